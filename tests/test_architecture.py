"""The data flows one way: a room imports only what it may, no module cycles, and importing the package stays light."""

from __future__ import annotations

import ast
import subprocess
import sys
import tomllib
from collections.abc import Iterator
from functools import cache
from pathlib import Path

import pytest

import decomplex_bt

SOURCE = Path(decomplex_bt.__file__).parent
ENVS = Path(sys.modules["decomplex_bt.envs"].__path__[0])

BASIC = frozenset({"errors", "flow", "instruction", "phrases", "hesitation", "domain", "corpus", "processes"})
MAY_IMPORT: dict[str, frozenset[str]] = {
    "errors": frozenset({"instruction"}),
    "flow": frozenset({"errors"}),
    "instruction": frozenset({"errors", "flow", "phrases"}),
    "phrases": frozenset({"instruction"}),
    "hesitation": frozenset({"phrases"}),
    "domain": frozenset({"errors", "flow", "instruction", "domains"}),
    "domains": frozenset(),
    "processes": frozenset(),
    "corpus": frozenset({"errors", "flow", "instruction", "domain"}),
    "formats": BASIC,
    "understanding": BASIC,
    "planning": BASIC,
    "corpus_structures": BASIC,
    "corpus_statistics": BASIC | {"planning", "corpus_structures"},
    "behaviour": BASIC | {"understanding", "planning"},
    "envs": BASIC | {"understanding", "planning", "behaviour"},
    "evaluation": BASIC | {"understanding", "planning", "behaviour", ""},
    "reproduction": BASIC | {"formats", "understanding", "evaluation", "corpus_statistics"},
    "": BASIC | {"understanding", "behaviour", "envs"},
    "cli": BASIC
    | {"understanding", "planning", "behaviour", "envs", "evaluation", "corpus_statistics"}
    | {"formats", "reproduction", ""},
    "__main__": frozenset({"cli"}),
}
"""Which rooms each room may import, itself apart; "" is the package's own front door. Lazy imports count, too."""

INSIDE_UNDERSTANDING: dict[str, frozenset[str]] = {
    "references": frozenset(),
    "rules": frozenset({"references"}),
    "control_flow": frozenset({"references", "rules"}),
    "recombination": frozenset(),
    "encoder": frozenset({"references", "control_flow"}),
}
"""Which of its inner rooms each inner room of `understanding` may import, itself apart."""

HEAVY = ("spacy", "sklearn", "sklearn_crfsuite", "pycrfsuite", "pyperplan", "joblib", "PIL", "rich", "typer")
"""What neither `import decomplex_bt` nor `gym.make` may load: language, planners, pictures, the command line."""


def room_of(module: str) -> str:
    """The room of a module of ours: "decomplex_bt.envs.world" is in "envs"."""
    parts = module.split(".")
    return parts[1] if len(parts) > 1 else ""


@cache
def modules() -> dict[str, Path]:
    """Every module of the package by its installed name."""
    found = {}
    for folder, prefix in ((SOURCE, "decomplex_bt"), (ENVS, "decomplex_bt.envs")):
        for path in sorted(folder.rglob("*.py")):
            parts = [*prefix.split("."), *path.relative_to(folder).with_suffix("").parts]
            found[".".join(parts).removesuffix(".__init__")] = path
    return found


def imports_of(path: Path, *, at_import: bool) -> Iterator[str]:
    """The modules of ours that a file imports: all of them, or only when it is imported itself."""
    tree = ast.parse(path.read_text(encoding="utf-8"))
    nodes = list(_run_at_import(tree)) if at_import else list(ast.walk(tree))
    for node in nodes:
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names if alias.name.split(".")[0] == "decomplex_bt")
        elif isinstance(node, ast.ImportFrom) and node.module and node.module.split(".")[0] == "decomplex_bt":
            for alias in node.names:
                whole = f"{node.module}.{alias.name}"
                yield whole if whole in modules() else node.module


def _run_at_import(tree: ast.AST) -> Iterator[ast.AST]:
    """Nodes that run when the module is imported: not those inside functions or under `if TYPE_CHECKING`."""
    for node in ast.iter_child_nodes(tree):
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef | ast.Lambda):
            continue
        if isinstance(node, ast.If) and "TYPE_CHECKING" in ast.unparse(node.test):
            continue
        yield node
        yield from _run_at_import(node)


@pytest.mark.parametrize("module", sorted(modules()))
def test_module_imports_only_what_its_room_may(module: str) -> None:
    room = room_of(module)
    assert room in MAY_IMPORT, f"{module} is in a new room: say in MAY_IMPORT what it may import"
    for imported in imports_of(modules()[module], at_import=False):
        target = room_of(imported)
        assert target == room or target in MAY_IMPORT[room], f"{module} imports {imported}: against the data flow"


@pytest.mark.parametrize("room", sorted(INSIDE_UNDERSTANDING))
def test_inner_room_imports_only_what_it_may(room: str) -> None:
    prefix = "decomplex_bt.understanding."
    inside = [module for module in modules() if module.startswith(f"{prefix}{room}.")]
    imported = {name for module in inside for name in imports_of(modules()[module], at_import=False)}
    targets = {name.removeprefix(prefix).split(".")[0] for name in imported if name.startswith(prefix)}
    assert inside
    assert targets & INSIDE_UNDERSTANDING.keys() <= INSIDE_UNDERSTANDING[room] | {room}


def test_every_inner_room_is_in_the_table() -> None:
    folders = {path.parent.name for path in (SOURCE / "understanding").glob("*/__init__.py")}
    assert folders == INSIDE_UNDERSTANDING.keys()


def test_no_imports_in_a_circle() -> None:
    graph = {module: set(imports_of(path, at_import=True)) - {module} for module, path in modules().items()}
    while free := [module for module, imported in graph.items() if not imported & graph.keys()]:
        for module in free:
            del graph[module]
    circles = {module: sorted(imported & graph.keys()) for module, imported in graph.items()}
    assert not circles, f"these import one another: {circles}"


def test_every_package_is_in_the_wheel() -> None:
    root = Path(__file__).parent.parent
    listed = tomllib.loads((root / "pyproject.toml").read_text(encoding="utf-8"))["tool"]["setuptools"]["packages"]
    folders = {
        "decomplex_bt." * (top != "decomplex_bt") + ".".join(path.parent.relative_to(root).parts)
        for top in ("decomplex_bt", "envs", "domains")
        for path in (root / top).rglob("__init__.py")
    }
    assert sorted(listed) == sorted(folders)


def test_only_understanding_imports_spacy() -> None:
    for module, path in modules().items():
        if "spacy" in path.read_text(encoding="utf-8") and room_of(module) != "understanding":
            tree = ast.parse(path.read_text(encoding="utf-8"))
            names = [alias.name for node in ast.walk(tree) if isinstance(node, ast.Import) for alias in node.names]
            names += [node.module or "" for node in ast.walk(tree) if isinstance(node, ast.ImportFrom)]
            assert not any(name.split(".")[0] == "spacy" for name in names), f"{module} imports spaCy"


@pytest.mark.parametrize(
    "code",
    [
        "import decomplex_bt",
        "import gymnasium, decomplex_bt; gymnasium.make('decomplex_bt/Household-v0')",
        "import decomplex_bt.cli",
    ],
    ids=["import", "gym.make", "cli"],
)
def test_stays_light(code: str) -> None:
    heavy = [name for name in HEAVY if not (name == "typer" and "cli" in code)]
    probe = f"{code}; import sys; print([name for name in {heavy!r} if name in sys.modules])"
    done = subprocess.run([sys.executable, "-c", probe], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "[]"

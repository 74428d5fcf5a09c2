"""The household robot that does what a complex sentence says.

`TreeAgent` carries an instruction out in an environment; `Interpreter` understands a sentence, and `settle` asks for
what it leaves open. They are imported when first asked for, so that `import decomplex_bt` stays light; it registers the
environments with Gymnasium.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

from decomplex_bt.envs.registration import register_envs

if TYPE_CHECKING:
    from decomplex_bt.behaviour.agent import TreeAgent
    from decomplex_bt.behaviour.settling import settle
    from decomplex_bt.understanding.interpreter import Interpreter

    __version__: str

__all__ = ["Interpreter", "TreeAgent", "__version__", "settle"]

_HOMES = {
    "Interpreter": "decomplex_bt.understanding.interpreter",
    "TreeAgent": "decomplex_bt.behaviour.agent",
    "settle": "decomplex_bt.behaviour.settling",
}


register_envs()


def __getattr__(name: str) -> Any:
    if name == "__version__":
        # Reading what is installed takes longer than all else here.
        from importlib.metadata import version

        return version("decomplex-bt")
    if name not in _HOMES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    value = getattr(import_module(_HOMES[name]), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})

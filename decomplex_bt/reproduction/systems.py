"""The paper's system as it describes it: tasks, arguments, pronouns, dependency labels, the tree of control flow."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from decomplex_bt.flow import Flow
from decomplex_bt.instruction import Argument, Instruction, Task
from decomplex_bt.reproduction.lexicon_induction import lex_induct
from decomplex_bt.understanding.arguments import AssociationArguments, FoundArgument, Method, train_association
from decomplex_bt.understanding.control_flow.clauses import clauses_of
from decomplex_bt.understanding.crf import transition_weights
from decomplex_bt.understanding.dependencies import (
    PaperDependencies,
    marked_tasks,
    train_paper_dependencies,
    tree_of,
)
from decomplex_bt.understanding.features import Observed
from decomplex_bt.understanding.tasks import TaskModel, train_tasks

METHODS: tuple[Method, ...] = ("none", "naive", "split")
"""The three ways to associate words with tasks (Table III); the last one is the paper's."""
TRAINED: Mapping[Method, Method] = {"none": "none", "naive": "naive", "split": "naive"}
"""The association that each method's model is trained with."""
LABELLERS = ("lex_induct", "crf-tf", "crf")
"""What labels dependencies (Table IV): rules, the CRF without task_type, the CRF."""
MERGED = " (m)"
"""The mark of a system that merges conditions (Fig. 3)."""
PRONOUNS = frozenset("it them they that this these those one ones him her he she".split())

Annotated = Sequence[tuple[Observed, Instruction]]


@dataclass(frozen=True)
class PaperSystem:
    """The trained models of the paper's system, in a folder."""

    tasks: TaskModel
    arguments: Mapping[Method, AssociationArguments]
    dependencies: Mapping[str, PaperDependencies]
    folder: Path

    def find_tasks(self, observed: Observed) -> dict[int, str]:
        """Token index to task type."""
        return {task.token: task.type for task in self.tasks.find(observed)}

    def find_arguments(self, observed: Observed, tasks: Mapping[int, str]) -> tuple[FoundArgument, ...]:
        return self.arguments["split"].find(observed, tasks)

    def label(self, observed: Observed, instruction: Instruction, labeller: str) -> tuple[str, ...]:
        """The dependency label of every task, by one of `LABELLERS`; the instruction's own flow is not read."""
        marked = marked_tasks(observed, instruction)
        if labeller == "lex_induct":
            return lex_induct(observed.document, [task.token for task in marked])
        return self.dependencies[labeller].label(observed, clauses_of(observed, marked))

    def read(self, observed: Observed) -> Instruction:
        """Tasks and arguments, pronouns resolved; without a flow."""
        tasks = self.find_tasks(observed)
        return instruction_of(observed, tasks, self.find_arguments(observed, tasks))

    def understand(self, observed: Observed) -> Instruction:
        """The whole system, with merging (the example of Fig. 1)."""
        instruction = self.read(observed)
        return replace(instruction, flow=tree_of(self.label(observed, instruction, "crf"), instruction))

    def flows(self, observed: Observed, instruction: Instruction) -> dict[str, Flow]:
        """The control flow by every labeller, each with and without merging, by the system's name (Fig. 3)."""
        found: dict[str, Flow] = {}
        for labeller in LABELLERS:
            labels = self.label(observed, instruction, labeller)
            for mark in ("", MERGED):
                found[labeller + mark] = tree_of(labels, instruction, with_merging=bool(mark))
        return found

    def transitions(self) -> dict[tuple[str, str], float]:
        """The learnt weight of every transition of the full dependency CRF (Table V)."""
        return transition_weights(self.folder / "crf.crf")

    def feature_weights(self, names: Sequence[str]) -> dict[str, tuple[int, float]]:
        """Of each feature of Table II: how many weights the full CRF has learnt, and the sum of their sizes."""
        import pycrfsuite

        tagger = pycrfsuite.Tagger()
        tagger.open(str(self.folder / "crf.crf"))
        sizes: dict[str, list[float]] = {name: [] for name in names}
        for (attribute, _), weight in tagger.info().state_features.items():
            sizes.setdefault(attribute.split(":")[0], []).append(abs(weight))
        return {name: (len(sizes[name]), sum(sizes[name])) for name in names}


def train_paper_system(folder: Path, data: Annotated) -> PaperSystem:
    """Trains the task and argument models on all, the dependency models on the complex instructions (section IV-A).

    Split search is "during inference" (section III-B): it labels with the model of the naive association. The same
    search with a model trained on the true owners came out lower.
    """
    complex_ones = [(observed, instruction) for observed, instruction in data if len(instruction.tasks) > 1]
    train_tasks(folder / "tasks.crf", data)
    for method in sorted(set(TRAINED.values())):
        train_association(folder / f"{method}.crf", data, method)
    train_paper_dependencies(folder / "crf.crf", complex_ones)
    train_paper_dependencies(folder / "crf-tf.crf", complex_ones, with_task_type=False)
    return PaperSystem(
        TaskModel(folder / "tasks.crf"),
        {method: AssociationArguments(folder / f"{TRAINED[method]}.crf", method) for method in METHODS},
        {name: PaperDependencies(folder / f"{name}.crf", with_task_type=name == "crf") for name in ("crf", "crf-tf")},
        folder,
    )


def instruction_of(observed: Observed, tasks: Mapping[int, str], arguments: Sequence[FoundArgument]) -> Instruction:
    """The instruction of what was found, pronouns resolved; without a flow."""
    document = observed.document
    built = []
    for number, token in enumerate(sorted(tasks), start=1):
        own = []
        for found in arguments:
            if found.owner == token:
                span = document.span(found.tokens.start, found.tokens.stop - 1)
                own.append(Argument(found.type, span.of(document.text), span))
        built.append(Task(number, tasks[token], document.span(token, token), tuple(own)))
    return Instruction(document.text, resolved(built))


def resolved(tasks: Sequence[Task]) -> tuple[Task, ...]:
    """Pronouns replaced by the nearest object of the tasks before; where there is none they stay.

    Section III-B: "the corresponding arguments (nouns) of the preceding tasks".
    """
    nearest: str | None = None
    done: list[Task] = []
    for task in tasks:
        arguments = []
        for argument in task.arguments:
            is_pronoun = argument.value.lower() in PRONOUNS
            arguments.append(replace(argument, value=nearest) if is_pronoun and nearest else argument)
        done.append(replace(task, arguments=tuple(arguments)))
        objects = [a.value for a in arguments if a.type == "object" and a.value.lower() not in PRONOUNS]
        nearest = objects[-1] if objects else nearest
    return tuple(done)

"""The errors a caller can tell apart; each message names the value, what was expected and how to mend it."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from numbers import Integral
from pathlib import Path
from reprlib import Repr
from typing import TYPE_CHECKING, Any, TypeGuard

if TYPE_CHECKING:
    from decomplex_bt.instruction import Missing

FEW = 12
"""So many names an error lists in full."""
_SHORTENER = Repr()
_SHORTENER.maxstring = _SHORTENER.maxother = 100


def among(name: object, known: Iterable[str]) -> str:
    """How an error that refuses an unknown name goes on: by what was perhaps meant, or else by what is known.

    Of many that are not alike it gives the first, and how many there are. "" where none is known.
    """
    from difflib import get_close_matches

    names = list(dict.fromkeys(known))
    alike = {_plainly(one): one for one in reversed(names)}
    if near := get_close_matches(_plainly(str(name)), list(alike), n=3):
        return f"; the nearest known: {', '.join(alike[one] for one in near)}"
    return _listed(names)


def _listed(names: Sequence[str]) -> str:
    """What is known, of many the first; "" where nothing is."""
    listed = names if len(names) <= FEW else [*names[: FEW - 1], f"... ({len(names)} in all)"]
    return f"; known: {', '.join(listed)}" if names else ""


def _plainly(name: str) -> str:
    return name.casefold().replace("_", " ").replace("-", " ").strip()


def check_jobs(jobs: object, name: str = "jobs") -> None:
    """Raises `InputError` for what is no number of processes: 1 or more, or -1 for one a core."""
    if not is_whole(jobs) or (jobs != -1 and jobs < 1):
        raise InputError(f"{name} is {jobs!r}; expected at least one process, or -1 for one a core")


def quoted(value: object) -> str:
    """A value as an error quotes it: of a long one the beginning and the end, some hundred characters."""
    return _SHORTENER.repr(value)


def is_whole(value: object) -> TypeGuard[int]:
    """Whether a value is a whole number, of numpy's as well; True is none."""
    return isinstance(value, Integral) and not isinstance(value, bool)


class _Raised(type):
    """The class of error classes: one that is called with an error of its own gives that error.

    So Gymnasium raises an error of a worker process anew, whatever arguments the class takes.
    """

    def __call__(cls, *args: Any, **options: Any) -> Any:
        is_again = len(args) == 1 and type(args[0]) is cls and not options
        return args[0] if is_again else super().__call__(*args, **options)


class DecomplexError(Exception, metaclass=_Raised):
    """Root of all errors raised on purpose by this package; each is the same when it comes from another process."""

    def __reduce__(self) -> tuple[Any, ...]:
        return _restored, (type(self), self.args, vars(self))


def _restored(kind: type[DecomplexError], args: tuple[Any, ...], state: dict[str, Any]) -> DecomplexError:
    """An error that was pickled: its class need not take its arguments as they are kept."""
    error = kind.__new__(kind, *args)
    vars(error).update(state)
    return error


class InputError(DecomplexError, ValueError):
    """What the caller gave cannot be used: an instruction, an option, a file."""


class DataFileError(InputError):
    """A data file (domain, corpus, model, house) is broken; the message starts with the file and the known line."""

    def __init__(self, path: str | Path, problem: str, *, line: int | None = None) -> None:
        self.path = str(path)
        self.line = line
        self.problem = problem
        where = self.path if line is None else f"{self.path}:{line}"
        super().__init__(f"{where}: {problem}")


class UnknownWordError(InputError):
    """A phrase of the instruction names nothing in the domain.

    `phrase` is the phrase; `choices` are the nearest known words, best first (may be empty: then the message lists some
    of all that are `known`); `task` is the number of the task it belongs to, where known.
    """

    def __init__(
        self,
        phrase: str,
        choices: Iterable[str] = (),
        *,
        known: Iterable[str] = (),
        expected: str = "a thing",
        task: int | None = None,
    ):
        self.phrase = phrase
        self.choices = tuple(choices)
        self.task = task
        hint = f"; the nearest known: {', '.join(self.choices)}" if self.choices else _listed(tuple(known))
        super().__init__(f"{quoted(phrase)} names nothing in this house (expected {expected}){hint}")


class ImpossibleGoalError(InputError):
    """A task asks for what no state of the domain can be, whatever the world ("open the pen"); `task` is its number."""

    def __init__(self, message: str, *, task: int | None = None):
        self.task = task
        super().__init__(message)


class MissingArgumentError(InputError):
    """A required argument is neither said nor implied and nobody answered the question that asks for it."""

    def __init__(self, missing: Missing) -> None:
        self.missing = missing
        super().__init__(
            f"task {missing.task} lacks its {missing.argument}: {missing.question} "
            "Say it in the instruction, or answer on a terminal (in Python: give what `decomplex_bt.settle(text, ask)` "
            "returns to `reset` as the instruction and to `TreeAgent` as the flow)."
        )

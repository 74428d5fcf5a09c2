"""The application: its commands, and one place where errors become one line and an exit status."""

from __future__ import annotations

import errno
import os
import sys
from collections.abc import Sequence
from contextlib import redirect_stderr
from typing import Annotated, Any

import typer

from decomplex_bt import __version__
from decomplex_bt.cli import corpus, evaluate, parse, plan, reproduce, run, train, tree
from decomplex_bt.cli.output import Spared, silence
from decomplex_bt.errors import DecomplexError
from decomplex_bt.instruction import escaped

OK, FAILED, BAD_INPUT, INTERRUPTED = 0, 1, 2, 130
"""Exit statuses: done; the task failed or was infeasible; the input cannot be used; interrupted by the user."""
DEBUG = "DECOMPLEX_BT_DEBUG"
"""Environment variable that lets an unexpected error show its traceback."""

# typer brings its own click in some releases and the public one in others: its classes are found through typer
_ClickError: Any = next(base for base in typer.BadParameter.__mro__ if base.__name__ == "ClickException")
_NoArguments = "NoArgsIsHelpError"

# plain help: loading rich for it would double the time until it shows
app = typer.Typer(
    name="decomplex-bt",
    help="A household robot that does what a complex sentence says. Data goes to standard output, all else to "
    "standard error. Exit status: 0 success, 1 the task failed or is infeasible, 2 bad input.",
    no_args_is_help=True,
    add_completion=False,
    rich_markup_mode=None,
    pretty_exceptions_enable=False,
    context_settings={"help_option_names": ["-h", "--help"]},
)
app.command("run")(run.run)
app.command("parse")(parse.parse)
app.command("plan")(plan.plan)
app.command("tree")(tree.tree)
app.command("evaluate")(evaluate.evaluate)
app.command("train")(train.train)
app.command("reproduce")(reproduce.reproduce)
app.add_typer(corpus.app, name="corpus")


def _show_version(is_asked: bool) -> None:
    if is_asked:
        print(__version__)
        raise typer.Exit


@app.callback()
def _options(
    version: Annotated[
        bool, typer.Option("--version", callback=_show_version, is_eager=True, help="Print the version and stop.")
    ] = False,
) -> None:
    """Options before any command."""


def main(argv: Sequence[str] | None = None) -> int:
    """Runs the command line on `argv` (default: the process' arguments); returns the exit status, never raises."""
    arguments = list(sys.argv[1:] if argv is None else argv)
    for name in ("stdout", "stderr"):
        if getattr(sys, name) is None:  # closed before the start ("run ... 2>&-"): what is printed goes nowhere
            setattr(sys, name, open(os.devnull, "w", encoding="utf-8"))  # noqa: SIM115 - until the process ends
    remarks: Any = Spared(sys.stderr)
    with redirect_stderr(remarks):
        return _run(arguments)


def _run(arguments: Sequence[str]) -> int:
    try:
        try:
            result = typer.main.get_command(app).main(list(arguments), prog_name="decomplex-bt", standalone_mode=False)
        finally:
            sys.stdout.flush()  # here, and not as Python ends, where what goes wrong would be told in its words
        if result == INTERRUPTED:  # typer has caught what `except` is for below
            _complain("interrupted")
        return result if isinstance(result, int) else OK
    except _ClickError as error:
        if type(error).__name__ == _NoArguments:
            print(error.format_message(), file=sys.stderr)
        else:
            # "Value error, " is how the checks that typer leaves to pydantic begin; it tells the user nothing
            _complain(f"{error.format_message().replace(': Value error, ', ': ', 1)} (see decomplex-bt --help)")
        return BAD_INPUT
    except DecomplexError as error:
        _complain(str(error))
        return BAD_INPUT
    except (KeyboardInterrupt, typer.Abort):
        _complain("interrupted")
        return INTERRUPTED
    except (BrokenPipeError, SystemExit):
        # Whoever read our output has seen enough (typer turns that into SystemExit, which it uses for nothing else
        # here); keep Python from complaining about it when it exits.
        silence(sys.stdout)
        return OK
    except OSError as error:
        if error.errno in (errno.ENOSPC, errno.EIO, errno.EDQUOT):
            silence(sys.stdout)
            _complain(f"the output cannot be written: {error.strerror}")
        elif error.filename is not None:  # a path that no check had foreseen, "File name too long" for one
            _complain(f"{error.filename}: cannot be used: {error.strerror}; give another path")
        else:
            return _report(error)
        return BAD_INPUT
    except Exception as error:
        return _report(error)


def _report(error: Exception) -> int:
    if os.environ.get(DEBUG):
        raise error
    _complain(f"internal error: {type(error).__name__}: {error}; run with {DEBUG}=1 to see where, and report it")
    return FAILED


def _complain(message: str) -> None:
    print(f"decomplex-bt: {escaped(' '.join(message.split()))}", file=sys.stderr)

"""The commands: the only place that prints and exits."""

from __future__ import annotations

import gc
import os
import sys

from archlint import __version__
from archlint.cli.exits import FAILED, INTERRUPTED, READER_GONE, UsageError

TYPE_CHECKING = False
if TYPE_CHECKING:  # most starts end before anything of this is needed, so nothing more than that is imported
    from collections.abc import Sequence
    from typing import NoReturn

COMMANDS = (
    "check",
    "graph",
    "diff",
    "show",
    "trace",
    "impact",
    "advise",
    "docs",
    "export",
    "facts",
    "observe",
    "explain",
    "rules",
    "config",
    "init",
    "server",
    "completion",
    "man",
)
"""Each is a module of this package with ``parser()`` and ``run(arguments)``; a new command is a new row."""


def main(argv: Sequence[str] | None = None) -> int:
    """Run one command and return its exit status.  Without ``argv`` the process ends here, at once."""
    if argv is not None:
        return _guarded(list(argv))
    if None in (sys.stdin, sys.stdout, sys.stderr):
        from archlint.cli.streams import reopen_closed

        reopen_closed()
    gc.disable()  # a run is short, and its data lives until the end
    return _leave(_guarded(sys.argv[1:]))


def _guarded(arguments: list[str]) -> int:
    """The exit status of a command, whatever happens in it: no exception and no traceback gets out."""
    from archlint.cli.console import flush

    try:
        status = _dispatch(arguments)
        flush()
    except BrokenPipeError:
        return READER_GONE
    except KeyboardInterrupt:
        return INTERRUPTED
    except SystemExit as end:  # argparse: --help, or a usage error that it has reported
        match end.code:
            case int(status):
                return status
        return FAILED
    except UsageError as error:
        return _note(f"error: {error}")
    except Exception as error:
        return _failed(error, "--verbose" in arguments)
    return status


def _dispatch(arguments: list[str]) -> int:
    from archlint.cli.console import say

    for stream in (sys.stdout, sys.stderr):
        if hasattr(stream, "reconfigure"):
            stream.reconfigure(errors="backslashreplace")
    first = arguments[0] if arguments else ""
    if first in ("-h", "--help", "help") and arguments[1:2] and arguments[1] in COMMANDS:
        first, arguments = arguments[1], [arguments[1], "--help"]
    if first in ("-h", "--help", "help"):
        from archlint.cli.overview import overview

        say(overview())
        return 0
    if first in ("-V", "--version"):
        say(f"archlint {__version__}\n")
        return 0
    command, rest = (first, arguments[1:]) if first in COMMANDS else ("check", arguments)
    if (status := _answered(command, arguments)) is not None:
        return status
    from contextvars import copy_context
    from importlib import import_module

    module = import_module(f"archlint.cli.{command}")
    options = module.parser().parse_words(rest)
    options.words = arguments
    return int(copy_context().run(module.run, options))  # what the command activates ends with it


def _answered(command: str, arguments: list[str]) -> int | None:
    """Say again what the same command has said, where nothing has changed since; returns its exit status then."""
    from archlint.cli.console import give, terminal
    from archlint.engine.answers import ANSWERED, known_answer

    if command not in ANSWERED:
        return None
    try:
        answer = known_answer(arguments, terminal())
    except (OSError, ValueError):  # the working directory is gone, say
        return None
    return None if answer is None else give(answer)


def _note(text: str) -> int:
    from archlint.cli.console import note

    note(f"archlint: {text}")
    return FAILED


def _failed(error: Exception, verbose: bool) -> int:
    if _is_nowhere():
        return _note("error: the working directory no longer exists; change to one that does")
    if verbose:
        import traceback

        _note("traceback:\n" + "".join(traceback.format_exception(error)))
    from archlint.project import issue_tracker

    hint = "" if verbose else ", with the output of `--verbose`"
    return _note(
        f"internal error: {type(error).__name__}: {error}\n"
        f"This is an error in archlint, not in your code. Please report it on {issue_tracker()}{hint}."
    )


def _is_nowhere() -> bool:
    try:
        os.getcwd()
    except OSError:
        return True
    return False


def _leave(status: int) -> NoReturn:
    """End the process without the long way out of the interpreter."""
    try:
        sys.stdout.flush()
    except BrokenPipeError:
        status = READER_GONE
    except KeyboardInterrupt:
        status = INTERRUPTED
    except OSError:  # what could not be written has been reported, and is still there to be written
        status = FAILED
    os._exit(status)

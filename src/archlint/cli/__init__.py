"""The commands: the only place that prints and exits."""

from __future__ import annotations

import gc
import os
import sys
from collections.abc import Sequence
from importlib import import_module
from typing import NoReturn

from archlint import __version__
from archlint.cli.exits import FAILED, INTERRUPTED, READER_GONE, UsageError
from archlint.cli.overview import OVERVIEW
from archlint.project import issue_tracker

COMMANDS = ("check", "graph", "observe", "explain", "rules", "config")
"""Each is a module of this package with ``parser()`` and ``run(arguments)``; a new command is a new row."""


def main(argv: Sequence[str] | None = None) -> int:
    """Run one command and return its exit status.  Without ``argv`` the process ends here, at once."""
    if argv is not None:
        return _guarded(list(argv))
    gc.disable()  # a run is short, and its data lives until the end
    return _leave(_guarded(sys.argv[1:]))


def _guarded(arguments: list[str]) -> int:
    """The exit status of a command, whatever happens in it: no exception and no traceback gets out."""
    try:
        status = _dispatch(arguments)
        sys.stdout.flush()
    except BrokenPipeError:
        return READER_GONE
    except KeyboardInterrupt:
        return INTERRUPTED
    except SystemExit as end:  # argparse: --help, or a usage error that it has told
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
    for stream in (sys.stdout, sys.stderr):
        if hasattr(stream, "reconfigure"):
            stream.reconfigure(errors="backslashreplace")
    first = arguments[0] if arguments else ""
    if first in ("-h", "--help", "help"):
        print(OVERVIEW, end="")
        return 0
    if first in ("-V", "--version"):
        print(f"archlint {__version__}")
        return 0
    command, rest = (first, arguments[1:]) if first in COMMANDS else ("check", arguments)
    module = import_module(f"archlint.cli.{command}")
    status: int = module.run(module.parser().parse_intermixed_args(rest))
    return status


def _note(text: str) -> int:
    from archlint.cli.console import note  # with pathlib, which --version and --help do without

    note(f"archlint: {text}")
    return FAILED


def _failed(error: Exception, verbose: bool) -> int:
    if verbose:
        import traceback

        _note("traceback:\n" + "".join(traceback.format_exception(error)))
    hint = "" if verbose else ", with what `--verbose` adds"
    return _note(
        f"internal error: {type(error).__name__}: {error}\n"
        f"This is a fault of archlint, not of your code. Please report it on {issue_tracker()}{hint}."
    )


def _leave(status: int) -> NoReturn:
    """End the process without the long way out of the interpreter."""
    try:
        sys.stdout.flush()
        sys.stderr.flush()
    except BrokenPipeError:
        status = READER_GONE
    except KeyboardInterrupt:
        status = INTERRUPTED
    os._exit(status)

"""Where output goes: findings to standard output or a file, everything else to standard error."""

from __future__ import annotations

import os
import sys

from archlint.cli.exits import UsageError

TYPE_CHECKING = False
if TYPE_CHECKING:  # the console is there on every start: it imports what it needs when it does
    from collections.abc import Collection
    from typing import Literal, TextIO

    from archlint.engine.answers import Answer

    When = Literal["auto", "always", "never"]
    """What ``--color`` takes."""

_COLORING = ("NO_COLOR", "FORCE_COLOR", "CLICOLOR_FORCE", "CLICOLOR", "TERM")
_COLUMNS = 80
"""How wide a terminal is that does not say so."""


def note(text: str) -> None:
    """Tell something on standard error; a reader that went away is not an error."""
    _tell(noted(text))


def note_faults(faults: Collection[str], done: str = "analysed") -> bool:
    """Tell of errors in archlint itself, and that everything else was ``done``; returns whether there are any."""
    for fault in faults:
        note(f"archlint: {fault}")
    if faults:
        note(f"This is an error in archlint, not in your code; everything else was {done}.")
    return bool(faults)


def noted(text: str) -> str:
    """A note as it is shown: each line safe to show."""
    from archlint.visible import visible

    return "".join(f"{visible(line)}\n" for line in text.splitlines())


def give(answer: Answer) -> int:
    """Say what a command has to say; returns its exit status."""
    say(answer.text)
    _tell(answer.warnings)
    if answer.notes:
        flush()
        _tell(answer.notes)
    return answer.status


def _tell(lines: str) -> None:
    try:
        sys.stderr.write(lines)
        sys.stderr.flush()
    except OSError:  # nobody is left to tell
        return


def say(text: str) -> None:
    """Write to standard output; every command does it here.

    Raises :class:`UsageError` where it takes nothing: it is closed, or the disk is full.
    """
    if not text:
        return  # even to write nothing fails on a full disk
    try:
        sys.stdout.write(text)
    except OSError as error:
        raise _refused(error) from None


def flush() -> None:
    """Hand on what was said, with the errors of :func:`say`."""
    try:
        sys.stdout.flush()
    except OSError as error:
        raise _refused(error) from None


def _say_bytes(content: bytes) -> None:
    flush()
    try:
        sys.stdout.buffer.write(content)
    except OSError as error:
        raise _refused(error) from None


def _refused(error: OSError) -> Exception:
    """What to raise instead of an error of standard output; a reader that went away is none that is told."""
    return error if isinstance(error, BrokenPipeError) else UsageError(f"cannot write the output: {error.strerror}")


def terminal() -> list[str]:
    """What else than the words of a command decides how it is shown: what it writes colours for, and its width."""
    return [*(repr(os.environ.get(name)) for name in _COLORING), str(columns(sys.stdout))]


def columns(stream: TextIO) -> int | None:
    """The width of the terminal that a stream is, COLUMNS first; None where it is none: what goes to a file or a pipe
    is not wrapped."""
    if not stream.isatty():
        return None
    given = os.environ.get("COLUMNS", "")
    if given.isdecimal() and int(given):
        return int(given)
    try:
        return os.get_terminal_size(stream.fileno()).columns or _COLUMNS
    except (OSError, ValueError):
        return _COLUMNS


def wants_color(when: When, stream: TextIO) -> bool:
    """Whether to write colours: the option, then NO_COLOR, then what forces them, then the terminal."""
    environment = os.environ.get
    if when != "auto":
        return when == "always"
    if environment("NO_COLOR"):
        return False
    if environment("FORCE_COLOR", "0") != "0" or environment("CLICOLOR_FORCE", "0") != "0":
        return True
    if environment("CLICOLOR") == "0" or environment("TERM") == "dumb":
        return False
    return stream.isatty()


def write(content: str | bytes, file: str | None) -> None:
    """Write to a file, or to standard output where ``file`` is None or ``-``.

    A file appears whole or not at all.  Raises :class:`UsageError` where it cannot be written.
    """
    if file is not None and file != "-":
        _write_file(content.encode("utf-8", "replace") if isinstance(content, str) else content, file)
    elif isinstance(content, str):
        say(content)
    else:
        _say_bytes(content)


def _write_file(content: bytes, file: str) -> None:
    from pathlib import Path

    from archlint.disk import replace_file

    if file.endswith(("/", os.sep)) and not os.path.isdir(file):
        raise UsageError(f"cannot write {file}: that names a folder, and there is none; name a file")
    path = Path(file)
    try:
        target = path.resolve()  # a symbolic link stays one
        if target.exists() and not target.is_file():  # /dev/null, a named pipe
            target.write_bytes(content)
            return
        replace_file(target, content, target.stat() if target.exists() else None)
    except BrokenPipeError:
        raise
    except OSError as error:
        raise UsageError(f"cannot write {path}: {error.strerror}") from None
    except (RuntimeError, ValueError):  # a link to itself; a name that is none
        raise UsageError(f"cannot write {path}: it is not a file name") from None

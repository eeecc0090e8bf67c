"""The file of a baseline: a line for each finding that it holds, sorted, so that git merges it."""

from __future__ import annotations

import errno
import json
import os
import re
from collections.abc import Iterable, Iterator
from pathlib import Path

from archlint.disk import read_regular, replace_file
from archlint.engine.known import Baseline, Entry
from archlint.report.occurrence import Key
from archlint.visible import visible

MARK = "# archlint baseline"
"""What the first line of each starts with: nothing else is overwritten."""
_HEAD = f"""\
{MARK}: the findings that `archlint check` holds back, one a line: code, file, what it is about.
# `archlint check --write-baseline` writes this file, `--prune-baseline` removes what is no longer found.
"""
MAX_BYTES = 50_000_000

_ENTRY = re.compile(r'([A-Z]{3}[0-9]{3}) ("(?:[^"\\]|\\.)*"|[^"].*?):(?: (.*))?')
_CONFLICT = re.compile(r"(?:<{7}|={7}|>{7}|\|{7})(?: |$)")


class BaselineError(Exception):
    """A baseline that cannot be read or written; ``str()`` says where and why."""


def read(path: Path) -> Baseline:
    """What a baseline holds.  Raises :class:`BaselineError`, with the line that is at fault."""
    shown = _shown(path)
    entries = []
    for number, line in _lines(_text(path)):
        entry = _entry(number, line, path)
        if entry is None:
            raise BaselineError(f"{shown}:{number}: {_fault(line)}")
        entries.append(entry)
    return Baseline(shown, tuple(entries))


def read_to_rewrite(path: Path) -> Baseline:
    """What can be read of a baseline that is to be written again: nothing where there is none yet.

    Raises :class:`BaselineError` where another file would be overwritten.
    """
    if not os.path.lexists(path):
        return Baseline(_shown(path))
    text = _text(path)
    if text.strip() and not text.startswith(MARK):
        raise BaselineError(f"{_shown(path)} is not a baseline, so it is not overwritten")
    entries = [_entry(number, line, path) for number, line in _lines(text)]
    return Baseline(_shown(path), tuple(entry for entry in entries if entry is not None))


def write(path: Path, keys: Iterable[Key]) -> None:
    """Put a baseline with these findings in place, in one step; the comment at the top of an earlier one stays.

    Raises :class:`BaselineError`.
    """
    try:
        target = path.resolve()
        status = target.stat() if target.exists() else None
        if status is not None and not (status.st_mode & 0o222 and os.access(target, os.W_OK)):
            raise PermissionError(errno.EACCES, "the file is read-only")
        head = _head(_text(path)) if status is not None else _HEAD
        data = head + "".join(f"{line}\n" for line in sorted(_line(key, path) for key in keys))
        replace_file(target, data.encode(), status)
    except OSError as error:
        raise BaselineError(f"cannot write {_shown(path)}: {error.strerror}") from None


def _text(path: Path) -> str:
    try:
        return read_regular(path, MAX_BYTES).decode("utf-8-sig")
    except OSError as error:
        raise BaselineError(f"{_shown(path)} cannot be read: {error.strerror}") from None
    except UnicodeDecodeError as error:
        line = error.object.count(b"\n", 0, error.start) + 1
        raise BaselineError(f"{_shown(path)}:{line}: is not UTF-8") from None


def _head(text: str) -> str:
    """The comment at the top of a baseline."""
    head = []
    for line in text.splitlines():
        if not line.startswith("#"):
            break
        head.append(f"{line}\n")
    return "".join(head) or _HEAD


def _lines(text: str) -> Iterator[tuple[int, str]]:
    """The lines that say something, with their numbers from 1."""
    for number, line in enumerate(text.split("\n"), 1):
        stripped = line.strip()
        if stripped and not stripped.startswith("#"):
            yield number, stripped


def _entry(number: int, line: str, path: Path) -> Entry | None:
    match = _ENTRY.fullmatch(line)
    if match is None:
        return None
    file = match[2]
    if file.startswith('"'):
        try:
            file = str(json.loads(file))
        except ValueError:
            return None
    return Entry(number, Key(match[1], os.path.normpath(os.path.join(_folder(path), file)), (match[3] or "").strip()))


def _fault(line: str) -> str:
    """What is wrong with a line, without repeating it: the file may be something else altogether."""
    if _CONFLICT.match(line):
        return "a merge conflict: keep the lines of both sides, or run `archlint check --write-baseline`"
    return "not an entry of a baseline, which is a code, a file and what it is about: `SRV003 src/node.py: on_request`"


def _line(key: Key, path: Path) -> str:
    try:
        file = os.path.relpath(key.file, _folder(path)).replace(os.sep, "/")
    except ValueError:  # another drive
        file = key.file
    if ": " in file or file.startswith('"'):
        file = json.dumps(file)
    return f"{key.code} {file}: {key.what}".rstrip()


def _folder(path: Path) -> str:
    """The folder that the files are named from."""
    return visible(os.path.dirname(os.path.abspath(path)))


def _shown(path: Path) -> str:
    try:
        return os.path.relpath(path).replace(os.sep, "/")
    except ValueError:
        return path.as_posix()


__all__ = ["MARK", "BaselineError", "read", "read_to_rewrite", "write"]

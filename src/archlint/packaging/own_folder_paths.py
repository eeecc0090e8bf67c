"""Paths that Python code makes of its own file: ``os.path.join(os.path.dirname(__file__), 'words.json')``,
``Path(__file__).parent / 'words.json'``, also in parts, through variables that only ever have one value."""

from __future__ import annotations

import posixpath
import re
from typing import NamedTuple

from archlint.packaging.share_paths import ASKS, only_given
from archlint.syntax import facts
from archlint.syntax.parts import everything_in, once_for
from archlint.syntax.walk import called_name

FILE = "__file__"
_SAME = frozenset({"Path", "PurePath", "str", "fspath", "abspath", "realpath", "normpath", "expanduser"})
"""Functions that make another kind of path, or a text, of a path."""
_SAME_METHODS = frozenset({"resolve", "absolute", "as_posix", "expanduser"})
_MANY = 8
_ROUNDS = 3
"""Variables of variables."""
_WRITES = ("w", "a", "x")


class OwnPath(NamedTuple):
    """A path from the folder of a file on, in its normal form, and where it is written."""

    path: str
    span: facts.Span


@once_for
def paths_beside(code: facts.Facts) -> list[OwnPath]:
    """The paths that a file writes in full, but for folders that it lies in; none where it asks whether some file is
    there, or writes one."""
    asks = any(called_name(call) in ASKS for call in everything_in(code.body, facts.Call))
    if FILE not in code.names or asks or may_write(code):
        return []
    reader = _Reader(code)
    parts = [p for p in everything_in(code.body) if isinstance(p, (facts.Call, facts.Binary, facts.FormatString))]
    within = {id(inner) for part in parts for inner in everything_in(part.children()) if reader.path(part)}
    rows = ((part, reader.path(part)) for part in parts if id(part) not in within)
    return [OwnPath(path, part.span) for part, path in rows if path and not _is_around(path)]


@once_for
def may_write(code: facts.Facts) -> bool:
    """Whether a file has code that may make another file, a folder for some, or a database."""
    calls = list(everything_in(code.body, facts.Call))
    if any(map(_may_write, calls)):
        return True
    return any(called_name(call) == "connect" for call in calls) and any(
        literal.text is not None and _CREATES.search(literal.text)
        for literal in everything_in(code.body, facts.Literal)
    )


_CREATES = re.compile(r"\bcreate\s+table\b", re.IGNORECASE)


def _is_around(path: str) -> bool:
    return path == FILE or not path.replace("..", "").strip("/.")


def _may_write(call: facts.Call) -> bool:
    """Whether a call may make a file, or a folder for some."""
    if called_name(call) in ("makedirs", "mkdir", "write_text", "write_bytes", "touch"):
        return True
    modes = (argument.value.text or "" for argument in call.args[1:] if argument.keyword in (None, "mode"))
    return called_name(call) == "open" and any(mode.startswith(_WRITES) or "+" in mode for mode in modes)


class _Reader:
    """What the expressions of a file mean, as far as its own text says."""

    def __init__(self, code: facts.Facts) -> None:
        given = only_given(code)
        self._texts = {name: value.text for name, value in given.items() if value.text is not None}
        self._paths: dict[str, str] = {}
        for _ in range(_ROUNDS):
            self._paths |= {name: path for name, value in given.items() if (path := self.path(value))}

    def path(self, value: facts.Base) -> str | None:
        """The path from the folder of the file on that an expression is; None where it is none, or not known."""
        match value:
            case facts.Name(id=name):
                return FILE if name == FILE else self._paths.get(name)
            case facts.Attribute(value=inner, attr="parent"):
                return _above(self.path(inner))
            case facts.Subscript(value=facts.Attribute(value=inner, attr="parents"), index=facts.Literal(int(count))):
                return _above(self.path(inner), count + 1)
            case facts.Call():
                return self._called(value)
            case facts.Binary(op="/", left=left, right=right):
                return _joined(self.path(left), [self._text(right)])
            case facts.Binary(op="+", left=left, right=right):
                return _with_text(self.path(left), self._text(right))
            case facts.FormatString(parts=[facts.Field(value=first, conversion=None, spec=None), *others]):
                texts = [part if isinstance(part, str) else self._text(part.value) for part in others]
                return _with_text(self.path(first), None if None in texts else "".join(filter(None, texts)))
        return None

    def _called(self, call: facts.Call) -> str | None:
        if any(argument.star or argument.keyword for argument in call.args):
            return None
        given = [argument.value for argument in call.args]
        match call.func:
            case facts.Attribute(value=inner, attr=name) if name in _SAME_METHODS and not given:
                return self.path(inner)
            case facts.Attribute(value=inner, attr="joinpath"):
                return _joined(self.path(inner), [self._text(part) for part in given])
            case facts.Attribute(value=inner, attr="with_name") if len(given) == 1:
                return _joined(_above(self.path(inner)), [self._text(given[0])])
        name = called_name(call)
        if not given:
            return None
        if name in _SAME and len(given) == 1:
            return self.path(given[0])
        if name == "dirname" and len(given) == 1:
            return _above(self.path(given[0]))
        return _joined(self.path(given[0]), [self._text(part) for part in given[1:]]) if name == "join" else None

    def _text(self, value: facts.Base) -> str | None:
        return value.text if value.text is not None else self._texts.get(value.variable)


def _above(path: str | None, count: int = 1) -> str | None:
    if path is None or not 0 < count <= _MANY:
        return None
    return posixpath.normpath(posixpath.join(path, *[".."] * count))


def _joined(start: str | None, texts: list[str | None]) -> str | None:
    if start is None or any(text is None or text.startswith("/") for text in texts):
        return None
    return posixpath.normpath(posixpath.join(start, *filter(None, texts)))


def _with_text(start: str | None, text: str | None) -> str | None:
    return None if start is None or text is None or not text.startswith("/") else posixpath.normpath(start + text)


def of_file(path: str, file: str) -> str:
    """A path that :func:`paths_beside` gives, as that of the workspace; ``file`` is the one that writes it."""
    return posixpath.normpath(posixpath.join(posixpath.dirname(file), path))


__all__ = ["FILE", "OwnPath", "may_write", "of_file", "paths_beside"]

"""Paths below the share folder of a package, as code of Python or C++ writes them.

``os.path.join(get_package_share_directory('robot'), 'data')``, a sum of texts, an f-string, and the ``/`` of pathlib
and of ``std::filesystem``; also in parts, through variables that only ever have one value.
"""

from __future__ import annotations

import posixpath
from collections import Counter
from collections.abc import Iterator
from typing import NamedTuple

from archlint.analysis.kept import kept_for_each_file
from archlint.syntax import facts
from archlint.syntax.parts import everything_in, once_for
from archlint.syntax.walk import called_name

SHARE = "get_package_share_directory"
SHARES = frozenset({SHARE, "get_package_share_path"})
_WRAPPERS = frozenset({"Path", "PurePath", "path", "str", "string", "fspath", "as_posix"})
"""What makes another kind of path, or a text, of a path."""
ASKS = frozenset({"exists", "isfile", "is_file", "lexists", "is_regular_file", "isdir", "is_dir", "is_directory"})
"""What code asks that can do without a file."""
_ROUNDS = 3
"""Variables of variables."""


class _Path(NamedTuple):
    """A text that begins with the share folder of a package: the package, and what follows."""

    package: str
    below: str


class Named(NamedTuple):
    """A path below the share folder of a package, by its normal form, and where it is written."""

    package: str
    path: str
    span: facts.Span


@kept_for_each_file
def paths_in_share(file_facts: facts.Facts) -> list[Named]:
    """The paths that a file of Python writes in full; none where it asks whether some file is there."""
    return paths_in_code(file_facts)


@once_for
def paths_in_code(file_facts: facts.Facts) -> list[Named]:
    """The paths that a file writes in full; none where it asks whether some file is there."""
    if any(called_name(call) in ASKS for call in everything_in(file_facts.body, facts.Call)):
        return []
    reader = _Reader(file_facts)
    parts: list[facts.Call | facts.Binary | facts.FormatString] = []
    within: set[int] = set()
    for part in everything_in(file_facts.body):
        if isinstance(part, (facts.Call, facts.Binary, facts.FormatString)):
            parts.append(part)
            within.update(id(inner) for inner in _parts_of_a_path(part))
    rows = []
    within |= _kept_for_nobody(file_facts)
    for part in parts:
        path = reader.path(part) if id(part) not in within else None
        below = posixpath.normpath(path.below.strip("/")) if path is not None and path.below.startswith("/") else "."
        if path is not None and below.partition("/")[0] not in (
            ".",
            "..",
        ):  # what is around the folder is not asked for
            rows.append(Named(path.package, below, part.span))
    return rows


def _kept_for_nobody(file_facts: facts.Facts) -> set[int]:
    """What functions assign to variables whose names the file never has again: no path that anything opens."""
    uses = Counter(name.id for name in everything_in(file_facts.body, facts.Name))
    values = set()
    for function in everything_in(file_facts.body, facts.Function):
        for assign in everything_in(function.body, facts.Assign):
            if all(target.variable and uses[target.variable] == 1 for target in assign.targets):
                values.add(id(assign.value))
    return values


def _parts_of_a_path(part: facts.Call | facts.Binary | facts.FormatString) -> Iterator[facts.Base]:
    """What a path, if this is one, goes on from: it is no path of its own."""
    if isinstance(part, facts.Binary):
        yield part.left
    elif isinstance(part, facts.FormatString):
        yield from (inner.value for inner in part.parts if not isinstance(inner, str))
    elif called_name(part) == "join" or called_name(part) in _WRAPPERS:
        yield from (argument.value for argument in part.args)


class _Reader:
    """What the expressions of a file mean, as far as its own text says."""

    def __init__(self, file_facts: facts.Facts) -> None:
        self._given = only_given(file_facts)
        self._paths: dict[str, _Path] = {}
        self._texts = {name: value.text for name, value in self._given.items() if value.text is not None}
        for _ in range(_ROUNDS):
            self._paths |= {name: path for name, value in self._given.items() if (path := self.path(value))}

    def path(self, value: facts.Base) -> _Path | None:
        """The path below a share folder that an expression is; None where it is none, or not known in full."""
        match value:
            case facts.Call(args=[facts.Argument(value=inner, star="")]) if called_name(value) in _WRAPPERS | {"join"}:
                return self.path(inner)
            case facts.Call() if called_name(value) in SHARES:
                package = self._package(value)
                return None if package is None else _Path(package, "")
            case facts.Call(args=[facts.Argument(value=first), *others]) if called_name(value) == "join":
                if any(argument.star or argument.keyword for argument in value.args):
                    return None
                return self._joined(first, [argument.value for argument in others])
            case facts.Binary(op="/", left=left, right=right):
                return self._joined(left, [right])
            case facts.Binary(op="+", left=left, right=right):
                return self._with_text(self.path(left), self._text(right))
            case facts.FormatString(parts=[facts.Field(value=first, conversion=None, spec=None), *others]):
                texts = [part if isinstance(part, str) else self._text(part.value) for part in others]
                return self._with_text(self.path(first), None if None in texts else "".join(filter(None, texts)))
        return self._paths.get(value.variable)

    def _package(self, call: facts.Call) -> str | None:
        names = [argument.value for argument in call.args]
        return self._text(names[0]) if len(names) == 1 else None

    def _text(self, value: facts.Base) -> str | None:
        return value.text if value.text is not None else self._texts.get(value.variable)

    def _joined(self, first: facts.Base, parts: list[facts.Expr]) -> _Path | None:
        start, texts = self.path(first), [self._text(part) for part in parts]
        if start is None or any(text is None or text.startswith("/") for text in texts):
            return None
        return _Path(start.package, "/".join([start.below, *filter(None, texts)]))

    @staticmethod
    def _with_text(start: _Path | None, text: str | None) -> _Path | None:
        return None if start is None or text is None else _Path(start.package, start.below + text)


def only_given(file_facts: facts.Facts) -> dict[str, facts.Expr]:
    """The variables that are assigned once, or always the same, and what they are given."""
    given: dict[str, list[facts.Expr | None]] = {}
    for part in everything_in(file_facts.body):
        match part:
            case facts.Assign(targets=targets, value=value):
                for target in targets:
                    given.setdefault(target.variable, []).append(value)
            case facts.Augmented(target=target):
                given.setdefault(target.variable, []).append(None)
            case facts.Param(name=name):
                given.setdefault(name, []).append(None)
    return {
        name: values[0]
        for name, values in given.items()
        if name and values[0] is not None and all(value is not None and _is_like(value, values[0]) for value in values)
    }


def _is_like(value: facts.Expr, other: facts.Expr) -> bool:
    """Whether two expressions say the same for certain: one text, or the share folder of one package."""
    if value is other:
        return True
    if value.text is not None:
        return value.text == other.text
    match value, other:
        case facts.Call(args=[mine]), facts.Call(args=[theirs]):
            text = mine.value.text
            return called_name(value) == called_name(other) in SHARES and text is not None and text == theirs.value.text
    return False


__all__ = ["ASKS", "SHARE", "Named", "only_given", "paths_in_code", "paths_in_share"]

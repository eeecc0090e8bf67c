"""Calls that only give a result, on a line that throws it away: ``sorted(robots)``, ``np.append(poses, pose)``.

Source: Python's documentation of ``sorted()`` and of texts, which never change; numpy's, whose functions of this table
change nothing that they are given.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.kept import kept_for_each_file
from archlint.place import Place
from archlint.python_code.imported_modules import bindings_of
from archlint.python_code.offered_names import may_make_names, stars
from archlint.records import dataclass
from archlint.syntax import facts
from archlint.syntax.parts import Itself, everything_in

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex

_SORTED = "sorted"
_OF_NUMPY = frozenset(
    {"append", "concatenate", "delete", "flip", "hstack", "insert", "roll", "sort", "unique", "vstack"}
)
"""Functions of numpy that make another array of the one they are given."""
_REPLACE = "replace"
_TWO = 2


@dataclass(frozen=True)
class DroppedResult:
    """``sorted(robots)`` on a line of its own: ``given`` stays as it is."""

    place: Place
    function: str
    given: str
    result: str
    """What it returns."""


def dropped_results(workspace: WorkspaceIndex) -> Iterator[DroppedResult]:
    """Every such line in the files that were asked for, but for test code and code that tries what fails."""
    for path in workspace.python_files():
        for span, function, given in _dropped(workspace, path) or ():
            yield DroppedResult(Place(path, *span), function, given, _result_of(function))


def _result_of(function: str) -> str:
    if function == _SORTED:
        return "a new list"
    return "another text" if function.endswith(f".{_REPLACE}") else "a new array"


@kept_for_each_file
def _dropped(code: facts.Facts) -> list[tuple[facts.Span, str, str]]:
    if may_make_names(code) or stars(code):
        return []
    numpy = frozenset(_names_of_numpy(code))
    lines = [each for each in everything_in(code.body, facts.Expression) if isinstance(each.value, facts.Call)]
    rows = [(each, *row) for each in lines for row in _row_of(each.value, code, numpy)]
    tried = {Itself(part) for attempt in everything_in(code.body, facts.Try) for part in everything_in(attempt.body)}
    return [(line.span, function, given) for line, function, given in rows if Itself[facts.Base](line) not in tried]


def _row_of(call: facts.Expr, code: facts.Facts, numpy: frozenset[str]) -> Iterator[tuple[str, str]]:
    """The function and what it is given, where the call is of such a one."""
    match call:
        case facts.Call(func=facts.Name(id=name), args=[facts.Argument(value=value, star="", keyword=None), *_]):
            if name == _SORTED and not bindings_of(code)[name] and value.dotted:
                yield name, value.dotted
        case facts.Call(
            func=facts.Attribute(value=facts.Name(id=module), attr=name),
            args=[facts.Argument(value=value, star="", keyword=None), *others],
        ) if module in numpy:
            if name in _OF_NUMPY and value.dotted and all(each.keyword != "out" and not each.star for each in others):
                yield f"{module}.{name}", value.dotted
        case facts.Call(func=facts.Attribute(value=owner, attr=name), args=args) if name == _REPLACE:
            root = owner.dotted.partition(".")[0]
            if root and not _is_imported(code, root) and len(args) == _TWO and all(map(_is_text, args)):
                yield call.func.dotted, owner.dotted


def _is_text(argument: facts.Argument) -> bool:
    match argument:
        case facts.Argument(value=facts.Literal(value=str()), keyword=None, star=""):
            return True
    return False


def _is_imported(code: facts.Facts, name: str) -> bool:
    plain = (each.alias or each.module.partition(".")[0] for each in everything_in(code.body, facts.Import))
    others = (bound for each in everything_in(code.body, facts.ImportFrom) for _, bound in each.names)
    return name in {*plain, *others}


def _names_of_numpy(code: facts.Facts) -> Iterator[str]:
    for statement in code.body:
        match statement:
            case facts.Import(module="numpy", alias=alias) if bindings_of(code)[alias or "numpy"] == 1:
                yield alias or "numpy"


__all__ = ["DroppedResult", "dropped_results"]

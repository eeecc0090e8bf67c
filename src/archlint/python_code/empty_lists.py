"""Items of lists that are empty for certain: ``angles = []``, then ``angles[0] = 1.0``."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Union

from archlint.analysis.kept import kept_for_each_file
from archlint.place import Place
from archlint.python_code.tried_code import tried_for
from archlint.records import dataclass
from archlint.syntax import facts
from archlint.syntax.parts import Itself, everything_in

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex

_CAUGHT = ("IndexError", "LookupError", "Exception", "BaseException")
_Row = tuple[facts.Span, str, facts.Span]


@dataclass(frozen=True)
class ItemOfNothing:
    """``angles[0]`` of a list into which nothing has been put; ``empty_at`` is where it comes from."""

    place: Place
    name: str
    empty_at: Place


def items_of_nothing(workspace: WorkspaceIndex) -> Iterator[ItemOfNothing]:
    """Every such line in the files that were asked for, but for test code."""
    for path in workspace.python_files():
        for span, name, empty_at in _items(workspace, path) or ():
            yield ItemOfNothing(Place(path, *span), name, Place(path, *empty_at))


# ------------------------------------------------------------------------------------------------- by the text alone


@kept_for_each_file
def _items(code: facts.Facts) -> list[_Row]:
    return [row for function in everything_in(code.body, facts.Function) for row in _in_function(function)]


def _in_function(function: facts.Function) -> Iterator[_Row]:
    """The first such item of each list."""
    expecting = tried_for(function.body, _CAUGHT)
    for attempt in everything_in(function.body, facts.Try):
        if any(handler.type is None for handler in attempt.handlers):
            expecting.update(map(Itself, everything_in(attempt.body)))
    shared = {name for each in everything_in(function.body, facts.Global) for name in each.names}
    blocks = [function.body]
    while blocks:
        block = blocks.pop()
        for at, statement in enumerate(block):
            if not isinstance(statement, (facts.Function, facts.Class)):
                blocks += statement.blocks
            if not isinstance(statement, (facts.Assign, facts.Annotated)):
                continue
            name = _made_empty(statement)
            if name is not None and name not in shared:
                met = _first(block[at + 1 :], name)
                if isinstance(met, facts.Subscript) and Itself[facts.Base](met) not in expecting:
                    yield met.span, name, statement.span


def _made_empty(statement: facts.Assign | facts.Annotated) -> str | None:
    """The variable to which a line assigns an empty list."""
    match statement:
        case facts.Assign(targets=[facts.Name(id=name)], value=value):
            return name if _is_empty(value) else None
        case facts.Annotated(target=facts.Name(id=name), value=value):
            return name if value is not None and _is_empty(value) else None
    return None


def _is_empty(value: facts.Expr) -> bool:
    match value:
        case facts.Sequence(kind="list", elements=[]) | facts.Call(func=facts.Name(id="list"), args=[]):
            return True
    return False


class _Other:
    """Code that names a variable, and of which nothing is said."""


_OTHER = _Other()
_Met = Union[facts.Subscript, _Other, None]


def _first(block: Sequence[facts.Stmt], name: str, *, in_loop: bool = False) -> _Met:
    """The item that the first code with a variable asks it for, whichever way leads there.  A branch inside a loop may
    be for later rounds."""
    for statement in block:
        match statement:
            case facts.If(test=head) | facts.For(iterable=head) | facts.While(test=head):
                met = _asked([head], name)
            case facts.With() | facts.Try() | facts.Match() | facts.Function() | facts.Class():
                met = _OTHER if _names(statement, name) else None
            case _:
                met = _asked([statement], name)
        if met is None and statement.blocks and not isinstance(statement, (facts.Function, facts.Class)):
            is_loop = isinstance(statement, (facts.For, facts.While))
            ways = [_first(each, name, in_loop=in_loop or is_loop) for each in statement.blocks]
            asked = [way for way in ways if isinstance(way, facts.Subscript)]
            if any(ways):
                met = asked[0] if asked and not in_loop else _OTHER
        if met is not None:
            return met
    return None


def _names(part: facts.Base, name: str) -> bool:
    return any(each.id == name for each in everything_in([part], facts.Name))


def _asked(parts: Sequence[facts.Base], name: str) -> _Met:
    """The item that some code takes of a variable for certain, where it does nothing else with it."""
    items: list[facts.Subscript] = []
    stack = [(part, True) for part in parts]
    while stack:
        part, surely = stack.pop()
        match part:
            case facts.Subscript(value=facts.Name(id=owner), index=index) if owner == name:
                if not surely or isinstance(index, facts.Slice) or _names(index, name):
                    return _OTHER
                items.append(part)
                stack.append((index, True))
                continue
            case facts.Name(id=owner) if owner == name:
                return _OTHER
            case facts.Boolean(values=[value, *others]):
                stack += [(value, surely), *((other, False) for other in others)]
                continue
            case facts.Conditional() | facts.Comprehension() | facts.Lambda() | facts.Assert():
                surely = False
        stack += [(child, surely) for child in part.children()]
    return items[-1] if items else None


__all__ = ["ItemOfNothing", "items_of_nothing"]

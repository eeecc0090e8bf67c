"""Messages that never leave the function that makes them: nothing sends, returns or keeps them.

Only what is sent is converted, and only then do the messages of jazzy and later find out what a field was given.  A
point that goes through ``do_transform_point()`` and nowhere else is a place to keep three numbers.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING

from archlint.analysis.kept import kept_for_each_file
from archlint.place import Place
from archlint.python_code.message_variables import imported_messages, makes_message, variables_of_messages
from archlint.syntax import facts
from archlint.syntax.flow_facts import holds
from archlint.syntax.parts import Itself, everything_in, parts_of

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex

_COMPUTES = "do_transform_"
"""How the functions of tf2_geometry_msgs and tf2_sensor_msgs begin that make another message of one."""
_PUTS = frozenset({"append", "extend", "insert"})
_SAYS = frozenset({"print", "str", "repr", "debug", "info", "warn", "warning", "error", "fatal"})
_OF_NUMBERS = frozenset({"math", "np", "numpy"})
"""Modules whose functions take numbers and give others."""


def is_never_sent(workspace: WorkspaceIndex | None, place: Place) -> bool:
    """Whether a place sets a field of such a message."""
    spans = (_statements(workspace, place.file) if workspace is not None else None) or ()
    return any(holds(span, place.span) for span in spans)


@kept_for_each_file
def _statements(code: facts.Facts) -> list[facts.Span]:
    """The assignments of a file that make such a message or set something of it."""
    classes = imported_messages(code)
    functions = everything_in(code.body, facts.Function) if classes else ()
    return [span for function in functions for span in _in(function, classes)]


def _in(function: facts.Function, classes: dict[str, str]) -> Iterator[facts.Span]:
    staying = _staying(function, classes)
    for part in parts_of(function.body) if staying else ():
        match part:
            case facts.Assign(targets=targets, value=value) if all(_root(target) in staying for target in targets):
                if all(isinstance(target, facts.Attribute) for target in targets) or _is_made(value, classes):
                    yield part.span
            case facts.Expression(value=facts.Call(func=facts.Attribute(value=held, attr=method))) if method in _PUTS:
                if _root(held) in staying:
                    yield part.span


def _is_made(value: facts.Expr, classes: dict[str, str]) -> bool:
    """Whether an expression makes a message, and gives what it calls to this message alone."""
    calls = everything_in(value, facts.Call)
    return makes_message(value, classes) and all(makes_message(call, classes) or call is value for call in calls)


def _staying(function: facts.Function, classes: dict[str, str]) -> set[str]:
    """The variables whose messages stay where they are: each is put, if at all, into another that does."""
    staying = variables_of_messages(function, classes)
    uses = {base: into for part in everything_in(function.body) for base, into in _uses(part, classes)}
    mentions = [part for part in everything_in(function.body, facts.Name) if part.id in staying]
    while leaving := {
        name.id for name in mentions if name.id in staying and not uses.get(Itself(name), _ANYWHERE) <= staying
    }:
        staying -= leaving
    return staying


_ANYWHERE = frozenset({""})
_NOWHERE = frozenset[str]()


def _uses(part: facts.Base, classes: dict[str, str]) -> Iterator[tuple[Itself[facts.Name], frozenset[str]]]:
    """What is done with variables, where that is known: the variables into whose messages each is put."""
    match part:
        case facts.Assign(targets=targets, value=value):
            into = frozenset(map(_root, targets))
            yield from ((base, _NOWHERE) for base in _bases(targets))
            yield from ((base, into) for base in _bases((value, *_given(value, classes))))
        case facts.Call(func=facts.Attribute(value=facts.Attribute() as held, attr=method), args=args) if (
            method in _PUTS
        ):
            given = [each for argument in args for each in (argument.value, *_given(argument.value, classes))]
            yield from ((base, _NOWHERE) for base in _bases((held,)))
            yield from ((base, frozenset({_root(held)})) for base in _bases(given))
        case facts.Call(func=func, args=args) if _is_harmless(func):
            yield from ((base, _NOWHERE) for base in _bases(argument.value for argument in args))
        case facts.Binary(left=left, right=right):
            yield from ((base, _NOWHERE) for base in _bases((left, right)))
        case facts.Compare(left=left, comparators=others):
            yield from ((base, _NOWHERE) for base in _bases((left, *others)))
        case facts.Field(value=value):
            yield from ((base, _NOWHERE) for base in _bases((value,)))


def _given(value: facts.Expr, classes: dict[str, str]) -> Iterator[facts.Expr]:
    """What a constructor of a message is given, and those inside it."""
    if isinstance(value, facts.Call) and makes_message(value, classes):
        for argument in value.args:
            yield argument.value
            yield from _given(argument.value, classes)


def _is_harmless(function: facts.Expr) -> bool:
    """Whether a call keeps nothing of what it is given, and gives back something else."""
    module = function.dotted.partition(".")[0]
    return function.last_name.startswith(_COMPUTES) or function.last_name in _SAYS or module in _OF_NUMBERS


def _bases(expressions: Iterable[facts.Expr]) -> Iterator[Itself[facts.Name]]:
    """The variables that names and chains of attributes begin with."""
    return (Itself(base) for e in expressions if (base := _base(e)) is not None)


def _base(e: facts.Base) -> facts.Name | None:
    while isinstance(e, facts.Attribute):
        e = e.value
    return e if isinstance(e, facts.Name) else None


def _root(target: facts.Base) -> str:
    base = _base(target)
    return "" if base is None else base.id


__all__ = ["is_never_sent"]

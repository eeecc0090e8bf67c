"""What an expression of launch is made of, as a text: two that are built alike say the same, whatever it is."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from archlint.interpreter import containers
from archlint.interpreter.values import ClassValue, Instance, Known, ListValue, Value
from archlint.launch.objects import LaunchObject, given_of, kind_of

if TYPE_CHECKING:
    from archlint.launch.run import LaunchRun

OPAQUE = "\2"
"""Stands around the number of an object of which no more is known than that it is always the same one."""

WHERE = "\3"
"""Stands around the file of a class: two classes may share a name."""

NESTING = 20


def shape_of(run: LaunchRun, value: Value, depth: int = 0) -> str:
    """The text of an expression; the names of launch arguments stand between NULs in it."""
    if depth > NESTING:
        return _opaque(run, value)
    match value:
        case Known(value=constant):
            return str(constant)
        case ListValue():
            return _list(run, value, depth)
        case LaunchObject(kind=kind) if kind in _SHAPES:
            return _SHAPES[kind](run, value, depth)
        case LaunchObject(rest=rest):
            given = [*value.arguments.items(), *(("", item) for item in rest)]
            return f"{value.kind}({_written(run, given, depth)})"
        case Instance(cls=ClassValue() as cls):
            return _own_object(run, value, cls, depth)
        case Instance():
            return f"{value.note or kind_of(value)}({_written(run, list(value.arguments.items()), depth)})"
    name = run.names.of(value)
    return _opaque(run, value) if name is None else f"\0{name}\0"


def _opaque(run: LaunchRun, value: Value) -> str:
    return f"{OPAQUE}{run.names.number(value)}{OPAQUE}"


def _part(run: LaunchRun, value: LaunchObject, name: str, depth: int) -> str:
    found = value.argument(name)
    return "" if found is None else shape_of(run, found, depth + 1)


def _list(run: LaunchRun, value: ListValue, depth: int) -> str:
    items = containers.items_of(run, value)
    return _opaque(run, value) if items.open else "".join(shape_of(run, item, depth + 1) for item in items.values)


def _own_object(run: LaunchRun, value: Instance, cls: ClassValue, depth: int) -> str:
    """``Class(arguments)`` of a class of this workspace."""
    given = given_of(run, value)
    if given is None:
        return _opaque(run, value)
    return f"{cls.qualified}{WHERE}{cls.scope.module.path}{WHERE}({_written(run, given, depth)})"


def _written(run: LaunchRun, given: Sequence[tuple[str, Value]], depth: int) -> str:
    return ", ".join(f"{name}={shape_of(run, item, depth + 1)}" for name, item in given)


def _configuration(run: LaunchRun, value: LaunchObject, depth: int) -> str:
    name = run.text_of(value.argument("variable_name"))
    return _opaque(run, value) if name is None else f"\0{run.argument_behind(name)}\0"


def _expression(run: LaunchRun, value: LaunchObject, depth: int) -> str:
    return _part(run, value, "expression", depth)


def _not(run: LaunchRun, value: LaunchObject, depth: int) -> str:
    return f"not {_part(run, value, 'value', depth)}"


def _equality(run: LaunchRun, value: LaunchObject, depth: int) -> str:
    left, right = _part(run, value, "left", depth), _part(run, value, "right", depth)
    if "\0" in right and "\0" not in left:
        left, right = right, left
    return f"{left} {'==' if value.kind == 'EqualsSubstitution' else '!='} '{right}'"


def _both(run: LaunchRun, value: LaunchObject, depth: int) -> str:
    word = "and" if value.kind == "AndSubstitution" else "or"
    return f"{_part(run, value, 'left', depth)} {word} {_part(run, value, 'right', depth)}"


def _environment(run: LaunchRun, value: LaunchObject, depth: int) -> str:
    return f"${_part(run, value, 'name', depth)}"


_SHAPES = {
    "LaunchConfiguration": _configuration,
    "PythonExpression": _expression,
    "NotSubstitution": _not,
    "EqualsSubstitution": _equality,
    "NotEqualsSubstitution": _equality,
    "AndSubstitution": _both,
    "OrSubstitution": _both,
    "EnvironmentVariable": _environment,
}

"""What an expression of launch is made of, as a text: two that are built alike say the same, whatever it is."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.interpreter import containers
from archlint.interpreter.values import ClassValue, Instance, Known, ListValue, Value
from archlint.launch.objects import GIVEN, LaunchObject, argument, kind_of

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
    if isinstance(value, Known):
        return str(value.value)
    if isinstance(value, ListValue):
        return _list(run, value, depth)
    if isinstance(value, Instance):
        build = _SHAPES.get(kind_of(value))
        return _object(run, value, depth) if build is None else build(run, value, depth)
    name = run.names.of(value)
    return _opaque(run, value) if name is None else f"\0{name}\0"


def _opaque(run: LaunchRun, value: Value) -> str:
    return f"{OPAQUE}{run.names.number(value)}{OPAQUE}"


def _part(run: LaunchRun, value: Value, name: str, depth: int) -> str:
    found = argument(value, name)
    return "" if found is None else shape_of(run, found, depth + 1)


def _list(run: LaunchRun, value: ListValue, depth: int) -> str:
    items = containers.items_of(run, value)
    return _opaque(run, value) if items.open else "".join(shape_of(run, item, depth + 1) for item in items.values)


def _object(run: LaunchRun, value: Instance, depth: int) -> str:
    """``Class(arguments)``, of launch's own, of another package or of this workspace."""
    given: list[tuple[str, Value]] = list(value.arguments.items())
    given += [("", item) for item in value.rest] if isinstance(value, LaunchObject) else []
    name, where = value.note or kind_of(value), ""
    if isinstance(value.cls, ClassValue):
        kept = run.store.get(value.key, GIVEN)
        if not isinstance(kept, tuple):
            return _opaque(run, value)
        given, name, where = list(kept), value.cls.qualified, f"{WHERE}{value.cls.scope.module.path}{WHERE}"
    written = ", ".join(f"{key}={shape_of(run, item, depth + 1)}" for key, item in given)
    return f"{name}{where}({written})"


def _configuration(run: LaunchRun, value: Instance, depth: int) -> str:
    name = run.perform(argument(value, "variable_name"))
    return f"\0{run.argument_behind(str(name.value))}\0" if isinstance(name, Known) else _opaque(run, value)


def _expression(run: LaunchRun, value: Instance, depth: int) -> str:
    return _part(run, value, "expression", depth)


def _not(run: LaunchRun, value: Instance, depth: int) -> str:
    return f"not {_part(run, value, 'value', depth)}"


def _equality(run: LaunchRun, value: Instance, depth: int) -> str:
    left, right = _part(run, value, "left", depth), _part(run, value, "right", depth)
    if "\0" in right and "\0" not in left:
        left, right = right, left
    return f"{left} {'==' if kind_of(value) == 'EqualsSubstitution' else '!='} '{right}'"


def _both(run: LaunchRun, value: Instance, depth: int) -> str:
    word = "and" if kind_of(value) == "AndSubstitution" else "or"
    return f"{_part(run, value, 'left', depth)} {word} {_part(run, value, 'right', depth)}"


def _environment(run: LaunchRun, value: Instance, depth: int) -> str:
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

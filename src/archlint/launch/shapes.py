"""What an expression of launch is made of: two that are built alike have the same shape, whatever they come to."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

from archlint.interpreter.values import ClassValue, Instance, Known, ListValue, Value
from archlint.launch.objects import LaunchObject, class_name, given_of
from archlint.launch.shape import Argument, ClassFile, Part, SameObject, Shape
from archlint.launch.tables import LaunchClass

if TYPE_CHECKING:
    from archlint.launch.run import LaunchRun

NESTING = 20

Parts = list[Part]


def shape_of(run: LaunchRun, value: Value) -> Shape:
    """The shape of an expression."""
    return Shape.of(_parts(run, value, 0))


def _parts(run: LaunchRun, value: Value, depth: int) -> Parts:
    if depth > NESTING:
        return _opaque(run, value)
    match value:
        case Known(value=constant):
            return [str(constant)]
        case ListValue():
            return _list(run, value, depth)
        case LaunchObject(kind=kind) if kind in _SHAPES:
            return _SHAPES[kind](run, value, depth)
        case LaunchObject(rest=rest):
            given = [*value.arguments.items(), *(("", item) for item in rest)]
            return [f"{value.kind}(", *_written(run, given, depth), ")"]
        case Instance(cls=ClassValue() as cls):
            return _own_object(run, value, cls, depth)
        case Instance():
            given = list(value.arguments.items())
            return [f"{value.note or class_name(value)}(", *_written(run, given, depth), ")"]
    name = run.names.of(value)
    return _opaque(run, value) if name is None else [Argument(name)]


def _opaque(run: LaunchRun, value: Value) -> Parts:
    return [SameObject(run.names.number(value))]


def _part(run: LaunchRun, value: LaunchObject, name: str, depth: int) -> Parts:
    argument = value.argument(name)
    return [] if argument is None else _parts(run, argument, depth + 1)


def _list(run: LaunchRun, value: ListValue, depth: int) -> Parts:
    items = value.items(run)
    if items.open:
        return _opaque(run, value)
    return [part for item in items.values for part in _parts(run, item, depth + 1)]


def _own_object(run: LaunchRun, value: Instance, cls: ClassValue, depth: int) -> Parts:
    """``Class(arguments)`` of a class of this workspace."""
    given = given_of(run, value)
    if given is None:
        return _opaque(run, value)
    return [cls.qualified, ClassFile(cls.scope.module.path), "(", *_written(run, given, depth), ")"]


def _written(run: LaunchRun, given: Sequence[tuple[str, Value]], depth: int) -> Parts:
    parts: Parts = []
    for number, (name, item) in enumerate(given):
        parts += [f"{', ' if number else ''}{name}=", *_parts(run, item, depth + 1)]
    return parts


def _configuration(run: LaunchRun, value: LaunchObject, depth: int) -> Parts:
    name = run.text_of(value.argument("variable_name"))
    return _opaque(run, value) if name is None else [Argument(run.argument_behind(name))]


def _expression(run: LaunchRun, value: LaunchObject, depth: int) -> Parts:
    return _part(run, value, "expression", depth)


def _not(run: LaunchRun, value: LaunchObject, depth: int) -> Parts:
    return ["not ", *_part(run, value, "value", depth)]


def _equality(operator: str) -> Callable[[LaunchRun, LaunchObject, int], Parts]:
    def parts(run: LaunchRun, value: LaunchObject, depth: int) -> Parts:
        left, right = _part(run, value, "left", depth), _part(run, value, "right", depth)
        if Shape.of(right).arguments and not Shape.of(left).arguments:
            left, right = right, left
        return [*left, f" {operator} '", *right, "'"]

    return parts


def _both(word: str) -> Callable[[LaunchRun, LaunchObject, int], Parts]:
    def parts(run: LaunchRun, value: LaunchObject, depth: int) -> Parts:
        return [*_part(run, value, "left", depth), f" {word} ", *_part(run, value, "right", depth)]

    return parts


def _environment(run: LaunchRun, value: LaunchObject, depth: int) -> Parts:
    return ["$", *_part(run, value, "name", depth)]


_SHAPES: dict[LaunchClass, Callable[[LaunchRun, LaunchObject, int], Parts]] = {
    LaunchClass.LAUNCH_CONFIGURATION: _configuration,
    LaunchClass.PYTHON_EXPRESSION: _expression,
    LaunchClass.NOT_SUBSTITUTION: _not,
    LaunchClass.EQUALS_SUBSTITUTION: _equality("=="),
    LaunchClass.NOT_EQUALS_SUBSTITUTION: _equality("!="),
    LaunchClass.AND_SUBSTITUTION: _both("and"),
    LaunchClass.OR_SUBSTITUTION: _both("or"),
    LaunchClass.ENVIRONMENT_VARIABLE: _environment,
}

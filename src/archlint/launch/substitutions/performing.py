"""What the text of a substitution is, and of anything else that launch takes for one."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from archlint.interpreter import containers
from archlint.interpreter.attributes import get_attribute
from archlint.interpreter.values import (
    BoundMethod,
    ClassValue,
    FunctionValue,
    Holed,
    Instance,
    Known,
    ListValue,
    OneOf,
    Unknown,
    Value,
    one_of,
    reason,
)
from archlint.launch.objects import argument, kind_of, made_by_base
from archlint.launch.substitutions import logic, nav2, paths, texts

if TYPE_CHECKING:
    from archlint.launch.run import LaunchRun

DEEP_TEXT = 100
"""How deep lists and substitutions may stand in each other: one may hold itself."""
PARTS = 2_000
"""How many lists and substitutions one text may come to: one may stand in another twice, and that in the next."""


def _own_text(run: LaunchRun, value: Instance) -> Value:
    """The text of a substitution class of the workspace: what its ``perform`` returns."""
    method = get_attribute(run, value, "perform")
    if isinstance(method, BoundMethod) and isinstance(method.function, FunctionValue):
        found = run.ask(method)
        return found if isinstance(found, Unknown) else run.perform(found)
    base = made_by_base(run, value)
    return Unknown(reason(value)) if base is None else run.perform(base)


def perform(run: LaunchRun, value: Value | None) -> Value:
    """The text of what launch takes for one: a text, a substitution, a path, or a list of these."""
    if value is None:
        return Known("")
    if isinstance(value, Known):
        kind = "other" if value.kind == "path" else value.kind
        return Known(str(value.value), value.via, value.origin, kind) if value.value is not None else Known("")
    if isinstance(value, (Unknown, Holed)):
        return value
    if not run.performing:
        run.performed = 0
    if run.performing >= DEEP_TEXT or run.performed >= PARTS:
        return Unknown("a text of more parts than are followed")
    run.performing += 1
    run.performed += 1
    try:
        return _perform(run, value)
    finally:
        run.performing -= 1


def _perform(run: LaunchRun, value: Value) -> Value:
    if isinstance(value, OneOf):
        with run.perhaps():
            return one_of([run.perform(option) for option in value.values])
    if isinstance(value, ListValue):
        items = containers.items_of(run, value)
        if items.open:
            return Unknown("a text of parts that are not known")
        return texts.concatenate([run.perform(item) for item in items.values])
    kind = kind_of(value)
    if kind in SUBSTITUTIONS:
        assert isinstance(value, Instance)
        return SUBSTITUTIONS[kind](run, value)
    if isinstance(value, Instance) and isinstance(value.cls, ClassValue):
        return _own_text(run, value)
    return Unknown(reason(value))


def _value(run: LaunchRun, value: Instance) -> Value:
    return run.perform(argument(value, "value"))


def _not_here(what: str) -> Callable[[LaunchRun, Instance], Value]:
    return lambda run, value: Unknown(what)


SUBSTITUTIONS: dict[str, Callable[[LaunchRun, Instance], Value]] = {
    "LaunchConfiguration": texts.configuration,
    "TextSubstitution": texts.text,
    "PathJoinSubstitution": texts.path_join,
    "StringJoinSubstitution": texts.string_join,
    "EnvironmentVariable": texts.environment,
    "FindPackageShare": paths.share,
    "FindPackagePrefix": paths.prefix,
    "ExecutableInPackage": paths.executable,
    "ThisLaunchFileDir": paths.here,
    "ThisLaunchFile": paths.this_file,
    "AnonName": texts.anonymous,
    "PythonExpression": texts.python_expression,
    "NotSubstitution": logic.negation,
    "AndSubstitution": logic.connective(False),
    "AllSubstitution": logic.connective(False),
    "OrSubstitution": logic.connective(True),
    "AnySubstitution": logic.connective(True),
    "EqualsSubstitution": logic.equality,
    "NotEqualsSubstitution": logic.inequality,
    "IfElseSubstitution": logic.if_else,
    "BooleanSubstitution": logic.boolean,
    "ParameterValue": _value,
    "RewrittenYaml": nav2.rewritten_yaml,
    "ReplaceString": nav2.replaced_string,
    "HasNodeParams": nav2.has_node,
    "LaunchConfigAsBool": nav2.as_bool,
    "Command": _not_here("the output of a command"),
    "FindExecutable": _not_here("the path of an executable"),
    "FileContent": _not_here("the content of a file"),
    "LocalSubstitution": _not_here("what an event handler is told"),
    "ForLoopIndex": _not_here("the index of a loop"),
    "ForEachVar": _not_here("the variable of a loop"),
    "ParameterSubstitution": _not_here("the value of a parameter"),
}

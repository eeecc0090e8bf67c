"""What the text of a substitution is, and of anything else that launch takes for one."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from archlint.interpreter.values import (
    ClassValue,
    Holed,
    Instance,
    Known,
    ListValue,
    OneOf,
    Unknown,
    Value,
    chosen_with,
    one_of,
    reason,
)
from archlint.launch.functions import ask
from archlint.launch.objects import LaunchObject, made_by_base, own_method
from archlint.launch.shared_paths import note_paths_in_command
from archlint.launch.substitutions import expressions, logic, nav2, paths, texts
from archlint.launch.tables import LaunchClass

if TYPE_CHECKING:
    from archlint.launch.run import LaunchRun

DEEP_TEXT = 100
"""How deep lists and substitutions may be nested in each other: one may hold itself."""
PARTS = 2_000
"""How many lists and substitutions one text may come to: one may be in another twice, and that in the next."""


def _own_text(run: LaunchRun, value: Instance) -> Value:
    """The text of a substitution class of the workspace: what its ``perform`` returns."""
    method = own_method(run, value, "perform")
    if method is not None:
        text = ask(run, method)
        return text if isinstance(text, Unknown) else run.perform(text)
    base = made_by_base(run, value)
    return Unknown(reason(value)) if base is None else run.perform(base)


def perform(run: LaunchRun, value: Value | None) -> Value:
    """The text of what launch takes for one: a text, a substitution, a path, or a list of these."""
    match value:
        case None | Known(value=None):
            return Known("")
        case Known(value=constant, via=via, origin=origin, kind=kind):
            return Known(str(constant), via, origin, "other" if kind == "path" else kind)
        case Unknown() | Holed():
            return value
    if not run.performing:
        run.performed = 0
    if run.performing >= DEEP_TEXT or run.performed >= PARTS:
        return Unknown("a string with too many parts to follow")
    run.performing += 1
    run.performed += 1
    try:
        return _perform(run, value)
    finally:
        run.performing -= 1


def _perform(run: LaunchRun, value: Value) -> Value:
    match value:
        case OneOf(values=options):
            with run.perhaps():
                return chosen_with(one_of([run.perform(option) for option in options]), value)
        case ListValue():
            items = value.items(run)
            if items.open:
                return Unknown("a string with unknown parts")
            return texts.concatenate([run.perform(item) for item in items.values])
        case LaunchObject(kind=kind) if kind in SUBSTITUTIONS:
            return SUBSTITUTIONS[kind](run, value)
        case Instance(cls=ClassValue()):
            return _own_text(run, value)
    return Unknown(reason(value))


def _value(run: LaunchRun, value: LaunchObject) -> Value:
    return run.perform(value.argument("value"))


def _command(run: LaunchRun, value: LaunchObject) -> Value:
    """The output of a command is not known; the files that it is given are."""
    parts = [run.perform(part) for part in run.items(value.argument("command"))]
    note_paths_in_command(run, parts, value.place or run.place_now)
    return Unknown("the output of a command")


def _not_here(what: str) -> Callable[[LaunchRun, LaunchObject], Value]:
    return lambda run, value: Unknown(what)


SUBSTITUTIONS: dict[LaunchClass, Callable[[LaunchRun, LaunchObject], Value]] = {
    LaunchClass.LAUNCH_CONFIGURATION: texts.configuration,
    LaunchClass.TEXT_SUBSTITUTION: texts.text,
    LaunchClass.PATH_JOIN_SUBSTITUTION: texts.path_join,
    LaunchClass.STRING_JOIN_SUBSTITUTION: texts.string_join,
    LaunchClass.ENVIRONMENT_VARIABLE: texts.environment,
    LaunchClass.FIND_PACKAGE_SHARE: paths.share,
    LaunchClass.FIND_PACKAGE_PREFIX: paths.prefix,
    LaunchClass.EXECUTABLE_IN_PACKAGE: paths.executable,
    LaunchClass.THIS_LAUNCH_FILE_DIR: paths.here,
    LaunchClass.THIS_LAUNCH_FILE: paths.this_file,
    LaunchClass.ANON_NAME: texts.anonymous,
    LaunchClass.PYTHON_EXPRESSION: expressions.python_expression,
    LaunchClass.NOT_SUBSTITUTION: logic.negation,
    LaunchClass.AND_SUBSTITUTION: logic.connective(False),
    LaunchClass.ALL_SUBSTITUTION: logic.connective(False),
    LaunchClass.OR_SUBSTITUTION: logic.connective(True),
    LaunchClass.ANY_SUBSTITUTION: logic.connective(True),
    LaunchClass.EQUALS_SUBSTITUTION: logic.equality,
    LaunchClass.NOT_EQUALS_SUBSTITUTION: logic.inequality,
    LaunchClass.IF_ELSE_SUBSTITUTION: logic.if_else,
    LaunchClass.BOOLEAN_SUBSTITUTION: logic.boolean,
    LaunchClass.PARAMETER_VALUE: _value,
    LaunchClass.REWRITTEN_YAML: nav2.rewritten_yaml,
    LaunchClass.REPLACE_STRING: nav2.replaced_string,
    LaunchClass.HAS_NODE_PARAMS: nav2.has_node,
    LaunchClass.LAUNCH_CONFIG_AS_BOOL: nav2.as_bool,
    LaunchClass.COMMAND: _command,
    LaunchClass.FIND_EXECUTABLE: _not_here("the path of an executable"),
    LaunchClass.FILE_CONTENT: _not_here("the content of a file"),
    LaunchClass.LOCAL_SUBSTITUTION: _not_here("the argument of an event handler"),
    LaunchClass.FOR_LOOP_INDEX: _not_here("the index of a loop"),
    LaunchClass.FOR_EACH_VAR: _not_here("the variable of a loop"),
    LaunchClass.PARAMETER_SUBSTITUTION: _not_here("the value of a parameter"),
}

"""Substitutions: what their text is in a launch context."""

from __future__ import annotations

import math
import posixpath
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

from archlint.interpreter import constant_expressions
from archlint.interpreter.attributes import get_attribute
from archlint.interpreter.values import (
    BoundMethod,
    ClassValue,
    External,
    FunctionValue,
    Holed,
    Instance,
    Known,
    ListValue,
    OneOf,
    Unknown,
    Value,
    alternatives,
    file_origin,
    join_texts,
    one_of,
    reason,
)

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.launch.run import LaunchRun

COMBINATIONS = 12
DEEP_TEXT = 100
"""How deep lists and substitutions may stand in each other: one may hold itself."""
PARTS = 2_000
"""How many lists and substitutions one text may come to: one may stand in another twice, and that in the next."""


def kind_of(value: Value | None) -> str:
    """``Node`` for an object of launch's or launch_ros' ``Node`` …; empty for anything else."""
    if isinstance(value, Instance) and isinstance(value.cls, External) and value.cls.path.startswith("launch."):
        return value.cls.path.removeprefix("launch.")
    return ""


def argument(value: Value | None, name: str) -> Value | None:
    """A constructor argument; None where it was not given, or is None."""
    found = value.arguments.get(name) if isinstance(value, Instance) else None
    return None if isinstance(found, Known) and found.value is None else found


def made_by_base(run: LaunchRun, value: Value) -> Instance | None:
    """For an object of a workspace's class that derives from one of launch's: what ``super().__init__()`` made."""
    made = run.store.get(value.key, "#action") if isinstance(value, Instance) else None
    return made if isinstance(made, Instance) else None


def _own_text(run: LaunchRun, value: Instance) -> Value:
    """The text of a substitution class of the workspace: what its ``perform`` returns."""
    method = get_attribute(run, value, "perform")
    if isinstance(method, BoundMethod) and isinstance(method.function, FunctionValue):
        found = run.ask(method)
        return found if isinstance(found, Unknown) else perform(run, found)
    base = made_by_base(run, value)
    return Unknown(reason(value)) if base is None else perform(run, base)


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
            return one_of([perform(run, option) for option in value.values])
    if isinstance(value, ListValue):
        from archlint.interpreter import containers

        items = containers.items_of(run, value)
        if items.open:
            return Unknown("a text of parts that are not known")
        return concatenate([perform(run, item) for item in items.values])
    kind = kind_of(value)
    if kind in _SUBSTITUTIONS:
        assert isinstance(value, Instance)
        return _SUBSTITUTIONS[kind](run, value)
    if isinstance(value, Instance) and isinstance(value.cls, ClassValue):
        return _own_text(run, value)
    return Unknown(reason(value))


def concatenate(parts: Sequence[Value], joint: str = "") -> Value:
    """The parts one after the other, over all their alternatives."""
    rows: list[list[Value]] = [[]]
    for number, part in enumerate(parts):
        options = alternatives(part)
        if len(rows) * len(options) > COMBINATIONS:
            options = (Unknown("more values than can be followed"),)
        between = [Known(joint)] if joint and number else []
        rows = [[*row, *between, option] for row in rows for option in options]
    return one_of(row[0] if len(row) == 1 else join_texts(row, file_origin(*row)) for row in rows)


def written_at(value: Value, place: Place | None) -> Value:
    """A text that is not known to be written anywhere else, with where it is given."""
    if isinstance(value, Known) and value.origin is None:
        return Known(value.value, value.via, place, value.kind)
    return value


def _parts(run: LaunchRun, value: Value | None) -> list[Value]:
    from archlint.interpreter import containers

    if isinstance(value, ListValue):
        return list(containers.items_of(run, value).values)
    return [] if value is None else [value]


def _configuration(run: LaunchRun, value: Instance) -> Value:
    name = perform(run, argument(value, "variable_name"))
    if not isinstance(name, Known):
        run.result.reads_any = True
        return Unknown("the name of a launch configuration is not known")
    text = str(name.value)
    run.result.read.add(text)
    found = run.launch.configurations.get(text)
    if found is not None:
        return found
    default = value.arguments.get("default")
    if default is not None and default != Known(None):
        return perform(run, default)
    if value.place is not None:
        made = run.store.get(value.key, "#arms")
        in_branch = isinstance(made, frozenset) and bool(made - run.code_arms)
        run.note_undeclared(text, value.place, run.is_conditional or in_branch)
    return Unknown(f"the launch configuration '{text}' is not set")


def _text(run: LaunchRun, value: Instance) -> Value:
    return perform(run, argument(value, "text"))


def _path_join(run: LaunchRun, value: Instance) -> Value:
    parts = [perform(run, part) for part in _parts(run, argument(value, "substitutions"))]
    if all(isinstance(part, Known) for part in parts):
        texts = [str(part.value) for part in parts if isinstance(part, Known)]
        return Known(posixpath.join("", *texts), origin=file_origin(*parts))
    return concatenate(parts, "/")


def _string_join(run: LaunchRun, value: Instance) -> Value:
    joint = perform(run, argument(value, "delimiter"))
    parts = [perform(run, part) for part in _parts(run, argument(value, "substitutions"))]
    return concatenate(parts, str(joint.value)) if isinstance(joint, Known) else Unknown(reason(joint))


def _environment(run: LaunchRun, value: Instance) -> Value:
    name = perform(run, argument(value, "name"))
    if not isinstance(name, Known):
        return Unknown("the name of an environment variable is not known")

    found = run.launch.environment.get(str(name.value)) or run.library.environment(name.value)
    if found is not None:
        return found
    unknown = Unknown(f"the environment variable {name.value!s}")
    default = value.arguments.get("default_value")
    if default is None or default == Known(None) or name.value in _SET_EVERYWHERE:
        return unknown
    return perform(run, default)


_SET_EVERYWHERE = frozenset({"HOME", "LOGNAME", "PATH", "PWD", "SHELL", "USER"})
"""Variables that a login sets: their default is for the machine that has none."""


def package_share(name: str) -> Known:
    """The share folder of a package, as a path that says so."""
    return Known(f"$(find-pkg-share {name})")


def _share(run: LaunchRun, value: Instance) -> Value:
    rows = alternatives(perform(run, argument(value, "package")))
    return one_of(package_share(str(n.value)) if isinstance(n, Known) else Unknown(reason(n)) for n in rows)


def _prefix(run: LaunchRun, value: Instance) -> Value:
    name = perform(run, argument(value, "package"))
    return Known(f"$(find-pkg-prefix {name.value!s})") if isinstance(name, Known) else Unknown(reason(name))


def _executable(run: LaunchRun, value: Instance) -> Value:
    package = perform(run, argument(value, "package"))
    name = perform(run, argument(value, "executable"))
    parts = [Known("$(find-pkg-prefix "), package, Known(")/lib/"), package, Known("/"), name]
    return concatenate(parts)


def _here(run: LaunchRun, value: Instance) -> Value:
    return Known(posixpath.dirname(run.file_path))


def _this_file(run: LaunchRun, value: Instance) -> Value:
    return Known(run.file_path)


def _anonymous(run: LaunchRun, value: Instance) -> Value:
    name = perform(run, argument(value, "name"))
    return join_texts((name, Known("_"), Unknown("a name that launch makes unique")))


def expression_template(run: LaunchRun, value: Instance) -> Value:
    """The text of a Python expression, before it is evaluated."""
    return perform(run, argument(value, "expression"))


def _python(run: LaunchRun, value: Instance) -> Value:
    found: list[Value] = []
    for option in alternatives(expression_template(run, value)):
        if not isinstance(option, Known):
            found.append(Unknown(reason(option)))
            continue
        try:
            found.append(Known(str(constant_expressions.evaluate(str(option.value)))))
        except constant_expressions.NotFollowed as error:
            found.append(Unknown(str(error)))
    return one_of(found)


_TRUE = frozenset({"true", "1"})
_FALSE = frozenset({"false", "0"})


def truth_of(value: Value) -> bool | None:
    """Whether the text of a condition holds, in any case and between spaces; None where it is not known or launch
    refuses it (``evaluate_condition_expression``)."""
    return _agreed(value, lambda text: _in(text.strip().lower(), _TRUE, _FALSE))


_YAML_TRUE = frozenset({"true", "True", "TRUE", "yes", "Yes", "YES", "on", "On", "ON"})
_YAML_FALSE = frozenset({"false", "False", "FALSE", "no", "No", "NO", "off", "Off", "OFF"})


def typed_truth_of(value: Value) -> bool | None:
    """The same for launch's boolean substitutions, which read ``1``, ``0`` and what is a bool to PyYAML
    (``coerce_to_type``)."""
    digits = {"1": True, "0": False}
    return _agreed(value, lambda text: digits.get(text, _in(text.strip(), _YAML_TRUE, _YAML_FALSE)))


def _in(text: str, true: frozenset[str], false: frozenset[str]) -> bool | None:
    return True if text in true else False if text in false else None


def _agreed(value: Value, read: Callable[[str], bool | None]) -> bool | None:
    """What all alternatives of a text say."""
    verdicts = {read(str(option.value)) if isinstance(option, Known) else None for option in alternatives(value)}
    return verdicts.pop() if len(verdicts) == 1 else None


def _told(verdict: bool | None, *values: Value) -> Value:
    return Unknown(reason(*values)) if verdict is None else Known(str(verdict).lower())


def _not(run: LaunchRun, value: Instance) -> Value:
    inner = perform(run, argument(value, "value"))
    verdict = typed_truth_of(inner)
    return _told(None if verdict is None else not verdict, inner)


def _several(stop: bool) -> Callable[[LaunchRun, Instance], Value]:
    def evaluate(run: LaunchRun, value: Instance) -> Value:
        given = [value.arguments[name] for name in ("left", "right") if name in value.arguments]
        rest = run.store.get(value.key, "#rest")
        inner = [perform(run, part) for part in [*given, *(rest if isinstance(rest, tuple) else ())]]
        verdicts = [typed_truth_of(part) for part in inner]
        if stop in verdicts:
            return _told(stop)
        return _told(None if None in verdicts else not stop, *inner)

    return evaluate


def _equals(run: LaunchRun, value: Instance) -> Value:
    left, right = perform(run, argument(value, "left")), perform(run, argument(value, "right"))
    verdicts = {
        _same_text(str(one.value), str(other.value)) if isinstance(one, Known) and isinstance(other, Known) else None
        for one in alternatives(left)
        for other in alternatives(right)
    }
    return _told(verdicts.pop() if len(verdicts) == 1 else None, left, right)


def _same_text(one: str, other: str) -> bool:
    """launch compares two truth values, two numbers (nearly), or the texts as they are (``EqualsSubstitution``)."""
    truths = [_in(text.lower(), _TRUE, _FALSE) for text in (one, other)]
    if None not in truths:
        return truths[0] == truths[1]
    try:
        return math.isclose(float(one), float(other))
    except ValueError:
        return one == other


def _not_equals(run: LaunchRun, value: Instance) -> Value:
    same = _equals(run, value)
    return Known("false" if same.value == "true" else "true") if isinstance(same, Known) else same


def _if_else(run: LaunchRun, value: Instance) -> Value:
    test = perform(run, argument(value, "condition"))
    verdict = typed_truth_of(test)
    rows = {True: "if_value", False: "else_value"}
    if verdict is not None:
        return perform(run, argument(value, rows[verdict]))
    with run.perhaps():
        return one_of([perform(run, argument(value, name)) for name in rows.values()])


def _boolean(run: LaunchRun, value: Instance) -> Value:
    inner = perform(run, argument(value, "value"))
    return _told(typed_truth_of(inner), inner)


def _value(run: LaunchRun, value: Instance) -> Value:
    return perform(run, argument(value, "value"))


def _of_nav2(name: str) -> Callable[[LaunchRun, Instance], Value]:
    def evaluate(run: LaunchRun, value: Instance) -> Value:
        from archlint.launch import nav2

        return nav2.SUBSTITUTIONS[name](run, value)

    return evaluate


def _not_here(what: str) -> Callable[[LaunchRun, Instance], Value]:
    return lambda run, value: Unknown(what)


_SUBSTITUTIONS: dict[str, Callable[[LaunchRun, Instance], Value]] = {
    "LaunchConfiguration": _configuration,
    "TextSubstitution": _text,
    "PathJoinSubstitution": _path_join,
    "StringJoinSubstitution": _string_join,
    "EnvironmentVariable": _environment,
    "FindPackageShare": _share,
    "FindPackagePrefix": _prefix,
    "ExecutableInPackage": _executable,
    "ThisLaunchFileDir": _here,
    "ThisLaunchFile": _this_file,
    "AnonName": _anonymous,
    "PythonExpression": _python,
    "NotSubstitution": _not,
    "AndSubstitution": _several(False),
    "AllSubstitution": _several(False),
    "OrSubstitution": _several(True),
    "AnySubstitution": _several(True),
    "EqualsSubstitution": _equals,
    "NotEqualsSubstitution": _not_equals,
    "IfElseSubstitution": _if_else,
    "BooleanSubstitution": _boolean,
    "ParameterValue": _value,
    **{name: _of_nav2(name) for name in ("RewrittenYaml", "ReplaceString", "HasNodeParams", "LaunchConfigAsBool")},
    "Command": _not_here("the output of a command"),
    "FindExecutable": _not_here("the path of an executable"),
    "FileContent": _not_here("the content of a file"),
    "LocalSubstitution": _not_here("what an event handler is told"),
    "ForLoopIndex": _not_here("the index of a loop"),
    "ForEachVar": _not_here("the variable of a loop"),
    "ParameterSubstitution": _not_here("the value of a parameter"),
}

SUBSTITUTIONS = tuple(_SUBSTITUTIONS)

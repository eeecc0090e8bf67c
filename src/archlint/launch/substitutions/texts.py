"""Texts made of others: parts one after the other, joined, or read from configurations and the environment."""

from __future__ import annotations

import posixpath
from collections.abc import Sequence
from typing import TYPE_CHECKING

from archlint.interpreter import constant_expressions, containers
from archlint.interpreter.values import (
    Instance,
    Known,
    ListValue,
    Unknown,
    Value,
    alternatives,
    file_origin,
    join_texts,
    one_of,
    reason,
)
from archlint.launch.objects import LaunchObject, argument

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.launch.run import LaunchRun

COMBINATIONS = 12


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
    if isinstance(value, ListValue):
        return list(containers.items_of(run, value).values)
    return [] if value is None else [value]


def configuration(run: LaunchRun, value: Instance) -> Value:
    name = run.perform(argument(value, "variable_name"))
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
        return run.perform(default)
    if value.place is not None:
        in_branch = isinstance(value, LaunchObject) and bool(value.branch_arms - run.code_arms)
        run.note_undeclared(text, value.place, run.is_conditional or in_branch)
    return Unknown(f"the launch configuration '{text}' is not set")


def text(run: LaunchRun, value: Instance) -> Value:
    return run.perform(argument(value, "text"))


def path_join(run: LaunchRun, value: Instance) -> Value:
    parts = [run.perform(part) for part in _parts(run, argument(value, "substitutions"))]
    if all(isinstance(part, Known) for part in parts):
        texts = [str(part.value) for part in parts if isinstance(part, Known)]
        return Known(posixpath.join("", *texts), origin=file_origin(*parts))
    return concatenate(parts, "/")


def string_join(run: LaunchRun, value: Instance) -> Value:
    joint = run.perform(argument(value, "delimiter"))
    parts = [run.perform(part) for part in _parts(run, argument(value, "substitutions"))]
    return concatenate(parts, str(joint.value)) if isinstance(joint, Known) else Unknown(reason(joint))


def environment(run: LaunchRun, value: Instance) -> Value:
    name = run.perform(argument(value, "name"))
    if not isinstance(name, Known):
        return Unknown("the name of an environment variable is not known")
    found = run.launch.environment.get(str(name.value)) or run.library.environment(name.value)
    if found is not None:
        return found
    unknown = Unknown(f"the environment variable {name.value!s}")
    default = value.arguments.get("default_value")
    if default is None or default == Known(None) or name.value in _SET_EVERYWHERE:
        return unknown
    return run.perform(default)


_SET_EVERYWHERE = frozenset({"HOME", "LOGNAME", "PATH", "PWD", "SHELL", "USER"})
"""Variables that a login sets: their default is for the machine that has none."""


def anonymous(run: LaunchRun, value: Instance) -> Value:
    name = run.perform(argument(value, "name"))
    return join_texts((name, Known("_"), Unknown("a name that launch makes unique")))


def python_expression(run: LaunchRun, value: Instance) -> Value:
    found: list[Value] = []
    for option in alternatives(run.perform(argument(value, "expression"))):
        if not isinstance(option, Known):
            found.append(Unknown(reason(option)))
            continue
        try:
            found.append(Known(str(constant_expressions.evaluate(str(option.value)))))
        except constant_expressions.NotFollowed as error:
            found.append(Unknown(str(error)))
    return one_of(found)

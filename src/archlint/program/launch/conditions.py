"""Conditions: whether an action runs, and where no default decides it, what the two branches are called."""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import TYPE_CHECKING

from archlint.program.launch.substitutions import (
    argument,
    expression_template,
    kind_of,
    perform,
    truth_of,
)
from archlint.program.values import Instance, Known, ListValue, OneOf, Unknown, Value, alternatives

if TYPE_CHECKING:
    from archlint.program.launch.run import LaunchRun


@dataclass(frozen=True)
class Verdict:
    """``holds`` is None where the arguments do not decide; ``branch`` is then the arm that this action is in."""

    holds: bool | None
    branch: tuple[str, int] | None = None


ALWAYS = Verdict(True)


def judge(run: LaunchRun, condition: Value | None) -> Verdict:
    """The verdict on a ``condition=`` argument."""
    if condition is None:
        return ALWAYS
    kind = kind_of(condition)
    if kind in ("IfCondition", "UnlessCondition"):
        expected = kind == "IfCondition"
        given = argument(condition, "predicate_expression")
        holds = truth_of(perform(run, given))
        if holds is not None:
            return Verdict(holds is expected)
        return Verdict(None, _branch(run, given, expected))
    if kind in ("LaunchConfigurationEquals", "LaunchConfigurationNotEquals"):
        return _equality(run, condition, kind == "LaunchConfigurationEquals")
    place = condition.place if isinstance(condition, Instance) else None
    return Verdict(None, (f"condition at {place}", 1))


def _equality(run: LaunchRun, condition: Value, wanted: bool) -> Verdict:
    name = perform(run, argument(condition, "launch_configuration_name"))
    expected = perform(run, argument(condition, "expected_value"))
    if not isinstance(name, Known):
        return Verdict(None, None)
    text = str(name.value)
    found = run.launch.configurations.get(text)
    verdicts = set()
    for option in alternatives(found) if found is not None else ():
        both = isinstance(option, Known) and isinstance(expected, Known)
        verdicts.add(_same(option, expected) if both else None)
    if found is None:
        verdicts = {False}
    if len(verdicts) == 1 and None not in verdicts:
        return Verdict(verdicts.pop() is wanted)
    return Verdict(None, _arm_of_value(run, text, expected, wanted))


def _same(one: Value, other: Value) -> bool:
    assert isinstance(one, Known) and isinstance(other, Known)
    return str(one.value) == str(other.value)


def _arm_of_value(run: LaunchRun, name: str, expected: Value, wanted: bool) -> tuple[str, int] | None:
    """One branch an argument, one arm a value: ``mode:=a`` and ``mode:=b`` exclude each other."""
    if not isinstance(expected, Known):
        return None
    text = str(expected.value)
    if text.lower() in ("true", "false"):
        run.note_undecided(name, "true", "false")
        truth = (text.lower() == "true") is wanted
        return run.label((name, int(truth)), f"{name}:={str(truth).lower()}")
    run.note_undecided(name, text)
    if wanted:
        return run.label((name, 2 + run.number_of_value(name, text)), f"{name}:={text}")
    return run.label((f"{name}!={text}", 1), f"{name} other than {text}")


_EQUALS = re.compile(r"""^\s*['"]?\0(?P<name>[^\0]+)\0['"]?\s*(?P<op>==|!=)\s*['"](?P<value>[^'"]*)['"]\s*$""")
_PLAIN = re.compile(r"^\s*\0(?P<name>[^\0]+)\0\s*$")
_ARGUMENT = re.compile(r"\0([^\0]+)\0")
_OPERANDS = re.compile(r"\0[^\0]+\0|\b(?:and|or|not)\b|[()]")
"""What a test of truth values consists of."""
_NOT = re.compile(r"^\s*not\s+\0(?P<name>[^\0]+)\0\s*$")


def _branch(run: LaunchRun, expression: Value | None, expected: bool) -> tuple[str, int] | None:
    """The arm of an undecided test.  The same test elsewhere has the same branch."""
    template = _template(run, expression)
    if template is None:
        return None
    plain = _PLAIN.match(template)
    negated = _NOT.match(template)
    if plain or negated:
        name = (plain or negated)["name"]  # type: ignore[index]
        truth = expected if plain else not expected
        run.note_undecided(name, "true", "false")
        return run.label((name, int(truth)), f"{name}:={str(truth).lower()}")
    equality = _EQUALS.match(template)
    if equality:
        wanted = (equality["op"] == "==") is expected
        return _arm_of_value(run, equality["name"], Known(equality["value"]), wanted)
    if not _OPERANDS.sub("", template).strip():
        for name in _ARGUMENT.findall(template):
            run.note_undecided(name, "true", "false")
    shown = _ARGUMENT.sub(r"\1", template)
    return run.label((f"({shown})", int(expected)), f"{'' if expected else 'not '}({shown})")


def _template(run: LaunchRun, value: Value | None) -> str | None:
    """The text of a test with the names of configurations between NULs."""
    if isinstance(value, Known):
        return str(value.value)
    if isinstance(value, ListValue):
        from archlint.program import containers

        parts = [_template(run, item) for item in containers.items_of(run, value).values]
        return None if None in parts else "".join(part for part in parts if part is not None)
    kind = kind_of(value)
    if kind == "LaunchConfiguration":
        name = perform(run, argument(value, "variable_name"))
        return f"\0{name.value!s}\0" if isinstance(name, Known) else None
    if kind == "PythonExpression":
        return _template(run, argument(value, "expression"))
    if kind == "NotSubstitution":
        inner = _template(run, argument(value, "value"))
        return None if inner is None else f"not {inner}"
    if kind in ("EqualsSubstitution", "NotEqualsSubstitution"):
        left, right = _template(run, argument(value, "left")), _template(run, argument(value, "right"))
        if left is None or right is None:
            return None
        if "\0" in right and "\0" not in left:
            left, right = right, left
        return f"{left} {'==' if kind == 'EqualsSubstitution' else '!='} '{right}'"
    if kind in ("AndSubstitution", "OrSubstitution"):
        left, right = _template(run, argument(value, "left")), _template(run, argument(value, "right"))
        word = "and" if kind == "AndSubstitution" else "or"
        return None if left is None or right is None else f"{left} {word} {right}"
    if kind == "EnvironmentVariable":
        name = perform(run, argument(value, "name"))
        return f"${name.value!s}" if isinstance(name, Known) else None
    return None


__all__ = ["ALWAYS", "OneOf", "Unknown", "Verdict", "expression_template", "judge"]

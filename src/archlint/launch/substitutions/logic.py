"""Truth: of the texts of conditions, and what launch's boolean substitutions make of others."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import TYPE_CHECKING

from archlint.interpreter.values import Instance, Known, Unknown, Value, alternatives, one_of, reason
from archlint.launch.objects import LaunchObject, argument

if TYPE_CHECKING:
    from archlint.launch.run import LaunchRun


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


def negation(run: LaunchRun, value: Instance) -> Value:
    inner = run.perform(argument(value, "value"))
    verdict = typed_truth_of(inner)
    return _told(None if verdict is None else not verdict, inner)


def connective(stop: bool) -> Callable[[LaunchRun, Instance], Value]:
    def evaluate(run: LaunchRun, value: Instance) -> Value:
        given = [value.arguments[name] for name in ("left", "right") if name in value.arguments]
        rest = value.rest if isinstance(value, LaunchObject) else ()
        inner = [run.perform(part) for part in [*given, *rest]]
        verdicts = [typed_truth_of(part) for part in inner]
        if stop in verdicts:
            return _told(stop)
        return _told(None if None in verdicts else not stop, *inner)

    return evaluate


def equality(run: LaunchRun, value: Instance) -> Value:
    left, right = run.perform(argument(value, "left")), run.perform(argument(value, "right"))
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


def inequality(run: LaunchRun, value: Instance) -> Value:
    same = equality(run, value)
    return Known("false" if same.value == "true" else "true") if isinstance(same, Known) else same


def if_else(run: LaunchRun, value: Instance) -> Value:
    test = run.perform(argument(value, "condition"))
    verdict = typed_truth_of(test)
    rows = {True: "if_value", False: "else_value"}
    if verdict is not None:
        return run.perform(argument(value, rows[verdict]))
    with run.perhaps():
        return one_of([run.perform(argument(value, name)) for name in rows.values()])


def boolean(run: LaunchRun, value: Instance) -> Value:
    inner = run.perform(argument(value, "value"))
    return _told(typed_truth_of(inner), inner)

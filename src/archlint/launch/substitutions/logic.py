"""Truth: of the texts of conditions, and what launch's boolean substitutions make of others."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import TYPE_CHECKING

from archlint.interpreter.values import Known, Unknown, Value, alternatives, one_of, reason
from archlint.launch.objects import LaunchObject, known_text

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
    texts = map(known_text, alternatives(value))
    return _only({None if text is None else read(text) for text in texts})


def _only(verdicts: set[bool | None]) -> bool | None:
    """What several verdicts agree on."""
    return verdicts.pop() if len(verdicts) == 1 else None


def _as_text(verdict: bool | None, *values: Value) -> Value:
    return Unknown(reason(*values)) if verdict is None else Known(str(verdict).lower())


def negation(run: LaunchRun, value: LaunchObject) -> Value:
    inner = run.perform(value.argument("value"))
    verdict = typed_truth_of(inner)
    return _as_text(None if verdict is None else not verdict, inner)


def connective(stop: bool) -> Callable[[LaunchRun, LaunchObject], Value]:
    def evaluate(run: LaunchRun, value: LaunchObject) -> Value:
        given = [value.arguments[name] for name in ("left", "right") if name in value.arguments]
        inner = [run.perform(part) for part in [*given, *value.rest]]
        verdicts = [typed_truth_of(part) for part in inner]
        if stop in verdicts:
            return _as_text(stop)
        return _as_text(None if None in verdicts else not stop, *inner)

    return evaluate


def equality(run: LaunchRun, value: LaunchObject) -> Value:
    left, right = run.perform(value.argument("left")), run.perform(value.argument("right"))
    verdicts = {
        None if first is None or second is None else _same_text(first, second)
        for first in map(known_text, alternatives(left))
        for second in map(known_text, alternatives(right))
    }
    return _as_text(_only(verdicts), left, right)


def _same_text(first: str, second: str) -> bool:
    """launch compares two truth values, two numbers (nearly), or the texts as they are (``EqualsSubstitution``)."""
    truths = [_in(text.lower(), _TRUE, _FALSE) for text in (first, second)]
    if None not in truths:
        return truths[0] == truths[1]
    try:
        return math.isclose(float(first), float(second))
    except ValueError:
        return first == second


def inequality(run: LaunchRun, value: LaunchObject) -> Value:
    same = equality(run, value)
    return Known("false" if same.value == "true" else "true") if isinstance(same, Known) else same


def if_else(run: LaunchRun, value: LaunchObject) -> Value:
    test = run.perform(value.argument("condition"))
    verdict = typed_truth_of(test)
    rows = {True: "if_value", False: "else_value"}
    if verdict is not None:
        return run.perform(value.argument(rows[verdict]))
    with run.perhaps():
        return one_of([run.perform(value.argument(name)) for name in rows.values()])


def boolean(run: LaunchRun, value: LaunchObject) -> Value:
    inner = run.perform(value.argument("value"))
    return _as_text(typed_truth_of(inner), inner)

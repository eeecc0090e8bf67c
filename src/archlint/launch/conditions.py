"""Conditions: whether an action runs, and where no default decides it, what the two branches are called."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.branches import ArgumentBranch, BranchArm, UnfollowedCondition
from archlint.interpreter.values import (
    BoundMethod,
    ClassValue,
    FunctionValue,
    Instance,
    Known,
    ListValue,
    OneOf,
    Partial,
    Value,
    alternatives,
)
from archlint.launch.functions import ask
from archlint.launch.objects import LaunchObject, argument, kind_of, known_text, made_by_base, own_method
from archlint.launch.shape import Shape
from archlint.launch.shapes import shape_of
from archlint.launch.substitutions.logic import truth_of
from archlint.launch.tables import CLASSES, SUBSTITUTIONS, LaunchClass
from archlint.launch.verdict import ALWAYS, Verdict
from archlint.syntax import facts

if TYPE_CHECKING:
    from archlint.launch.run import LaunchRun


def judge(run: LaunchRun, condition: Value | None) -> Verdict:
    """The verdict on a ``condition=`` argument."""
    if condition is None:
        return ALWAYS
    match condition:
        case OneOf():
            return _one_of_several(run, condition)
        case LaunchObject(kind=LaunchClass.IF_CONDITION | LaunchClass.UNLESS_CONDITION as kind):
            return _truth(run, condition.argument("predicate_expression"), kind == LaunchClass.IF_CONDITION)
        case LaunchObject(
            kind=LaunchClass.LAUNCH_CONFIGURATION_EQUALS | LaunchClass.LAUNCH_CONFIGURATION_NOT_EQUALS as kind
        ):
            return _equality(run, condition, kind == LaunchClass.LAUNCH_CONFIGURATION_EQUALS)
    holds = _asked(run, condition)
    if holds is not None:
        return Verdict(holds)
    base = made_by_base(run, condition)
    if base is not None and base.kind != LaunchClass.CONDITION and _own_predicate(run, condition) is None:
        return judge(run, base)
    return Verdict(None, _branch(run, condition, True))


def _truth(run: LaunchRun, predicate: Value | None, expected: bool) -> Verdict:
    holds = truth_of(run.perform(predicate))
    return Verdict(None, _branch(run, predicate, expected)) if holds is None else Verdict(holds is expected)


def _one_of_several(run: LaunchRun, condition: OneOf) -> Verdict:
    """One of several conditions, None among them: decided where all of them agree."""
    options = [None if option == Known(None) else option for option in condition.values]
    outcomes = {judge(run, option).holds for option in options}
    if len(outcomes) == 1 and None not in outcomes:
        return Verdict(outcomes.pop())
    return Verdict(None, _branch(run, condition, True))


_PREDICATES = ("evaluate", "_predicate_func")
"""What a class that derives from launch's conditions may define of its own."""


def _asked(run: LaunchRun, condition: Value) -> bool | None:
    """What the condition's own code says, for a class of the workspace and for ``Condition(predicate=…)``."""
    launch_condition = made_by_base(run, condition) or condition
    predicate = _own_predicate(run, condition) or argument(launch_condition, "predicate")
    if predicate is None:
        return None
    return ask(run, predicate).truth(run)


def _own_predicate(run: LaunchRun, condition: Value) -> Value | None:
    match condition:
        case Instance(cls=ClassValue()):
            return next((method for name in _PREDICATES if (method := own_method(run, condition, name))), None)
    return None


def _equality(run: LaunchRun, condition: LaunchObject, wanted: bool) -> Verdict:
    name = run.text_of(condition.argument("launch_configuration_name"))
    given = condition.argument("expected_value")
    if name is None:
        return Verdict(None, _branch(run, condition, True))
    run.note_read(name)
    value = run.launch.configurations.get(name)
    if given is None:
        return Verdict((value is None) is wanted)
    expected = run.text_of(given)
    if value is None:
        return Verdict(not wanted)
    if expected is None:
        return Verdict(None, _branch(run, condition, True))
    texts = set(map(known_text, alternatives(value)))
    verdicts = {None if text is None else text == expected for text in texts}
    if len(verdicts) == 1 and None not in verdicts:
        return Verdict(verdicts.pop() is wanted)
    arm = _arm_of_value(run, run.argument_behind(name), expected, wanted)
    run.note_open_test(arm[0], value)
    return Verdict(None, arm)


def _arm_of_value(run: LaunchRun, name: str, text: str, wanted: bool) -> BranchArm:
    """One branch an argument, one arm a value: ``mode:=a`` and ``mode:=b`` exclude each other."""
    if text.lower() in ("true", "false"):
        return _arm_of_truth(run, name, (text.lower() == "true") is wanted)
    run.note_undecided(name, text)
    shown = run.shown(name)
    if wanted:
        return run.label((ArgumentBranch(name), 2 + run.number_of_value(name, text)), f"{shown}:={text}")
    return run.label((ArgumentBranch(name, text), 1), f"{shown} other than {text}")


def _arm_of_truth(run: LaunchRun, name: str, truth: bool) -> BranchArm:
    run.note_undecided(name, "true", "false")
    return run.label((ArgumentBranch(name), int(truth)), f"{run.shown(name)}:={str(truth).lower()}")


def _branch(run: LaunchRun, expression: Value | None, expected: bool) -> BranchArm:
    """The arm of an undecided test.  The same test elsewhere has the same branch."""
    arm = _arm(run, expression, expected)
    if expression is not None:
        run.note_open_test(arm[0], run.perform(expression))
    return arm


def _arm(run: LaunchRun, expression: Value | None, expected: bool) -> BranchArm:
    shape = Shape() if expression is None else shape_of(run, expression)
    if all(map(run.is_open_argument, shape.arguments)):
        known = _known_form(run, shape, expected)
        if known is not None:
            return known
        if shape.is_about_truth:
            for name in shape.arguments:
                run.note_undecided(name, "true", "false")
    arm = (UnfollowedCondition(shape.key), int(expected))
    if not shape.is_known:
        return arm
    return run.label(arm, f"{'' if expected else 'not '}({shape.written(run.shown)})")


def _known_form(run: LaunchRun, shape: Shape, expected: bool) -> BranchArm | None:
    """The arm of a test of one argument: for its truth, or against one value."""
    if shape.truth is not None:
        name, wanted = shape.truth
        return _arm_of_truth(run, name, wanted is expected)
    equality = shape.equality
    if equality is None:
        return None
    return _arm_of_value(run, equality.argument, equality.value, equality.equal is expected)


def mistaken(run: LaunchRun, condition: Value) -> str | None:
    """What a ``condition=`` is that has no ``evaluate`` for launch to call; None for what has one, or may."""
    match condition:
        case FunctionValue(ir=facts.Lambda()):
            return "a lambda"
        case FunctionValue(qualified=name):
            return f"the function '{name}'"
        case BoundMethod() | Partial():
            return "a callable"
        case Known(value=str(text)):
            return f"the text '{text}'"
        case Known(value=value):
            return f"the value {value!r}"
        case ListValue(kind=kind):
            return f"a {kind}"
        case LaunchObject(is_substitution=True, kind=kind):
            return f"a {kind}"
        case Instance(cls=ClassValue() as cls):
            bases = {kind_of(made_by_base(run, condition)), *map(_class_named, cls.external_bases())}
            if bases & {LaunchClass.SUBSTITUTION, *SUBSTITUTIONS} and _own_predicate(run, condition) is None:
                return f"a {cls.qualified}"
    return None


def _class_named(path: str) -> LaunchClass | None:
    return CLASSES.get(path.rpartition(".")[2])


__all__ = ["judge", "mistaken"]

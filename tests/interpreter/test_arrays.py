"""What a message has in an array: nobody knows how many there are, but each is like the others."""

from __future__ import annotations

import pytest

from archlint.interpreter.values import EachValue, Known, Value
from interpreting import interpret

POSE = Known("a pose")
POSES = EachValue(POSE)


@pytest.mark.parametrize(
    "item",
    [
        "poses[0]",
        "poses[outside]",
        "poses[1:][0]",
        "list(poses)[-1]",
        "tuple(poses)[0]",
        "sorted(poses)[0]",
        "list(reversed(poses))[0]",
        "list(filter(None, poses))[0]",
        "max(poses)",
        "next(poses)",
        "next(iter(poses), 'a pose')",
        "next(pose for pose in poses)",
        "list(enumerate(poses))[0][1]",
        "list(zip(poses, outside))[0][0]",
        "list(zip(outside, poses))[3][1]",
    ],
)
def test_an_item_by_whatever_way_it_is_taken(item: str):
    assert known(item) == POSE


@pytest.mark.parametrize(
    "asked", ["len(poses)", "list(map(str, poses))", "any(poses)", "sum(poses, [])", "zip(poses)[0][1]"]
)
def test_how_many_there_are_nobody_knows(asked: str):
    assert known(asked).why_unknown is not None


def test_a_loop_runs_with_one_that_is_like_all():
    interpreted = interpret("def first(poses):\n    for pose in poses:\n        return pose\n    return None\n")
    result = interpreted.evaluate("first(poses)", poses=POSES)
    assert set(result.inner) == {POSE, Known(None)}


def known(expression: str) -> Value:
    return interpret("import outside\n").evaluate(expression, poses=POSES)

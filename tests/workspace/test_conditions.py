"""Conditions in a package.xml; each of these was held against catkin_pkg 1.1.1."""

from __future__ import annotations

import pytest

from archlint.workspace.conditions import is_condition
from archlint.workspace.manifest import MAX_CONDITION


@pytest.mark.parametrize(
    "text",
    [
        "$ROS_VERSION == 2",
        " $ROS_VERSION==2 ",
        "($ROS_VERSION == 2)",
        "(($A == 1)) and ($B != 'a.b' or $C >= \"x y\")",
        "$A == 1 or $B == 2 and $C == 3",
        "jazzy <= $ROS_DISTRO",
        "x" * (MAX_CONDITION + 1),
    ],
)
def test_conditions(text):
    assert is_condition(text)


@pytest.mark.parametrize(
    "text",
    [
        "",
        "$ROS_VERSION",
        "$ROS_VERSION = 2",
        "$ROS_VERSION == 2 and",
        "$ROS_VERSION == 2 && $A == 1",
        "not $A == 1",
        "($A == 1",
        "$A == 22.04",
        "$ == 1",
        "(" * MAX_CONDITION,
    ],
)
def test_no_conditions(text):
    assert not is_condition(text)

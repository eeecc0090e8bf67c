"""Comments of a description that are no YAML; each of these went through xacro 2.1.1 and ``yaml.safe_load``."""

from __future__ import annotations

import pytest

from archlint.syntax.kept_comments import comment_that_is_no_yaml

ROBOT = """<?xml version="1.0"?>
<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
{}
<link name="a"/>
</robot>
"""


@pytest.mark.parametrize(
    ("inner", "told"),
    [
        ("<!-- note: this -->", (3, ":")),
        ("<!-- note:\n this -->", (3, ":")),
        ("<!-- one\n two: three -->", (4, ":")),
        ("<!-- joint #1 -->", (3, "#")),
        ("<xacro:property name='w' value='1'/>\n<!-- note: this -->", (4, ":")),
    ],
)
def test_comments_that_are_no_yaml(inner, told):
    assert comment_that_is_no_yaml(ROBOT.format(inner)) == told


def test_a_comment_above_and_below_the_robot():
    top = '<?xml version="1.0"?>\n<!-- License: MIT -->\n<robot name="r"/>\n'
    assert comment_that_is_no_yaml(top) == (2, ":")


@pytest.mark.parametrize(
    "inner",
    [
        "",
        "<!-- see http://x.y:80/z -->",
        "<!-- joint#1 -->",
        "<!-- note: this -->\n<xacro:property name='w' value='1'/>",  # xacro drops it
        "<xacro:macro name='w' params='p'><!-- note: this --><link name='b'/></xacro:macro>",  # nothing calls that
        "<!-- note: this",
    ],
)
def test_comments_that_are_yaml_or_not_handed_on(inner):
    assert comment_that_is_no_yaml(ROBOT.format(inner)) is None

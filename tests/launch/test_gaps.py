"""What is not followed, and what is told of it."""

from __future__ import annotations

import pytest

from launching import left_out, names


@pytest.mark.parametrize(
    ("path", "reason"),
    [
        (
            "$(find-pkg-share robot)/launch/gone.launch.py",
            "'$(find-pkg-share robot)/launch/gone.launch.py' is not there",
        ),
        ("$(find-pkg-share nav2_bringup)/launch/x.launch.py", "the package 'nav2_bringup' is not in this workspace"),
        ("/opt/x.launch.py", "a path of the machine"),
        ("$(find-pkg-share $(env LIDAR))/launch/x.launch.py", "the environment variable LIDAR"),
    ],
)
def test_an_include_that_is_not_followed_is_told(launches, path, reason):
    launched = launches.xml(f'<group>\n<include file="{path}"/></group>')
    assert left_out(launched) == [("include", reason)]
    assert [gap.place.line for gap in launched.not_followed()] == [3]


def test_of_a_branch_that_is_not_taken_nothing_is_told(launches):
    launched = launches.xml(
        '<group if="false"><include file="$(env FILE)"/><include file="/opt/x.launch.py"/><thing/></group>'
    )
    assert left_out(launched) == []


@pytest.mark.parametrize(
    ("actions", "reason"),
    [
        ("[make_nodes()]", "make_nodes"),
        ("[OpaqueFunction(function=elsewhere.setup)]", "a function that launch calls, and that is not followed"),
        ("[ForLoop(length='3', function=lambda i: [])]", "ForLoop is not an action that is followed"),
        ("elsewhere.nodes()", "elsewhere.nodes() is outside of this workspace"),
    ],
)
def test_an_action_that_is_not_followed_is_told(launches, actions, reason):
    launched = launches.python(actions, "import elsewhere\nfrom launch.actions import ForLoop")
    assert launched.started == []
    [(kind, words)] = left_out(launched)
    assert kind == "launch" and reason in words


def test_an_element_that_is_not_followed_is_told(launches):
    launched = launches.xml(
        '<for_each values="$(env ROBOTS)"><node pkg="robot" exec="talker"/></for_each><log message="x"/>'
    )
    assert left_out(launched) == [("launch", "<for_each> is not an action that is followed")]


def test_a_class_that_derives_from_an_action_is_one(launches):
    before = """\
class Talker(Node):
    def __init__(self, name, **kwargs):
        super().__init__(package='robot', executable='talker', name=name + '_talker', **kwargs)
"""
    launched = launches.python("[Talker('left'), Talker('right', namespace='r')]", before)
    assert names(launched) == ["left_talker", "/r/right_talker"]
    assert left_out(launched) == []


def test_a_class_that_derives_from_an_action_in_two_ways(launches):
    before = """\
class Talker(Node):
    def __init__(self, name):
        if is_wsl():
            super().__init__(package='robot', executable='talker', name=name)
        else:
            super().__init__(package='robot', executable='talker', name=name + '_native')
"""
    launched = launches.python("[Talker('left')]", before)
    assert names(launched) == ["left", "left_native"]
    assert left_out(launched) == [] and all(started.branch_arms for started in launched.started)

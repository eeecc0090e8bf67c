"""LCH015: descriptions of robots whose links and joints are no tree."""

from __future__ import annotations

import pytest

ROBOT = """<robot name="robot" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <link name="base"/>
  <link name="arm"/>
  <joint name="shoulder" type="fixed"><parent link="base"/><child link="arm"/></joint>
  {more}
</robot>
"""
DESCRIBED = (
    '<node pkg="robot" exec="talker"><param name="robot_description" '
    "value=\"$(command 'xacro $(find-pkg-share robot)/urdf/robot.urdf.xacro')\"/></node>"
)
ENDS = "whatever reads 'robot.urdf.xacro' refuses it, and the robot has no description"
HAND = '<link name="hand"/>'
WRIST = '<joint name="wrist" type="fixed"><parent link="arm"/><child link="hand"/></joint>'


def _described(findings, more, **files):
    return findings("LCH015", DESCRIBED, **{"urdf/robot.urdf.xacro": ROBOT.format(more=more)}, **files)


@pytest.mark.parametrize(
    ("more", "message", "help"),
    [
        (
            '<link name="arm"/>',
            "a second link is called 'arm'",
            "give it a name of its own, or remove one of the two",
        ),
        (
            '<joint name="shoulder" type="fixed"><parent link="base"/><child link="arm"/></joint>',
            "a second joint is called 'shoulder'",
            "give it a name of its own, or remove one of the two",
        ),
        (
            WRIST,
            "the joint 'wrist' has 'hand' as its child, and no link is called so",
            'add <link name="hand"/>, or remove the joint',
        ),
        (
            HAND + WRIST.replace("arm", "arms"),
            "the joint 'wrist' has 'arms' as its parent, and no link is called so; did you mean 'arm'?",
            "write 'arm'",
        ),
        (
            HAND,
            "no joint has 'base' or 'hand' as its child, and a robot has one link alone without",
            "add a joint between the two, or remove the one that is not needed",
        ),
        (
            '<xacro:macro name="finger" params="side"><link name="finger"/>'
            '<joint name="${side}" type="fixed"><parent link="arm"/><child link="finger"/></joint></xacro:macro>'
            '<xacro:finger side="left"/><xacro:finger side="right"/>',
            "this makes more than one link 'finger', as the macro around it is called more than once",
            "make the name of a parameter that is another one in each call",
        ),
    ],
)
def test_links_and_joints_that_are_no_tree(findings, more, message, help):
    (told,) = _described(findings, more)
    assert (told.message, told.help) == (f"{message}: {ENDS}", help)
    assert (told.place.file, told.place.line) == ("urdf/robot.urdf.xacro", 5)


@pytest.mark.parametrize(
    "more",
    [
        HAND + WRIST,
        WRIST + HAND,
        # a macro, with what it is given, and what it is not
        '<xacro:macro name="finger" params="side:=left *origin"><link name="${side}"/>'
        '<joint name="to_${side}" type="fixed"><parent link="arm"/><child link="${side}"/>'
        '<xacro:insert_block name="origin"/></joint></xacro:macro>'
        '<xacro:finger><origin xyz="0 0 0"/></xacro:finger><xacro:finger side="right"><origin/></xacro:finger>',
        # properties, of which some are worked out
        '<xacro:property name="number" value="${1 + 1}"/><link name="hand2"/>'
        '<joint name="wrist" type="fixed"><parent link="arm"/><child link="hand${number}"/></joint>',
        # conditions
        f'<xacro:if value="false">{HAND}</xacro:if>',
        f'<xacro:unless value="${{2 > 1}}">{HAND}</xacro:unless>',
        f'<xacro:if value="$(arg hand)">{HAND}</xacro:if>',
        f'<xacro:if value="$(arg x)">{HAND}</xacro:if><xacro:unless value="$(arg x)">{HAND}</xacro:unless>{WRIST}',
        # names with arguments
        '<link name="$(arg tool)"/><joint name="wrist" type="fixed"><parent link="arm"/><child link="hand"/></joint>',
        f'{HAND}<joint name="wrist" type="fixed"><parent link="arm"/><child link="$(arg tool)"/></joint>',
        # what is not followed
        '<xacro:include filename="$(find elsewhere)/hand.xacro"/><xacro:hand/>' + WRIST,
        '<xacro:property name="tools" value="${xacro.load_yaml(\'tools.yaml\')}"/><link name="${tools[0]}"/>' + WRIST,
        # what is no link or joint of the robot
        '<ros2_control name="arm" type="system"><joint name="shoulder"/></ros2_control>',
        '<transmission name="arm"><joint name="shoulder"/></transmission>',
        '<!-- <link name="arm"/> -->',
    ],
)
def test_what_is_a_tree_or_may_be_one(findings, more):
    assert _described(findings, more) == []


def test_what_a_description_includes(findings):
    hand = f'<robot xmlns:xacro="http://www.ros.org/wiki/xacro">{HAND}</robot>'
    files = {"urdf/hand.xacro": hand}
    assert _described(findings, '<xacro:include filename="hand.xacro"/>' + WRIST, **files) == []
    assert _described(findings, '<xacro:include filename="$(find robot)/urdf/hand.xacro"/>' + WRIST, **files) == []
    (told,) = _described(findings, '<xacro:include filename="hand.xacro"/>' + WRIST + HAND, **files)
    assert (told.place.line, [related.place.file for related in told.related]) == (5, ["urdf/hand.xacro"])


def test_all_that_is_wrong_in_one_way_is_one_finding(findings):
    (told,) = _described(findings, WRIST + "\n" + WRIST.replace("wrist", "other").replace("hand", "tool"))
    assert told.place.line == 5 and len(told.related) == 1


def test_a_description_that_no_launch_file_names(findings):
    files = {"urdf/robot.urdf.xacro": ROBOT.format(more=HAND)}
    assert findings("LCH015", '<node pkg="robot" exec="talker"/>', **files) == []
    sdf = '<sdf version="1.6"><model name="robot"><link name="a"/><link name="a"/></model></sdf>'
    assert findings("LCH015", DESCRIBED, **{"urdf/robot.urdf.xacro": sdf}) == []

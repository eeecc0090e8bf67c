"""The virtual joints of an SRDF."""

from __future__ import annotations

import pytest

from archlint.syntax.srdf import VirtualJoint, virtual_joints

JOINT = "<virtual_joint name='fixed' type='fixed' parent_frame='world' child_link='base'/>"


def test_joints_stand_directly_in_the_robot():
    text = f"<robot name='arm'>{JOINT}<group name='arm'><chain base_link='base'/></group></robot>"
    assert virtual_joints(text) == [VirtualJoint("world", "base")]
    assert virtual_joints(f"<robot name='arm'><group>{JOINT}</group></robot>") == []


@pytest.mark.parametrize(
    "text",
    [
        f"<robot xmlns:xacro='http://ros.org/wiki/xacro'>{JOINT}</robot>",
        JOINT.replace("base", "${prefix}base"),
        "<robot",
        "",
        f"<!DOCTYPE robot [<!ENTITY a 'b'>]><robot>{JOINT}</robot>",
    ],
)
def test_a_text_that_xacro_changes_or_that_is_no_xml(text: str):
    assert virtual_joints(text) is None

"""What is read of descriptions of robots."""

from __future__ import annotations

from archlint.syntax.robot_descriptions import read_description

TEXT = """\
<robot xmlns:xacro="http://www.ros.org/wiki/xacro">
  <!-- <joint name="gone"/> -->
  <xacro:macro name="wheel" params="side"><joint name="${side}_wheel"/></xacro:macro>
  <joint name='elbow' type="fixed"><parent link="a"/></joint>
  <gazebo><plugin name="joint"/></gazebo>
  <ros2_control name="robot" type="system">
    <joint name="elbow">
      <command_interface name="position"><param name="min">-1</param></command_interface>
      <state_interface name="position"/>
    </joint>
    <sensor name="imu"/>
    <gpio name="led"><state_interface name="on"/></gpio>
  </ros2_control>
  <transmission name="t"><joint name="wrist"><hardwareInterface>x</hardwareInterface></joint></transmission>
</robot>
"""


def test_joints_and_the_interfaces_of_hardware():
    read = read_description(TEXT)
    assert [row.name for row in read.names] == ["${side}_wheel", "elbow", "imu", "led", "wrist"]
    found = {row.name.name: ([c.name for c in row.commands], [s.name for s in row.states]) for row in read.components}
    assert found == {"elbow": (["position"], ["position"]), "imu": ([], []), "led": ([], ["on"])}


def test_a_name_with_a_hole_may_be_many():
    (wheel,) = (row for row in read_description(TEXT).names if not row.is_literal)
    assert wheel.may_be("left_wheel")
    assert not wheel.may_be("left_wheels")


def test_a_name_of_many_holes_may_be_anything():
    (name,) = read_description(f"<joint name='{'${a}b' * 50}'/>").names
    assert name.may_be("b" * 40 + "c")


def test_what_is_no_description_has_nothing():
    for text in ("", "<robot", "<joint name=>", "<" * 10_000, "plain text <joint"):
        assert read_description(text).names == ()

"""The files that a description of a robot names."""

from __future__ import annotations

from archlint.syntax.description_files import files_named

TEXT = """\
<robot xmlns:xacro="http://www.ros.org/wiki/xacro">
  <!-- <xacro:include filename="$(find gone)/a.xacro"/> -->
  <xacro:include filename="$(find robot)/urdf/wheel.xacro"/>
  <xacro:include filename='parts/arm.xacro'/>
  <xacro:include filename="$(find robot)/urdf/$(arg model).xacro"/>
  <xacro:include filename="${name}.xacro"/>
  <xacro:include filename="extra.xacro" optional="true"/>
  <xacro:include filename="parts/*.xacro"/>
  <xacro:if value="$(arg camera)"><xacro:include filename="camera.xacro"/></xacro:if>
  <xacro:macro name="leg" params="side"><mesh filename="package://robot/meshes/leg.stl"/></xacro:macro>
  <link name="a"><visual><mesh filename="package://robot/meshes/a.stl" scale="1 1 1"/></visual></link>
  <mesh filename="file:///tmp/b.stl"/>
</robot>
"""


def test_what_is_read_for_certain():
    named = [(row.package, row.path, row.span[0], row.included) for row in files_named(TEXT) if not row.perhaps]
    assert named == [
        ("robot", "/urdf/wheel.xacro", 3, True),
        (None, "parts/arm.xacro", 4, True),
        ("robot", "/meshes/a.stl", 11, False),
    ]


def test_what_stands_in_a_condition_that_may_hold():
    assert [(row.path, row.span[0]) for row in files_named(TEXT) if row.perhaps] == [("camera.xacro", 9)]
    never = TEXT.replace('value="$(arg camera)"', 'value="false"')
    assert [row.path for row in files_named(never) if row.perhaps] == []


def test_the_place_of_a_file():
    (row,) = files_named('<robot>\n  <mesh filename="package://a/b.stl"/>\n</robot>\n')
    assert row.span == (2, 9, 2, 37)


def test_what_is_no_description():
    assert [*files_named("<xacro:include")] == [*files_named("package://a <mesh filename=")] == []

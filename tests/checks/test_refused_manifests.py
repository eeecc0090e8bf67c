"""PKG011: package.xml files that colcon refuses."""

from __future__ import annotations

import pytest

from robot_package import CMAKE, SETUP

MAIL = 'email="a@example.org"'


@pytest.fixture
def full() -> str:
    """A whole manifest."""
    more = (
        f"<version>0.1.0</version><description>d</description><maintainer {MAIL}>A</maintainer><license>MIT</license>"
    )
    return "<package format='3'><name>robot</name>" + more + "{}</package>"


def test_all_of_a_file_is_one_finding(findings, full):
    text = full.replace("0.1.0", "1").replace(MAIL, 'email="a"').format("")
    (finding,) = findings("PKG011", **{"package.xml": text, "setup.py": SETUP})
    assert finding.message == (
        "colcon does not take 'robot' for a package of ROS, and builds it as plain Python: '1' is no version of three "
        "numbers"
    )
    assert [row.message for row in finding.related] == ["'a' is no email address"]


def test_with_a_cmake_file_and_without_any(findings, full):
    text = full.replace(MAIL, "").format("<export><build_type>ament_cmake</build_type></export>")
    (finding,) = findings("PKG011", **{"package.xml": text, "CMakeLists.txt": "project(robot)\n"})
    assert "builds it as plain CMake" in finding.message


@pytest.mark.parametrize("files", [{}, {"package.xml": CMAKE}])
def test_manifests_that_are_taken(findings, files):
    assert findings("PKG011", **files) == []


def test_a_package_of_ros_1(findings, full):
    text = full.replace(MAIL, "").format("<buildtool_depend>catkin</buildtool_depend>")
    assert findings("PKG011", **{"package.xml": text}) == []

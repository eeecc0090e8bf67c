"""Branches of the preprocessor that hold no whole statements, or that no build for ROS 2 has."""

from __future__ import annotations

from textwrap import dedent

import pytest

from archlint.syntax.cpp.preprocessor import with_whole_branches


def kept(source: str) -> list[str]:
    """The lines that are left, without those that are blank."""
    text = with_whole_branches(dedent(source).encode()).decode()
    assert text.count("\n") == dedent(source).count("\n")
    return [line.strip() for line in text.splitlines() if line.strip()]


def test_the_first_branch_stays_where_each_opens_a_block() -> None:
    source = """
        #if A && \\
          B
        if (a) {
        #else
        if (b) {
        #endif
        }
    """
    assert kept(source) == ["if (a) {", "}"]


def test_a_block_under_a_condition_of_its_own_stays_whole() -> None:
    source = """
        #ifdef A
        if (a) {
        #endif
        go();
        #ifdef A
        }
        #endif
    """
    assert kept(source) == ["if (a) {", "go();", "}"]


def test_whole_branches_stay_as_they_are() -> None:
    source = '#if A\nf("{"); // (\n#else\ng();\n#endif\n'
    assert with_whole_branches(source.encode()) == source.encode()


def test_what_if_0_leaves_out_is_no_code() -> None:
    source = """
        if (a) { one(); }
        #if 0
        else if (b) { two(); }
        #endif
        else if (c) { three(); }
        #if 0  // the old way
        old();
        #else
        now();
        #endif
    """
    assert kept(source) == ["if (a) { one(); }", "else if (c) { three(); }", "now();"]


@pytest.mark.parametrize(
    ("of_ros1", "of_ros2"),
    [
        ("#ifdef BUILDING_ROS1", "#elif defined BUILDING_ROS2"),
        ("#if defined(ROS1)  // the old one", "#else"),
        ("#ifndef USE_ROS2", "#else"),
        ("#if !defined(ROS_2)", "#elif defined(ROS_2)"),
        ("#if ROS_VERSION == 1", "#elif ROS_VERSION == 2"),
    ],
)
def test_of_two_editions_of_ros_the_second_is_code(of_ros1: str, of_ros2: str) -> None:
    source = f"""
        {of_ros1}
        ros::NodeHandle nh;
        {of_ros2}
        auto node = std::make_shared<rclcpp::Node>("a");
        #endif
        spin();
    """
    assert kept(source) == ['auto node = std::make_shared<rclcpp::Node>("a");', "spin();"]


def test_code_for_ros_2_alone_stays_without_its_condition() -> None:
    source = """
        #ifdef USE_ROS2
        start();
        #endif
        #ifdef USE_ROS1
        begin();
        #endif
    """
    assert kept(source) == ["start();"]


@pytest.mark.parametrize(
    "condition",
    [
        "#ifdef HAVE_CUDA",
        "#ifndef ROS2_DRIVER_HPP_",  # the guard of a header
        "#ifdef ROS1_BRIDGE",  # something that may be built besides
        "#if defined(USE_ROS1) && defined(FAST)",
        "#if ROS_VERSION_MINOR == 2",
        "#if CUDA == 1",
    ],
)
def test_a_condition_of_something_else_stays(condition: str) -> None:
    source = f"{condition}\nf();\n#else\ng();\n#endif\n"
    assert with_whole_branches(source.encode()) == source.encode()


def test_a_macro_that_the_file_defines_stays() -> None:
    source = "#ifndef ROS2\n#define ROS2\nf();\n#endif\n"
    assert with_whole_branches(source.encode()) == source.encode()

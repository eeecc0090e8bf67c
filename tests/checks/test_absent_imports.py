"""API002: names that modules of launch, launch_ros and rclpy do not have, and modules that are none."""

from __future__ import annotations

from textwrap import dedent

import pytest

from checks.judging import Judge

FILE = """
import rclpy
import launch
import launch.actions as actions
from launch import LaunchDescription
from rclpy.node import Node


{line}


def generate_launch_description():
    return LaunchDescription([])
"""


@pytest.mark.parametrize(
    ("line", "message", "help"),
    [
        (
            "from launch import get_logger",
            "launch has no 'get_logger'; it is in launch.logging",
            "write `from launch.logging import get_logger`",
        ),
        (
            "from launch.actions import LaunchConfiguration",
            "launch.actions has no 'LaunchConfiguration'; it is in launch.substitutions",
            "write `from launch.substitutions import LaunchConfiguration`",
        ),
        (
            "from launch.actions import GroupAction, Node as RosNode",
            "launch.actions has no 'Node'; it is in launch_ros.actions",
            "write `from launch_ros.actions import Node`",
        ),
        (
            "from launch.actions import DeclareLaunchArgumnet",
            "launch.actions has no 'DeclareLaunchArgumnet'; did you mean 'DeclareLaunchArgument'?",
            "write `from launch.actions import DeclareLaunchArgument`",
        ),
        (
            "from rclpy import MultiThreadedExecutor",
            "rclpy has no 'MultiThreadedExecutor'; it is in rclpy.executors",
            "write `from rclpy.executors import MultiThreadedExecutor`",
        ),
        (  # which rclpy imports for type checkers only
            "from rclpy import Node as Base",
            "rclpy has no 'Node'; it is in rclpy.node",
            "write `from rclpy.node import Node`",
        ),
        (
            "rclpy.Duration(3)",
            "rclpy has no 'Duration'; it is in rclpy.duration",
            "import rclpy.duration and write rclpy.duration.Duration(seconds=…)",
        ),
        (
            "rclpy.Duration(seconds=3)",
            "rclpy has no 'Duration'; it is in rclpy.duration",
            "import rclpy.duration and write rclpy.duration.Duration",
        ),
        ("from rclpy import loginfo", "rclpy has no 'loginfo'", "use get_logger().info() of a node"),
        (
            "from rclpy import teleport",
            "rclpy has no 'teleport'",
            "remove it, or name what there is: the import fails when the file is loaded",
        ),
        (
            "from launch.substitution import LaunchConfiguration as Argument",
            "launch.substitution has no 'LaunchConfiguration'; it is in launch.substitutions",
            "write `from launch.substitutions import LaunchConfiguration`",
        ),
        (
            "from launch_ros.action import LifecycleNode",
            "there is no module launch_ros.action; did you mean launch_ros.actions?",
            "write `from launch_ros.actions import LifecycleNode`",
        ),
        (
            "from rclpy.executor import teleport",
            "there is no module rclpy.executor; did you mean rclpy.executors?",
            "remove it, or name what there is: the import fails when the file is loaded",
        ),
        (
            "import rclpy.callback_group",
            "there is no module rclpy.callback_group; did you mean rclpy.callback_groups?",
            "write `import rclpy.callback_groups`",
        ),
        (
            "rclpy.spin_until_future_comple(None, None)",
            "rclpy has no 'spin_until_future_comple'; did you mean 'spin_until_future_complete'?",
            "write rclpy.spin_until_future_complete",
        ),
        (
            "group = rclpy.ReentrantCallbackGroup()",
            "rclpy has no 'ReentrantCallbackGroup'; it is in rclpy.callback_groups",
            "import rclpy.callback_groups and write rclpy.callback_groups.ReentrantCallbackGroup",
        ),
        (
            "include = actions.IncludeLaunchDescripton",
            "launch.actions has no 'IncludeLaunchDescripton'; did you mean 'IncludeLaunchDescription'?",
            "write launch.actions.IncludeLaunchDescription",
        ),
        (
            "found = launch.actions.FindPackageShare",
            "launch.actions has no 'FindPackageShare'; it is in launch_ros.substitutions",
            "import launch_ros.substitutions and write launch_ros.substitutions.FindPackageShare",
        ),
    ],
)
def test_what_no_distribution_has(judge: Judge, line: str, message: str, help: str):
    [finding] = judge("API002", FILE.format(line=f"{line}  # here"))
    assert (finding.message, finding.help) == (message, help)


def test_a_class_that_only_an_except_names(judge: Judge):
    """It is looked up once something has been raised."""
    lines = "try:\n    rclpy.init()\nexcept rclpy.ServiceException:  # here\n    pass"
    [finding] = judge("API002", FILE.format(line=lines))
    assert finding.message == "rclpy has no 'ServiceException'"
    assert finding.help == (
        "the except fails, too, as soon as something is raised in its try: name a class that there is"
    )


@pytest.mark.parametrize(
    ("base", "call", "help"),
    [
        ("Node", "rclpy.get_logger().info('slow')", "write self.get_logger()"),
        ("rclpy.node.Node", "now = rclpy.get_clock().now()", "write self.get_clock()"),
        ("Node", "rclpy.get_logger('it').info('')", "import rclpy.logging and write rclpy.logging.get_logger"),
        (
            "object",
            "rclpy.get_logger().info('slow')",
            "import rclpy.logging and write rclpy.logging.get_logger('robot'), with any name",
        ),
    ],
)
def test_a_method_of_the_node_that_is_called_as_a_function(judge: Judge, base: str, call: str, help: str):
    """What rclpy.logging has of the name wants the name of a logger."""
    line = f"class Robot({base}):\n    def warn(self):\n        {call}  # here\n\n\nRobot('it').warn()"
    [finding] = judge("API002", FILE.format(line=line))
    assert finding.help == help


def test_an_import_in_a_function(judge: Judge):
    [finding] = judge("API002", FILE.format(line="def later():\n    from rclpy import teleport  # here"))
    assert finding.help == "remove it, or name what there is: the import fails when that function runs"


def test_a_line_that_runs_only_in_a_program(judge: Judge):
    [finding] = judge("API002", FILE.format(line="if __name__ == '__main__':\n    rclpy.teleport()  # here"))
    assert finding.help == "remove it, or name what there is: the line fails when the file is run as a program"


@pytest.mark.parametrize(
    "line",
    [
        "from launch.actions import DeclareLaunchArgument, OpaqueFunction",
        "from launch.logging import get_logger",
        "from launch_ros.actions.node import Node as RosNode",  # a module below the package
        "from launch_ros.actions import PushRosNamespace, PushROSNamespace",  # one of which is new
        "from launch_ros.actions import node",
        "from launch.conditions import LaunchConfigurationEquals",  # which newer distributions lack
        "from rclpy.qos import qos_profile_sensor_data, QoSPresetProfiles",
        "from rclpy.node import ParameterDescriptor",  # imported there
        "from rclpy.utilities import *",
        "from rclpy.impl.implementation_singleton import rclpy_implementation",
        "from rclpy import _rclpy_pybind11",
        "import rclpy.action",
        "from .launch import get_logger",
        "from launch_pal.arg_utils import LaunchArgumentsBase",
        "rclpy.executors.MultiThreadedExecutor()",
        "launch.substitutions.LaunchConfiguration('x')",
        "rclpy.__version__",
        "rclpy.teleport = print",
        "def run(rclpy):\n    rclpy.teleport()",
        "hasattr(rclpy, 'teleport') and rclpy.teleport()",
        "try:\n    from launch.actions import Node as N\nexcept ImportError:\n    N = None",
        "try:\n    import rclpy.teleport\nexcept Exception:\n    pass",
        "from typing import TYPE_CHECKING\nif TYPE_CHECKING:\n    from rclpy import Duration",
    ],
)
def test_what_some_distribution_has_or_is_not_asked_for(judge: Judge, line: str):
    judge("API002", FILE.format(line=line))


def test_several_lines_that_ask_for_one_name_are_one_finding(judge: Judge):
    [finding] = judge("API002", FILE.format(line="rclpy.teleport()  # here\nrclpy.teleport()"))
    assert finding.message == "rclpy has no 'teleport'; another line of the file does the same"


def test_a_workspace_with_a_module_of_that_name(judge: Judge):
    (judge.folder / "launch").mkdir()
    (judge.folder / "launch" / "__init__.py").write_text("def get_logger(): ...\n", encoding="utf-8")
    judge("API002", dedent(FILE).format(line="from launch import get_logger"))


def test_the_arguments_that_rospy_leaves_are_one_finding_with_the_rest_of_the_file(judge: Judge):
    lines = "arguments = rclpy.myargv()  # here\nrclpy.init_node('echo')"
    [finding] = judge("API002", FILE.format(line=lines))
    assert finding.message == "rclpy has no myargv(); another call in this file is of rospy, too"
    assert finding.help.endswith("; here use rclpy.utilities.remove_ros_args(args=sys.argv)")


def test_methods_of_nodes_that_a_file_without_a_node_asks_rclpy_for(judge: Judge):
    source = """
    import rclpy
    from std_msgs.msg import String


    def main():
        rclpy.init()
        out = rclpy.create_publisher(String, 'out', 10)  # here
        rclpy.create_subscription(String, 'in', out.publish, 10)
        rclpy.spin(None)


    main()
    """
    (finding,) = judge("API002", dedent(source))
    assert finding.message == "rclpy has no 'create_publisher'; another line of the file asks for such"
    assert finding.help == "use create_publisher() of a node"

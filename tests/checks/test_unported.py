"""API002 and API005 about files of ROS 1: one finding for each, and none where nobody starts it."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from archlint.finding import Finding

SETUP = """
from setuptools import setup
setup(name='robot', packages=['robot'], entry_points={'console_scripts': ['talker = robot.talker:main']})
"""
TALKER = """
import rclpy


def main():
    rclpy.init()
    rclpy.spin(rclpy.create_node('talker'))
"""
UNDER_ANOTHER_NAME = """
import rclpy as rospy
from std_msgs.msg import String


def main():
    rospy.init_node('talker')
    pub = rospy.Publisher('said', String, queue_size=1)
    rate = rospy.Rate(10)


if __name__ == '__main__':
    main()
"""
HALF = """
import rclpy
from std_msgs.msg import String

pub = rospy.Publisher('said', String, queue_size=1)


def main():
    rclpy.init_node('talker')
    rospy.spin()
"""
ONE_SLIP = """
import rclpy


def main():
    rclpy.init()
    rclpy.sleep(1.0)


if __name__ == '__main__':
    main()
"""
MODULE = """
from std_msgs.msg import String
import rclpy


def open_valve():
    return rospy.ServiceProxy('open', String)
"""

Said = Callable[..., "list[Finding]"]


@pytest.fixture
def said(findings: Said) -> Said:
    """What is said of the files of a package that installs one program."""

    def run(code: str, files: dict[str, str]) -> list[Finding]:
        return findings(code, **{"setup.py": SETUP, "robot/__init__.py": "", "robot/talker.py": TALKER, **files})

    return run


def test_the_help_is_to_port_the_file_and_each_call_has_its_replacement(said: Said) -> None:
    [finding] = said("API002", {"robot/talker.py": UNDER_ANOTHER_NAME})
    assert finding.message == "rclpy has no init_node(); 2 more calls in this file are of rospy, too"
    assert finding.help == "port the file, which is written for ROS 1; here use create_node()"
    assert [row.message for row in finding.related] == [
        "rclpy has no Publisher(): use create_publisher() of a node",
        "rclpy has no Rate(): use create_rate() of a node",
    ]


def test_what_else_rclpy_refuses_in_such_a_file_is_no_cause_of_its_own(said: Said) -> None:
    more = "    node = rclpy.create_node('talker')\n    node.create_timer(pub, rate, oneshot=True)\n"
    more += "    node.logwarn('late')\n"
    text = UNDER_ANOTHER_NAME.replace("import rclpy as rospy", "import rclpy\nimport rclpy as rospy")
    text = text.replace("    rate = rospy.Rate(10)\n", f"    rate = rospy.Rate(10)\n{more}")
    [finding] = said("API002", {"robot/talker.py": text})
    assert finding.message == "rclpy has no init_node(); 3 more calls in this file are of rospy, too"
    assert said("API001", {"robot/talker.py": text}) == []
    ported = TALKER.replace("    rclpy.spin", f"    pub, rate = None, 1.0\n{more}    rclpy.spin")
    assert [f.message.partition(" fails")[0] for f in said("API001", {"robot/talker.py": ported})] == ["create_timer()"]


def test_one_slip_is_no_file_of_ros_1(said: Said) -> None:
    [finding] = said("API002", {"robot/talker.py": ONE_SLIP})
    assert (finding.message, finding.help) == ("rclpy has no sleep()", "use time.sleep()")


def test_rospy_itself_is_told_with_its_functions(said: Said) -> None:
    [finding] = said("API005", {"robot/talker.py": HALF.replace("rclpy.init_node('talker')", "rclpy.init()")})
    assert finding.help == "port the file to rclpy: it is written for ROS 1"
    assert said("API005", {"robot/talker.py": HALF}) == []  # API002 says so


def test_other_names_of_a_file_of_ros_1_are_for_its_port(said: Said) -> None:
    names = UNDER_ANOTHER_NAME.replace("    rate =", "    name = raw_input()\n    rate =")
    assert said("API005", {"robot/talker.py": names}) == []
    [finding] = said("API005", {"robot/talker.py": TALKER.replace("    rclpy.spin", "    raw_input()\n    rclpy.spin")})
    assert finding.help == "write input"


@pytest.mark.parametrize(
    ("code", "path", "text"),
    [
        ("API002", "tools/talker_1.py", UNDER_ANOTHER_NAME),
        ("API005", "robot/valve.py", MODULE),
    ],
    ids=["a script that is not installed", "a module that nothing imports"],
)
def test_what_no_program_comes_to_is_left_in_ros_1(said: Said, code: str, path: str, text: str) -> None:
    assert said(code, {path: text}) == []


def test_a_module_that_a_program_uses_is_not_left_alone(said: Said) -> None:
    uses = TALKER.replace("import rclpy", "import rclpy\nfrom robot.valve import open_valve")
    assert said("API005", {"robot/valve.py": MODULE, "robot/talker.py": uses}) == []  # nothing calls it yet
    calls = uses.replace("    rclpy.init()\n", "    rclpy.init()\n    open_valve()\n")
    [finding] = said("API005", {"robot/valve.py": MODULE, "robot/talker.py": calls})
    assert finding.place.file.endswith("robot/valve.py")


def test_one_slip_in_a_script_that_a_document_says_to_run_is_told(said: Said) -> None:
    [finding] = said("API002", {"tools/waiter.py": ONE_SLIP, "README.md": "    python3 tools/waiter.py\n"})
    assert finding.message == "rclpy has no sleep(); no installed program uses this file"

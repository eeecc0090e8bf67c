"""API005: names that nothing defines."""

from __future__ import annotations

from collections.abc import Callable
from textwrap import dedent

import pytest

from archlint.config.settings import load
from archlint.engine.pipeline import Request, check
from archlint.finding import Finding, Severity
from checks.judging import Judge
from robot_package import CMAKE, SETUP, manifest, write_files

NODE = """
import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Talker(Node):
    limit = 3
    numbers = [number for number in range(limit)]

    def __init__(self):
        super().__init__('talker')
        self.pub = self.create_publisher(String, 'chatter', 10)
        self.timer = self.create_timer(1.0, self.talk)

    @property
    def topic(self):
        return 'chatter'

    @topic.setter
    def topic(self, name):
        pass

    def talk(self):
{body}

    def helper(self):
        pass


def main():
    rclpy.init()
    rclpy.spin(Talker())


main()
"""


def _node(*lines: str) -> str:
    return NODE.format(body="\n".join(f"        {line}" for line in lines))


@pytest.mark.parametrize(
    ("line", "hint", "help"),
    [
        ("time.sleep(0.1)", "", "write `import time`"),
        ("time.sleep(0.1); time.zone = 1; time[0] = 2", "", "write `import time`"),
        ("rospy.sleep(0.1)", "", "port the file to rclpy: it is written for ROS 1"),
        ("bridge = CvBridge()", "", "write `from cv_bridge import CvBridge`"),
        ("raise TransformException('lost')", "", "write `from tf2_ros import TransformException`"),
        ("print(np.zeros(3))", "", "write `import numpy as np`"),
        ("print(ReentrantCallbackGroup())", "", "write `from rclpy.callback_groups import ReentrantCallbackGroup`"),
        ("self.pub.publish(Sting())", "; did you mean 'String'?", "write String"),
        ("print(Int32())", "", "write `from std_msgs.msg import Int32`"),  # the file has others of that package
        ("print(Imu())", "", "write `from sensor_msgs.msg import Imu`"),
        ("print(GoalStatus())", "", "write `from action_msgs.msg import GoalStatus`"),  # actionlib_msgs is of ROS 1
        ("print(Pose())", "", "write `from geometry_msgs.msg import Pose`"),  # turtlesim's is for those who use it
        (
            "print(JointTrajectory())",
            "",
            "write `from trajectory_msgs.msg import JointTrajectory`",
        ),  # no action is made
        ("name = raw_input()", "; did you mean 'input'?", "write input"),
        ("print(double(self.limit))", "; did you mean 'float'?", "write float"),
        ("self.limit = true", "; did you mean 'True'?", "write True"),
        ("print(limit)", "; did you mean 'self.limit'?", "write self.limit"),
        ("self.limit = limit + 1.0", "; did you mean 'self.limit'?", "write self.limit"),
        ("self.store = store('map.db')", "", "define it, or remove the line"),
        ("print(use_sim_time)", "", "define it, or remove the line"),
        ("print(qos_profile_sensor_data)", "", "write `from rclpy.qos import qos_profile_sensor_data`"),
        ("helper()", "; did you mean 'self.helper'?", "write self.helper"),
        ("print(f'{elapsed:.1f} s')", "", "define it, or remove the line"),
        ("print([part for part in entries])", "", "define it, or remove the line"),
        ("print(lambda name: name + other)", "", "define it, or remove the line"),
    ],
)
def test_a_name_that_nothing_defines(judge: Judge, line: str, hint: str, help: str) -> None:
    (finding,) = judge("API005", _node(f"{line}  # here"))
    assert finding.message.startswith("nothing defines '")
    assert finding.message.endswith(f"': this line fails with a NameError{hint}")
    assert finding.help == help


@pytest.mark.parametrize(
    ("line", "hint", "help"),
    [
        ("count += 1", "", "give count a value before"),
        ("limit += 1", "; did you mean 'self.limit'?", "write self.limit"),
        ("shared += 1", "", "write `global shared` at the beginning of talk()"),
    ],
)
def test_a_local_variable_that_is_only_added_to(judge: Judge, line: str, hint: str, help: str) -> None:
    (finding,) = judge("API005", _node(f"{line}  # here") + "\n\nshared = 0\n")
    assert finding.message.endswith(f"a value in this function: this line fails with an UnboundLocalError{hint}")
    assert finding.help == help


def test_a_variable_that_is_added_to_fails_where_it_is_read_first(judge: Judge) -> None:
    (finding,) = judge("API005", _node("if shared > 3:  # here", "    return", "shared += 1") + "\n\nshared = 0\n")
    assert finding.help == "write `global shared` at the beginning of talk()"


def test_variables_that_one_function_adds_to_are_one_finding(judge: Judge) -> None:
    lines = ("shared += 1  # here", "if other:", "    total += 1")
    (finding,) = judge("API005", _node(*lines) + "\n\nshared = total = other = 0\n")
    assert finding.help == "write `global shared, total` at the beginning of talk()"


def test_a_function_that_assigns_one_variable_of_the_file_and_adds_to_another(judge: Judge) -> None:
    lines = ("if not other:  # here", "    other = True", "total += 1")
    (finding,) = judge("API005", _node(*lines) + "\n\ntotal = other = 0\n")
    assert finding.help == "write `global other, total` at the beginning of talk()"


@pytest.mark.parametrize(
    ("method", "message", "help"),
    [
        (
            "    def move():\n        helper()  # here\n        print(limit)\n",
            "nothing defines 'helper': this line fails with a NameError; move() has no parameter 'self'; another line "
            "of the file does the same",
            "write `def move(self):`, and write self.helper",
        ),
        (
            "    def move():\n        self.helper()  # here\n",
            "nothing defines 'self': this line fails with a NameError; move() has no parameter 'self'",
            "write `def move(self):`",
        ),
        (
            "    def move():\n        limit += 1  # here\n",
            "nothing defines 'limit': this line fails with an UnboundLocalError; move() has no parameter 'self'",
            "write `def move(self):`, and write self.limit",
        ),
        (
            "    @staticmethod\n    def move():\n        print(limit)  # here\n",
            "nothing defines 'limit': this line fails with a NameError",
            "define it, or remove the line",
        ),
        (
            "    def move(other):\n        print(limit)  # here\n",
            "nothing defines 'limit': this line fails with a NameError",
            "define it, or remove the line",
        ),
    ],
)
def test_a_method_without_self(judge: Judge, method: str, message: str, help: str) -> None:
    (finding,) = judge("API005", _node("pass").replace("\n\n\ndef main", f"\n\n{method}\n\ndef main"))
    assert (finding.message.partition(" (")[0], finding.help) == (message, help)


def test_all_reads_in_a_file_are_one_finding(judge: Judge) -> None:
    (finding,) = judge("API005", _node("time.sleep(0.1)  # here") + "\n\ndef wait():\n    time.sleep(1.0)\n")
    assert finding.message.endswith("; another line of the file does the same")
    assert len(finding.related) == 1


def test_what_a_file_does_not_import_is_one_finding(judge: Judge) -> None:
    (finding,) = judge("API005", _node("print(Imu())  # here", "print(Pose())", "print(CvBridge(), Imu())"))
    assert finding.message.endswith("; 2 more names are not defined, either")
    assert finding.help == "write `from sensor_msgs.msg import Imu`"
    assert [row.message for row in finding.related] == [
        "nothing defines 'Pose': write `from geometry_msgs.msg import Pose`",
        "nothing defines 'CvBridge': write `from cv_bridge import CvBridge`",
    ]


@pytest.mark.parametrize("line", ["print(Imu(), limit)", "print(limit, Imu())"])
def test_a_slip_in_a_statement_with_an_import_is_told_with_it(judge: Judge, line: str) -> None:
    (finding,) = judge("API005", _node(f"{line}  # here", "print(Imu())" if line.startswith("print(I") else "pass"))
    assert finding.message.endswith("; another name is not defined, either")


def test_what_a_slip_is_stays_beside_what_is_not_imported(judge: Judge) -> None:
    slip, lacking = judge("API005", _node("print(limit)  # here", "print(Imu())  # here"))
    assert (slip.help, lacking.help) == ("write self.limit", "write `from sensor_msgs.msg import Imu`")


LACKING = """
# from .arms import make_arm, Tray


def arm():
    return make_arm()


def tray():
    return Tray()


def test_arm_made():
    return testArmMade()


print(arm(), tray(), test_arm_made())
"""
ARMS = """
import rclpy

def make_arm():
    return rclpy.create_node('arm')


class Tray:
    pass


def testArmMade():
    pass
"""


def test_names_that_a_module_beside_defines_are_one_finding(findings: Callable[..., list[Finding]]) -> None:
    files = {"robot/start.py": "import rclpy\n" + LACKING, "robot/arms.py": ARMS}
    (finding,) = findings("API005", **files)
    assert (finding.place.file, finding.place.line) == ("robot/start.py", 7)
    assert finding.message.endswith("; 2 more names are not defined, either")
    assert finding.help == "write `from robot.arms import make_arm`"
    assert [row.message for row in finding.related] == [
        "nothing defines 'Tray': write `from robot.arms import Tray`",
        "nothing defines 'testArmMade': write `from robot.arms import testArmMade`",
    ]


@pytest.mark.parametrize(
    ("arms", "more"),
    [
        (ARMS, ARMS),
        ("import robot.start\nfrom robot import start\n" + ARMS, ""),
        (ARMS.replace("make_arm", "other_arm"), ""),
        (ARMS.replace("def make_arm", "class Hidden:\n  def make_arm"), ""),
    ],
    ids=["two modules define it", "it imports this file", "none does", "a method"],
)
def test_a_name_that_no_single_module_beside_offers(
    findings: Callable[..., list[Finding]], arms: str, more: str
) -> None:
    start = "import rclpy\nprint(make_arm())\n"
    files = {"robot/start.py": start, "robot/arms.py": arms, "robot/more.py": more}
    (finding,) = (found for found in findings("API005", **files) if found.place.file.endswith("start.py"))
    assert finding.help == "define it, or remove the line"


STEER = """
import rclpy


{functions}


if __name__ == '__main__':
    {name}()
"""


@pytest.mark.parametrize(
    ("functions", "name", "help"),
    [
        ("def steer(args=None):\n    rclpy.init(args=args)", "main", "define it, or call what the file has: steer()"),
        ("def steer(speed):\n    print(speed)", "main", "define it, or remove the line"),
        ("def maim():\n    rclpy.init()", "main", "write maim"),
        ("def steer(args=None):\n    rclpy.init(args=args)", "read_keys", "write `from robot.keys import read_keys`"),
    ],
    ids=["its own function", "one that needs a value", "almost the same name", "no everyday name"],
)
def test_the_main_of_another_program_is_not_meant(
    findings: Callable[..., list[Finding]], functions: str, name: str, help: str
) -> None:
    keys = "import rclpy\n\n\ndef read_keys():\n    pass\n\n\ndef main():\n    rclpy.init()\n"
    steer = STEER.format(functions=functions, name=name)
    setup = SETUP.replace("robot.talker:main", "robot.steer:steer")
    (told,) = findings("API005", **{"setup.py": setup, "robot/steer.py": steer, "robot/keys.py": keys})
    assert told.message.startswith(f"nothing defines '{name}'")
    assert told.help == help


def test_a_function_that_would_call_itself_for_ever_is_not_meant(judge: Judge) -> None:
    (finding,) = judge("API005", _node("pass") + "\n\ndef test_arm_made():\n    return testArmMade()  # here\n")
    assert finding.help == "define it, or remove the line"


@pytest.mark.parametrize(
    ("read", "help"),
    [
        ("print(Move.Request())", "write `from robot.srv import Move`"),
        ("print(Move())", "write `from robot.msg import Move`"),
        ("print(Stop.Request())", "define it, or remove the line"),
    ],
)
def test_the_kind_of_interface_that_is_used(findings: Callable[..., list[Finding]], read: str, help: str) -> None:
    interfaces = '"msg/Move.msg" "msg/Stop.msg" "srv/Move.srv"'
    files = {
        "msg/Move.msg": "uint8 id\n",
        "msg/Stop.msg": "uint8 id\n",
        "srv/Move.srv": "---\n",
        "robot/mover.py": "from robot.msg import Move\n\nprint(Move())\n",
        "robot/talker.py": _node(read),
        "package.xml": CMAKE,
        "CMakeLists.txt": f"rosidl_generate_interfaces(robot {interfaces})\n",
    }
    (finding,) = findings("API005", **files)
    assert finding.help == help


def test_an_interface_of_the_workspace_that_is_not_imported(findings: Callable[..., list[Finding]]) -> None:
    files = {
        "msg/ServoState.msg": "uint8 id\n",
        "robot/talker.py": _node("print(ServoState())"),
        "package.xml": CMAKE,
        "CMakeLists.txt": 'rosidl_generate_interfaces(robot "msg/ServoState.msg")\n',
    }
    (finding,) = findings("API005", **files)
    assert finding.help == "write `from robot.msg import ServoState`"


def test_no_interface_of_a_package_that_generates_none(findings: Callable[..., list[Finding]]) -> None:
    files = {"msg/ServoState.msg": "uint8 id\n", "robot/talker.py": _node("print(ServoState())")}
    (finding,) = findings("API005", **files)
    assert finding.help == "define it, or remove the line"


def test_what_annotations_take_from_typing(judge: Judge) -> None:
    (finding,) = judge("API005", "import rclpy\n\n\ndef angles() -> List[float]:  # here\n    return []\n")
    assert finding.help == "write `from typing import List`"


def test_the_names_of_one_statement_are_one_finding(judge: Judge) -> None:
    (finding,) = judge("API005", _node("print(elapsed, entries, others)  # here"))
    assert (
        finding.message
        == "nothing defines 'elapsed': this line fails with a NameError; 2 more names are not defined, either"
    )
    assert [one.message.partition(":")[0] for one in finding.related] == [
        "nothing defines 'entries'",
        "nothing defines 'others'",
    ]


@pytest.mark.parametrize(
    "lines",
    [
        ("return True", "try:", "    print(result)", "except OSError:", "    pass"),
        ("raise OSError", "print(result)"),
        ("for number in range(3):", "    continue", "    print(result)"),
        ("if self.limit:", "    return 1", "else:", "    return 2", "print(result)"),
    ],
)
def test_a_line_that_nothing_leads_to_does_not_fail(judge: Judge, lines: tuple[str, ...]) -> None:
    judge("API005", _node(*lines))


@pytest.mark.parametrize(
    "lines",
    [
        ("if self.limit:", "    return True", "print(result)  # here"),
        ("for number in range(3):", "    break", "print(result)  # here"),
        ("return result  # here",),
        ("def inner():", "    return 1", "print(result, inner())  # here"),
        ("if self.limit:", "    return 1", "    print(result)", "print(result)  # here"),
    ],
)
def test_a_line_beside_a_return_fails(judge: Judge, lines: tuple[str, ...]) -> None:
    judge("API005", _node(*lines))


def test_what_other_files_write(judge: Judge) -> None:
    other = _node("pass").replace("import rclpy\n", "import rclpy\nfrom math import hypot\n", 1)
    (finding,) = judge("API005", _node("print(hypot(1, 2))  # here"), other)
    assert finding.help == "write `from math import hypot`"


@pytest.mark.parametrize(
    "lines",
    [
        ("later()",),
        ("for number in range(3):", "    print(number)"),
        ("with open(__file__) as file:", "    print(file)"),
        ("try:", "    pass", "except OSError as error:", "    print(error)"),
        ("try:", "    unicode", "except NameError:", "    pass"),
        ("if (count := len('ab')):", "    print(count)"),
        ("match 'ab':", "    case [first, *rest]:", "        print(first, rest)"),
        ("message: Missing = None", "print(message)"),
        ("print({key: value for key, value in {}.items() if key})",),
        ("print((lambda a, *b, c=1, **d: (a, b, c, d)))",),
        ("global shared", "shared += 1"),
        ("count = 0", "count += 1"),
        ("for count in range(3):", "    count += 1"),
        ("def inner(given=1):", "    nonlocal kept", "    kept = given", "kept = 0", "inner()"),
        ("import os.path as path", "print(path, __class__)"),
        ("print(sorted([], key=len), ExceptionGroup)",),
    ],
)
def test_names_that_are_defined(judge: Judge, lines: tuple[str, ...]) -> None:
    judge("API005", _node(*lines) + "\n\ndef later():\n    print(shared)\n\n\nshared = 2\n")


def test_a_function_of_ros_1_is_told_once(judge: Judge) -> None:
    ported = "print(tf.transformations)\n        print(rospy.Time(0))  # here"
    judge("API005", _node(ported))
    helper = "\n\ndef helper():\n    print(tf.transformations)  # here\n"
    judge("API005", _node("print(rospy.Time(0))  # here") + helper)


@pytest.mark.parametrize(
    "start",
    [
        "from unknown_library import *",
        "import rospy",
        "exec('value = 1')",
        "globals()['value'] = 1",
        "if 'other' in globals():\n    globals().update(value=1)",
        "if 'value' not in globals():\n    print('value is not here')",
        "from .beside import *",
    ],
)
def test_files_in_which_anything_may_be_defined(judge: Judge, start: str) -> None:
    judge("API005", f"{start}\n{_node('print(value)')}")


def test_a_file_that_asks_for_another_name(judge: Judge) -> None:
    judge("API005", "if 'camera' in globals():\n    print(camera)\n" + _node("print(value)  # here"))


def test_star_imports_that_are_known(judge: Judge) -> None:
    helpers = "import math\n\nvalue = 3\n\n\ndef scale():\n    return value\n"
    star = "from node1 import *\nfrom std_msgs.msg import *\n"
    judge("API005", star + _node("print(value, scale(), math, Int32())", "print(time)  # here"), helpers)


INTERFACES = {
    "parts/package.xml": """<package format="3"><name>parts</name><version>0.1.0</version><description>x</description>
<maintainer email="a@example.org">A</maintainer><license>MIT</license><buildtool_depend>ament_cmake</buildtool_depend>
<build_depend>rosidl_default_generators</build_depend><member_of_group>rosidl_interface_packages</member_of_group>
<export><build_type>ament_cmake</build_type></export></package>""",
    "parts/CMakeLists.txt": "project(parts)\nfind_package(rosidl_default_generators REQUIRED)\n"
    'rosidl_generate_interfaces(parts "msg/TaskRequest.msg" "srv/Start.srv")\nament_package()\n',
    "parts/msg/TaskRequest.msg": "int32 id\n",
    "parts/srv/Start.srv": "---\n",
}


@pytest.mark.parametrize(
    ("star", "name", "told"),
    [
        ("from parts.msg import *", "Task", True),
        ("from parts.msg import *", "TaskRequest", False),
        ("from parts.msg import *", "Start", True),
        ("from parts.srv import *", "Start", False),
        ("from parts.msg import *\nfrom parts.srv import *", "Start", False),
        ("from parts.msg import *\nfrom std_msgs.msg import *", "Task", False),  # who knows what that will have
        ("from other_parts.msg import *", "Task", False),
        ("from parts.msg import *\nfrom robot.more import *", "Task", False),
    ],
)
def test_a_star_import_of_interfaces_of_the_workspace(tmp_path, monkeypatch, star: str, name: str, told: bool) -> None:
    more = "import rclpy\nfrom somewhere import *\n"
    package = {
        "package.xml": manifest(),
        "setup.py": SETUP,
        "robot/__init__.py": "",
        "robot/talker.py": f"{star}\n{_node(f'print({name}())')}",
    }
    files = {f"robot/{file}": text for file, text in package.items()} | {"robot/robot/more.py": more}
    write_files(tmp_path, {"archlint.toml": 'select = ["API005"]', **INTERFACES, **files})
    monkeypatch.chdir(tmp_path)
    rows = check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings
    assert [f"'{name}'" in row.message for row in rows] == [True] * told


@pytest.mark.parametrize(
    ("names", "help"),
    [
        ("FRONT_CAMERA_TOPIC, REAR_CAMERA_TOPIC", "write FRONT_CAMERA_TOPIC"),
        ("FRONT_CAMERA_TOPIC, FRONT_LIDAR_TOPIC", "define it, or remove the line"),  # either may be meant
        ("AFFRONT_TOPIC", "define it, or remove the line"),
    ],
)
def test_an_import_that_nothing_uses_may_be_what_was_meant(judge: Judge, names: str, help: str) -> None:
    topics = "".join(f"{name} = 'topic'\n" for name in names.split(", "))
    lines = f"from node1 import {names}\n" + _node("self.create_subscription(String, Front, print, 10)  # here")
    (finding,) = judge("API005", lines, topics)
    assert finding.help == help


@pytest.mark.parametrize(("line", "told"), [("self.helper()", 1), ("pass", 0)])
def test_a_method_of_a_program_that_nothing_calls(findings: Callable[..., list[Finding]], line: str, told: int) -> None:
    node = _node(line).replace("def helper(self):\n        pass", "def helper(self):\n        time.sleep(1)")
    assert len(findings("API005", **{"robot/talker.py": node})) == told


LAUNCH = """
from launch import LaunchDescription
from launch.actions import OpaqueFunction
from launch_ros.actions import Node


def talker(context):
    return [Node(package='robot', executable='talker', namespace=side)]


def spare():
    return Node(package='robot', executable='talker', namespace=elsewhere)


def generate_launch_description():
    return LaunchDescription([OpaqueFunction(function=talker)])
"""


def test_a_function_that_a_launch_file_passes_on(findings: Callable[..., list[Finding]]) -> None:
    """What no line of the file names, spare(), is never run."""
    (finding,) = findings("API005", **{"launch/robot.launch.py": LAUNCH})
    assert (finding.place.file, finding.place.line) == ("launch/robot.launch.py", 8)
    assert finding.message == "nothing defines 'side': this line fails with a NameError"


def test_a_name_that_keeps_a_launch_file_from_being_read_is_for_lch008(
    findings: Callable[..., list[Finding]],
) -> None:
    launch = LAUNCH.replace("function=talker", "function=talkers")
    assert not findings("API005", **{"launch/robot.launch.py": launch})
    assert [f.place.line for f in findings("LCH008", **{"launch/robot.launch.py": launch})] == [16]


def test_the_names_of_a_statement_that_stops_a_launch_are_all_for_lch008(
    findings: Callable[..., list[Finding]],
) -> None:
    lines = "group = GroupAction([PushRosNamespace(robot)])\n    return LaunchDescription"
    files = {"launch/robot.launch.py": LAUNCH.replace("return LaunchDescription", lines).replace("side", "'front'")}
    assert not findings("API005", **files)
    (told,) = findings("LCH008", **files)
    assert told.message.endswith("before it starts anything; nor are PushRosNamespace, robot")
    assert told.help == "write `from launch.actions import GroupAction`"
    assert [row.message for row in told.related] == [
        "'PushRosNamespace' is not defined, either",
        "'robot' is not defined, either",
    ]


def test_names_that_a_launch_file_has(findings: Callable[..., list[Finding]]) -> None:
    launch = LAUNCH.replace("\n\ndef talker", "\n\nside = 'front'\n\n\ndef talker")
    assert not findings("API005", **{"launch/robot.launch.py": launch})
    assert not findings("API005", **{"launch/robot.launch.py": f"from launch import *\n{LAUNCH}"})


def test_a_launch_file_that_python_refuses_to_compile(findings: Callable[..., list[Finding]]) -> None:
    told = findings("API005", **{"launch/robot.launch.py": f"{LAUNCH}\nreturn side\n"})
    assert [finding.code for finding in told] == ["LNT002"]


@pytest.mark.parametrize(("name", "near"), [("node", ""), ("Noed", "Node"), ("noed", "")])
def test_an_object_is_no_slip_for_its_class(judge: Judge, name: str, near: str) -> None:
    (finding,) = judge("API005", _node(f"{name}.destroy_node()  # here"))
    assert finding.message.endswith(f"; did you mean '{near}'?" if near else "a NameError")


PROGRAM = _node("print(math.hypot(3.0, 4.0))").removesuffix("\n\nmain()\n") + "\n"


def test_a_console_script_with_the_name_of_a_launch_file(findings: Callable[..., list[Finding]]) -> None:
    """`ros2 launch` offers the file by its name, and what runs it is the console script."""
    setup = SETUP.replace("robot.talker:main", "robot.talker_for_launch:main")
    (told,) = findings("API005", **{"setup.py": setup, "robot/talker_for_launch.py": PROGRAM})
    assert told.place.file == "robot/talker_for_launch.py"
    assert told.message.startswith("nothing defines 'math'")


def test_a_file_with_the_name_of_a_launch_file_that_nothing_runs(findings: Callable[..., list[Finding]]) -> None:
    assert not findings("API005", **{"robot/talker_for_launch.py": PROGRAM})


def test_a_launch_file_beside_the_programs(findings: Callable[..., list[Finding]]) -> None:
    """What a console script names describes a launch, too: it is read as a launch file, in which nothing calls this."""
    setup = SETUP.replace("robot.talker:main", "robot.robot_launch:main")
    launch = (
        "from launch import LaunchDescription\n\n\ndef generate_launch_description():\n    return LaunchDescription([])"
    )
    idle = "\n\n\ndef main():\n    pass\n\n\ndef idle():\n    print(math.pi)\n"
    assert not findings("API005", **{"setup.py": setup, "robot/robot_launch.py": launch + idle})


@pytest.mark.parametrize(
    ("line", "help"),
    [("from glob import glob\n", "write `from glob import glob`"), ("from setuptools import setup\n", "")],
)
def test_a_name_that_a_setup_file_does_not_import(findings: Callable[..., list[Finding]], line: str, help: str) -> None:
    (told,) = findings("API005", **{"setup.py": SETUP.replace(line, "")})
    assert (told.place.file, told.severity) == ("setup.py", Severity.ERROR)
    assert told.help == help or not help


def test_a_setup_file_that_nothing_runs(findings: Callable[..., list[Finding]]) -> None:
    files = {"package.xml": CMAKE, "CMakeLists.txt": "project(robot)\nament_package()\n"}
    assert not findings("API005", **files, **{"setup.py": SETUP.replace("from glob import glob\n", "")})


PASTED = """
import rclpy


def __init__(self):
    super().__init__('picker')
    self.bridge = CvBridge()
    self.create_subscription(Image, 'image', print, 10)
"""


def test_a_method_that_stands_outside_of_every_class(judge: Judge) -> None:
    (finding,) = judge("API005", PASTED.replace("__('picker')", "__('picker')  # here"))
    assert finding.message == "super() fails here with a RuntimeError: __init__() stands outside of every class"
    assert finding.help == "move __init__() into the class that it was written for, or delete it"


@pytest.mark.parametrize(
    "source",
    [
        """
        def make(base):
            class Made(base):
                def __init__(self):
                    super().__init__()
            return Made
        """,
        """
        class Made(dict):
            def __init__(self):
                super().__init__()
        """,
        """
        def look(self):
            return super(dict, self).keys()
        """,
    ],
)
def test_a_super_that_has_a_class(judge: Judge, source: str) -> None:
    assert not judge("API005", "import rclpy\n" + dedent(source))


def test_gaps_of_an_exercise_are_there_to_be_filled_in(judge: Judge):
    judge("API005", _node("self.pub.publish(____)", "self.limit = ________(self.limit)"))


def test_what_a_comment_asks_others_to_write(judge: Judge):
    judge("API005", _node("# TODO: stop if the wall is near", "", "", "", "self.pub.publish(command)"))
    judge("API005", _node("# TODO: make a Wall here", "# that is called at_wall", "self.pub.publish(at_wall)"))
    judge("API005", _node("# your code: set speed", "self.pub.publish(speed)", "print(speed)"))


@pytest.mark.parametrize(
    "lines",
    [
        ("# TODO: stop if the wall is near", "self.pub.publish(command)  # here"),
        ("# TODO: stop if the wall is near", "", "", "self.limit = 1.0", "self.pub.publish(command)  # here"),
        ("# send the command", "", "", "self.pub.publish(command)  # here"),
        ("# leer todo el command", "", "", "self.pub.publish(command)  # here"),
        ("# TODO: make it faster", "# with node.command", "self.pub.publish(command)  # here"),
    ],
)
def test_a_comment_that_leaves_no_room_for_others(judge: Judge, lines: tuple[str, ...]):
    judge("API005", _node(*lines))


def test_an_except_with_the_name_of_what_it_catches(judge: Judge):
    (told,) = judge("API005", _node("try:", "    self.publish()", "except e:  # here", "    print(e)"))
    assert told.help == "write `except Exception as e:`"
    (of_class,) = judge("API005", _node("try:", "    self.publish()", "except Failure:  # here", "    pass"))
    assert of_class.help == "define it, or remove the line"
    (of_word,) = judge("API005", _node("try:", "    self.publish()", "except failure:  # here", "    pass"))
    assert of_word.help == "name the class of the exception that is meant"


@pytest.mark.parametrize(
    ("imported", "meant"), [("import socket", "socket.timeout"), ("from socket import socket", "TimeoutError")]
)
def test_an_except_for_a_timeout(judge: Judge, imported: str, meant: str):
    source = f"{imported}{_node('try:', '    self.publish()', 'except timeout:  # here', '    pass')}"
    (told,) = judge("API005", source)
    assert told.help == f"write `except {meant}:`"


@pytest.mark.parametrize("call", ["destroy_node()", "get_logger().info('done')"])
def test_a_node_that_is_ended_by_another_name_than_it_is_spun_by(judge: Judge, call: str):
    spins = f"node = Talker()\n    try:\n        rclpy.spin(node)\n    finally:\n        talker.{call}  # here"
    (told,) = judge("API005", _node("pass").replace("rclpy.spin(Talker())", spins))
    assert told.help == "write node"


@pytest.mark.parametrize("spins", ["rclpy.spin(Imu())  # here", "node = Imu()  # here\n    rclpy.spin(node)"])
def test_a_message_is_no_node_to_spin(judge: Judge, spins: str):
    (told,) = judge("API005", _node("pass").replace("rclpy.spin(Talker())", spins))
    assert told.help == "write Talker"
    others = "class Imu2(Node):\n    pass\n\n\ndef main"
    (told,) = judge("API005", _node("pass").replace("rclpy.spin(Talker())", spins).replace("def main", others))
    assert told.help == "define it, or remove the line"


def test_what_stands_behind_the_line_at_which_loading_ends(judge: Judge):
    source = """
        import rclpy

        first = folder + 'a'  # here
        first.append(description)

        def later():
            print(rate)  # here
        """
    told = judge("API005", source)
    assert [(row.place.line, len(row.related)) for row in told] == [(3, 1), (7, 0)]


OF_ROS_1 = """
import os
import rclpy
from rclpy.node import Node
from arm_msgs.action import Reach
from arm_msgs.msg import Tick
from arm_msgs.srv import Park


class Arm(Node):
    def __init__(self):
        super().__init__('arm')
        {line}


def main():
    rclpy.init()
    rclpy.spin(Arm())
"""
OTHER_OF_ROS_1 = "from arm_msgs.msg import tick, tock\n"


@pytest.mark.parametrize(
    ("line", "help"),
    [
        ("self.pub = self.create_publisher(tick, 'ticks', 3)", "write Tick"),
        ("self.pub = self.create_publisher(tock, 'ticks', 3)", "define it, or remove the line"),
        ("print(ReachResult())", "write Reach.Result"),
        ("print(ParkRequest())", "write Park.Request"),
    ],
)
def test_names_of_ros_1(judge: Judge, line: str, help: str) -> None:
    """An import that fails is no advice."""
    (finding,) = judge("API005", OF_ROS_1.replace("{line}", f"{line}  # here"), OTHER_OF_ROS_1)
    assert finding.help == help


@pytest.mark.parametrize("test", ["IN_COLAB or IN_KAGGLE", "self.is_notebook()"])
def test_what_only_a_notebook_defines(judge: Judge, test: str) -> None:
    line = (
        "from robot.where import IN_COLAB, IN_KAGGLE\n        elapsed = passed = 1\n"
        f"        if {test}:\n            display(elapsed)\n        else:\n            display(passed)  # here"
    )
    judge("API005", OF_ROS_1.replace("{line}", line))


@pytest.mark.parametrize("test", ["os.name == 'nt'", "sys.platform == 'win32'"])
def test_what_runs_on_windows_alone(judge: Judge, test: str) -> None:
    line = (
        f"import sys\n        if {test}:\n            print(elapsed)\n        else:\n            print(passed)  # here"
    )
    judge("API005", OF_ROS_1.replace("{line}", line))


CALLBACK = """
import rclpy
from rclpy.node import Node


class Talker(Node):
    limit = 3

    def __init__(self):
        super().__init__('talker')
        self.sub = self.create_subscription(String, 'chatter', self.hear, 10)

    {definition}
        print(message)


class Other:
    pass


rclpy.init()
rclpy.spin(Talker())
"""
IMPORTED = CALLBACK.replace("import rclpy\n", "import rclpy\nfrom std_msgs.msg import String\n", 1)


@pytest.mark.parametrize(
    ("definition", "name"),
    [
        ("def hear(self, message: Strin):", "Strin"),
        ("def hear(self, message: list[Strin]):", "Strin"),
        ("def hear(self, message, *rest: Missing):", "Missing"),
        ("def hear(self, message) -> Missing:", "Missing"),
    ],
)
def test_a_name_in_an_annotation_of_a_function(judge: Judge, definition: str, name: str) -> None:
    (finding,) = judge("API005", IMPORTED.format(definition=f"{definition}  # here"))
    assert finding.message.startswith(f"nothing defines '{name}': this line fails with a NameError")


def test_a_name_in_an_annotation_and_in_the_code_is_one_finding(judge: Judge) -> None:
    text = CALLBACK.format(definition="def hear(self, message: String):")
    (finding,) = judge("API005", text.replace("self.hear, 10)", "self.hear, 10)  # here"))
    assert finding.help == "write `from std_msgs.msg import String`"


@pytest.mark.parametrize(
    "definition",
    [
        "def hear(self, message: String) -> None:",
        "def hear(self, message: 'Missing') -> 'Missing':",  # a text, which nothing evaluates
        "def hear(self, message: Other) -> Talker:",  # bound in the file, wherever
        "def hear(self, message, most: range(limit) = 3):",  # the body of the class has it
        "def hear[Item](self, message: Item) -> Item:",
    ],
)
def test_annotations_that_name_nothing_unknown(judge: Judge, definition: str) -> None:
    assert judge("API005", IMPORTED.format(definition=definition)) == []


def test_annotations_that_nothing_evaluates(judge: Judge, findings: Callable[..., list[Finding]]) -> None:
    text = IMPORTED.format(definition="def hear(self, message: Missing):")
    assert judge("API005", f"from __future__ import annotations\n{text}") == []
    files = {"robot/talker.py": text.lstrip(), "CMakeLists.txt": CMAKE}
    assert findings("API005", **files, Dockerfile="FROM ros:lyrical\n") == []
    assert len(findings("API005", **files, Dockerfile="FROM ros:jazzy\n")) == 1


@pytest.mark.parametrize("comment", ["noqa", "NOQA", "noqa: F821", "noqa: E501, F821"])
def test_a_line_that_its_author_has_looked_at(judge: Judge, comment: str) -> None:
    body = f"        self.get_logger().info(session)  # {comment}"
    assert judge("API005", NODE.format(body=body)) == []


@pytest.mark.parametrize("comment", ["# noqa: E501", "# noqa: F401", "# noqas are rare"])
def test_a_comment_about_something_else(judge: Judge, comment: str) -> None:
    body = f"        self.get_logger().info(session)  {comment}  # here"
    assert len(judge("API005", NODE.format(body=body))) == 1


@pytest.mark.parametrize(
    ("lines", "help"),
    [
        (("word = Twist()", "self.pub.publish(word)"), "define it, or remove the line"),
        (("self.pub.publish(Twist())",), "define it, or remove the line"),
        (("word = Twist()", "self.other.publish(word)"), "write `from geometry_msgs.msg import Twist`"),
        (("word = Twist()", "print(word)"), "write `from geometry_msgs.msg import Twist`"),
    ],
    ids=["from a variable", "at once", "a publisher from elsewhere", "not published"],
)
def test_a_message_for_a_publisher_of_another_type_is_no_missing_import(
    judge: Judge, lines: tuple[str, ...], help: str
):
    marked = "\n".join(f"{row}  # here" if "Twist()" in row else row for row in _node(*lines).splitlines())
    (finding,) = judge("API005", marked)
    assert finding.message == "nothing defines 'Twist': this line fails with a NameError"
    assert finding.help == help

"""Rules over launch files, parameters and packages: what they must not say, and how they say it."""

from __future__ import annotations

from pathlib import Path

import pytest

from archlint.config.settings import load
from archlint.engine.pipeline import Request, check
from archlint.finding import Finding, Severity
from archlint.suggestions import did_you_mean, distance, nearest

MANIFEST = """<package format="3"><name>{name}</name>
<exec_depend>rclpy</exec_depend>
<exec_depend>std_msgs</exec_depend>{more}
<export><build_type>{type}</build_type></export></package>
"""
SETUP = """\
from glob import glob
from setuptools import setup
setup(
    name='robot',
    data_files=[('share/robot/launch', glob('launch/*')), ('share/robot/config', glob('config/*'))],
    entry_points={'console_scripts': ['talker = robot.talker:main']},
)
"""
TALKER = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String

class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.declare_parameter('rate', 1.0)
        self.create_publisher(String, 'chatter', 10)

def main():
    rclpy.init()
    rclpy.spin(Talker())
"""


@pytest.fixture
def findings(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.chdir(tmp_path)

    def run(code: str, launch: str = "", **files: str) -> list[Finding]:
        texts = {
            "archlint.toml": f'select = ["{code}"]',
            "package.xml": MANIFEST.format(name="robot", type="ament_python", more=""),
            "setup.py": SETUP,
            "robot/talker.py": TALKER,
            "launch/it.launch.xml": f"<launch>{launch}</launch>",
            **files,
        }
        for name, text in texts.items():
            path = tmp_path / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
        return check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings

    return run


def node(inner: str = "", **attributes: str) -> str:
    given = {"pkg": "robot", "exec": "talker"} | attributes
    return f"<node {' '.join(f'{k}={v!r}' for k, v in given.items())}>{inner}</node>"


# ------------------------------------------------------------------------------------------------------ near


@pytest.mark.parametrize(
    ("one", "other", "edits"),
    [("talker", "talker", 0), ("taker", "talker", 1), ("tlaker", "talker", 1), ("a", "bcd", 3)],
)
def test_distance(one, other, edits):
    assert distance(one, other, 5) == edits


def test_the_nearest_word_is_near():
    assert nearest("taker", ["listener", "talker"]) == "talker"
    assert did_you_mean("x", ["talker"]) == ""


@pytest.mark.parametrize(
    ("word", "meant"),
    [("cmd_topc", "cmd_topic"), ("sub_ids", "sub_id"), ("maxspeed", "max_speed"), ("Camra", "camera")],
)
def test_a_word_that_is_misspelt_in_a_name(word: str, meant: str):
    assert nearest(word, [meant]) == meant


@pytest.mark.parametrize(
    ("word", "other"),
    [
        ("cmd_topic", "imu_topic"),
        ("publish_odom", "publish_rate"),
        ("motor_1", "motor_2"),
        ("linear_x", "linear_y"),
        ("kp", "kd"),
        ("input_gain", "output_gain"),
    ],
)
def test_two_names_of_which_neither_is_misspelt(word: str, other: str):
    assert nearest(word, [other]) is None


# ------------------------------------------------------------------------------------------------------- LCH


CMAKE = MANIFEST.format(name="robot", type="ament_cmake", more="")
SCRIPTS = "install(PROGRAMS scripts/drive.py DESTINATION lib/robot)\n"
TESTS = """if(BUILD_TESTING)
  foreach(path test/test_a.py)
    ament_add_pytest_test(${path} ${path})
  endforeach()
endif()
"""


@pytest.mark.parametrize(
    ("cmake", "found"),
    [
        ("project(robot)\nadd_subdirectory(gone)\n" + SCRIPTS, 0),
        ("project(robot)\nmake_node(driver)\n" + SCRIPTS, 0),  # an unknown command may build it
        ("project(robot)\nforeach(n ${NODES})\nadd_executable(${n})\nendforeach()\n" + SCRIPTS, 0),
        ("project(robot)\nforeach(n driver arm)\nadd_executable(${n})\nendforeach()\n" + SCRIPTS, 0),
        ("project(robot)\nadd_subdirectory(src)\n" + SCRIPTS, 0),
        ("project(robot)\ninstall(DIRECTORY nodes/ DESTINATION lib/robot)\n" + SCRIPTS, 0),
        ("project(robot)\n" + SCRIPTS + TESTS, 1),
        ("project(driver)\n" + SCRIPTS, 1),  # a project is no executable
        ("project(robot)\ninstall(DIRECTORY scripts/ DESTINATION lib/robot)\n", 1),
        ("project(robot)\nament_python_install_package(robot SCRIPTS_DESTINATION lib/robot)\n" + SCRIPTS, 1),
    ],
)
def test_what_a_build_with_cmake_leaves_open(findings, cmake, found):
    files = {"CMakeLists.txt": cmake, "package.xml": CMAKE, "setup.py": "", "setup.cfg": "[develop]\n"}
    files |= {"src/CMakeLists.txt": "add_executable(driver driver.cpp)\n", "nodes/driver": "", "scripts/drive.py": ""}
    assert len(findings("LCH001", node(exec="driver"), **files)) == found


def test_an_executable_of_another_workspace(findings):
    assert findings("LCH001", node(pkg="nav2_amcl", exec="amcl")) == []


def test_an_unknown_executable_is_named_with_the_near_one(findings):
    (found,) = findings("LCH001", node(exec="taker"))
    assert found.message == "package 'robot' installs no executable 'taker'; did you mean 'talker'?"
    assert found.help == "add it to setup.py, or start one that the package installs: talker"


def test_a_long_list_says_that_it_goes_on(findings):
    names = [f"talk{number}" for number in range(10)]
    entries = ", ".join(f"'{name} = robot.talker:main'" for name in names)
    (found,) = findings(
        "LCH001", node(exec="zebra"), **{"setup.py": SETUP.replace("'talker = robot.talker:main'", entries)}
    )
    assert found.help.endswith(f"that the package installs: {', '.join(names[:8])} and 2 more")


def test_another_name_of_the_same_file_is_the_one_to_start(findings):
    setup = SETUP.replace("'talker =", "'speak =")
    (found,) = findings("LCH001", node(exec="talker.py"), **{"setup.py": setup})
    assert found.message.endswith("no executable 'talker.py'; robot.talker is installed as 'speak'")
    assert found.help == "start 'speak'"
    files = {"CMakeLists.txt": "project(robot)\n" + SCRIPTS, "package.xml": CMAKE, "setup.py": ""}
    (found,) = findings("LCH001", node(exec="drive"), **files)
    assert found.message.endswith("; scripts/drive.py is installed as 'drive.py'")


def test_an_executable_of_another_package_of_the_workspace(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    launch = f"<launch>{node(exec='grip')}</launch>"
    texts = {"archlint.toml": 'select = ["LCH001"]', "robot/launch/it.launch.xml": launch}
    for name, executable in (("robot", "talker"), ("arm", "grip")):
        texts[f"{name}/package.xml"] = MANIFEST.format(name=name, type="ament_python", more="")
        texts[f"{name}/setup.py"] = SETUP.replace("talker = robot.talker", f"{executable} = {name}.{executable}")
        texts[f"{name}/{name}/{executable}.py"] = TALKER
    for name, text in texts.items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text, encoding="utf-8")
    (found,) = check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings
    assert found.message == "package 'robot' installs no executable 'grip'; package 'arm' installs it"
    assert found.help == "start it from package 'arm'"


def test_an_executable_whose_file_is_there(findings):
    files = {"CMakeLists.txt": "project(robot)\n" + SCRIPTS, "package.xml": CMAKE, "setup.py": ""}
    (found,) = findings("LCH001", node(exec="steer.py"), **files, **{"scripts/steer.py": TALKER})
    assert found.help == "install scripts/steer.py in CMakeLists.txt"


@pytest.mark.parametrize(
    ("scripts", "hint", "help"),
    [
        (
            ["track.py", "crack.py"],
            "; scripts/track.py is there, and not installed",
            "install it in CMakeLists.txt under",
        ),
        (["crack.py"], "; did you mean 'crack_node'?", "add it to"),
    ],
)
def test_a_file_of_that_name_is_nearer_than_another_node(findings, scripts, hint, help):
    cmake = "project(robot)\ninstall(PROGRAMS scripts/crack.py DESTINATION lib/robot RENAME crack_node)\n"
    files = {
        "CMakeLists.txt": cmake,
        "package.xml": CMAKE,
        "setup.py": "",
        **{f"scripts/{one}": TALKER for one in scripts},
    }
    (found,) = findings("LCH001", node(exec="track_node"), **files)
    assert found.message.endswith(f"'track_node'{hint}") and found.help.startswith(help)


def test_a_program_in_a_folder_below_is_not_found_by_launch(findings):
    cmake = "project(robot)\ninstall(DIRECTORY scripts DESTINATION lib/robot)\n"
    files = {"CMakeLists.txt": cmake, "package.xml": CMAKE, "setup.py": "", "scripts/drive.py": TALKER}
    (found,) = findings("LCH001", node(exec="drive.py"), **files)
    assert found.message.endswith("'drive.py': it is installed as lib/robot/scripts")
    assert found.help == "install the content of the folder, with a trailing slash: install(DIRECTORY …/ …)"
    files["CMakeLists.txt"] = cmake.replace("scripts", "scripts/")
    assert findings("LCH001", node(exec="drive.py"), **files) == []


@pytest.mark.parametrize(
    ("line", "found"), [("", 1), ("open(path, 'w').write('x')", 0), ("shutil.copy('a', path)", 0), ("open(path)", 1)]
)
def test_a_file_that_the_launch_file_may_make(findings, line, found):
    launch = f"""\
import os, shutil
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch_ros.actions import Node

def generate_launch_description():
    path = os.path.join(get_package_share_directory('robot'), 'config', 'made.yaml')
    {line}
    return LaunchDescription([Node(package='robot', executable='talker', parameters=[path])])
"""
    assert len(findings("LCH004", **{"launch/py.launch.py": launch})) == found


def test_a_missing_file_behind_the_block_that_every_package_copies(findings):
    cmake = "project(robot)\ninstall(DIRECTORY launch DESTINATION share/robot)\n" + TESTS
    files = {"CMakeLists.txt": cmake, "package.xml": CMAKE, "setup.py": "", "config/talk.yaml": ""}
    for written, message in (("config/talk.yaml", "does not install"), ("config/tolk.yaml", "has no parameter file")):
        inner = f'<param from="$(find-pkg-share robot)/{written}"/>'
        (found,) = findings("LCH004", node(inner), **files)
        assert message in found.message
    whole = cmake.replace("DIRECTORY launch", "DIRECTORY launch config")
    inner = '<param from="$(find-pkg-share robot)/config/talk.yaml"/>'
    assert findings("LCH004", node(inner), **{**files, "CMakeLists.txt": whole}) == []


@pytest.mark.parametrize(
    "remap",
    [
        '<remap from="chatter" to="x"/>',
        '<remap from="~/get_parameters" to="x"/>',
        '<remap from="/tf" to="tf"/>',
        '<remap from="/rosout" to="x"/>',
    ],
)
def test_live_remappings(findings, remap):
    assert findings("LCH002", node(remap)) == []


def test_remappings_of_a_group_are_for_whoever_has_the_name(findings):
    assert findings("LCH002", '<set_remap from="odom" to="/odom"/>' + node()) == []


def test_the_node_that_a_helper_works_on_is_no_second_one(findings):
    helper = "class Helper:\n    def start(self, node):\n        node.create_timer(1.0, print)\n\n\n"
    text = helper + TALKER.replace(
        "        self.create_p", "        Helper().start(found('a node'))\n        self.create_p"
    )
    twice = TALKER.replace("rclpy.spin(Talker())", "one, other = Talker(), Talker()\n    rclpy.spin(one)")

    assert findings("NME004", node(name="it"), **{"robot/talker.py": text}) == []
    closed = 'select = ["GRF001"]\nclosed-world = true'
    assert findings("GRF001", node(name="it"), **{"robot/talker.py": text, "archlint.toml": closed}) == []
    assert findings("NME004", node(name="it"), **{"robot/talker.py": twice}) != []


EXECUTOR = "several = rclpy.executors.SingleThreadedExecutor()"


@pytest.mark.parametrize(
    ("main", "several"),
    [
        (["node = Talker()", "while not node.ready:", "    node = Talker()"], False),
        (["node = None", "while node is None or not node.ready:", "    node = Talker()"], False),
        (["node = Talker()", "node.destroy_node()", "node = Talker()"], False),
        ([EXECUTOR, "for _ in range(2):", "    node = Talker()", "    several.add_node(node)"], True),
        (["node = Talker()", "other = Talker()"], True),
    ],
)
def test_a_node_that_takes_the_place_of_itself_is_one(findings, main, several):
    text = TALKER.replace("rclpy.spin(Talker())", "\n    ".join([*main, "rclpy.spin(node)"]))
    found = findings("NME004", node(name="it"), **{"robot/talker.py": text})
    assert bool(found) is several


def test_a_factory_makes_one_of_its_nodes(findings):
    """Which of them, only data decides: in each process there is one."""
    factory = """\
import sys
import rclpy
from rclpy.node import Node

class Race(Node):
    def __init__(self):
        super().__init__('race')

class Duel(Node):
    def __init__(self):
        super().__init__('duel')

def make(name):
    if name == 'race':
        return Race()
    elif name == 'duel':
        return Duel()
    raise ValueError(name)

def main():
    rclpy.init()
    rclpy.spin(make(open('which').read()))
"""
    assert findings("NME004", node(name="it"), **{"robot/talker.py": factory}) == []
    both = factory.replace("rclpy.spin(make", "other = Duel()\n    rclpy.spin(make")
    assert len(findings("NME004", node(name="it"), **{"robot/talker.py": both})) == 1


def test_name_renames_all_nodes_of_an_executable(findings):
    two = TALKER.replace("Talker())", "Talker())\n    rclpy.spin(rclpy.create_node('helper'))")
    (found,) = findings("NME004", node(name="it"), **{"robot/talker.py": two})
    assert found.message == "name= renames every node of this executable, so several have the name '/it'"
    assert found.help == "remove name=, so that each node keeps the name from its code"
    assert sorted((one.place.line, one.message) for one in found.related) == [
        (13, "'talker' is made here"),
        (14, "'helper' is made here"),
    ]
    assert findings("NME004", node(), **{"robot/talker.py": two}) == []  # the advice works


def test_an_executable_that_makes_two_nodes_of_one_name(findings):
    two = TALKER.replace("Talker())", "Talker())\n    rclpy.spin(rclpy.create_node('talker'))")
    (found,) = findings("NME004", node(), **{"robot/talker.py": two})
    assert found.message == "this executable creates several nodes with the name '/talker'"
    assert found.help == "give each its own name in the code"
    (found,) = findings("NME004", node(name="it"), **{"robot/talker.py": two})
    assert found.help == "give each its own name in the code, and remove name= here"


HERE = '<include file="$(dirname)/{}.launch.xml"/>'
TWO_TALKERS = f"<launch>\n{node(name='left')}\n{node(name='right')}\n</launch>"


def test_a_launch_file_that_is_included_twice_is_told_once(findings):
    includes = "\n" + HERE.format("common") + "\n" + HERE.format("talkers") + "\n"
    files = {"launch/common.launch.xml": f"<launch>\n\n\n{HERE.format('talkers')}</launch>"}
    files["launch/talkers.launch.xml"] = TWO_TALKERS
    (found,) = findings("NME004", includes, **files)
    assert (found.place.file, found.place.line) == ("launch/it.launch.xml", 3)
    assert found.message == (
        "this system includes talkers.launch.xml twice, which starts 2 nodes twice, such as '/left'"
    )
    assert [(one.place.file, one.place.line) for one in found.related] == [
        ("launch/common.launch.xml", 4),
        ("launch/talkers.launch.xml", 2),
    ]


def test_includes_further_out_are_the_cause(findings):
    includes = "\n" + HERE.format("common") + "\n" + HERE.format("common") + "\n"
    files = {"launch/common.launch.xml": f"<launch>{HERE.format('talkers')}</launch>"}
    files["launch/talkers.launch.xml"] = TWO_TALKERS
    (found,) = findings("NME004", includes, **files)
    assert (found.place.file, found.place.line, found.related[0].place.line) == ("launch/it.launch.xml", 3, 2)
    assert found.message.startswith("this system includes common.launch.xml twice")


def test_a_file_may_be_included_twice_in_two_namespaces(findings):
    def group(name: str) -> str:
        return f"<group><push_ros_namespace namespace='{name}'/>{HERE.format('talkers')}</group>"

    files = {"launch/talkers.launch.xml": TWO_TALKERS}
    assert findings("NME004", group("one") + group("two"), **files) == []
    (found,) = findings("NME004", f"{group('one')}\n{group('two')}\n{group('one')}", **files)
    assert (found.place.line, found.related[0].place.line) == (3, 1)


def test_a_node_that_another_process_makes_is_one(findings):
    text = TALKER.replace(
        "        self.create_p",
        "        self.last = None\n        self.create_timer(1.0, self.tick)\n        self.create_p",
    )
    text = text.replace(
        "def main():\n", "    def tick(self):\n        self.last = self.create_client(String, 'x')\n\ndef work():\n"
    )
    text += "\ndef main():\n    import multiprocessing\n    multiprocessing.Process(target=work).start()\n"

    assert findings("NME004", node(name="it"), **{"robot/talker.py": text}) == []


def test_a_remapping_that_works_where_the_file_is_included_in_a_namespace(findings):
    remap = '<remap from="/left/chatter" to="/x"/>'
    part = f"<launch>{node(remap)}</launch>"
    include = '<include file="$(find-pkg-share robot)/launch/part.launch.xml"/>'

    pushed = f'<group><push_ros_namespace namespace="left"/>{include}</group>'
    assert findings("LCH002", pushed, **{"launch/part.launch.xml": part}) == []
    assert findings("LCH002", include, **{"launch/part.launch.xml": part}) != []


def test_a_remapping_is_judged_under_the_nodes_namespace(findings):
    (found,) = findings("LCH002", node('<remap from="/chatter" to="x"/>', namespace="left"))
    assert "/left/talker has no name '/chatter'" in found.message
    assert "/left/chatter" in found.help


def test_a_node_that_hands_itself_out_may_have_more_names(findings):
    text = TALKER.replace("        self.create_publisher", "        Helper(self)\n        self.create_publisher")
    text = "from library import Helper\n" + text
    assert findings("LCH002", node('<remap from="odom" to="x"/>'), **{"robot/talker.py": text}) == []


def test_an_argument_that_every_includer_passes_is_declared_enough(findings):
    inner = f"<launch>{node(name='$(var name)')}</launch>"
    outer = '<include file="$(dirname)/inner.launch.xml"><arg name="name" value="a"/></include>'
    assert findings("LCH003", outer, **{"launch/inner.launch.xml": inner}) == []
    (found,) = findings("LCH003", outer.replace('name="name"', 'name="nam"'), **{"launch/inner.launch.xml": inner})[:1]
    assert found.place.file.startswith("launch/")


def test_a_configuration_behind_a_condition_may_be_set_by_then(findings):
    assert findings("LCH003", '<arg name="x"/>' + node(name="$(var y)", **{"if": "$(var x)"})) == []


def test_the_advice_is_written_in_the_language_of_the_launch_file(findings):
    (xml,) = findings("LCH003", node(name="$(var y)"))
    assert xml.help == 'declare it before it is read: <arg name="y" default="…"/>'
    yaml = "launch:\n- node: {pkg: robot, exec: talker, name: $(var y)}\n"
    (other,) = findings("LCH003", **{"launch/b.launch.yaml": yaml})
    assert other.help == "declare it before it is read: - arg: {name: y, default: …}"


def test_an_argument_of_an_action_that_it_does_not_have_stops_the_whole_file(findings):
    (xml,) = findings("LCH005", node(nodename="y"))
    assert xml.help == "launch rejects this file before anything is started"
    code = "from launch import LaunchDescription\nfrom launch_ros.actions import Node\n\n"
    code += "def generate_launch_description():\n    return LaunchDescription([Node(package='robot', node_name='x')])\n"
    (python,) = findings("LCH005", **{"launch/b.launch.py": code})
    assert python.help == "this call raises TypeError before anything is started"


def test_what_the_actions_of_one_file_do_not_have_is_one_finding(findings):
    inner = f"{node(nodename='y', respawned='true')}\n{node(nodename='z')}\n{node(name='fine')}"
    code = "from launch import LaunchDescription\nfrom launch_ros.actions import Node\n\n"
    code += "def generate_launch_description():\n    return LaunchDescription([\n"
    code += "        Node(package='robot', node_name='x', name='a'),\n        Node(package='robot', params=[])])\n"
    python, xml = findings("LCH005", inner, **{"launch/b.launch.py": code})
    assert (xml.place.line, "<node> has no attribute 'nodename'" in xml.message) == (1, True)
    assert [one.place.line for one in xml.related] == [1, 2]
    assert xml.related[0].message == "<node> has no attribute 'respawned'; did you mean 'respawn'?"
    assert (python.place.line, [one.place.line for one in python.related]) == (6, [7])


@pytest.mark.parametrize(
    ("inner", "told"),
    [
        ("<node name='Monitor' path='a/Monitor'/><node name='Plan' path='a/Plan'/>", 0),  # of another tool
        ("<component name='Plan' path='a/Plan'/>", 0),
        ("<node name='a' path='b'/><node pkg='robot' exec='talker'/>", 1),
        ("<node package='robot' executable='talker'/>", 1),
        ("<node name='a' path='$(find-pkg-share robot)/a'/>", 1),
        ("<node name='a' path='b'/><arg name='c'/>", 1),
        ("<node name='a' path='b'><param name='c' value='1'/></node>", 1),
    ],
)
def test_a_launch_file_of_another_tool_is_none_of_ros(findings, inner: str, told: int):
    assert len(findings("LCH005", inner)) == told


def test_a_comment_allows_one_of_them(findings):
    inner = f"{node(nodename='y')} <!-- archlint: ignore[LCH005] -->\n{node(other='z')}"
    (found,) = findings("LCH005", inner)
    assert (found.place.line, found.related) == (2, ())


def test_one_forgotten_argument_is_told(findings):
    (found,) = findings("LCH003", '<arg name="x" default="a"/>' + node(name="$(var y)"))
    assert "no launch argument 'y' is declared" in found.message


def test_an_argument_that_is_declared_too_late(findings):
    (found,) = findings("LCH003", node(name="$(var y)") + '<arg name="y" default="a"/>')
    assert found.message == "the launch argument 'y' is read before it is declared"
    assert [one.message for one in found.related] == ["it is declared here"]


READS_ITSELF = """\
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node

def generate_launch_description():
    name = LaunchConfiguration('name')
    return LaunchDescription([
        DeclareLaunchArgument('name', default_value=[name]),
        Node(package='robot', executable='talker', name=name),
    ])
"""


def test_a_default_that_is_the_argument_itself(findings):
    (found,) = findings("LCH003", **{"launch/a.launch.py": READS_ITSELF})
    assert found.message.startswith("the default of the launch argument 'name' is 'name' itself")
    assert (found.place.line, [one.place.line for one in found.related]) == (9, [7])


@pytest.mark.parametrize("good", ["LaunchConfiguration('name', default='ann')", "'ann'"])
def test_a_default_behind_the_default_is_one(findings, good):
    text = READS_ITSELF.replace("LaunchConfiguration('name')", good)
    assert findings("LCH003", **{"launch/a.launch.py": text}) == []


def test_an_include_that_gives_the_argument_needs_no_default(findings):
    outer = '<include file="$(dirname)/a.launch.py"><arg name="name" value="ann"/></include>'
    assert findings("LCH003", outer, **{"launch/a.launch.py": READS_ITSELF}) == []


def test_an_argument_that_a_missing_include_may_declare(findings):
    read = node(name="$(var y)")
    there = '<include file="$(find-pkg-share robot)/launch/inner.launch.xml"/>'
    assert findings("LCH003", there + read) == []  # LCH004 tells the include
    (found,) = findings("LCH003", there + read, **{"launch/inner.launch.xml": "<launch/>"})
    assert "'y'" in found.message
    (found,) = findings("LCH003", read + there)
    assert "'y'" in found.message


def test_what_a_later_include_declares_for_itself_is_no_declaration_here(findings):
    inner = '<launch><arg name="y" default="a"/></launch>'
    outer = node(name="$(var y)") + '<include file="$(dirname)/inner.launch.xml"/>'
    (found,) = findings("LCH003", outer, **{"launch/inner.launch.xml": inner})
    assert found.message == "no launch argument 'y' is declared at this point, and nothing sets it"
    assert found.help is not None and found.help.startswith("declare it before it is read")
    assert [one.message for one in found.related] == ["declared here, later"]


NEVER_ADDED = """\
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node

def generate_launch_description():
    name = DeclareLaunchArgument('name', default_value='ann')
    talker = Node(package='robot', executable='talker', name=LaunchConfiguration('name'))
    return LaunchDescription([talker])
"""


def test_a_declaration_that_is_made_and_never_added(findings):
    (found,) = findings("LCH003", **{"launch/a.launch.py": NEVER_ADDED})
    assert found.message == "the launch argument 'name' is read, but its declaration is not in the LaunchDescription"
    assert (found.place.line, [one.place.line for one in found.related]) == (8, [7])


def test_a_declaration_that_only_an_included_file_adds_later(findings):
    inner = '<arg name="name" default="bob"/>'
    include = (
        "    later = IncludeLaunchDescription(XMLLaunchDescriptionSource(\n"
        "        [FindPackageShare('robot'), '/launch/it.launch.xml']))\n    return"
    )
    outer = (
        "from launch.actions import IncludeLaunchDescription\nfrom launch_xml.launch_description_sources import "
        "XMLLaunchDescriptionSource\nfrom launch_ros.substitutions import FindPackageShare\n"
    ) + NEVER_ADDED.replace("    return", include).replace("[talker]", "[talker, later]")
    (found,) = findings("LCH003", inner, **{"launch/a.launch.py": outer})
    assert [one.place.file for one in found.related] == ["launch/a.launch.py"]


@pytest.mark.parametrize("added", ["[name, talker]", "[talker], **{}", "[*[name], talker]"])
def test_a_declaration_that_is_added(findings, added):
    text = NEVER_ADDED.replace("[talker]", added)
    if "**" in added:
        text = NEVER_ADDED.replace("    return LaunchDescription([talker])", ADDED_LATER)
    assert findings("LCH003", **{"launch/a.launch.py": text}) == []


ADDED_LATER = """\
    description = LaunchDescription()
    for one in (name, talker):
        description.add_action(one)
    return description"""


@pytest.mark.parametrize(
    "launch",
    [
        '<arg name="x"/>' + node(name="$(var y)"),
        node(name="$(var a)", namespace="$(var b)", args="$(var c)"),
    ],
)
def test_a_file_that_is_meant_to_be_included_gets_its_arguments_from_elsewhere(findings, launch):
    assert findings("LCH003", launch) == []


@pytest.mark.parametrize(("substitutes", "told"), [("true", 0), ("false", 1)])
def test_a_parameter_file_with_substitutions_may_read_an_includes_argument(findings, substitutes, told):
    load_it = f'<param from="$(find-pkg-share robot)/config/p.yaml" allow_substs="{substitutes}"/>'
    files = {
        "launch/inner.launch.xml": f"<launch>{node(load_it)}</launch>",
        "config/p.yaml": "talker: {ros__parameters: {rate: $(var speed)}}",
    }
    outer = '<include file="$(dirname)/inner.launch.xml"><arg name="speed" value="2.0"/></include>'
    assert len(findings("LCH003", outer, **files)) == told


INCLUDING = """\
import os
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, IncludeLaunchDescription
from launch.launch_description_sources import AnyLaunchDescriptionSource
from launch.substitutions import LaunchConfiguration, PathJoinSubstitution
from launch_ros.substitutions import FindPackageShare

def part(name):
    return PathJoinSubstitution([FindPackageShare('robot'), 'launch', name])

def generate_launch_description():
    real = os.path.exists('/dev/robot')
    given = {{'speed': '1.0', 'sped': '2.0', 'rate': '3.0'}}
    {before}
    return LaunchDescription([
        IncludeLaunchDescription(AnyLaunchDescriptionSource(part({file})), launch_arguments={arguments}),
    ])
"""
FAST = '<launch><arg name="speed" default="1"/><arg name="rate" default="1"/></launch>'


def included(findings, arguments: str, file: str = "'fast.launch.xml'", before: str = "", **files: str):
    outer = INCLUDING.format(file=file, arguments=arguments, before=before or "pass")
    return findings("LCH003", **{"launch/fast.launch.xml": FAST, "launch/outer.launch.py": outer, **files})


def test_an_include_is_told_once(findings):
    (one,) = included(findings, "{'sped': '2.0', 'slow': '1', 'rate': '1', 'colour': 'red'}.items()")
    assert one.message == "fast.launch.xml declares none of the launch arguments 'sped', 'slow', 'colour'"
    assert [other.message for other in one.related] == ["'slow' is set here", "'colour' is set here"]
    (one,) = included(findings, "{'sped': '2.0'}.items()")
    assert one.message == "fast.launch.xml declares no launch argument 'sped'; did you mean 'speed'?"
    assert "declared are rate, speed" in (one.help or "")


def test_the_same_mistake_at_two_includes_is_one(findings):
    include = '<include file="$(dirname)/fast.launch.xml"><arg name="colour" value="{}"/></include>'
    outer = include.format("red") + "\n" + include.format("green")
    (one,) = findings("LCH003", outer, **{"launch/fast.launch.xml": FAST})
    assert [(related.place.line, related.message) for related in one.related] == [(2, "and here")]


def test_an_argument_is_for_the_file_that_takes_it(findings):
    slow = {"launch/slow.launch.xml": '<launch><arg name="sped" default="1"/></launch>'}
    choice = "'fast.launch.xml' if real else 'slow.launch.xml'"
    assert included(findings, "{'speed': '1', 'sped': '2'}.items()", choice, **slow) == []
    (one,) = included(findings, "{'speed': '1', 'colour': 'red'}.items()", choice, **slow)
    assert "fast.launch.xml and slow.launch.xml declare no launch argument 'colour'" in one.message


@pytest.mark.parametrize(
    ("inner", "told"),
    [
        ("# colour", 1),
        ("Node(package='robot', executable='talker', name='colour')", 1),
        ("Node(package='robot', executable='talker', parameters=[{'colour': 'red'}])", 1),
        ("Node(package='robot', executable='talker', parameters=[{'c': LaunchConfiguration('colour')}])", 0),
        ("OpaqueFunction(function=lambda c: [LogInfo(msg=c.launch_configurations['colour'])])", 0),
        ("OpaqueFunction(function=lambda c: read(c, 'colour'))", 0),
    ],
)
def test_only_what_reads_an_argument_takes_it(findings, inner, told):
    text = (
        "from launch import LaunchDescription\nfrom launch.actions import LogInfo, OpaqueFunction\n"
        "from launch.substitutions import LaunchConfiguration\nfrom launch_ros.actions import Node\n"
        f"def generate_launch_description():\n    return LaunchDescription([\n        {inner}\n    ])\n"
    )
    outer = '<include file="$(dirname)/inner.launch.py"><arg name="colour" value="red"/></include>'
    assert len(findings("LCH003", outer, **{"launch/inner.launch.py": text})) == told


def test_a_node_of_an_included_xml_file_may_have_an_arguments_name(findings):
    outer = '<include file="$(dirname)/inner.launch.yaml"><arg name="talker" value="red"/></include>'
    inner = "launch:\n- node: {pkg: robot, exec: talker, name: 'NAME'}\n"
    (one,) = findings("LCH003", outer, **{"launch/inner.launch.yaml": inner.replace("NAME", "talker")})
    assert one.message.startswith("inner.launch.yaml declares no launch argument 'talker'")
    assert findings("LCH003", outer, **{"launch/inner.launch.yaml": inner.replace("NAME", "$(var talker)")}) == []


@pytest.mark.parametrize(
    ("value", "before"),
    [
        ("{'speed': LaunchConfiguration('s')}.items() if real else {}.items()", ""),
        ("{'speed': LaunchConfiguration('s') if real else '1'}.items()", ""),
        ("given.items()", "given = {}\n    if real:\n        given['speed'] = LaunchConfiguration('s')"),
    ],
)
def test_what_one_branch_reads_is_not_read_in_the_other(findings, value, before):
    assert included(findings, value, before=before) == []
    assert len(included(findings, "{'speed': LaunchConfiguration('s')}.items()")) == 1


@pytest.mark.parametrize(("condition", "told"), [("True", 1), ("os.getenv('ROS_DISTRO') == 'dashing'", 0)])
def test_keywords_of_an_older_ros(findings, condition, told):
    text = f"""\
import os
from launch import LaunchDescription
from launch_ros.actions import Node

def generate_launch_description():
    if {condition}:
        return LaunchDescription([Node(package='robot', node_executable='talker')])
    return LaunchDescription([Node(package='robot', executable='talker')])
"""
    assert len(findings("LCH005", **{"launch/old.launch.py": text})) == told


@pytest.mark.parametrize(
    ("name", "keyword", "severity"),
    [
        ("dashing_start", "node_executable", Severity.INFO),
        ("start", "node_executable", Severity.WARNING),
        ("dashing_start", "executible", Severity.WARNING),
        ("flashing_start", "node_executable", Severity.WARNING),
    ],
)
def test_a_file_for_an_old_release(findings, name: str, keyword: str, severity: Severity):
    text = f"""\
from launch import LaunchDescription
from launch_ros.actions import Node

def generate_launch_description():
    return LaunchDescription([Node(package='robot', {keyword}='talker')])
"""
    assert [one.severity for one in findings("LCH005", **{f"launch/{name}.launch.py": text})] == [severity]


def test_files_of_other_packages_are_not_looked_for(findings):
    assert findings("LCH004", '<include file="$(find-pkg-share nav2_bringup)/launch/x.launch.py"/>') == []


@pytest.mark.parametrize(
    ("written", "hint"),
    [
        ("launch/robt.launch.xml", "; did you mean 'robot.launch.xml'?"),
        ("launch/robot.launch.yml", "; did you mean 'robot.launch.xml'?"),
        ("launch/nope.launch.xml", ""),
        ("launch/camera.launch.xml", ""),
    ],
)
def test_a_missing_file_is_named_with_the_near_one_beside_it(findings, written, hint):
    include = f'<include file="$(find-pkg-share robot)/{written}"/>'
    (found,) = findings("LCH004", include, **{"launch/robot.launch.xml": "<launch/>"})
    assert found.message == f"package 'robot' has no launch file '{written}'{hint}"


def test_a_file_that_is_there_but_not_installed(findings):
    (found,) = findings(
        "LCH004", '<include file="$(find-pkg-share robot)/more/x.launch.xml"/>', **{"more/x.launch.xml": "<launch/>"}
    )
    assert "does not install the launch file 'more/x.launch.xml'" in found.message


LAUNCHES = '<executable cmd="ros2 launch robot deep.launch.xml"/>'
DEEP = SETUP.replace("glob('config/*'))", "glob('config/*')), ('share/robot/more/helpers', glob('helpers/*.xml'))")


@pytest.mark.parametrize(
    ("files", "told"),
    [
        ({"setup.py": DEEP, "helpers/deep.launch.xml": "<launch/>"}, ""),  # ros2 launch looks in all folders
        ({"launch/deep.launch.xml": "<launch/>"}, ""),
        ({"setup.py": DEEP, "helpers/deep.launch.xml": "<launch/>", "launch/deep.launch.xml": "<launch/>"}, ""),
        ({"helpers/deep.launch.xml": "<launch/>"}, "does not install the launch file 'helpers/deep.launch.xml'"),
        ({"setup.py": DEEP, "helpers/deeper.launch.xml": "<launch/>"}, "has no launch file 'launch/deep.launch.xml'"),
    ],
)
def test_a_launch_file_that_a_command_names(findings, files: dict[str, str], told: str):
    messages = [found.message for found in findings("LCH004", LAUNCHES, **files)]
    assert len(messages) == (1 if told else 0)
    assert all(told in message for message in messages)


GIVES = """\
import os
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, IncludeLaunchDescription
from launch.launch_description_sources import AnyLaunchDescriptionSource
from launch.substitutions import LaunchConfiguration

def generate_launch_description():
    share = get_package_share_directory('robot')
    def inner(name, file):
        return IncludeLaunchDescription(AnyLaunchDescriptionSource(share + '/launch/' + name),
                                        launch_arguments={'params': file}.items())
    return LaunchDescription([
        DeclareLaunchArgument('file', default_value=os.path.join(share, 'config', 'gone.yaml')),
        inner('one.launch.xml', LaunchConfiguration('file')),
        inner('two.launch.xml', LaunchConfiguration('file')),
        inner('two.launch.xml', os.path.join(share, 'config', 'lost.yaml')),
    ])
"""


def test_a_missing_file_is_told_where_it_is_named(findings):
    """The files that use it name none: what they are given has a default, or is written in the include."""
    arg = '<arg name="params" default="$(find-pkg-share robot)/config/good.yaml"/>'
    inner = "<launch>" + arg + "\n" + node('<param from="$(var params)"/>') + "</launch>"
    files = {"launch/one.launch.xml": inner, "launch/two.launch.xml": inner, "config/good.yaml": ""}
    outer = {"launch/outer.launch.py": GIVES}
    gone, lost = findings("LCH004", **files, **outer)
    rows = [(one.place.file, one.place.line, one.message.rpartition(" ")[2]) for one in (gone, lost)]
    assert rows == [
        ("launch/outer.launch.py", 14, "'config/gone.yaml'"),
        ("launch/outer.launch.py", 17, "'config/lost.yaml'"),
    ]
    uses = [[(one.place.file, one.place.line) for one in found.related] for found in (gone, lost)]
    assert uses == [[("launch/one.launch.xml", 2), ("launch/two.launch.xml", 2)], [("launch/two.launch.xml", 2)]]
    there = {"config/gone.yaml": "", "config/lost.yaml": ""}
    assert findings("LCH004", **files, **outer, **there) == []


def test_a_variable_for_a_missing_file_is_told_once(findings):
    text = """\
import os
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch_ros.actions import Node

def generate_launch_description():
    view = os.path.join(get_package_share_directory('robot'), 'config', 'view.rviz')
    return LaunchDescription([
        Node(package='rviz2', executable='rviz2', name='one', arguments=['-d', view]),
        Node(package='rviz2', executable='rviz2', name='two', arguments=['-d', view])])
"""
    (found,) = findings("LCH004", **{"launch/py.launch.py": text})
    assert (found.place.line, [one.place.line for one in found.related]) == (7, [9, 10])


@pytest.mark.parametrize(
    ("test", "told"),
    [
        ("if os.path.exists(path):", 0),
        ("if os.path.isfile(path):", 0),
        ("if Path(path).exists():", 0),
        ("if os.path.exists(os.path.dirname(path)):", 1),  # another path
        ("if os.environ.get('CONFIGURED'):", 1),
        ("if not os.path.exists(path):\n        raise RuntimeError(path)\n    if True:", 1),  # it cannot do without
    ],
)
@pytest.mark.parametrize("use", ["parameters = [path]", "talkers = [Node(**talker, parameters=[path])]"])
def test_a_file_that_is_used_only_where_it_is(findings, test: str, told: int, use: str):
    text = f"""\
import os
from pathlib import Path
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch_ros.actions import Node

def generate_launch_description():
    path = os.path.join(get_package_share_directory('robot'), 'config', 'perhaps.yaml')
    talker = dict(package='robot', executable='talker')
    parameters, talkers = [], []
    {test}
        {use}
    return LaunchDescription([Node(**talker, parameters=parameters), *talkers])
"""
    assert len(findings("LCH004", **{"launch/py.launch.py": text})) == told


@pytest.mark.parametrize(
    ("there", "hint"),
    [
        ("params_multi_robot_1.yaml", True),
        ("multirobot_1_params.yaml", True),
        ("params_multi_robot_2.yaml", False),  # the other robot's
        ("params_robot_1.yaml", False),
    ],
)
def test_a_file_whose_words_stand_in_another_order(findings, there: str, hint: bool):
    inner = '<param from="$(find-pkg-share robot)/config/multirobot_params_1.yaml"/>'
    (found,) = findings("LCH004", node(inner), **{f"config/{there}": ""})
    assert (f"did you mean '{there}'?" in found.message) is hint


WRITES = "with open(os.path.join(folder, 'made.yaml'), 'w') as file:\n    file.write(text)\n"


@pytest.mark.parametrize(
    ("files", "told"),
    [
        ({"robot/make.py": WRITES}, 0),
        ({"robot/make.py": "(folder / 'made.yaml').write_text(text)\n"}, 0),
        ({"templates/made.yaml.j2": ""}, 0),
        ({"templates/made.xacro": ""}, 0),
        ({"robot/make.py": WRITES.replace("'w'", "'r'")}, 1),  # who reads it does not make it
        ({"robot/make.py": WRITES.replace("made.yaml", "premade.yaml")}, 1),
        ({"robot/make.py": WRITES, "config/temp/other.yaml": ""}, 1),  # the folder is there: what is kept there is, too
        ({}, 1),
    ],
)
def test_a_file_that_something_here_writes(findings, files: dict[str, str], told: int):
    inner = '<param from="$(find-pkg-share robot)/config/temp/made.yaml"/>'
    assert len(findings("LCH004", node(inner), **files)) == told


# ------------------------------------------------------------------------------------------------ parameters


NAMED_BY_PARAMETER = TALKER.replace("'chatter'", "self.declare_parameter('topic', 'out').value")
OF_A_FILE = '<param from="{}"/>'
NOT_FOUND = ["$(find-pkg-share robot)/gone.yaml", "$(find-pkg-share elsewhere)/a.yaml", "$(var config)", "/etc/a.yaml"]


def two(inner: str) -> str:
    return '<arg name="config"/>' + node(inner, name="a") + node(inner, name="b")


@pytest.mark.parametrize("file", NOT_FOUND)
def test_a_parameter_file_that_is_not_found_may_name_anything(findings, file: str):
    files = {"robot/talker.py": NAMED_BY_PARAMETER}
    assert findings("OWN001", two(OF_A_FILE.format(file)), **files) == []
    (found,) = findings("OWN001", two(OF_A_FILE.format(file) + '<param name="topic" value="both"/>'), **files)
    assert "'/both'" in found.message


STARTS_TWO = """\
import os
from launch import LaunchDescription
from launch_ros.actions import Node
import elsewhere

def generate_launch_description():
    given = GIVEN
    return LaunchDescription([
        Node(package='robot', executable='talker', name=name, PARAMETERS) for name in ('a', 'b')
    ])
"""


@pytest.mark.parametrize(
    ("given", "parameters", "topic"),
    [
        ("elsewhere.load()", "parameters=given", None),
        ("elsewhere.load()", "parameters=[given]", None),
        ("{elsewhere.NAME: 1.0}", "parameters=[given]", None),
        ("elsewhere.load()", "**given", None),
        ("elsewhere.load()", "parameters=[given, {'topic': 'both'}]", "/both"),  # what comes later holds
        ("elsewhere.load()", "parameters=[{'rate': given}]", "/out"),  # only the value is not known
        ("[{'rate': 1.0}] if os.environ.get('FAST') else [{'rate': 2.0}]", "parameters=given", "/out"),
        ("{'rate': 1.0} if os.environ.get('FAST') else {'rate': 2.0}", "parameters=[given]", "/out"),
    ],
)
def test_parameters_that_are_not_known_may_name_anything(findings, given: str, parameters: str, topic: str | None):
    launch = STARTS_TWO.replace("GIVEN", given).replace("PARAMETERS", parameters)
    files = {"robot/talker.py": NAMED_BY_PARAMETER, "launch/two.launch.py": launch}
    told = [found.message for found in findings("OWN001", **files)]
    assert [f"'{topic}'" in message for message in told] == ([] if topic is None else [True])


def test_a_parameter_file_that_is_found_leaves_the_other_defaults(findings):
    files = {"robot/talker.py": NAMED_BY_PARAMETER, "config/a.yaml": "/**: {ros__parameters: {rate: 2.0}}"}
    (found,) = findings("OWN001", two(OF_A_FILE.format("$(find-pkg-share robot)/config/a.yaml")), **files)
    assert "'/out'" in found.message
    gone = OF_A_FILE.format("$(find-pkg-share robot)/gone.yaml")
    assert len(findings("OWN001", two(gone))) == 1  # a name that no parameter decides stays


def test_values_of_the_right_type(findings):
    assert findings("PRM002", node('<param name="rate" value="2.0"/>')) == []
    assert findings("PRM002", '<arg name="r"/>' + node('<param name="rate" value="$(var r)"/>')) == []


def test_dynamic_typing_takes_anything(findings):
    text = TALKER.replace("1.0)", "1.0, ParameterDescriptor(dynamic_typing=True))")
    assert findings("PRM002", node('<param name="rate" value="2"/>'), **{"robot/talker.py": text}) == []


NAMED_AFTER_IT = "self.declare_parameter(f'radios.{kind}.ip', '')"


@pytest.mark.parametrize(
    ("yaml", "told"),
    [
        ("talker: {ros__parameters: {radio: b, radios: {a: {ip: x}, b: {ip: y}}}}", []),  # each choice has its section
        ("talker: {ros__parameters: {radios: {a: {ip: x}, b: {ip: y}}}}", []),
        ("talker: {ros__parameters: {radios: {a: {port: x}}}}", ["radios.a.port"]),
        ("talker: {ros__parameters: {radoi: b}}", ["radoi"]),
    ],
)
def test_values_for_what_another_choice_would_declare(findings, yaml: str, told: list[str]):
    chosen = "kind = self.declare_parameter('radio', 'a').value"
    text = TALKER.replace("self.declare_parameter('rate', 1.0)", f"{chosen}\n        {NAMED_AFTER_IT}")
    files = {"config/p.yaml": yaml, "robot/talker.py": text}
    found = findings("PRM004", node('<param from="$(find-pkg-share robot)/config/p.yaml"/>'), **files)
    assert [one.identity[1] for one in found] == told


def test_a_shared_section_is_for_whichever_node_declares_the_name(findings):
    load_it = '<param from="$(find-pkg-share robot)/config/p.yaml"/>'
    yaml = "/**: {ros__parameters: {rat: 1.0}}"
    assert findings("PRM004", node(load_it), **{"config/p.yaml": yaml})[0].place.file == "config/p.yaml"
    external = node(pkg="nav2_amcl", exec="amcl", name="amcl")
    assert findings("PRM004", node(load_it) + external, **{"config/p.yaml": yaml}) == []


def test_a_shared_section_may_be_for_the_nodes_of_another_launch_file(findings):
    load_it = '<param from="$(find-pkg-share robot)/config/p.yaml"/>'
    yaml = "/**: {ros__parameters: {mass: 1.0}}"
    amcl = f"<launch>{node(load_it, pkg='nav2_amcl', exec='amcl', name='amcl')}</launch>"
    alone = "<launch></launch>"

    both = {"config/p.yaml": yaml, "launch/other.launch.xml": amcl}
    assert findings("PRM004", node(load_it), **both) == []
    assert len(findings("PRM004", node(load_it), **both | {"launch/other.launch.xml": alone})) == 1


def test_a_section_may_be_for_another_node_of_that_name(findings):
    load_it = '<param from="$(find-pkg-share robot)/config/p.yaml"/>'
    yaml = "talker: {ros__parameters: {mass: 1.0}}"
    files = {"config/p.yaml": yaml, "robot/heavy.py": TALKER.replace("'rate'", "'mass'")}
    files["setup.py"] = SETUP.replace("robot.talker:main'", "robot.talker:main', 'heavy = robot.heavy:main'")
    heavy = f"<launch>{node(load_it, exec='heavy')}</launch>"

    assert len(findings("PRM004", node(load_it), **files)) == 1
    either = TALKER.replace("Talker())", "Talker() if len(found()) else Talker())")
    assert len(findings("PRM004", node(load_it), **files | {"robot/talker.py": either})) == 1
    files["robot/talker.py"] = TALKER
    assert findings("PRM004", node(load_it), **files, **{"launch/other.launch.xml": heavy}) == []


def test_a_helper_that_the_command_line_does_not_reach_keeps_its_name(findings):
    helper = "        rclpy.create_node('asker'{})\n"
    with_helper = TALKER.replace("        self.declare", helper + "        self.declare")
    apart = with_helper.format(", use_global_arguments=False")
    assert findings("NME004", node(name="it"), **{"robot/talker.py": apart}) == []
    reached = with_helper.format("")
    assert len(findings("NME004", node(name="it"), **{"robot/talker.py": reached})) == 1


def test_a_node_that_allows_undeclared_parameters_takes_anything(findings):
    text = TALKER.replace("('talker')", "('talker', allow_undeclared_parameters=True)")
    assert findings("PRM004", node('<param name="rat" value="1.0"/>'), **{"robot/talker.py": text}) == []


def test_a_section_without_its_namespace(findings):
    load_it = '<param from="$(find-pkg-share robot)/config/p.yaml"/>'
    yaml = "talker: {ros__parameters: {rate: 1.0}}"
    (found,) = findings("PRM005", node(load_it, namespace="left"), **{"config/p.yaml": yaml})
    assert found.message.endswith("did you mean '/left/talker'?")
    assert findings("PRM005", node(load_it), **{"config/p.yaml": yaml}) == []


@pytest.mark.parametrize(
    ("source", "told"),
    [
        ('#include <rclcpp/rclcpp.hpp>\nOther() : rclcpp::Node("other_base") {}', 0),
        ('#include <rclcpp/rclcpp.hpp>\nOther() : rclcpp::Node("other") {}', 1),
        ('std::string name = "other_base";', 1),  # no program of ROS
    ],
)
def test_a_section_for_another_program_of_the_package(findings, source: str, told: int):
    """One file for two programs, of which the launch file starts one."""
    load_it = '<param from="$(find-pkg-share robot)/config/p.yaml"/>'
    yaml = "talker: {ros__parameters: {rate: 1.0}}\nother_base: {ros__parameters: {speed: 1.0}}"
    assert len(findings("PRM005", node(load_it), **{"config/p.yaml": yaml, "src/other.cpp": source})) == told


IN_ROUNDS = """\
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node

def generate_launch_description():
    actions = []
    for name in ('left', 'right'):
        actions.append(Node(package='robot', executable='talker', name=LaunchConfiguration(name)))
        actions.append(DeclareLaunchArgument(name, default_value=name))
    return LaunchDescription(actions)
"""


def test_the_rounds_of_a_loop_read_too_early_once(findings):
    (found,) = findings("LCH003", **{"launch/it.launch.py": IN_ROUNDS})
    assert (found.place.line, found.message) == (9, "the launch argument 'left' is read before it is declared")
    assert "the launch argument 'right' is read before it is declared" in [one.message for one in found.related]
    names = "$(var left) $(var right)"  # two mistakes in one attribute
    assert len(findings("LCH003", f"<let name='a' value='{names}'/>", **{"launch/it.launch.py": ""})) == 2


def test_a_section_for_a_node_inside_a_process_that_is_not_here(findings):
    load_it = '<param from="$(find-pkg-share robot)/config/p.yaml"/>'
    yaml = "local_costmap:\n  local_costmap: {ros__parameters: {rate: 1.0}}"
    server = f'<node pkg="nav2_controller" exec="controller_server" name="controller_server">{load_it}</node>'
    assert findings("PRM005", node(load_it) + server, **{"config/p.yaml": yaml}) == []
    misspelt = {"config/p.yaml": "controller_sever: {ros__parameters: {rate: 1.0}}"}
    assert len(findings("PRM005", node(load_it) + server, **misspelt)) == 1
    assert len(findings("PRM005", node(load_it), **{"config/p.yaml": yaml})) == 1


REWRITTEN = """\
from launch import LaunchDescription
from launch_ros.actions import Node
from launch_ros.substitutions import FindPackageShare
from nav2_common.launch import RewrittenYaml
FILE = [FindPackageShare('robot'), '/config/p.yaml']

def generate_launch_description():
    return LaunchDescription([
        Node(package='robot', executable='talker', namespace='left', parameters=[
            RewrittenYaml(FILE, {%s}, %s)
        ])
    ])
"""


def test_a_file_that_the_launch_rewrites_is_judged_as_it_is_then(findings):
    def told(code: str, yaml: str, rewrites: str = "", more: str = "root_key='left'") -> list[Finding]:
        files = {"config/p.yaml": yaml, "launch/more.launch.py": REWRITTEN % (rewrites, more)}
        return findings(code, **files)

    yaml = "talker:\n  ros__parameters:\n    rate: 1.0\n"
    assert told("PRM005", yaml) == []  # '/talker' in the file, '/left/talker' in the one that the launch makes
    assert told("PRM002", yaml) == []
    assert told("PRM002", yaml, "'rate': '2.5'", "root_key='left', convert_types=True") == []
    (found,) = told("PRM002", yaml, "'rate': '2.5'")  # without convert_types a text stays one
    assert (found.place.file, found.place.line) == ("launch/more.launch.py", 10)
    (found,) = told("PRM004", yaml.replace("rate", "rat"))
    assert (found.place.file, found.place.line) == ("config/p.yaml", 3)
    assert told("PRM004", yaml.replace("rate", "rat"), more="root_key='right'") == []
    (found,) = told("PRM004", yaml, "'talker.ros__parameters.rat': '1'")
    assert found.place.file == "launch/more.launch.py"
    assert told("PRM004", yaml, "'/**.ros__parameters.rat': '1'") == []


@pytest.mark.parametrize(
    ("around", "given", "told"),
    [
        ("", "", 1),
        ("", '<arg name="camera" value="front"/>', 1),
        ("", '<arg name="params" value="$(find-pkg-share robot)/config/p.yaml"/>', 0),
        ("", '<arg name="folder" value="$(find-pkg-share robot)/config"/>', 0),
        ("", '<arg name="params" value="$(env PARAMS)"/>', 0),
        ('<arg name="params" default="$(find-pkg-share robot)/config/p.yaml"/>', "", 0),
    ],
)
def test_an_include_that_is_not_here_and_a_file_that_it_is_or_is_not_given(findings, around, given, told):
    load_it = '<param from="$(find-pkg-share robot)/config/p.yaml"/>'
    files = {"config/p.yaml": "tlaker: {ros__parameters: {rate: 1.0}}"}
    include = f'<include file="$(find-pkg-share zed_wrapper)/launch/zed.launch.py">{given}</include>'
    assert len(findings("PRM005", around + node(load_it) + include, **files)) == told


def test_an_include_of_a_file_that_is_not_known_may_load_anything(findings):
    load_it = '<param from="$(find-pkg-share robot)/config/p.yaml"/>'
    files = {"config/p.yaml": "tlaker: {ros__parameters: {rate: 1.0}}"}
    assert findings("PRM005", node(load_it) + '<include file="$(env MORE)"/>', **files) == []


def test_a_section_for_a_node_that_other_arguments_start(findings):
    load_it = '<param from="$(find-pkg-share robot)/config/p.yaml"/>'
    yaml = "talker: {ros__parameters: {rate: 1.0}}\nother: {ros__parameters: {rate: 1.0}}"
    other = '<arg name="more" default="false"/>' + node(load_it, name="other", **{"if": "$(var more)"})
    assert findings("PRM005", node(load_it) + other, **{"config/p.yaml": yaml}) == []


@pytest.mark.parametrize(
    "second",
    [
        "if not self.has_parameter('rate'):\n            self.declare_parameter('rate', 2.0)",
        "try:\n            self.declare_parameter('rate', 2.0)\n        except Exception:\n            pass",
        "self.undeclare_parameter('rate')\n        self.declare_parameter('rate', 2.0)",
    ],
)
def test_declarations_that_ask_first(findings, second):
    text = TALKER.replace("        self.create_publisher", f"        {second}\n        self.create_publisher")
    assert findings("PRM008", **{"robot/talker.py": text}) == []


def test_reads_that_may_find_nothing(findings):
    text = TALKER.replace(
        "        self.create_publisher",
        "        if self.has_parameter('other'):\n            self.get_parameter('other')\n"
        "        self.get_parameter_or('third')\n        self.get_parameter('use_sim_time')\n"
        "        self.create_publisher",
    )
    assert findings("PRM003", **{"robot/talker.py": text}) == []


def test_a_parameter_that_nobody_reads(findings):
    (found,) = findings("PRM006")
    assert found.message == "parameter 'rate' is declared but never read"


@pytest.mark.parametrize(
    "declaration",
    [
        "for name in ['rate', 'other']:\n            self.declare_parameter(name, 1.0)",
        "self.port = find_port()\n        self.declare_parameter('rate', self.port)",
    ],
)
def test_declarations_that_say_nothing_of_who_reads(findings, declaration):
    text = TALKER.replace("self.declare_parameter('rate', 1.0)", declaration)
    assert findings("PRM006", **{"robot/talker.py": text}) == []


@pytest.mark.parametrize(("first", "told"), [("from robot.talker import Talker", 0), ("import math", 1)])
def test_a_parameter_that_a_subclass_in_another_file_reads(findings, first, told):
    reader = f"{first}\n\ndef rate_of(node):\n    return node.get_parameter('rate').value\n"
    assert len(findings("PRM006", **{"robot/reader.py": reader})) == told


# -------------------------------------------------------------------------------------------------- packages


@pytest.mark.parametrize(
    ("entries", "message", "help"),
    [
        ("'talker == robot.talker:main'", "it has '==' for '='", "write 'talker = robot.talker:main'"),
        (
            "'talker = robot.talker:main' 'other = robot.talker:main'",
            "a comma is missing between 'talker' and 'other'; newer setuptools stop the build here",
            "write 'talker = robot.talker:main',",
        ),
    ],
)
def test_an_entry_that_is_not_of_the_form_is_told_once(findings, entries, message, help):
    setup = SETUP.replace("'talker = robot.talker:main'", entries)
    (found,) = findings("PKG002", **{"setup.py": setup})
    assert found.message == f"this entry does not install an executable 'talker': {message}"
    assert (found.help, found.place.line) == (help, 6)
    assert findings("LCH001", node(exec="talker"), **{"setup.py": setup}) == []
    assert findings("LCH001", node(exec="listener"), **{"setup.py": setup}) != []


@pytest.mark.parametrize(
    ("target", "what"),
    [
        ("robot.talker", "'robot.talker' is a module, and the entry names no function in it"),
        ("robot.talker.main", "module 'robot.talker.main' does not exist; did you mean 'robot.talker:main'?"),
    ],
)
def test_an_entry_without_a_function(findings, target, what):
    (found,) = findings("PKG002", **{"setup.py": SETUP.replace("robot.talker:main", target)})
    assert found.message == f"the executable 'talker' cannot start: {what}"


def test_an_entry_without_a_function_for_a_module_that_runs_when_it_is_imported(findings):
    files = {"setup.py": SETUP.replace("robot.talker:main", "robot.talker"), "robot/talker.py": TALKER + "\nmain()\n"}
    assert findings("PKG002", **files) == []


def test_a_setup_py_that_nobody_runs_breaks_nothing(findings):
    files = {"CMakeLists.txt": "project(robot)\n" + SCRIPTS, "package.xml": CMAKE}
    assert findings("PKG002", **files, **{"setup.py": SETUP.replace("robot.talker", "robot.gone")}) == []


def test_entry_points_of_other_distributions(findings):
    setup = SETUP.replace("'talker = robot.talker:main'", "'talker = robot.talker:main', 'serve = uvicorn.main:run'")
    assert findings("PKG002", **{"setup.py": setup}) == []


def test_a_module_beside_the_python_package_is_not_in_it(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    setup = SETUP.replace("robot.talker:main", "robot.scripts.talker:main")
    texts = {"robot/__init__.py": "", "robot/driver.py": TALKER, "scripts/talker.py": TALKER, "setup.py": setup}
    texts["package.xml"] = MANIFEST.format(name="robot", type="ament_python", more="")
    for name, text in texts.items():  # scripts/talker.py ends like the module's name only with the package's folder
        (tmp_path / "src/robot" / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / "src/robot" / name).write_text(text)
    (tmp_path / "archlint.toml").write_text('select = ["PKG002"]')
    (found,) = check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings
    assert "module 'robot.scripts.talker' does not exist" in found.message


def test_a_file_that_is_missing_beside_the_launch_file_says_where_it_is_looked_for(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    include = """<launch><include file="$(dirname)/gone.launch.xml"/></launch>"""
    texts = {"setup.py": SETUP, "robot/talker.py": TALKER, "launch/it.launch.xml": include}
    texts["package.xml"] = MANIFEST.format(name="robot", type="ament_python", more="")
    for name, text in texts.items():
        (tmp_path / "src/robot" / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / "src/robot" / name).write_text(text)
    (tmp_path / "archlint.toml").write_text('select = ["LCH004"]')
    (found,) = check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings
    assert found.message == "package 'robot' has no launch file 'launch/gone.launch.xml'"
    assert "relative to the installed folder of this launch file" in found.help


def test_a_module_that_gitignore_hides_is_there(findings):
    files = {"setup.py": SETUP.replace("robot.talker", "robot.bags"), ".gitignore": "bags*\n", "robot/bags.py": TALKER}
    assert findings("PKG002", **files) == []
    (found,) = findings("PKG002", **files | {"setup.py": SETUP.replace("robot.talker", "robot.boxes")})
    assert "'robot.boxes' does not exist" in found.message


@pytest.mark.parametrize(
    ("needs", "circles"),
    [
        ("<exec_depend>arm</exec_depend>", 1),
        ('<exec_depend condition="$ROS_VERSION == 1">arm</exec_depend>', 0),
        ('<exec_depend condition="$BUILD == hardware">arm</exec_depend>', 0),  # only the machine that builds knows
        ("<test_depend>arm</test_depend>", 0),
    ],
)
def test_what_makes_a_circle(tmp_path, monkeypatch, needs, circles):
    monkeypatch.chdir(tmp_path)
    for name, more in (("robot", needs), ("arm", "<exec_depend>robot</exec_depend>")):
        (tmp_path / name).mkdir()
        manifest = MANIFEST.format(name=name, type="ament_python", more=more)
        (tmp_path / name / "package.xml").write_text(manifest, encoding="utf-8")
    (tmp_path / "robot" / "talker.py").write_text(TALKER, encoding="utf-8")
    (tmp_path / "archlint.toml").write_text('select = ["PKG003"]', encoding="utf-8")
    assert len(check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings) == circles


# ------------------------------------------------------------------------------------------------------ GRF002

STARTS = """
from launch import LaunchDescription
from launch_ros.actions import Node

PACKAGE = 'robot'

def generate_launch_description():
    talker = Node(package=PACKAGE, executable='talker')
    return LaunchDescription([])
"""


@pytest.mark.parametrize(
    ("name", "text", "told"),
    [
        ("launch/more.launch.py", STARTS.replace("'talker'", "'listener'"), True),
        ("launch/more.launch.py", STARTS, False),  # under some condition it may well be returned
        ("launch/more.launch.py", STARTS.replace("'robot'", "'other'"), True),
        (
            "launch/more.launch.py",
            "import os\n\ndef generate_launch_description():\n    os.system(\"xterm -e 'ros2 run robot talker'\")\n",
            False,
        ),
        ("robot/actions.py", STARTS.replace("def generate_launch_description", "def actions"), False),
        ("robot/words.py", "NAMES = ['talker']\n", True),
    ],
)
def test_a_node_that_no_launch_file_speaks_of(findings, name: str, text: str, told: bool):
    assert bool(findings("GRF002", **{name: text})) is told


# --------------------------------------------------------------------------------------- the workspace is closed

LONELY = """
import rclpy
{imports}

class Talker({base}):
    def __init__(self):
        super().__init__('talker')
        self.create_subscription(String, 'heard', print, 10)

def main():
    rclpy.init()
    rclpy.spin(Talker())
"""


@pytest.mark.parametrize(
    ("imports", "base", "told"),
    [
        ("from rclpy.node import Node", "Node", True),
        ("from nav2_simple_commander.robot_navigator import BasicNavigator", "BasicNavigator", False),
    ],
)
def test_what_a_base_class_from_elsewhere_publishes_is_not_known(findings, imports: str, base: str, told: bool):
    text = LONELY.format(imports=f"{imports}\nfrom std_msgs.msg import String", base=base)
    closed = "select = ['TOP003']\nclosed-world = true\n"
    assert bool(findings("TOP003", node(), **{"robot/talker.py": text, "archlint.toml": closed})) is told


def test_a_node_action_without_a_package_needs_none(findings):
    assert findings("PKG001", '<node pkg="" exec="talker"/>') == []


@pytest.mark.parametrize(
    ("target", "words"),
    [
        ("robot.tlker", "module 'robot.tlker' does not exist; did you mean 'robot.talker'?"),
        ("robot.b", "module 'robot.b' does not exist"),
        ("robt.talker", "module 'robt.talker' does not exist; did you mean 'robot.talker'?"),
    ],
)
def test_a_module_that_is_not_there_is_named_with_the_near_one(findings, target, words):
    (found,) = findings("PKG002", **{"setup.py": SETUP.replace("robot.talker:", f"{target}:"), "robot/a.py": ""})
    assert found.message.endswith(f": {words}")


# ------------------------------------------------------------------------------------------------ LCH008

ASKED = """\
from launch import Condition, LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.conditions import IfCondition
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node
from elsewhere import unknown

def is_real(context):
    return True

def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument('x', default_value='true'),
        Node(package='robot', executable='talker', condition={condition}),
    ])
"""


@pytest.mark.parametrize(
    ("condition", "what", "wrap"),
    [
        ("'true'", "the text 'true'", "IfCondition"),
        ("True", "the value True", "IfCondition"),
        ("LaunchConfiguration('x')", "a LaunchConfiguration", "IfCondition"),
        ("[LaunchConfiguration('x')]", "a list", "IfCondition"),
        ("lambda context: True", "a lambda", "Condition(predicate"),
        ("is_real", "the function 'is_real'", "Condition(predicate"),
    ],
)
def test_what_is_no_condition(findings, condition, what, wrap):
    (one,) = findings("LCH008", **{"launch/it.launch.py": ASKED.format(condition=condition)})
    assert one.message == f"condition= of this Node is {what}, which is not a Condition"
    assert (one.place.file, one.place.line) == ("launch/it.launch.py", 14)
    assert wrap in (one.help or "")


@pytest.mark.parametrize(
    "condition",
    [
        "None",
        "IfCondition('true')",
        "Condition(predicate=is_real)",
        "IfCondition(LaunchConfiguration('x'))",
        "unknown()",
    ],
)
def test_what_is_a_condition_or_may_be_one(findings, condition):
    assert findings("LCH008", **{"launch/it.launch.py": ASKED.format(condition=condition)}) == []


NAMED = """\
from launch import LaunchDescription
from launch_ros.actions import Node
{above}
def generate_launch_description():
    {line}
    return LaunchDescription([Node(package='robot', executable='gone', {argument})])
"""


@pytest.mark.parametrize(
    ("above", "line", "argument", "at"),
    [
        ("", "pass", "output=output", 6),
        ("", "rate = rate_of(3)", "output='log'", 5),
        ("rate = RATE", "pass", "output='log'", 3),
        ("", "import os", "output=os.environ.get(OUTPUT)", 6),
    ],
)
def test_a_name_that_nothing_defines_stops_the_launch(findings, above, line, argument, at):
    files = {"launch/it.launch.py": NAMED.format(above=above, line=line, argument=argument)}
    (one,) = findings("LCH008", **files)
    assert one.message.endswith("is not defined: this launch file stops with a NameError before it starts anything")
    assert (one.place.file, one.place.line) == ("launch/it.launch.py", at)
    assert findings("LCH001", **files) == []  # it never comes to that node


@pytest.mark.parametrize(
    ("above", "line", "argument"),
    [
        ("output = 'log'", "pass", "output=output"),
        ("from shared import *", "pass", "output=output"),
        ("", "global output; output = 'log'", "output=output"),
        ("def setup(output): pass", "pass", "output=str(output)"),  # bound elsewhere: let Python say it
        ("", "output = [name for name in ('log',)][0]", "output=output"),
        ("", "for output in ('log',): pass", "output=output"),
        ("", "output: str = __file__", "output=output or other"),
        ("", "with open('x') as output: pass", "output=output"),
        ("", "(output := 'log')", "output=(lambda: later)() if False else output"),
        ("import os.path", "if os.path.exists('x'): return None", "output=output"),
    ],
)
def test_a_name_that_is_defined_or_may_be(findings, above, line, argument):
    files = {"launch/it.launch.py": NAMED.format(above=above, line=line, argument=argument)}
    assert findings("LCH008", **files) == []


# ------------------------------------------------------------------------------------------------ NME004


@pytest.mark.parametrize(
    ("package", "executable", "told"),
    [("gazebo_ros", "spawn_entity.py", 0), ("ros_gz_sim", "create", 0), ("rviz2", "rviz2", 1), ("robot", "create", 1)],
)
def test_tools_that_end_by_themselves_share_no_name_for_long(findings, package: str, executable: str, told: int):
    tools = [node(pkg=package, exec=executable, name="it", args=f"-x {number}") for number in (1, 2)]
    assert len(findings("NME004", "\n".join(tools))) == told


READ = """\

def read():
    node = rclpy.create_node('params')
    node.declare_parameter('car', 'a')
    {line}
    return node.get_parameter('car').value

def main():
    rclpy.init()
    read()
    rclpy.spin(Talker())
"""


@pytest.mark.parametrize(
    ("line", "clashes"),
    [
        ("pass", 0),
        ("rclpy.spin_once(node)", 0),
        ("kept.append(node)", 1),
        ("return node", 1),
        ("return lambda: node.get_name()", 1),
        ("node.create_timer(1.0, print)", 1),  # its callback may hold the node
        ("main.node = node", 1),
    ],
)
def test_a_node_that_is_freed_before_the_next_is_made(findings, line, clashes):
    before, _, _ = TALKER.partition("\ndef main")
    text = before + "\nkept = []\n" + READ.format(line=line)
    assert len(findings("NME004", node(name="it"), **{"robot/talker.py": text})) == clashes


def test_a_helper_node_that_is_made_beside_the_other(findings):
    before, _, _ = TALKER.partition("\ndef main")
    text = before + READ.format(line="pass").replace("    read()\n", "    it = Talker()\n    read()\n")
    text = text.replace("spin(Talker())", "spin(it)")
    assert len(findings("NME004", node(name="it"), **{"robot/talker.py": text})) == 1


def test_two_launch_actions_are_one_finding_with_all_names(findings):
    before, _, _ = TALKER.partition("\ndef main")
    main = "\ndef main():\n    rclpy.init()\n    helper = rclpy.create_node('params')\n    rclpy.spin(Talker())\n"
    files = {"robot/talker.py": before + main}
    (found,) = findings("NME004", f"{node()}\n{node()}", **files)
    assert found.message == "two launch actions start nodes with the same names: /params, /talker"
    assert found.help == "give each action its own namespace: name= would rename all its nodes"
    assert findings("NME004", f"{node()}\n{node(namespace='b')}", **files) == []  # the advice works
    (sole,) = findings("NME004", f"{node()}\n{node()}")
    assert (sole.message, "its own name or namespace" in sole.help) == (
        "two nodes of this system have the name '/talker'",
        True,
    )


TWO = """\
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.conditions import IfCondition, UnlessCondition
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node
from somewhere.launch import AsBool

def generate_launch_description():
    real = IfCondition(LaunchConfiguration('real'))
    return LaunchDescription([
        DeclareLaunchArgument('real'),
        Node(package='robot', executable='talker', condition={first}),
        Node(package='robot', executable='talker', condition={second}),
    ])
"""


@pytest.mark.parametrize(
    ("first", "second", "clash"),
    [
        ("None", "real", True),
        ("real", "real", True),
        ("IfCondition(AsBool('x'))", "IfCondition(AsBool('x'))", True),
        ("real", "UnlessCondition(LaunchConfiguration('real'))", False),
        ("IfCondition(AsBool('x'))", "UnlessCondition(AsBool('x'))", False),
        ("IfCondition(AsBool('x'))", "IfCondition(AsBool('y'))", False),
        ("None", "IfCondition(AsBool('x'))", False),  # which may never hold
    ],
)
def test_nodes_of_one_name_clash_where_they_run_together(findings, first, second, clash):
    found = findings("NME004", **{"launch/it.launch.py": TWO.format(first=first, second=second)})
    assert [one.place.line for one in found] == ([13] if clash else [])


def test_one_entry_of_a_list_that_nobody_reads(findings):
    text = TALKER.replace(
        "self.declare_parameter('rate', 1.0)",
        "self.declare_parameters('', [\n            ('rate', 1.0),\n            ('name', 'a'),\n        ])\n"
        "        self.declare_parameters('arm', [('speed', 1.0), ('reach', 2.0)])\n"
        "        self.get_parameter('name'), self.get_parameter('arm.reach')",
    )
    found = findings("PRM006", **{"robot/talker.py": text})
    assert [(one.place.line, one.message) for one in found] == [
        (9, "parameter 'rate' is declared but never read"),
        (12, "parameter 'arm.speed' is declared but never read"),
    ]


HELPER = """
    def p(self, name):
        return self.get_parameter(name).value

    def again(self, name='rat'):
        return self.p(name)

def of(node, name):
    return node.get_parameter(name).get_parameter_value().double_value

NAME = 'constant'
"""


@pytest.mark.parametrize(
    ("lines", "told"),
    [
        (["self.p('rate')", "self.p('rat')", "self.p('speed')", "self.p(name='a')"], {2: "rat", 3: "speed", 4: "a"}),
        (["self.rate, self.kind = of(self, 'rate'), of(self, 'kind')"], {1: "kind"}),
        (["self.p('on_start')", "self.create_timer(1.0, lambda: self.p('on_timer'))"], {1: "on_start", 2: "on_timer"}),
        (["self.all = [self.p(n) for n in ('rate', 'one', 'two')]"], {1: "one"}),
        (["if self.has_parameter('rat'):", "    self.p('rat')"], {}),
        (["try:", "    self.p('rat')", "except Exception:", "    pass"], {}),
        (["self.p(NAME)", "self.get_parameter(NAME)"], {1: "constant", 2: "constant"}),
        (["self.p(input())"], {}),
        (["self.get_parameters(['rate', 'rat'])", "self.get_parameters([", "    'speed'])"], {1: "rat", 3: "speed"}),
        (["self.get_parameters(['rate'])", "self.get_parameters(input())", "self.get_parameters([NAME])"], {}),
        (["try:", "    self.get_parameters(['rat'])", "except Exception:", "    pass"], {}),
    ],
)
def test_names_that_a_helper_reads(findings, lines, told):
    body = "".join(f"        {line}\n" for line in lines)
    text = TALKER.replace("        self.create_publisher", body + "        self.create_publisher")
    text = text.replace("\ndef main", HELPER + "\ndef main")
    found = findings("PRM003", **{"robot/talker.py": text})
    assert {one.place.line - 8: one.identity[1] for one in reversed(found)} == told


# ------------------------------------------------------------------------------------- NME002, OWN003

XML = """
<push_ros_namespace namespace="a-b"/>
<node pkg="robot" exec="talker" name="my-talker" namespace="/ro bot">
  <remap from="chatter" to="1st"/>
</node>
<node pkg="elsewhere" exec="other" name="2nd"/>
<node pkg="elsewhere" exec="other" name="third"/>"""
YAML = """\
launch:
- node:
    pkg: robot
    exec: talker
    name: my-talker
    remap:
    - {from: chatter, to: good}
    - from: other
      to: not good
"""


def told(found: list[Finding]) -> list[tuple[str, int, str]]:
    """File, line and what was rejected."""
    return [(one.place.file, one.place.line, one.message.partition(":")[0]) for one in found]


def test_each_bad_name_of_a_launch_file_is_told_where_it_is_given(findings):
    found = findings("NME002", XML)
    assert told(found) == [
        ("launch/it.launch.xml", 3, "ROS rejects the name of the node 'my-talker'"),
        ("launch/it.launch.xml", 3, "ROS rejects the namespace '/ro bot'"),
        ("launch/it.launch.xml", 4, "ROS rejects the name '1st', the target of this remapping"),
        ("launch/it.launch.xml", 6, "ROS rejects the namespace '/a-b'"),
        ("launch/it.launch.xml", 6, "ROS rejects the name of the node '2nd'"),
    ]
    assert [one.place.line for one in found[3].related] == [7]  # the namespace is pushed once, for both


def test_bad_names_in_yaml_and_python(findings):
    found = findings("NME002", **{"launch/two.launch.yaml": YAML})
    assert told(found) == [
        ("launch/two.launch.yaml", 5, "ROS rejects the name of the node 'my-talker'"),
        ("launch/two.launch.yaml", 8, "ROS rejects the name 'not good', the target of this remapping"),
    ]
    code = TWO.format(first="None, name='my-talker'", second="None, name=LaunchConfiguration('real')")
    (one,) = findings("NME002", **{"launch/two.launch.yaml": "", "launch/it.launch.py": code})
    assert told([one]) == [("launch/it.launch.py", 12, "ROS rejects the name of the node 'my-talker'")]


ROUNDS = """\
from launch import LaunchDescription
from launch.actions import GroupAction
from launch_ros.actions import Node, PushRosNamespace

def generate_launch_description():
    nodes = []
    for name in ('{one}', '{other}'):
        nodes.append(GroupAction([PushRosNamespace('{root}'), Node(
            package='robot', executable='talker', namespace=name)]))
    return LaunchDescription(nodes)
"""


def test_the_rounds_of_a_loop_are_one_bad_name(findings):
    (one,) = findings("NME002", **{"launch/it.launch.py": ROUNDS.format(root="/", one="2d", other="3d")})
    assert told([one]) == [("launch/it.launch.py", 9, "ROS rejects the namespace '/2d'")]
    assert ["'/3d'" in related.message for related in one.related] == [True]
    assert findings("NME002", **{"launch/it.launch.py": ROUNDS.format(root="/", one="left", other="right")}) == []


def test_a_name_that_launch_files_replace_is_judged_as_they_give_it(findings):
    bad = {"robot/talker.py": TALKER.replace("'talker'", "'my-talker'")}
    assert findings("NME002", node(name="good"), **bad) == []
    (one,) = findings("NME002", node(), **bad)
    assert (one.place.file, one.place.line) == ("robot/talker.py", 7)


@pytest.mark.parametrize(
    ("owner", "launch", "clash"),
    [
        ("/left", node(name="left"), False),
        ("/talker", node(name="left"), True),
        ("/talker", node('<remap from="chatter" to="words"/>', name="left"), False),
        ("/talker", "", False),
    ],
)
def test_who_publishes_is_who_is_launched(findings, owner, launch, clash):
    config = {"archlint.toml": f'select = ["OWN003"]\n[owners]\n"/chatter" = "{owner}"\n'}
    assert [one.node for one in findings("OWN003", launch, **config)] == (["/left"] if clash else [])


def test_a_name_that_waits_for_an_argument_is_not_bad(findings):
    """Without a value for ``robot`` nothing works, and nobody starts it so."""
    text = '<arg name="robot" default="{}"/><node pkg="robot" exec="talker"><remap from="{}" to="pose"/></node>'
    assert findings("NME002", text.format("", "/model/$(var robot)/pose")) == []
    (one,) = findings("NME002", text.format("", "/model/2d/pose"))
    assert "2d" in one.message
    assert len(findings("NME002", text.format("a", "/model//pose"))) == 1


# ------------------------------------------------------------------------------------- LCH003, one cause


def test_a_file_that_takes_no_argument_is_told_once_for_all_that_hand_it_over(findings):
    inner = {"launch/inner.launch.xml": '<launch><arg name="speed" default="1"/></launch>'}
    include = '<include file="$(find-pkg-share robot)/launch/inner.launch.xml"><arg name="gain" value="1"/></include>'
    files = {f"launch/{name}.launch.xml": f"<launch>{include}</launch>" for name in ("first", "second", "third")}
    (one,) = findings("LCH003", **inner, **files)
    assert one.place.file == "launch/first.launch.xml"
    assert [related.place.file for related in one.related] == ["launch/second.launch.xml", "launch/third.launch.xml"]
    assert one.severity.label == "warning"


def test_use_sim_time_handed_over_as_a_matter_of_course_is_information(findings):
    inner = {"launch/inner.launch.xml": '<launch><arg name="speed" default="1"/></launch>'}
    given = '<arg name="use_sim_time" value="false"/>'
    outer = f'<include file="$(find-pkg-share robot)/launch/inner.launch.xml">{given}</include>'
    (one,) = findings("LCH003", outer, **inner)
    assert one.severity.label == "info"


# --------------------------------------------------------------------------------- TOP004, the namespace

HEARER = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String

class Hearer(Node):
    def __init__(self):
        super().__init__('hearer')
        self.create_subscription(String, 'chatter', print, 10)

def main():
    rclpy.init()
    rclpy.spin(Hearer())
"""
TWO_NODES = {
    "setup.py": SETUP.replace("robot.talker:main'", "robot.talker:main', 'hearer = robot.hearer:main'"),
    "robot/hearer.py": HEARER,
}
IN_NAMESPACE = """\
import sys
from launch import LaunchDescription
from launch_ros.actions import Node

def generate_launch_description():
    namespace = 'left'
    for word in WORDS:
        if word.startswith('namespace:='):
            namespace = word.split(':=')[1]
    return LaunchDescription([
        Node(package='robot', executable='talker', namespace=namespace),
        Node(package='robot', executable='hearer'),
    ])
"""


def test_one_name_in_two_namespaces(findings):
    (found,) = findings("TOP004", node(namespace="left") + node(exec="hearer"), **TWO_NODES)
    assert found.message.endswith("; both write 'chatter'")
    assert found.help == "give /hearer and /left/talker the same namespace in the launch file"
    assert findings("TOP004", node(namespace="left") + node(exec="hearer", namespace="left"), **TWO_NODES) == []


def test_one_name_that_the_launch_file_remaps_at_one_end(findings):
    remapped = node('<remap from="chatter" to="chater"/>')
    (found,) = findings("TOP004", remapped + node(exec="hearer"), **TWO_NODES)
    assert found.help == "use the same name at both ends, or remap one in the launch file"


@pytest.mark.parametrize(("words", "told"), [("sys.argv", 0), ("['verbose:=true']", 1)])
def test_a_namespace_from_the_command_line_is_not_known(findings, words, told):
    launch = {"launch/it.launch.xml": "<launch/>", "launch/two.launch.py": IN_NAMESPACE.replace("WORDS", words)}
    assert len(findings("TOP004", **TWO_NODES, **launch)) == told


# ------------------------------------------------------------------------- NME001, in a launch file's namespace


def absolute(*names: str) -> dict[str, str]:
    """The talker with a publisher for each name."""
    lines = "".join(f"        self.create_publisher(String, '{name}', 10)\n" for name in names)
    return {"robot/talker.py": TALKER.replace("        self.create_publisher(String, 'chatter', 10)\n", lines)}


@pytest.mark.parametrize(
    ("names", "namespaces", "help"),
    [
        (["/left/words"], ["left"], "write 'words': the launch file starts the node in '/left'"),
        (
            ["/words"],
            ["left"],
            "write 'words', to which the node's namespace applies, or take the name from a parameter",
        ),
        (
            ["/left/words"],
            [""],
            "write 'left/words', to which the node's namespace applies, or take the name from a parameter",
        ),
        (["/lefty/words"], ["left"], "write 'lefty/words', to which"),
        (["/left/words"], ["left", ""], "take the name from a parameter: self.declare_parameter('words_name'"),
        (
            ["/left/words", "/left/more"],
            ["left"],
            "remove '/left/', the namespace in which the launch file starts the node",
        ),
        (
            ["/left/words", "/arm/state"],
            ["left"],
            "remove '/left/', the namespace in which the launch file starts the node, "
            "and take the other names from parameters",
        ),
        (["/left/words", "/arm/state"], ["left", "right"], "take the names from parameters"),
        (["/words", "/state"], ["left", "right"], "remove the leading '/'"),
    ],
)
def test_the_name_to_write_in_the_namespace_that_the_launch_file_gives(findings, names, namespaces, help):
    launch = "".join(node(**({"namespace": one} if one else {})) for one in namespaces)
    (found,) = findings("NME001", launch, **absolute(*names))
    assert found.help is not None and found.help.startswith(help)


def test_the_namespace_that_an_including_file_gives(findings):
    include = '<include file="$(find-pkg-share robot)/launch/it.launch.xml"/>'
    outer = f'<launch><group><push-ros-namespace namespace="left"/>{include}</group></launch>'
    files = {"launch/all.launch.xml": outer, **absolute("/left/words")}
    (found,) = findings("NME001", node(), **files)
    assert found.help == "write 'words': the launch file starts the node in '/left'"


HANDED = """\

def make():
    node = rclpy.create_node('params')
    node.declare_parameter('car', 'a')
    return node

def ask(node, name, other=None):
    {line}
    return node.get_parameter(name).value

def read():
    node = make()
    return ask(node, 'car')

def main():
    rclpy.init()
    car = read()
    rclpy.spin(Talker())
"""


@pytest.mark.parametrize(
    ("line", "clashes"),
    [
        ("pass", 0),
        ("node.get_logger().info(name)", 0),
        ("kept.append(node)", 1),
        ("ask.node = node", 1),
        ("other = node", 1),
    ],
)
def test_a_node_that_a_helper_makes_and_another_is_lent(findings, line, clashes):
    before, _, _ = TALKER.partition("\ndef main")
    text = before + "\nkept = []\n" + HANDED.format(line=line)
    assert len(findings("NME004", node(name="it"), **{"robot/talker.py": text})) == clashes


def test_a_node_that_a_helper_makes_and_main_keeps(findings):
    before, _, _ = TALKER.partition("\ndef main")
    text = before + HANDED.format(line="pass").replace("car = read()", "asker = make()")
    assert len(findings("NME004", node(name="it"), **{"robot/talker.py": text})) == 1


DECLARATIVE = """\
import rclpy
from rclpy.node import Node

class Field:
    def __init__(self, default):
        self.default = default

    def start(self, node):
        node.declare_parameter(self.name, self.default)

class Talker(Node):
    speed = Field(1.0)

    def __init__(self):
        super().__init__('talker')
        self.declare_parameter('rate', 1.0)

def main():
    rclpy.init()
    rclpy.spin(Talker())
"""


def test_what_declares_parameters_on_a_node_that_is_not_known_may_do_so_on_this_one(findings):
    """Also where the program runs again with the parameters of the launch file, of which one decides a name."""
    given = node('<param name="rate" value="2.0"/><param name="speed" value="2.0"/>')
    fields, talker = DECLARATIVE.split("class Talker(Node)")
    talker = "from robot.fields import Field\nimport rclpy\nfrom rclpy.node import Node\n\nclass Talker(Node)" + talker
    named = talker.replace(
        "('rate', 1.0)", "('rate', 1.0)\n        self.create_timer(self.get_parameter('rate').value, print)"
    )
    for text in (talker, named):
        assert findings("PRM004", given, **{"robot/talker.py": text, "robot/fields.py": fields}) == []
        plain = text.replace("    speed = Field(1.0)\n", "").replace("import Field", "import rclpy")
        (found,) = findings("PRM004", given, **{"robot/talker.py": plain, "robot/fields.py": fields})
        assert "'speed'" in found.message


PERFORMED = """\
from launch import LaunchContext, LaunchDescription
from launch.actions import DeclareLaunchArgument, LogInfo, OpaqueFunction
from launch.substitutions import LaunchConfiguration, PathJoinSubstitution, TextSubstitution
from launch_ros.actions import Node
from launch_ros.substitutions import FindPackageShare
import os

def start(context, *given):
    text = LaunchConfiguration('kind').perform(context)
    return [Node(package='robot', executable='talker', name=text)]

def generate_launch_description():
    kind = LaunchConfiguration('kind')
    {line}
    return LaunchDescription([
        DeclareLaunchArgument('kind', default_value='small'), OpaqueFunction(function=start), LogInfo(msg=kind),
    ])
"""


@pytest.mark.parametrize(
    ("line", "said"),
    [
        ("text = kind.perform({})", "LaunchConfiguration is called with a dict, which is not the launch context"),
        ("text = f'{kind.perform(None)}.urdf'", "LaunchConfiguration is called with None, which"),
        ("text = PathJoinSubstitution(['a', kind]).perform({})", "PathJoinSubstitution is called with a dict"),
        ("text = kind.perform(LaunchContext())", "a new LaunchContext, in which no launch argument has a value"),
    ],
)
def test_a_substitution_that_is_performed_without_the_launch_context(findings, line, said):
    launch = {"launch/it.launch.py": PERFORMED.format(line=line)}
    (one,) = findings("LCH008", **launch)
    assert said in one.message and one.place.line == 14 and one.severity is Severity.ERROR
    assert findings("LCH003", **launch) == []  # a declaration in front would mend nothing


@pytest.mark.parametrize(
    "line",
    [
        "text = FindPackageShare('robot').perform(LaunchContext())",
        "text = LaunchConfiguration('kind', default='a').perform(LaunchContext())",
        "text = TextSubstitution(text='a').perform({})",
        "text = kind.perform({}) if os.environ.get('TRY') else ''",
        "start(None) if os.environ.get('TRY') else None",
        "text = LaunchConfiguration('other', default='a').perform(os.context)",
    ],
)
def test_a_substitution_that_is_performed_and_does_not_fail(findings, line):
    launch = {"launch/it.launch.py": PERFORMED.format(line=line)}
    assert findings("LCH008", **launch) == []
    assert findings("LCH003", **launch) == []


def test_conditions_of_one_kind_in_a_file_are_one_finding(findings):
    nodes = "Node(package='robot', executable='talker', name='{}', condition=lambda context: True)"
    text = ASKED.format(condition="lambda context: True")
    assert len(findings("LCH008", **{"launch/it.launch.py": text})) == 1
    start = text.index("Node(package")
    twice = text[:start] + nodes.format("a") + ", " + nodes.format("b") + ", " + text[start:]
    (one,) = findings("LCH008", **{"launch/it.launch.py": twice})
    assert [row.message for row in one.related] == ["here, too"] * 2

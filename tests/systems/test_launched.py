"""The systems that launch files start: final names, parameters that decide names, nodes from elsewhere."""

from __future__ import annotations

from pathlib import Path

import pytest

from archlint.config.settings import Settings
from archlint.engine.pipeline import Request, check, graph
from archlint.programs.linker import Linker
from archlint.render.json import document
from archlint.render.text import render
from archlint.systems.overrides import key_matches
from robot_package import CMAKE, SETUP, manifest, write_robot

TALKER = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String

class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.declare_parameter('topic', 'chatter')
        self.create_publisher(String, self.get_parameter('topic').value, 10)
        self.create_publisher(String, '~/state', 10)

def main():
    rclpy.init()
    rclpy.spin(Talker())
"""


@pytest.fixture
def robot(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.chdir(tmp_path)

    def write(launch: str, **files: str) -> Path:
        return write_robot(tmp_path, launch, **{"robot/talker.py": TALKER} | files)

    return write


def system(**arguments: str):
    given = tuple(arguments.items())
    return graph(
        Request((".",), Settings(), cached=False, jobs=1, launch="launch/it.launch.xml", launch_arguments=given)
    )


def topics(made) -> dict[str | None, list[str | None]]:
    return {node.name: [endpoint.name for endpoint in node.endpoints] for node in made.nodes}


def test_two_robots_share_nothing(robot):
    robot('<node pkg="robot" exec="talker" namespace="a"/><node pkg="robot" exec="talker" namespace="b"/>')
    assert topics(system()) == {
        "/a/talker": ["/a/chatter", "/a/talker/state"],
        "/b/talker": ["/b/chatter", "/b/talker/state"],
    }


def test_names_and_remappings(robot):
    robot('<node pkg="robot" exec="talker" name="alice"><remap from="chatter" to="/words"/></node>')
    assert topics(system()) == {"/alice": ["/alice/state", "/words"]}


COUNTED = TALKER.replace(
    """        self.declare_parameter('topic', 'chatter')
        self.create_publisher(String, self.get_parameter('topic').value, 10)
""",
    """        for number in range(self.declare_parameter('cameras', 0).value):
            name = self.declare_parameter(f'camera{number}', '').value
            self.create_publisher(String, f'/{name}/image', 10)
""",
)


def test_parameters_that_are_only_declared_with_the_value_of_another(robot):
    robot(
        '<node pkg="robot" exec="talker"><param name="cameras" value="2"/><param name="camera0" value="front"/>'
        '<param name="camera1" value="rear"/></node>',
        **{"robot/talker.py": COUNTED},
    )
    assert topics(system()) == {"/talker": ["/front/image", "/rear/image", "/talker/state"]}


NAMES = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String

class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.create_publisher(String, f'/status/{self.get_name()}', 10)
        self.create_publisher(String, self.get_fully_qualified_name() + '/full', 10)
        self.create_publisher(String, '/map' + self.get_namespace(), 10)

def main():
    rclpy.init()
    rclpy.spin(Talker())
"""


def test_a_node_that_asks_for_its_name_gets_the_one_of_the_launch_file(robot):
    start = '<node pkg="robot" exec="talker" {}/>'
    given = ('name="alice" namespace="a"', 'namespace="b"', 'name="$(env WHO)" namespace="c"')
    robot("".join(map(start.format, given)), **{"robot/talker.py": NAMES})
    assert topics(system()) == {
        "/a/alice": ["/a/alice/full", "/map/a", "/status/alice"],
        "/b/talker": ["/b/talker/full", "/map/b", "/status/talker"],
        None: ["/c/*/full", "/map/c", "/status/*"],
    }


def test_remappings_on_the_command_line_come_first(robot):
    robot(
        '<node pkg="robot" exec="talker" args="--ros-args -r chatter:=first"><remap from="chatter" to="second"/></node>'
    )
    assert topics(system()) == {"/talker": ["/first", "/talker/state"]}


@pytest.mark.parametrize(
    "words", ['args="--ros-args -r __node:=bob -r __ns:=/b"', 'ros_args="-r __node:=bob -r __ns:=/b"']
)
def test_a_name_among_the_arguments_comes_before_that_of_the_action(robot, words):
    robot(f'<node pkg="robot" exec="talker" name="alice" namespace="a" {words}/>')
    assert topics(system()) == {"/b/bob": ["/b/bob/state", "/b/chatter"]}


def test_parameters_decide_names(robot):
    robot('<arg name="t" default="news"/><node pkg="robot" exec="talker"><param name="topic" value="$(var t)"/></node>')
    assert "/news" in topics(system())["/talker"]
    assert "/gossip" in topics(system(t="gossip"))["/talker"]


BRANCHING = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String

class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.declare_parameter('robots', 1)
        self.create_publisher(String, 'one', 10)
        if self.get_parameter('robots').value == 2:
            self.create_publisher(String, 'two', 10)

def main():
    rclpy.init()
    rclpy.spin(Talker())
"""


@pytest.mark.parametrize(
    ("robots", "expected"),
    [
        ("3", [("/one", False)]),
        ("2", [("/one", False), ("/two", False)]),
        ("$(env ROBOTS_OF_TODAY)", [("/one", False), ("/two", True)]),
    ],
)
def test_a_parameter_that_the_launch_file_sets_decides_a_branch(robot, robots, expected):
    robot(
        f'<node pkg="robot" exec="talker"><param name="robots" value="{robots}"/></node>',
        **{"robot/talker.py": BRANCHING},
    )
    (node,) = system().nodes
    assert [(endpoint.name, endpoint.conditional) for endpoint in node.endpoints] == expected


@pytest.mark.parametrize(
    ("node", "expected"),
    [
        ("", [("/one", False)]),
        ('<param name="other" value="2"/>', [("/one", False)]),
        ('<param from="$(env HOME)/mine.yaml"/>', [("/one", False), ("/two", True)]),
        ('<param from="$(find-pkg-share robot)/config/p.yaml"/>', [("/one", False), ("/two", False)]),
    ],
    ids=["nothing is set", "another one is set", "a file that is not here", "a file that is"],
)
def test_a_parameter_that_the_launch_file_leaves_alone_has_its_default(robot, node, expected):
    robot(
        f'<node pkg="robot" exec="talker">{node}</node>',
        **{"robot/talker.py": BRANCHING, "config/p.yaml": "talker: {ros__parameters: {robots: 2}}"},
    )
    (talker,) = system().nodes
    assert [(endpoint.name, endpoint.conditional) for endpoint in talker.endpoints] == expected


def test_words_of_a_command_line_that_are_not_known_may_set_any_parameter(robot):
    robot('<node pkg="robot" exec="talker" args="$(env WORDS)"/>', **{"robot/talker.py": BRANCHING})
    (talker,) = system().nodes
    assert [(endpoint.name, endpoint.conditional) for endpoint in talker.endpoints] == [("/one", False), ("/two", True)]


@pytest.mark.parametrize(
    ("yaml", "name"),
    [
        ("talker: {ros__parameters: {topic: right}}", "/a/chatter"),
        ("/a/talker: {ros__parameters: {topic: right}}", "/a/right"),
        ("a: {talker: {ros__parameters: {topic: right}}}", "/a/right"),
        ("/**: {ros__parameters: {topic: right}}", "/a/right"),
        ("/**: {ros__parameters: {topic: wrong}}\n/a/talker: {ros__parameters: {topic: right}}", "/a/right"),
        ("/a/talker: {ros__parameters: {topic: wrong}}\n/**: {ros__parameters: {topic: right}}", "/a/right"),
        ("other: {ros__parameters: {topic: wrong}}\n---\n/a/talker: {ros__parameters: {topic: right}}", "/a/right"),
    ],
)
def test_parameter_files_reach_the_nodes_that_their_keys_match(robot, yaml, name):
    robot(
        '<node pkg="robot" exec="talker" namespace="a"><param from="$(find-pkg-share robot)/config/p.yaml"/></node>',
        **{"config/p.yaml": yaml},
    )
    assert name in topics(system())["/a/talker"]


@pytest.mark.parametrize(
    ("key", "node", "matches"),
    [
        ("/talker", "/talker", True),
        ("/talker", "/a/talker", False),
        ("/**/talker", "/a/b/talker", True),
        ("/**/talker", "/talker", True),
        ("/*/talker", "/a/talker", True),
        ("/*/talker", "/a/b/talker", False),
        ("/a/**", "/a/b/c", True),
        ("/**", None, True),
        ("/talker", None, False),
    ],
)
def test_keys_of_parameter_files(key, node, matches):
    assert key_matches(key, node) is matches


def test_nodes_from_elsewhere_are_in_the_picture(robot):
    robot('<push_ros_namespace namespace="r"/><node pkg="nav2_amcl" exec="amcl" name="amcl"/>')
    (node,) = system().nodes
    assert (node.name, node.external, node.package, node.executable) == ("/r/amcl", True, "nav2_amcl", "amcl")
    assert (node.launch_place.file, node.launched_by) == ("launch/it.launch.xml", "launch/it.launch.xml")


def test_a_remapping_to_what_nobody_knows_leaves_the_name_unknown(robot):
    robot('<arg name="to"/><node pkg="robot" exec="talker"><remap from="chatter" to="$(var to)"/></node>')
    (node,) = system().nodes
    assert [endpoint.name for endpoint in node.endpoints] == [None, "/talker/state"]


# ------------------------------------------------------------------------------------------------- judging


def findings(**options) -> list[tuple[str, str | None]]:
    from archlint.config.settings import load

    report = check(Request((".",), load(Path()), cached=False, jobs=1, **options))
    return [(finding.code, finding.system) for finding in report.findings]


TWO = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String

class Other(Node):
    def __init__(self):
        super().__init__('other')
        self.create_publisher(String, 'chatter', 10)

def main():
    rclpy.init()
    rclpy.spin(Other())
"""
TWO_SETUP = SETUP.replace("['talker =", "['other = robot.other:main', 'talker =")


def test_what_a_launch_file_keeps_apart_is_no_conflict(robot):
    together = '<node pkg="robot" exec="talker"/><node pkg="robot" exec="other" namespace="{}"/>'
    config = {"archlint.toml": 'select = ["OWN001"]', "setup.py": TWO_SETUP, "robot/other.py": TWO}
    robot(together.format("far"), **config)
    assert findings() == []
    robot(together.format("/"), **config)
    assert findings() == [("OWN001", "launch/it.launch.xml")]


def test_without_a_launch_file_the_package_is_judged_as_a_whole(robot):
    config = {"archlint.toml": 'select = ["OWN001"]\nclosed-world = true', "setup.py": TWO_SETUP, "robot/other.py": TWO}
    robot("", **config)
    assert findings() == [("OWN001", None)]


def test_opposite_conditions_never_meet(robot):
    robot(
        '<arg name="sim"/><node pkg="robot" exec="talker" if="$(var sim)"/>'
        '<node pkg="robot" exec="other" unless="$(var sim)"/>',
        **{"archlint.toml": 'select = ["OWN001", "NME004"]', "setup.py": TWO_SETUP, "robot/other.py": TWO},
    )
    assert findings() == []


def test_a_broken_launch_file_is_a_finding_and_the_rest_is_judged(robot):
    robot('<node pkg="robot" exec="taker"/>', **{"launch/broken.launch.xml": "<launch><node>"})
    codes = [code for code, _ in findings() if code in ("LNT002", "LCH001")]
    assert codes == ["LNT002", "LCH001"]


def test_findings_in_xml_and_yaml_can_be_ignored_in_place(robot):
    robot('\n<!-- archlint: ignore[LCH001] -->\n<node pkg="robot" exec="taker"/>')
    assert "LCH001" not in [code for code, _ in findings()]


def test_the_configuration_says_which_launch_files_are_systems(robot):
    two = '<node pkg="robot" exec="talker"/><node pkg="robot" exec="other"/>'
    config = {"setup.py": TWO_SETUP, "robot/other.py": TWO, "launch/other.launch.xml": f"<launch>{two}</launch>"}
    robot("", **config, **{"archlint.toml": 'select = ["OWN001"]\nlaunch = ["launch/other.launch.xml"]'})
    assert findings() == [("OWN001", "launch/other.launch.xml")]
    robot("", **config, **{"archlint.toml": 'select = ["OWN001"]\nlaunch = ["launch/it.launch.xml"]'})
    assert findings() == []


def test_ros1_launch_files_are_passed_over_with_a_word(robot):
    from archlint.config.settings import load

    robot("", **{"launch/old.launch": '<launch><node pkg="robot" type="talker" name="t"/></launch>'})
    report = check(Request((".",), load(Path()), cached=False, jobs=1))
    assert list(report.notices) == ["launch/old.launch is for ROS 1 and skipped"]


SCRIPT = TALKER.replace("def main():", "if __name__ == '__main__':")


def test_a_script_without_a_suffix_is_the_node_that_it_runs(robot):
    root = robot(
        '<node pkg="robot" exec="speak"/><node pkg="robot" exec="again"/>',
        **{
            "package.xml": CMAKE,
            "CMakeLists.txt": "install(PROGRAMS scripts/speak scripts/again DESTINATION lib/robot)",
            "scripts/speak": f"#!/usr/bin/env python3\n{SCRIPT}",
        },
    )
    (root / "scripts" / "again").symlink_to("speak")
    nodes = system().nodes
    assert [(node.name, node.executable, node.external) for node in nodes] == [
        ("/talker", "speak", False),
        ("/talker", "again", False),
    ]
    assert all("/chatter" in topics for topics in topics(system()).values())


def test_a_script_without_a_main_guard_runs_again_with_the_parameters_of_a_launch(robot):
    robot(
        '<node pkg="robot" exec="speak.py"><param name="topic" value="news"/></node>',
        **{
            "setup.py": "from setuptools import setup\nsetup(scripts=['scripts/speak.py'])",
            "scripts/speak.py": "from robot.talker import main\nmain()\n",
        },
    )
    assert topics(system()) == {"/talker": ["/news", "/talker/state"]}


def test_an_entry_point_in_a_folder_that_is_no_python_package(robot):
    robot(
        '<node pkg="robot" exec="talker"/>',
        **{
            "setup.py": "from setuptools import setup\n"
            "setup(entry_points={'console_scripts': ['talker = src.robot.speaker:main']})",
            "src/robot/__init__.py": "",
            "src/robot/speaker.py": TALKER,
        },
    )
    assert list(topics(system())) == ["/talker"]


def test_of_two_packages_with_one_name_the_nearer_one_is_started(robot):
    texts = {"package.xml": manifest(), "setup.py": SETUP}
    first = {f"first/{name}": text for name, text in {**texts, "robot/talker.py": TALKER}.items()}
    second = {f"second/{name}": text for name, text in {**texts, "robot/talker.py": TALKER}.items()}
    started = '<launch><node pkg="robot" exec="talker"/></launch>'
    root = robot("", **first, **second, **{f"{one}/launch/it.launch.xml": started for one in ("first", "second")})
    for name in ("package.xml", "setup.py", "robot/talker.py", "launch/it.launch.xml"):
        (root / name).unlink()
    for one in ("first", "second"):
        request = Request((".",), Settings(), cached=False, jobs=1, launch=f"{one}/launch/it.launch.xml")
        [node] = graph(request).nodes
        assert node.blueprint is not None and node.blueprint.place.file == f"{one}/robot/talker.py"


HANDED_OUT = TALKER.replace("import rclpy\n", "import rclpy\nimport somewhere.process as process\n")


@pytest.mark.parametrize(
    "main",
    ["process.spin(Talker)", "process.run(args, node=Talker)", "process.Runner().go(Talker)"],
)
def test_a_class_that_is_given_to_code_from_elsewhere_is_the_node(robot, main):
    talker = HANDED_OUT.replace("    rclpy.init()\n    rclpy.spin(Talker())\n", f"    {main}\n")
    talker = talker.replace("main()", "main(args=None)")
    robot('<node pkg="robot" exec="talker" name="t"/>', **{"robot/talker.py": talker})
    [node] = system().nodes
    assert (node.name, node.external, node.executor) == ("/t", False, "unknown")
    assert [endpoint.name for endpoint in node.endpoints] == ["/chatter", "/t/state"]


def test_of_several_classes_that_are_given_away_none_is_guessed(robot):
    talker = HANDED_OUT.replace("    rclpy.init()\n    rclpy.spin(Talker())\n", "    process.spin(Talker, Other)\n")
    robot('<node pkg="robot" exec="talker"/>', **{"robot/talker.py": talker + "\n\nclass Other(Talker):\n    pass\n"})
    made = system()
    [node] = document(made)["nodes"]
    assert (node["class"], node["external"], node["complete"]) == (None, False, False)
    assert [row["reason"] for row in document(made)["unresolved"]] == ["no node was found in the code it starts"]


ARGUMENTS = """\
import argparse
import sys

import rclpy
from rclpy.node import Node
from rclpy.utilities import remove_ros_args
from std_msgs.msg import String


def short(word):
    return word[:3]


def main(args=None):
    parser = argparse.ArgumentParser()
    parser.add_argument('name', nargs='?', default='nobody', type=short)
    parser.add_argument('--best-effort', action='store_true')
    parser.add_argument('-c', '--copies', type=int, default='1')
    parser.add_argument('--extra', nargs='*', default=[])
    {parse}
    rclpy.init(args=args)
    node = Node(given.name + ('_best' if given.best_effort else ''))
    for number in range(given.copies):
        node.create_publisher(String, f'copy_{{number}}', 10)
    for name in given.extra:
        node.create_publisher(String, name, 10)
    rclpy.spin(node)
"""
STRIPPED = "given = parser.parse_args(remove_ros_args(args=sys.argv)[1:])"
SOME = "given, rest = parser.parse_known_args()"


@pytest.mark.parametrize(
    ("parse", "words", "expected"),
    [
        (STRIPPED, "", {"/nob": ["/copy_0"]}),
        (STRIPPED, "sensor --best-effort", {"/sen_best": ["/copy_0"]}),
        (SOME, "-c2 lidar --extra a b", {"/lid": ["/a", "/b", "/copy_0", "/copy_1"]}),
        (STRIPPED, "--copies=2 --ros-args -r copy_1:=/second", {"/nob": ["/copy_0", "/second"]}),
        ("given = parser.parse_args(sys.argv[1:3])", "'two words' --best-effort", {"/two_best": ["/copy_0"]}),
        (STRIPPED, "$(var name) --extra $(var name)/x", {"/rea": ["/copy_0", "/rear/x"]}),
        (STRIPPED, "front --extra $(env TOPIC)", {"/fro": ["/copy_0", None]}),
    ],
)
def test_words_of_the_command_line(robot, parse, words, expected):
    robot(
        f'<arg name="name" default="rear"/><node pkg="robot" exec="talker" args="{words}"/>',
        **{"robot/talker.py": ARGUMENTS.format(parse=parse)},
    )
    assert topics(system()) == expected


@pytest.mark.parametrize("words", ["$(env WORDS)", "--copies $(env COPIES) $(env MORE)"])
def test_words_that_nothing_decides_leave_the_name_open(robot, words):
    robot(f'<node pkg="robot" exec="talker" args="{words}"/>', **{"robot/talker.py": ARGUMENTS.format(parse=STRIPPED)})
    [node] = system().nodes
    assert node.resolution in ("partial", "unknown")


def test_rclpy_alone_takes_ros_arguments_away(robot):
    parse = "given = parser.parse_args()"
    text = ARGUMENTS.format(parse=parse)
    robot('<node pkg="robot" exec="talker" args="sensor"/>', **{"robot/talker.py": text})
    assert system().nodes[0].resolution in ("partial", "unknown"), "argparse ends the program at --ros-args"
    robot('<executable cmd="ros2 run robot talker sensor --best-effort"/>', **{"robot/talker.py": text})
    assert list(topics(system())) == ["/sen_best"]


def test_words_in_sys_argv(robot):
    text = TALKER.replace("import rclpy\n", "import sys\nimport rclpy\n").replace("'chatter'", "sys.argv[1]")
    robot('<node pkg="robot" exec="talker" args="news --loud"/>', **{"robot/talker.py": text})
    assert "/news" in topics(system())["/talker"]


PAIR = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String

class Side(Node):
    def __init__(self, name):
        super().__init__(name)
        topic = self.declare_parameter('topic', 'silence').value
        self.create_publisher(String, topic, 10)
        if self.declare_parameter('loud', False).value:
            self.create_publisher(String, topic + '/loud', 10)

def main():
    rclpy.init()
    executor = rclpy.executors.SingleThreadedExecutor()
    for name in ('left', 'right'):
        executor.add_node(Side(name))
    executor.spin()
"""
SILENT = ["/silence"]


UNDECLARED = """\
import rclpy
from rclpy.node import Node
from rclpy.parameter import Parameter
from std_msgs.msg import String

class Talker(Node):
    def __init__(self):
        super().__init__('talker', allow_undeclared_parameters=True)
        if self.get_parameter_or('loud', Parameter('loud', value=False)).value:
            self.create_publisher(String, 'shout', 10)

def main():
    rclpy.init()
    rclpy.spin(Talker())
"""


@pytest.fixture
def runs(monkeypatch: pytest.MonkeyPatch) -> list[object]:
    """What each program was followed with, as often as it was."""
    every: list[object] = []
    run_entry = Linker._run_entry

    def counted(linker, entry, module, overrides, words):
        every.append(overrides)
        return run_entry(linker, entry, module, overrides, words)

    monkeypatch.setattr(Linker, "_run_entry", counted)
    return every


def test_a_program_runs_again_only_for_parameters_that_it_asks_for(robot, runs):
    given = {"a": ("true", "red"), "b": ("true", "blue"), "c": ("false", "blue"), "d": ("false", "red")}
    nodes = [
        f"""<node pkg="robot" exec="talker" namespace="{name}">
        <param name="loud" value="{loud}"/><param name="color" value="{color}"/></node>"""
        for name, (loud, color) in given.items()
    ]
    robot("".join(nodes), **{"robot/talker.py": UNDECLARED})
    assert topics(system()) == {
        "/a/talker": ["/a/shout"],
        "/b/talker": ["/b/shout"],
        "/c/talker": [],
        "/d/talker": [],
    }
    assert len(runs) == 3  # by itself, loud and not loud


SPOKEN = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String

class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.color = self.declare_parameter('color', 'grey').value
        self.loud = self.declare_parameter('loud', False).value
        name = self.get_name()
        self.get_logger().info(f'{name} is {self.color}, ' + 'loud: ' + str(self.loud))
        #HERE
        if self.declare_parameter('talks', False).value:
            self.create_publisher(String, 'words', 10)

def main():
    rclpy.init()
    rclpy.spin(Talker())
"""
ROBOTS = (("a", "true", "red"), ("b", "false", "blue"), ("c", "true", "blue"))


@pytest.mark.parametrize(
    ("uses", "followed"),
    [
        ("", 1),  # in what it logs alone
        ("self.create_timer(1.0, lambda: print(self.color, self.get_name()))", 1),
        ("self.create_publisher(String, self.get_name() + '/own', 10)", 3),
        ("self.create_publisher(String, self.color, 10)", 2),
        ("self.tables = {self.color: String}\n        self.create_publisher(self.tables['red'], 'x', 10)", 2),
        ("if self.loud:\n            self.create_publisher(String, 'shout', 10)", 2),
        ("if self.color:\n            self.create_publisher(String, 'paint', 10)", 1),
        ("if self.color == 'red' and self.loud:\n            self.create_publisher(String, 'red', 10)", 2),
    ],
)
def test_what_a_program_does_nothing_with_is_no_reason_to_follow_it_again(robot, runs, uses, followed):
    nodes = [
        f"""<node pkg="robot" exec="talker" name="{name}"><param name="talks" value="true"/>
        <param name="loud" value="{loud}"/><param name="color" value="{color}"/></node>"""
        for name, loud, color in ROBOTS
    ]
    code = SPOKEN.replace("#HERE", uses)
    robot("".join(nodes), **{"robot/talker.py": code})
    together = topics(system())
    assert len(runs) == 1 + followed  # by itself, and with what each robot gives
    for node, (name, *_) in zip(nodes, ROBOTS, strict=True):
        robot(node, **{"robot/talker.py": code})
        assert topics(system()) == {f"/{name}": together[f"/{name}"]}
    assert all("/words" in names for names in together.values())


@pytest.mark.parametrize(
    ("parameters", "left", "right"),
    [
        ("left: {ros__parameters: {topic: l}}", ["/l"], SILENT),
        ("left: {ros__parameters: {topic: l}}\nright: {ros__parameters: {topic: r}}", ["/l"], ["/r"]),
        ("/**: {ros__parameters: {topic: both, loud: false}}", ["/both"], ["/both"]),
        (
            "/**: {ros__parameters: {loud: true}}\nright: {ros__parameters: {loud: false}}",
            ["/silence", "/silence/loud"],
            SILENT,
        ),
        ("/other/left: {ros__parameters: {topic: l}}", SILENT, SILENT),
    ],
)
def test_a_section_reaches_only_the_nodes_that_it_names(robot, parameters, left, right):
    root = robot(
        '<node pkg="robot" exec="talker"><param from="$(dirname)/p.yaml"/></node>', **{"robot/talker.py": PAIR}
    )
    (root / "launch" / "p.yaml").write_text(parameters)
    assert topics(system()) == {"/left": left, "/right": right}


def test_parameters_of_a_node_action_without_a_name_reach_all_nodes_of_its_process(robot):
    robot('<node pkg="robot" exec="talker"><param name="topic" value="t"/></node>', **{"robot/talker.py": PAIR})
    assert topics(system()) == {"/left": ["/t"], "/right": ["/t"]}


def test_a_name_and_a_namespace_in_a_node_action_are_the_key_of_its_parameters(robot):
    named = PAIR.replace(
        "super().__init__(name)", "super().__init__(name, cli_args=['--ros-args', '-r', '__node:=own'])"
    )
    robot(
        '<node pkg="robot" exec="talker" name="n" namespace="a"><param name="topic" value="t"/></node>',
        **{"robot/talker.py": named},
    )
    assert topics(system()) == {"/a/own": ["/a/silence"]}, "the key is /a/n"


def test_what_a_launch_file_does_not_lead_to_is_told_in_the_graph(robot):
    robot('\n<include file="$(find-pkg-share lidar)/launch/$(env MODEL).launch.py"/>\n<surprise/>')
    made = system()
    rows = [(row["kind"], row["file"], row["line"], row["reason"]) for row in document(made)["unresolved"]]
    assert rows == [
        ("include", "launch/it.launch.xml", 2, "the environment variable MODEL"),
        ("launch", "launch/it.launch.xml", 3, "<surprise> is not an action that is followed"),
    ]
    assert "include" in render(made)


def test_parameters_of_a_node_that_is_not_here(robot):
    root = robot(
        '\n<node pkg="lidar" exec="driver" name="lidar" namespace="front">\n<param name="rate" value="10.5"/>\n'
        '<param name="port" value="$(env PORT)"/><param from="$(dirname)/p.yaml"/></node>'
    )
    (root / "launch" / "p.yaml").write_text(
        "/front/lidar: {ros__parameters: {sides: [left, right]}}\nlidar: {ros__parameters: {rate: 1.0}}\n"
    )
    [node] = document(system())["nodes"]
    rows = [(p["name"], p["type"], p["value"], p["default"], p["file"], p["line"]) for p in node["parameters"]]
    assert rows == [
        ("port", None, None, None, "launch/it.launch.xml", 4),
        ("rate", "double", 10.5, None, "launch/it.launch.xml", 3),
        ("sides", "string_array", ["left", "right"], None, "launch/p.yaml", 1),
    ]
    assert "rate" in render(system()) and "double = 10.5" in render(system())


OUT = {"config/p.yaml": "/**:\n  ros__parameters:\n    topic: from_file\n"}


@pytest.mark.parametrize(
    ("action", "name"),
    [
        ('<node pkg="robot" exec="talker" args="--ros-args --params-file {file}"/>', "/from_file"),
        ('<node pkg="robot" exec="talker" ros_args="--params-file {file}"/>', "/from_file"),
        ('<executable cmd="ros2 run robot talker --ros-args --params-file {file}"/>', "/from_file"),
        ('<node pkg="robot" exec="talker" args="--params-file {file}"/>', "/chatter"),
        (
            '<node pkg="robot" exec="talker" ros_args="--params-file {file}"><param name="topic" value="own"/></node>',
            "/own",
        ),
    ],
)
def test_parameter_files_on_the_command_line_come_before_the_others(robot, action, name):
    robot(action.format(file="$(find-pkg-share robot)/config/p.yaml"), **OUT)
    assert topics(system())["/talker"] == [name, "/talker/state"]


def test_substitutions_in_a_parameter_file(robot):
    robot(
        '<arg name="ns" default="left"/><arg name="n" default="5"/>'
        '<node pkg="robot" exec="talker" namespace="$(var ns)">'
        '<param from="$(find-pkg-share robot)/config/p.yaml" allow_substs="true"/></node>'
        '<node pkg="robot" exec="talker" name="plain"><param from="$(find-pkg-share robot)/config/q.yaml"/></node>'
        '<node pkg="robot" exec="talker" name="number">'
        '<param from="$(find-pkg-share robot)/config/q.yaml" allow_substs="true"/></node>',
        **{
            "config/p.yaml": "$(var ns)/talker:\n  ros__parameters:\n    topic: $(var ns)_out\n",
            "config/q.yaml": "/**:\n  ros__parameters:\n    topic: $(var n)\n",
        },
    )
    made = topics(system())
    assert made["/left/talker"] == ["/left/left_out", "/left/talker/state"]
    assert made["/number"] == ["/number/state", None]  # without quotes it is a number, and no name
    assert not [code for code, _ in findings() if code == "PRM005"]


def test_a_parameter_file_asks_for_the_share_of_a_package(robot):
    robot(
        '<node pkg="lidar" exec="driver" name="lidar">'
        '<param from="$(find-pkg-share robot)/config/p.yaml" allow_substs="true"/></node>',
        **{"config/p.yaml": "/**:\n  ros__parameters:\n    map: $(find-pkg-share robot)/maps/hall.yaml\n"},
    )
    assert "string = '$(find-pkg-share robot)/maps/hall.yaml'" in render(system())


def test_remappings_and_parameters_of_a_node_that_is_not_here_are_rows_of_one_table(robot):
    robot(
        '<node pkg="lidar" exec="driver" name="lidar"><param name="rate" value="10.5"/>'
        '<remap from="scan" to="front_scan"/></node>'
    )
    shown = render(system())
    assert "remaps     scan  to /front_scan" in shown and "parameter  rate  double = 10.5" in shown


def test_a_parameter_chooses_the_type(robot):
    load = (
        "        package, _, name = self.declare_parameter('type', 'std_msgs/msg/String').value.split('/')\n"
        "        kind = getattr(importlib.import_module(f'{package}.msg'), name)\n"
    )
    create = "        self.create_publisher({}, self"
    text = TALKER.replace(create.format("String"), load + create.format("kind"))
    files = {"robot/talker.py": "import importlib\n" + text}
    start = '<node pkg="robot" exec="talker" name="{}"><param name="type" value="{}"/></node>'

    robot(start.format("a", "std_msgs/msg/Bool"), **files)

    assert [e.type for e in system().endpoints if e.name == "/chatter"] == ["std_msgs/msg/Bool"]


def test_a_launch_file_that_copies_its_table_changes_the_copy_only(robot):
    launch = """\
import copy
from launch import LaunchDescription
from launch_ros.actions import Node

TABLE = [{'name': 'front'}]


def named(suffix):
    rows = copy.deepcopy(TABLE)
    for row in rows:
        row['name'] += suffix
    return rows


def generate_launch_description():
    rows = named('_left') + named('_right')
    return LaunchDescription([Node(package='robot', executable='talker', name=row['name']) for row in rows])
"""
    robot("", **{"launch/copies.launch.py": launch})

    found = graph(Request((".",), Settings(), cached=False, jobs=1, launch="launch/copies.launch.py"))

    assert [node.name for node in found.nodes] == ["/front_left", "/front_right"]


@pytest.mark.parametrize(
    ("words", "node", "topic"),
    [
        ("-r __node:=other", "/other", "/for_other"),
        ("-r __ns:=/a", "/a/talker", "/a/for_a"),
        ("-r talker:__node:=other", "/other", "/for_other"),
        ("-r x:=y", "/talker", "/for_talker"),
    ],
)
def test_sections_go_by_the_name_that_the_command_line_gives(robot, words, node, topic):
    robot(
        f'<node pkg="robot" exec="talker" args="--ros-args {words}">'
        '<param from="$(find-pkg-share robot)/config/p.yaml"/></node>',
        **{
            "config/p.yaml": "talker: {ros__parameters: {topic: for_talker}}\n"
            "other: {ros__parameters: {topic: for_other}}\n"
            "a: {talker: {ros__parameters: {topic: for_a}}}\n"
        },
    )
    assert topics(system())[node][0] == topic


TALKS = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String, Bool

class {cls}(Node):
    def __init__(self):
        super().__init__('{cls}')
        self.declare_parameter('topic', 'chatter')
        self.create_{create})

def main():
    rclpy.init()
    rclpy.spin({cls}())
"""
BY_PARAMETER = "self.get_parameter('topic').value"


@pytest.mark.parametrize(
    ("talker", "listener", "told"),
    [
        ("", None, True),  # the default, and a node that no launch file starts
        ("<param name='topic' value='news'/>", None, False),
        ("<remap from='chatter' to='news'/>", None, False),
        ("<remap from='chatter' to='news'/>", "<remap from='chatter' to='news'/>", True),
        ("<remap from='chatter' to='news'/>", "<remap from='chatter' to='old'/>", False),
    ],
)
def test_types_are_compared_under_the_names_that_launch_files_give(robot, talker, listener, told):
    publisher = TALKS.format(cls="Talker", create=f"publisher(String, {BY_PARAMETER}, 10")
    listens = TALKS.format(cls="Listener", create=f"subscription(Bool, {BY_PARAMETER}, print, 10")
    files = {"robot/talker.py": publisher, "robot/listener.py": listens}
    files["setup.py"] = SETUP.replace("robot.talker:main'", "robot.talker:main', 'listener = robot.listener:main'")
    if listener is not None:
        files["launch/other.launch.xml"] = f"<launch><node pkg='robot' exec='listener'>{listener}</node></launch>"
    robot(f"<node pkg='robot' exec='talker'>{talker}</node>", **files)
    found = check(Request((".",), Settings(), cached=False, jobs=1)).findings
    assert ("TOP001" in {one.code for one in found}) is told


CHOOSING = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String

OUTPUTS = {{'left': {{'topic': '/left/out'}}, 'right': {{'topic': '/right/out'}}}}
ROWS = {{'left': ('/left/out', 1), 'right': ('/right/out', 2)}}

class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.declare_parameter('side', 'left')
        side = str(self.get_parameter('side').value)
        {choice}
        self.create_publisher(String, topic, 10)

def main():
    rclpy.init()
    rclpy.spin(Talker())
"""


@pytest.mark.parametrize(
    "choice",
    [
        "topic = OUTPUTS[side]['topic']",
        "config = OUTPUTS.get(side); topic = config['topic']",
        "topic = OUTPUTS.get(side.lower(), {}).get('topic', '/none')",
        "topic = {'left': '/left/out'}.get(side, '/right/out')",
        "topic, _ = ROWS[side]",
        "topic = ROWS[side][0]",
        "topic = list(OUTPUTS[side].values())[0]",
        "topic = '/left/out' if side == 'left' else '/right/out'",
    ],
)
def test_a_parameter_chooses_from_a_table(robot, choice):
    launch = """
      <node pkg="robot" exec="talker" name="left"/>
      <node pkg="robot" exec="talker" name="right"><param name="side" value="right"/>
        <remap from="/right/out" to="/robot/out"/></node>
    """
    robot(launch, **{"robot/talker.py": CHOOSING.format(choice=choice)})
    assert topics(system()) == {"/left": ["/left/out"], "/right": ["/robot/out"]}
    found = check(Request((".",), Settings(), cached=False, jobs=1)).findings
    assert "LCH002" not in {one.code for one in found}


def test_what_a_parameter_chooses_is_a_default_and_no_more(robot):
    code = CHOOSING.format(choice="topic = OUTPUTS[side]['topic']")
    robot("", **{"robot/talker.py": code})
    made = graph(Request((".",), Settings(), cached=False, jobs=1))
    (endpoint,) = made.nodes[0].endpoints
    assert (endpoint.name, endpoint.resolution, endpoint.parameter) == ("/left/out", "parameter", "side")


def test_what_the_code_itself_chooses_from_a_table_is_certain(robot):
    code = CHOOSING.format(choice="topic = OUTPUTS['right']['topic']")
    robot("", **{"robot/talker.py": code})
    made = graph(Request((".",), Settings(), cached=False, jobs=1))
    (endpoint,) = made.nodes[0].endpoints
    assert (endpoint.name, endpoint.resolution) == ("/right/out", "exact")


THREE = SETUP.replace("robot.talker:main'", "robot.a:main', 'two = robot.b:main', 'three = robot.c:main'")


def test_publishers_of_a_launch_file_and_of_one_that_it_includes_are_told_once(robot):
    files = {
        f"robot/{name}.py": TALKS.format(cls=name.upper(), create="publisher(String, 'drive', 10") for name in "abc"
    }
    both = "<node pkg='robot' exec='talker'/><node pkg='robot' exec='three'/>"
    files["launch/part.launch.xml"] = f"<launch>{both}</launch>"
    files["setup.py"] = THREE
    robot('<include file="$(dirname)/part.launch.xml"/><node pkg="robot" exec="two"/>', **files)
    found = [one for one in check(Request((".",), Settings(), cached=False, jobs=1)).findings if one.code == "OWN001"]
    assert [(one.place.file, one.message) for one in found] == [
        ("robot/c.py", "/A, /B and /C all publish the topic '/drive'")
    ]
    assert [one.place.file for one in found[0].related] == ["robot/a.py", "robot/b.py"]

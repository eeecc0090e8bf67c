"""NME004: nodes of one name that launch files start together."""

from __future__ import annotations

import pytest

from robot_package import SETUP, TALKER, UNDER_CONDITIONS, node


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


INCLUDES = "".join(f'<include file="$(find-pkg-share robot)/launch/{name}.launch.xml"/>' for name in "cd")


@pytest.mark.parametrize(
    ("one", "other", "help"),
    [
        ({}, {}, "remove one of the two: they start the same program in the same way"),
        ({}, {"args": "--quiet"}, "start the program once, or give each its own name or namespace"),
        ({}, {"exec": "other", "name": "talker"}, "give each its own name"),  # in a namespace, its topics move, too
    ],
)
def test_a_program_that_two_files_start(findings, one, other, help):
    launch = {
        f"launch/{file}.launch.xml": f"<launch>{node(**more)}</launch>" for file, more in (("c", one), ("d", other))
    }
    (found,) = findings("NME004", INCLUDES, **launch)
    assert found.help == help


@pytest.mark.parametrize(
    ("key", "more"),
    [("talker", ", and p.yaml a section for each: 'talker' is for one name alone"), ("/**", ""), ("listener", "")],
)
def test_a_parameter_file_has_the_name_too(findings, key, more):
    param = '<param from="$(find-pkg-share robot)/config/p.yaml"/>'
    twice = node(param) + node(param, args="--quiet")
    (found,) = findings("NME004", twice, **{"config/p.yaml": f"{key}: {{ros__parameters: {{rate: 1.0}}}}\n"})
    assert found.help == f"give each its own name or namespace{more}"


def test_nodes_that_the_code_calls_alike_are_not_renamed_by_the_launch_file(findings):
    """A class that makes another node of its own name: without ``name=`` they would clash as well."""
    talker = TALKER.replace(
        "super().__init__('talker')", "super().__init__('talker')\n        self.helper = rclpy.create_node('talker')"
    )
    assert talker != TALKER
    (found,) = findings("NME004", node(name="it"), **{"robot/talker.py": talker})
    assert found.message == "this executable creates several nodes with the name '/it'"
    assert found.help == "give each its own name in the code, and remove name= here"


@pytest.mark.parametrize(
    ("lines", "told"),
    [
        ("super().__init__('helper')", 1),
        ("self.rate = 1.0", 0),
        ("raise RuntimeError('no camera')\n        super().__init__('helper')", 0),
    ],
    ids=["a second node", "it forgets to call the constructor", "it raises before"],
)
def test_an_object_that_never_becomes_a_node(findings, lines: str, told: int):
    """Nothing of it is there under any name, so that ``name=`` renames one node."""
    helper = (
        f"class Helper(Node):\n    def __init__(self):\n        {lines}\n        self.create_timer(1.0, print)\n\n\n"
    )
    first = "super().__init__('talker')"
    talker = TALKER.replace(first, f"{first}\n        self.helper = Helper()").replace(
        "class Talker", f"{helper}class Talker"
    )
    assert len(findings("NME004", node(name="it"), **{"robot/talker.py": talker})) == told


def test_nodes_that_ros_refuses_to_start_do_not_meet(findings):
    assert findings("NME004", node(namespace="2nd") * 2) == []
    assert len(findings("NME004", node(namespace="second") * 2)) == 1


def test_a_node_that_one_branch_makes_beside_the_other_is_information(findings):
    branch = "Talker())\n    if len(sys.argv) > 3:\n        rclpy.spin(rclpy.create_node('helper'))"
    two = "import sys\n" + TALKER.replace("Talker())", branch)
    (found,) = findings("NME004", node(name="it"), **{"robot/talker.py": two})
    assert found.severity.label == "info"
    assert found.message.endswith("have the name '/it', once a branch of its code has created both")


@pytest.mark.parametrize(
    ("lines", "told"),
    [
        ("if input('Calibrate? ') == 'y':", 0),
        ("answer = input('Calibrate? ').lower()\n    if answer == 'y':", 0),
        ("answer = input('Calibrate? ')\n    if len(sys.argv) > 3:", 1),
    ],
)
def test_a_node_that_an_answer_at_the_keyboard_makes(findings, lines: str, told: int):
    """What launch starts has no keyboard."""
    branch = f"Talker())\n    {lines}\n        rclpy.spin(rclpy.create_node('helper'))"
    two = "import sys\n" + TALKER.replace("Talker())", branch)
    assert len(findings("NME004", node(name="it"), **{"robot/talker.py": two})) == told


def test_name_renames_all_nodes_of_an_executable(findings):
    two = TALKER.replace("Talker())", "Talker())\n    rclpy.spin(rclpy.create_node('helper'))")
    (found,) = findings("NME004", node(name="it"), **{"robot/talker.py": two})
    assert found.message == "name= renames every node of this executable, so several have the name '/it'"
    assert found.help == "remove name=, so that each node keeps the name from its code"
    assert sorted((one.place.line, one.message) for one in found.related) == [
        (13, "'talker' is created here"),
        (14, "'helper' is created here"),
    ]
    assert findings("NME004", node(), **{"robot/talker.py": two}) == []  # the advice works


def test_the_names_that_one_action_doubles_in_several_namespaces_are_one_finding(findings):
    more = "Talker())\n    " + "\n    ".join(
        f"rclpy.spin(rclpy.create_node('{name}', namespace='arm'))" for name in ("helper", "planner")
    )
    more += "\n    rclpy.spin(rclpy.create_node('watcher'))"
    talker = TALKER.replace("Talker())", more)
    (found,) = findings("NME004", node(name="it"), **{"robot/talker.py": talker})
    assert found.message == (
        "name= renames every node of this executable, so several have the name '/arm/it'; so it is with '/it'"
    )
    assert len(found.related) == 4
    assert findings("NME004", node(), **{"robot/talker.py": talker}) == []  # the advice works


LISTENER = """
import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Listener(Node):
    def __init__(self):
        super().__init__('listener')
        self.create_subscription(String, '{}', print, 10)


def main():
    rclpy.init()
    rclpy.spin(Listener())
"""


@pytest.mark.parametrize(("topic", "kept"), [("/it/words", True), ("/that/words", False)])
def test_names_below_that_of_a_node_would_change_with_it(findings, topic: str, kept: bool):
    two = TALKER.replace("Talker())", "Talker())\n    rclpy.spin(rclpy.create_node('helper'))")
    two = two.replace("'chatter'", "'~/words'")
    setup = SETUP.replace("'talker = robot.talker:main'", "'talker = robot.talker:main', 'other = robot.other:main'")
    files = {"setup.py": setup, "robot/talker.py": two, "robot/other.py": LISTENER.format(topic)}
    (found,) = findings("NME004", node(name="it") + node(exec="other"), **files)
    keep = (
        "keep name= for 'talker', whose names below ~/ go by it, and create the other with use_global_arguments=False"
    )
    assert found.help.startswith(keep if kept else "remove name=, so that each node keeps the name from its code")


def test_a_name_that_another_action_has_is_no_way_out(findings):
    two = TALKER.replace("Talker())", "Talker())\n    rclpy.spin(rclpy.create_node('helper'))")
    (found,) = findings("NME004", node(name="it") + node(name="helper", exec="other"), **{"robot/talker.py": two})
    assert found.help == ("remove name=, and create no '/helper' in this executable: this system starts one by itself")


def test_names_that_the_code_gives_twice_are_no_way_out(findings):
    """Without ``name=``, the nodes of one executable would clash with each other, or with those of another one."""
    several = "remove name=, and give each node a name of its own in the code: several are called '/helper'"
    helper = "\n    rclpy.spin(rclpy.create_node('helper'))"
    thrice = TALKER.replace("Talker())", f"Talker()){helper * 2}")
    (found,) = findings("NME004", node(name="it"), **{"robot/talker.py": thrice})
    assert found.help == several
    two = TALKER.replace("Talker())", f"Talker()){helper}")
    setup = SETUP.replace("'talker = robot.talker:main'", "'talker = robot.talker:main', 'other = robot.other:main'")
    files = {"setup.py": setup, "robot/talker.py": two, "robot/other.py": two.replace("talker", "other")}
    both = findings("NME004", node(name="it") + node(name="that", exec="other"), **files)
    assert [found.help for found in both] == [several] * 2


@pytest.mark.parametrize(("folder", "told"), [("launch", 1), ("launch/_old", 0)])
def test_a_launch_file_that_is_put_aside_is_started_by_nobody(findings, folder: str, told: int):
    twice = f"<launch>{node(name='it') * 2}</launch>"
    assert len(findings("NME004", "", **{f"{folder}/twice.launch.xml": twice})) == told


def test_removing_a_name_needs_another_section_in_the_parameter_file_that_is_for_it(findings):
    two = TALKER.replace("Talker())", "Talker())\n    rclpy.spin(rclpy.create_node('helper'))")
    started = node('<param from="$(find-pkg-share robot)/config/it.yaml"/>', name="it")

    def advice(section):
        files = {"robot/talker.py": two, "config/it.yaml": f"{section}:\n  ros__parameters:\n    rate: 5\n"}
        (found,) = findings("NME004", started, **files)
        return found.help

    assert advice("it") == "remove name=, and call the section 'it' of it.yaml as the code calls the node that reads it"
    assert advice("/**") == "remove name=, so that each node keeps the name from its code"


def test_an_executable_that_several_launch_files_rename_is_one_finding(findings):
    two = TALKER.replace("Talker())", "Talker())\n    rclpy.spin(rclpy.create_node('helper'))")
    again = {"launch/again.launch.xml": f"<launch>{node(name='other')}</launch>", "robot/talker.py": two}
    (found,) = findings("NME004", node(name="it"), **again)
    assert [one.message for one in found.related].count("it is started here, too") == 1


TEXT_MODE = """\
import os
import sys
import rclpy

def main():
    rclpy.init()
{before}
    rclpy.spin(rclpy.create_node('window'))
"""
SPINS = "rclpy.spin(rclpy.create_node('text'))"


@pytest.mark.parametrize(
    ("before", "several"),
    [
        (["if '--text' in sys.argv:", f"    {SPINS}", "    return"], False),
        (["if '--text' in sys.argv:", f"    {SPINS}", "    sys.exit(0)"], False),
        (["try:", "    open(os.environ['DISPLAY'])", "except OSError:", f"    {SPINS}", "    return"], False),
        (["match open('mode').read():", "    case 'text':", f"        {SPINS}", "        return"], False),
        (["for word in sys.argv:", "    if word == '--text':", f"        {SPINS}", "        return"], False),
        (["if '--text' in sys.argv:", f"    {SPINS}"], True),
        (["if '--text' in sys.argv:", f"    {SPINS}", "    if len(sys.argv) > 3:", "        return"], True),
        (["def text():", "    if '--text' in sys.argv:", f"        {SPINS}", "        return", "text()"], True),
        (["try:", f"    {SPINS}", "    sys.exit(0)", "except SystemExit:", "    pass"], True),
        (
            [
                "try:",
                "    if '--text' in sys.argv:",
                f"        {SPINS}",
                "        sys.exit(0)",
                "except SystemExit: pass",
            ],
            True,
        ),
    ],
)
def test_a_branch_that_ends_the_function_makes_its_node_alone(findings, before, several):
    code = TEXT_MODE.replace("{before}", "\n".join(f"    {line}" for line in before))
    found = findings("NME004", node(name="it"), **{"robot/talker.py": code})
    assert bool(found) is several


def test_what_a_finally_makes_stands_beside_what_its_try_returned_from(findings):
    before = ["try:", "    if '--text' in sys.argv:", f"        {SPINS}", "        return", "finally:"]
    before.append("    rclpy.spin_once(rclpy.create_node('farewell'))")
    code = TEXT_MODE.replace("{before}", "\n".join(f"    {line}" for line in before))
    (found,) = findings("NME004", node(name="it"), **{"robot/talker.py": code})
    assert {"'text' is created here", "'farewell' is created here"} == {one.message for one in found.related}


SPAWNER = """\
import rclpy
from std_srvs.srv import Trigger

def main():
    rclpy.init()
    node = rclpy.create_node('spawner')
    client = node.create_client(Trigger, 'spawn')
    while not client.wait_for_service(timeout_sec=1.0):
        pass
    future = client.call_async(Trigger.Request())
    rclpy.spin_until_future_complete(node, future, timeout_sec=5.0)
    node.destroy_node()
    rclpy.shutdown()
"""


@pytest.mark.parametrize(
    ("before", "after", "clash"),
    [
        ("", "", False),
        ("spin_until_future_complete(node, future, timeout_sec=5.0)", "spin(node)", True),
        ("    future = client", "    node.create_publisher(Trigger, 'log', 10)\n    future = client", True),
        ("    future = client", "    while rclpy.ok():\n        future = client", True),
        ("    future = client.call_async(Trigger.Request())\n", "    future = None\n", True),
    ],
)
def test_a_program_that_makes_one_request_and_ends(findings, before: str, after: str, clash: bool):
    code = SPAWNER.replace(before, after) if before else SPAWNER
    found = findings("NME004", node() + "\n" + node(), **{"robot/talker.py": code})
    assert bool(found) is clash


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


def test_what_two_files_both_start_is_one_finding(findings):
    start = f"<launch>\n{node(name='left')}\n{node(name='right')}\n</launch>"
    files = {"launch/again.launch.xml": start, "launch/talkers.launch.xml": TWO_TALKERS}
    (both,) = findings("NME004", f"\n{HERE.format('again')}\n{HERE.format('talkers')}", **files)
    assert both.message == "two nodes of this system have the name '/left'; another node is started in the same way"
    assert (both.place.file, both.place.line) == ("launch/talkers.launch.xml", 2)
    assert [(each.place.file, each.place.line, each.message) for each in both.related] == [
        ("launch/again.launch.xml", 2, "the other one is started here"),
        ("launch/it.launch.xml", 2, "again.launch.xml is included here"),
        ("launch/it.launch.xml", 3, "talkers.launch.xml is included here"),
        ("launch/talkers.launch.xml", 3, "two nodes of this system have the name '/right'"),
    ]
    (beside,) = findings("NME004", f"\n{node(name='left')}\n{HERE.format('talkers')}", **files)
    assert [each.message for each in beside.related] == [
        "the other one is started here",
        "talkers.launch.xml is included here",
    ]


def test_the_name_that_the_code_gives_is_shown(findings):
    (clash,) = findings("NME004", f"{node()}\n{node(name='talker')}")
    assert [(each.place.file, each.message) for each in clash.related][1:] == [
        ("robot/talker.py", "the code gives '/talker' its name here")
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


def test_a_helper_that_the_command_line_does_not_reach_keeps_its_name(findings):
    helper = "        rclpy.create_node('asker'{})\n"
    with_helper = TALKER.replace("        self.declare", helper + "        self.declare")
    apart = with_helper.format(", use_global_arguments=False")
    assert findings("NME004", node(name="it"), **{"robot/talker.py": apart}) == []
    reached = with_helper.format("")
    assert len(findings("NME004", node(name="it"), **{"robot/talker.py": reached})) == 1


BRIDGE = """\
import rclpy
from rclpy.context import Context
from rclpy.executors import SingleThreadedExecutor
from rclpy.node import Node
from std_msgs.msg import String

class Side(Node):
    def __init__(self, name, context):
        super().__init__(name, context=context)
        self.create_publisher(String, '/both', 10)

def main(args=None):
    near, far = Context(), Context()
    rclpy.init(context=near, args=args)
    rclpy.init({init})
    first = Side('first', near)
    second = {second}
    executor = SingleThreadedExecutor(context=near)
    executor.add_node(first)
    executor.spin()
"""


@pytest.mark.parametrize(
    ("init", "second", "renamed"),
    [
        ("context=far, args=[]", "Side('second', far)", False),
        ("context=far, args=[]", "Node('second', context=far)", False),
        ("args=[]", "Node('second')", False),
        ("args=[]", "Node('second', context=None)", False),
        ("context=far, args=args", "Side('second', far)", True),
        ("context=far", "Side('second', far)", True),
        ("context=far, args=[]", "Side('second', near)", True),
        ("context=far, args=[]", "Side('second', contexts['far'])", True),
    ],
)
def test_a_context_that_the_command_line_does_not_reach(findings, init: str, second: str, renamed: bool):
    """A bridge between two DDS domains has two contexts: ``name=`` renames the nodes of those with its arguments."""
    code = {"robot/talker.py": BRIDGE.format(init=init, second=second)}
    assert bool(findings("NME004", node(name="it"), **code)) is renamed


@pytest.mark.parametrize(
    ("package", "executable", "told"),
    [
        ("gazebo_ros", "spawn_entity.py", 0),
        ("ros_gz_sim", "create", 0),
        ("nav2_util", "lifecycle_bringup", 0),
        ("rviz2", "rviz2", 1),
        ("robot", "create", 1),
    ],
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


PAIRS = (("left", "right"), ("up", "down"))


def test_helper_nodes_of_one_package_are_one_finding_whatever_launch_files_start_them(findings):
    """Only the code can tell them apart, and it does so once for all launch files."""
    before, _, _ = TALKER.partition("\ndef main")
    main = "\ndef main():\n    rclpy.init()\n    helper = rclpy.create_node('{}')\n    rclpy.spin(Talker())\n"
    helpers = {"left": "reader", "right": "reader", "up": "writer", "down": "writer"}
    files = {
        f"robot/{name}.py": before.replace("'talker'", f"'{name}'") + main.format(helper)
        for name, helper in helpers.items()
    }
    entries = ", ".join(f"'{name} = robot.{name}:main'" for name in helpers)
    files["setup.py"] = SETUP.replace("'talker = robot.talker:main'", entries)
    files |= {f"launch/{name}.launch.xml": f"<launch>{node(exec=name)}</launch>" for name in ("left", "up")}
    outer = "".join(f'<include file="$(dirname)/{name}.launch.xml"/>{node(exec=other)}' for name, other in PAIRS)
    (told,) = findings("NME004", outer, **files)
    assert told.message == "two nodes of this system have the name '/reader'; another node is started in the same way"


def test_two_launch_actions_are_one_finding_with_all_names(findings):
    before, _, _ = TALKER.partition("\ndef main")
    main = "\ndef main():\n    rclpy.init()\n    helper = rclpy.create_node('params')\n    rclpy.spin(Talker())\n"
    files = {"robot/talker.py": before + main}
    (found,) = findings("NME004", f"{node()}\n{node()}", **files)
    assert found.message == "two launch actions start nodes with the same names: /params, /talker"
    assert found.help == (
        "give each its own name in the code, or in one action ros_arguments=['-r', 'params:__node:=…']: name= would "
        "rename all its nodes"
    )
    other = node(ros_args="-r params:__node:=others -r talker:__node:=other")
    assert findings("NME004", f"{node()}\n{other}", **files) == []  # the advice works
    (sole,) = findings("NME004", f"{node()}\n{node()}")
    assert (sole.message, "its own name or namespace" in sole.help) == (
        "two nodes of this system have the name '/talker'",
        True,
    )


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
    found = findings("NME004", **{"launch/it.launch.py": UNDER_CONDITIONS.format(first=first, second=second)})
    assert [one.place.line for one in found] == ([13] if clash else [])


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


def test_one_line_that_starts_a_node_several_times(findings):
    """Of its own accord, or because its file is included in a loop."""
    many = """
import os
from launch import LaunchDescription
from launch.actions import IncludeLaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    file = os.path.join(os.path.dirname(__file__), 'one.launch.xml')
    return LaunchDescription([ACTION for _ in range(2)])
"""
    one = {"launch/one.launch.xml": f"<launch>\n{node(name='it')}\n</launch>"}
    included = many.replace("ACTION", "IncludeLaunchDescription(file)")
    (told,) = findings("NME004", "", **one, **{"launch/many.launch.py": included})
    assert (told.message, told.place.file) == (
        "this line starts several nodes with the name '/it'",
        "launch/one.launch.xml",
    )
    (row,) = told.related
    assert (row.message, row.place.file) == ("its file is included here", "launch/many.launch.py")
    looped = many.replace("ACTION", "Node(package='robot', executable='talker', name='it')")
    (told,) = findings("NME004", "", **one, **{"launch/many.launch.py": looped})
    assert told.message == "this line creates several actions, and each starts a node with the name '/it'"
    assert not told.related

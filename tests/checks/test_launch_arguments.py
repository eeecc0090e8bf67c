"""LCH003: launch arguments that nothing declares, and that an included file does not take."""

from __future__ import annotations

import pytest

from archlint.finding import Severity
from robot_package import SETUP, node


def test_an_argument_that_every_includer_passes_is_declared_enough(findings):
    inner = f"<launch>{node(name='$(var name)')}</launch>"
    outer = '<include file="$(dirname)/inner.launch.xml"><arg name="name" value="a"/></include>'
    assert findings("LCH003", outer, **{"launch/inner.launch.xml": inner}) == []
    (found,) = findings("LCH003", outer.replace('name="name"', 'name="nam"'), **{"launch/inner.launch.xml": inner})[:1]
    assert found.place.file.startswith("launch/")


@pytest.mark.parametrize(
    ("command", "told"),
    [
        ("ros2 launch robot it.launch.xml rate:=2 name:=a", 0),
        ("ros2 launch robot it.launch.xml \\\n  name:=a", 0),
        ("ros2 launch robot other.launch.xml name:=a", 1),
        ("ros2 launch robot it.launch.xml rate:=2", 1),
    ],
)
def test_an_argument_that_a_document_gives_on_the_command_line(findings, command: str, told: int):
    launch = f'<arg name="rate" default="1"/>{node(name="$(var name)")}'
    assert len(findings("LCH003", launch, **{"README.md": f"    {command}\n"})) == told


SHARED = """from launch import LaunchDescription
from launch.actions import IncludeLaunchDescription
from launch_ros.substitutions import FindPackageShare

def generate_launch_description():
    robot, settings = FindPackageShare('robot'), {'rate': '2', 'mode': 'fast'}
    return LaunchDescription([
        IncludeLaunchDescription([robot, '/launch/laser.launch.xml'], launch_arguments=settings.items()),
        IncludeLaunchDescription([robot, '/launch/filter.launch.xml'], launch_arguments=settings.items()),
    ])
"""


@pytest.mark.parametrize(("declared", "names"), [(("rate", "mode"), set()), (("rate",), {"mode"})])
def test_a_dict_that_two_includes_share(findings, declared: tuple[str, ...], names: set[str]):
    """What one of them takes is no slip where the other one gets it, too."""
    takes = "".join(f'<arg name="{name}" default="1"/>' for name in declared)
    files = {
        "launch/both.launch.py": SHARED,
        "launch/laser.launch.xml": f"<launch>{takes}</launch>",
        "launch/filter.launch.xml": "<launch><arg name='other' default='1'/></launch>",
    }
    found = findings("LCH003", **files)
    assert {name for one in found for name in one.identity if "/" not in name} == names


def test_what_the_top_declares_reaches_files_two_includes_down(findings):
    """A file in the middle that is started alone lacks the argument; what includes it has it."""
    middle = '<launch><include file="$(dirname)/inner.launch.xml"/></launch>'
    files = {
        "launch/middle.launch.xml": middle,
        "launch/inner.launch.xml": f"<launch>{node(name='$(var name)')}</launch>",
    }
    top = '<arg name="name" default="a"/><include file="$(dirname)/middle.launch.xml"/>'
    assert findings("LCH003", top, **files) == []
    (diagnostic,) = findings("LCH003", top.replace('name="name"', 'name="other"'), **files)
    assert diagnostic.place.file == "launch/inner.launch.xml"


READER = """\
from launch.substitutions import LaunchConfiguration

def setting(name):
    return LaunchConfiguration(name)

def rate():
    return LaunchConfiguration('rate')
"""
READS = """\
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch_ros.actions import Node
from robot.reader import rate, setting

def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument('other', default_value='a'),
        Node(package='robot', executable='talker', name=setting('other'), namespace=setting('space')),
    ])
"""


def test_a_function_that_reads_what_it_is_given_is_no_place_of_a_finding(findings):
    files = {"robot/__init__.py": "", "robot/reader.py": READER}
    (diagnostic,) = findings("LCH003", **files, **{"launch/a.launch.py": READS})
    assert (diagnostic.place.file, diagnostic.place.line) == ("launch/a.launch.py", 9)
    assert "'space'" in diagnostic.message
    (diagnostic,) = findings("LCH003", **files, **{"launch/a.launch.py": READS.replace("setting('space')", "rate()")})
    assert (diagnostic.place.file, diagnostic.place.line) == ("robot/reader.py", 7)


def test_a_configuration_behind_a_condition_may_be_set_by_then(findings):
    assert findings("LCH003", '<arg name="x"/>' + node(name="$(var y)", **{"if": "$(var x)"})) == []


def test_the_advice_is_written_in_the_language_of_the_launch_file(findings):
    (xml,) = findings("LCH003", node(name="$(var y)"))
    assert xml.help == 'declare it before it is read: <arg name="y" default="…"/>'
    yaml = "launch:\n- node: {pkg: robot, exec: talker, name: $(var y)}\n"
    (other,) = findings("LCH003", **{"launch/b.launch.yaml": yaml})
    assert other.help == "declare it before it is read: - arg: {name: y, default: …}"


def test_one_forgotten_argument_is_told(findings):
    (found,) = findings("LCH003", '<arg name="x" default="a"/>' + node(name="$(var y)"))
    assert "no launch argument 'y' is declared" in found.message


def test_an_argument_that_is_declared_too_late(findings):
    (found,) = findings("LCH003", node(name="$(var y)") + '<arg name="y" default="a"/>')
    assert found.message == "the launch argument 'y' is read before it is declared"
    assert [one.message for one in found.related] == ["it is declared here"]


EVENTS = """
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, RegisterEventHandler, TimerAction
from launch.event_handlers import OnProcessExit
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node

def generate_launch_description():
    first = Node(package='robot', executable='talker', name='a')
    second = Node(package='robot', executable='talker', name=LaunchConfiguration('name'))
    return LaunchDescription([
        {starts},
        DeclareLaunchArgument('{declared}', default_value='b'),
        first,
    ])
"""


@pytest.mark.parametrize(
    "starts",
    [
        "RegisterEventHandler(OnProcessExit(target_action=first, on_exit=[second]))",
        "TimerAction(period=2.0, actions=[second])",
    ],
)
def test_what_an_event_or_a_timer_starts_reads_its_arguments_later(findings, starts):
    def told(declared, starts=starts):
        launch = {"launch/b.launch.py": EVENTS.format(starts=starts, declared=declared)}
        return [one for one in findings("LCH003", **launch) if one.place.file == "launch/b.launch.py"]

    assert told("name") == []
    assert [one.place.line for one in told("nam")] == [10]
    assert [one.place.line for one in told("name", "second")] == [10]


def test_names_that_one_file_forgets_are_one_finding(findings):
    reads = '<arg name="speed" default="1"/>\n' + node(name="$(var x)") + "\n" + node(name="$(var sped)")
    (found,) = findings("LCH003", reads)
    assert found.message == "no launch arguments 'x' and 'sped' are declared, and nothing sets them"
    assert (found.severity, found.place.line) == (Severity.WARNING, 2)
    assert [(one.place.line, one.message) for one in found.related] == [
        (3, "'sped' is read here; did you mean 'speed'?")
    ]


def test_the_files_of_a_folder_that_declare_nothing_are_one_finding(findings):
    more = {f"launch/{name}.launch.xml": f"<launch>{node(name='$(var z)')}</launch>" for name in ("more", "most")}
    (found,) = findings("LCH003", node(name="$(var x)"), **more)  # the habit of a folder
    assert found.message.endswith("no launch argument is declared; the same holds for 2 more launch files")
    assert [row.place.file for row in found.related] == ["launch/more.launch.xml", "launch/most.launch.xml"]


def test_a_file_that_declares_nothing_gets_its_arguments_on_the_command_line(findings):
    (found,) = findings("LCH003", node(name="$(var x)", namespace="$(var y)"))
    assert found.message.startswith("the launch fails without y:=… and x:=… on its command line")
    assert found.severity == Severity.INFO
    (found,) = findings("LCH003", '<arg name="z" default="a"/>' + node(name="$(var x)"))
    assert found.severity == Severity.WARNING


def test_only_the_option_tells_of_a_file_that_declares_nothing(findings):
    """It is started with its values on the command line, or by another file; one with declarations forgot this one."""
    quiet = {"archlint.toml": 'select = ["LCH003"]'}
    assert findings("LCH003", node(name="$(var x)"), **quiet) == []
    assert len(findings("LCH003", '<arg name="z" default="a"/>' + node(name="$(var x)"), **quiet)) == 1


@pytest.mark.parametrize(("passed", "told"), [("x", 0), ("y", 1)])
def test_a_file_that_another_may_choose_gets_its_arguments_from_there(findings, passed: str, told: int):
    """Which file it is comes from an argument, whose default names none."""
    chooses = f"""<launch>
      <arg name="link" default="none"/>
      <include file="$(find-pkg-share robot)/launch/$(var link).launch.xml"><arg name="{passed}" value="1"/></include>
    </launch>"""
    more = {"launch/tcp.launch.xml": f"<launch>{node(name='$(var x)')}</launch>", "launch/link.launch.xml": chooses}
    rows = [row for row in findings("LCH003", **more) if row.place.file == "launch/tcp.launch.xml"]
    assert len(rows) == told


ON_THE_MACHINE = """\
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, IncludeLaunchDescription
from launch.launch_description_sources import AnyLaunchDescriptionSource
from launch.substitutions import LaunchConfiguration

def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument('x', default_value='a'),
        IncludeLaunchDescription(
            AnyLaunchDescriptionSource('FILE'), launch_arguments={'x': LaunchConfiguration('x')}.items()),
    ])
"""


@pytest.mark.parametrize(
    ("file", "told"),
    [
        ("/home/me/ws/src/robot/launch/it.launch.xml", 0),
        ("/home/me/ws/src/robot/launch/other.launch.xml", 1),
        ("/opt/ros/jazzy/share/other/launch/it.launch.xml", 1),
    ],
)
def test_a_file_that_another_may_include_by_a_path_of_the_machine(findings, file, told):
    outer = ON_THE_MACHINE.replace("FILE", file)
    assert len(findings("LCH003", node(name="$(var x)"), **{"launch/outer.launch.py": outer})) == told


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
    assert "without y:=…" in found.message
    (found,) = findings("LCH003", read + there)
    assert "without y:=…" in found.message


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


def test_declarations_of_one_list_that_is_never_added_are_told_once(findings):
    both = NEVER_ADDED.replace(
        "    talker", "    pace = DeclareLaunchArgument('pace', default_value='1')\n    talker", 1
    )
    both = both.replace(
        "name=LaunchConfiguration('name')",
        "name=LaunchConfiguration('name'),\n        namespace=LaunchConfiguration('pace')",
    )
    (told,) = findings("LCH003", **{"launch/a.launch.py": both})
    assert (
        told.message
        == "the launch arguments 'name', 'pace' are read, but their declarations are not in the LaunchDescription"
    )
    assert told.place.line == 9
    assert [(row.place.line, row.message) for row in told.related] == [
        (7, "it is created here and never added"),
        (10, "it is read here"),
    ]


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


def test_an_argument_for_the_file_that_a_wrong_test_never_chooses(findings):
    """LCH006 tells of the test: once it works, the other file takes the argument."""
    slow = {"launch/slow.launch.xml": '<launch><arg name="sped" default="1"/></launch>'}
    choice = "'fast.launch.xml' if LaunchConfiguration('quick') else 'slow.launch.xml'"
    assert included(findings, "{'sped': '2'}.items()", choice, **slow) == []
    assert len(included(findings, "{'sped': '2'}.items()", **slow)) == 1


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
        ("Node(package='robot', executable='talker', parameters=[{'sort_by': 'colour'}])", 1),
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
    (found,) = findings("LCH003", f"<let name='a' value='{names}'/>", **{"launch/it.launch.py": ""})
    assert "left:=… and right:=…" in found.message


def test_a_file_that_takes_no_argument_is_told_once_for_all_that_hand_it_over(findings):
    inner = {"launch/inner.launch.xml": '<launch><arg name="speed" default="1"/></launch>'}
    include = '<include file="$(find-pkg-share robot)/launch/inner.launch.xml"><arg name="gain" value="1"/></include>'
    files = {f"launch/{name}.launch.xml": f"<launch>{include}</launch>" for name in ("first", "second", "third")}
    (one,) = findings("LCH003", **inner, **files)
    assert one.place.file == "launch/first.launch.xml"
    assert [related.place.file for related in one.related] == ["launch/second.launch.xml", "launch/third.launch.xml"]
    assert one.severity.label == "warning"


def test_a_file_that_hands_the_same_to_all_its_includes_is_told_once(findings):
    names = ("arm", "base", "camera")
    inner = {f"launch/{name}.launch.xml": f'<launch><arg name="{name}" default="1"/></launch>' for name in names}
    include = '<include file="$(find-pkg-share robot)/launch/{}.launch.xml"><arg name="fake" value="1"/></include>\n'
    (told,) = findings("LCH003", "".join(map(include.format, names)), **inner)
    assert told.message == ("arm.launch.xml declares no launch argument 'fake'; the same holds for 2 more launch files")
    assert [(row.place.line, row.message) for row in told.related] == [
        (2, "base.launch.xml declares no launch argument 'fake'"),
        (3, "camera.launch.xml declares no launch argument 'fake'"),
    ]


def test_what_a_file_hands_to_one_include_is_apart_from_what_it_hands_to_another(findings):
    names = ("arm", "base")
    inner = {f"launch/{name}.launch.xml": f'<launch><arg name="{name}" default="1"/></launch>' for name in names}
    include = '<include file="$(find-pkg-share robot)/launch/{0}.launch.xml"><arg name="x{0}" value="1"/></include>\n'
    told = findings("LCH003", "".join(map(include.format, names)), **inner)
    assert [row.place.line for row in told] == [1, 2]


def test_use_sim_time_handed_over_as_a_matter_of_course_is_information(findings):
    inner = {"launch/inner.launch.xml": '<launch><arg name="speed" default="1"/></launch>'}
    given = '<arg name="use_sim_time" value="false"/>'
    outer = f'<include file="$(find-pkg-share robot)/launch/inner.launch.xml">{given}</include>'
    (one,) = findings("LCH003", outer, **inner)
    assert one.severity.label == "info"


def test_use_sim_time_handed_to_many_is_told_once_for_a_folder(findings):
    inner = {f"launch/{name}.launch.xml": '<launch><arg name="speed" default="1"/></launch>' for name in "ab"}
    inner["more/c.launch.xml"] = inner["launch/a.launch.xml"]
    given = '<arg name="use_sim_time" value="false"/>'
    files = [*inner]
    outer = "\n".join(f'<include file="$(find-pkg-share robot)/{file}">{given}</include>' for file in files)
    setup = SETUP.replace("glob('config/*'))", "glob('config/*')), ('share/robot/more', glob('more/*'))")
    folder, other = findings("LCH003", outer, **inner, **{"setup.py": setup})
    told = "{}.launch.xml declares no launch argument 'use_sim_time'".format
    assert folder.message == f"{told('a')}; the same holds for 1 more launch file"
    assert [(row.place.line, row.message) for row in folder.related] == [(2, told("b"))]
    assert other.message == told("c")


BEFORE_ANOTHER = """\
<arg name="ns" default="front"/>
<include file="$(dirname)/view.launch.xml"><arg name="ns" value="GIVEN"/></include>
<node pkg="robot" exec="talker" namespace="NAMESPACE"/>
"""


@pytest.mark.parametrize(
    ("given", "namespace", "stays"),
    [
        ("", "$(var ns)", True),
        ("$(var ns)", "$(var ns)", False),  # it has this value anyway
        ("", "rear", False),
    ],
)
def test_what_an_include_does_not_take_stays_set_in_the_including_file(findings, given, namespace, stays):
    """An include is not scoped: whoever asks for ns:=left gets a talker without a namespace."""
    launch = BEFORE_ANOTHER.replace("GIVEN", given).replace("NAMESPACE", namespace)
    (found,) = findings("LCH003", launch, **{"launch/view.launch.xml": f"<launch>{node(exec='viewer')}</launch>"})
    assert "declares no launch argument 'ns'" in found.message
    assert found.message.endswith("so 'ns' stays set to this for the rest of this file") is stays
    assert [(one.place.line, one.message) for one in found.related] == [(3, "'ns' is read here")] * stays


READ_IN_CODE = """\
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, IncludeLaunchDescription, OpaqueFunction
from launch.launch_description_sources import AnyLaunchDescriptionSource
from launch.substitutions import LaunchConfiguration, PathJoinSubstitution, ThisLaunchFileDir
from launch_ros.actions import Node

def view(context):
    rate = {}
    source = AnyLaunchDescriptionSource(PathJoinSubstitution([ThisLaunchFileDir(), 'view.launch.xml']))
    return [IncludeLaunchDescription(source, launch_arguments={{'rate': rate}}.items())]

def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument('rate', default_value='10'),
        OpaqueFunction(function=view),
        Node(package='robot', executable='talker', parameters=[{{'rate': LaunchConfiguration('rate')}}]),
    ])
"""


@pytest.mark.parametrize(
    ("rate", "stays"),
    [
        ("LaunchConfiguration('rate').perform(context)", False),  # it has this value anyway
        ("context.launch_configurations.get('rate', '10')", False),
        ("context.launch_configurations['rate']", False),
        ("'10'", True),  # not what the user asks for
    ],
)
def test_what_code_reads_and_passes_on_changes_nothing(findings, rate, stays):
    files = {"launch/view.launch.xml": f"<launch>{node(exec='viewer')}</launch>"}
    (found,) = findings("LCH003", **files, **{"launch/all.launch.py": READ_IN_CODE.format(rate)})
    assert ("stays set to this" in found.message) is stays


def test_what_only_includes_give_a_value_is_read_after_them_on_purpose(findings):
    """Each include sets it; without them all, the launch would stop at the group."""
    include = '<include file="$(dirname)/view.launch.xml"><arg name="real" value="$(env REAL true)"/></include>\n'
    group = f'<group if="$(var real)">{node(exec="driver")}</group>'
    view = {"launch/view.launch.xml": f"<launch>{node(exec='viewer')}</launch>"}
    assert findings("LCH003", include * 2 + group, **view) == []
    (never_read,) = findings("LCH003", include, **view)
    assert never_read.help.startswith("the value has no effect")
    (declared,) = findings("LCH003", '<arg name="real" default="true"/>\n' + include + group, **view)
    assert "stays set to this" in declared.message


def test_what_a_scoped_include_does_not_take_is_gone_after_it(findings):
    launch = BEFORE_ANOTHER.replace("<include", "<group><include").replace("</include>", "</include></group>")
    launch = launch.replace("GIVEN", "").replace("NAMESPACE", "$(var ns)")
    (found,) = findings("LCH003", launch, **{"launch/view.launch.xml": f"<launch>{node(exec='viewer')}</launch>"})
    assert found.help.startswith("the value has no effect") and not found.related


GIVEN_TOO_EARLY = '<include file="$(dirname)/view.launch.xml"><arg name="world" value="hall"/></include>\n'


@pytest.mark.parametrize(
    ("later", "told"),
    [
        ('<include file="$(find-pkg-share simulator)/launch/it.launch.xml"/>', 0),
        ('<include file="$(dirname)/simulator.launch.xml"/>', 0),
        (
            '<include file="$(find-pkg-share simulator)/launch/it.launch.xml"><arg name="world" value="a"/></include>',
            1,
        ),
        ('<include file="$(dirname)/panel.launch.xml"/>', 1),
        ("", 1),
    ],
)
def test_an_argument_that_reaches_a_later_include(findings, later, told):
    """Includes are not scoped: what the first one does not take, a simulator that is not in the workspace may."""
    files = {
        "launch/view.launch.xml": f"<launch>{node(exec='viewer')}</launch>",
        "launch/panel.launch.xml": '<launch><arg name="ns" default=""/></launch>',
        "launch/simulator.launch.xml": f'<launch><arg name="world" default="a"/>{node(name="$(var world)")}</launch>',
    }
    assert len(findings("LCH003", GIVEN_TOO_EARLY + later, **files)) == told
    assert len(findings("LCH003", later + GIVEN_TOO_EARLY, **files)) == 1
    assert len(findings("LCH003", f"<group>{GIVEN_TOO_EARLY}</group>{later}", **files)) == 1


LATE_IN_THE_LIST = """\
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node

def generate_launch_description():
    side = DeclareLaunchArgument('side', default_value='left')
    talker = Node(package='robot', executable='talker', namespace=LaunchConfiguration('side'))
    return LaunchDescription([
        talker,
        side,
    ])
"""


def test_a_declaration_that_comes_late_in_the_list_has_to_move_there(findings):
    (told,) = findings("LCH003", **{"launch/a.launch.py": LATE_IN_THE_LIST})
    assert told.help == "put 'side' before 'talker' in the LaunchDescription: actions run in that order"
    assert told.place.line == 11  # 'side' in the list
    assert [(row.place.line, row.message) for row in told.related] == [
        (7, "it is declared here"),
        (8, "'side' is read here"),
        (10, "'talker' comes before it"),
    ]
    in_order = LATE_IN_THE_LIST.replace("        talker,\n        side,", "        side,\n        talker,")
    assert findings("LCH003", **{"launch/a.launch.py": in_order}) == []


@pytest.mark.parametrize(
    ("own", "severity"), [("", Severity.INFO), ('<arg name="other" default="a"/>', Severity.WARNING)]
)
def test_a_file_that_only_forwards_what_an_include_requires(findings, own, severity):
    inner = f'<launch><arg name="x"/>{node(name="$(var x)")}</launch>'
    outer = own + '<include file="$(dirname)/inner.launch.xml"><arg name="x" value="$(var x)"/></include>'
    (told,) = findings("LCH003", outer, **{"launch/inner.launch.xml": inner})
    assert (told.severity, told.place.file) == (severity, "launch/it.launch.xml")


PART = '<include file="$(dirname)/part.launch.xml"/>'


@pytest.mark.parametrize(
    ("whole", "more", "told"),
    [
        (f'<arg name="name" default="a"/><!-- {PART} -->', "", False),
        (f'<arg name="other" default="a"/><!-- {PART} -->', "", True),
        ('<arg name="name" default="a"/>', "", True),
        (f'<arg name="name" default="a"/><!-- {PART} -->', PART, True),
    ],
    ids=["commented out", "declares another", "never included", "included elsewhere"],
)
def test_a_part_whose_include_is_commented_out(findings, whole: str, more: str, told: bool):
    files = {
        "launch/part.launch.xml": f"<launch>{node(name='$(var name)')}</launch>",
        "launch/alone.launch.xml": f"<launch>{more}</launch>",
    }
    rows = findings("LCH003", whole + node(), **files)
    assert [row.place.file for row in rows] == ["launch/part.launch.xml"] * told


def test_a_part_of_what_another_file_includes(findings):
    files = {
        "launch/part.launch.xml": f"<launch>{node(name='$(var name)')}</launch>",
        "launch/middle.launch.xml": f"<launch><!-- {PART} -->{node()}</launch>",
    }
    top = '<arg name="name" default="a"/><include file="$(dirname)/middle.launch.xml"/>'
    assert findings("LCH003", top, **files) == []

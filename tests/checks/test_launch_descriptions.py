"""LCH008: what a launch file returns, and what it gives launch that is no list.

What launch says of each was tried with launch of Jazzy.
"""

from __future__ import annotations

import pytest

from archlint.config.settings import load
from archlint.engine.pipeline import Request, check
from archlint.finding import Severity

FILE = """\
from launch import LaunchDescription
from launch.actions import LogInfo
from launch_ros.actions import Node

def generate_launch_description():
    talker = Node(package='robot', executable='talker', {given})
    {rest}
"""


def _file(rest: str = "return LaunchDescription([talker])", given: str = "") -> dict[str, str]:
    return {"launch/it.launch.py": FILE.format(rest=rest, given=given)}


@pytest.mark.parametrize(
    ("rest", "message"),
    [
        ("LaunchDescription([talker])", "generate_launch_description() returns nothing"),
        ("return None if LaunchDescription([talker]) else None", None),
        ("return [talker]", "generate_launch_description() returns a list"),
        ("return LaunchDescription([talker]), 1", "generate_launch_description() returns a tuple"),
        ("return Node(package='robot', executable=talker)", "generate_launch_description() returns a single Node"),
        (
            "return LaunchDescription(Node(package='robot', executable=talker))",
            "LaunchDescription() is given a single Node, and launch wants a list",
        ),
        ("return LaunchDescription([[talker]])", "a list stands in the list of LaunchDescription()"),
        ("return LaunchDescription(['talker', talker])", "a string stands in the list of LaunchDescription()"),
        ("ld = LaunchDescription([talker])\n    return ld", None),
        ("return LaunchDescription([*[talker]])", None),
        ("return LaunchDescription((talker,))", None),
        ("return LaunchDescription([talker] + [LogInfo(msg='a')])", None),
        ("raise RuntimeError(talker)", None),
    ],
)
def test_what_a_launch_file_returns(findings, rest, message):
    told = findings("LCH008", **_file(rest))
    assert [one.severity for one in told] == [Severity.ERROR] * (message is not None)
    assert all(message in one.message for one in told)


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ("parameters={'rate': 1.0}", "parameters= of Node is given a dict, and launch wants a list"),
        ("parameters='config/p.yaml'", "parameters= of Node is given a string, and launch wants a list"),
        ("parameters=[{'rate', 1.0}]", "a set stands in parameters= of Node, where launch wants {'name': value}"),
        ("parameters=[{'rate', str(1.0)}]", "a set stands in parameters= of Node, where launch wants {'name': value}"),
        ("parameters=[{1.0}]", "a set stands in parameters= of Node, where launch wants {'name': value}"),
        ("parameters=[{('a', 1)}]", "a set stands in parameters= of Node, where launch wants {'name': value}"),
        (
            "parameters=[{'a.yaml', 'b.yaml'}]",
            "a set stands in parameters= of Node, where launch wants each file by itself",
        ),
        ("parameters=[{'config/p.yaml'}]", None),
        ("parameters=[{'/'.join(('config', 'p.yaml'))}, {'rate': 1.0}]", None),
        ("parameters=[{*('p.yaml',)}]", None),
        ("remappings={'a': 'b'}", "remappings= of Node is given a dict, and launch wants a list"),
        ("remappings=('a', 'b')", "a string stands in remappings= of Node, where launch wants ('from', 'to')"),
        ("remappings=[['a', 'b']]", "a list stands in remappings= of Node, where launch wants ('from', 'to')"),
        ("arguments='--fast'", "arguments= of Node is given a string, and launch wants a list"),
        ("arguments=['--fast', {'rate': 1.0}]", "a dict stands in arguments= of Node, where launch wants a text"),
        ("parameters=[{'rate': 1.0}, 'config/p.yaml']", None),
        ("parameters=[]", None),
        ("remappings=[('a', 'b')]", None),
        ("remappings=(('a', 'b'),)", None),
        ("arguments=['--fast']", None),
        ("parameters=list(())", None),
    ],
)
def test_what_a_node_is_given(findings, given, message):
    told = findings("LCH008", **_file(given=given))
    assert len(told) == (message is not None)
    assert all(message in one.message for one in told)


@pytest.mark.parametrize(
    ("package", "help"),
    [
        ("robot", "move it to parameters=: here its keys alone become words of the command line"),
        ("rqt_plot", "write its values as texts of the list: here its keys alone become words of the command line"),
    ],
)
def test_a_dict_among_the_arguments(findings, package: str, help: str):
    """A program of rqt has no parameters."""
    other = f"other = Node(package='{package}', executable='it', arguments=[{{'args': '/speed/data'}}])"
    (told,) = findings("LCH008", **_file(f"{other}\n    return LaunchDescription([talker, other])"))
    assert told.help == help


@pytest.mark.parametrize(
    ("rest", "message"),
    [
        (
            "other = Node(package='robot', executable='talker'),\n    return LaunchDescription([talker, other])",
            "'other' is a tuple, where launch wants an action: it stops with an AttributeError",
        ),
        (
            "return LaunchDescription([Node(package='robot', executable='talker')(talker)])",
            "this Node is called like a function: launch stops with a TypeError",
        ),
        ("other = talker,\n    return LaunchDescription([*other])", None),
        ("return LaunchDescription([Node(package='robot', executable='talker'), talker])", None),
    ],
)
def test_a_comma_too_many_or_too_few(findings, rest, message):
    told = findings("LCH008", **_file(rest))
    assert [one.message for one in told] == [message] * (message is not None)


OPAQUE = """\
from launch import LaunchDescription
from launch.actions import OpaqueFunction
from launch_ros.actions import Node

{function}

def generate_launch_description():
    return LaunchDescription([OpaqueFunction({given})])
"""
ONE = "Node(package='robot', executable='talker')"


@pytest.mark.parametrize(
    ("function", "given", "message"),
    [
        (
            f"def start(context):\n    return {ONE}",
            "function=start",
            "'start' returns a single Node, where launch wants",
        ),
        (f"def start(context):\n    one = {ONE}\n    return one", "function=start", "'start' returns a single Node"),
        (f"def start(context):\n    return LaunchDescription([{ONE}])", "function=start", "a single LaunchDescription"),
        (
            f"def start():\n    return [{ONE}]",
            "function=start",
            "'start' takes no argument, and launch passes the context",
        ),
        (
            f"def start(context=None):\n    return [{ONE}]",
            "function=start()",
            "'start' is called here, and OpaqueFunction",
        ),
        (f"def start(context):\n    return [{ONE}]", "function=start", None),
        (f"def start(*given):\n    return [{ONE}]", "function=start", None),
        (f"def start(context):\n    one = {ONE}\n    one = [one]\n    return one", "function=start", None),
        (f"def start(context, n):\n    return [{ONE}] * n", "function=start, args=[2]", None),
        (f"def make():\n    return lambda context: [{ONE}]", "function=make()", None),
        (f"def make():\n    def start(context):\n        return [{ONE}]\n    return start", "function=make()", None),
    ],
)
def test_the_function_of_an_opaque_function(findings, function, given, message):
    told = findings("LCH008", **{"launch/it.launch.py": OPAQUE.format(function=function, given=given)})
    assert len(told) == (message is not None)
    assert all(message in one.message for one in told)


def test_an_action_that_nothing_adds(findings):
    (told,) = findings("LCH008", **_file("return LaunchDescription([])"))
    assert told.message.startswith("nothing adds 'talker' to the launch description") and told.place.line == 6
    assert told.severity is Severity.INFO


LATER = "later = {}\n    return LaunchDescription([talker])"


@pytest.mark.parametrize(
    ("later", "help"),
    [
        ("TimerAction(period=3.0, actions=[talker])", "(), in place of 'talker', which it starts, or delete it"),
        (
            "RegisterEventHandler(OnProcessStart(target_action=talker, on_start=[LogInfo(msg='it runs')]))",
            "(), or delete it",
        ),
    ],
)
def test_an_action_for_another_one_that_nothing_adds(findings, later: str, help: str):
    """To add it beside the other would start that twice."""
    text = FILE.replace("LogInfo", "LogInfo, RegisterEventHandler, TimerAction").replace(
        "from launch_ros", "from launch.event_handlers import OnProcessStart\nfrom launch_ros"
    )
    (told,) = findings("LCH008", **{"launch/it.launch.py": text.format(given="", rest=LATER.format(later))})
    assert told.help == f"put 'later' into the list of LaunchDescription{help}"


OTHER = "talker = Node(package='robot', executable='listener')"


def test_an_action_whose_variable_gets_another(findings):
    (told,) = findings("LCH008", **_file(f"{OTHER}\n    return LaunchDescription([talker])"))
    assert told.message == "this Node is lost: before it is added, line 7 gives 'talker' another action"
    assert (told.place.line, told.severity) == (6, Severity.WARNING)
    assert told.help == "give each a variable of its own, and put both into the list of LaunchDescription()"


@pytest.mark.parametrize(
    ("given", "is_the_same"),
    [
        ("executable='talker', output='screen'", True),
        ("executable='talker', namespace='left'", False),
        ("executable='talker', arguments=['left']", False),
        ("executable=chosen", False),
    ],
)
def test_an_action_whose_variable_gets_one_that_starts_the_same_program(findings, given, is_the_same):
    other = f"chosen = 'talker'\n    talker = Node(package='robot', {given})"
    (told,) = findings("LCH008", **_file(f"{other}\n    return LaunchDescription([talker])"))
    assert (told.help or "").startswith("remove one: both start the same program; if two are meant, ") is is_the_same


@pytest.mark.parametrize(
    "between",
    [
        f"described = LaunchDescription([talker])\n    {OTHER}\n    described.add_action(talker)\n    return described",
        f"for _ in range(1):\n        {OTHER}\n    return LaunchDescription([talker])",
        f"{OTHER[:-1]}, namespace=talker.name)\n    return LaunchDescription([talker])",
        f"talker = {ONE}\n    return LaunchDescription([talker])",  # written twice, nothing is lost
    ],
)
def test_an_action_that_is_used_before_its_variable_gets_another(findings, between):
    assert findings("LCH008", **_file(between)) == []


@pytest.mark.parametrize(
    "action",
    [
        "SetEnvironmentVariable('ROS_DOMAIN_ID', '3')",
        "SetLaunchConfiguration('use_sim_time', 'true')",
        "SetParameter('use_sim_time', True)",
        "SetRemap('scan', 'front/scan')",
    ],
)
def test_a_setting_that_nothing_adds(findings, action):
    rest = f"setting = {action}\n    return LaunchDescription([talker])"
    more = "from launch.actions import *\nfrom launch_ros.actions import *\n"
    names = "SetEnvironmentVariable, SetLaunchConfiguration"
    more = f"from launch.actions import {names}\nfrom launch_ros.actions import SetParameter, SetRemap\n"
    (told,) = findings("LCH008", **{"launch/it.launch.py": more + _file(rest)["launch/it.launch.py"]})
    kind = action.partition("(")[0]
    assert told.message == f"nothing adds 'setting' to the launch description, so that launch never runs this {kind}"
    added = more + _file(rest.replace("[talker]", "[setting, talker]"))["launch/it.launch.py"]
    assert findings("LCH008", **{"launch/it.launch.py": added}) == []


@pytest.mark.parametrize(
    "rest",
    [
        "return LaunchDescription([\n        # talker,\n    ])",  # somebody has taken it out
        "ld = LaunchDescription()\n    ld.add_action(talker)\n    return ld",
        "ld = LaunchDescription()\n    # ld.add_action(talker_node)\n    return ld",  # it had another name then
        "return LaunchDescription(list(locals().values()))",
        '"""Add what you need: Talker, listener."""\n    return LaunchDescription([])',
    ],
)
def test_an_action_that_may_be_added_or_is_put_aside(findings, rest):
    assert findings("LCH008", **_file(rest)) == []


@pytest.mark.parametrize(("switches", "told"), [(("planner", "camera"), 0), (("planner",), 1)])
def test_what_a_board_of_switches_leaves_out(findings, switches: tuple[str, ...], told: int):
    lines = ["run = []"]
    for name in switches:
        lines += [f"with_{name} = False", f"{name} = Node(package='robot', executable='{name}')"]
        lines += [f"if with_{name}:", f"    run.append({name})"]
    file = _file("\n    ".join([*lines, "return LaunchDescription(run)"]))
    assert len(findings("LCH008", **file)) == told


@pytest.mark.parametrize(
    ("name", "package", "program", "told"),
    [
        ("slam_node", "nav2_amcl", "amcl", 0),
        ("slam_node", "nav2_map_server", "map_server", 1),  # may show a map that SLAM has nothing to do with
        ("amcl_node", "slam_toolbox", "async_slam_toolbox_node", 0),
        ("joint_state_publisher", "joint_state_publisher_gui", "joint_state_publisher_gui", 0),
        ("joint_state_publisher_gui", "joint_state_publisher", "joint_state_publisher", 0),
        ("joint_state_publisher", "robot_state_publisher", "robot_state_publisher", 1),
    ],
)
def test_an_action_of_which_the_file_starts_another_choice(findings, name, package, program, told):
    made = f"{name} = Node(package='robot', executable='talker')\n    "
    started = f"return LaunchDescription([talker, Node(package='{package}', executable='{program}')])"
    assert len(findings("LCH008", **_file(made + started))) == told


def test_what_is_made_beside_an_action_that_is_put_aside(findings):
    made = "planner = Node(package='robot', executable='planner')\n    return LaunchDescription([{}])"
    assert findings("LCH008", **_file(made.format("\n        # talker,\n    "))) == []
    (told,) = findings("LCH008", **_file(made.format("talker")))
    assert told.message.startswith("nothing adds 'planner'")


DECLARED = """\
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.conditions import IfCondition
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node

def generate_launch_description():
    gui = LaunchConfiguration('gui')
    declare_gui = DeclareLaunchArgument('gui', default_value='true')
    talker = Node(package='robot', executable='talker', {read})
    return LaunchDescription([talker])
"""


@pytest.mark.parametrize(
    ("read", "codes"),
    [
        ("", []),  # nothing would read it if it were added
        ("condition=IfCondition(gui)", ["LCH003"]),
        ("arguments=[gui]", ["LCH003"]),  # LCH003 says so where it is read
        (
            "arguments=[LaunchConfiguration('gui', default='no')]",
            ["LCH008"],
        ),  # nothing fails, but the value that is meant is not used
    ],
)
def test_a_declaration_that_nothing_adds_is_told_once(findings, read, codes):
    file = {"launch/it.launch.py": DECLARED.format(read=read)}
    assert [told.code for code in ("LCH003", "LCH008") for told in findings(code, **file)] == codes


@pytest.mark.parametrize(
    ("default", "help"),
    [
        ("'no'", "delete it: in the list it would change the default of 'gui'"),
        ("'true'", "put 'declare_gui' into the list of LaunchDescription(), or delete it"),
    ],
)
def test_a_declaration_with_another_default_than_what_reads_it(findings, default: str, help: str):
    read = f"arguments=[LaunchConfiguration('gui', default={default})]"
    (told,) = findings("LCH008", **{"launch/it.launch.py": DECLARED.format(read=read)})
    assert told.help == help


# ------------------------------------------------------------------------------ the name that launch looks for


@pytest.mark.parametrize("name", ["generate_launch_descriptions", "genrate_launch_description", "launch_setup", "main"])
def test_a_function_that_launch_does_not_find(findings, name):
    text = FILE.replace("generate_launch_description", name)
    for rest in ("return LaunchDescription([talker])", "ld = LaunchDescription([talker])\n    return ld"):
        (finding,) = findings("LCH008", **{"launch/py.launch.py": text.format(rest=rest, given="")})
        assert finding.message == (
            f"launch finds no generate_launch_description() in this file: the function is called '{name}'"
        )
        assert (finding.help, finding.place.line) == (f"rename '{name}' to generate_launch_description", 5)


@pytest.mark.parametrize(
    ("path", "more"),
    [
        ("launch/py.launch.py", "generate_launch_description = describe"),
        ("launch/py.launch.py", "from robot.launches import generate_launch_description"),
        ("launch/py.launch.py", "from robot.launches import *"),
        ("launch/py.launch.py", "globals()['generate_launch_description'] = describe"),
        ("launch/py.launch.py", "print(describe())"),
        ("launch/py.launch.py", "def generate_launch_description():\n    return describe()"),
        ("launch/helpers.py", ""),
        ("test/it_launch.py", ""),
    ],
)
def test_a_function_that_is_there_for_something_else(findings, path, more):
    text = FILE.replace("generate_launch_description", "describe")
    text = text.format(rest="return LaunchDescription([talker])", given="")
    assert findings("LCH008", **{path: f"{text}\n\n{more}\n"}) == []


def test_a_function_that_another_file_calls(findings):
    text = FILE.replace("generate_launch_description", "describe")
    other = "from robot.part_launch import describe\n\n\ndef generate_launch_description():\n    return describe()\n"
    files = {"launch/part_launch.py": text.format(rest="return LaunchDescription([talker])", given="")}
    assert len(findings("LCH008", **files)) == 1
    assert findings("LCH008", **files, **{"launch/it.launch.py": other}) == []


@pytest.mark.parametrize(("parameters", "count"), [("context", 1), ("context, *words", 1), ("a=1, *b, **c", 0)])
def test_a_parameter_that_launch_does_not_pass(findings, parameters, count):
    text = FILE.replace("description()", f"description({parameters})")
    rows = findings(
        "LCH008", **{"launch/py.launch.py": text.format(rest="return LaunchDescription([talker])", given="")}
    )
    assert [row.message for row in rows] == [
        "generate_launch_description() wants 'context', and launch passes nothing: a TypeError stops it"
    ] * count


# ------------------------------------------------------------------------------ includes of another language

INCLUDE = """\
from launch import LaunchDescription
from launch.actions import IncludeLaunchDescription
from {module} import {source}
from launch_ros.substitutions import FindPackageShare

def generate_launch_description():
    return LaunchDescription([
        IncludeLaunchDescription({source}([FindPackageShare('{package}'), '/launch/{file}'])),
    ])
"""
PYTHON, XML, YAML = (f"{kind}LaunchDescriptionSource" for kind in ("Python", "XML", "YAML"))


@pytest.mark.parametrize(
    ("source", "package", "file", "message"),
    [
        (PYTHON, "mavros", "px4.launch", "reads 'px4.launch' as Python, and it is XML: launch stops at this include"),
        (
            PYTHON,
            "robot",
            "arm.launch.xml",
            "reads 'arm.launch.xml' as Python, and it is XML: launch stops at this include",
        ),
        (
            XML,
            "mavros",
            "node.launch.yaml",
            "reads 'node.launch.yaml' as XML, and it is YAML: launch stops at this include",
        ),
        (
            YAML,
            "slam",
            "slam.launch.py",
            "reads 'slam.launch.py' as YAML, and it is Python: launch stops at this include",
        ),
        (PYTHON, "slam", "slam.launch.py", None),
        (XML, "mavros", "px4.launch", None),
        ("AnyLaunchDescriptionSource", "mavros", "px4.launch", None),
        (PYTHON, "robot", "base.launch", None),
    ],
)
def test_an_include_that_reads_another_language(findings, source, package, file, message):
    """base.launch is Python, whatever its name says."""
    module = {XML: "launch_xml.launch_description_sources", YAML: "launch_yaml.launch_description_sources"}
    text = INCLUDE.format(
        module=module.get(source, "launch.launch_description_sources"), source=source, package=package, file=file
    )
    others = {
        "launch/arm.launch.xml": "<launch/>\n",
        "launch/base.launch": FILE.format(rest="return LaunchDescription([talker])", given=""),
    }
    told = findings("LCH008", **{"launch/it.launch.py": text}, **others)
    assert [one.message for one in told] == ([f"{source} {message}"] if message else [])
    assert all(one.place.line == 8 for one in told)


def test_a_description_that_is_forgotten_altogether_is_one_finding(findings):
    [told] = findings("LCH008", **_file("print(Node)"))
    assert told.message.startswith("generate_launch_description() returns nothing")


def test_a_description_that_a_later_function_makes(findings):
    """Python keeps the last function of a name."""
    text = FILE.format(rest="return LaunchDescription([talker])", given="")
    early = "def generate_launch_description():\n    print('to do')\n\n\n"
    assert findings("LCH008", **{"launch/it.launch.py": early + text}) == []
    assert len(findings("LCH008", **{"launch/it.launch.py": text + "\n\n" + early})) == 1


@pytest.mark.parametrize(("package", "told"), [("your_package", 0), ("<package name>", 0), ("arm", 1)])
def test_a_file_in_no_package_that_is_there_to_be_copied(tmp_path, monkeypatch, package: str, told: int):
    monkeypatch.chdir(tmp_path)
    source = FILE.format(rest="print(Node)", given="").replace("package='robot'", f"package='{package}'")
    (tmp_path / "it.launch.py").write_text(source, encoding="utf-8")
    (tmp_path / "archlint.toml").write_text('select = ["LCH008"]\n', encoding="utf-8")
    rows = check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings
    assert [row.code for row in rows] == ["LCH008"] * told

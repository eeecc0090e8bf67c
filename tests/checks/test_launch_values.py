"""LCH008: what launch refuses of the values in a launch file."""

from __future__ import annotations

import pytest

from archlint.finding import Severity
from robot_package import node

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
        ("def main(words=sys.argv): print(words)", "pass", "output='log'", 3),
        ("@cached\ndef main(): pass", "pass", "output='log'", 3),
        ("", "import os", "output=os.environ.get(OUTPUT)", 6),
        ("", "with open('rate') as file: rate = file.read() or print(rates[0])", "output=str(RATE)", 6),
        ("", "with open(folder) as file: print(file)", "output='log'", 5),
    ],
)
def test_a_name_that_nothing_defines_stops_the_launch(findings, above, line, argument, at):
    files = {"launch/it.launch.py": NAMED.format(above=above, line=line, argument=argument)}
    (one,) = findings("LCH008", **files)
    assert one.message.endswith("is not defined: this launch file stops with a NameError before it starts anything")
    assert (one.place.file, one.place.line) == ("launch/it.launch.py", at)
    (gone,) = findings("LCH001", **files)  # what is wrong behind that line is told in the same run
    assert gone.identity == ("robot", "gone")


@pytest.mark.parametrize(
    ("written", "hint", "help"),
    [
        ("LaunchCOnfiguration", "; did you mean 'LaunchConfiguration'?", "write 'LaunchConfiguration'"),
        ("Executable", "", "write `from launch.descriptions import Executable`"),
        ("LaunchConfigurationEquals", "", "write `from launch.conditions import LaunchConfigurationEquals`"),
        ("Speed", "", "define or import 'Speed', or put it in quotes if it is meant as a string"),
    ],
)
def test_a_slip_in_a_name_that_is_imported(findings, written: str, hint: str, help: str):
    above = "from launch.substitutions import LaunchConfiguration"
    text = NAMED.format(above=above, line="pass", argument=f"output={written}('output')")
    (told,) = findings("LCH008", **{"launch/it.launch.py": text})
    assert told.message.endswith(f"before it starts anything{hint}")
    assert told.help == help


@pytest.mark.parametrize(
    ("above", "line", "argument"),
    [
        ("output = 'log'", "pass", "output=output"),
        ("from shared import *", "pass", "output=output"),
        ("", "global output; output = 'log'", "output=output"),
        ("def setup(output): pass", "pass", "output=str(output)"),  # bound elsewhere: let Python say it
        ("def setup(log: Level = None) -> Level: return later", "pass", "output='log'"),
        ("if __file__:\n    def main(words=sys.argv): pass", "pass", "output='log'"),
        ("", "output = [name for name in ('log',)][0]", "output=output"),
        ("", "for output in ('log',): pass", "output=output"),
        ("", "output: str = __file__", "output=output or other"),
        ("", "with open('x') as output: pass", "output=output"),
        ("", "(output := 'log')", "output=(lambda: later)() if False else output"),
        ("try:\n    rate = RATE\nexcept NameError:\n    rate = 3", "pass", "output='log'"),
        ("", "try: return LaunchDescription(load())\n    except NameError: pass", "output='log'"),
        ("import os.path", "if os.path.exists('x'): return None", "output=output"),
    ],
)
def test_a_name_that_is_defined_or_may_be(findings, above, line, argument):
    files = {"launch/it.launch.py": NAMED.format(above=above, line=line, argument=argument)}
    assert findings("LCH008", **files) == []


PERFORMED = """\
from launch import LaunchContext, LaunchDescription, conditions
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
        (
            "text = 'a' if conditions.IfCondition(kind).evaluate(None) else 'b'",
            "LaunchConfiguration is called with None, which",
        ),
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
        "text = 'a' if conditions.IfCondition('true').evaluate(None) else 'b'",  # which looks up no argument
        "start(None) if os.environ.get('TRY') else None",
        "text = LaunchConfiguration('other', default='a').perform(os.context)",
    ],
)
def test_a_substitution_that_is_performed_and_does_not_fail(findings, line):
    launch = {"launch/it.launch.py": PERFORMED.format(line=line)}
    assert findings("LCH008", **launch) == []
    assert findings("LCH003", **launch) == []


def test_an_error_that_is_caught_does_not_stop_the_launch(findings):
    tried = "try:\n        path = kind.perform({})\n    except TypeError:\n        path = 'a'"
    assert findings("LCH008", **{"launch/it.launch.py": PERFORMED.format(line=tried)}) == []


def test_conditions_of_one_kind_in_a_file_are_one_finding(findings):
    nodes = "Node(package='robot', executable='talker', name='{}', condition=lambda context: True)"
    text = ASKED.format(condition="lambda context: True")
    assert len(findings("LCH008", **{"launch/it.launch.py": text})) == 1
    start = text.index("Node(package")
    twice = text[:start] + nodes.format("a") + ", " + nodes.format("b") + ", " + text[start:]
    (one,) = findings("LCH008", **{"launch/it.launch.py": twice})
    assert [row.message for row in one.related] == ["here, too"] * 2


GIVEN = """\
from launch import LaunchDescription
from launch.actions import (
    DeclareLaunchArgument, ExecuteProcess, IncludeLaunchDescription, SetEnvironmentVariable, SetLaunchConfiguration,
)
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node, SetParameter
from elsewhere import unknown

def generate_launch_description():
    return LaunchDescription([
        {action},
    ])
"""


@pytest.mark.parametrize(
    ("action", "message", "help"),
    [
        (
            "DeclareLaunchArgument('speed', default_value=0.5)",
            "default_value= of this DeclareLaunchArgument is 0.5, which is no string: launch stops with a TypeError",
            "write the string '0.5'",
        ),
        (
            "DeclareLaunchArgument('speed', default_value=0 if unknown() else 1)",
            "default_value= of this DeclareLaunchArgument is 0, which is no string: launch stops with a TypeError",
            "write the string '0'",
        ),
        (
            "IncludeLaunchDescription('a.launch.py', launch_arguments={'sim': True}.items())",
            "the launch argument 'sim' is True, which is no string: launch stops with a TypeError",
            "write the string 'true'",
        ),
        (
            "IncludeLaunchDescription('a.launch.py', launch_arguments=[('sim', None)])",
            "the launch argument 'sim' is None, which is no string: launch stops with a TypeError",
            "write '', or leave the argument out",
        ),
        (
            "IncludeLaunchDescription('a.launch.py', launch_arguments={'sim': 'true'})",
            "launch_arguments= is a dict, of which launch sees the keys alone: it stops at this include",
            "add .items(), or write a list of pairs, [('name', 'value')]",
        ),
        (
            "Node(package='robot', executable='talker', arguments=['-x', 0])",
            "arguments= of this Node contains 0, which is no string: launch stops with a TypeError",
            "write the string '0'",
        ),
        (
            "ExecuteProcess(cmd=['sleep', ['0.', 5]])",
            "cmd= of this ExecuteProcess contains a list with 5, which is no string: launch stops with a TypeError",
            "write strings and substitutions only",
        ),
        (
            "SetEnvironmentVariable('ROS_DOMAIN_ID', 5)",
            "value= of this SetEnvironmentVariable is 5, which is no string: launch stops with a TypeError",
            "write the string '5'",
        ),
    ],
)
def test_what_is_no_text_to_launch(findings, action, message, help):
    (one,) = findings("LCH008", **{"launch/it.launch.py": GIVEN.format(action=action)})
    assert (one.message, one.help) == (message, help)
    assert (one.place.file, one.place.line) == ("launch/it.launch.py", 11)


@pytest.mark.parametrize(
    "action",
    [
        "DeclareLaunchArgument('speed', default_value='0.5')",
        "DeclareLaunchArgument('speed', default_value=None)",
        "DeclareLaunchArgument('speed', default_value=['0.', LaunchConfiguration('digits', default=5)])",
        "DeclareLaunchArgument('speed', default_value=unknown())",
        "DeclareLaunchArgument('speed', default_value=0 if unknown() else '1')",
        "IncludeLaunchDescription('a.launch.py', launch_arguments={})",
        "IncludeLaunchDescription('a.launch.py', launch_arguments={'sim': str(True)}.items())",
        "SetLaunchConfiguration('speed', f'{0.5}')",
        "SetParameter('speed', 0.5)",
        "Node(package='robot', executable='talker', arguments=[str(0)], parameters=[{'speed': 5}])",
    ],
)
def test_what_launch_makes_a_text_of(findings, action):
    assert findings("LCH008", **{"launch/it.launch.py": GIVEN.format(action=action)}) == []


PARAMETERS = """\
from pathlib import Path
from ament_index_python.packages import get_package_share_directory, get_package_share_path
from launch import LaunchDescription
from launch_ros.actions import Node
from elsewhere import unknown

def generate_launch_description():
    config = Path(get_package_share_directory('robot'), 'config')
    maps = get_package_share_path('robot') / 'maps'
    found = {{}}
    for name in unknown():
        found[name] = 1
    return LaunchDescription([
        Node(package='robot', executable='talker', parameters={parameters}),
    ])
"""


@pytest.mark.parametrize(
    ("parameters", "says", "help"),
    [
        ("[{'map': config / 'hall.yaml'}]", "'map' is a pathlib.Path", "write str(…) around the path"),
        ("['a.yaml', {'rate': 1, 'map': maps}]", "'map' is a pathlib.Path", "write str(…) around the path"),
        ("[{'maps': {'hall': maps / 'hall.yaml'}}]", "'maps.hall' is a pathlib.Path", "write str(…) around the path"),
        ("[{'map': None}]", "'map' is None", "leave it out, or give it a value"),
    ],
)
def test_a_value_that_no_parameter_can_have(findings, parameters, says, help):
    (one,) = findings("LCH008", **{"launch/it.launch.py": PARAMETERS.format(parameters=parameters)})
    assert one.message == f"the parameter {says}, which none can be: launch stops with a TypeError"
    assert (one.place.line, one.help) == (14, help)


@pytest.mark.parametrize(
    "parameters",
    [
        "[config / 'talker.yaml']",
        "[{'map': str(config / 'hall.yaml')}]",
        "[{'map': (config / 'hall.yaml').as_posix()}]",
        "[{'map': f'{maps}/hall.yaml', 'name': maps.name}]",
        "[{'map': unknown(maps)}]",
        "[{'map': None if unknown() else 'hall'}]",
        "[{'map': None, **unknown()}]",
        "[found]",
    ],
)
def test_a_value_that_a_parameter_may_have(findings, parameters):
    assert findings("LCH008", **{"launch/it.launch.py": PARAMETERS.format(parameters=parameters)}) == []


READS = """\
import os
import yaml
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, OpaqueFunction
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def read(name):
    with open(os.path.join(get_package_share_directory('robot'), 'config', name)) as file:
        return yaml.safe_load(file)


def start(context):
    data = read(LaunchConfiguration('file').perform(context))
    return [Node(package='robot', executable='talker', namespace=data['nmae'])]


def generate_launch_description():
    data = read('c.yaml')
    {line}
    return LaunchDescription([Node(package='robot', executable='talker'){more}])
"""
HELD = "controller:\n  gain: 1.0\n  limits: {speed: 2.0}\nname: left\n"


def _read(findings, line: str, held: str = HELD, more: str = ""):
    return findings("LCH008", **{"launch/it.launch.py": READS.format(line=line, more=more), "config/c.yaml": held})


@pytest.mark.parametrize(
    ("line", "message", "help"),
    [
        ("data['controller']['gains']", "has no 'gains' here", "write 'gain'"),
        ("data['controller']['limits']['speeed']", "has no 'speeed' here", "write 'speed'"),
        ("limits = data['limits']", "has no 'limits' here", "to the file, or take what is there: controller, name"),
        ("data['controller']['gains']['p'] = 1.0", "has no 'gains' here", "write 'gain'"),
    ],
)
def test_a_key_that_a_file_does_not_have(findings, line: str, message: str, help: str):
    (told,) = _read(findings, line)
    assert f"config/c.yaml {message}: this launch file stops with a KeyError" in told.message
    assert told.help.endswith(help)
    assert told.place.line == 22


def test_several_keys_that_a_file_does_not_have_are_one_finding(findings):
    """Launch stops at the first of them."""
    (told,) = _read(findings, "speed = data['speed']\n    limits = data['limits']\n    other = data['limits']")
    assert told.message.endswith(
        "has no 'speed' here: this launch file stops with a KeyError; another key is not there, either"
    )
    assert [(row.place.line, "'limits'" in row.message) for row in told.related] == [(23, True)]


def test_a_key_that_an_opaque_function_asks_for(findings):
    more = ", DeclareLaunchArgument('file', default_value='c.yaml'), OpaqueFunction(function=start)"
    (told,) = _read(findings, "", more=more)
    assert told.message.endswith("has no 'nmae' here: this launch file stops with a KeyError; did you mean 'name'?")


@pytest.mark.parametrize(
    "line",
    [
        "data['controller']['gain']",
        "data.get('gains', 1.0)",
        "data['gains'] if 'gains' in data else 1.0",
        "'gains' in data and data['gains']",
        "data['gains'] = 1.0; data['gains']",
        "data.update(os.environ); data['gains']",
        "data.setdefault('gains', 1.0); data['gains']",
        "data = dict(data, gains=1.0); data['gains']",
        "data = {**data, 'gains': 1.0}; data['gains']",
        "[data[key] for key in data]",
        "[data[key] for key in ('gains', 'name') if key in data]",
        "import sys\n    if len(sys.argv) > 3:\n        data['gains']",
        "try:\n        data['gains']\n    except KeyError:\n        pass",
        "data[os.environ['KEY']]",
        "data = read('of_the_machine.yaml')['gains']",
    ],
)
def test_a_key_that_is_there_or_may_be(findings, line: str):
    assert _read(findings, line) == []


def test_a_file_that_is_a_list_and_one_with_a_merged_map(findings):
    assert _read(findings, "data[0]['name']", "- name: left\n") == []
    assert _read(findings, "data['b']['x']", "a: &a {x: 1}\nb: {<<: *a, y: 2}\n") == []


EXPRESSION = """\
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.conditions import IfCondition
from launch.substitutions import LaunchConfiguration, PythonExpression
from launch_ros.actions import Node

def generate_launch_description():
    gui = LaunchConfiguration('gui')
    return LaunchDescription([
        DeclareLaunchArgument('gui'{default}),
        Node(package='robot', executable='talker', condition=IfCondition(PythonExpression({expression}))),
    ])
"""


@pytest.mark.parametrize(
    ("default", "expression", "name"),
    [
        (", default_value='false'", "['not ', gui]", "false"),
        (", default_value='true'", "[gui, ' and 1 < 2']", "true"),
        (", default_value='slam'", "[gui, ' == \"slam\"']", "slam"),
        (", default_value='slam'", "['\"slam\" in [', gui, ']']", None),  # a list may be followed one day
        (", default_value='False'", "['not ', gui]", None),
        (", default_value='false'", "['\"', gui, '\" == \"true\"']", None),
        (", default_value='false'", "['False and ', gui]", None),  # it is never read
        (", default_value='1.0'", "[gui, ' < pi']", None),  # a name of math
        (", default_value='1.0'", "[gui, ' < wheel.size']", None),
        ("", "['not ', gui]", None),  # whoever launches the file may say True
    ],
)
def test_a_launch_argument_in_an_expression_of_python(findings, default, expression, name):
    """Tried with launch of Jazzy: ``name 'false' is not defined``."""
    code = EXPRESSION.format(default=default, expression=expression)
    messages = [finding.message for finding in findings("LCH008", **{"launch/py.launch.py": code})]
    assert [message.split(":")[0] for message in messages] == ([f"Python knows no '{name}'"] if name else [])


def test_an_expression_in_xml(findings):
    launch = '<arg name="gui" default="true"/>' + node(**{"if": "$(eval 'not $(var gui)')"})
    (finding,) = findings("LCH008", launch)
    assert finding.message == ("Python knows no 'true': the expression `not true` stops this launch with a NameError")

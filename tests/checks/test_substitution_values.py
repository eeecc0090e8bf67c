"""LCH006: substitutions that the code of a launch file takes for their values."""

from __future__ import annotations

import pytest

from archlint.finding import Severity

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
    ("line", "said", "help"),
    [
        ("path = os.path.join(FindPackageShare('robot'), 'launch')", "a FindPackageShare", "_directory('robot')"),
        ("path = os.path.join('/robots', kind, 'a.urdf')", "a LaunchConfiguration", "PathJoinSubstitution([…])"),
        ("path = open(os.path.join(FindPackageShare(kind), 'a'))", "a FindPackageShare", "PathJoinSubstitution([…])"),
    ],
)
def test_a_substitution_that_is_taken_for_a_path(findings, line, said, help):
    (one,) = findings("LCH006", **{"launch/it.launch.py": PERFORMED.format(line=line)})
    assert f"os.path.join() is called with {said}, which is not a string" in one.message and help in one.help
    assert one.place.line == 14 and one.severity is Severity.ERROR


def test_a_comma_that_makes_a_tuple(findings):
    line = "folder = get_package_share_directory('robot'),\n    path = os.path.join(folder, 'launch')"
    source = PERFORMED.format(line=line).replace("import os\n", f"import os\n{IMPORT}\n", 1)
    (one,) = findings("LCH006", **{"launch/it.launch.py": source})
    assert one.message == (
        "os.path.join() is called with a tuple, which is not a string: the launch stops here with a TypeError"
    )
    assert one.help == "remove the comma at the end of the line that makes the tuple"


IMPORT = "from ament_index_python.packages import get_package_share_directory"


@pytest.mark.parametrize(
    "line",
    [
        "path = os.path.join(*('robots', 'launch'))",
        "path = os.path.join(('robots', 'launch')[0], 'launch')",
        "path = PathJoinSubstitution([FindPackageShare('robot'), 'launch'])",
        "path = os.path.join(start.__name__, 'launch')",
        "path = os.path.join(FindPackageShare('robot').find('robot'), 'launch')",
        "path = os.path.join(kind, 'launch') if os.environ.get('TRY') else ''",
        "path = os.path.join(kind.perform(os.context), 'launch')",
    ],
)
def test_what_is_a_path_or_may_be_one(findings, line):
    assert findings("LCH006", **{"launch/it.launch.py": PERFORMED.format(line=line)}) == []


def test_a_join_that_is_tried(findings):
    tried = "try:\n        path = os.path.join(kind, 'a')\n    except TypeError:\n        path = 'a'"
    assert findings("LCH006", **{"launch/it.launch.py": PERFORMED.format(line=tried)}) == []


def test_a_join_in_an_opaque_function(findings):
    text = PERFORMED.replace("{line}", "").replace("name=text)", "name=os.path.join(LaunchConfiguration('kind'), 'a'))")
    (one,) = findings("LCH006", **{"launch/it.launch.py": text})
    assert one.place.line == 10


WRITTEN = """\
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, OpaqueFunction
from launch.conditions import IfCondition
from launch.substitutions import LaunchConfiguration, PathJoinSubstitution
from launch_ros.actions import Node

def start(context, ns=None):
    sim = LaunchConfiguration('sim').perform(context)
    kind = LaunchConfiguration('kind').perform(context)
    value = {there}
    return []

def generate_launch_description():
    lc = LaunchConfiguration('sim')
    either = None
    if start:
        either = LaunchConfiguration('kind')
    value = {here}
    return LaunchDescription([
        DeclareLaunchArgument('sim', default_value='true'),
        DeclareLaunchArgument('kind', default_value='small'),
        OpaqueFunction(function=start, kwargs={{'ns': lc}}),
        Node(package='robot', executable='talker'),
    ])
"""


def _written(here: str = "''", there: str = "''") -> dict[str, str]:
    return {"launch/it.launch.py": WRITTEN.format(here=here, there=there)}


@pytest.mark.parametrize(
    ("here", "message", "help"),
    [
        ("'a' + lc", "'+' has a LaunchConfiguration as an operand", "write a list"),
        ("LaunchConfiguration('sim') + '/x'", "'+' has a LaunchConfiguration as an operand", "write a list"),
        ("PathJoinSubstitution(['a']) + '/x'", "'+' has a PathJoinSubstitution as an operand", "write a list"),
        ("f'robot_{lc}.urdf'", "this makes a string of the LaunchConfiguration itself", "write a list"),
        ("'robot_%s' % lc", "this makes a string of the LaunchConfiguration itself", "write a list"),
        ("'%s_%s' % ('a', lc)", "this makes a string of the LaunchConfiguration itself", "write a list"),
        ("str(lc)", "str() is called with a LaunchConfiguration", "in an OpaqueFunction, with the text"),
        ("[str(lc)]", "str() is called with a LaunchConfiguration", "the substitution itself"),
        ("[str(lc) if start else '']", "str() is called with a LaunchConfiguration", "in an OpaqueFunction"),
        ("dict(rate=int(lc))", "int() is called with a LaunchConfiguration", "the substitution itself"),
        ("start([str(lc), 'b'])", "str() is called with a LaunchConfiguration", "in an OpaqueFunction"),
        ("list(open(lc))", "open() is called with a LaunchConfiguration", "in an OpaqueFunction"),
        ("lc == 'true'", "so that this is always false", "EqualsSubstitution"),
        ("'true' != lc", "so that this is always true", "NotEqualsSubstitution"),
        ("lc in ['a', 'b']", "so that this is always false", "EqualsSubstitution"),
        ("lc and LaunchConfiguration('kind')", "'and' takes it for true", "AndSubstitution"),
        ("lc or 'true'", "'or' takes it for true", "OrSubstitution"),
        ("not lc", "this test takes it for true", "condition=IfCondition"),
        ("1 if lc else 2", "this test takes it for true", "use PythonExpression"),
        ("1 if start and lc else 2", "this test takes it for true", "use PythonExpression"),
        ("lc if lc else None", "this test takes it for true", "condition=IfCondition"),
    ],
)
def test_a_substitution_that_is_taken_for_its_value(findings, here, message, help):
    (told,) = findings("LCH006", **_written(here))
    assert message in told.message and help in told.help
    assert told.place.line == 18


@pytest.mark.parametrize(
    "there",
    ["1 if sim else 2", "not sim", "1 if context.launch_configurations['sim'] else 2", "2 if kind and sim else 1"],
)
def test_the_text_of_a_switch_that_is_taken_for_its_truth(findings, there):
    (told,) = findings("LCH006", **_written(there=there))
    assert "the text of the launch argument 'sim' is tested" in told.message
    assert told.place.line == 10


@pytest.mark.parametrize(
    "there",
    [
        "1 if kind else 2",  # an empty text is a value that people use
        "sim == 'true'",
        "sim.lower() in ('true', '1')",
        "sim or 'false'",
        "f'robot_{kind}' + sim",
        "1 if ns else 2",
        "ns or ''",
    ],
)
def test_a_text_and_what_may_be_given_or_not(findings, there):
    assert findings("LCH006", **_written(there=there)) == []


@pytest.mark.parametrize(
    "here",
    [
        "['a', lc]",
        "[lc] + ['x']",
        "1 if either else 2",
        "either is None",
        "lc is not None",
        "lc == None",
        "lc if start else None",
        "start and lc",
        "IfCondition(lc)",
        "print(f'{lc}')",
        "print('kind: ' + str(lc))",
        "logger.info(f'{lc}')",
        "logging.warning('kind: %s' % lc)",
        "get_logger('robot').debug(f'{lc}')",
        "f'{start}'",
        "[1 for lc in ('a', 'b') if lc]",
    ],
)
def test_a_substitution_that_launch_performs(findings, here):
    assert findings("LCH006", **_written(here)) == []


def test_what_is_logged_cannot_be_a_sum_with_a_substitution_either(findings):
    (told,) = findings("LCH006", **_written("logger.info('kind: ' + lc)"))
    assert "the launch stops here with a TypeError" in told.message


def test_a_text_with_a_substitution_for_anything_but_a_log(findings):
    (told,) = findings("LCH006", **_written("catalog.info(f'{lc}')"))
    assert "a string of the LaunchConfiguration itself" in told.message


def test_a_class_of_another_library_with_the_same_name(findings):
    text = WRITTEN.format(here="'a' + lc", there="''").replace("from launch.substitutions", "from elsewhere")
    assert findings("LCH006", **{"launch/it.launch.py": text}) == []


def test_what_is_wrong_in_the_same_way_in_one_file_is_one_finding(findings):
    (told,) = findings("LCH006", **_written("['a' + lc, lc + 'b']"))
    assert [row.message for row in told.related] == ["here, too"]


ACTION = "Node(package='robot', executable='talker', {})"


@pytest.mark.parametrize(
    ("arguments", "help"),
    [
        # A condition is an object that launch_ros refuses as the value of a parameter.
        ("parameters=[{'once': lc == 'false'}]", "use EqualsSubstitution(…, …)"),
        ("parameters=[{'once': 'false' != lc}]", "use NotEqualsSubstitution(…, …)"),
        ("arguments=['--once', lc == 'false']", "use EqualsSubstitution(…, …)"),
        ("parameters=[{'once': lc == 'no' or lc == 'never'}]", "use OrSubstitution(EqualsSubstitution(…, …), …)"),
        ("arguments=[lc != 'a' and lc != 'b']", "use AndSubstitution(NotEqualsSubstitution(…, …), …)"),
        ("condition=lc == 'a' or lc == 'b'", "use IfCondition(EqualsSubstitution(…, …))"),
        (
            "arguments=['--once' if lc == 'true' else '']",
            """use PythonExpression(["'…' if '", …, "' == '…' else '…'"])""",
        ),
        ("condition=IfCondition(lc == 'false')", "use EqualsSubstitution(…, …)"),
        ("condition=lc == 'false'", "use IfCondition(EqualsSubstitution(…, …))"),
    ],
)
def test_a_comparison_that_is_a_value_needs_no_condition(findings, arguments, help):
    (told,) = findings("LCH006", **_written(ACTION.format(arguments)))
    assert told.help == help


@pytest.mark.parametrize(
    ("arguments", "count"),
    [
        ("condition=IfCondition(lc), arguments=['-d'] if lc else []", 0),
        ("condition=IfCondition(LaunchConfiguration('sim')), arguments=['-d'] if lc else []", 0),
        ("condition=IfCondition(LaunchConfiguration('kind')), arguments=['-d'] if lc else []", 1),
        ("condition=UnlessCondition(lc), arguments=['-d'] if lc else []", 1),
        ("arguments=['-d'] if lc else []", 1),
    ],
)
def test_a_test_of_what_the_action_has_as_its_condition(findings, arguments, count):
    assert len(findings("LCH006", **_written(ACTION.format(arguments)))) == count

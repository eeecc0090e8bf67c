"""Code in launch files: loops, functions, classes of their own."""

from __future__ import annotations

import pytest

from launching import names, node, parameters


def test_loops_and_helpers(launches):
    launched = launches.python(
        "[make(name) for name in ('a', 'b')]",
        before="def make(name):\n    return Node(package='robot', executable='talker', name=f'{name}_node')",
    )
    assert names(launched) == ["a_node", "b_node"]


def test_opaque_functions_see_the_context(launches):
    launched = launches.python(
        "[DeclareLaunchArgument('count', default_value='2'), OpaqueFunction(function=setup)]",
        before=(
            "def setup(context):\n"
            "    count = int(LaunchConfiguration('count').perform(context))\n"
            "    ns = context.launch_configurations['count']\n"
            "    return [Node(package='robot', executable='talker', name=f'n{i}', namespace='r' + ns)\n"
            "            for i in range(count)]"
        ),
    )
    assert names(launched) == ["/r2/n0", "/r2/n1"]


def test_a_description_may_grow_while_it_runs(launches):
    launches.file(
        "robot/launch/it.launch.py",
        "from launch import LaunchDescription\nfrom launch.actions import OpaqueFunction\n"
        "from launch_ros.actions import Node\n"
        "def setup(context, ld):\n    ld.add_action(Node(package='robot', executable='talker', name='late'))\n"
        "def generate_launch_description():\n    ld = LaunchDescription()\n"
        "    ld.add_action(OpaqueFunction(function=setup, args=[ld]))\n    return ld\n",
    )
    assert names(launches.run("robot/launch/it.launch.py")) == ["late"]


def test_a_branch_of_the_code_that_nothing_decides(launches):
    launched = launches.python(
        "actions",
        before=(
            "actions = []\nif os.environ['ROBOT'] == 'a':\n    actions.append(" + node("a") + ")\n"
            "else:\n    actions.append(" + node("b") + ")"
        ),
    )
    one, other = (dict(started.branch_arms) for started in launched.started)
    assert one.keys() == other.keys() and one != other


@pytest.mark.parametrize("grow", ["d += [{0}]", "d.append({0})", "d.extend([{0}])"])
@pytest.mark.parametrize("rounds", ["os.listdir('robots')", "('r1',)"])
def test_a_list_that_grows_in_a_loop_is_one_list(launches, grow, rounds):
    """Whether the loop's rounds are known or not, what was in the list before is started once."""
    loop = f"d = [{node('first')}]\nfor r in {rounds}:\n    {grow.format(node('more'))}"
    assert names(launches.python("d", before=loop)) == ["first", "more"]
    assert names(launches.python("[GroupAction(d)]", before=loop)) == ["first", "more"]


def test_a_name_for_the_list_sees_it_grow(launches):
    before = f"d = []\nactions = d\nd += [{node('late')}]"
    assert names(launches.python("actions", before=before)) == ["late"]


def test_a_new_list_does_not_change_the_old_one(launches):
    before = f"d = []\nactions = d\nd = d + [{node('late')}]"
    assert names(launches.python("actions", before=before)) == []


def test_two_processes_of_one_helper_in_a_handler_are_two(launches):
    launched = launches.python(
        "[first, RegisterEventHandler(OnProcessExit(target_action=first, on_exit=[spawner('a'), spawner('b')]))]",
        "def spawner(controller):\n"
        "    return Node(package='controller_manager', executable='spawner', arguments=[controller])\n"
        "first = Node(package='robot', executable='talker')",
    )
    assert [started.arguments for started in launched.started] == [[], ["a"], ["b"]]


@pytest.mark.parametrize(("distro", "expected"), [("jazzy", "new"), ("humble", "old"), (None, None)])
def test_the_distribution_decides_only_where_it_is_said(launches, distro, expected):
    launches.python(
        "[Node(package='p', executable=name), Node(package='p', executable=other),"
        " Node(package='p', executable=['as_', EnvironmentVariable('ROS_DISTRO')])]",
        "name = 'old' if os.environ['ROS_DISTRO'] == 'humble' else 'new'\n"
        "other = 'old' if os.getenv('ROS_DISTRO', 'rolling') == 'humble' else 'new'",
    )
    one, other, last = launches.of_workspace(distro).run("robot/launch/it.launch.py").started
    assert [one.executable.text, other.executable.text] == [expected, expected]
    assert last.executable.text == (f"as_{distro}" if distro else "as_*")


@pytest.mark.parametrize("as_text", ["str(path)", "path.__str__()", "path.as_posix()"])
def test_a_path_as_text(launches, as_text):
    launches.file("robot/launch/inner.launch.xml", '<launch><node pkg="p" exec="inner"/></launch>')
    launched = launches.python(
        f"[IncludeLaunchDescription(AnyLaunchDescriptionSource({as_text}))]",
        "from pathlib import Path\npath = Path(get_package_share_directory('robot'), 'launch', 'inner.launch.xml')",
    )
    assert [one.executable.text for one in launched.started] == ["inner"] and not launched.gaps


def test_lists_that_are_summed_up(launches):
    launched = launches.python(
        "sum(([Node(package='p', executable=name)] for name in ('a', 'b')), [Node(package='p', executable='first')])"
    )
    assert [one.executable.text for one in launched.started] == ["first", "a", "b"]
    numbers = launches.python("[Node(package='p', executable='e', parameters=[{'n': sum([1, 2, 3])}])]")
    assert parameters(numbers.started[0]) == {"n": 6}
    unknown = launches.python("sum((nodes_of(name) for name in ('a', 'b')), [])", "from elsewhere import nodes_of")
    assert not unknown.started and unknown.gaps


def test_the_entities_of_a_description_are_actions(launches):
    launched = launches.python(
        "[OpaqueFunction(function=setup)]",
        "def setup(context):\n"
        "    made = LaunchDescription([Node(package='p', executable='first')])\n"
        "    made.add_action(Node(package='p', executable='second'))\n"
        "    return made.entities",
    )
    assert [one.executable.text for one in launched.started] == ["first", "second"] and not launched.gaps
    unknown = launches.python("LaunchDescription(nodes_of('a')).entities", "from elsewhere import nodes_of")
    assert not unknown.started and unknown.gaps


HELPERS = """\
import logging, os
from pathlib import Path
from launch.logging import get_logger
def value_of(text):
    try:
        return int(text)
    except ValueError:
        pass
    try:
        return float(text)
    except ValueError:
        return text
def flat(data, above='', found=None):
    found = {} if found is None else found
    for key, value in data.items():
        if isinstance(value, dict):
            flat(value, above + key + '.', found)
        else:
            found[above + key] = value
    return found
def endless(depth):
    return endless(depth + 1)
def read(text):
    try:
        logging.getLogger('launch').info(f'reading {text}')
        logging.debug('reading')
        get_logger().warning('reading')
        return 'read_' + text
    except OSError:
        return 'default'
"""


@pytest.mark.parametrize(
    ("expression", "expected"),
    [
        ("f\"{value_of('8')}_{value_of('0.5')}_{value_of('fast')}\"", "8_0.5_fast"),
        ("str(value_of(os.environ['NUMBER']))", "?"),
        # A driver has hundreds of parameters.
        ("[value_of(str(number)) for number in range(400)][-1] and 'all'", "all"),
        ("'-'.join(flat({'a': {'b': {'c': {'d': 'e'}}}, 'f': 'g'}))", "a.b.c.d-f"),
        ("endless(1)", "?"),
        # What is logged fails no more than what is printed.
        ("read('it')", "read_it"),
    ],
)
def test_helpers_of_launch_files(launches, expression, expected):
    assert names(
        launches.python("[Node(package='r', executable='t', name=name)]", f"{HELPERS}name = {expression}")
    ) == [expected]


SHARE = "get_package_share_directory('robot')"


@pytest.mark.parametrize(
    ("path", "expected"),
    [
        (f"Path({SHARE}).parent", "$(find-pkg-prefix robot)/share"),
        (f"Path({SHARE}).parents[1] / 'lib'", "$(find-pkg-prefix robot)/lib"),
        (f"os.path.dirname(os.path.dirname({SHARE}))", "$(find-pkg-prefix robot)"),
        (f"os.path.dirname({SHARE} + '/config')", "$(find-pkg-share robot)"),
        (f"os.path.abspath({SHARE} + '/config/../maps')", "$(find-pkg-share robot)/maps"),
        (f"os.path.normpath({SHARE} + '/../../lib')", "$(find-pkg-prefix robot)/lib"),
        ("Path(__file__).resolve().parents[1] / 'config'", "$(workspace)/robot/config"),
        ("Path(__file__).parents[1]", "$(workspace)/robot"),
    ],
)
def test_the_folders_around_a_path(launches, path, expected):
    before = f"import os\nfrom pathlib import Path\npath = str({path})"
    assert names(launches.python("[Node(package='r', executable='t', name=path)]", before)) == [expected]


@pytest.mark.parametrize(
    "path",
    [f"Path({SHARE}).parents[3]", f"Path({SHARE}).parents[2] / 'src'", f"os.path.abspath({SHARE} + '/../../..')"],
)
def test_nobody_knows_what_is_around_an_installed_package(launches, path):
    before = f"import os\nfrom pathlib import Path\npath = {path}"
    [started] = launches.python("[Node(package='r', executable='t', name=path)]", before).started
    assert (started.name.text, started.name.reason) == (None, "where the workspace is installed")


def test_the_arguments_that_a_description_declares(launches):
    before = f"""\
ld = LaunchDescription([DeclareLaunchArgument('ns', default_value='robot')])
given = {{argument.name: LaunchConfiguration(argument.name) for argument in ld.get_launch_arguments()}}
ld.add_action(GroupAction([{node("a", namespace="LaunchConfiguration('ns')")}], launch_configurations=given,
    forwarding=False))"""
    assert names(launches.python("ld.entities", before)) == ["/robot/a"]


SUBSTITUTIONS = "from launch.frontend.parse_substitution import parse_substitution\n"


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("$(var robot)_base", "arm_base"),
        ("base", "base"),
        ("2.5", 2.5),  # read as YAML, as the text of any substitution
        ("$(find-pkg-share robot)/x.urdf", "$(find-pkg-share robot)/x.urdf"),
    ],
)
def test_a_text_with_substitutions_in_python(launches, text: str, value: object):
    launched = launches.python(
        "[DeclareLaunchArgument('robot', default_value='arm'), "
        f"Node(package='p', executable='e', parameters=[{{'frame': parse_substitution('{text}')}}])]",
        SUBSTITUTIONS,
    )
    assert parameters(launched.started[0]) == {"frame": value}


def test_an_action_that_code_executes_sets_its_configuration(launches):
    body = (
        "def made(context):\n"
        "    SetLaunchConfiguration('robot', parse_substitution('left_arm')).execute(context)\n"
        "    SetLaunchConfiguration('side', 'left', condition=IfCondition('false')).execute(context)\n"
        "    return [Node(package='p', executable='e', name=LaunchConfiguration(name).perform(context)) "
        "for name in ('robot', 'side')]\n"
    )
    launched = launches.python("[OpaqueFunction(function=made)]", SUBSTITUTIONS + body)
    assert names(launched) == ["left_arm", "left"]  # execute() does not ask for the condition


@pytest.mark.parametrize(
    "test", ["hasattr(action, '_Node__node_name') and ", ""], ids=["asked for", "taken for granted"]
)
def test_nodes_that_are_left_out_by_their_names(launches, test):
    launched = launches.python(
        f"[action for action in actions if not ({test}action._Node__node_name == 'first')]",
        before=f"actions = [{node('first')}, {node('second')}]",
    )
    assert names(launched) == ["second"]

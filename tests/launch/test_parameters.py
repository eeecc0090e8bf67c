"""The parameters that launch files give nodes."""

from __future__ import annotations

import pytest

from archlint.systems.overrides import NotKnown, overrides_of, settings_of
from launching import names, node, parameters


def test_parameters_of_python(launches):
    launched = launches.python(
        "[DeclareLaunchArgument('rate', default_value='5'), SetParameter('use_sim_time', True), Node(package='robot', "
        "executable='talker', parameters=[{'rate': LaunchConfiguration('rate'), 'deep': {'er': 'text'}, "
        "'no': secret()}, "
        "os.path.join(get_package_share_directory('robot'), 'config', 'robot.yaml')])]"
    )
    (started,) = launched.started
    not_known = NotKnown("launch.actions.secret() is outside of this workspace")
    assert parameters(started) == {"use_sim_time": True, "rate": 5, "deep.er": "text", "no": not_known}
    assert started.parameters[-1].reference.status == "missing"


def test_yaml_that_a_launch_file_loads_itself(launches):
    launches.file("robot/config/p.yaml", "/**: {ros__parameters: {mode: fast, n: 2}}")
    launched = launches.python(
        "actions",
        before=(
            "import yaml\nwith open(os.path.join(get_package_share_directory('robot'), 'config', 'p.yaml')) as file:\n"
            "    values = yaml.safe_load(file)['/**']['ros__parameters']\nactions = []\n"
            "if values.get('mode', None) == 'fast':\n"
            "    actions.append(Node(package='robot', executable='talker', name='quick', parameters=[values]))"
        ),
    )
    assert names(launched) == ["quick"]
    assert parameters(launched.started[0]) == {"mode": "fast", "n": 2}
    assert not launched.started[0].branch_arms


def test_the_share_directory_as_the_module_of_a_substitution_imports_it(launches):
    launches.file("robot/config/p.yaml", "/**: {ros__parameters: {mode: fast}}")
    launched = launches.python(
        "[Node(package='robot', executable='talker', parameters=[share('robot') + '/config/p.yaml'])]",
        before="from launch_ros.substitutions.find_package import get_package_share_directory as share",
    )

    (given,) = launched.started[0].parameters
    assert given.reference.source == "robot/config/p.yaml"


def test_a_list_that_may_have_fewer_items_has_no_others(launches):
    before = """\
sides = ['left', 'right']
if has_an_arm():
    sides.append('hand')
nodes = []
for side in sides:
    nodes.append(ComposableNode(package='p', plugin='P', name='camera_' + side))
"""
    loads = "[LoadComposableNodes(composable_node_descriptions=nodes, target_container='c')]"
    launched = launches.python(loads, before)
    assert names(launched) == ["camera_left", "camera_right", "camera_hand"]
    assert not launched.gaps


@pytest.mark.parametrize(
    ("condition", "expected"),
    [
        ("IfCondition(LaunchConfiguration('mock', default='true'))", ["mock"]),
        ("UnlessCondition(LaunchConfiguration('mock', default='true'))", ["real"]),
        ("LaunchConfigurationEquals('mock', 'true')", ["real"]),
        ("IfCondition(EnvironmentVariable('MOCK'))", ["mock", "real"]),
    ],
)
@pytest.mark.parametrize("evaluate", ["evaluate", "_predicate_func"])
def test_a_condition_that_code_evaluates(launches, condition, expected, evaluate):
    before = f"""\
def setup(context):
    if {condition}.{evaluate}(context):
        return [{node("mock")}]
    return [{node("real")}]
"""
    assert names(launches.python("[OpaqueFunction(function=setup)]", before)) == expected


@pytest.mark.parametrize(("text", "value"), [("0.5", 0.5), ("3", 3), ("true", True), ("robot", "robot")])
def test_set_parameter_reads_its_text_as_a_parameter_does(launches, text, value):
    xml = launches.xml(f'<set_parameter name="p" value="{text}"/><node pkg="robot" exec="talker"/>')
    assert parameters(xml.started[0])["p"] == value


def test_substitutions_in_a_parameter_file_keep_what_quotes_say(launches):
    launches.file(
        "robot/config/p.yaml",
        "/**:\n  ros__parameters:\n"
        "    plain: $(var number)\n"
        "    quoted: '$(var number)'\n"
        '    empty: "$(var none)"\n'
        "    nothing: $(var none)\n"
        "    joints: [$(var side)_hip, $(var side)_knee, fixed]\n"
        "    numbers: [$(var number)]\n"
        "    $(var side)_arm: {rate: 10}\n"
        "    $(env ARM)_arm: {rate: 20}\n",
    )
    launches.file(
        "robot/launch/it.launch.xml",
        '<launch><arg name="number" default="5"/><arg name="none" default=""/><arg name="side" default="left"/>'
        '<node pkg="p" exec="e"><param from="$(find-pkg-share robot)/config/p.yaml" allow_substs="true"/></node>'
        "</launch>",
    )
    loaded = launches.of_workspace()
    [started] = loaded.run("robot/launch/it.launch.xml").started
    assert {one.name: one.value for one in settings_of(started, loaded.files.parameters)} == {
        "plain": 5,
        "quoted": "5",
        "empty": "",
        "nothing": NotKnown("a string that YAML may read in several ways"),
        "joints": ["left_hip", "left_knee", "fixed"],
        "numbers": NotKnown("a string that YAML may read in several ways"),  # whether its item is quoted is not kept
        "left_arm.rate": 10,
    }


@pytest.mark.parametrize(
    ("value", "why"),
    [
        ("os.environ['ROBOT']", "the environment variable ROBOT"),
        ("os.environ.get('ROBOT', 'spare')", "the environment variable ROBOT"),
        ("['left', os.environ['ROBOT']]", "the environment variable ROBOT"),
        ("EnvironmentVariable('ROBOT')", "the environment variable ROBOT"),
        ("ParameterValue(EnvironmentVariable('ROBOT'), value_type=str)", "the environment variable ROBOT"),
        ("[EnvironmentVariable('ROBOT'), '/base']", "the environment variable ROBOT"),
        ("Command(['xacro ', 'robot.urdf'])", "the output of a command"),
        ("LaunchConfiguration('robot')", "the environment variable ROBOT"),
        ("'left' if os.environ['ROBOT'] == '1' else 'right'", "the environment variable ROBOT"),
        ("LaunchConfiguration('unset')", "the launch configuration 'unset' is not set"),
    ],
)
def test_a_parameter_that_is_not_known_says_why(launches, value, why):
    launched = launches.python(
        "[DeclareLaunchArgument('robot', default_value=os.environ['ROBOT']), "
        f"Node(package='robot', executable='talker', parameters=[{{'p': {value}, 'rate': 5}}])]"
    )
    assert parameters(launched.started[0]) == {"p": NotKnown(why), "rate": 5}


def test_an_empty_path_is_no_parameter_file(launches):
    """launch_ros makes the current folder of it, says that it is not a file, and leaves it out."""
    launched = launches.python(
        "[DeclareLaunchArgument('file', default_value=''), Node(package='robot', executable='talker', "
        "parameters=[{'rate': 5}, LaunchConfiguration('file')])]"
    )
    (started,) = launched.started
    assert started.parameters[-1].reference.written == "." and not launched.gaps
    assert {one.name: one.value for one in settings_of(started, launches.of_workspace().files.parameters)} == {
        "rate": 5
    }


def test_a_parameter_file_elsewhere_may_set_what_stands_before_it(launches):
    launched = launches.python("[Node(package='robot', executable='talker', parameters=[{'rate': 5}, '/etc/it.yaml'])]")
    (setting,) = settings_of(launched.started[0], launches.of_workspace().files.parameters)
    assert setting.value == NotKnown("'/etc/it.yaml', which is not in this workspace, may set it")


def test_what_decides_between_parameter_files_is_named(launches):
    launched = launches.python(
        "[Node(package='robot', executable='talker', parameters=[left if os.environ['SIDE'] == 'left' else right])]",
        before="left, right = (PathJoinSubstitution(['.', name]) for name in ('left.yaml', 'right.yaml'))",
    )
    opened, *files = launched.started[0].parameters
    assert opened.reason == "one of several parameters: the environment variable SIDE"
    assert [one.reference.written for one in files] == ["./left.yaml", "./right.yaml"]


def test_a_file_with_a_variable_of_the_environment_says_so(launches):
    launches.file(
        "robot/config/p.yaml", "/**:\n  ros__parameters:\n    arm: $(env ARM)\n    leg: $(var leg)_$(env LEG)\n"
    )
    launches.file(
        "robot/launch/it.launch.xml",
        '<launch><arg name="leg" default="left"/><node pkg="p" exec="e">'
        '<param from="$(find-pkg-share robot)/config/p.yaml" allow_substs="true"/></node></launch>',
    )
    loaded = launches.of_workspace()
    [started] = loaded.run("robot/launch/it.launch.xml").started
    assert {one.name: one.value for one in settings_of(started, loaded.files.parameters)} == {
        "arm": NotKnown("the environment variable ARM"),
        "leg": NotKnown("the environment variable LEG"),
    }


@pytest.mark.parametrize(("variable", "shown"), [("ROBOT", "spare"), ("USER", None)])
def test_the_default_of_a_variable_that_each_machine_has(launches, variable, shown):
    launched = launches.xml(f'<node pkg="robot" exec="talker" name="$(env {variable} spare)"/>')
    [name] = [started.name for started in launched.started]
    assert name.text == shown


def test_a_file_without_nodes_is_for_components(launches):
    launches.file("robot/config/plain.yaml", "rate: 10\nled: {number: 24}\n")
    launches.file("robot/config/nodes.yaml", "rate: 5\ndriver:\n  ros__parameters: {led: 1}\n")

    def given(file: str) -> list[dict[str, object]]:
        launches.python(
            "[ComposableNodeContainer(package='c', executable='c', name='c', namespace='', parameters=[file],"
            " composable_node_descriptions=[part])]",
            f"file = FindPackageShare('robot').find('robot') + '/config/{file}'\n"
            "part = ComposableNode(package='p', plugin='D', name='driver', parameters=[file])",
        )
        loaded = launches.of_workspace()
        started = loaded.run("robot/launch/it.launch.py").started
        return [{row.name: row.value for row in settings_of(one, loaded.files.parameters)} for one in started]

    assert sorted(given("plain.yaml"), key=len) == [{}, {"rate": 10, "led.number": 24}]  # the container gets nothing
    assert given("nodes.yaml") == [{"led": 1}, {"led": 1}]  # one section is enough: the rest is not read


@pytest.mark.parametrize(("given", "found"), [("", {"use_sim_time": True}), ("5", {"use_sim_time": True, "offset": 5})])
def test_a_parameter_of_a_group_under_a_condition(launches, given, found):
    """The list of parameters for all nodes is one list, in the group and after it; what a condition leaves out is
    in neither."""
    wanted = "LaunchConfigurationNotEquals('offset', '')"
    inside = f"SetParameter('offset', LaunchConfiguration('offset'), condition={wanted}), {node('inside')}"
    launched = launches.python(
        "[DeclareLaunchArgument('offset', default_value=''), SetParameter('use_sim_time', True), "
        f"GroupAction([{inside}]), {node('after')}]",
        offset=given,
    )
    assert [parameters(started) for started in launched.started] == [found, found]


def test_a_parameter_that_a_branch_chooses_says_what_decides_the_branch(launches):
    before = """
arm = 'left'
if os.environ['SIDE'] == 'r':
    arm = 'right'

def side():
    if os.environ['ROBOT'] == '1':
        return 'left'
    return 'right'
other = side()
"""
    node = "Node(package='robot', executable='talker', parameters=[{'arm': arm, 'other': other}])"
    (started,) = launches.python(f"[{node}]", before).started
    assert parameters(started) == {
        "arm": NotKnown("the environment variable SIDE"),
        "other": NotKnown("the environment variable ROBOT"),
    }


@pytest.mark.parametrize(
    ("written", "read"),
    [
        ("'y'", True),
        ("'N'", False),
        ("'1e5'", 100000.0),
        ("['y', 'n']", [True, False]),
        ("ParameterValue('y', value_type=str)", True),
        # PyYAML quotes what it would read as another type itself.
        ("'yes'", "yes"),
        ("'1'", "1"),
        ("'1.5'", "1.5"),
        ("['x', 'z']", ["x", "z"]),
    ],
)
def test_launch_writes_a_text_without_quotes_where_only_rcl_reads_something_else_in_it(launches, written, read):
    before = "from launch_ros.parameter_descriptions import ParameterValue"
    launched = launches.python(f"[Node(package='robot', executable='talker', parameters=[{{'a': {written}}}])]", before)
    (setting,) = settings_of(launched.started[0], launches.of_workspace().files.parameters)
    assert setting.value == read and type(setting.value) is type(read)


def test_a_container_is_sent_the_text_itself(launches):
    component = "ComposableNode(package='p', plugin='P', name='a', parameters=[{'a': 'y'}])"
    launched = launches.python(
        f"[LoadComposableNodes(composable_node_descriptions=[{component}], target_container='c')]"
    )
    (setting,) = settings_of(launched.started[0], launches.of_workspace().files.parameters)
    assert setting.value == "y"


def test_launch_reads_the_file_of_a_component_with_pyyaml(launches):
    """rcl, which reads the file of a node, takes `1e-2` for a number and `y` for a boolean; PyYAML takes them for
    texts, and launch sends the component what PyYAML reads."""
    launches.file(
        "robot/config/p.yaml",
        "/**:\n  ros__parameters:\n    small: 1e-2\n    answer: y\n    number: 1.5\n    day: 2024-13-01\n"
        "    quoted: 'true'\n    list: [1e3, 2]\n",
    )
    file = "get_package_share_directory('robot') + '/config/p.yaml'"
    component = f"ComposableNode(package='robot', plugin='Camera', name='camera', parameters=[{file}])"
    launched = launches.python(
        f"[LoadComposableNodes(target_container='c', composable_node_descriptions=[{component}]),"
        f" Node(package='robot', executable='talker', name='talker', namespace='/', parameters=[{file}])]"
    )
    read = launches.of_workspace().files.parameters
    of_component, of_node = (overrides_of(started, "/camera", read) for started in launched.started)
    assert of_component == {
        "small": "1e-2", "answer": "y", "number": 1.5, "day": "2024-13-01", "quoted": "true", "list": ["1e3", 2]
    }  # fmt: skip
    assert of_node == {**of_component, "small": 0.01, "answer": True, "list": [1000.0, 2]}


def test_a_parameter_of_its_own_is_for_all_nodes_of_the_process(launches):
    """launch_ros writes a dict to a file, under the name of the node, and a ``Parameter`` to the command line."""
    launched = launches.python(
        "[Node(package='robot', executable='talker', name='nose', namespace='/arm', "
        "parameters=[{'rate': 5}, Parameter('frame', 'map')])]",
        "from launch_ros.parameter_descriptions import Parameter",
    )
    keys = {one.name: one.key for one in settings_of(launched.started[0], launches.of_workspace().files.parameters)}
    assert keys == {"rate": "/arm/nose", "frame": "/**"}


def test_a_param_of_xml_is_for_one_node(launches):
    launched = launches.xml(
        "<node pkg='robot' exec='talker' name='nose' namespace='/arm'><param name='frame' value='map'/></node>"
    )
    keys = {one.name: one.key for one in settings_of(launched.started[0], launches.of_workspace().files.parameters)}
    assert keys == {"frame": "/arm/nose"}


ELSEWHERE = NotKnown("'$(find-pkg-share other)/nav.yaml', which is not in this workspace, may set it")
BEHIND = NotKnown("what comes behind it may set it: the environment variable NAV")


@pytest.mark.parametrize(
    ("others", "frame"),
    [
        ("{'frame': 'map'}, get_package_share_directory('other') + '/nav.yaml'", ELSEWHERE),
        ("get_package_share_directory('other') + '/nav.yaml', {'frame': 'map'}", "map"),
        ("{'frame': 'map'}, get_package_share_directory('robot') + '/nav.yaml'", "map"),  # it is not there
        ("{'frame': 'map'}, os.environ['NAV']", BEHIND),
        ("os.environ['NAV'], {'frame': 'map'}", "map"),
        ("{**given(), 'frame': 'map'}", "map"),
        ("{'frame': 'map', 'arm': {**given()}}", "map"),
    ],
)
def test_what_is_behind_a_value_may_set_it(launches, others: str, frame: object):
    launched = launches.python(f"[Node(package='robot', executable='talker', name='nose', parameters=[{others}])]")
    facts_of = launches.of_workspace().files.parameters
    assert overrides_of(launched.started[0], "/nose", facts_of) == {"frame": frame}


@pytest.mark.parametrize(
    ("value", "read"),
    [
        ("[LaunchConfiguration('robot'), TextSubstitution(text='_odom')]", "r1_odom"),
        ("[LaunchConfiguration('robot'), '_odom']", "r1_odom"),
        (
            "[[LaunchConfiguration('robot'), '/left'], [LaunchConfiguration('robot'), '/right']]",
            ["r1/left", "r1/right"],
        ),
        ("[['1'], ['2']]", [1, 2]),
        ("[['1'], ['left']]", ["1", "left"]),
        ("[[['1']]]", NotKnown("a parameter cannot be a list of lists")),
        ("[['1'], 'left']", NotKnown("a list of texts and of lists")),
        ("[[LaunchConfiguration('other'), '/left']]", NotKnown("the launch configuration 'other' is not set")),
    ],
)
def test_a_list_as_the_value_of_a_parameter(launches, value: str, read: object):
    launched = launches.python(
        "[DeclareLaunchArgument('robot', default_value='r1'), Node(package='robot', executable='talker', "
        f"parameters=[{{'frame': {value}}}])]",
        "from launch.substitutions import TextSubstitution",
    )
    assert parameters(launched.started[0]) == {"frame": read}


def test_the_constants_of_numpy(launches):
    launched = launches.python(
        "[Node(package='robot', executable='talker', parameters=[{'most': np.pi / 2, 'sum': np.sum([1])}])]",
        "import numpy as np",
    )
    not_known = NotKnown("numpy.sum() is outside of this workspace")
    assert parameters(launched.started[0]) == {"most": 1.5707963267948966, "sum": not_known}


@pytest.mark.parametrize(
    "later",
    [
        "del shared['rate']",
        "shared['rate'] = 9",
        "shared.clear()",
        "given.append({'rate': 9})",
        "inner['er'] = 'other'",
    ],
)
def test_a_node_keeps_the_parameters_that_it_was_made_with(launches, later: str):
    before = "inner = {'er': 'text'}\nshared = {'rate': 5, 'deep': inner}\ngiven = [shared]\n"
    made = f"first = Node(package='robot', executable='talker', parameters=given)\n{later}"
    launched = launches.python("[first]", before=before + made)
    assert parameters(launched.started[0]) == {"rate": 5, "deep.er": "text"}


def test_a_node_that_is_made_later_has_what_is_left_of_a_dict(launches):
    node_of = "Node(package='robot', executable='talker', name='{0}', parameters=[shared])"
    before = f"shared = {{'rate': 5, 'n': 2}}\nfirst = {node_of.format('a')}\ndel shared['rate']\n"
    launched = launches.python(f"[first, {node_of.format('b')}]", before=before)
    assert [parameters(each) for each in launched.started] == [{"rate": 5, "n": 2}, {"n": 2}]


def test_a_node_whose_list_of_parameters_depends_on_a_branch(launches):
    before = """\
given = [{'rate': 5}] if has_an_arm() else [{'rate': 7}]
first = Node(package='robot', executable='talker', parameters=given)
given.append({'n': 2})"""
    launched = launches.python("[first]", before=before)
    names_of = {row.name for row in launched.started[0].parameters if not row.is_open}
    assert names_of == {"rate"}

"""What launch actions do: scopes, namespaces, remappings, conditions, includes, functions."""

from __future__ import annotations

import pytest

from archlint.systems.overrides import NotKnown, settings_of
from launching import names, parameters, remaps


def node(name: str, **keywords: str) -> str:
    more = "".join(f", {key}={value}" for key, value in keywords.items())
    return f"Node(package='robot', executable='talker', name={name!r}{more})"


# --------------------------------------------------------------------------------------- names and namespaces


@pytest.mark.parametrize(
    ("pushed", "own", "full"),
    [
        (None, None, "n"),
        (None, "'left'", "/left/n"),
        ("'robot'", None, "/robot/n"),
        ("'robot'", "'left'", "/robot/left/n"),
        ("'robot'", "'/left'", "/left/n"),
        ("'/a/'", "'b/'", "/a/b/n"),
        ("'/'", None, "/n"),
        ("'/'", "'left'", "/left/n"),
        ("'/'", "''", "/n"),
        ("''", "'left'", "/left/n"),
    ],
)
def test_namespace_of_a_node(launches, pushed, own, full):
    push = f"PushRosNamespace({pushed}), " if pushed else ""
    keywords = {"namespace": own} if own else {}
    assert names(launches.python(f"[{push}{node('n', **keywords)}]")) == [full]


def test_namespaces_add_up_until_their_group_ends(launches):
    launched = launches.python(
        f"[GroupAction([PushRosNamespace('a'), PushRosNamespace('b'), {node('in')}]), {node('out')}]"
    )
    assert names(launched) == ["/a/b/in", "out"]


def test_the_root_namespace_adds_no_slash(launches):
    component = "ComposableNode(package='p', plugin='p::C', name='c', namespace='left')"
    launched = launches.python(
        f"[PushRosNamespace('/'), PushRosNamespace('robot'), {node('n')}, GroupAction([PushRosNamespace('/'), "
        f"LoadComposableNodes(target_container='box', composable_node_descriptions=[{component}])])]"
    )
    assert names(launched) == ["/robot/n", "/left/c"]


def test_a_group_without_scope_leaks(launches):
    launched = launches.python(f"[GroupAction([PushRosNamespace('a')], scoped=False), {node('out')}]")
    assert names(launched) == ["/a/out"]


def test_an_include_is_not_scoped(launches):
    launches.file(
        "robot/launch/inner.launch.xml",
        '<launch><push_ros_namespace namespace="deep"/><arg name="x" default="1"/></launch>',
    )
    launched = launches.python(
        "[IncludeLaunchDescription(AnyLaunchDescriptionSource([FindPackageShare('robot'), "
        f"'/launch/inner.launch.xml'])), {node('after', namespace='LaunchConfiguration(chr(120))')}, {node('last')}]"
    )
    assert names(launched)[1] == "/deep/last"


# ----------------------------------------------------------------------------------------------- remappings


def test_group_remappings_come_before_the_nodes_own(launches):
    (started,) = launches.python(
        f"[SetRemap('a', 'group'), {node('n', remappings='[(chr(97), chr(98)), (str(1), str(2))]')}]"
    ).started
    assert remaps(started)[0] == ("a", "group")
    assert [remap.group for remap in started.remaps] == [True, False, False]


def test_a_remapping_ends_with_its_group_unless_an_outer_one_exists(launches):
    alone = launches.python(f"[GroupAction([SetRemap('a', 'x'), {node('in')}]), {node('out')}]")
    assert [remaps(started) for started in alone.started] == [[("a", "x")], []]
    leaking = launches.python(f"[SetRemap('o', 'p'), GroupAction([SetRemap('a', 'x'), {node('in')}]), {node('out')}]")
    assert remaps(leaking.started[1]) == [("o", "p"), ("a", "x")]


# ------------------------------------------------------------------------------------------------ arguments


def test_arguments_default_and_given(launches):
    actions = f"[DeclareLaunchArgument('ns', default_value='a'), {node('n', namespace='LaunchConfiguration(str(x))')}]"
    actions = actions.replace("str(x)", "'ns'")
    assert names(launches.python(actions)) == ["/a/n"]
    assert names(launches.python(actions, ns="b")) == ["/b/n"]


def test_an_argument_without_default_leaves_a_hole(launches):
    launched = launches.python(
        "[DeclareLaunchArgument('robot'), Node(package='robot', executable='talker', name='n', "
        "namespace=['fleet/', LaunchConfiguration('robot')])]"
    )
    (started,) = launched.started
    assert (started.namespace.text, started.namespace.resolution) == ("/fleet/*", "partial")
    assert "'robot' has no default" in started.namespace.reason


def test_a_configuration_that_nothing_sets_is_noted_with_its_place(launches):
    launched = launches.xml('<node pkg="robot" exec="talker" name="$(var nmae)"/>')
    (use,) = launched.undeclared
    assert (use.name, use.place.line, use.place.column) == ("nmae", 2, 33)


# ----------------------------------------------------------------------------------------------- conditions


@pytest.mark.parametrize(("default", "expected"), [("true", ["yes"]), ("False", ["no"]), ("1", ["yes"])])
def test_a_default_decides_a_condition(launches, default, expected):
    launched = launches.python(
        f"[DeclareLaunchArgument('sim', default_value='{default}'), "
        f"{node('yes', condition='IfCondition(LaunchConfiguration(sim))')}, "
        f"{node('no', condition='UnlessCondition(LaunchConfiguration(sim))')}]",
        before="sim = 'sim'",
    )
    assert names(launched) == expected
    assert len(launched.started) == 2


def test_an_undecided_condition_gives_two_arms_that_exclude_each_other(launches):
    launched = launches.python(
        "[DeclareLaunchArgument('sim'), "
        f"{node('yes', condition='IfCondition(LaunchConfiguration(sim))')}, "
        f"{node('no', condition='UnlessCondition(LaunchConfiguration(sim))')}]",
        before="sim = 'sim'",
    )
    yes, no = launched.started
    assert (yes.branch_arms, no.branch_arms) == ({("sim", 1)}, {("sim", 0)})
    assert (launched.condition(yes.branch_arms), launched.condition(no.branch_arms)) == ("sim:=true", "sim:=false")


def test_values_of_one_argument_exclude_each_other(launches):
    launched = launches.python(
        "[DeclareLaunchArgument('mode'), "
        + ", ".join(
            node(
                name, condition=f"IfCondition(PythonExpression([q, LaunchConfiguration('mode'), q, ' == ', {name!r}]))"
            )
            for name in ("'a'", "'b'")
        )
        + "]",
        before='q = "\'"',
    )
    one, other = (dict(started.branch_arms) for started in launched.started)
    assert one.keys() == other.keys() == {"mode"} and one != other


@pytest.mark.parametrize(
    ("expression", "expected"),
    [
        ("\"'$(var mode)' == 'fast'\"", ["n"]),
        ("\"'$(var mode)' in ['slow', 'still']\"", []),
        ('"not $(var flag)"', []),
        ("\"$(var flag) and '$(var mode)'.startswith('fa')\"", ["n"]),
        ('"$(var count) * 2 > 5"', ["n"]),
    ],
)
def test_python_expressions_on_known_values(launches, expression, expected):
    launched = launches.xml(
        '<arg name="mode" default="fast"/><arg name="flag" default="True"/><arg name="count" default="3"/>'
        f"<node pkg='robot' exec='talker' name='n' if='$(eval {expression.replace(chr(39), '&apos;')})'/>"
    )
    assert names(launched) == expected


@pytest.mark.parametrize(("arguments", "expected"), [({}, ["slow"]), ({"fast": "True"}, ["quick"])])
def test_eval_of_an_argument_decides_what_a_function_starts(launches, arguments, expected):
    launched = launches.python(
        """[DeclareLaunchArgument('fast', default_value='False'), OpaqueFunction(function=start)]""",
        before="""\
def start(context):
    fast = eval(LaunchConfiguration('fast').perform(context))
    return [Node(package='robot', executable='talker', name='quick' if fast else 'slow')]
""",
        **arguments,
    )
    assert names(launched) == expected


def test_eval_of_more_than_constants_stays_unknown(launches):
    launched = launches.python(
        "[Node(package='robot', executable='talker', name=eval('__import__(\"os\").getcwd()'))]",
    )
    assert names(launched) == ["?"]


def test_no_expression_is_executed(launches, tmp_path):
    marker = tmp_path / "executed"
    text = f"__import__(&apos;os&apos;).mkdir(&apos;{marker}&apos;)"
    launched = launches.xml(f"<node pkg='robot' exec='talker' name='n' if='$(eval \"{text}\")'/>")
    assert not marker.exists()
    assert launched.started[0].branch_arms


# ----------------------------------------------------------------------------------- code in a launch file


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


def test_timers_handlers_and_processes(launches):
    launched = launches.python(
        f"[first, TimerAction(period=1.0, actions=[{node('timed')}]), "
        f"RegisterEventHandler(OnProcessExit(target_action=first, on_exit=[{node('handled')}])), "
        "ExecuteProcess(cmd=['ros2', 'run', 'robot', 'talker']), ExecuteProcess(cmd=['bash', 'x.sh'])]",
        before=f"first = {node('first')}",
    )
    assert [(s.kind, s.package.text, s.executable.text) for s in launched.started] == [
        ("node", "robot", "talker"),
        ("node", "robot", "talker"),
        ("node", "robot", "talker"),
        ("node", "robot", "talker"),
        ("process", None, "bash"),
    ]


def test_components(launches):
    launched = launches.python(
        "[PushRosNamespace('r'), ComposableNodeContainer(name='box', namespace='', package='rclcpp_components', "
        "executable='component_container', composable_node_descriptions=[ComposableNode(package='p', plugin='p::C', "
        "name='c', remappings=[('a', 'b')])]), LoadComposableNodes(target_container='box', "
        "composable_node_descriptions=[ComposableNode(package='p', plugin='p::D', namespace='n')])]"
    )
    assert [(s.kind, s.executable.text) for s in launched.started] == [
        ("container", "component_container"),
        ("component", "p::C"),
        ("component", "p::D"),
    ]
    assert names(launched) == ["/r/box", "/r/c", "/r/n/-"]


# ------------------------------------------------------------------------------------------------- includes


def test_includes_across_packages_and_formats(launches):
    launches.package("arm")
    launches.file(
        "arm/launch/arm.launch.py",
        "from launch import LaunchDescription\nfrom launch.substitutions import LaunchConfiguration\n"
        "from launch_ros.actions import Node\n"
        "def generate_launch_description():\n"
        "    return LaunchDescription([Node(package='arm', executable='talker', name=LaunchConfiguration('name'))])\n",
    )
    launches.file(
        "robot/launch/two.launch.yaml",
        "launch:\n- include:\n    file: $(find-pkg-share arm)/launch/arm.launch.py\n"
        "    arg:\n    - {name: name, value: left}\n",
    )
    launched = launches.xml('<include file="$(dirname)/two.launch.yaml"/>')
    assert names(launched) == ["left"]
    assert [include.reference.status for include in launched.included] == ["installed", "installed"]


@pytest.mark.parametrize(
    ("path", "status"),
    [
        ("$(find-pkg-share robot)/launch/gone.launch.py", "missing"),
        ("$(find-pkg-share nav2_bringup)/launch/x.launch.py", "external"),
        ("/opt/x.launch.py", "external"),
        ("$(find-pkg-share robot)/other/there.launch.xml", "not installed"),
    ],
)
def test_files_that_are_not_there(launches, path, status):
    launches.file("robot/other/there.launch.xml", "<launch/>")
    launched = launches.xml(f'<include file="{path}"/>')
    assert [include.reference.status for include in launched.included] == [status]
    assert launched.gaps == []


def test_a_circle_of_includes_ends(launches):
    launched = launches.xml('<include file="$(dirname)/it.launch.xml"/><node pkg="robot" exec="talker"/>')
    assert len(launched.started) == 1
    assert "includes itself" in launched.gaps[0].reason


@pytest.mark.parametrize(
    ("first", "second", "told"),
    [
        ('<include file="$(dirname)/other.launch.xml"/>', '<include file="$(dirname)/it.launch.xml"/>', 1),
        ('<include file="$(dirname)/other.launch.xml"/>', "", 0),
        (
            '<arg name="n" default="1"/><include file="$(dirname)/other.launch.xml" if="$(var n)"/>',
            '<include file="$(dirname)/it.launch.xml"><arg name="n" value="0"/></include>',
            0,
        ),
        (
            '<include file="$(dirname)/other.launch.xml"/>',
            '<arg name="again"/><include file="$(dirname)/it.launch.xml" if="$(var again)"/>',
            0,
        ),
    ],
    ids=["a circle", "none", "an argument may end it", "a condition may end it"],
)
def test_a_circle_of_includes_is_told_once(launches, first, second, told):
    launches.file("robot/launch/other.launch.xml", f"<launch>{second}</launch>")
    launches.xml(first)
    loaded = launches.of_workspace()
    for file in loaded.files.all():
        loaded.run(file)
    endless = [problem for problem in loaded.files.problems() if "never end" in problem[3]]
    assert [(path, line) for path, line, _, _ in endless] == [("robot/launch/other.launch.xml", 1)] * told


# ----------------------------------------------------------------------------------------------- parameters


def test_types_of_parameters(launches):
    launched = launches.xml(
        """<arg name="x" default="1.5"/><node pkg="robot" exec="talker">
          <param name="a" value="1"/><param name="b" value="1" type="str"/><param name="c" value="$(var x)"/>
          <param name="d"><param name="e" value="true"/></param><param name="f" value="[1, 2]"/>
        </node>"""
    )
    assert parameters(launched.started[0]) == {"a": 1, "b": "1", "c": 1.5, "d.e": True, "f": [1, 2]}


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


def test_yaml_keeps_types_but_for_texts_that_look_like_numbers(launches):
    launched = launches.yaml(
        "launch:\n- node:\n    pkg: robot\n    exec: talker\n    namespace: left\n"
        "    param:\n    - {name: a, value: 1}\n    - {name: b, value: '1'}\n    - {name: c, value: one}\n"
        "    remap:\n    - {from: x, to: y}\n"
    )
    (started,) = launched.started
    why = "a text that looks like a number: releases differ in what they make of it"
    assert parameters(started) == {"a": 1, "b": NotKnown(why), "c": "one"}
    assert remaps(started) == [("x", "y")]
    assert names(launched) == ["/left/-"]


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
def test_a_condition_that_code_evaluates(launches, condition, expected):
    before = f"""\
def setup(context):
    if {condition}.evaluate(context):
        return [{node("mock")}]
    return [{node("real")}]
"""
    assert names(launches.python("[OpaqueFunction(function=setup)]", before)) == expected


# ------------------------------------------------------------------------------------- what is not followed


def left_out(launched) -> list[tuple[str, str]]:
    return [(gap.kind, gap.reason) for gap in launched.not_followed()]


@pytest.mark.parametrize(
    ("path", "reason"),
    [
        (
            "$(find-pkg-share robot)/launch/gone.launch.py",
            "'$(find-pkg-share robot)/launch/gone.launch.py' is not there",
        ),
        ("$(find-pkg-share nav2_bringup)/launch/x.launch.py", "the package 'nav2_bringup' is not in this workspace"),
        ("/opt/x.launch.py", "a path of the machine"),
        ("$(find-pkg-share $(env LIDAR))/launch/x.launch.py", "the environment variable LIDAR"),
    ],
)
def test_an_include_that_is_not_followed_is_told(launches, path, reason):
    launched = launches.xml(f'<group>\n<include file="{path}"/></group>')
    assert left_out(launched) == [("include", reason)]
    assert [gap.place.line for gap in launched.not_followed()] == [3]


def test_of_a_branch_that_is_not_taken_nothing_is_told(launches):
    launched = launches.xml(
        '<group if="false"><include file="$(env FILE)"/><include file="/opt/x.launch.py"/><thing/></group>'
    )
    assert left_out(launched) == []


@pytest.mark.parametrize(
    ("actions", "reason"),
    [
        ("[make_nodes()]", "make_nodes"),
        ("[OpaqueFunction(function=elsewhere.setup)]", "a function that launch calls, and that is not followed"),
        ("[ForLoop(length='3', function=lambda i: [])]", "ForLoop is no action that is followed"),
        ("elsewhere.nodes()", "elsewhere.nodes() is outside of this workspace"),
    ],
)
def test_an_action_that_is_not_followed_is_told(launches, actions, reason):
    launched = launches.python(actions, "import elsewhere\nfrom launch.actions import ForLoop")
    assert launched.started == []
    [(kind, words)] = left_out(launched)
    assert kind == "launch" and reason in words


def test_an_element_that_is_not_followed_is_told(launches):
    launched = launches.xml(
        '<for_each values="$(env ROBOTS)"><node pkg="robot" exec="talker"/></for_each><log message="x"/>'
    )
    assert left_out(launched) == [("launch", "<for_each> is no action that is followed")]


def test_a_function_that_handles_an_event_is_run(launches):
    before = f"def after(event, context):\n    return [{node('handled')}]\n"
    handler = "RegisterEventHandler(OnProcessExit(target_action=None, on_exit=after))"
    assert names(launches.python(f"[{handler}]", before)) == ["handled"]


@pytest.mark.parametrize("order", ["{node}, {handler}", "{handler}, {node}"])
def test_a_process_that_is_started_again_when_it_ends_is_one(launches, order):
    before = f"def start(*_):\n    return [{node('driver')}]\n"
    actions = order.format(
        node="*start()",
        handler="RegisterEventHandler(OnProcessExit(target_action=None, on_exit=start))",
    )
    assert names(launches.python(f"[{actions}]", before)) == ["driver"]


def test_two_processes_of_one_place_and_name_are_two(launches):
    before = f"def start():\n    return {node('driver')}\n"
    assert names(launches.python("[start(), start()]", before)) == ["driver", "driver"]


def test_a_class_that_derives_from_an_action_is_one(launches):
    before = """\
class Talker(Node):
    def __init__(self, name, **kwargs):
        super().__init__(package='robot', executable='talker', name=name + '_talker', **kwargs)
"""
    launched = launches.python("[Talker('left'), Talker('right', namespace='r')]", before)
    assert names(launched) == ["left_talker", "/r/right_talker"]
    assert left_out(launched) == []


def test_a_class_that_derives_from_an_action_in_two_ways(launches):
    before = """\
class Talker(Node):
    def __init__(self, name):
        if is_wsl():
            super().__init__(package='robot', executable='talker', name=name)
        else:
            super().__init__(package='robot', executable='talker', name=name + '_native')
"""
    launched = launches.python("[Talker('left')]", before)
    assert names(launched) == ["left", "left_native"]
    assert left_out(launched) == [] and all(started.branch_arms for started in launched.started)


def test_a_launch_that_a_command_starts_has_a_context_of_its_own(launches):
    launches.file(
        "robot/launch/inner.launch.xml",
        '<launch><arg name="who" default="nobody"/><push_ros_namespace namespace="deep"/>'
        '<node pkg="robot" exec="talker" name="$(var who)"/></launch>',
    )
    launched = launches.xml(
        '<arg name="who" default="outer"/><push_ros_namespace namespace="a"/>'
        '<executable cmd="ros2 launch robot inner.launch.xml who:=$(var who)_one"/><node pkg="robot" exec="talker"/>'
    )
    assert names(launched) == ["/deep/outer_one", "/a/-"]


# ---------------------------------------------------------------------------------- what a group hands on


def test_what_a_group_hands_on_is_read_before_it_forgets_the_rest(launches):
    arguments = "DeclareLaunchArgument('outer', default_value='o')"
    inner = node("n").replace("'n'", "LaunchConfiguration('kept')")
    group = f"GroupAction([{inner}], forwarding=False, launch_configurations={{'kept': LaunchConfiguration('outer')}})"
    assert names(launches.python(f"[{arguments}, {group}]")) == ["o"]


def test_frontends_keep_configurations_through_a_group_that_forwards_none(launches):
    xml = launches.xml(
        '<arg name="outer" default="o"/><group forwarding="false"><keep name="kept" value="$(var outer)"/>'
        '<node pkg="robot" exec="talker" name="$(var kept)"/></group>'
    )
    yaml = launches.yaml(
        "launch:\n- arg: {name: outer, default: o}\n- group:\n    forwarding: false\n"
        "    keep:\n    - {name: kept, value: $(var outer)}\n"
        "    children:\n    - node: {pkg: robot, exec: talker, name: $(var kept)}\n"
    )
    assert names(xml) == names(yaml) == ["o"]


# ------------------------------------------------------------------------------- types of parameters in text


@pytest.mark.parametrize(
    ("attributes", "value"),
    [
        ('value="1"', 1),
        ('value="1" type="float"', 1.0),
        ('value="1" type="int"', 1),
        ('value="1" type="str"', "1"),
        ('value="yes" type="bool"', True),
        ('value="0.5"', 0.5),
        ('value="x" type="int"', NotKnown("a value that is no int")),
    ],
)
def test_the_type_of_a_parameter_in_xml(launches, attributes, value):
    launched = launches.xml(f'<node pkg="robot" exec="talker"><param name="p" {attributes}/></node>')
    found = parameters(launched.started[0])["p"]
    assert (type(found), found) == (type(value), value)


@pytest.mark.parametrize(("text", "value"), [("0.5", 0.5), ("3", 3), ("true", True), ("robot", "robot")])
def test_set_parameter_reads_its_text_as_a_parameter_does(launches, text, value):
    xml = launches.xml(f'<set_parameter name="p" value="{text}"/><node pkg="robot" exec="talker"/>')
    assert parameters(xml.started[0])["p"] == value


# ------------------------------------------------------------------------------- lists that grow in a loop


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


# -------------------------------------------------------------- conditions that are not launch's own, or unknown

OWN = """\
from launch import Condition, Substitution
from launch.substitutions import (AndSubstitution, EqualsSubstitution, NotEqualsSubstitution, NotSubstitution)
from somewhere.launch import Foreign, is_real
class AsBool(Substitution):
    def __init__(self, name):
        super().__init__()
        self.config = LaunchConfiguration(name)
    def perform(self, context):
        return str(self.config.perform(context).lower() in ('yes', 'true'))
class Is(Condition):
    def __init__(self, name, value):
        self.name, self.value = name, value
        super().__init__(predicate=self.ask)
    def ask(self, context):
        return context.launch_configurations[self.name] == self.value
class Never(IfCondition):
    def __init__(self):
        super().__init__('false')
class Given(Condition):
    def evaluate(self, context):
        return 'x' in context.launch_configurations
"""


def started_under(launches, first: str, second: str, default: str | None = None) -> str:
    """How two nodes under two conditions run: ``both``, ``first``, ``second`` or ``none`` where that is known,
    ``alike`` or ``apart`` where it depends on the same thing, and ``either`` where nothing is known."""
    given = "" if default is None else f", default_value={default!r}"
    actions = f"[DeclareLaunchArgument('x'{given}), {node('a', condition=first)}, {node('b', condition=second)}]"
    one, other = launches.python(actions, before=OWN).started
    if not one.branch_arms and not other.branch_arms:
        running = [name for name, started in (("first", one), ("second", other)) if not started.dormant]
        return {0: "none", 1: running[0] if running else "", 2: "both"}[len(running)]
    if one.branch_arms == other.branch_arms:
        return "alike"
    (this,), (that,) = one.branch_arms, other.branch_arms
    return "apart" if this[0] == that[0] else "either"


@pytest.mark.parametrize(
    ("first", "second", "default", "expected"),
    [
        ("IfCondition(AsBool('x'))", "UnlessCondition(AsBool('x'))", "yes", "first"),
        ("IfCondition(AsBool('x'))", "UnlessCondition(AsBool('x'))", "no", "second"),
        ("IfCondition(AsBool('x'))", "UnlessCondition(AsBool('x'))", None, "apart"),
        ("IfCondition(AsBool('x'))", "IfCondition(AsBool('x'))", None, "alike"),
        ("IfCondition(AsBool('x'))", "IfCondition(AsBool('y'))", None, "either"),
        ("Is('x', 'a')", "Is('x', 'b')", "b", "second"),
        ("Is('x', 'a')", "Is('x', 'b')", None, "either"),
        ("Is('x', 'a')", "Is('x', 'a')", None, "alike"),
        ("Condition(predicate=lambda c: c.launch_configurations['x'] == '1')", "Never()", "1", "first"),
        ("Given()", "Never()", "1", "first"),
        ("IfCondition(Foreign('x'))", "UnlessCondition(Foreign('x'))", None, "apart"),
        ("IfCondition(Foreign('x'))", "IfCondition(Foreign('y'))", None, "either"),
        ("IfCondition(is_real())", "UnlessCondition(is_real())", None, "either"),
        ("IfCondition(Command('a'))", "UnlessCondition(Command('a'))", None, "apart"),
        ("Foreign('x')", "Foreign('y')", None, "either"),
        ("lambda c: True", "lambda c: False", None, "either"),
        ("LaunchConfiguration('x')", "'true'", "true", "either"),
    ],
)
def test_how_conditions_go_together(launches, first, second, default, expected):
    assert started_under(launches, first, second, default) == expected


def test_one_condition_in_a_variable_excludes_its_opposite(launches):
    before = f"{OWN}\nreal = is_real()\nother = is_real()"
    nodes = [
        node(name, condition=f"{kind}({what})")
        for name, kind, what in [
            ("a", "IfCondition", "real"),
            ("b", "UnlessCondition", "real"),
            ("c", "UnlessCondition", "other"),
        ]
    ]
    a, b, c = (dict(started.branch_arms) for started in launches.python(f"[{', '.join(nodes)}]", before=before).started)
    assert a.keys() == b.keys() and a != b
    assert a.keys() != c.keys()


@pytest.mark.parametrize(
    ("text", "runs"),
    [("'True'", True), ("' 1 '", True), ("'FALSE'", False), ("'yes'", None), ("''", None), ("'on'", None)],
)
def test_the_truth_of_a_text_is_launchs(launches, text, runs):
    (started,) = launches.python(f"[{node('n', condition=f'IfCondition({text})')}]").started
    assert (None if started.branch_arms else not started.dormant) is runs


@pytest.mark.parametrize(
    ("test", "runs"),
    [
        ("EqualsSubstitution('Sim', 'sim')", False),
        ("EqualsSubstitution('True', '1')", True),
        ("EqualsSubstitution('1.0', '1')", True),
        ("NotEqualsSubstitution('a', 'b')", True),
        ("NotSubstitution('off')", True),
        ("NotSubstitution('oFF')", None),
        ("AndSubstitution('yes', '1')", True),
        ("PythonExpression(['not ', 'False'])", True),
        ("PythonExpression(['not ', 'false'])", None),  # a NameError
    ],
)
def test_the_truth_of_a_substitution_is_launchs(launches, test, runs):
    (started,) = launches.python(f"[{node('n', condition=f'IfCondition({test})')}]", before=OWN).started
    assert (None if started.branch_arms else not started.dormant) is runs


def test_an_argument_set_anew_is_another_condition(launches):
    launched = launches.xml(
        '<arg name="x"/><node pkg="robot" exec="talker" name="a" if="$(var x)"/>'
        '<let name="x" value="$(command \'id\')"/><node pkg="robot" exec="talker" name="b" unless="$(var x)"/>'
    )
    first, second = (dict(started.branch_arms) for started in launched.started)
    assert first.keys() != second.keys()
    assert launched.undecided == {"x": ["true", "false"]}


def test_an_argument_keeps_its_condition_under_another_name(launches):
    launches.file(
        "robot/launch/inner.launch.xml",
        '<launch><arg name="sim"/><node pkg="robot" exec="talker" name="b" unless="$(var sim)"/></launch>',
    )
    launched = launches.xml(
        '<arg name="x"/><node pkg="robot" exec="talker" name="a" if="$(var x)"/>'
        '<include file="$(find-pkg-share robot)/launch/inner.launch.xml"><arg name="sim" value="$(var x)"/></include>'
    )
    assert [launched.condition(started.branch_arms) for started in launched.started] == ["x:=true", "x:=false"]


# ------------------------------------------------------------------------------- one of several actions

ONE_OR_OTHER = f"one, other = {node('one')}, {node('other')}\nreal = os.path.exists('/dev/robot')\n"


@pytest.mark.parametrize(
    ("actions", "before"),
    [
        ("[one if real else other]", ""),
        ("[one] if real else [other]", ""),
        ("[GroupAction([one] if real else [other])]", ""),
        ("[chosen]", "if real:\n    chosen = one\nelse:\n    chosen = other"),
        ("chosen", "if real:\n    chosen = [one]\nelse:\n    chosen = [other]"),
        ("[OpaqueFunction(function=lambda context: [one if real else other])]", ""),
    ],
)
def test_one_of_two_actions_excludes_the_other(launches, actions, before):
    one, other = (
        dict(started.branch_arms) for started in launches.python(actions, before=ONE_OR_OTHER + before).started
    )
    assert one.keys() == other.keys() and one != other


def test_what_is_in_both_lists_runs_always(launches):
    before = ONE_OR_OTHER + f"both = {node('both')}\nchosen = [both, one] if real else [both, other]"
    conditional = {s.name.text: bool(s.branch_arms) for s in launches.python("chosen", before=before).started}
    assert conditional == {"both": False, "one": True, "other": True}


def test_each_entry_of_a_yaml_list_has_its_own_place(launches):
    launched = launches.yaml(
        "launch:\n"
        "- include:\n"
        "    file: $(find-pkg-share robot)/launch/other.launch.yaml\n"
        "    arg:\n"
        "    - {name: a, value: '1'}\n"
        "    - name: b\n"
        "      value: '2'\n"
        "- node:\n"
        "    pkg: robot\n"
        "    exec: talker\n"
        "    remap:\n"
        "    - from: x\n"
        "      to: y\n"
        "    - {from: v, to: w}\n"
        "    param:\n"
        "    - {name: rate, value: 1.0}\n"
        "    -\n"
        "      name: speed\n"
        "      value: 2.0\n"
    )
    (included,), (started,) = launched.included, launched.started
    assert [(name, place.line, place.column) for name, place in included.arguments] == [("a", 5, 8), ("b", 6, 7)]
    assert [remap.place.line for remap in started.remaps] == [12, 14]
    assert [parameter.place.line for parameter in started.parameters] == [16, 18]


@pytest.mark.parametrize(
    "folder",
    [
        "os.path.dirname(os.path.abspath(__file__))",
        "os.path.dirname(os.path.dirname(os.path.realpath(__file__))) + '/launch'",
        "str(Path(__file__).resolve().parent)",
    ],
)
def test_a_launch_file_knows_where_it_is(launches, folder):
    launches.file("robot/launch/p.yaml", "/**:\n  ros__parameters: {rate: 1}\n")
    [node] = launches.python(
        f"[Node(package='p', executable='e', parameters=[os.path.join({folder}, 'p.yaml')])]",
        "from pathlib import Path",
    ).started
    [use] = node.parameters
    assert (use.reference.source, use.reference.status) == ("robot/launch/p.yaml", "installed")


FLAT = """\
from glob import glob
from setuptools import setup
setup(name='robot', data_files=[('share/robot', glob('launch/*.py')), ('share/robot/config', glob('config/*'))])
"""


@pytest.mark.parametrize(("file", "status"), [("config/p.yaml", "installed"), ("config/q.yaml", "missing")])
def test_the_way_from_a_launch_file_starts_where_it_is_installed(launches, file, status):
    launches.file("robot/setup.py", FLAT)
    launches.file("robot/config/p.yaml", "/**:\n  ros__parameters: {rate: 1}\n")
    [node] = launches.python(
        f"[Node(package='p', executable='e', parameters=[os.path.join(os.path.dirname(__file__), '{file}')])]"
    ).started
    [use] = node.parameters
    assert use.reference.status == status


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
    assert {one.name: one.value for one in settings_of(started, None, loaded.files.parameters)} == {
        "plain": 5,
        "quoted": "5",
        "empty": "",
        "nothing": NotKnown("a text that YAML may read in several ways"),
        "joints": ["left_hip", "left_knee", "fixed"],
        "numbers": NotKnown("a text that YAML may read in several ways"),  # whether its item is quoted is not kept
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
        ("LaunchConfiguration('unset')", "the launch configuration 'unset' is not set"),
    ],
)
def test_a_parameter_that_is_not_known_says_why(launches, value, why):
    launched = launches.python(
        "[DeclareLaunchArgument('robot', default_value=os.environ['ROBOT']), "
        f"Node(package='robot', executable='talker', parameters=[{{'p': {value}, 'rate': 5}}])]"
    )
    assert parameters(launched.started[0]) == {"p": NotKnown(why), "rate": 5}


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
    assert {one.name: one.value for one in settings_of(started, None, loaded.files.parameters)} == {
        "arm": NotKnown("the environment variable ARM"),
        "leg": NotKnown("the environment variable LEG"),
    }


@pytest.mark.parametrize(
    ("code", "why"),
    [
        ("if os.environ['ROBOT'] == 'arm':\n    description.append({0})", "the environment variable ROBOT"),
        ("description += [{0}] if os.getenv('ROBOT') else []", "the environment variable ROBOT"),
        ("if 'arm' in get_search_paths():\n    description.append({0})", "the environment variable AMENT_PREFIX_PATH"),
        (
            "if 'arm' in [path.split('/')[-1] for path in get_search_paths()]:\n    description.append({0})",
            "the environment variable AMENT_PREFIX_PATH",
        ),
    ],
)
def test_why_nobody_knows_whether_a_node_is_started(launches, code, why):
    imported = "from ament_index_python.packages import get_search_paths"
    before = f"{imported}\ndescription = []\n{code.format(node('talker'))}"
    launched = launches.python("description", before)
    [started] = launched.started
    assert launched.reasons(started.branch_arms) == [why]
    assert launched.condition(started.branch_arms) == f"a condition ({why})"


def test_why_a_condition_is_open(launches):
    condition = "IfCondition(EnvironmentVariable('ROBOT'))"
    launched = launches.python(f"[{node('talker', condition=condition)}]")
    [started] = launched.started
    assert launched.reasons(started.branch_arms) == ["the environment variable ROBOT"]


@pytest.mark.parametrize(("variable", "shown"), [("ROBOT", "spare"), ("USER", None)])
def test_the_default_of_a_variable_that_each_machine_has(launches, variable, shown):
    launched = launches.xml(f'<node pkg="robot" exec="talker" name="$(env {variable} spare)"/>')
    [name] = [started.name for started in launched.started]
    assert name.text == shown


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


def test_ros2_launch_is_an_include_with_a_process_of_its_own(launches):
    launches.file("robot/launch/inner.launch.xml", '<launch><node pkg="p" exec="inner"/></launch>')
    launched = launches.python("[ExecuteProcess(cmd=['ros2', 'launch', 'robot', 'inner.launch.xml'])]")
    assert [(one.reference.source, one.own_process) for one in launched.included] == [
        ("robot/launch/inner.launch.xml", True)
    ]
    plain = launches.xml('<include file="$(find-pkg-share robot)/launch/inner.launch.xml"/>')
    assert [one.own_process for one in plain.included] == [False]


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
        return [{row.name: row.value for row in settings_of(one, None, loaded.files.parameters)} for one in started]

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

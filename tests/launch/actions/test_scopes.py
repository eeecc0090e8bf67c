"""What launch actions do to the context of later ones: namespaces, remappings, arguments, groups."""

from __future__ import annotations

import pytest

from launching import names, node, remaps


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


def test_what_a_group_hands_on_is_read_before_it_forgets_the_rest(launches):
    arguments = "DeclareLaunchArgument('outer', default_value='o')"
    inner = node("n").replace("'n'", "LaunchConfiguration('kept')")
    group = f"GroupAction([{inner}], forwarding=False, launch_configurations={{'kept': LaunchConfiguration('outer')}})"
    assert names(launches.python(f"[{arguments}, {group}]")) == ["o"]


def test_a_group_that_keeps_what_is_not_known_may_keep_any(launches):
    arguments = "ld := LaunchDescription([DeclareLaunchArgument('outer', default_value='o')])"
    kept = "{a.name: LaunchConfiguration(a.name) for a in ld.get_launch_arguments()}"
    inner = node("n").replace("'n'", "LaunchConfiguration('outer')")
    group = f"GroupAction([{inner}], forwarding=False, launch_configurations={kept})"
    launched = launches.python(f"[{arguments}, {group}]")
    assert names(launched) == ["?"] and not launched.undeclared


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


@pytest.mark.parametrize(
    "later",
    [
        "TimerAction(period=1.0, actions=[NODE])",
        "RegisterEventHandler(OnProcessExit(target_action=None, on_exit=[NODE]))",
        "RegisterEventHandler(OnProcessExit(target_action=None, on_exit=lambda event, context: [NODE]))",
        "GroupAction([TimerAction(period=1.0, actions=[NODE])])",
    ],
)
def test_what_starts_later_is_outside_of_the_groups_around_it(launches, later: str):
    group = "GroupAction([PushRosNamespace('left'), SetRemap('scan', 'laser'), {now}, {later}])"
    actions = group.format(now=node("now"), later=later.replace("NODE", node("later")))
    launched = launches.python(f"[PushRosNamespace('robots'), {actions}]")
    assert names(launched) == ["/robots/left/now", "/robots/later"]
    assert [remaps(started) for started in launched.started] == [[("scan", "laser")], []]


def test_what_starts_later_is_inside_of_its_own_groups(launches):
    timer = (
        f"TimerAction(period=1.0, actions=[GroupAction([PushRosNamespace('arm'), {node('later')}]), {node('last')}])"
    )
    launched = launches.python(f"[GroupAction([PushRosNamespace('left'), {timer}]), {node('after')}]")
    assert names(launched) == ["/arm/later", "last", "after"]
    unscoped = (
        f"GroupAction([PushRosNamespace('left'), TimerAction(period=1.0, actions=[{node('later')}])], scoped=False)"
    )
    assert names(launches.python(f"[{unscoped}]")) == ["/left/later"]

"""What launch files start: nodes, containers, components, commands, and what event handlers start."""

from __future__ import annotations

import pytest

from launching import names, node


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


def test_the_keywords_of_nodes_before_galactic(launches):
    launched = launches.python(
        "[Node(package='robot', node_executable='talker', node_name='first', node_namespace='left'), "
        "Node(package='robot', executable='talker', name='second', node_name='third'), "
        "ComposableNodeContainer(node_name='box', node_namespace='', package='rclcpp_components', "
        "node_executable='component_container', composable_node_descriptions=[ComposableNode(package='p', "
        "node_plugin='p::C', node_name='c')])]"
    )
    assert [(s.kind, s.executable.text) for s in launched.started] == [
        ("node", "talker"),
        ("node", "talker"),
        ("container", "component_container"),
        ("component", "p::C"),
    ]
    assert names(launched) == ["/left/first", "second", "/box", "c"]


def test_an_installed_program_that_python_is_told_to_run_is_a_node(launches):
    path = "get_package_prefix('robot') + '/lib/robot/talker'"
    launched = launches.python(
        f"[ExecuteProcess(cmd=['python3', {path}, 'x']), ExecuteProcess(cmd=['python3', 'tool.py'])]",
        before="from ament_index_python.packages import get_package_prefix",
    )
    assert [(s.kind, s.executable.text, s.arguments) for s in launched.started] == [
        ("node", "talker", ["x"]),
        ("process", "python3", ["tool.py"]),
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


@pytest.mark.parametrize("real", ["true", "false"])
def test_one_of_two_handlers_starts_it(launches, real):
    """An action that is given to two handlers starts with the one whose condition holds."""
    before = f"spawner = {node('spawner')}\nwhen = OnProcessExit(target_action=None, on_exit=[spawner])"
    handlers = ", ".join(
        f"RegisterEventHandler(when, condition={condition}(LaunchConfiguration('real')))"
        for condition in ("IfCondition", "UnlessCondition")
    )
    actions = f"[DeclareLaunchArgument('real', default_value='{real}'), {handlers}]"
    launched = launches.python(actions, before)
    assert names(launched) == ["spawner"] and len(launched.started) == 1


def test_two_processes_of_one_place_and_name_are_two(launches):
    before = f"def start():\n    return {node('driver')}\n"
    assert names(launches.python("[start(), start()]", before)) == ["driver", "driver"]


def test_what_starts_after_a_process_has_ended_well(launches):
    before = f"""
def after(event, context):
    return [{node("handled")}] if event.returncode == 0 else []
"""
    handler = "RegisterEventHandler(OnProcessExit(target_action=None, on_exit=after))"
    launched = launches.python(f"[{handler}]", before)
    (started,) = launched.started
    assert {launched.why_open[branch] for branch, _ in started.branch_arms} == {"how a process ends"}


@pytest.mark.parametrize(
    ("ready", "why"),
    [
        ("re.search('ready', event.text.decode())", "what a process prints"),
        ("re.compile('ready').match(event.text.decode())", "what a process prints"),
        ("re.search('ready', 'ready')", "what a regular expression finds"),
    ],
)
def test_what_starts_when_a_process_has_printed_a_line(launches, ready, why):
    before = f"""
import re
from launch.event_handlers import OnProcessIO
def printed(event):
    return [{node("handled")}] if {ready} else []
"""
    launched = launches.python("[RegisterEventHandler(OnProcessIO(target_action=None, on_stdout=printed))]", before)
    (started,) = launched.started
    assert {launched.why_open[branch] for branch, _ in started.branch_arms} == {why}

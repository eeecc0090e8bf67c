"""What hovering over a name tells."""

from __future__ import annotations

from archlint.rulebook import find_rule
from lookup.asking import Editor


def test_a_topic_from_both_ends(lesson: Editor):
    expected = (
        "topic `/sensor_data`: `my_robot_interfaces/msg/SensorReading`\n\n"
        "Published by\n"
        "- `/sensor_node`: reliable, volatile, keep last 10, 1 Hz, "
        "src/my_first_package/my_first_package/sensor_node.py:12 (src/my_first_package/launch/robot.launch.py)\n\n"
        "Subscribed by\n"
        "- `/control_node`: reliable, volatile, keep last 10, "
        "src/my_first_package/my_first_package/control_node.py:12 (src/my_first_package/launch/robot.launch.py)"
    )
    assert lesson.hover("sensor_node.py", "'sensor^_data'") == expected
    assert lesson.hover("control_node.py", "'^sensor_data'") == expected


def test_a_create_call_is_told_where_its_method_is_named(lesson: Editor):
    told = lesson.hover("control_node.py", "self.create^_subscription(") or ""
    assert told.startswith("topic `/sensor_data`")
    assert lesson.hover("control_node.py", "self.sensor^_callback,") is None


def test_a_service(lesson: Editor):
    told = lesson.hover("control_node.py", "'set^_motor'") or ""
    assert told.startswith(
        "service `/set_motor`: `my_robot_interfaces/srv/SetMotorSpeed`\n\nServed by\n- `/motor_node`: "
    )
    assert "Called by\n- `/control_node`: src/" in told


def test_each_name_that_a_launch_file_gives(launched: Editor):
    told = launched.hover("driver.py", "'sc^an'") or ""
    north, south = told.split("\n\n---\n\n")
    assert north.startswith("topic `/north/front/scan`") and "- `/north/scanner`: " in north
    assert south.startswith("topic `/south/scan`") and "- `/south/scanner`: " in south


def test_a_remapping_tells_of_the_final_name(launched: Editor):
    assert (launched.hover("fleet.launch.py", "'/south^/scan'") or "").startswith("topic `/south/scan`")


def test_a_parameter_and_what_sets_it(launched: Editor):
    expected = (
        "parameter `topic`: string = `'scan'`\n\n"
        "Declared at src/patrol/patrol/scanner.py:9\n\n"
        "Value when launched:\n- `/north/scanner`: `'front/scan'` (string)\n\n"
        "Set at src/patrol/config/patrol.yaml:4"
    )
    assert launched.hover("scanner.py", "'to^pic'") == expected
    assert launched.hover("patrol.yaml", "t^opic: front") == expected


def test_a_value_that_is_the_name_of_a_topic(launched: Editor):
    assert (launched.hover("patrol.yaml", "fr^ont/scan") or "").startswith("topic `/north/front/scan`")


def test_an_executable_of_a_launch_file(launched: Editor):
    told = launched.hover("robot.launch.xml", 'exec="scan^ner"') or ""
    assert told.startswith("executable `scanner` of package `patrol`\n\nnode `/north/scanner`: class `Scanner`, ")
    assert "- publishes `/north/front/scan` (`std_msgs/msg/String`)\n- timer every 0.5 s\n- parameter `topic`" in told


def test_the_node_that_a_parameter_file_names(launched: Editor):
    told = launched.hover("patrol.yaml", "/north/sc^anner:") or ""
    assert told.startswith("node `/north/scanner`: class `Scanner`, src/patrol/patrol/scanner.py:6")


def test_an_executable_from_elsewhere(launched: Editor):
    assert (
        launched.hover("fleet.launch.py", "name='b^ag'") == "node `/tools/bag`, whose source is not in this workspace"
    )


def test_an_included_file_and_its_arguments(launched: Editor):
    expected = "file `src/patrol/launch/robot.launch.xml`\n\nLaunch arguments:\n- `scan`, by default `scan`"
    assert launched.hover("fleet.launch.py", "'robot.launch^.xml'") == expected


def test_a_type(lesson: Editor):
    told = lesson.hover("sensor_node.py", "^SensorReading, 'sensor_data'") or ""
    assert told.startswith("`my_robot_interfaces/msg/SensorReading`\n\n```\n") and "float64 value" in told


def test_the_code_of_a_rule_in_a_suppression(lesson: Editor):
    file = lesson.path("motor_node.py")
    text = (lesson.text_of(file) or "").replace("motor_speeds = {}", "motor_speeds = {}  # archlint: ignore[SRV003]")
    rule = find_rule("SRV003")
    assert rule is not None
    lesson.buffers[file] = text
    try:
        told = lesson.hover("motor_node.py", "SRV^003") or ""
        assert told.startswith("SRV003 nested-service-call (error)") and rule.summary in told
        assert lesson.hover("motor_node.py", "arch^lint") is None
    finally:
        lesson.buffers.clear()


def test_nothing_of_what_has_changed_since(lesson: Editor):
    file = lesson.path("motor_node.py")
    lesson.buffers[file] = (lesson.text_of(file) or "").replace("'set_motor'", "'set_speed'")
    try:
        assert lesson.hover("motor_node.py", "'set^_speed'") is None
    finally:
        lesson.buffers.clear()


def test_lines_that_have_moved(lesson: Editor):
    """Above the line somebody types what no parser takes: what is below is known all the same, where it is now."""
    file = lesson.path("motor_node.py")
    lesson.buffers[file] = "import (\n\n" + (lesson.text_of(file) or "")
    try:
        assert (lesson.hover("motor_node.py", "'set^_motor'") or "").startswith("service `/set_motor`")
        assert lesson.definition("control_node.py", "'set^_motor'") == ["motor_node.py:14 'set_motor'"]
        assert lesson.references("motor_node.py", "'set^_motor'") == [
            "control_node.py:22 'set_motor'",
            "motor_node.py:14 'set_motor'",
        ]
    finally:
        lesson.buffers.clear()


def test_nothing_of_other_texts(lesson: Editor):
    assert lesson.hover("motor_node.py", "'Motor service^ ready'") is None

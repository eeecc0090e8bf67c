from __future__ import annotations

from dataclasses import replace

from archlint.render.text import render
from archlint.ros.qos import Qos
from archlint.syntax.parameter_files import NotKnown
from render.hostile import hostile
from render.lesson import lesson
from systems.builders import (
    action_client,
    blueprint,
    client,
    from_parameter,
    node,
    parameter,
    place,
    publisher,
    subscriber,
    system,
    unknown,
)

LESSON = """\
3 nodes

/control_node  ControlNode  my_first_package/control_node  src/my_first_package/my_first_package/control_node\
.py:6
  subscribes  /sensor_data   my_robot_interfaces/msg/SensorReading  line 10, reliable, volatile, keep last 10
  calls       /query_sensor  my_robot_interfaces/srv/GetSensorData  line 11
  calls       /set_motor     my_robot_interfaces/srv/SetMotorSpeed  line 12
  timer       every 2 s      ControlNode.control_loop               line 13

/motor_node  MotorNode  my_first_package/motor_node  src/my_first_package/my_first_package/motor_node.py:6
  serves  /set_motor  my_robot_interfaces/srv/SetMotorSpeed  line 10

/sensor_node  SensorNode  my_first_package/sensor_node  src/my_first_package/my_first_package/sensor_node.py:6
  publishes  /sensor_data   my_robot_interfaces/msg/SensorReading  line 10, reliable, volatile, keep last 10
  serves     /query_sensor  my_robot_interfaces/srv/GetSensorData  line 11
  timer      every 1 s      SensorNode.publish_sensor              line 12
  parameter  rate           double = 1.0                           line 13

1 topic

/sensor_data  my_robot_interfaces/msg/SensorReading
  published by   /sensor_node
  subscribed by  /control_node

2 services

/query_sensor  my_robot_interfaces/srv/GetSensorData
  served by      /sensor_node
  called by      /control_node

/set_motor  my_robot_interfaces/srv/SetMotorSpeed
  served by      /motor_node
  called by      /control_node

shape

  pattern: request clusters
  connected: 3 of 3 nodes; pairs 1 by topics, 2 by services
  hub: /control_node, fan-in 1, fan-out 2
  longest chain of requests: /control_node -> /sensor_node
"""


def test_the_lesson() -> None:
    assert render(lesson()) == LESSON


def test_colour_changes_nothing_but_the_colour() -> None:
    import re

    coloured = render(lesson(), color=True)
    assert "\x1b[" in coloured
    assert re.sub(r"\x1b\[[0-9;]*m", "", coloured) == LESSON


def test_an_end_that_nobody_holds() -> None:
    assert "  published by   no node here\n" in render(system(node("/n", subscriber("/scan"))))


def test_types_that_differ() -> None:
    shown = render(system(node("/a", publisher("/x", "p/msg/A")), node("/b", subscriber("/x", "p/msg/B"))))
    assert "/x  p/msg/A ≠ p/msg/B" in shown


def test_qos_in_words() -> None:
    nothing = Qos(history=None, reliability=None, durability=None)
    shown = render(system(node("/n", publisher("/a", qos=nothing), publisher("/b", qos=Qos(depth=None)))))
    assert "line 10, QoS not known\n" in shown
    assert "line 11, reliable, volatile, keep last ?\n" in shown


def test_what_is_known_only_in_part() -> None:
    shown = render(
        system(
            node(
                "/n",
                publisher(from_parameter("topic", "a"), conditional=True),
                publisher(unknown("it comes from sys.argv"), None),
                client("b c"),
            )
        )
    )
    assert "from the parameter topic, only under a condition" in shown
    assert "topic name must not contain characters other than" in shown
    assert shown.endswith("1 not resolved\n\n  src/demo/demo/n.py:11  publisher  it comes from sys.argv\n")


def test_an_endpoint_of_another_file_says_so() -> None:
    made = blueprint("n", publisher("a"), action_client("b"))
    made.creations[0].place = place("src/demo/demo/helper.py", 3)
    from archlint.systems.instances import instantiate

    shown = render(system(instantiate(made, None)))
    assert "src/demo/demo/helper.py:3, reliable" in shown
    assert "line 11" in shown


def test_a_node_without_a_name() -> None:
    from archlint.systems.instances import instantiate

    helper = instantiate(blueprint(unknown(), publisher("/x"), file="helper.py", class_name="Helper"), None)
    shown = render(system(helper))
    assert "name not known  Helper  demo  helper.py:6" in shown
    assert "a node whose name is not known" in shown


def test_nothing_at_all() -> None:
    assert render(system()) == "no nodes\n"


def test_no_name_steers_the_terminal() -> None:
    shown = render(hostile())
    assert "\x1b" not in shown
    assert "\u202e" not in shown
    assert "\r" not in shown
    assert shown.encode("utf-8")


def test_a_parameter_that_the_launch_sets_is_shown_with_its_value():
    scanner = node("/scanner", parameter("topic", "scan"), parameter("rate", 1.0, "double"))
    started = replace(scanner, overrides={"topic": "front/scan", "rate": NotKnown("the environment variable RATE")})

    rows = [" ".join(line.split()) for line in render(system(started)).splitlines()]

    assert any(
        row.startswith("parameter topic string = 'front/scan', set by the launch (default 'scan')") for row in rows
    )
    rate = "parameter rate double = ? (the environment variable RATE), set by the launch (default 1.0)"
    assert any(row.startswith(rate) for row in rows)


def test_a_parameter_that_nothing_sets_is_shown_with_its_default():
    shown = render(system(node("/scanner", parameter("rate", 1.0, "double"))))
    assert "parameter rate double = 1.0 line" in " ".join(shown.split())

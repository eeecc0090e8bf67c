"""OWN001: what only a command, a state or two streams of values can override, and frames for a device."""

from __future__ import annotations

import pytest

from archlint.config.settings import load
from archlint.engine.pipeline import Request, check
from checks.judging import Judge
from robot_package import write_files

NODES = """
import rclpy
from {package}.msg import {kind}
from rclpy.executors import SingleThreadedExecutor
from rclpy.node import Node
from std_srvs.srv import Trigger

class Poller(Node):
    def __init__(self):
        super().__init__('poller')
        self.out = self.create_publisher({kind}, '{topic}', 10)
        self.create_timer(0.1, self.tick)

    def tick(self):
        self.out.publish({kind}())

class Driver(Node):
    def __init__(self):
        super().__init__('driver')
        self.out = self.create_publisher({kind}, '{topic}', 10){here}
        {on}

    def tick(self, request=None, response=None):
        self.out.publish({kind}())
        return response

def main():
    rclpy.init()
    executor = SingleThreadedExecutor()
    executor.add_node(Poller())
    executor.add_node(Driver())
    executor.spin()

main()
"""
ALWAYS = "self.create_timer(0.1, self.tick)"
IF_SEEN = "self.create_timer(0.1, lambda: self.tick() if self.seen else None)"
AT_TIMES = "self.create_service(Trigger, 'send', self.tick)"


@pytest.mark.parametrize(
    ("kind", "topic", "on", "told"),
    [
        ("geometry_msgs.Twist", "drive", ALWAYS, True),
        ("std_msgs.Float32", "wheel_cmd", AT_TIMES, True),
        ("std_msgs.Int32", "mode", AT_TIMES, True),
        ("std_msgs.Bool", "light", AT_TIMES, True),
        ("geometry_msgs.PoseStamped", "arm/target", AT_TIMES, True),
        ("std_msgs.Float32", "motor_speed", AT_TIMES, True),
        ("std_msgs.Float32", "temperature", ALWAYS, True),
        ("std_msgs.Float32", "temperature", IF_SEEN, True),
        ("std_msgs.Float32", "temperature", AT_TIMES, False),  # one value more, and the next one comes at once
    ],
)
def test_one_stream_beside_what_is_said_at_times(judge: Judge, kind: str, topic: str, on: str, told: bool):
    package, _, name = kind.partition(".")
    judge("OWN001", NODES.format(package=package, kind=name, topic=topic, on=on, here="  # here" if told else ""))


@pytest.mark.parametrize(
    ("kind", "topic", "told"),
    [
        ("std_msgs.UInt8MultiArray", "out", False),
        ("std_msgs.Int32", "send_can0", False),
        ("std_msgs.Int32", "base/uart_tx", False),
        ("std_msgs.Int32", "canopy", True),
        ("std_msgs.Int32", "can_cmd", True),  # a command, whatever carries it
        ("std_msgs.Float32MultiArray", "out", True),
    ],
)
def test_frames_for_a_device(judge: Judge, kind: str, topic: str, told: bool):
    package, _, name = kind.partition(".")
    judge("OWN001", NODES.format(package=package, kind=name, topic=topic, on=ALWAYS, here="  # here" if told else ""))


@pytest.mark.parametrize(
    ("definition", "told"),
    [
        ("uint8[8] left\nuint8[8] right\n", 0),
        ("byte[] data\n", 0),
        ("uint8[8] data\nfloat32 speed\n", 1),
        ("uint8 level\n", 1),
    ],
)
def test_a_message_of_nothing_but_octets(tmp_path, monkeypatch, definition: str, told: int):
    monkeypatch.chdir(tmp_path)
    manifest = "<package format='3'><name>share</name><version>0.0.1</version>"
    manifest += "<member_of_group>rosidl_interface_packages</member_of_group></package>"
    cmake = (
        'project(share)\nfind_package(rosidl_default_generators)\nrosidl_generate_interfaces(share "msg/Sent.msg")\n'
    )
    nodes = NODES.format(package="share", kind="Sent", topic="out", on=ALWAYS, here="")
    texts = {"share/package.xml": manifest, "share/CMakeLists.txt": cmake, "share/msg/Sent.msg": definition}
    write_files(tmp_path, {**texts, "nodes.py": nodes, "archlint.toml": 'select = ["OWN001"]\nclosed-world = true\n'})
    assert len(check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings) == told

"""TOP008: clocks that nobody hears, and nodes that wait for a clock."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from archlint.finding import Finding
from checks.judging import Judge

Findings = Callable[..., list[Finding]]

SIMULATOR = """
import rclpy
from rclpy.node import Node
from rosgraph_msgs.msg import Clock
from std_msgs.msg import String


class Simulator(Node):
    def __init__(self):
        super().__init__('simulator'{options})
        self.create_publisher({clock}
        {more}


def main():
    rclpy.init()
    rclpy.spin(Simulator())


if __name__ == '__main__':
    main()
"""


def simulator(clock: str, options: str = "", more: str = "pass") -> str:
    return SIMULATOR.format(clock=clock, options=options, more=more)


@pytest.mark.parametrize(
    ("clock", "options"),
    [
        ("Clock, '/sim_clock', 10)  # here", ""),
        ("Clock, '~/clock', 10)  # here", ""),
        ("Clock, 'clock', 10)  # here", ", namespace='arena'"),
        ("Clock, '/clocks', 10)  # here", ""),
    ],
)
def test_a_clock_on_another_topic(judge: Judge, clock: str, options: str):
    [finding] = judge("TOP008", simulator(clock, options))
    assert "nodes with use_sim_time listen to '/clock'" in finding.message


@pytest.mark.parametrize(
    ("clock", "options", "more"),
    [
        ("Clock, '/clock', 10)", "", "pass"),
        ("Clock, 'clock', 10)", "", "pass"),
        ("Clock, '/clock', 10)", ", namespace='arena'", "pass"),
        ("String, '/sim_clock', 10)", "", "pass"),
        ("Clock, '/sim_clock', 10)", "", "self.create_subscription(Clock, '/sim_clock', print, 10)"),
        ("Clock, '/sim_clock', 10)", ", cli_args=['--ros-args', '-r', '/clock:=/sim_clock']", "pass"),
        ("Clock, self.get_parameter('somewhere').value, 10)", "", "pass"),
    ],
)
def test_a_clock_that_somebody_hears(judge: Judge, clock: str, options: str, more: str):
    assert not judge("TOP008", simulator(clock, options, more))


def test_a_clock_that_is_listed_as_external(judge: Judge):
    assert not judge("TOP008", simulator("Clock, '/sim_clock', 10)"), config='external = ["/sim_clock"]')


# --- as it is launched


@pytest.mark.parametrize(
    ("launch", "number"),
    [
        ("<node pkg='robot' exec='talker' namespace='arena'/>", 1),
        ("<group><push-ros-namespace namespace='arena'/><node pkg='robot' exec='talker'/></group>", 1),
        ("<node pkg='robot' exec='talker'/>", 0),
        ("<node pkg='robot' exec='talker' namespace='arena'><remap from='clock' to='/clock'/></node>", 0),
        (
            "<node pkg='robot' exec='talker' namespace='arena'/>"
            "<node pkg='nav2' exec='amcl'><remap from='/clock' to='/arena/clock'/></node>",
            0,
        ),
    ],
)
def test_the_name_that_a_launch_file_gives(findings: Findings, launch: str, number: int):
    files = {"robot/talker.py": simulator("Clock, 'clock', 10)")}
    assert len(findings("TOP008", launch, **files)) == number


TALKER = "<node pkg='robot' exec='talker'><param name='use_sim_time' value='{value}'/></node>"
CLOSED = {"archlint.toml": "select = ['TOP008']\nclosed-world = true\n"}
CLOCK = {
    "robot/clock.py": simulator("Clock, '/clock', 10)"),
    "setup.py": "from setuptools import setup\nsetup(name='robot', data_files=[('share/robot/launch', "
    "['launch/it.launch.xml'])], entry_points={'console_scripts': ['talker = robot.talker:main', "
    "'clock = robot.clock:main']})\n",
}


def test_nobody_publishes_the_clock(findings: Findings):
    [finding] = findings("TOP008", TALKER.format(value="true"), **CLOSED)
    assert "/talker takes its time from '/clock', and no node publishes that" in finding.message
    assert finding.place.file == "launch/it.launch.xml"


@pytest.mark.parametrize(
    ("launch", "files"),
    [
        (TALKER.format(value="true"), {}),
        (TALKER.format(value="false"), CLOSED),
        (TALKER.format(value="$(env SIMULATED)"), CLOSED),
        ("<node pkg='robot' exec='talker'/>", CLOSED),
        (TALKER.format(value="true") + "<node pkg='ros_gz_bridge' exec='parameter_bridge'/>", CLOSED),
        (TALKER.format(value="true") + "<executable cmd='gz sim'/>", CLOSED),
        (TALKER.format(value="true") + "<node pkg='robot' exec='clock'/>", CLOSED | CLOCK),
        (
            TALKER.format(value="true"),
            {"archlint.toml": CLOSED["archlint.toml"] + "external = ['/clock']\n"},
        ),
    ],
)
def test_somebody_may_publish_the_clock(findings: Findings, launch: str, files: dict[str, str]):
    assert not findings("TOP008", launch, **files)

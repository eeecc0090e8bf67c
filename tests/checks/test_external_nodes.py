"""Rules of the graph where one end is a node whose source is not here, and that is known all the same."""

from __future__ import annotations

from pathlib import Path

import pytest
from msgspec.structs import replace

from archlint.config.settings import Settings
from archlint.engine.pipeline import Request, check
from archlint.ros.external_nodes import ExternalEnd, ExternalNode, ExternalParameter, ExternalQos, OpenQuestion
from robot_package import manifest, write_robot

NODE = """\
import rclpy
from rclpy.node import Node
from rclpy.qos import QoSProfile, ReliabilityPolicy
from geometry_msgs.msg import Twist, TwistStamped
from sensor_msgs.msg import LaserScan

class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        {}

    def on(self, message):
        print(message)

def main():
    rclpy.init()
    rclpy.spin(Talker())
"""
RELIABLE = ExternalQos("keep_last", 10, "reliable", "volatile")
BEST_EFFORT = ExternalQos("keep_last", 5, "best_effort", "volatile")
BASE = ExternalNode(
    "acme",
    ("base",),
    "base",
    ends=(
        ExternalEnd("publisher", "scan", "sensor_msgs/msg/LaserScan", BEST_EFFORT),
        ExternalEnd("subscriber", "cmd_vel", "geometry_msgs/msg/Twist", RELIABLE),
    ),
    parameters=(ExternalParameter("wheel_base", "double", 0.3),),
)
OPEN = ExternalNode("acme", ("base",), "base", ends=BASE.ends, open=(OpenQuestion("its plug-ins say more"),))
SHOWS = ExternalNode("acme", ("view",), "view", ends=(ExternalEnd("subscriber", "scan", "nav_msgs/msg/Odometry"),))


@pytest.fixture
def told(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    """Code, file and message of what is found in a node with these statements beside external ones."""
    monkeypatch.chdir(tmp_path)

    def judge(
        codes: tuple[str, ...],
        statements: str = "pass",
        more: str = '<node pkg="acme" exec="base"/>',
        known: tuple[ExternalNode, ...] = (BASE,),
        closed: bool = False,
    ) -> list[tuple[str, str, str]]:
        write_robot(
            tmp_path,
            f'<node pkg="robot" exec="talker"/>{more}',
            **{"robot/talker.py": NODE.format(statements.replace("\n", "\n        "))},
        )
        settings = Settings(external_nodes=known, closed_world=closed)
        report = check(Request((".",), settings, cached=False, jobs=1))
        return [(d.code, d.place.file, d.message) for d in report.findings if d.code in codes]

    return judge


@pytest.mark.parametrize(
    ("value", "help"),
    [
        ("0.2", "it declares wheel_base"),
        (
            "true",
            "write 'wheel_base' with a value of its type, double: with this one, of the type bool, the node stops",
        ),
    ],
)
def test_a_value_that_the_parameter_which_was_meant_does_not_take(tmp_path, monkeypatch, value: str, help: str):
    monkeypatch.chdir(tmp_path)
    write_robot(tmp_path, f'<node pkg="acme" exec="base"><param name="wheel_bas" value="{value}"/></node>')
    found = check(Request((".",), Settings(external_nodes=(BASE,)), cached=False, jobs=1)).findings
    assert [row.help for row in found if row.code == "PRM004"] == [help]


def test_a_type_that_the_other_node_does_not_take(told):
    [(code, file, message)] = told(("TOP001",), "self.create_publisher(TwistStamped, 'cmd_vel', 10)")
    assert (code, file) == ("TOP001", "robot/talker.py")
    assert message.startswith("/talker publishes '/cmd_vel' as geometry_msgs/msg/TwistStamped, but /base subscribes")
    assert told(("TOP001",), "self.create_publisher(Twist, 'cmd_vel', 10)") == []


def test_a_type_that_only_some_distributions_have_is_no_conflict_where_another_fits(told):
    either = ExternalNode(
        "acme",
        ("base",),
        "base",
        ends=(
            ExternalEnd("subscriber", "cmd_vel", "geometry_msgs/msg/Twist", conditional=True),
            ExternalEnd("subscriber", "cmd_vel", "geometry_msgs/msg/TwistStamped", conditional=True),
        ),
    )
    assert told(("TOP001",), "self.create_publisher(TwistStamped, 'cmd_vel', 10)", known=(either,)) == []
    [(_, _, message)] = told(("TOP001",), "self.create_publisher(LaserScan, 'cmd_vel', 10)", known=(either,))
    assert "but /base subscribes to it as geometry_msgs/msg/Twist:" in message


def test_a_request_that_the_other_node_does_not_serve(told):
    [(_, file, message)] = told(("QOS001",), "self.create_subscription(LaserScan, 'scan', self.on, 10)")
    assert file == "robot/talker.py"
    assert message.startswith("/talker requests reliable on '/scan', but /base offers best effort")


def test_an_offer_that_does_not_serve_the_other_node(told):
    unreliable = "QoSProfile(depth=5, reliability=ReliabilityPolicy.BEST_EFFORT)"
    [(_, file, message)] = told(("QOS001",), f"self.create_publisher(Twist, 'cmd_vel', {unreliable})")
    assert file == "robot/talker.py", "the launch file cannot mend it"
    assert message.startswith("/base requests reliable on '/cmd_vel', but /talker offers best effort")


def test_what_is_between_two_of_them_is_not_told(told):
    both = '<node pkg="acme" exec="base"/><node pkg="acme" exec="view"/>'
    assert told(("TOP001",), more=both, known=(BASE, SHOWS)) == []


def test_two_publishers_one_of_which_is_here(told):
    [(_, file, message)] = told(
        ("OWN001",),
        "self.p = self.create_publisher(LaserScan, 'scan', 10)\n"
        "self.create_timer(0.1, lambda: self.p.publish(LaserScan()))",
    )
    assert file == "robot/talker.py"
    assert "/base and /talker both publish the topic '/scan'" in message


@pytest.mark.parametrize(("known", "found"), [(BASE, 1), (OPEN, 0)], ids=["all is known", "it may have more"])
def test_a_remapping_of_a_name_that_it_does_not_have(told, known: ExternalNode, found: int):
    line = '<node pkg="acme" exec="base"><remap from="cmd_velocity" to="/go"/></node>'
    assert len(told(("LCH002",), more=line, known=(known,))) == found
    line = '<node pkg="acme" exec="base"><remap from="cmd_vel" to="/go"/></node>'
    assert told(("LCH002",), more=line, known=(known,)) == []


@pytest.mark.parametrize(("known", "found"), [(BASE, 1), (OPEN, 0)], ids=["all is known", "it may have more"])
def test_a_parameter_that_it_does_not_declare(told, known: ExternalNode, found: int):
    line = '<node pkg="acme" exec="base"><param name="{}" value="0.2"/></node>'
    assert len(told(("PRM004",), more=line.format("wheelbase"), known=(known,))) == found
    assert told(("PRM004",), more=line.format("wheel_base"), known=(known,)) == []
    assert told(("PRM004",), more=line.format("use_sim_time"), known=(known,)) == []


@pytest.mark.parametrize(
    ("given", "subject"), [('name="wheels" ', "the node 'wheels'"), ("", "a node of acme")], ids=["named", "nameless"]
)
def test_one_whose_namespace_is_not_known_is_called_what_the_launch_file_says(told, given: str, subject: str):
    group = (
        '<arg name="robot"/><group><push-ros-namespace namespace="$(var robot)"/>'
        f'<node pkg="acme" exec="base" {given}><param name="wheelbase" value="0.2"/></node></group>'
    )
    ((_, _, message),) = told(("PRM004",), more=group)
    assert message.startswith(f"{subject} declares no parameter 'wheelbase'")


def test_what_such_a_node_does_not_declare_is_one_finding_for_all_that_start_it(told):
    line = '<node pkg="acme" exec="base"><param name="{}" value="0.2"/></node>'
    twice = line.format("max_speed") + line.format("use_odometry")
    (message,) = [message for _, _, message in told(("PRM004",), more=twice)]
    assert message.startswith("/base declares none of these 2 parameters")


def test_what_is_misspelt_of_such_a_node_is_one_finding(told):
    slips = (
        '<node pkg="acme" exec="base"><param name="wheel_bas" value="1"/><param name="wheel_bases" value="2"/></node>'
    )
    ((_, _, message),) = told(("PRM004",), more=slips)
    assert message.endswith("wheel_bas (did you mean 'wheel_base'?), wheel_bases ('wheel_base'?)")


@pytest.mark.parametrize(("distros", "named"), [((), True), (("humble", "jazzy"), True), (("jazzy",), False)])
def test_a_parameter_that_only_some_distributions_have_is_no_advice(told, distros: tuple[str, ...], named: bool):
    newer = ExternalParameter("wheel_bases", "double", 0.3, distros=distros)
    known = replace(BASE, versions={"humble": "1.0", "jazzy": "2.0"}, parameters=(newer,))
    ((_, _, message),) = told(
        ("PRM004",), more='<node pkg="acme" exec="base"><param name="wheel_base" value="0.2"/></node>', known=(known,)
    )
    assert ("did you mean 'wheel_bases'?" in message) == named


@pytest.mark.parametrize(("known", "found"), [(BASE, 1), (OPEN, 0)], ids=["all is known", "it may have more"])
def test_in_a_closed_system_it_counts_as_one_of_its_nodes(told, known: ExternalNode, found: int):
    both = "self.create_publisher(Twist, 'cmd_vel', 10)\nself.create_publisher(Twist, 'twist', 10)"
    findings = told(("TOP002",), both, known=(known,), closed=True)
    assert len(findings) == found
    assert all("'/twist'" in message for _, _, message in findings)


def test_a_name_that_is_almost_its_own(told):
    line = "self.create_publisher(Twist, 'cmd_vell', 10)"
    [(_, file, message)] = told(("TOP004",), line)
    assert file == "robot/talker.py"
    assert "did you mean '/cmd_vel'?" in message
    assert told(("TOP004",), line, known=(OPEN,)) == [], "somebody else may have both names"


BESIDE = """\
#include "acme/driver.hpp"
#include "rclcpp/rclcpp.hpp"
class Follower : public rclcpp::Node {
public:
  Follower() : Node("follower") { declare_parameter("speed", 0.2); }
};
int main(int argc, char ** argv) {
  rclcpp::init(argc, argv);
  rclcpp::executors::MultiThreadedExecutor executor;
  auto follower = std::make_shared<Follower>();
  executor.add_node(follower);
  %s
  executor.spin();
}
"""


@pytest.mark.parametrize(
    ("more", "found"), [("", 1), ("executor.add_node(std::make_shared<acme::Driver>());", 0)], ids=["alone", "beside"]
)
def test_a_value_may_be_for_a_node_from_elsewhere_in_the_same_process(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, more: str, found: int
):
    monkeypatch.chdir(tmp_path)
    line = '<node pkg="robot" exec="follower"><param name="counters" value="true"/></node>'
    build = "add_executable(follower src/follower.cpp)\ninstall(TARGETS follower DESTINATION lib/${PROJECT_NAME})\n"
    files = {"src/follower.cpp": BESIDE % more, "CMakeLists.txt": f"project(robot)\n{build}"}
    write_robot(tmp_path, line, **files, **{"package.xml": manifest(build_type="ament_cmake")})
    report = check(Request((".",), Settings(), cached=False, jobs=1))
    assert len([finding for finding in report.findings if finding.code == "PRM004"]) == found


def test_a_second_node_that_a_parameter_makes_is_no_namesake(told):
    named = '<node pkg="acme" exec="base" name="driver"/>'
    log = replace(BASE, name="log")
    [(_, _, message)] = told(("NME004",), more=named, known=(BASE, log))
    assert "several have the name '/driver'" in message
    assert told(("NME004",), more=named, known=(BASE, replace(log, conditional=True))) == []

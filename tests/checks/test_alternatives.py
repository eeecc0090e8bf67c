"""OWN001 and launch files: who publishes one topic but is never started together."""

from __future__ import annotations

from pathlib import Path
from textwrap import dedent

import pytest

from archlint.config.settings import Settings
from archlint.engine.pipeline import Request, check
from archlint.finding import Severity
from checks.judging import Judge

LAUNCH = """
    from launch import LaunchDescription
    from launch_ros.actions import Node


    def generate_launch_description():
        return LaunchDescription([{nodes}])
"""


@pytest.mark.parametrize(
    ("launch_files", "judged"),
    [([], False), (["left"], False), (["left right"], True), (["left", "right"], False)],
)
def test_nodes_that_only_different_launch_files_start_are_alternatives(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, launch_files: list[str], judged: bool
):
    monkeypatch.chdir(tmp_path)
    write_package(tmp_path, launch_files)
    report = check(Request((".",), Settings(), cached=False, jobs=1))
    assert ("OWN001" in {finding.code for finding in report.findings}) is judged


def write_package(folder: Path, launch_files: list[str]) -> None:
    (folder / "drive").mkdir()
    (folder / "launch").mkdir()
    (folder / "drive" / "__init__.py").touch()
    (folder / "package.xml").write_text(
        '<package format="3"><name>drive</name><version>0.1.0</version><description>d</description>'
        "<maintainer email='a@b.org'>A</maintainer><license>MIT</license>"
        "<export><build_type>ament_python</build_type></export></package>"
    )
    (folder / "setup.py").write_text(
        "from setuptools import setup\nsetup(name='drive', packages=['drive'], entry_points={'console_scripts': ["
        "'left = drive.left:main', 'right = drive.right:main']})\n"
    )
    for name in ("left", "right"):
        (folder / "drive" / f"{name}.py").write_text(
            "import rclpy\nfrom rclpy.node import Node\nfrom std_msgs.msg import String\n\n\n"
            f"class {name.title()}(Node):\n    def __init__(self):\n        super().__init__('{name}')\n"
            "        self.create_publisher(String, 'said', 10)\n\n\n"
            f"def main():\n    rclpy.init()\n    rclpy.spin({name.title()}())\n"
        )
    for names in launch_files:
        nodes = ", ".join(f"Node(package='drive', executable='{name}')" for name in names.split())
        (folder / "launch" / f"{names.replace(' ', '_')}.launch.py").write_text(
            dedent(LAUNCH).format(nodes=nodes).lstrip()
        )


TALKS = "self.create_publisher(String, 'said', QoSProfile(depth=1, reliability=ReliabilityPolicy.BEST_EFFORT))"
HEARS = "self.create_subscription(String, 'said', print, 10)"
ALSO = "; self.create_publisher(String, 'done', 10)"
TOGETHER = ", if they run together: no launch file here starts both by default"


@pytest.mark.parametrize(
    ("launch_files", "also", "told"),
    [
        (["left right"], ALSO, [(Severity.ERROR, False)]),
        (["left", "right"], "", []),  # each in a launch file of its own
        (["left"], "", [(Severity.WARNING, True)]),
        (["left"], ALSO, []),  # both publish 'done': the one does the other's work
        ([], "", [(Severity.ERROR, False)]),  # everything is started by hand
    ],
)
def test_a_mismatch_of_nodes_that_perhaps_never_run_together(
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    launch_files: list[str],
    also: str,
    told: list[tuple[Severity, bool]],
):
    monkeypatch.chdir(tmp_path)
    write_package(tmp_path, launch_files)
    for name, creates in (("left", TALKS), ("right", HEARS)):
        file = tmp_path / "drive" / f"{name}.py"
        text = file.read_text().replace("self.create_publisher(String, 'said', 10)", creates + also)
        file.write_text("from rclpy.qos import QoSProfile, ReliabilityPolicy\n" + text)
    report = check(Request((".",), Settings(), cached=False, jobs=1))
    found = [one for one in report.findings if one.code == "QOS001"]
    assert [(one.severity, one.message.endswith(TOGETHER)) for one in found] == told
    assert all((one.place.file, one.place.line) == ("drive/right.py", 10) for one in found)


@pytest.mark.parametrize(("depth", "told"), [("10", []), (TALKS.partition("'said', ")[2][:-1], ["QOS001"])])
def test_a_subscription_that_was_made_for_another_publisher(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, depth: str, told: list[str]
):
    """The one that nothing starts is no partner of it, unless it has no other."""
    monkeypatch.chdir(tmp_path)
    write_package(tmp_path, ["right"])
    setup = tmp_path / "setup.py"
    setup.write_text(setup.read_text().replace("'left = ", "'front = drive.front:main', 'left = "))
    front = (tmp_path / "drive" / "left.py").read_text().replace("left", "front").replace("Left", "Front")
    (tmp_path / "drive" / "front.py").write_text(front)
    for name, creates in (
        ("left", TALKS),
        ("right", HEARS),
        ("front", f"self.create_publisher(String, 'said', {depth})"),
    ):
        file = tmp_path / "drive" / f"{name}.py"
        text = file.read_text().replace("self.create_publisher(String, 'said', 10)", creates)
        file.write_text("from rclpy.qos import QoSProfile, ReliabilityPolicy\n" + text)
    found = check(Request((".",), Settings(), cached=False, jobs=1)).findings
    assert [one.code for one in found if one.code.startswith("QOS")] == told


BENCH = """
    import subprocess

    import rclpy
    from std_msgs.msg import {type}


    def measure():
        {start}
        rclpy.init()
        node = rclpy.create_node('bench')
        node.create_{end}
        rclpy.spin(node)


    if __name__ == '__main__':
        measure()
"""
PARTNER = """
    import rclpy
    from rclpy.qos import DurabilityPolicy, QoSProfile
    from std_msgs.msg import String


    def main():
        rclpy.init()
        node = rclpy.create_node('partner')
        latched = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        node.create_subscription(String, 'state', print, latched){mark}
        rclpy.spin(node)


    if __name__ == '__main__':
        main()
"""


def test_a_script_that_starts_its_own_system_is_no_partner(judge: Judge):
    bench = BENCH.replace("{type}", "String").replace("{end}", "publisher(String, 'state', 1)")

    judge("QOS002", bench.replace("{start}", "print()"), PARTNER.replace("{mark}", "  # here"))
    judge("QOS002", bench.replace("{start}", "subprocess.Popen(['planner'])"), PARTNER.replace("{mark}", ""))


def test_two_publishers_that_nothing_starts_together_may_differ_in_type(judge: Judge):
    other = PARTNER.replace("subscription(String, 'state', print, latched)", "publisher(String, 'state', 1)")
    bench = BENCH.replace("{start}", "print()").replace("{type}", "Bool")

    judge("TOP001", bench.replace("{end}", "publisher(Bool, 'state', 1)"), other.replace("{mark}", ""))
    subscribed = bench.replace("{end}", "subscription(Bool, 'state', print, 1)")
    judge("TOP001", subscribed, other.replace("{mark}", "  # here"))

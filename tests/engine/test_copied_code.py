"""One finding for a function that a package has once for each of several robots, with other numbers in it."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from archlint.config.settings import Settings
from archlint.engine.pipeline import Request, check
from archlint.finding import Finding

MANIFEST = """<package format="3"><name>{name}</name><version>0.0.1</version><description>d</description>
<maintainer email="a@b.org">a</maintainer><license>MIT</license><exec_depend>rclpy</exec_depend>
<exec_depend>std_msgs</exec_depend><export><build_type>ament_python</build_type></export></package>
"""
TRUCK = """import time

import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Truck(Node):
    ID = 11

    def __init__(self):
        super().__init__('truck_11')
        self.create_subscription(String, 'site_11', self.arrive, 10)
        self.create_subscription(String, 'stop', self.stop, 10)

    def stop(self, message):
        self.get_logger().info(message.data)

    def arrive(self, message):
        if message.data == 'truck_11':
            time.sleep(3)


def main():
    rclpy.init()
    rclpy.spin(Truck())


if __name__ == '__main__':
    main()
"""
AGAIN = "the same in a copy of this code"


@pytest.fixture(autouse=True)
def workspace(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    write("trucks/package.xml", MANIFEST.format(name="trucks"))


def write(path: str, text: str) -> None:
    file = Path(path)
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(text, encoding="utf-8")


def sleeps(paths: tuple[str, ...] = (".",), jobs: int = 1, **settings: bool) -> list[Finding]:
    request = Request(paths, replace(Settings(), **settings), cached=False, jobs=jobs)
    return [finding for finding in check(request).findings if finding.code == "EXE003"]


def shown(**settings: bool) -> list[tuple[str, int, list[str]]]:
    """File and line of each finding, and the files that have the same."""
    rows = []
    for finding in sleeps(**settings):
        again = [row.place.file for row in finding.related if row.message == AGAIN]
        rows.append((finding.place.file, finding.place.line, again))
    return rows


def test_copies_that_differ_in_numbers_are_one_finding():
    write("trucks/trucks/truck_11.py", TRUCK)
    write("trucks/trucks/truck_12.py", TRUCK.replace("11", "12"))
    write("trucks/trucks/truck_13.py", "# has a word more\n" + TRUCK.replace("11", "13").replace("(3)", "(4.5)"))
    others = ["trucks/trucks/truck_12.py", "trucks/trucks/truck_13.py"]
    assert shown() == [("trucks/trucks/truck_11.py", 21, others)]
    [finding] = sleeps()
    assert finding.message.endswith("; 2 more files have the same")
    assert [row.place.line for row in finding.related if row.message == AGAIN] == [21, 22]
    assert sleeps(jobs=3) == [finding]


LAUNCH = """from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch_ros.actions import Node


def generate_launch_description():
    site = DeclareLaunchArgument('site', default_value='11')
    return LaunchDescription([site, Node(package='turtlesim', executable='turtlesim_node')])
"""


def unread_arguments() -> list[Finding]:
    report = check(Request((".",), Settings(), cached=False, jobs=1))
    return [finding for finding in report.findings if finding.code == "LCH011"]


def test_a_copy_outside_of_all_packages_is_told_with_the_original():
    write("trucks/launch/truck.launch.py", LAUNCH)
    write("bench/my_truck.launch.py", "# as it was\n" + LAUNCH)
    [finding] = unread_arguments()
    assert finding.place.file == "trucks/launch/truck.launch.py"
    copies = [(row.place.file, row.place.line) for row in finding.related if row.message == AGAIN]
    assert copies == [("bench/my_truck.launch.py", 8)]
    write("bench/my_truck.launch.py", LAUNCH.replace("[", "[ "))
    assert [row.place.file for row in unread_arguments()] == [
        "bench/my_truck.launch.py",
        "trucks/launch/truck.launch.py",
    ]


def test_another_function_of_the_file_may_be_another():
    write("trucks/trucks/truck_11.py", TRUCK)
    write("trucks/trucks/truck_12.py", TRUCK.replace("11", "12").replace("info(message.data)", "warn('stop')"))
    assert shown() == [("trucks/trucks/truck_11.py", 21, ["trucks/trucks/truck_12.py"])]


@pytest.mark.parametrize(("lines", "copies"), [(45, [["trucks/trucks/truck_12.py"]]), (5, [[], []])])
def test_a_long_copy_may_differ_further_down(lines: int, copies: list[list[str]]):
    """What somebody has changed below the line says nothing of it; a short beginning may be alike by chance."""
    long = "".join(f"        self.seen_{number} = message.data\n" for number in range(lines))
    text = TRUCK.replace("        if message.data ==", long + "        if message.data ==")
    write("trucks/trucks/truck_11.py", text)
    below = "time.sleep(6)\n        self.get_logger().warn('over')\n"
    write("trucks/trucks/truck_12.py", text.replace("time.sleep(3)\n", below))
    assert [row[2] for row in shown()] == copies


@pytest.mark.parametrize(
    ("path", "change"),
    [
        ("trucks/trucks/truck_12.py", ("if message.data ==", "if self.ID and message.data ==")),
        ("excavators/excavators/digger_12.py", ("11", "12")),
    ],
    ids=["other code", "another package"],
)
def test_what_is_no_copy_is_told(path: str, change: tuple[str, str]):
    write("excavators/package.xml", MANIFEST.format(name="excavators"))
    write("trucks/trucks/truck_11.py", TRUCK)
    write(path, TRUCK.replace(*change))
    assert sorted(shown()) == sorted([("trucks/trucks/truck_11.py", 21, []), (path, 21, [])])


def test_scripts_without_a_package_stay_apart():
    Path("trucks/package.xml").unlink()
    write("scripts/truck_11.py", TRUCK)
    write("scripts/truck_12.py", TRUCK.replace("11", "12"))
    assert shown() == [("scripts/truck_11.py", 21, []), ("scripts/truck_12.py", 21, [])]


def test_who_wants_all_files_sees_each_copy():
    write("trucks/trucks/truck_11.py", TRUCK)
    write("trucks/trucks/truck_12.py", TRUCK.replace("11", "12"))
    each = [("trucks/trucks/truck_11.py", 21, []), ("trucks/trucks/truck_12.py", 21, [])]
    assert shown(unused_files=True) == each


def test_a_copy_is_suppressed_by_itself():
    ignored = "time.sleep(3)  # archlint: ignore[EXE003] it only unloads then"
    write("trucks/trucks/truck_11.py", TRUCK.replace("time.sleep(3)", ignored))
    write("trucks/trucks/truck_12.py", TRUCK.replace("11", "12"))
    write("trucks/trucks/truck_13.py", TRUCK.replace("11", "13"))
    assert shown() == [("trucks/trucks/truck_12.py", 21, ["trucks/trucks/truck_13.py"])]


ASKS = """import rclpy
from rclpy.node import Node
from std_srvs.srv import Trigger


class Asks(Node):
    def __init__(self):
        super().__init__('asks_11')
        client = self.create_client(Trigger, 'go_11')
        client.wait_for_service()
        self.create_timer(1.0, lambda: client.call_async(Trigger.Request()))


def main():
    rclpy.init()
    rclpy.spin(Asks())


if __name__ == '__main__':
    main()
"""


def test_a_fix_mends_each_copy():
    write("trucks/trucks/asks_11.py", ASKS)
    write("trucks/trucks/asks_12.py", ASKS.replace("11", "12"))
    report = check(Request((".",), Settings(), cached=False, jobs=1))
    [finding] = [finding for finding in report.findings if finding.code == "TMO001"]
    assert finding.fix is not None
    edited = {edit.place.file for edit in finding.fix.edits}
    assert edited == {"trucks/trucks/asks_11.py", "trucks/trucks/asks_12.py"}


def test_what_cannot_be_read_is_no_copy():
    for name in ("left", "right"):
        file = Path(f"trucks/trucks/{name}.py")
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_bytes(b"import rclpy\nname = '\xff'\n")
    found = check(Request((".",), Settings(), cached=False, jobs=1)).findings
    unread = [finding.place.file for finding in found if finding.code == "LNT002"]
    assert unread == ["trucks/trucks/left.py", "trucks/trucks/right.py"]

"""Findings in files that nothing runs: what a run says of them, and how to see them."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from archlint.cli import main

MANIFEST = """<package format="3"><name>robot</name><version>0.0.1</version><description>d</description>
<maintainer email="a@b.org">a</maintainer><license>MIT</license><exec_depend>rclpy</exec_depend>
<exec_depend>std_msgs</exec_depend><export><build_type>ament_python</build_type></export></package>
"""
SETUP = """
from setuptools import setup

setup(name='robot', packages=['robot'], entry_points={'console_scripts': ['driver = robot.driver:main']})
"""
DRIVER = """
import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Driver(Node):
    def __init__(self):
        super().__init__('driver')
        self.words = self.create_publisher(String, 'state', 10)


def main():
    rclpy.init()
    rclpy.spin(Driver())
"""
PROBE = """
import rclpy


def main():
    rclpy.init()
    rclpy.create_node('probe').get_logger().info(missing)


main()
"""
LISTENER = """
import rclpy
from rclpy.node import Node
from std_msgs.msg import Int32


class Listener(Node):
    def __init__(self):
        super().__init__('listener')
        self.create_subscription(Int32, 'state', print, 10)


rclpy.init()
rclpy.spin(Listener())
"""


@pytest.fixture(autouse=True)
def workspace(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A package with a program, and a script that it does not install."""
    monkeypatch.chdir(tmp_path)
    write("robot/package.xml", MANIFEST)
    write("robot/setup.py", SETUP)
    write("robot/setup.cfg", "[develop]\nscript_dir=$base/lib/robot\n[install]\ninstall_scripts=$base/lib/robot\n")
    write("robot/robot/__init__.py")
    write("robot/robot/driver.py", DRIVER)
    write("robot/tools/probe.py", PROBE)


def write(path: str, text: str = "") -> None:
    file = Path(path)
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(text, encoding="utf-8")


def checked(capsys: pytest.CaptureFixture[str], *arguments: str, cached: bool = False) -> tuple[dict[str, Any], str]:
    """The JSON of a check, and what it says beside it."""
    assert main(["check", *([] if cached else ["--no-cache"]), "--format", "json", "-o", "it.json", *arguments]) in (
        0,
        1,
    )
    return json.loads(Path("it.json").read_text(encoding="utf-8")), capsys.readouterr().err


def files_of(document: dict[str, Any]) -> list[str]:
    return [row["file"] for row in document["diagnostics"]]


def test_they_are_counted_and_not_shown(capsys: pytest.CaptureFixture[str]) -> None:
    document, said = checked(capsys)
    assert files_of(document) == []
    assert (document["summary"]["unused"], document["summary"]["unused_files"]) == (1, 1)
    assert "1 finding in 1 file that nothing runs is not shown; --all-files shows it." in said


@pytest.mark.parametrize("wanted", [("--all-files",), ("robot/tools/probe.py",)], ids=["all files", "by its name"])
def test_they_are_shown_to_who_asks(capsys: pytest.CaptureFixture[str], wanted: tuple[str, ...]) -> None:
    document, said = checked(capsys, *wanted)
    assert files_of(document) == ["robot/tools/probe.py"]
    assert (document["summary"]["unused"], document["summary"]["unused_files"]) == (0, 0)
    assert "nothing runs" not in said


def test_the_configuration_may_ask_for_them(capsys: pytest.CaptureFixture[str]) -> None:
    write("archlint.toml", "unused-files = true\n")
    assert files_of(checked(capsys)[0]) == ["robot/tools/probe.py"]


def test_a_kept_result_is_that_of_what_was_asked(capsys: pytest.CaptureFixture[str]) -> None:
    few, many = checked(capsys, cached=True)[0], checked(capsys, "--all-files", cached=True)[0]
    assert (files_of(few), files_of(many)) == ([], ["robot/tools/probe.py"])
    assert files_of(checked(capsys, cached=True)[0]) == []


BY_HAND = PROBE.replace("main()\n\n\n", "").replace("\n\nmain()\n", "\n\nif __name__ == '__main__':\n    main()\n")


@pytest.mark.parametrize("path", ["robot/tools/probe.py", "robot/robot/probe.py"], ids=["beside", "among the modules"])
def test_what_fails_in_a_script_that_its_author_may_start_is_not_shown_either(
    capsys: pytest.CaptureFixture[str], path: str
) -> None:
    Path("robot/tools/probe.py").unlink()
    write(path, BY_HAND)
    document, _ = checked(capsys)
    assert (files_of(document), document["summary"]["unused"]) == ([], 1)
    document, _ = checked(capsys, "--all-files")
    assert [(row["file"], row["severity"]) for row in document["diagnostics"]] == [(path, "info")]


def test_several_are_counted_with_their_files(capsys: pytest.CaptureFixture[str]) -> None:
    write("robot/tools/other.py", PROBE.replace("missing", "absent") + "lost\n")
    document, said = checked(capsys)
    assert (document["summary"]["unused"], document["summary"]["unused_files"]) == (3, 2)
    assert "3 findings in 2 files that nothing runs are not shown; --all-files shows them." in said


def test_a_baseline_holds_them_whether_they_are_shown_or_not(capsys: pytest.CaptureFixture[str]) -> None:
    checked(capsys, "--all-files", "--baseline", "known.txt", "--write-baseline")
    document, _ = checked(capsys, "--baseline", "known.txt")
    assert files_of(document) == []
    assert (document["summary"]["baselined"], document["summary"]["unused"]) == (1, 0)


def test_a_suppression_there_is_not_unused(capsys: pytest.CaptureFixture[str]) -> None:
    write("robot/tools/probe.py", PROBE.replace("info(missing)", "info(missing)  # archlint: ignore[API005] later"))
    document, _ = checked(capsys)
    assert (files_of(document), document["summary"]["suppressed"]) == ([], 1)


def test_a_node_that_the_package_leaves_out_is_no_partner_of_what_runs(capsys: pytest.CaptureFixture[str]) -> None:
    write("robot/tools/probe.py", LISTENER)
    document, _ = checked(capsys, "--select", "TOP001")
    assert files_of(document) == []


def test_what_is_put_aside_is_no_partner_of_what_runs(capsys: pytest.CaptureFixture[str]) -> None:
    Path("robot/tools/probe.py").unlink()
    write("robot/old/driver.py", LISTENER)
    document, _ = checked(capsys, "--select", "TOP001")
    assert files_of(document) == []


SPEAKER = """
#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/{type}.hpp"

class {name} : public rclcpp::Node
{{
public:
  {name}() : Node("{name}")
  {{
    words_ = create_{kind}<std_msgs::msg::{type}>("words", 10{last});
  }}
}};

int main(int argc, char ** argv)
{{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<{name}>());
}}
"""


@pytest.mark.parametrize(("built", "told"), [("src/say.cpp", []), ("src/say.cpp src/hear.cpp", ["cpp/src/say.cpp"])])
def test_a_source_that_nothing_compiles_meets_nobody(
    capsys: pytest.CaptureFixture[str], built: str, told: list[str]
) -> None:
    write("cpp/package.xml", MANIFEST.replace("robot", "cpp").replace("ament_python", "ament_cmake"))
    lines = [
        f"add_executable(n{at} {file})\ninstall(TARGETS n{at} DESTINATION lib/cpp)\n"
        for at, file in enumerate(built.split())
    ]
    write("cpp/CMakeLists.txt", f"project(cpp)\n{''.join(lines)}")
    write("cpp/src/say.cpp", SPEAKER.format(name="Say", kind="publisher", type="String", last=""))
    write("cpp/src/hear.cpp", SPEAKER.format(name="Hear", kind="subscription", type="Int32", last=", on_word"))
    document, _ = checked(capsys, "--select", "TOP001")
    assert files_of(document) == told


def test_why_nothing_runs_a_file_is_told(capsys: pytest.CaptureFixture[str]) -> None:
    write("robot/setup.py", SETUP.replace("robot.driver:main", "robot.drivers:main"))
    assert [row["code"] for row in checked(capsys)[0]["diagnostics"]] == ["PKG002"]


DRAFT = "import rclpy\nfrom std_msgs\n"


@pytest.mark.parametrize(
    ("draft", "beside"),
    [
        ("notes/pick and place version 1.py", "notes/pick and place version 2.py"),
        ("notes/Pick_V1.py", "notes/Pick_V3.py"),
        ("pick-v09.py", "pick-v10.py"),
    ],
)
def test_an_earlier_version_that_no_longer_parses_is_not_shown(
    capsys: pytest.CaptureFixture[str], draft: str, beside: str
) -> None:
    write(draft, DRAFT)
    write(beside, DRIVER)
    assert draft not in files_of(checked(capsys)[0])
    assert draft in files_of(checked(capsys, draft)[0])


@pytest.mark.parametrize(
    ("draft", "beside", "text"),
    [
        ("notes/pick_v2.py", "notes/pick_v1.py", DRIVER),
        ("notes/pick_v1.py", "notes/place_v2.py", DRIVER),
        ("notes/pick_v1.py", "notes/later/pick_v2.py", DRIVER),
        ("notes/pick_v1.py", "notes/pick_v2.py", DRIVER + "\n\nimport pick_v1\n"),
        ("notes/pick_v1.py", "README.md", "Start it: `python3 notes/pick_v1.py`\n"),
        ("notes/arm1.py", "notes/arm2.py", DRIVER),
    ],
    ids=["the last one", "another thing", "elsewhere", "imported", "told to run", "two arms"],
)
def test_a_version_that_is_in_use_is_shown(
    capsys: pytest.CaptureFixture[str], draft: str, beside: str, text: str
) -> None:
    write(draft, DRAFT)
    write(beside, text)
    assert draft in files_of(checked(capsys)[0])


BROKEN_PACKAGE = {
    "package.xml": MANIFEST.replace("<name>robot<", "<name>arm<").replace("rclpy<", "rospy<"),
    "setup.py": SETUP.replace("robot", "arm").replace("arm.driver", "arm.gone"),
    "arm/__init__.py": "",
}


@pytest.mark.parametrize(
    ("folder", "others", "codes"),
    [
        ("arm (no usado)", {}, []),
        ("unused/arm", {}, []),
        ("arm", {}, ["PKG002", "PKG008"]),
        ("unused/arm", {"robot/robot/lifts.py": "import arm.lift\n"}, ["PKG002"]),
        ("unused/arm", {"README.md": "    ros2 run arm lift\n"}, ["PKG002"]),
        ("unused/arm", {"robot/launch/up.launch.xml": '<launch><node pkg="arm" exec="x"/></launch>'}, ["PKG002"]),
    ],
    ids=["in brackets", "a folder", "in use", "imported", "a document starts it", "a launch file starts it"],
)
def test_a_package_that_is_put_aside_as_a_whole(
    capsys: pytest.CaptureFixture[str], folder: str, others: dict[str, str], codes: list[str]
) -> None:
    for path, text in {**{f"{folder}/{name}": text for name, text in BROKEN_PACKAGE.items()}, **others}.items():
        write(path, text)
    document, _ = checked(capsys, "--select", "PKG001,PKG002,PKG008")
    own = (row for row in document["diagnostics"] if row["file"].startswith(f"{folder}/"))
    assert sorted({row["code"] for row in own}) == codes


WAITS = """
import rclpy
from std_srvs.srv import Trigger


def main():
    rclpy.init()
    node = rclpy.create_node('asker')
    client = node.create_client(Trigger, 'start')
    client.wait_for_service()
    node.get_logger().info(missing)


if __name__ == '__main__':
    main()
"""


@pytest.mark.parametrize(
    ("path", "wanted", "shown", "hidden"),
    [
        ("tools/ask.py", (), ["API005"], 2),
        ("tools/ask.py", ("--all-files",), ["TMO001", "API005"], 0),
        ("tools/ask.py", ("tools/ask.py",), ["TMO001", "API005"], 0),
        ("robot/robot/driver.py", (), ["TMO001", "API005"], 1),
    ],
    ids=["no program has it", "all files", "by its name", "a program"],
)
def test_who_starts_a_script_by_hand_sees_that_it_waits(
    capsys: pytest.CaptureFixture[str], path: str, wanted: tuple[str, ...], shown: list[str], hidden: int
) -> None:
    write(path, WAITS)
    document, _ = checked(capsys, "--select", "TMO001,API005", *wanted)
    assert [row["code"] for row in document["diagnostics"] if row["file"] == path] == shown
    assert document["summary"]["unused"] == hidden  # with the one of robot/tools/probe.py

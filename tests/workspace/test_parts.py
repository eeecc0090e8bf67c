"""Packages of one name are in different workspaces, and each workspace is judged by itself."""

from __future__ import annotations

from pathlib import Path

from archlint.config.settings import load
from archlint.engine.pipeline import Request, check, graph
from archlint.workspace.parts import parts
from workspace.trees import look, manifest, plant

CMAKE = "find_package(rosidl_default_generators)\nrosidl_generate_interfaces(${{PROJECT_NAME}} {})\n"


def found(folder: Path) -> list[tuple[set[str], set[str]]]:
    """Of each part the folders of its packages: those asked for and those that are context."""
    return [
        (
            {file.relative.rpartition("/")[0] for file in part.of_kind("package_xml") if not file.context},
            {file.relative.rpartition("/")[0] for file in part.of_kind("package_xml") if file.context},
        )
        for part in parts(look(folder))
    ]


def packages(folder: Path, *paths: str) -> Path:
    return plant(folder, {f"{path}/package.xml": manifest(path.rpartition("/")[2]) for path in paths})


def test_a_workspace_is_one(tmp_path):
    packages(tmp_path, "src/a", "src/group/b")
    assert found(tmp_path) == [({"src/a", "src/group/b"}, set())]


def test_the_weeks_of_a_course_are_several(tmp_path):
    packages(tmp_path, "week1/src/robot", "week1/src/tools", "week2/src/robot", "week2/src/tools")
    assert found(tmp_path) == [
        ({"week1/src/robot", "week1/src/tools"}, set()),
        ({"week2/src/robot", "week2/src/tools"}, set()),
    ]


def test_what_the_weeks_share_is_known_in_each_and_told_once(tmp_path):
    packages(tmp_path, "common/interfaces", "week1/robot", "week2/robot")
    assert found(tmp_path) == [
        ({"common/interfaces", "week1/robot"}, set()),
        ({"week2/robot"}, {"common/interfaces"}),
    ]


def test_an_old_copy_beside_the_packages_stands_apart(tmp_path):
    packages(tmp_path, "src/drive", "src/sense", "src/old/drive")
    assert found(tmp_path) == [({"src/drive", "src/sense"}, set()), ({"src/old/drive"}, set())]


def test_loose_files_belong_to_the_nearest_part(tmp_path):
    packages(tmp_path, "week1/robot", "week2/robot")
    plant(tmp_path, {"week2/try.py": "", "try.py": ""})
    first, second = parts(look(tmp_path))
    assert [file.relative for file in second.of_kind("python")] == ["week2/try.py"]
    assert [file.relative for file in first.of_kind("python")] == ["try.py"]


def test_an_interface_is_looked_for_in_the_package_of_its_own_workspace(tmp_path, monkeypatch):
    """A second workspace, say for a bridge, has a package of the same name with fewer messages."""
    monkeypatch.chdir(tmp_path)
    plant(
        tmp_path,
        {
            "main/src/rover_msgs/package.xml": manifest("rover_msgs", "ament_cmake"),
            "main/src/rover_msgs/CMakeLists.txt": CMAKE.format('"msg/A.msg" "msg/B.msg"'),
            "main/src/rover_msgs/msg/A.msg": "int32 a\n",
            "main/src/rover_msgs/msg/B.msg": "int32 b\n",
            "main/src/p/package.xml": manifest("p", more="<depend>rclpy</depend><depend>rover_msgs</depend>"),
            "main/src/p/p/__init__.py": "",
            "main/src/p/p/n.py": "import rclpy\nfrom rover_msgs.msg import A, C\n",
            "zbridge/src/rover_msgs/package.xml": manifest("rover_msgs", "ament_cmake"),
            "zbridge/src/rover_msgs/CMakeLists.txt": CMAKE.format('"msg/B.msg"'),
            "zbridge/src/rover_msgs/msg/B.msg": "int32 b\n",
        },
    )
    report = check(Request((".",), load(tmp_path), cached=False, jobs=1))
    assert [(one.place.file, one.message.split(",")[0]) for one in report.findings if one.code == "MSG002"] == [
        ("main/src/p/p/n.py", "rover_msgs defines no message 'C'")
    ]


NODE = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import {type}


class Talker(Node):
    def __init__(self):
        super().__init__('{name}')
        self.create_publisher({type}, 'chatter', 10)


def main():
    rclpy.init()
    rclpy.spin(Talker())
"""


def test_nodes_of_different_workspaces_never_meet_but_are_all_drawn(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    for week, type_, name in (("week1", "String", "one"), ("week2", "Int32", "two")):
        plant(
            tmp_path,
            {
                f"{week}/robot/package.xml": manifest("robot", more="<depend>rclpy</depend><depend>std_msgs</depend>"),
                f"{week}/robot/robot/__init__.py": "",
                f"{week}/robot/robot/node.py": NODE.format(type=type_, name=name),
            },
        )
    request = Request((".",), load(tmp_path), cached=False, jobs=1)
    report = check(request)
    assert not any(one.code in ("TOP001", "OWN001") for one in report.findings)
    assert (report.summary.files, report.summary.nodes) == (4, 2)
    assert [node.name for node in graph(request).nodes] == ["/one", "/two"]

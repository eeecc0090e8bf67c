"""Modules that are symbolic links: Python imports them under the name of the link."""

from __future__ import annotations

from pathlib import Path

import pytest

from archlint.config.settings import Settings
from archlint.engine.pipeline import Request, check

MANIFEST = "<package format='3'><name>{}</name><export><build_type>ament_python</build_type></export></package>"
NODE = """
import rclpy
from rclpy.node import Node
from std_msgs.msg import String
{imports}

class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.create_publisher(String, TOPIC, 10)

def main():
    rclpy.init()
    rclpy.spin(Talker())
"""
BAD, GOOD = "TOPIC = 'bad-name'\n", "TOPIC = 'good_name'\n"


def package(name: str, imports: str) -> dict[str, str]:
    points = f"entry_points={{'console_scripts': ['t = {name}.n:main']}}"
    return {
        f"{name}/package.xml": MANIFEST.format(name),
        f"{name}/setup.py": f"from setuptools import setup\nsetup(name='{name}', {points})",
        f"{name}/{name}/__init__.py": "",
        f"{name}/{name}/n.py": NODE.format(imports=imports),
    }


def write(folder: Path, texts: dict[str, str]) -> None:
    for name, text in texts.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")


def bad_names(cached: bool = False) -> int:
    """How often rcl would refuse a name: it stands in the linked file alone."""
    found = check(Request((".",), Settings(), cached=cached, jobs=1)).findings
    return sum(one.code == "NME002" for one in found)


@pytest.mark.parametrize("imports", ["from .shared import TOPIC", "from robot.shared import TOPIC"])
def test_a_link_to_a_file_of_the_workspace_is_a_module(tmp_path, monkeypatch, imports: str):
    monkeypatch.chdir(tmp_path)
    write(tmp_path, {**package("robot", imports), "lib/shared.py": BAD})
    assert bad_names() == 0  # nothing of the package is called so
    (tmp_path / "robot/robot/shared.py").symlink_to("../../lib/shared.py")
    assert bad_names() == 1


def test_another_package_imports_a_linked_module_by_its_name(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    files = {**package("robot", ""), **package("other", "from robot.shared import TOPIC")}
    write(tmp_path, {**files, "robot/robot/n.py": "", "lib/shared.py": BAD})
    (tmp_path / "robot/robot/shared.py").symlink_to("../../lib/shared.py")
    assert bad_names() == 1


def test_what_a_linked_module_imports_may_lie_beside_the_link(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    files = {**package("robot", "from .shared import TOPIC"), "robot/robot/names.py": BAD}
    write(tmp_path, {**files, "lib/shared.py": "from .names import TOPIC\n"})
    (tmp_path / "robot/robot/shared.py").symlink_to("../../lib/shared.py")
    assert bad_names() == 1


def test_a_link_that_is_turned_is_no_unchanged_workspace(tmp_path, monkeypatch):
    """Neither file has changed, and another one is imported."""
    monkeypatch.chdir(tmp_path)
    write(tmp_path, {**package("robot", "from .shared import TOPIC"), "lib/one.py": BAD, "lib/two.py": GOOD})
    link = tmp_path / "robot/robot/shared.py"
    counts = []
    for target in ("one", "two", "one"):
        link.unlink(missing_ok=True)
        link.symlink_to(f"../../lib/{target}.py")
        counts.append(bad_names(cached=True))
    assert counts == [1, 0, 1]

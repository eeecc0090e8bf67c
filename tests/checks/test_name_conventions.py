"""NME001 in a package where absolute names are the convention: one finding for all its classes."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from archlint.config.settings import load
from archlint.engine.known import Baseline, Entry, Older
from archlint.engine.pipeline import Request, check
from archlint.finding import Finding
from robot_package import write_robot

NODE = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class {class_name}(Node):
    def __init__(self):
        super().__init__('{node}')
{publishers}


def main():
    rclpy.init()
    rclpy.spin({class_name}())
"""
SETUP = """\
from setuptools import setup
setup(name='robot', entry_points={{'console_scripts': [{scripts}]}})
"""


def node(class_name: str, *names: str, comment: str = "") -> str:
    """A module with one class, which publishes under these names; a comment ends the line of each."""
    lines = (f"        self.create_publisher(String, '{name}', 10){comment}" for name in names)
    return NODE.format(class_name=class_name, node=class_name.lower(), publishers="\n".join(lines))


def request(folder: Path, launch: str = "", **nodes: str) -> Request:
    """A check of the package ``robot`` that consists of these modules, all of them installed."""
    scripts = ", ".join(f"'{name} = robot.{name}:main'" for name in nodes)
    files = {f"robot/{name}.py": text for name, text in nodes.items()}
    files |= {"setup.py": SETUP.format(scripts=scripts), "archlint.toml": 'select = ["NME001"]'}
    write_robot(folder, launch, **files)
    (folder / "robot" / "talker.py").unlink()
    return Request((".",), load(folder), cached=False, jobs=1)


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    return tmp_path


ARM = node("Arm", "/arm/state", "/arm/goal")
BASE = node("Base", "/base/state")
CAMERA = node("Camera", "/camera/image", "/camera/state")


def places(findings: list[Finding]) -> list[tuple[str, int]]:
    return [(finding.place.file, finding.place.line) for finding in findings]


def test_three_classes_with_nothing_else_are_one_finding(folder: Path):
    [finding] = check(request(folder, arm=ARM, base=BASE, camera=CAMERA)).findings

    assert finding.message == "package 'robot' fixes 5 absolute names in 3 classes: no namespace applies to any of them"
    assert places([finding]) == [("robot/arm.py", 9)]
    assert [(related.place.file, related.place.line, related.message) for related in finding.related] == [
        ("robot/base.py", 9, "Base fixes the topic '/base/state'"),
        ("robot/camera.py", 9, "Camera fixes the topic '/camera/image' and 1 more"),
    ]
    assert "`archlint check --fix --unsafe-fixes`" in finding.help
    assert '`ignore = ["NME001"]`' in finding.help


def test_its_fix_is_that_of_all_classes(folder: Path):
    [finding] = check(request(folder, arm=ARM, base=BASE, camera=CAMERA)).findings

    assert finding.fix is not None
    assert {edit.place.file for edit in finding.fix.edits} == {"robot/arm.py", "robot/base.py", "robot/camera.py"}


def test_one_name_that_all_classes_use(folder: Path):
    modules = {name.lower(): node(name, "/words") for name in ("Arm", "Base", "Camera")}
    [finding] = check(request(folder, **modules)).findings

    assert finding.message == (
        "package 'robot' fixes the absolute name '/words' in 3 classes: no namespace applies to it"
    )


def test_two_classes_are_one_finding_each(folder: Path):
    findings = check(request(folder, arm=ARM, base=BASE)).findings

    assert places(findings) == [("robot/arm.py", 9), ("robot/base.py", 9)]
    assert findings[0].message.startswith("2 names of Arm are absolute and fixed in the code")


def test_a_package_that_has_relative_names_too_has_no_convention(folder: Path):
    lidar = node("Lidar", "lidar/scan", "lidar/state")
    findings = check(request(folder, arm=ARM, base=BASE, camera=CAMERA, lidar=lidar)).findings

    assert places(findings) == [("robot/arm.py", 9), ("robot/base.py", 9), ("robot/camera.py", 9)]


def test_a_class_that_mixes_both_forms_is_told_alone(folder: Path):
    lidar = node("Lidar", "/lidar/scan", "lidar/state")
    whole, mixed = check(request(folder, arm=ARM, base=BASE, camera=CAMERA, lidar=lidar)).findings

    assert "5 absolute names in 3 classes" in whole.message
    assert places([mixed]) == [("robot/lidar.py", 9)]
    assert mixed.message.startswith("the topic '/lidar/scan' is absolute")


def test_a_class_whose_node_is_started_in_a_namespace_is_told_alone(folder: Path):
    launch = '<node pkg="robot" exec="lidar" namespace="left"/>'
    lidar = node("Lidar", "/lidar/scan")
    whole, launched = check(request(folder, launch, arm=ARM, base=BASE, camera=CAMERA, lidar=lidar)).findings

    assert "in 3 classes" in whole.message
    assert places([launched]) == [("robot/lidar.py", 9)]


def test_a_suppression_takes_its_class_out(folder: Path):
    quiet = node("Arm", "/arm/state", comment="  # archlint: ignore[NME001] one arm is all there is")
    report = check(request(folder, arm=quiet, base=BASE, camera=CAMERA, drive=node("Drive", "/drive")))

    [finding] = report.findings
    assert "fixes 4 absolute names in 3 classes" in finding.message
    assert places([finding]) == [("robot/base.py", 9)]
    assert report.summary.suppressed == 1


def test_a_baseline_holds_what_was_there_and_a_new_class_is_told(folder: Path):
    before = request(folder, arm=ARM, base=BASE, camera=CAMERA)
    keys = [occurrence.key for occurrence in check(replace(before, occurrences=True)).occurrences]
    known = Baseline("known.txt", tuple(Entry(number, key) for number, key in enumerate(keys, 1)))
    assert len(keys) == 5
    assert check(replace(before, baseline=known)).findings == []

    after = request(folder, arm=ARM, base=BASE, camera=CAMERA, drive=node("Drive", "/drive"))
    [finding] = check(replace(after, baseline=known)).findings
    assert finding.message.startswith("the topic '/drive' is absolute and fixed in the code")


def test_what_was_there_before_a_change_is_not_told_again(folder: Path):
    occurrences = check(replace(request(folder, arm=ARM, base=BASE, camera=CAMERA), occurrences=True)).occurrences
    older = tuple(Older(occurrence.key, occurrence.severity) for occurrence in occurrences)
    after = request(folder, arm=ARM, base=BASE, camera=CAMERA, drive=node("Drive", "/drive"))

    [finding] = check(replace(after, before=older)).findings
    assert places([finding]) == [("robot/drive.py", 9)]


def test_of_one_file_alone_only_its_class_is_told(folder: Path):
    whole = request(folder, arm=ARM, base=BASE, camera=CAMERA)
    [finding] = check(replace(whole, paths=("robot/camera.py",))).findings

    assert finding.message.startswith("2 names of Camera are absolute")

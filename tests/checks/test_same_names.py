"""PKG011: packages side by side that have one name."""

from __future__ import annotations

from pathlib import Path

import pytest

from archlint.config.settings import load
from archlint.engine.pipeline import Request, check
from archlint.finding import Finding
from robot_package import CMAKE, write_files

BUILD = "project(robot)\nfind_package(ament_cmake REQUIRED)\nament_package()\n"


def package(folder: str, name: str = "robot") -> dict[str, str]:
    manifest = CMAKE.replace("<name>robot</name>", f"<name>{name}</name>")
    return {f"{folder}/package.xml": manifest, f"{folder}/CMakeLists.txt": BUILD.replace("robot", name)}


@pytest.fixture
def found(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    """What is found of a workspace that has these files alone."""
    monkeypatch.chdir(tmp_path)

    def run(**files: str) -> list[Finding]:
        write_files(tmp_path, files | {"archlint.toml": 'select = ["PKG011"]\n'})
        return check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings

    return run


def test_a_package_that_was_copied_from_the_one_beside_it(found):
    (finding,) = found(**package("src/robot"), **package("src/fast_robot"))
    assert finding.place.file == "src/fast_robot/package.xml"
    assert finding.message == "colcon builds nothing here: the package beside it is called 'robot', too"
    assert finding.help == "write <name>fast_robot</name>, and that name where the package builds and looks for itself"
    assert [row.place.file for row in finding.related] == ["src/robot/package.xml"]


@pytest.mark.parametrize(
    ("first", "second"),
    [
        ("src/robot", "more/robot"),  # each may be for a workspace of its own
        ("lesson_1", "lesson_2"),  # one is to be copied to a workspace at a time
        ("src/robot", "src/robot/robot"),  # colcon looks for no package in a package
        ("src/robot", "src/robot_old"),
        ("src/robot", "src/robot (copy)"),
    ],
)
def test_packages_that_may_not_be_built_together(found, first, second):
    assert found(**package(first), **package(second)) == []


@pytest.mark.parametrize("passed_over", ["src/new", "src/robot"])
def test_what_colcon_passes_over(found, passed_over):
    files = package("src/robot") | package("src/new") | {f"{passed_over}/COLCON_IGNORE": ""}
    assert found(**files) == []

"""One finding for a line that was copied from file to file, and for what workspaces side by side have in common."""

from __future__ import annotations

from pathlib import Path

import pytest

from archlint.config.settings import load
from archlint.engine.pipeline import Request, check
from archlint.finding import Finding
from robot_package import SETUP_OF, manifest, write_files

LAUNCH = """from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    {first}
    return LaunchDescription([])
"""
MADE = "turtle = Node(package='turtlesim', executable='turtlesim_node')"


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    return tmp_path


def judged(folder: Path, code: str, files: dict[str, str], **request: object) -> list[Finding]:
    write_files(folder, {"archlint.toml": f'select = ["{code}"]\n', **files})
    return check(Request((".",), load(folder), cached=False, jobs=1, **request)).findings


def two_packages(arm: str, base: str) -> dict[str, str]:
    """Two packages with a launch file each, which begins with this line."""
    lines = {"arm": arm, "base": base}
    return {
        path: text
        for name, line in lines.items()
        for path, text in {
            f"{name}/package.xml": manifest(name),
            f"{name}/setup.py": SETUP_OF.format(name=name),
            f"{name}/launch/{name}.launch.py": LAUNCH.format(first=line),
        }.items()
    }


def test_a_line_that_was_copied_is_one_finding_at_the_first(folder: Path):
    (finding,) = judged(folder, "LCH008", two_packages(MADE, MADE))
    assert finding.place.file == "arm/launch/arm.launch.py"
    assert finding.message.endswith("; another file has the same")
    assert [(row.place.file, row.message) for row in finding.related] == [
        ("base/launch/base.launch.py", "the same here")
    ]


@pytest.mark.parametrize(
    "other",
    [
        "teleop = Node(package='turtlesim', executable='turtle_teleop_key')",  # the message names something else
        "turtle = Node(package='turtlesim', executable='turtlesim_node', name='two')",  # another line
    ],
)
def test_lines_that_differ_are_findings_of_their_own(folder: Path, other: str):
    findings = judged(folder, "LCH008", two_packages(MADE, other))
    assert [finding.place.file for finding in findings] == ["arm/launch/arm.launch.py", "base/launch/base.launch.py"]


def test_a_copy_that_is_suppressed_hides_no_other(folder: Path):
    ignored = f"{MADE}  # archlint: ignore[LCH008] a trial"
    (finding,) = judged(folder, "LCH008", two_packages(ignored, MADE))
    assert (finding.place.file, finding.related) == ("base/launch/base.launch.py", ())


ONE_OPTION = "[develop]\nscript-dir=$base/lib/{}\n"
"""Of an old template."""


def side_by_side(name: str, depend: str) -> dict[str, str]:
    """A package of a repository that holds another one of that name."""
    return {
        "package.xml": manifest(name, more=f"<depend>{depend}</depend>"),
        "setup.py": SETUP_OF.format(name=name),
        "setup.cfg": ONE_OPTION.format(name),
    }


@pytest.mark.parametrize(
    ("code", "ending"),
    [
        ("PKG008", "it is a build type; 2 more package.xml files have it, too"),
        ("PKG010", "2 more setup.cfg files have such options, too"),
    ],
)
def test_workspaces_side_by_side_have_one_finding_for_one_cause(folder: Path, code: str, ending: str):
    files = {
        f"{place}/{path}": text
        for place, name in {"simulated/base": "base", "real/base": "base", "real/arm": "arm"}.items()
        for path, text in side_by_side(name, "ament_python").items()
    }
    (finding,) = judged(folder, code, files)
    assert finding.message.endswith(ending)
    folders = {row.place.file.rpartition("/")[0] for row in (finding, *finding.related)}
    assert folders == {"simulated/base", "real/base", "real/arm"}

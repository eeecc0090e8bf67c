"""Which files that do not compile are reported: those that a run of the nodes would meet."""

from __future__ import annotations

from pathlib import Path

import pytest

from archlint.cli import main

NODE = """\
import rclpy
{imports}
rclpy.init()
rclpy.spin(rclpy.create_node('robot'))
"""
BROKEN = "def start(:\n"


@pytest.fixture
def robot(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A package ``robot`` with a package ``motors`` in it, which cannot be imported."""
    package = tmp_path / "robot"
    (package / "motors").mkdir(parents=True)
    (tmp_path / "package.xml").write_text("<package format='3'><name>robot</name><version>0.0.0</version></package>")
    (package / "__init__.py").write_text("")
    (package / "motors" / "__init__.py").write_text(BROKEN)
    (package / "motors" / "left.py").write_text("def turn():\n    pass\n")
    monkeypatch.chdir(tmp_path)
    return package


def broken(capsys: pytest.CaptureFixture[str]) -> list[str]:
    main(["check", "--format", "concise", "--no-cache", "--select", "LNT002", "--quiet"])
    return [line.partition(":")[0] for line in capsys.readouterr().out.splitlines()]


@pytest.mark.parametrize(
    "imports",
    [
        "import robot.motors.left",
        "from robot.motors.left import turn",
        "from .motors.left import turn",
        "from robot.motors import left",
        "from robot import motors",
    ],
)
def test_the_package_of_an_imported_module_is_run_first(robot: Path, capsys: pytest.CaptureFixture[str], imports: str):
    (robot / "node.py").write_text(NODE.format(imports=imports))
    assert broken(capsys) == ["robot/motors/__init__.py"]


def test_a_package_from_which_nothing_is_imported_may_be_broken(robot: Path, capsys: pytest.CaptureFixture[str]):
    (robot / "node.py").write_text(NODE.format(imports="import os"))
    assert broken(capsys) == []


def test_a_file_that_nothing_imports_may_be_a_template_or_bad_on_purpose(
    robot: Path, capsys: pytest.CaptureFixture[str]
):
    (robot / "node.py").write_text(NODE.format(imports=""))
    for name in ("template.py", "wrong_input.py"):
        (robot / name).write_text("class {{ name }}(:\n")
    (robot / "old.py").write_text("print 'ready'\n")
    assert broken(capsys) == []


def test_a_script_in_a_package_is_started_without_it(robot: Path, capsys: pytest.CaptureFixture[str]):
    (robot / "motors" / "script.py").write_text(NODE.format(imports="import os"))
    assert broken(capsys) == []

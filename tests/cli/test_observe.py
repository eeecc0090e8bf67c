"""``archlint observe``, and ``--observed`` on the command line."""

from __future__ import annotations

import ast
import json
import sys
from pathlib import Path

import pytest

from archlint.cli import main

ROOT = Path(__file__).parents[2]
LAUNCH = "src/my_first_package/launch/robot.launch.py"
FROM_ROS = {"rclpy", "rcl_interfaces"}


@pytest.fixture
def recorded(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A recording of the lesson without one of its nodes; the lesson is the working directory."""
    monkeypatch.chdir(ROOT / "fixtures" / "lesson")
    record = json.loads((ROOT / "tests" / "observed" / "lesson.jazzy.json").read_text("utf-8"))
    record["nodes"] = [node for node in record["nodes"] if node["name"] != "/motor_node"]
    path = tmp_path / "robot.json"
    path.write_text(json.dumps(record), encoding="utf-8")
    return path


def test_the_script_is_one_file_that_needs_rclpy_alone(capsys):
    assert main(["observe", "--print-script"]) == 0
    tree = ast.parse(capsys.readouterr().out, feature_version=(3, 10))
    imports = [node for node in ast.walk(tree) if isinstance(node, (ast.Import, ast.ImportFrom))]
    modules = {one.module if isinstance(one, ast.ImportFrom) else one.names[0].name for one in imports}
    assert {name.partition(".")[0] for name in modules} - sys.stdlib_module_names == FROM_ROS


def test_the_script_may_be_written_to_a_file(tmp_path, capsys):
    assert main(["observe", "--print-script", "-o", str(tmp_path / "record.py")]) == 0
    assert main(["observe", "--print-script"]) == 0
    assert (tmp_path / "record.py").read_text("utf-8") == capsys.readouterr().out


def test_archlint_itself_runs_nothing(capsys):
    assert main(["observe"]) == 2
    assert "`archlint observe --print-script` prints the script to run" in capsys.readouterr().err


def test_a_difference_is_a_finding(recorded, capsys):
    words = ["check", "--no-cache", "--format", "json", "--launch", LAUNCH, "--observed", str(recorded)]
    assert main(words) == 1
    said = capsys.readouterr()
    [found] = json.loads(said.out)["diagnostics"]
    assert (found["code"], found["node"], found["system"], found["file"]) == ("GRF005", "/motor_node", LAUNCH, LAUNCH)
    assert f"Compared {recorded.as_posix()} with the system that {LAUNCH} starts." in said.err
    assert "2 nodes and 5 endpoints on both sides; 1 missing." in said.err


def test_a_picture_is_told_what_it_was_compared_with(recorded, tmp_path, capsys):
    words = ["graph", "--no-cache", "--launch", LAUNCH, "--observed", str(recorded)]
    assert main([*words, "-o", str(tmp_path / "robot.mmd")]) == 0
    assert "2 nodes and 5 endpoints on both sides; 1 missing." in capsys.readouterr().err
    assert main(words) == 0  # the text says it itself
    assert capsys.readouterr().err == ""


def test_quiet_says_the_findings_alone(recorded, capsys):
    assert main(["check", "--no-cache", "-q", "--launch", LAUNCH, "--observed", str(recorded)]) == 1
    assert capsys.readouterr().err == ""


@pytest.mark.parametrize("command", ["check", "graph"])
@pytest.mark.parametrize(
    ("text", "said"),
    [("{", "malformed JSON"), ("hello", "expected a recording"), (None, "No such file or directory")],
)
def test_a_file_that_is_of_no_use(recorded, capsys, command, text, said):
    if text is None:
        recorded.unlink()
    else:
        recorded.write_text(text, encoding="utf-8")
    assert main([command, "--no-cache", "--observed", str(recorded)]) == 2
    told = capsys.readouterr()
    assert told.out == ""
    assert said in told.err
    assert str(recorded) in told.err

"""What somebody types who is new here, or comes from another linter, and the answer that helps."""

from __future__ import annotations

from pathlib import Path

import pytest

from archlint.cli import main
from archlint.cli.habits import COMMANDS, OPTIONS
from archlint.cli.near_paths import named_below, near_path

MANIFEST = "<package format='3'><name>{name}</name><version>0.0.0</version></package>\n"
NODE = """\
import rclpy
from rclpy.node import Node

rclpy.init()
rclpy.spin(Node('driver'))
"""
LAUNCH = (
    "from launch import LaunchDescription\n\n\ndef generate_launch_description():\n    return LaunchDescription([])\n"
)


@pytest.fixture
def workspace(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    for name in ("driver", "planner"):
        package = tmp_path / "src" / name
        (package / "launch").mkdir(parents=True)
        (package / "package.xml").write_text(MANIFEST.format(name=name))
        (package / f"{name}.py").write_text(NODE)
        (package / "launch" / f"{name}.launch.py").write_text(LAUNCH)
    (tmp_path / "build").mkdir()
    (tmp_path / "archlint.toml").write_text("")
    (tmp_path / "src" / "resource" / "driver").mkdir(parents=True)
    monkeypatch.chdir(tmp_path)
    return tmp_path


@pytest.mark.parametrize(
    ("words", "hint"),
    [
        ("chekc", "no such file or directory: chekc; did you mean the command `check`?"),
        ("lint", "did you mean the command `archlint check`?"),
        ("lint src", "did you mean the command `archlint check`?"),
        ("rule SRV003", "did you mean the command `archlint explain SRV003`?"),
        ("why", "did you mean the command `archlint explain CODE`?"),
        ("baseline", "the command `archlint check --baseline archlint-baseline.txt --write-baseline`?"),
        ("show", "the following arguments are required: NAME\n"),
        ("show riv", "is called `riv`; did you mean '/driver'?"),
        ("version", "did you mean the command `archlint --version`?"),
        ("check lint", "no such file or directory: lint\n"),
        ("srcc", "did you mean src?"),
        ("check src/drivr", "did you mean src/driver?"),
        ("check src/drivr/drivre.py", "did you mean src/driver/driver.py?"),
        ("check ./srcc/driver", "did you mean ./src/driver?"),
        ("check driver", "no such file or directory: driver; did you mean src/driver?"),
        ("check driver.py", "did you mean src/driver/driver.py?"),
        ("check src/**/*.py", "a pattern is for the shell, without quotes"),
        ("check --ignore NME001 TMO001", "several rules are written with commas between them: --select TMO001,TMO001"),
        ("check use_sim:=true", "arguments of a launch file come after --launch FILE"),
        ("check nothing/like/this", "no such file or directory: nothing/like/this\n"),
        ("check --select SVR003", "did you mean SRV003?"),
        ("check --select F401", "unknown rule `F401`; `archlint rules` lists them"),
        ("check --select nested-servce-call", "did you mean nested-service-call (SRV003)?"),
        ("explain", "which rule? `archlint rules` lists them"),
        ("explain nested", "did you mean nested-service-call (SRV003)?"),
        ("explain OWN", "did you mean one of OWN001, OWN002, OWN003?"),
        ("check --format jsn", "argument --format: invalid choice: 'jsn'; did you mean json?"),
        ("check --format xml", "(choose from text, concise, json, sarif, github, gitlab, junit)"),
        ("check --severity warn", "did you mean warning?"),
        ("check --stat", "did you mean --statistics?"),
        ("check --output-format=json", "unrecognized arguments: --output-format=json; write --format"),
        ("check -j4", "unrecognized arguments: -j4; write --jobs"),
        ("check --exclude build", "that is the key `exclude` of the configuration"),
        ("check --strict", "write --severity info"),
        ("check --quite", "did you mean --quiet?"),
        ("check --launch driver.launch.py", "did you mean src/driver/launch/driver.launch.py?"),
        ("check --launch src/driver/launch/drivr.launch.py", "did you mean src/driver/launch/driver.launch.py?"),
        ("check --launch src/driver", "is a folder; the launch files in it: src/driver/launch/driver.launch.py"),
        ("check --launch driver driver.launch.py", "did you mean src/driver/launch/driver.launch.py?"),
        ("check --launch src/driver/launch/driver.launch.py sim=true", "write sim:=true, as for `ros2 launch`"),
        ("check --config archlnt.toml", "cannot be read: No such file or directory; did you mean archlint.toml?"),
        ("check --select ,", "--select: no rule is named, so nothing would be checked"),
        ("rules SVR", "unknown rule `SVR`; did you mean SRV?"),
        ("graph -o robot.jpg", "the suffix of robot.jpg does not name a format: use one of .txt, .json"),
    ],
)
def test_a_mistake_is_answered_with_what_was_meant(
    workspace: Path, capsys: pytest.CaptureFixture[str], words: str, hint: str
):
    assert main(words.split()) == 2
    assert hint in capsys.readouterr().err


def test_a_variable_that_is_unset_is_no_path(workspace: Path, capsys: pytest.CaptureFixture[str]):
    assert main(["check", ""]) == 2
    assert "an empty word is no path: is a variable of the shell unset?" in capsys.readouterr().err


def test_a_launch_file_of_another_package_is_found_in_the_workspace(
    workspace: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
):
    monkeypatch.chdir(workspace / "src" / "driver")
    assert main(["check", "--launch", "planner.launch.py"]) == 2
    assert "did you mean ../planner/launch/planner.launch.py?" in capsys.readouterr().err


@pytest.mark.parametrize("words", ["help graph", "--help graph", "graph --help"])
def test_help_is_asked_for_in_any_order(capsys: pytest.CaptureFixture[str], words: str):
    assert main(words.split()) == 0
    assert capsys.readouterr().out.startswith("usage: archlint graph ")


def test_rules_lists_those_that_are_named(capsys: pytest.CaptureFixture[str]):
    assert main(["rules", "OWN", "nested-service-call"]) == 0
    codes = [line.split()[0] for line in capsys.readouterr().out.splitlines()]
    assert codes == ["code", "OWN001", "OWN002", "OWN003", "SRV003"]


def test_no_habit_hides_a_command_or_an_option_of_archlint():
    from archlint.cli import COMMANDS as OURS
    from archlint.cli.check import parser

    assert not set(COMMANDS) & set(OURS)
    known = {text for action in parser()._actions for text in action.option_strings}
    assert not set(OPTIONS) & known


def test_a_path_with_every_part_right_is_near_none(workspace: Path):
    assert near_path("src/driver/") == ""
    assert near_path("elsewhere") == ""


def test_a_package_is_found_by_its_name_and_not_what_is_called_alike(workspace: Path):
    (workspace / "build" / "planner").mkdir()
    assert named_below("driver") == ["src/driver"]
    assert named_below("planner") == ["src/planner"]
    assert named_below("launch") == ["src/driver/launch", "src/planner/launch"]
    assert named_below("src/driver") == []


@pytest.mark.parametrize(
    ("files", "told"),
    [
        ([], "no launch file; there is no file at all\n"),
        (
            ["src/drv/main.cpp", "src/drv/main.hpp"],
            "and nothing that uses rclpy or rclcpp in 2 files of Python or C++\n",
        ),
        (["src/a.txt", "README", ".hidden"], "there are 1 .txt, 1 other files\n"),
        (
            ["robot.repos"],
            "there is 1 .repos file\nThe sources that robot.repos lists may not be there yet: vcs import",
        ),
        ([".gitmodules"], "The submodules may not be there yet: git submodule update --init --recursive\n"),
    ],
    ids=["empty", "C++", "others", "vcs", "git"],
)
def test_where_there_is_nothing_to_check_it_is_said_what_is_there(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], files: list[str], told: str
):
    (tmp_path / "src").mkdir()
    for file in files:
        (tmp_path / file).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / file).write_text("")
    monkeypatch.chdir(tmp_path)
    assert main(["check"]) == 2
    assert told in capsys.readouterr().err


@pytest.mark.parametrize(
    ("file", "text", "told"),
    [
        (
            "archlint.toml",
            'exclude = ["src/**"]',
            "`exclude` in archlint.toml leaves out all of it, such as src/drv/n.py\n",
        ),
        ("src/COLCON_IGNORE", "", "all of it is left out, such as src/drv/n.py: there is src/COLCON_IGNORE\n"),
        ("src/drv/AMENT_IGNORE", "", "such as src/drv/n.py: there is src/drv/AMENT_IGNORE\n"),
        (".gitignore", "src/drv", "such as src/drv/n.py: git ignores it, or a build has left it\n"),
    ],
    ids=["exclude", "colcon", "ament", "git"],
)
def test_where_all_is_left_out_it_is_said_why(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], file: str, text: str, told: str
):
    (tmp_path / "src" / "drv").mkdir(parents=True)
    (tmp_path / "src" / "drv" / "n.py").write_text("import rclpy\n")
    (tmp_path / file).write_text(text)
    monkeypatch.chdir(tmp_path)
    assert main(["check", "--no-cache"]) == 2
    assert told in capsys.readouterr().err


def test_inside_of_a_workspace_the_whole_is_offered(
    workspace: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
):
    offer = "The rest of .. was read, too, but is not reported on: `archlint check ..` checks all of it.\n"
    monkeypatch.chdir(workspace / "src" / "driver")
    main(["check"])
    assert offer in capsys.readouterr().err
    main(["check", "driver.py"])
    assert "The rest" not in capsys.readouterr().err
    monkeypatch.chdir(workspace)
    main(["check"])
    assert "The rest" not in capsys.readouterr().err


@pytest.mark.parametrize("path", ["a" * 5000, "/".join(["a"] * 3000)])
def test_a_path_that_is_too_long_for_the_system_is_one_that_does_not_exist(path: str, capsys):
    assert main(["check", path]) == 2
    assert capsys.readouterr().err.startswith("archlint: error: no such file or directory: a")

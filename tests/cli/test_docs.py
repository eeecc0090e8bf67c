"""``archlint docs``."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from archlint.cli import main

FIXTURES = Path(__file__).parents[2] / "fixtures"


@pytest.fixture
def robot(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The robot of the lesson, to write into."""
    shutil.copytree(FIXTURES / "lesson", tmp_path / "robot")
    monkeypatch.chdir(tmp_path / "robot")
    return tmp_path / "robot"


def docs(*words: str) -> int:
    return main(["docs", "--no-cache", *words])


def files_of(folder: Path) -> dict[str, bytes]:
    return {path.relative_to(folder).as_posix(): path.read_bytes() for path in folder.rglob("*") if path.is_file()}


def test_pages_for_a_robot(robot, capsys):
    assert docs() == 0
    assert [*sorted(files_of(robot / "docs/architecture"))] == [
        "README.md",
        "nodes/my_first_package.control_node.md",
        "nodes/my_first_package.motor_node.md",
        "nodes/my_first_package.sensor_node.md",
        "systems/robot.launch.py.md",
    ]
    assert capsys.readouterr() == ("", "5 pages in docs/architecture: 5 written.\n")
    text = (robot / "docs/architecture/nodes/my_first_package.sensor_node.md").read_text()
    assert "](../../../src/my_first_package/my_first_package/sensor_node.py#L" in text


def test_check_names_what_is_stale(robot, capsys):
    assert docs("-o", "pages") == 0
    assert docs("-o", "pages", "--check") == 0
    capsys.readouterr()
    node = robot / "src/my_first_package/my_first_package/sensor_node.py"
    node.write_text(node.read_text().replace("'sensor_data'", "'reading'").replace('"sensor_data"', '"reading"'))
    before = files_of(robot / "pages")
    assert docs("-o", "pages", "--check") == 1
    shown = capsys.readouterr()
    assert "pages/nodes/my_first_package.sensor_node.md: stale\n" in shown.out
    assert "motor_node" not in shown.out
    assert "Run `archlint docs`" in shown.err
    assert files_of(robot / "pages") == before


def test_check_of_a_folder_that_is_not_there(robot, capsys):
    assert docs("--check", "-q") == 1
    shown = capsys.readouterr()
    assert shown.out.splitlines()[0] == "docs/architecture/README.md: missing"
    assert shown.err == ""
    assert not (robot / "docs").exists()


def test_a_file_of_the_user_is_refused(robot, capsys):
    (robot / "pages").mkdir()
    (robot / "pages/README.md").write_text("# Mine\n")
    assert docs("-o", "pages") == 2
    assert "pages/README.md was not written by `archlint docs`, and is left as it is" in capsys.readouterr().err
    assert files_of(robot / "pages") == {"README.md": b"# Mine\n"}


def test_a_file_instead_of_a_folder(robot, capsys):
    (robot / "pages").write_text("")
    assert docs("-o", "pages") == 2
    assert "pages is a file: -o names the folder of the pages" in capsys.readouterr().err


def test_one_launch_file(robot):
    assert docs("--launch", "src/my_first_package/launch/robot.launch.py", "-o", "pages") == 0
    assert "systems/robot.launch.py.md" in files_of(robot / "pages")


def test_pages_are_the_same_on_every_run(robot):
    assert docs("-o", "pages") == docs("-o", "again") == 0
    assert files_of(robot / "pages") == files_of(robot / "again")

"""``--statistics``: counts in place of the findings, and the shape of what was checked, from the systems that the check
has made."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from archlint.cli import main
from archlint.programs.linker import Linker

TALKER = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class {name}(Node):
    def __init__(self):
        super().__init__('{lower}')
        self.out = self.create_publisher(String, '{said}', 10)
        self.create_subscription(String, '{heard}', self.out.publish, 10)


def main():
    rclpy.init()
    rclpy.spin({name}())


if __name__ == '__main__':
    main()
"""
PACKAGE = "<package format='3'><name>{name}</name><version>0.0.0</version></package>\n"
CHAIN = (("First", "a", "b"), ("Second", "b", "c"), ("Third", "c", "d"))


@pytest.fixture
def followed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> list[Linker]:
    """Two workspaces side by side, each with a chain of nodes; what follows the programs of one."""
    for workspace in ("one_ws", "other_ws"):
        package = tmp_path / workspace / "src" / "chain"
        package.mkdir(parents=True)
        (package / "package.xml").write_text(PACKAGE.format(name="chain"))
        for name, heard, said in CHAIN:
            text = TALKER.format(name=name, lower=name.lower(), heard=heard, said=said)
            (package / f"{name.lower()}.py").write_text(text)
    linkers: list[Linker] = []
    run_all = Linker.run_all

    def noted(linker: Linker, entry_points: object) -> object:
        linkers.append(linker)
        return run_all(linker, entry_points)  # type: ignore[arg-type]

    monkeypatch.setattr(Linker, "run_all", noted)
    monkeypatch.chdir(tmp_path)
    return linkers


def _shape(text: str) -> str:
    return text[text.index("pattern: ") : text.index("\nFound ") if "\nFound " in text else text.index("\nNo findings")]


def test_each_workspace_is_followed_once(followed: list[Linker], capsys: pytest.CaptureFixture[str]):
    main(["check", ".", "--statistics", "--no-cache", "--jobs", "1"])
    shape = _shape(capsys.readouterr().err)
    assert len(followed) == 2
    assert "connected: 6 of 6 nodes" in shape


def test_the_shape_is_the_same_when_the_findings_are_known(
    followed: list[Linker], capsys: pytest.CaptureFixture[str], tmp_path: Path
):
    command = ["check", ".", "--statistics", "--cache-dir", str(tmp_path / "cache"), "--jobs", "1"]
    main(command)
    first = _shape(capsys.readouterr().err)
    assert len(followed) == 2
    main(command)
    assert _shape(capsys.readouterr().err) == first
    assert len(followed) == 4


def test_the_counts_stand_instead_of_the_findings(followed: list[Linker], capsys: pytest.CaptureFixture[str]):
    command = ["check", "one_ws", "--statistics", "--no-cache", "--select", "NME002,GRF001", "-q"]
    (Path("one_ws") / "src/chain/first.py").write_text(
        TALKER.format(name="First", lower="first", heard="a", said="b-c")
    )
    assert main(command) == 1
    assert capsys.readouterr().out == "1\tNME002\tinvalid-name\n"
    main([*command, "--format", "json"])
    assert json.loads(capsys.readouterr().out)[0]["code"] == "NME002"


def test_other_formats_have_no_statistics(capsys: pytest.CaptureFixture[str]):
    assert main(["check", "--statistics", "--format", "github"]) == 2
    assert "--statistics is written as text, concise or json, not as github" in capsys.readouterr().err

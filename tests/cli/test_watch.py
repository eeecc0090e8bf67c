"""``--watch``: the result, and again after each change.  A pause is where a test makes the next change."""

from __future__ import annotations

import os
import sys
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from archlint.cli import main, watch

NODE = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.out = self.create_publisher(String, '{name}', 10)


def main():
    rclpy.init()
    rclpy.spin(Talker())


if __name__ == '__main__':
    main()
"""
Change = Callable[[], object]
Watched = Callable[..., list[str]]


@pytest.fixture
def watched(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> Watched:
    """Runs a watch through some changes, one a pause; returns what each run showed."""
    (tmp_path / "talker.py").write_text(NODE.format(name="chat"))
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("TERM", "dumb")
    monkeypatch.setenv("COLUMNS", "120")

    def run(*changes: Change, words: str = "") -> list[str]:
        shown: list[str] = []
        left: Iterator[Change] = iter(changes)

        def pause(seconds: float) -> None:
            assert seconds >= watch.INTERVAL
            shown.append(capsys.readouterr().out.lstrip("\n"))
            change = next(left, None)
            if change is None:
                raise KeyboardInterrupt
            change()

        monkeypatch.setattr(watch, "PAUSE", pause)
        monkeypatch.setattr(sys.stdout, "isatty", lambda: True)
        assert main(["check", "--watch", "--format", "concise", "--no-cache", *words.split()]) == 130
        return shown

    return run


def write(name: str, text: str) -> Change:
    """A file gets another text, and another time than it had before: a test is faster than a clock."""

    def change() -> None:
        before = os.stat(name).st_mtime_ns if os.path.exists(name) else 0
        Path(name).write_text(text)
        os.utime(name, ns=(before + 10**9, before + 10**9))

    return change


def nothing() -> None:
    """A pause in which nothing changes."""


def test_each_change_is_checked_and_told_of(watched: Watched):
    first, same, broken, mended = watched(
        nothing,
        write("talker.py", "\n" + NODE.format(name="chat-er")),
        write("talker.py", NODE.format(name="chat")),
    )
    assert "No findings in 1 file with 1 node." in first
    assert "Since the last run" not in first
    assert same == ""
    assert "talker.py:10:50: error: NME002" in broken
    assert "Since the last run: 1 new, 0 gone\n  + talker.py:10 error NME002 ROS rejects" in broken
    assert "Since the last run: 0 new, 1 gone\n  - talker.py:10 error NME002 ROS rejects" in mended


def test_a_finding_that_only_moves_is_not_new(watched: Watched):
    wrong = NODE.format(name="chat-er")
    _, moved, later = watched(write("talker.py", wrong), write("talker.py", "\n\n" + wrong))
    assert "1 new" in moved
    assert "talker.py:11:50" in later
    assert "Since" not in later


def test_files_that_come_and_go_are_seen(watched: Watched):
    _, more, fewer = watched(write("other.py", NODE.format(name="b")), lambda: Path("other.py").unlink())
    assert "in 2 files with 2 nodes." in more
    assert "in 1 file with 1 node." in fewer


def test_a_mistake_in_the_configuration_is_shown_until_it_is_mended(watched: Watched):
    _, wrong, right = watched(write("archlint.toml", "selec = []\n"), write("archlint.toml", "select = ['SRV']\n"))
    assert "archlint: error: archlint.toml:1: unknown key `selec`" in wrong
    assert "not checked; waiting for changes" in wrong
    assert "No findings" in right


def test_the_time_of_the_run_is_told_unless_it_is_quiet(watched: Watched):
    assert watched()[0].splitlines()[-1].endswith("waiting for changes, Ctrl-C ends")
    assert watched(words="--quiet") == [""]


@pytest.mark.parametrize(
    ("words", "reason"),
    [
        ("--fix", "--watch shows findings and does nothing else: leave out --fix"),
        ("-o out.txt", "leave out -o"),
        ("--baseline b.txt --write-baseline", "leave out --write-baseline"),
        ("--format json", "--watch shows text or concise, not json"),
        ("", "--watch needs a terminal, and standard output is none: leave it out to check once"),
        ("srcc", "--watch needs a terminal"),
    ],
)
def test_what_cannot_be_watched(capsys: pytest.CaptureFixture[str], words: str, reason: str):
    assert main(["check", "--watch", *words.split()]) == 2
    assert reason in capsys.readouterr().err


def test_a_first_check_that_cannot_be_done_ends_it(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]):
    monkeypatch.setattr(sys.stdout, "isatty", lambda: True)
    assert main(["check", "--watch", "nowhere"]) == 2
    assert "no such file or directory: nowhere" in capsys.readouterr().err

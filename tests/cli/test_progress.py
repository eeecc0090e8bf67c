"""The line that says how far a run is, and what ``--verbose`` says took long."""

from __future__ import annotations

import io
import json
import os
import subprocess
import sys
from contextlib import redirect_stderr
from pathlib import Path

import pytest

from archlint.cli import main, progress_line
from archlint.cli.costs import costs
from archlint.cli.progress import shows_progress
from archlint.cli.progress_line import ProgressLine
from archlint.cli.tally import Tally

NODE = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.create_publisher(String, '/chatter', 10)


def main():
    rclpy.init()
    rclpy.spin(Talker())


if __name__ == '__main__':
    main()
"""


class Terminal(io.StringIO):
    """A terminal; ``screen`` is the line that stands there."""

    def isatty(self) -> bool:
        return True

    def fileno(self) -> int:
        raise io.UnsupportedOperation("fileno")

    @property
    def screen(self) -> str:
        line: list[str] = []
        for piece in self.getvalue().split("\r"):
            line[: len(piece)] = piece
        return "".join(line).rstrip()


class Clock:
    """Stands still until it is set."""

    now = 0.0

    def __call__(self) -> float:
        return self.now


@pytest.fixture(autouse=True)
def at_a_desk(monkeypatch: pytest.MonkeyPatch):
    monkeypatch.delenv("CI", raising=False)
    monkeypatch.setenv("TERM", "xterm")


def run(*words: str) -> tuple[int, Terminal]:
    """Run a command with a terminal as standard error; the exit status, and the terminal."""
    terminal = Terminal()
    with redirect_stderr(terminal):
        return main(list(words)), terminal


@pytest.fixture
def long_runs(monkeypatch: pytest.MonkeyPatch) -> None:
    """Every run is long enough to say something."""
    monkeypatch.setattr(progress_line, "DELAY", 0.0)
    monkeypatch.setattr(progress_line, "INTERVAL", 0.0)


@pytest.fixture
def workspace(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    for name in ("talker", "other"):
        (tmp_path / f"{name}.py").write_text(NODE.replace("talker", name))
    monkeypatch.chdir(tmp_path)
    return tmp_path


def line_on(terminal: Terminal, clock: Clock) -> tuple[Tally, ProgressLine]:
    tally, line = Tally(), ProgressLine(terminal, clock)
    tally.changed = line.show
    return tally, line


def test_a_short_run_shows_no_line():
    terminal, clock = Terminal(), Clock()
    tally, line = line_on(terminal, clock)
    clock.now = 0.9
    tally.compiling(1)
    tally.compiled("a.py", 0.5)
    line.erase()
    assert terminal.getvalue() == ""


def test_a_long_run_says_how_far_it_is():
    terminal, clock = Terminal(), Clock()
    tally, _ = line_on(terminal, clock)
    tally.compiling(3)
    clock.now = 1.0
    tally.compiled("a.py", 0.5)
    assert terminal.screen == "archlint: 1/3 files read"
    clock.now = 2.0
    tally.following(40)
    assert terminal.screen == "archlint: 1/3 files read, 0/40 programs analysed"
    clock.now = 3.0
    tally.followed("ScriptKey(file='a.py')", "a (a.py)", 0.5)
    clock.now = 4.0
    tally.known("ScriptKey(file='b.py')")
    assert terminal.screen == "archlint: 1/3 files read, 2/40 programs analysed"
    clock.now = 5.0
    tally.judging(7)
    clock.now = 6.0
    tally.judged()
    assert terminal.screen.endswith(", 2/40 programs analysed, 1/7 systems checked")


def test_of_what_several_processes_follow_the_parts_are_counted():
    terminal, clock = Terminal(), Clock()
    tally, _ = line_on(terminal, clock)
    tally.following(40)
    clock.now = 2.0
    tally.dividing(5)
    clock.now = 3.0
    tally.part_done()
    assert terminal.screen == "archlint: 1/5 parts of the programs analysed"
    tally.divided()
    clock.now = 4.0
    tally.known("ScriptKey(file='a.py')")
    assert terminal.screen == "archlint: 1/40 programs analysed"


def test_the_line_changes_only_so_often():
    terminal, clock = Terminal(), Clock()
    tally, _ = line_on(terminal, clock)
    tally.compiling(3)
    clock.now = 2.0
    tally.compiled("a.py", 0.1)
    clock.now = 2.05
    tally.compiled("b.py", 0.1)
    assert terminal.screen == "archlint: 1/3 files read"
    clock.now = 2.11
    tally.compiled("c.py", 0.1)
    assert terminal.screen == "archlint: 3/3 files read"


def test_nothing_is_left_of_the_line_and_nothing_comes_after():
    terminal, clock = Terminal(), Clock()
    tally, line = line_on(terminal, clock)
    clock.now = 2.0
    tally.compiling(3)
    assert terminal.screen
    line.erase()
    assert terminal.screen == ""
    assert terminal.getvalue().endswith("\r")
    written = terminal.getvalue()
    line.erase()
    assert terminal.getvalue() == written


def test_a_narrow_terminal_gets_a_line_that_fits(monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setattr(progress_line, "columns", lambda stream: 20)
    terminal, clock = Terminal(), Clock()
    tally, _ = line_on(terminal, clock)
    clock.now = 2.0
    tally.compiling(3)
    assert terminal.screen == "archlint: 0/3 files"


def test_a_terminal_that_goes_away_is_no_error():
    class Gone(Terminal):
        def write(self, text: str) -> int:
            raise BrokenPipeError

    clock = Clock()
    tally, line = line_on(Gone(), clock)
    clock.now = 2.0
    tally.compiling(3)
    tally.compiled("a.py", 0.1)
    line.erase()


@pytest.mark.parametrize(
    ("environment", "shown"),
    [
        ({}, True),
        ({"CI": ""}, True),
        ({"CI": "false"}, True),
        ({"CI": "true"}, False),
        ({"CI": "1"}, False),
        ({"TERM": "dumb"}, False),
    ],
)
def test_where_the_line_is_shown(monkeypatch: pytest.MonkeyPatch, environment: dict[str, str], shown: bool):
    for name, value in environment.items():
        monkeypatch.setenv(name, value)
    assert shows_progress(Terminal()) is shown
    assert not shows_progress(io.StringIO())


@pytest.mark.parametrize("command", ["check", "graph"])
@pytest.mark.usefixtures("workspace", "long_runs")
def test_a_run_shows_the_line_and_takes_it_away(capsys: pytest.CaptureFixture[str], command: str):
    status, terminal = run(command, "--no-cache", "--jobs", "1", "--format", "json")
    assert status == 0
    assert "archlint: 2/2 files read" in terminal.getvalue()
    assert "4/4 programs analysed" in terminal.getvalue()
    assert terminal.screen == ""
    json.loads(capsys.readouterr().out)


@pytest.mark.parametrize(("command", "format"), [("check", "sarif"), ("check", "text"), ("graph", "json")])
@pytest.mark.usefixtures("workspace", "long_runs")
def test_the_line_changes_nothing_of_the_output(capsys: pytest.CaptureFixture[str], command: str, format: str):
    _, terminal = run(command, "--no-cache", "--format", format)
    assert "files read" in terminal.getvalue()
    with_line = capsys.readouterr().out
    main([command, "--no-cache", "--format", format])
    assert capsys.readouterr().out == with_line


@pytest.mark.parametrize("command", ["check", "graph"])
@pytest.mark.usefixtures("workspace", "long_runs")
def test_no_line_with_quiet_nor_in_ci(monkeypatch: pytest.MonkeyPatch, command: str):
    assert "\r" not in run(command, "--no-cache", "--quiet")[1].getvalue()
    assert "\r" in run(command, "--no-cache")[1].getvalue()
    monkeypatch.setenv("CI", "true")
    assert "\r" not in run(command, "--no-cache")[1].getvalue()


@pytest.mark.usefixtures("long_runs")
def test_what_is_checked_again_after_fixes_is_watched_too(workspace: Path):
    waits = NODE.replace("String\n\n", "String\nfrom std_srvs.srv import Trigger\n\n").replace(
        "        self.create_publisher(String, '/chatter', 10)",
        "        self.reset = self.create_client(Trigger, 'reset')\n        self.reset.wait_for_service()",
    )
    (workspace / "waits.py").write_text(waits)
    _, terminal = run("check", "--no-cache", "--jobs", "1", "--fix", "--unsafe-fixes")
    assert "\rFixed " in terminal.getvalue()
    assert "6/6 files read" in terminal.getvalue()  # three files, twice


@pytest.mark.usefixtures("workspace", "long_runs")
def test_the_line_is_gone_before_an_error_is_told(monkeypatch: pytest.MonkeyPatch):
    def fail(*arguments: object, **more: object) -> None:
        raise KeyError("gone")

    monkeypatch.setattr("archlint.syntax.files.compile_sources", fail)
    status, terminal = run("check", "--no-cache")
    assert status == 2
    shown, erased, rest = terminal.getvalue().rsplit("\r", 2)
    assert shown.endswith("0/2 files read")
    assert erased.isspace()
    assert rest.startswith("archlint: internal error: KeyError")


# ------------------------------------------------------------------------------------------------- --verbose


def ended_after(seconds: float) -> Tally:
    clock = Clock()
    tally = Tally(clock)
    clock.now = seconds
    tally.end()
    return tally


def test_the_slowest_come_first_with_their_share():
    tally = ended_after(20.0)
    for number in range(12):
        tally.compiled(f"file_{number:02}.py", 0.25 * number)
    tally.following(2)
    tally.followed("ScriptKey(file='a.py')", "a (a.py)", 1.0)
    tally.followed("ScriptKey(file='b.py')", "b (b.py)", 2.0)
    assert list(costs(tally)) == [
        "processor time: 20.00 s",
        "read 12 files: 16.50 s, 82.5 %",
        *(f"  {0.25 * number:7.2f} s {1.25 * number:4.1f} %  file_{number:02}.py" for number in range(11, 1, -1)),
        "analysed 2 programs: 3.00 s, 15.0 %; reused 0 from an earlier run",
        "     2.00 s 10.0 %  b (b.py)",
        "     1.00 s  5.0 %  a (a.py)",
    ]


def test_a_program_with_several_sets_of_parameters_is_told_once():
    tally = ended_after(10.0)
    tally.following(2)
    tally.followed("('entry', 'pkg', 'talker', None)", "talker (talker.py)", 1.0)
    tally.followed("('entry', 'pkg', 'talker', 'rate: 5')", "talker (talker.py)", 3.0)
    assert list(costs(tally))[-1] == "     4.00 s 40.0 %  talker (talker.py), 2 times"


def test_what_was_followed_ahead_is_not_from_an_earlier_run():
    tally, part = ended_after(10.0), Tally()
    part.compiled("of_the_parent.py", 9.0)  # a process begins with what its parent knows
    part.begin_part()
    part.followed("ScriptKey(file='a.py')", "a (a.py)", 1.5)
    part.compiled("imported.py", 0.5)
    tally.take(part.end_part())
    tally.following(2)
    tally.known("ScriptKey(file='a.py')")
    tally.known("ScriptKey(file='b.py')")
    assert (tally.kept, list(tally.programs.values())) == (1, [("a (a.py)", 1.5)])
    assert tally.files == {"imported.py": 0.5}


def told(capsys: pytest.CaptureFixture[str]) -> list[str]:
    """What the report is followed by, without the figures."""
    return [line.partition(":")[0] for line in capsys.readouterr().err.splitlines() if not line.startswith(" ")]


@pytest.mark.parametrize("command", ["check", "graph"])
def test_verbose_names_files_and_programs(workspace: Path, capsys: pytest.CaptureFixture[str], command: str):
    main([command, "--no-cache", "--verbose"])
    lines = capsys.readouterr().err.splitlines()
    assert [line.split("  ")[-1] for line in lines if line.endswith(" talker.py")] == ["talker.py"]
    assert any(line.endswith("  talker (talker.py)") for line in lines)


def test_verbose_counts_what_an_earlier_run_had_followed(workspace: Path, capsys: pytest.CaptureFixture[str]):
    main(["check", "--verbose", "--cache-dir", "cache"])
    assert {"read 2 files", "analysed 4 programs"} <= set(told(capsys))
    (workspace / "other.py").write_text(NODE.replace("talker", "listener"))
    main(["check", "--verbose", "--cache-dir", "cache"])
    lines = capsys.readouterr().err.splitlines()
    assert any(line.startswith("read 1 file:") for line in lines)
    [followed] = [line for line in lines if line.startswith("analysed")]
    assert (followed.split(":")[0], followed.split("; ")[1]) == ("analysed 2 programs", "reused 2 from an earlier run")


def test_verbose_says_that_the_whole_result_was_kept(workspace: Path, capsys: pytest.CaptureFixture[str]):
    main(["check", "--cache-dir", "cache"])
    capsys.readouterr()
    main(["check", "--verbose", "--cache-dir", "cache"])
    assert told(capsys)[-2:] == ["read 0 files", "analysed no programs"]


def test_quiet_is_stronger_than_verbose(workspace: Path, capsys: pytest.CaptureFixture[str]):
    main(["graph", "--no-cache", "--verbose", "--quiet"])
    assert capsys.readouterr().err == ""


def test_processes_say_what_each_file_took(workspace: Path, capsys: pytest.CaptureFixture[str]):
    for number in range(4):  # enough that programs are followed in processes, too
        filler = f"# {'x' * 70}\n" * 1000
        (workspace / f"node_{number}.py").write_text(NODE.replace("talker", f"node_{number}") + filler)
    main(["check", "--no-cache", "--verbose", "--jobs", "2"])
    lines = capsys.readouterr().err.splitlines()
    assert any(line.startswith("read 6 files: ") for line in lines)
    assert any(
        line.startswith("analysed 12 programs: ") and line.endswith("; reused 0 from an earlier run") for line in lines
    )
    for number in range(4):
        assert any(line.endswith(f"  node_{number} (node_{number}.py)") for line in lines)


# ------------------------------------------------------------------------------------------ a real terminal


def on_a_terminal(cwd: Path, *words: str, **more: str) -> str:
    """What a run whose standard error is a terminal writes there.  It is long enough to say something."""
    pty = pytest.importorskip("pty")
    ours, theirs = pty.openpty()
    code = (
        "from archlint.cli import main, progress_line; progress_line.DELAY = progress_line.INTERVAL = 0.0; "
        "main()"  # ends the process as the command does
    )
    environment = {**os.environ, "PYTHONPATH": str(Path(progress_line.__file__).parents[2]), "TERM": "xterm", **more}
    command = [sys.executable, "-c", code, *words, "--no-cache", "--isolated"]
    with subprocess.Popen(command, cwd=cwd, stdout=subprocess.DEVNULL, stderr=theirs, env=environment):
        os.close(theirs)
        written = b""
        while piece := _read(ours):
            written += piece
    os.close(ours)
    return written.decode()


def _read(terminal: int) -> bytes:
    try:
        return os.read(terminal, 4096)
    except OSError:  # nobody writes to it any more
        return b""


def test_a_real_terminal_shows_the_line_and_then_what_follows_it(workspace: Path):
    *shown, rest = on_a_terminal(workspace, "check").split("\r\n")[0].split("\r")
    assert any(line.startswith("archlint: ") and "2/2 files read" in line for line in shown)
    assert shown[-1].isspace()
    assert rest and not rest.startswith("archlint: ")


@pytest.mark.parametrize(("words", "more"), [((), {"CI": "true"}), (("--quiet",), {}), ((), {"TERM": "dumb"})])
def test_a_real_terminal_shows_none_in_ci_or_if_nobody_wants_one(
    workspace: Path, words: tuple[str, ...], more: dict[str, str]
):
    assert "files read" not in on_a_terminal(workspace, "check", *words, **more)

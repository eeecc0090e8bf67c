"""Streams that take nothing, and paths that are none: a plain sentence and an exit status, never a traceback."""

from __future__ import annotations

import io
import json
import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

from archlint.cli import main

SRC = Path(__file__).parents[2] / "src"
NODE = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String

rclpy.init()
node = Node('driver')
node.create_publisher(String, '/bad name', 10)
rclpy.spin(node)
"""
EMPTY = "an empty word is no path"


@pytest.fixture
def here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    (tmp_path / "driver.py").write_text(NODE)
    monkeypatch.chdir(tmp_path)
    return tmp_path


class Full(io.StringIO):
    """A stream on a full disk."""

    def write(self, text: str) -> int:
        raise OSError(28, "No space left on device")


@pytest.mark.parametrize(
    "words",
    [
        *(["check .", "check --format json", "check --help", "graph", "graph --format svg", "show driver"]),
        *(["explain SRV003", "explain --color always SRV003", "rules", "config", "config --schema"]),
        *(["init", "observe --print-script", "completion bash", "man", "--help", "--version"]),
    ],
)
def test_a_full_disk_is_told_as_what_it_is(here, monkeypatch, capsys, words):
    monkeypatch.setattr(sys, "stdout", Full())
    assert main(words.split()) == 2
    assert capsys.readouterr().err == "archlint: error: cannot write the output: No space left on device\n"


def test_what_has_nothing_to_say_needs_no_output(here, monkeypatch):
    monkeypatch.setattr(sys, "stdout", Full())
    assert main(["check", "-q", "-o", "report.txt"]) == 1
    assert main(["facts", "-q", "-o", "facts"]) == 0


def test_notes_that_nobody_takes_change_no_exit_status(here, monkeypatch, capsys):
    monkeypatch.setattr(sys, "stderr", Full())
    assert main(["check", "--no-cache"]) == 1
    assert main(["check", "nowhere"]) == 2


def test_every_command_writes_its_output_in_one_place():
    folder = SRC / "archlint" / "cli"
    direct = re.compile(r"sys\.stdout\.(write|flush|buffer)|(?<![\w.])print\(")
    found = {path.name for path in folder.glob("*.py") if direct.search(path.read_text())}
    assert found == {"console.py", "__init__.py"}  # the latter for the last flush


@pytest.mark.skipif(os.name == "nt", reason="closes streams as a shell does")
@pytest.mark.parametrize("closed", [(0,), (1,), (2,), (0, 1, 2)], ids=str)
def test_a_closed_stream_is_no_file_that_is_opened_next(here, closed):
    done = subprocess.run(
        [sys.executable, "-m", "archlint", "check", "--no-cache", "--format", "json"],
        env={**os.environ, "PYTHONPATH": str(SRC)},
        stdout=None if 1 in closed else subprocess.PIPE,
        stderr=None if 2 in closed else subprocess.PIPE,
        preexec_fn=lambda: [os.close(number) for number in closed],
        check=False,
    )
    if 1 in closed:
        assert (done.returncode, done.stderr) in [
            (2, b"archlint: error: cannot write the output: Bad file descriptor\n"),
            (2, None),
        ]
    else:
        assert done.returncode == 1
        assert [finding["code"] for finding in json.loads(done.stdout)["diagnostics"]] == ["NME002"]


def test_a_working_directory_that_is_gone(here, capsys):
    gone = here / "gone"
    gone.mkdir()
    os.chdir(gone)
    gone.rmdir()
    for command in ("check .", "graph", "config", "rules", "init", "facts -o out", f"check {here}"):
        assert main(command.split()) == 2
        assert capsys.readouterr().err == (
            "archlint: error: the working directory no longer exists; change to one that does\n"
        ), command


@pytest.mark.parametrize(
    "words",
    [
        *([["check", ""], ["graph", ""], ["show", "driver", ""], ["config", ""], ["init", ""]]),
        *([["check", "-o", ""], ["graph", "-o", ""], ["show", "driver", "-o", ""], ["facts", "-o", ""]]),
        *([["check", option, ""] for option in ("--config", "--cache-dir", "--baseline", "--observed", "--launch")]),
        *([["check", "--facts", ""], ["observe", "--print-script", "-o", ""]]),
    ],
    ids=" ".join,
)
def test_an_empty_word_is_no_path(here, capsys, words):
    assert main(words) == 2
    assert EMPTY in capsys.readouterr().err
    assert os.listdir(here) == ["driver.py"]


@pytest.mark.parametrize("command", ["check", "graph --format json", "show driver", "observe --print-script"])
def test_a_name_of_a_folder_is_no_file_to_write(here, capsys, command):
    assert main([*command.split(), "-o", "out/"]) == 2
    assert "cannot write out/: that names a folder, and there is none; name a file" in capsys.readouterr().err
    assert not Path("out").exists()


def test_links_that_lead_nowhere(here, capsys):
    Path("loop.json").symlink_to("loop.json")
    assert main(["check", "-o", "loop.json"]) == 2
    assert "cannot write loop.json: it is not a file name" in capsys.readouterr().err
    assert main(["check", "loop.json"]) == 2
    assert "loop.json is a symbolic link that leads nowhere" in capsys.readouterr().err


@pytest.mark.parametrize(
    "words", [["check", "--", "-o.py"], ["--", "-o.py"], ["-q", "--", "-o.py"], ["check", "driver.py", "--", "-o.py"]]
)
def test_after_two_dashes_there_are_no_options(here, capsys, words):
    Path("-o.py").write_text(NODE)
    assert main([*words]) == 1
    assert "-o.py:7:" in capsys.readouterr().out


def test_after_two_dashes_the_order_of_words_stays(here, capsys):
    Path("-o.py").write_text(NODE)
    assert main(["show", "--format", "json", "--", "driver", "-o.py"]) == 0
    assert '"-o.py"' in capsys.readouterr().out
    assert main(["check", "--", "-q"]) == 2
    assert "no such file or directory: -q" in capsys.readouterr().err

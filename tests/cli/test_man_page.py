"""The help of each command on a terminal of 80 columns, and the manual page that is made of it."""

from __future__ import annotations

import re
import shutil
import subprocess

import pytest

from archlint.cli import COMMANDS, main
from archlint.cli.all_options import commands_of, whole_parser
from archlint.cli.man_page import man_page


@pytest.mark.parametrize("command", ["", *COMMANDS])
def test_help_is_no_wider_than_80_columns(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], command: str
):
    monkeypatch.setenv("COLUMNS", "80")
    assert main([command, "--help"] if command else ["--help"]) == 0
    shown = capsys.readouterr().out
    assert [line for line in shown.splitlines() if len(line) > 80] == []
    assert all(name in shown for name in COMMANDS) or command


def test_the_page_has_every_option_with_its_help():
    plain = re.sub(r"\\f[BIR]", "", man_page()).replace(r"\-", "-")
    for name, command in commands_of(whole_parser()).items():
        section = plain.partition(f".SS archlint {name}")[2].partition("\n.S")[0]
        for action in command._actions:
            assert all(option in section for option in action.option_strings), name


def test_the_page_is_the_same_each_time(capsys: pytest.CaptureFixture[str]):
    assert main(["man"]) == 0
    assert capsys.readouterr().out == man_page()


def test_no_line_of_text_is_taken_for_a_command_of_roff():
    known = {"TH", "SH", "SS", "TP", "PP", "B", "I", "nf", "fi"}
    requests = {line[1:].partition(" ")[0] for line in man_page().splitlines() if line.startswith((".", "'"))}
    assert requests <= known


@pytest.mark.skipif(shutil.which("mandoc") is None, reason="needs mandoc")
def test_mandoc_takes_the_page():
    done = subprocess.run(["mandoc", "-T", "lint"], input=man_page(), capture_output=True, text=True, check=False)
    complaints = [line for line in (done.stdout + done.stderr).splitlines() if "missing date" not in line]
    assert complaints == []

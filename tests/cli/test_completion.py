"""``archlint completion``: what a shell offers, tried in the shells that are installed."""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path

import pytest

from archlint.cli import COMMANDS, main
from archlint.cli.all_options import commands_of, whole_parser
from archlint.cli.completers import script
from archlint.cli.completion import SHELLS
from archlint.report import FORMATS

IN_BASH = """\
source ./script
COMP_WORDS=({words} "{last}")
COMP_CWORD=$((${{#COMP_WORDS[@]}} - 1))
_shtab_archlint
printf '%s\\n' "${{COMPREPLY[@]}}"
"""
CASES = [
    ("archlint", "ch", ["check"]),
    ("archlint check", "--gro", ["--group-by"]),
    ("archlint check --format", "j", ["json", "junit"]),
    ("archlint check --select", "OWN00", ["OWN001", "OWN002", "OWN003"]),
    ("archlint check --select", "SRV,OWN00", ["SRV,OWN001", "SRV,OWN002", "SRV,OWN003"]),
    ("archlint explain", "ARC", ["ARC", "ARC001", "ARC002", "ARC003", "ARC004"]),
    ("archlint check --launch", "", ["src/a/launch/a.launch.py", "src/a/launch/b.launch.xml"]),
    ("archlint completion", "", ["bash", "fish", "zsh"]),
]


@pytest.fixture(autouse=True)
def workspace(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    for file in ("src/a/launch/a.launch.py", "src/a/launch/b.launch.xml", "install/a.launch.py", ".git/c.launch.py"):
        (tmp_path / file).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / file).write_text("")
    monkeypatch.chdir(tmp_path)


@pytest.mark.parametrize("shell", SHELLS)
def test_a_script_knows_every_command_and_option(capsys: pytest.CaptureFixture[str], shell: str):
    assert main(["completion", shell]) == 0
    text = capsys.readouterr().out
    for name, command in commands_of(whole_parser()).items():
        assert name in text
        for action in command._actions:
            assert all(option.lstrip("-") in text for option in action.option_strings)
    assert all(format in text for format in FORMATS)


def run(*command: str) -> list[str]:
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    assert done.stderr == ""
    return sorted(done.stdout.splitlines())


@pytest.mark.skipif(shutil.which("bash") is None, reason="needs bash")
def test_bash_completes():
    Path("script").write_text(script("bash"))
    for words, last, expected in CASES:
        assert run("bash", "-c", IN_BASH.format(words=words, last=last)) == expected


@pytest.mark.skipif(shutil.which("fish") is None, reason="needs fish")
def test_fish_completes():
    Path("script").write_text(script("fish"))
    for words, last, expected in CASES:
        rows = run("fish", "--no-config", "-c", f"source script; complete -C '{words} {last}'")
        assert [row.partition("\t")[0] for row in rows] == expected


@pytest.mark.skipif(shutil.which("zsh") is None, reason="needs zsh")
def test_zsh_takes_the_script():
    Path("script").write_text(script("zsh"))
    assert run("zsh", "-n", "script") == []


def test_a_shell_must_be_named(capsys: pytest.CaptureFixture[str]):
    assert main(["completion"]) == 2
    assert "for which shell: bash, zsh or fish?" in capsys.readouterr().err


def test_what_completes_is_in_the_list_of_commands():
    assert tuple(commands_of(whole_parser())) == COMMANDS

"""``preset``: what fails and what informs, before the other keys."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from archlint.cli import main
from archlint.config.settings import ConfigurationError, load
from robot_package import write_files, write_robot

COMMENTED = "x = 1  # archlint: ignore[SRV003]\n"


@pytest.fixture(autouse=True)
def here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A robot whose parameter `rate` is never read (PRM006, information), whose suppression hides nothing (LNT001, a
    warning) and gives no reason (LNT005, a warning)."""
    monkeypatch.chdir(tmp_path)
    write_robot(tmp_path, "<node pkg='robot' exec='talker'/>")
    return write_files(tmp_path, {"robot/__init__.py": "", "robot/more.py": COMMENTED})


def found(folder: Path, capsys: pytest.CaptureFixture[str], configuration: str) -> tuple[int, dict[str, str]]:
    """The exit status, and the severity of each finding by its code."""
    (folder / "archlint.toml").write_text(configuration, "utf-8")
    status = main(["check", "--quiet", "--no-cache", "--format", "json"])
    diagnostics = json.loads(capsys.readouterr().out)["diagnostics"]
    return status, {finding["code"]: finding["severity"] for finding in diagnostics}


@pytest.mark.parametrize(
    ("configuration", "status", "severities"),
    [
        ("", 1, {"LNT001": "warning"}),
        ('preset = "course"', 0, {"LNT001": "info", "PRM006": "info"}),
        ('preset = "team"', 1, {"LNT001": "warning", "LNT005": "warning"}),
        ('preset = "safety"', 1, {"LNT001": "warning", "LNT005": "warning", "PRM006": "warning"}),
    ],
)
def test_what_a_preset_reports(
    here: Path, capsys: pytest.CaptureFixture[str], configuration: str, status: int, severities: dict[str, str]
):
    assert found(here, capsys, configuration) == (status, severities)


def test_other_keys_change_it(here: Path, capsys: pytest.CaptureFixture[str]):
    configuration = 'preset = "safety"\nignore = ["LNT"]\n[severity]\nPRM = "info"\n'
    assert found(here, capsys, configuration) == (0, {"PRM006": "info"})


def test_a_file_that_cannot_be_read_is_no_information(here: Path, capsys: pytest.CaptureFixture[str]):
    write_files(here, {"robot/talker.py": "def broken(:\n"})
    status, severities = found(here, capsys, 'preset = "course"')
    assert status == 1
    assert severities["LNT002"] == "warning"


def test_an_unknown_one_is_an_error(here: Path):
    (here / "archlint.toml").write_text('preset = "teem"', "utf-8")
    with pytest.raises(ConfigurationError, match="one of course, team, safety; did you mean team"):
        load(here)


def test_an_error_fails_in_a_course_too(here: Path, capsys: pytest.CaptureFixture[str]):
    write_files(here, {"launch/it.launch.xml": "<launch><node pkg='robot' exec='tolker'/></launch>"})
    status, severities = found(here, capsys, 'preset = "course"')
    assert status == 1
    assert severities["LCH001"] == "error"

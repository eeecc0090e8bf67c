"""``archlint graph --source-links``."""

from __future__ import annotations

import json
import re
import shutil
from pathlib import Path
from typing import Any

import pytest

from archlint.cli import main

LESSON = Path(__file__).parents[2] / "fixtures" / "lesson"


@pytest.fixture
def workspace(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    for name in ("GITHUB_WORKSPACE", "CI_PROJECT_DIR"):
        monkeypatch.delenv(name, raising=False)
    (tmp_path / ".git").mkdir()
    shutil.copytree(LESSON, tmp_path / "robot")
    monkeypatch.chdir(tmp_path / "robot")
    return tmp_path / "robot"


def link(*words: str) -> dict[str, Any] | None:
    assert main(["graph", "--no-cache", "--isolated", "-o", "g.html", *words]) == 0
    [data] = re.findall(r'id="data">(.*?)</script>', Path("g.html").read_text("utf-8"))
    found: dict[str, Any] | None = json.loads(data)["source_link"]
    return found


def test_places_are_plain_text_unless_asked_for(workspace: Path):
    assert link() is None


@pytest.mark.parametrize(
    ("where", "address"),
    [
        ("vscode", "vscode://file{path}:{line}:{column}"),
        ("file", "file://{path}"),
        ("https://example.org/{file}#L{line}", "https://example.org/{file}#L{line}"),
    ],
)
def test_where_places_may_lead(workspace: Path, where: str, address: str):
    assert link("--source-links", where) == {"address": address, "root": workspace.as_posix(), "folder": "robot"}


@pytest.mark.parametrize(
    ("where", "why"),
    [
        ("javascript://{file}", "is neither vscode nor file"),
        ("emacs", "is neither vscode nor file"),
        ("https://example.org/", "the address needs {file} or {path}"),
        ("https://example.org/{file}/{branch}", "{line}, {column} and {commit} may be in it"),
        ("https://example.org/{commit}/{file}", "{commit} is not known"),
    ],
)
def test_what_is_refused(workspace: Path, where: str, why: str, capsys: pytest.CaptureFixture[str]):
    assert main(["graph", "--isolated", "-o", "g.html", "--source-links", where]) == 2
    assert why in capsys.readouterr().err


def test_no_other_format_has_links(workspace: Path, capsys: pytest.CaptureFixture[str]):
    assert main(["graph", "--isolated", "--source-links", "vscode"]) == 2
    assert "--source-links is for --format html" in capsys.readouterr().err

"""All fixes of all fixtures: what the JSON report offers is what ``--fix`` writes, it compiles, and it holds."""

from __future__ import annotations

import json
import shutil
from pathlib import Path

import pytest

from archlint.cli import main

FIXTURES = sorted(
    path for path in (Path(__file__).parents[2] / "fixtures").iterdir() if path.is_dir() and path.name != "bad_input"
)


@pytest.fixture(params=FIXTURES, ids=lambda path: path.name)
def fixture(request: pytest.FixtureRequest, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    folder = tmp_path / "copy"
    shutil.copytree(request.param, folder, ignore=shutil.ignore_patterns("__pycache__"))
    monkeypatch.chdir(folder)
    return folder


def report(capsys: pytest.CaptureFixture[str]) -> list[dict]:
    capsys.readouterr()
    main(["check", "--format", "json", "--no-cache", "--jobs", "1"])
    return json.loads(capsys.readouterr().out)["diagnostics"]


def texts(folder: Path) -> dict[str, bytes]:
    return {str(path.relative_to(folder)): path.read_bytes() for path in sorted(folder.rglob("*")) if path.is_file()}


def applied(folder: Path, diagnostics: list[dict]) -> dict[str, bytes]:
    """The files with every edit of the report worked in, from the last to the first."""
    found = texts(folder)
    edits = [edit for one in diagnostics if one.get("fix") for edit in one["fix"]["edits"]]
    for edit in sorted(edits, key=lambda edit: (edit["file"], edit["start"], edit["end"]), reverse=True):
        lines = found[edit["file"]].decode().split("\n")
        start, end = (sum(len(line) + 1 for line in lines[: line - 1]) + column - 1 for line, column in
                      (edit["start"], edit["end"]))  # fmt: skip
        text = "\n".join(lines)
        found[edit["file"]] = (text[:start] + edit["text"] + text[end:]).encode()
    return found


def test_the_edits_of_the_report_are_what_is_written(fixture: Path, capsys: pytest.CaptureFixture[str]):
    before = texts(fixture)
    diagnostics = report(capsys)
    expected = applied(fixture, diagnostics)
    main(["check", "--fix", "--unsafe-fixes", "--no-cache", "--jobs", "1"])

    after = texts(fixture)
    assert after == expected
    for name in after:
        if after[name] != before[name] and name.endswith(".py"):
            compile(after[name], name, "exec")
    left = report(capsys)
    assert not [one for one in left if one.get("fix")]
    fixed = {(one["code"], one["file"]) for one in diagnostics if one.get("fix")}
    counts = {key: sum((one["code"], one["file"]) == key for one in diagnostics) for key in fixed}
    assert all(sum((one["code"], one["file"]) == key for one in left) < counts[key] for key in fixed)

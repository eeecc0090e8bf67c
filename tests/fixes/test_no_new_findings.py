"""Every fix that is offered for a page of the rule book or a fixture mends its finding, and makes no other one."""

from __future__ import annotations

import shutil
from collections import Counter
from dataclasses import replace
from pathlib import Path

import pytest

from archlint.config.settings import load
from archlint.engine.pipeline import Request, check
from archlint.finding import Finding
from archlint.fixes.apply import apply, write
from archlint.testing.pages import Example, load_examples

ROOT = Path(__file__).parents[2]
BAD = [example for example in load_examples(ROOT / "rules") if example.section == "bad"]
FIXTURES = sorted(
    path for path in (ROOT / "fixtures").iterdir() if any(path.rglob("*.py")) and path.name != "bad_input"
)
DISTROS = (None, "jazzy", "rolling")


@pytest.mark.parametrize("distro", DISTROS, ids=str)
@pytest.mark.parametrize("example", BAD, ids=lambda example: example.id)
def test_a_fix_of_a_page(example: Example, distro: str | None, tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    example.write(tmp_path / "before")
    each_fix_alone(tmp_path, distro, monkeypatch)


@pytest.mark.parametrize("fixture", FIXTURES, ids=lambda path: path.name)
def test_a_fix_of_a_fixture(fixture: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    shutil.copytree(fixture, tmp_path / "before", ignore=shutil.ignore_patterns("__pycache__"))
    each_fix_alone(tmp_path, "jazzy", monkeypatch)


def each_fix_alone(folder: Path, distro: str | None, monkeypatch: pytest.MonkeyPatch) -> None:
    """Apply each fix to a copy of its own, then all that a user can ask for at once."""
    before = judged(folder / "before", distro, monkeypatch)
    fixed = [one for one in before if one.fix is not None]
    for number, chosen in enumerate([[one] for one in fixed] + ([fixed] if len(fixed) > 1 else [])):
        copy = folder / f"after{number}"
        shutil.copytree(folder / "before", copy)
        monkeypatch.chdir(copy)
        outcome = apply(chosen)
        write(outcome)
        after = judged(copy, distro, monkeypatch)
        made = counted(after) - counted(before)
        assert not made, f"{[one.code for one in chosen]} made {dict(made)}"
        assert len(after) < len(before) or not outcome.fixed


def judged(folder: Path, distro: str | None, monkeypatch: pytest.MonkeyPatch) -> list[Finding]:
    monkeypatch.chdir(folder)
    settings = load(folder)
    settings = settings if distro is None else replace(settings, distro=distro)
    return check(Request((".",), settings, cached=False, jobs=1)).findings


def counted(findings: list[Finding]) -> Counter[tuple[str, str]]:
    return Counter((one.code, one.place.file) for one in findings)


@pytest.mark.parametrize("code", ["NME001", "PKG001", "TMO001", "TMO002", "TMO003"])
def test_these_pages_have_something_to_fix(code: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    offered = []
    for number, example in enumerate(one for one in BAD if one.page_code == code):
        example.write(tmp_path / str(number))
        offered += [one for one in judged(tmp_path / str(number), "jazzy", monkeypatch) if one.code == code and one.fix]
    assert offered

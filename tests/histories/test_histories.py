"""Faults from histories: the commit before a fix is checked, and its rules must name the file."""

from __future__ import annotations

import os
import subprocess
from collections import Counter
from pathlib import Path

import pytest
from benchmarks.histories.__main__ import archlint, files, judged
from benchmarks.histories.parents import clone_of, export_parent
from benchmarks.histories.table import Bug, Verdict, read

BEFORE = "import rclpy\n\nrclpy.init()\nnode = rclpy.create_node('Bad name')\nrclpy.spin(node)\n"
BUG = Bug("team/robot", "", "talker.py", 4, "name", "a node name with a blank", Verdict.DEFAULT, ("NME002",), "")


@pytest.fixture
def clones(tmp_path: Path) -> Path:
    """A folder with one clone whose second commit repairs a node's name."""
    clone = tmp_path / "clones" / "team+robot"
    clone.mkdir(parents=True)
    git(clone, "init", "-q")
    for text in (BEFORE, BEFORE.replace("Bad name", "good_name")):
        (clone / "talker.py").write_text(text, "utf-8")
        git(clone, "add", "-A")
        git(clone, "commit", "-q", "-m", "talker")
    return clone.parent


def git(folder: Path, *words: str) -> str:
    who = {f"GIT_{role}_{what}": "a@b.c" for role in ("AUTHOR", "COMMITTER") for what in ("NAME", "EMAIL")}
    done = subprocess.run(
        ["git", *words], cwd=folder, env={**os.environ, **who}, capture_output=True, text=True, check=True
    )
    return done.stdout.strip()


def test_the_commit_before_the_fix_is_told(clones: Path, tmp_path: Path):
    clone = clone_of("team/robot", clones)
    assert clone is not None
    assert export_parent(clone, git(clone, "rev-parse", "HEAD"), tmp_path / "parent")
    findings = archlint(tmp_path / "parent")
    assert judged(BUG, findings, {"NME002"}) is Verdict.DEFAULT
    assert judged(BUG, findings, set()) is Verdict.OPT_IN


def test_the_fix_itself_is_silent(clones: Path):
    assert judged(BUG, archlint(clones / "team+robot"), {"NME002"}) is Verdict.SILENT


def test_a_clone_or_commit_that_is_not_there(clones: Path, tmp_path: Path):
    assert clone_of("team/other", clones) is None
    assert not export_parent(clones / "team+robot", "0" * 40, tmp_path / "parent")


def test_a_finding_names_the_files_of_its_fix_and_of_its_other_places():
    edit = {"file": "package.xml", "start": [1, 1], "end": [1, 1], "text": ""}
    finding = {"file": "a.py", "related": [{"file": "b.py"}], "fix": {"safety": "safe", "edits": [edit]}}
    assert files(finding) == {"a.py", "b.py", "package.xml"}
    assert files({"file": "a.py", "related": [], "fix": None}) == {"a.py"}


def test_each_row_of_the_table_says_how_it_was_judged():
    bugs = read()
    assert len(bugs) == len({(bug.repository, bug.fix, bug.file, bug.line, bug.description) for bug in bugs})
    assert max(Counter(bug.repository for bug in bugs).values()) <= 4
    for bug in bugs:
        assert len(bug.fix) == 40, bug
        assert bool(bug.rules) == (bug.verdict is not Verdict.SILENT), bug
        assert bool(bug.why) == (bug.verdict in (Verdict.SILENT, Verdict.PART)), bug


def test_a_clone_that_lacks_a_large_file_gives_the_others(clones: Path, tmp_path: Path):
    clone = clones / "team+robot"
    (clone / "mesh.dae").write_text("large", "utf-8")
    git(clone, "add", "-A")
    git(clone, "commit", "-q", "-m", "mesh")
    key = git(clone, "rev-parse", "HEAD:mesh.dae")
    git(clone, "commit", "-q", "--allow-empty", "-m", "fix")
    (clone / ".git" / "objects" / key[:2] / key[2:]).unlink()
    assert export_parent(clone, git(clone, "rev-parse", "HEAD"), tmp_path / "parent")
    assert [path.name for path in (tmp_path / "parent").iterdir()] == ["talker.py"]

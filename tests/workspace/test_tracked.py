"""The index of a repository: what is written of one is what is read of it."""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path

import pytest

from archlint.workspace.tracked import Tracked, index_of, paths_of_index

PATHS = [b"a", b"long/" + b"x" * 5000, b"src/robot/node.py", b"src/robot/\xe9.py"]


def test_a_written_index_has_its_paths():
    assert paths_of_index(index_of(PATHS[::-1])) == sorted(PATHS)


def test_of_a_cut_index_nothing_is_taken():
    assert paths_of_index(index_of(PATHS)[:-20]) == []


def test_a_folder_is_tracked_where_a_file_in_it_is(tmp_path):
    (tmp_path / ".git").mkdir()
    (tmp_path / ".git" / "index").write_bytes(index_of(PATHS))
    tracked = Tracked(str(tmp_path))
    assert tracked.has(str(tmp_path / "src" / "robot"), is_folder=True)
    assert not tracked.has(str(tmp_path / "src" / "robo"), is_folder=True)
    assert not tracked.has(str(tmp_path / "src" / "robot"))


@pytest.mark.skipif(shutil.which("git") is None, reason="needs git")
def test_an_index_with_names_of_sha_256_is_read(tmp_path: Path):
    (tmp_path / "node.py").write_text("")
    for arguments in (["init", "-q", "--object-format=sha256"], ["add", "."]):
        subprocess.run(["git", "-C", str(tmp_path), *arguments], check=True)
    assert Tracked(str(tmp_path)).has(str(tmp_path / "node.py"))


@pytest.mark.skipif(shutil.which("git") is None, reason="needs git")
def test_what_a_checkout_never_had_is_told_from_what_is_deleted(tmp_path: Path):
    """A commit of which one file is checked out, one is deleted by hand, and one is left out, as a sparse checkout."""
    git = ["git", "-C", str(tmp_path), "-c", "user.name=A", "-c", "user.email=a@example.org"]
    for name in ("here.py", "deleted.py", "films/far.mp4", "films/near.mp4", "skipped.mp4"):
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text(name)
    for arguments in (["init", "-q"], ["add", "."], ["commit", "-qm", "all"], ["rm", "-q", "-r", "--cached", "films"]):
        subprocess.run([*git, *arguments], check=True)
    (tmp_path / "films" / "far.mp4").unlink()
    subprocess.run([*git, "reset", "-q", "HEAD", "films"], check=True)  # lists the films again, and writes none
    subprocess.run([*git, "update-index", "--skip-worktree", "skipped.mp4"], check=True)
    (tmp_path / "skipped.mp4").unlink()
    (tmp_path / "deleted.py").unlink()
    tracked = Tracked(str(tmp_path))
    assert tracked.has_elsewhere(str(tmp_path / "films" / "far.mp4"))
    assert tracked.has_elsewhere(str(tmp_path / "films"))
    assert tracked.has_elsewhere(str(tmp_path / "skipped.mp4"))
    assert not tracked.has_elsewhere(str(tmp_path / "here.py"))
    assert not tracked.has_elsewhere(str(tmp_path / "deleted.py"))

"""Revisions that are made to hurt whoever reads them: each ends, within bounds, with a reason."""

from __future__ import annotations

import os
import subprocess
from collections.abc import Sequence
from pathlib import Path

import pytest

from archlint.engine import git, old_tree
from archlint.engine.git import GitError, Repository
from archlint.engine.old_tree import OldTree


def run(folder: Path, *words: str, given: bytes = b"") -> str:
    settings = ("-c", "user.name=Kim", "-c", "user.email=kim@example.com")
    said = subprocess.run(["git", *settings, *words], cwd=folder, input=given, capture_output=True, check=True)
    return said.stdout.decode().strip()


def blob(folder: Path, data: bytes) -> str:
    return run(folder, "hash-object", "-w", "--stdin", given=data)


def tree(folder: Path, rows: Sequence[tuple[str, str, str]]) -> str:
    """A folder of a revision: mode, name and object of what is in it."""
    data = b"".join(f"{mode} {name}\0".encode() + bytes.fromhex(given) for mode, name, given in rows)
    return run(folder, "hash-object", "-t", "tree", "-w", "--stdin", given=data)


def commit(folder: Path, given: str) -> str:
    return run(folder, "commit-tree", given, "-m", "a revision")


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    work = tmp_path / "work"
    work.mkdir()
    run(work, "init", "--quiet")
    return work


def paths(folder: Path, revision: str) -> list[str]:
    return [entry.path for entry in Repository(str(folder)).tree(revision)]


def write(folder: Path, revision: str) -> list[str]:
    """The files that are written for a revision, git's own left out."""
    base = folder.parent / "base"
    old = OldTree(str(base))
    old.write(Repository(str(folder)), revision)
    top = Path(old.place(str(folder)))
    written = [path.relative_to(top) for path in top.rglob("*") if path.is_file()]
    return sorted(str(path) for path in written if path.parts[0] != ".git")


def test_what_lies_too_deep_is_left_out_and_the_rest_is_there(folder: Path):
    text = blob(folder, b"x = 1\n")
    below = tree(folder, [("100644", "low.py", text)])
    for _ in range(3 * git.DEEPEST):
        below = tree(folder, [("40000", "a", below)])
    top = tree(folder, [("40000", "a", below), ("100644", "node.py", text)])
    assert write(folder, commit(folder, top)) == ["node.py"]


def test_a_few_folders_that_name_each_other_often_are_too_many_files(folder: Path, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setattr(git, "MOST_FILES", 1000)
    below = tree(folder, [("100644", "node.py", blob(folder, b"x = 1\n"))])
    for _ in range(3):
        below = tree(folder, [("40000", f"d{number}", below) for number in range(10)])
    assert len(paths(folder, commit(folder, below))) == 1000
    below = tree(folder, [("40000", f"d{number}", below) for number in range(10)])
    with pytest.raises(GitError, match="the revision has more than 1,000 files"):
        paths(folder, commit(folder, below))


def test_one_large_file_that_is_named_often_fills_no_disk(folder: Path, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setattr(old_tree, "_MOST_IN_ALL", 10_000)
    text = blob(folder, b"#" * 3_000)
    few = tree(folder, [("100644", f"n{number}.py", text) for number in range(3)])
    assert len(write(folder, commit(folder, few))) == 3
    many = tree(folder, [("100644", f"n{number}.py", text) for number in range(4)])
    with pytest.raises(GitError, match="the files of the revision have more than"):
        write(folder, commit(folder, many))


def test_a_tree_that_is_none_is_an_error(folder: Path):
    broken = tree(folder, [("40000", "a", blob(folder, b"no tree"))])
    with pytest.raises(GitError, match="git fsck"):
        paths(folder, commit(folder, broken))


def test_submodules_whose_links_lead_back_are_written_once(folder: Path, monkeypatch: pytest.MonkeyPatch):
    revision = commit(folder, tree(folder, [("100644", "node.py", blob(folder, b"x = 1\n"))]))
    for name in ("a", "b"):
        (folder / name).symlink_to(".")
    for _ in range(12):  # twice as often with each: 4,096 times
        revision = commit(folder, tree(folder, [("160000", "a", revision), ("160000", "b", revision)]))
    asked = 0
    files = OldTree._files

    def counted(self: OldTree, repository: Repository, given: str) -> list[tuple[str, str]]:
        nonlocal asked
        asked += 1
        return files(self, repository, given)

    monkeypatch.setattr(OldTree, "_files", counted)
    write(folder, revision)
    assert asked == 1


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="there are no pipes here")
def test_a_pipe_in_the_place_of_a_file_of_git_is_not_waited_for(folder: Path, monkeypatch: pytest.MonkeyPatch):
    (folder / ".git/HEAD").unlink()
    os.mkfifo(folder / ".git/HEAD")
    monkeypatch.setattr(git, "_PATIENCE", 0.2)
    with pytest.raises(GitError, match="git has not answered"):
        Repository(str(folder)).commit("HEAD")

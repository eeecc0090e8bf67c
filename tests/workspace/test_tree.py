"""What a tree on the disk lists."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from archlint.workspace import tree
from archlint.workspace.tree import SourceTree


def test_what_programs_keep_in_a_cache_is_not_listed(tmp_path: Path) -> None:
    for path in ("a.txt", "kept/CACHEDIR.TAG", "kept/1/b.txt", "other/c.txt"):
        (tmp_path / path).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / path).touch()
    assert SourceTree(tmp_path).files_below(".") == ["a.txt", "other/c.txt"]


def test_what_lies_beside_the_folders_that_were_asked_for_is_not_there(tmp_path: Path) -> None:
    """What two of them share may be the folder of a user, or of the whole machine."""
    for path in ("arm/package.xml", "private/notes.txt", "src/base/a.txt", "src/b.txt", "c.txt"):
        (tmp_path / path).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / path).write_text("text")
    files = SourceTree(tmp_path, inside=[str(tmp_path / "arm"), str(tmp_path / "src" / "base")])
    assert files.files_below(".") == ["arm/package.xml", "src/base/a.txt"]
    assert files.text("arm/package.xml") == "text"
    assert files.text("private/notes.txt") is None
    assert files.text("c.txt") is None


def test_a_file_is_read_again_only_where_it_has_changed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    reads = []
    read = tree.read_regular
    monkeypatch.setattr(tree, "read_regular", lambda path, limit: (reads.append(Path(path).name), read(path, limit))[1])
    (tmp_path / "a.txt").write_text("first")
    files = SourceTree(tmp_path)
    assert [files.text("a.txt"), files.text("a.txt"), files.text("./a.txt")] == ["first"] * 3
    assert reads == ["a.txt", "a.txt"]  # once for each way to say where it is
    answers = dict(files.asked)
    (tmp_path / "a.txt").write_text("other")
    os.utime(tmp_path / "a.txt", ns=(1, 1))
    assert files.text("a.txt") == "other"
    assert files.asked == answers  # what was said first is what all that is kept goes by
    (tmp_path / "a.txt").unlink()
    assert files.text("a.txt") is None
    assert len(reads) == 3


def test_a_link_that_leads_elsewhere_is_followed_anew(tmp_path: Path) -> None:
    (tmp_path / "inside").mkdir()
    (tmp_path / "inside" / "a.txt").write_text("same")
    (tmp_path / "secret.txt").write_text("same")
    link = tmp_path / "inside" / "link.txt"
    link.symlink_to("a.txt")
    files = SourceTree(tmp_path / "inside")
    assert files.text("link.txt") == "same"
    link.unlink()
    link.symlink_to("../secret.txt")
    assert files.text("link.txt") is None


def test_no_more_is_remembered_than_so_much(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(tree, "_REMEMBERED", 25)
    files = SourceTree(tmp_path)
    for name in "abcd":
        (tmp_path / name).write_text(name * 10)
    assert [files.text(name) for name in "abcdabcd"] == [name * 10 for name in "abcdabcd"]
    assert files._read._size <= 25

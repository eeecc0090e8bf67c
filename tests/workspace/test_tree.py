"""What a tree on the disk lists."""

from __future__ import annotations

from pathlib import Path

from archlint.workspace.tree import SourceTree


def test_what_programs_keep_in_a_cache_is_not_listed(tmp_path: Path) -> None:
    for path in ("a.txt", "kept/CACHEDIR.TAG", "kept/1/b.txt", "other/c.txt"):
        (tmp_path / path).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / path).touch()
    assert SourceTree(tmp_path).files_below(".") == ["a.txt", "other/c.txt"]

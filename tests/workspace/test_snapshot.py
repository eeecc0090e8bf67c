"""A tree that is not on the disk answers as one that is."""

from __future__ import annotations

import errno
from pathlib import Path

import pytest

from archlint.workspace.snapshot import TOO_LARGE, Entry, Snapshot
from archlint.workspace.tree import SourceTree

TEXTS = {
    "robot/package.xml": b"<package/>",
    "robot/config/values.yaml": b"a: 1\n",
    "robot/config/latin.yaml": b"name: J\xfcrgen\n",
    "robot/config/latin.xml": b"<?xml version='1.0' encoding='iso-8859-1'?><a>\xfc</a>",
    "robot/.hidden/a.txt": b"",
    "robot/a.txt": b"",
}
LINKS = {
    "robot/link.yaml": "robot/config/values.yaml",
    "robot/again.yaml": "robot/link.yaml",
    "robot/linked": "robot/config/",
    "robot/loop": "robot/loop",
}
ASKED = [
    *TEXTS,
    *LINKS,
    "robot",
    "robot/",
    ".",
    "robot/empty",
    "robot/linked/values.yaml",
    "robot/linked/nothing.yaml",
    "robot/../robot/a.txt",
    "../outside.txt",
    "/etc/hostname",
    "robot/nul\0.txt",
    "robot/a.txt/b",
]


@pytest.fixture
def trees(tmp_path: Path) -> tuple[SourceTree, Snapshot]:
    """The same files on the disk and written down."""
    for path, data in TEXTS.items():
        (tmp_path / path).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / path).write_bytes(data)
    for path, target in LINKS.items():
        (tmp_path / path).symlink_to(tmp_path / target)
    (tmp_path / "robot/empty").mkdir()
    entries = {path: Entry(data) for path, data in TEXTS.items()} | {path: Entry(link=to) for path, to in LINKS.items()}
    entries["robot/loop"] = Entry(link="")
    return SourceTree(tmp_path), Snapshot(tmp_path, entries, ["robot/empty"])


@pytest.mark.parametrize("path", ASKED)
def test_a_snapshot_answers_as_the_disk(trees: tuple[SourceTree, Snapshot], path: str) -> None:
    disk, snapshot = trees
    assert snapshot.text(path) == disk.text(path)
    assert snapshot.unreadable(path) == disk.unreadable(path)
    assert (snapshot.is_file(path), snapshot.is_folder(path)) == (disk.is_file(path), disk.is_folder(path))


@pytest.mark.parametrize("folder", [".", "robot", "robot/linked", "robot/config", "robot/.hidden", "robot/empty", ".."])
def test_a_snapshot_lists_what_the_disk_lists(trees: tuple[SourceTree, Snapshot], folder: str) -> None:
    disk, snapshot = trees
    assert snapshot.files_below(folder) == disk.files_below(folder)


def test_what_was_left_out_is_noted_when_it_is_asked_for(tmp_path: Path) -> None:
    snapshot = Snapshot(tmp_path, {"mesh.dae": Entry(), "big.yaml": Entry(errno=TOO_LARGE)})
    assert snapshot.is_file("mesh.dae")
    assert not snapshot.missed
    assert snapshot.text("mesh.dae") is None
    assert list(snapshot.missed) == ["mesh.dae"]
    assert "too large" in (snapshot.unreadable("big.yaml") or "")


def test_a_file_that_could_not_be_read_still_cannot(tmp_path: Path) -> None:
    snapshot = Snapshot(tmp_path, {"a.yaml": Entry(errno=errno.EACCES)})
    assert snapshot.text("a.yaml") is None
    assert snapshot.unreadable("a.yaml") == "cannot read this file: Permission denied"


def test_the_folder_of_a_file_is_no_file_of_the_machine(tmp_path: Path) -> None:
    (tmp_path / "a.txt").write_text("on the disk")
    assert Snapshot(tmp_path, {}).text("a.txt") is None

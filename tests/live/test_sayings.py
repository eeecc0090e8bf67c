"""What an edit of a Python file changes for an analysis."""

from __future__ import annotations

from pathlib import Path

import pytest

from archlint.live.buffers import Buffer
from archlint.live.readable import LastReadable
from archlint.live.sayings import Change, change_of
from archlint.live.store import LiveStore
from archlint.live.tree import LiveTree
from archlint.syntax.cache import NullStore
from archlint.workspace.model import SourceFile

CODE = "import rclpy\n\nrclpy.init()\nnumber = 1\n"


def changed_by(edited: str, folder: Path, looked_for: str = "") -> Change:
    path = str(folder / "code.py")
    store = LiveStore(NullStore())
    trees = []
    for text in (CODE, edited):
        held = {path: Buffer(text.encode())}
        LastReadable(store).of(held)  # compiles it
        trees.append(LiveTree(folder, folder, {path: text.encode()}))
    if looked_for:
        trees[0].words.stand_in("code.py", looked_for)
    return change_of([SourceFile(path, "code.py", "python", None, None)], trees[0], trees[1], store)


@pytest.mark.parametrize(
    ("edited", "change"),
    [
        (f"{CODE}# the end\n", Change.NOTHING),
        (CODE.replace("number = 1", "number = 1  # one"), Change.NOTHING),
        (f"# the start\n{CODE}", Change.PLACES),
        (CODE.replace("number = 1", "number  =  1"), Change.PLACES),
        (CODE.replace("number = 1", "number = 1.0"), Change.MORE),
        (CODE.replace("number = 1", "number = True"), Change.MORE),
        (CODE.replace("number", "another"), Change.MORE),
        (f"{CODE}x = 1\n", Change.MORE),
        (f"# archlint: ignore-file[NME001] why not\n{CODE}", Change.MORE),
        ("number = 1\n", Change.MORE),
    ],
)
def test_an_edit_changes_nothing_places_or_more(edited: str, change: Change, tmp_path: Path) -> None:
    assert changed_by(edited, tmp_path) is change


def test_a_word_that_was_looked_for_is_more(tmp_path: Path) -> None:
    assert changed_by(f"{CODE}# the end\n", tmp_path, looked_for="start") is Change.NOTHING
    assert changed_by(f"{CODE}# the end\n", tmp_path, looked_for="end") is Change.MORE

"""Generated pages on the disk: nothing of the user's is touched."""

from __future__ import annotations

from pathlib import Path

import pytest

from archlint.engine.page_files import NotOurs, Stale, bring_up_to_date, stale
from archlint.render.pages import MARK

PAGES = {"README.md": f"{MARK}\n\nall\n", "nodes/driver.md": f"{MARK}\n\ndriver\n"}
NOTHING = Stale((), (), ())


def test_pages_are_written_once(tmp_path: Path):
    assert bring_up_to_date(tmp_path / "docs", PAGES) == Stale((), ("README.md", "nodes/driver.md"), ())
    assert (tmp_path / "docs/nodes/driver.md").read_text() == PAGES["nodes/driver.md"]
    assert bring_up_to_date(tmp_path / "docs", PAGES) == NOTHING


def test_what_is_stale(tmp_path: Path):
    bring_up_to_date(tmp_path, {**PAGES, "nodes/gone.md": f"{MARK}\n\ngone\n"})
    (tmp_path / "README.md").write_text(f"{MARK}\n\nby hand\n")
    (tmp_path / "nodes/driver.md").unlink()
    assert stale(tmp_path, PAGES) == Stale(("README.md",), ("nodes/driver.md",), ("nodes/gone.md",))
    assert (tmp_path / "nodes/gone.md").exists()
    bring_up_to_date(tmp_path, PAGES)
    assert stale(tmp_path, PAGES) == NOTHING
    assert not (tmp_path / "nodes/gone.md").exists()


def test_a_page_of_the_user_is_in_the_way(tmp_path: Path):
    (tmp_path / "README.md").write_text("# My robot\n")
    with pytest.raises(NotOurs, match=r"README\.md was not written by `archlint docs`"):
        bring_up_to_date(tmp_path, PAGES)
    assert (tmp_path / "README.md").read_text() == "# My robot\n"
    assert not (tmp_path / "nodes").exists()  # nothing is done by halves


def test_a_page_of_the_user_beside_ours_stays(tmp_path: Path):
    bring_up_to_date(tmp_path, PAGES)
    (tmp_path / "nodes/mine.md").write_text(f"# Mine\n\n{MARK}\n")
    (tmp_path / "nodes/picture.svg").write_text(MARK)
    assert bring_up_to_date(tmp_path, PAGES) == NOTHING
    assert (tmp_path / "nodes/mine.md").exists()
    assert (tmp_path / "nodes/picture.svg").exists()


def test_a_link_is_never_written_through(tmp_path: Path):
    target = tmp_path / "elsewhere.md"
    target.write_text(f"{MARK}\n\nelsewhere\n")
    (tmp_path / "docs").mkdir()
    (tmp_path / "docs/README.md").symlink_to(target)
    with pytest.raises(NotOurs):
        bring_up_to_date(tmp_path / "docs", PAGES)
    assert target.read_text() == f"{MARK}\n\nelsewhere\n"


def test_a_folder_that_is_a_link_is_not_cleaned_up(tmp_path: Path):
    outside = tmp_path / "outside"
    bring_up_to_date(outside, PAGES)
    (tmp_path / "docs").mkdir()
    (tmp_path / "docs/linked").symlink_to(outside, target_is_directory=True)
    bring_up_to_date(tmp_path / "docs", PAGES)
    assert stale(outside, PAGES) == NOTHING

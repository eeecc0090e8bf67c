"""The key that signs cache entries: the user's alone, outside of what is checked, or none at all."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from archlint.syntax.secret import KEY_BYTES, user_key

pytestmark = pytest.mark.skipif(os.name == "nt", reason="permissions of POSIX")


@pytest.fixture(autouse=True)
def home(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path / "config"))
    return tmp_path / "config"


@pytest.fixture
def workspace(tmp_path: Path) -> str:
    (tmp_path / "workspace").mkdir()
    return str(tmp_path / "workspace")


def test_the_key_is_made_once_and_is_for_its_user_alone(home: Path, workspace: str):
    key = user_key([workspace])
    assert key is not None
    assert len(key) == KEY_BYTES
    assert user_key([workspace]) == key
    assert [path.name for path in (home / "archlint").iterdir()] == ["cache.key"]
    assert (home / "archlint/cache.key").stat().st_mode & 0o777 == 0o600
    assert (home / "archlint").stat().st_mode & 0o777 == 0o700


def test_a_key_below_what_is_checked_is_no_secret(home: Path, tmp_path: Path, workspace: str):
    assert user_key([workspace]) is not None
    assert user_key([workspace, str(tmp_path)]) is None
    assert user_key([str(home)]) is None


def test_without_a_folder_of_its_own_the_key_lies_in_the_home(
    tmp_path: Path, workspace: str, monkeypatch: pytest.MonkeyPatch
):
    monkeypatch.delenv("XDG_CONFIG_HOME")
    monkeypatch.setenv("HOME", str(tmp_path / "me"))
    assert user_key([workspace]) is not None
    assert (tmp_path / "me/.config/archlint/cache.key").is_file()


@pytest.mark.parametrize(
    "spoil",
    [
        lambda folder: (folder / "cache.key").chmod(0o644),
        lambda folder: (folder / "cache.key").write_bytes(b"short"),
        lambda folder: (folder / "cache.key").write_bytes(b"l" * 100),
        lambda folder: ((folder / "cache.key").rename(folder / "x"), (folder / "cache.key").symlink_to("x")),
        lambda folder: ((folder / "cache.key").unlink(), os.mkfifo(folder / "cache.key", 0o600)),
        lambda folder: folder.chmod(0o777),
    ],
    ids=["others may read it", "short", "long", "a link", "a pipe", "others may replace it"],
)
def test_a_key_that_others_could_know_or_make_does_not_count(home: Path, workspace: str, spoil):
    user_key([workspace])
    spoil(home / "archlint")
    assert user_key([workspace]) is None


def test_where_no_key_can_be_kept_there_is_none(home: Path, workspace: str):
    home.write_text("a file, not a folder")
    assert user_key([workspace]) is None

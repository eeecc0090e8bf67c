"""Files of a foreign folder are read and written without waiting, without end and without going elsewhere."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from archlint import disk
from archlint.cli import console
from archlint.cli.exits import UsageError
from archlint.disk import read_regular, replace_file
from archlint.fixes import Surroundings
from archlint.fixes.source import Source, read

posix = pytest.mark.skipif(os.name == "nt", reason="pipes, links and permissions of POSIX")


def test_a_regular_file_is_read_whole_up_to_the_limit(tmp_path: Path):
    path = tmp_path / "a"
    path.write_bytes(b"12345")

    assert read_regular(path, 5) == b"12345"
    with pytest.raises(OSError, match="too large"):
        read_regular(path, 4)


@posix
def test_a_pipe_a_device_a_folder_and_a_name_that_is_none_are_refused_at_once(tmp_path: Path):
    os.mkfifo(tmp_path / "pipe")
    (tmp_path / "zero").symlink_to("/dev/zero")
    for name in ("pipe", "zero", ".", "no\0name", "nowhere"):
        with pytest.raises(OSError):
            read_regular(f"{tmp_path}/{name}", 100)


@posix
def test_a_fix_looks_for_names_beside_a_pipe_and_an_endless_link(tmp_path: Path):
    os.mkfifo(tmp_path / "pipe.py")
    (tmp_path / "zero.py").symlink_to("/dev/zero")
    (tmp_path / "other.py").write_text("taken = 1\n")
    (tmp_path / "node.py").write_text("x = 1\n")
    around = Surroundings([str(path) for path in tmp_path.glob("*.py")])
    source = around.source(str(tmp_path / "node.py"))
    assert isinstance(source, Source)

    assert around.elsewhere(source) == ["taken = 1\n"]
    assert read(str(tmp_path / "pipe.py")) is None


@posix
def test_a_link_that_waits_under_the_temporary_name_is_not_written_through(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
):
    monkeypatch.setattr(disk.os, "urandom", lambda size: b"known")
    victim = tmp_path / "victim"
    victim.write_text("precious")
    (tmp_path / ".out.json.6b6e6f776e.tmp").symlink_to(victim)

    with pytest.raises(FileExistsError):
        replace_file(tmp_path / "out.json", b"new")
    assert victim.read_text() == "precious"


def test_two_writes_never_choose_the_same_temporary_name(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    names: list[str] = []
    replace = os.replace

    def noted(source, target):
        names.append(str(source))
        replace(source, target)

    monkeypatch.setattr(disk.os, "replace", noted)
    for text in (b"one", b"two"):
        replace_file(tmp_path / "out.json", text)

    assert len(set(names)) == 2
    assert [path.name for path in tmp_path.iterdir()] == ["out.json"]
    assert (tmp_path / "out.json").read_bytes() == b"two"


@posix
def test_a_file_keeps_its_permissions_and_a_new_one_has_those_that_the_user_set(tmp_path: Path):
    script = tmp_path / "script"
    script.write_text("old")
    script.chmod(0o750)
    mask = os.umask(0o027)
    try:
        replace_file(script, b"new", script.stat())
        console.write("new", str(tmp_path / "report"))
    finally:
        os.umask(mask)

    assert script.stat().st_mode & 0o777 == 0o750
    assert (tmp_path / "report").stat().st_mode & 0o777 == 0o640


@posix
def test_an_output_that_is_a_link_to_itself_is_an_error_of_the_user(tmp_path: Path):
    (tmp_path / "loop").symlink_to("loop")
    with pytest.raises(UsageError, match="cannot write"):
        console.write("text", str(tmp_path / "loop"))

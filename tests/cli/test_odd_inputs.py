"""Whatever stands at a path: the exit status of the contract, and one line that says why nothing is checked."""

from __future__ import annotations

import os
import sqlite3
import zipfile
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from archlint.cli import main
from archlint.report import FORMATS
from robot_package import manifest, write_files

posix = pytest.mark.skipif(os.name == "nt", reason="links and file names of POSIX")

NODE = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.create_publisher(String, 'bad name', 10)


def main():
    rclpy.init()
    rclpy.spin(Talker())
"""
NOTHING = "no package.xml, no Python or C++ file and no launch file"
LEVELS = 1_000

Say = Callable[..., tuple[int, str, str]]


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    return tmp_path


@pytest.fixture
def say(folder: Path, capsys: pytest.CaptureFixture[str]) -> Say:
    def run(*words: str) -> tuple[int, str, str]:
        status = main([*words])
        return (status, *capsys.readouterr())

    return run


# ------------------------------------------------------------------------------------------- no workspace


def _archive(path: Path) -> None:
    with zipfile.ZipFile(path, "w") as archive:
        archive.writestr("package.xml", manifest("talker"))
        archive.writestr("talker/node.py", NODE)


def _recording(path: Path) -> None:
    with sqlite3.connect(path) as database:
        database.execute("create table topics(id integer, name text)")


def _bag(path: Path) -> None:
    path.mkdir()
    _recording(path / "bag_0.db3")
    (path / "metadata.yaml").write_text("rosbag2_bagfile_information:\n  version: 5\n")


@pytest.mark.parametrize(
    ("name", "make", "there"),
    [
        ("workspace.zip", _archive, "there is 1 .zip file"),
        ("bag.db3", _recording, "there is 1 .db3 file"),
        ("bag", _bag, "there are 1 .db3, 1 .yaml files"),
        ("package.xml", Path.mkdir, "there is no file at all"),
    ],
    ids=["an archive with a package", "a recording", "the folder of a bag", "a folder named package.xml"],
)
def test_what_is_no_workspace_is_told(folder: Path, say: Say, name: str, make: Callable[[Path], None], there: str):
    make(folder / name)
    status, output, error = say("check", name)
    assert (status, output) == (2, "")
    assert error == f"archlint: error: nothing to check in {name}: {NOTHING}; {there}\n"


@posix
def test_a_link_that_leads_to_itself_is_told(folder: Path, say: Say):
    (folder / "loop").symlink_to("loop")
    assert say("check", "loop") == (2, "", "archlint: error: loop is a symbolic link that leads nowhere\n")


def test_a_folder_that_is_named_as_a_file_is_a_folder(folder: Path, say: Say):
    write_files(folder, {"x.py/node.py": NODE})
    for path in (".", "x.py"):
        status, output, _ = say("check", path, "--format", "concise")
        assert (status, output.count("NME002")) == (1, 1)


# ------------------------------------------------------------------------------------------------ too deep


@pytest.fixture
def deep(folder: Path) -> Iterator[str]:
    """A folder with nothing but the next one, 1,000 times, and a text at the end.  pytest could not remove it."""
    levels = ["/".join(["d"] * level) for level in range(1, LEVELS + 1)]
    os.makedirs(levels[99])
    for level in levels[100:]:
        os.mkdir(level)
    (folder / levels[-1] / "a.txt").write_text("")
    yield levels[-1]
    for name in os.listdir(levels[-1]):
        os.unlink(f"{levels[-1]}/{name}")
    for level in reversed(levels):
        os.rmdir(level)


@pytest.mark.parametrize(
    "command", [["check"], ["graph"], ["advise"], ["export", "--format", "json"], ["facts", "-o", "facts"]]
)
def test_a_workspace_of_1000_levels_is_read_to_its_end(folder: Path, say: Say, deep: str, command: list[str]):
    (folder / deep / "node.py").write_text(NODE)
    status, _, error = say(*command, "d")
    assert status == (1 if command == ["check"] else 0), error


def test_1000_levels_with_nothing_in_them_are_told(say: Say, deep: str):
    assert say("check", "d")[0] == 2
    assert say("check", "nowhere") == (2, "", "archlint: error: no such file or directory: nowhere\n")


@posix
def test_a_folder_that_is_too_deep_for_the_system_is_told(folder: Path, say: Say):
    """Its path is longer than any call takes."""
    name = "d" * 250
    os.mkdir("top")
    opened = [os.open("top", os.O_RDONLY)]
    for _ in range(20):
        os.mkdir(name, dir_fd=opened[-1])
        opened.append(os.open(name, os.O_RDONLY, dir_fd=opened[-1]))
    try:
        status, _, error = say("check", "top")
        write_files(folder / "top", {"node.py": NODE})
        also = say("check", "top", "--format", "concise")
    finally:
        for descriptor in reversed(opened):
            os.close(descriptor)
            if descriptor != opened[0]:
                os.rmdir(name, dir_fd=opened[opened.index(descriptor) - 1])
    assert status == 2
    assert error.endswith(": cannot be listed: File name too long\n")
    assert also[0] == 1
    assert "LNT002 cannot be listed: File name too long" in also[1]
    assert "NME002" in also[1]


# --------------------------------------------------------------------------------------------------- names


@posix
def test_file_names_that_are_long_or_no_utf_8_are_names(folder: Path, say: Say):
    names = [b"n" * 252 + b".py", b"caf\xe9.py", b"new\nline.py", b"red\x1b[31m.py", "\u202eright.py".encode()]
    os.mkdir(b"p\xe9")
    for name in names:
        Path(os.fsdecode(name)).write_text(NODE)
    write_files(folder / os.fsdecode(b"p\xe9"), {"package.xml": manifest("talker"), "talker/node.py": NODE})
    for form in FORMATS:
        status, output, _ = say("check", "--format", form)
        assert status == 1
        assert not set(output) & {"\x1b", "\u202e", "\udce9"}
    for command in (["graph"], ["graph", "--format", "json"], ["docs", "-o", "pages"], ["advise"], ["check", "--diff"]):
        assert say(*command)[0] == 0
    assert say("facts", "-o", "facts")[2].startswith("archlint: error: cannot write facts: the file name '")

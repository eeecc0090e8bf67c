"""``archlint diff``: what a change does, on real repositories."""

from __future__ import annotations

import json
import os
import subprocess
from pathlib import Path

import pytest

from archlint.cli import main
from robot_package import manifest, write_files

NODE = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import Int32, String


class {name}(Node):
    def __init__(self):
        super().__init__('{lower}')
        {body}

    def heard(self, message):
        self.get_logger().info(message.data)


def main():
    rclpy.init()
    rclpy.spin({name}())
"""
FILES = {
    "package.xml": manifest(),
    "setup.py": "from setuptools import setup\nsetup(name='robot', entry_points={'console_scripts': ["
    "'talker = robot.talker:main', 'listener = robot.listener:main']})\n",
    "robot/__init__.py": "",
    "robot/talker.py": NODE.format(
        name="Talker", lower="talker", body="self.words = self.create_publisher(String, 'words', 10)"
    ),
    "robot/listener.py": NODE.format(
        name="Listener", lower="listener", body="self.create_subscription(String, 'words', self.heard, 10)"
    ),
}


def git(*words: str) -> str:
    settings = ["-c", "user.name=Kim", "-c", "user.email=kim@example.com"]
    return subprocess.run(["git", *settings, *words], capture_output=True, text=True, check=True).stdout.strip()


def commit() -> None:
    git("add", "-A")
    git("commit", "-qm", "more")


def edit(file: str, before: str, after: str) -> None:
    text = Path(file).read_text("utf-8")
    assert before in text
    Path(file).write_text(text.replace(before, after), "utf-8")


@pytest.fixture(autouse=True)
def repository(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A talker and a listener, committed."""
    monkeypatch.setenv("GIT_CONFIG_GLOBAL", os.devnull)
    (tmp_path / "ws").mkdir()
    monkeypatch.chdir(tmp_path / "ws")
    write_files(Path(), FILES)
    git("init", "-q", "-b", "main")
    commit()
    return tmp_path / "ws"


@pytest.fixture
def diff(capsys: pytest.CaptureFixture[str]):
    """Run the command; the exit status, what it prints and what it notes."""

    def run(*words: str) -> tuple[int, str, str]:
        status = main(["diff", *words])
        said = capsys.readouterr()
        return status, said.out, said.err

    return run


@pytest.fixture
def data(diff):
    """The changes as data."""
    return lambda *words: json.loads(diff(*words, "--format", "json")[1])


def change_type() -> None:
    edit("robot/talker.py", "create_publisher(String", "create_publisher(Int32")


def test_nothing_has_changed(diff):
    edit("robot/talker.py", "import rclpy\n", "# A talker.\nimport rclpy\n")
    status, out, err = diff("HEAD")
    assert (status, err) == (0, "")
    assert out.endswith("no change of the architecture\n")


def test_a_type_that_no_longer_fits(data):
    change_type()
    said = data("HEAD")
    assert (said["version"], said["summary"]) == (1, {"breaking": 1, "risky": 0, "safe": 0})
    [change] = said["changes"]
    assert (change["subject"], change["name"], change["owner"]) == ("publisher", "/words", "/talker")
    assert (change["aspect"], change["before"], change["after"]) == (
        "type",
        "std_msgs/msg/String",
        "std_msgs/msg/Int32",
    )
    assert (change["file"], change["line"], change["side"]) == ("robot/talker.py", 9, "head")
    assert [finding["code"] for finding in said["findings"]["appeared"]] == ["TOP001"]


def test_what_went_is_named_where_it_was(data):
    edit("robot/talker.py", "self.words = self.create_publisher(String, 'words', 10)", "pass")
    [change] = [change for change in data("HEAD")["changes"] if change["subject"] == "publisher"]
    assert (change["status"], change["impact"], change["side"]) == ("removed", "breaking", "base")
    assert (change["file"], change["line"]) == ("robot/talker.py", 9)


def test_two_revisions_and_the_working_tree_stays(data):
    change_type()
    commit()
    edit("robot/talker.py", "Int32, 'words'", "Int32, 'more'")
    before = Path("robot/talker.py").read_text("utf-8")
    said = data("HEAD~1", "HEAD")
    assert [(change["name"], change["aspect"]) for change in said["changes"]] == [("/words", "type")]
    assert (said["base"]["commit"], said["head"]["commit"]) == (git("rev-parse", "HEAD~1"), git("rev-parse", "HEAD"))
    assert Path("robot/talker.py").read_text("utf-8") == before
    assert git("status", "--porcelain", "--", "robot") == "M robot/talker.py"


def test_two_revisions_where_nothing_is_checked_out(data):
    change_type()
    commit()
    for path in git("ls-files").splitlines():
        Path(path).unlink()
    assert [change["name"] for change in data("HEAD~1", "HEAD")["changes"]] == ["/words"]


def test_a_picture_of_what_changed(diff):
    change_type()
    assert diff("HEAD", "-o", "change.svg")[0] == 0
    drawn = Path("change.svg").read_text("utf-8")
    assert ">breaking</text>" in drawn
    assert ">/words</text>" in drawn


def test_the_suffix_chooses_the_format(diff):
    change_type()
    diff("HEAD", "-o", "change.gv")
    assert Path("change.gv").read_text("utf-8").startswith("digraph archlint {")
    status, _, err = diff("HEAD", "-o", "change.doc")
    assert (status, Path("change.doc").exists()) == (2, False)
    assert "the suffix of change.doc does not name a format" in err


def test_what_others_have_done_on_the_base_branch_is_no_change_of_this_one(diff):
    git("switch", "-qc", "feature")
    git("switch", "-q", "main")
    change_type()
    commit()
    start = git("rev-parse", "main~1")
    git("switch", "-q", "feature")
    _, out, err = diff("main")
    assert out.endswith("no change of the architecture\n")
    assert f"compared with {start[:12]}, where this branch left main" in err


def test_folders_and_saved_graphs(data, tmp_path: Path, capsys: pytest.CaptureFixture[str]):
    assert main(["graph", "--format", "json", "-o", "../before.json"]) == 0
    write_files(tmp_path / "other", FILES)
    change_type()
    from_file, from_folder = data("../before.json"), data(str(tmp_path / "other"), ".")
    assert from_file["changes"] == from_folder["changes"]
    assert [change["impact"] for change in from_file["changes"]] == ["breaking"]
    assert from_file["findings"] is None, "a graph has no findings"
    assert [finding["code"] for finding in from_folder["findings"]["appeared"]] == ["TOP001"]


@pytest.mark.parametrize(("limit", "status"), [("breaking", 1), ("risky", 1), (None, 0)])
def test_what_fails(diff, limit, status):
    change_type()
    assert diff("HEAD", *(("--fail-on", limit) if limit else ()))[0] == status


def test_a_safe_change_never_fails(diff):
    edit("robot/talker.py", "'words', 10)", "'words', 10); self.create_publisher(String, 'more', 10)")
    status, out, _ = diff("HEAD", "--fail-on", "risky")
    assert status == 0
    assert "/talker: publisher of /more added" in out


def test_the_comment_of_a_pull_request(diff):
    edit("robot/talker.py", "'words', 10", "'wörds|`<b>@me', 10")
    out = diff("HEAD", "--format", "markdown")[1]
    assert out.startswith("## Architecture: ")
    assert "```mermaid\nflowchart LR\n" in out
    assert "<b>" not in out
    assert "@me" not in out.partition("```mermaid")[0]


@pytest.mark.parametrize(
    ("words", "why"),
    [
        (["mian"], "git knows no revision mian in .; did you mean main?"),
        ([""], "an empty word is no BASE"),
        (["new.json"], "there is no file new.json"),
        (["old.json"], "an older archlint wrote it"),
        (["main", "--fail-on", "safe"], "invalid choice"),
        (["empty", "empty"], "nothing to check"),
    ],
)
def test_what_cannot_be_compared(diff, words, why):
    Path("old.json").write_text('{"version": 1, "nodes": [{"name": "/a"}]}', "utf-8")
    Path("empty").mkdir()
    status, out, err = diff(*words)
    assert (status, out) == (2, "")
    assert why in err

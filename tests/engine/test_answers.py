"""A command over an unchanged disk says what it said before; whatever changes what it could say is seen."""

from __future__ import annotations

import builtins
import io
import os
import shutil
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from archlint.cli import main
from archlint.cli.console import terminal
from archlint.engine import answers, keeper
from archlint.engine.answers import Answer, known_answer
from archlint.engine.own_code import own_places

pytestmark = pytest.mark.skipif(os.name == "nt", reason="the time of a status change, as POSIX has it")

NODE = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.create_publisher(String, '/bad name', 10)


def main():
    rclpy.init()
    rclpy.spin(Talker())
"""
LAUNCH = """\
import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    share = get_package_share_directory('robot')
    files = [os.path.join(share, 'config', name) for name in ('robot.yaml', 'missing.yaml')]
    return LaunchDescription([Node(package='robot', executable='talker', parameters=files)])
"""
PACKAGE = """\
<package format="3">
  <name>{name}</name>
  <depend>rclpy</depend>
  <export><build_type>ament_python</build_type></export>
</package>
"""
SETUP = """\
from glob import glob
from setuptools import setup

setup(
    name='robot',
    packages=['robot'],
    data_files=[('share/robot/config', glob('config/*.yaml')), ('share/robot/launch', glob('launch/*.py'))],
    entry_points={'console_scripts': ['talker = robot.node:main']},
)
"""


@pytest.fixture
def workspace(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A repository with a package of which git ignores a parameter file, a script, links, and a configuration."""
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path / "home"))
    monkeypatch.setattr(keeper, "RACY_NS", -(10**18))  # all here has been written just now
    root = tmp_path / "repository"
    texts = {
        "src/robot/package.xml": PACKAGE.format(name="robot"),
        "src/robot/setup.py": SETUP,
        "src/robot/setup.cfg": "",
        "src/robot/robot/__init__.py": "",
        "src/robot/robot/node.py": NODE,
        "src/robot/launch/robot.launch.py": LAUNCH,
        "src/robot/config/robot.yaml": "talker:\n  ros__parameters:\n    rate: 1\n",
        "src/robot/config/local.yaml": "talker: {}\n",
        "src/robot/scripts/tool": "#!/bin/sh\n",
        "src/robot/scripts/node": "#!/usr/bin/env python3\n" + NODE,
        "src/robot/README": "nothing\n",
        "src/other/package.xml": PACKAGE.format(name="other"),
        "src/other/CMakeLists.txt": "cmake_minimum_required(VERSION 3.8)\nproject(other)\n",
        "src/ignored/clone/.git/HEAD": "",
        "src/ignored/clone/cloned.py": "import rclpy\n",
        "linked/far.py": "import rclpy\n",
        ".gitignore": "robot.yaml\nsrc/ignored\ngenerated\n",
        ".git/info/exclude": "secret.py\n",
        "generated/made.py": NODE,
        "archlint.toml": 'extend = "tools/base.toml"\nexclude = ["old"]\n',
        "tools/base.toml": 'ignore = ["CBG001"]\n',
    }
    for name, text in texts.items():
        (root / name).parent.mkdir(parents=True, exist_ok=True)
        (root / name).write_text(text, "utf-8")
    (root / "src/robot/scripts/tool").chmod(0o755)
    (root / "src/robot/robot/linked.py").symlink_to("node.py")
    (root / "src/folder").symlink_to("../linked")
    (root / "src/nowhere").symlink_to("gone")
    monkeypatch.chdir(root)
    return root


@pytest.fixture
def said(workspace: Path, capsys: pytest.CaptureFixture[str]) -> Callable[..., tuple[int, str, str]]:
    """Runs a command; gives its exit status and its two outputs."""

    def say(*words: str) -> tuple[int, str, str]:
        capsys.readouterr()
        status = main(words)
        return status, *capsys.readouterr()

    return say


def known(*words: str) -> Answer | None:
    return known_answer(words, terminal())


def write(path: str, text: str) -> Callable[[], object]:
    return lambda: (Path(path).parent.mkdir(parents=True, exist_ok=True), Path(path).write_text(text, "utf-8"))


COMMANDS = [
    ("check",),
    ("check", "--format", "concise", "src"),
    ("check", "-q", "--exit-zero", "src/robot/robot/node.py"),
    ("check", "--launch", "src/robot/launch/robot.launch.py"),
    ("check", "src/robot", "--color", "always"),
    ("graph",),
    ("graph", "src/robot", "--format", "json"),
    ("show", "/talker"),
    ("show", "/talker", "src", "--format", "json"),
    ("trace", "/talker"),
    ("trace", "/talker", "--format", "mermaid", "--launch", "src/robot/launch/robot.launch.py"),
    ("impact", "Talker", "--color", "always"),
]


@pytest.mark.parametrize("words", COMMANDS, ids=" ".join)
def test_an_unchanged_workspace_is_told_of_as_before(said, monkeypatch, words):
    first = said(*words)
    assert first[1], first
    assert known(*words) is not None
    monkeypatch.setattr("archlint.engine.pipeline.find_files", None)  # whoever looks for files fails
    assert said(*words) == first


@pytest.mark.parametrize(
    "words",
    [
        ("check", "--no-cache"),
        ("check", "--verbose"),
        ("check", "--statistics"),
        ("check", "--diff"),
        ("check", "-o", "report"),
        ("check", "--output", "json=report"),
        ("check", "--format", "json"),
        ("check", "--format", "sarif"),
        ("graph", "-o", "graph.dot"),
        ("graph", "--", "src"),
        ("show", "/talker", "-o", "shown"),
        ("show", "/nobody"),
        ("trace", "/talker", "--verbose"),
        ("trace", "/talker", "--format", "svg"),
        ("impact", "/talker", "--no-cache"),
    ],
    ids=" ".join,
)
def test_what_does_more_or_never_says_the_same_is_done_each_time(said, words):
    said(*words)
    assert known(*words) is None


CHANGES: dict[str, Callable[[], object]] = {
    "a file is edited": write("src/robot/robot/node.py", NODE + "\n"),
    "a file is added": write("src/robot/robot/more.py", NODE),
    "a file is added in a new folder": write("src/robot/more/more.py", NODE),
    "a file is removed": lambda: Path("src/robot/robot/node.py").unlink(),
    "a file is renamed": lambda: Path("src/robot/robot/node.py").rename("src/robot/robot/nodes.py"),
    "a folder is renamed": lambda: Path("src/robot").rename("src/robots"),
    "a file is replaced": lambda: (write("new.py", NODE)(), Path("new.py").replace("src/robot/robot/node.py")),
    "a file has its old times": lambda: (
        write("src/robot/robot/node.py", NODE.replace("bad", "odd"))(),
        os.utime("src/robot/robot/node.py", (1, 1)),
    ),
    "a package is added": write("src/third/package.xml", PACKAGE.format(name="third")),
    "a manifest is edited": write("src/other/package.xml", PACKAGE.format(name="others")),
    "a build file is edited": write("src/other/CMakeLists.txt", "project(other)\n"),
    "a setup.cfg is edited": write("src/robot/setup.cfg", "[options]\n"),
    "a launch file is edited": write("src/robot/launch/robot.launch.py", LAUNCH + "\n"),
    "a file that git ignores and a launch file names": write("src/robot/config/robot.yaml", "talker: {}\n"),
    "a file that was missing is there": write("src/robot/config/missing.yaml", "talker: {}\n"),
    ".gitignore is edited": write(".gitignore", "node.py\n"),
    ".gitignore is added": write("src/robot/.gitignore", "node.py\n"),
    ".git/info/exclude is edited": write(".git/info/exclude", "node.py\n"),
    "a clone is made in an ignored folder": write("src/ignored/second/.git/HEAD", ""),
    "a repository is made in an ignored folder": write("generated/.git/HEAD", ""),
    "a folder is marked": write("src/robot/COLCON_IGNORE", ""),
    "a script is made Python": write("src/robot/scripts/tool", "#!/usr/bin/env python3\nimport rclpy\n"),
    "a script may run": lambda: Path("src/robot/README").chmod(0o755),
    "what is linked is edited": write("linked/far.py", "import rclpy\n\n"),
    "what is linked gets more": write("linked/more.py", "import rclpy\n"),
    "a link leads elsewhere": lambda: (Path("src/folder").unlink(), Path("src/folder").symlink_to("../generated")),
    "a link leads somewhere": write("src/gone", ""),
    "the configuration is edited": write("archlint.toml", 'exclude = ["old"]\n'),
    "the configuration is removed": lambda: Path("archlint.toml").unlink(),
    "what the configuration builds on is edited": write("tools/base.toml", ""),
    "a nearer configuration is added": write("src/archlint.toml", ""),
    "a configuration that comes first is added": write(".archlint.toml", ""),
    "the repository is none any more": lambda: shutil.rmtree(".git"),
}


ABOVE: dict[str, Callable[[], object]] = {
    "a manifest": write("src/package.xml", PACKAGE.format(name="all")),
    "an __init__.py": write("src/robot/__init__.py", ""),
    "a .gitignore": write("src/.gitignore", "node.py\n"),
    "a repository": write("src/.git/HEAD", ""),
    "a configuration": write("src/pyproject.toml", "[tool.archlint]\n"),
    "a sign of a build": write("install/setup.bash", ""),
    "a repository around all": write("../.git/HEAD", ""),
}


@pytest.mark.parametrize(
    "words, changes",
    [
        (("check",), CHANGES),
        (("check", "src/robot/robot/node.py"), ABOVE),
        (("trace", "/talker"), CHANGES),
        (("show", "/talker"), CHANGES),
    ],
    ids=["in the workspace", "above what is asked for", "in the workspace of a trace", "in what is shown"],
)
def test_each_change_is_seen(workspace, said, monkeypatch, words, changes):
    """One run says which places count; each change is made in a fresh copy of the workspace, at the same path."""
    shutil.copytree(workspace, workspace.parent / "copy", symlinks=True)
    states: list[answers.State] = []
    monkeypatch.setattr(keeper, "State", lambda *fields: states.append(answers.State(*fields)) or states[-1])
    said(*words)
    assert known(*words) is not None
    [state] = states
    unseen = []
    for name, change in changes.items():
        shutil.rmtree(workspace)
        shutil.copytree(workspace.parent / "copy", workspace, symlinks=True)
        os.chdir(workspace)
        before = now(state)
        assert answers.State.holds(before)
        time.sleep(0.02)  # longer than a tick of the clock of any file system here
        change()
        if answers.State.holds(before):
            unseen.append(name)
        shutil.rmtree(workspace.parent / ".git", ignore_errors=True)
    assert unseen == []


def now(state: answers.State) -> list[str]:
    """The fields of a state as its places are now."""
    stamped, _, placed, _, folder, without, _ = state.fields
    names = answers.Names(folder, without)
    paths, above = stamped.split("\0"), placed.split("\0")
    return answers.State(paths, answers.stamps_of(paths), above, answers.kinds_of(above), names).fields


@pytest.mark.parametrize("name", ["NO_COLOR", "FORCE_COLOR", "HOME"])
def test_another_environment_is_another_question(workspace, said, monkeypatch, name):
    said("check")
    monkeypatch.setenv(name, "/elsewhere")
    assert known("check") is None


def test_another_working_directory_is_another_question(workspace, said, monkeypatch):
    said("check", str(workspace))
    assert known("check", str(workspace)) is not None
    monkeypatch.chdir(workspace / "src")
    assert known("check", str(workspace)) is None


def test_a_day_later_it_is_asked_anew(workspace, said, monkeypatch):
    """What no run asks for is thrown away one day: the entries of the files, too."""
    said("check")
    later = time.time_ns() + 24 * 3600 * 10**9
    monkeypatch.setattr(answers.time, "time_ns", lambda: later)
    assert known("check") is None


def test_what_has_just_changed_may_change_again_unseen(workspace, said, monkeypatch):
    monkeypatch.setattr(keeper, "RACY_NS", 2_000_000_000)
    said("check")
    assert known("check") is None


def test_what_changes_while_a_run_goes_on_is_not_taken_for_what_it_saw(workspace, said, monkeypatch):
    shown = keeper.Keeper.lasts
    monkeypatch.setattr(keeper, "RACY_NS", 0)

    def changed(self: keeper.Keeper, *arguments: object) -> None:
        write(str(workspace / "src/robot/robot/node.py"), NODE + "\n")()
        shown(self, *arguments)

    said("check")
    time.sleep(0.02)
    monkeypatch.setattr(keeper.Keeper, "lasts", changed)
    said("check", "src")
    assert known("check", "src") is None


def test_archlint_itself_is_part_of_the_state(workspace, said, monkeypatch):
    """An edited rule is asked anew."""
    stamped: list[str] = []
    monkeypatch.setattr(keeper, "State", lambda paths, *rest: stamped.extend(paths) or answers.State(paths, *rest))
    said("check")
    assert set(own_places()) <= set(stamped)
    assert any(path.endswith("archlint/checks") for path in stamped)
    assert any(path.endswith("archlint/checks/names.py") for path in stamped)
    assert any(path.endswith(".md") for path in stamped)


@pytest.mark.parametrize("spoil", [lambda data: data[:-1], lambda data: b"0" * 32 + data[32:], lambda data: b""])
def test_an_answer_that_is_not_the_users_own_is_none(workspace, said, spoil):
    said("check")
    [file] = workspace.glob(".archlint_cache/*/answers/*")
    file.write_bytes(spoil(file.read_bytes()))
    assert known("check") is None


def test_no_link_leads_to_an_answer(workspace, said):
    said("check")
    [folder] = workspace.glob(".archlint_cache/*/answers")
    folder.rename(workspace.parent / "answers")
    folder.symlink_to(workspace.parent / "answers")
    assert known("check") is None


def test_a_key_below_what_is_checked_signs_nothing(workspace, said, monkeypatch):
    said("check")
    said("check", "src")
    shutil.copytree(workspace.parent / "home", workspace / "home")
    monkeypatch.setenv("XDG_CONFIG_HOME", str(workspace / "home"))
    monkeypatch.setattr(answers.State, "holds", lambda fields: True)
    assert known("check") is None
    assert known("check", "--format", "text") is None
    assert known("check", "src") is not None


def test_a_cache_elsewhere_is_found_by_its_option_only(workspace, said):
    said("check", "--cache-dir", "../cache")
    assert known("check", "--cache-dir", "../cache") is not None
    said("check", "--cache-dir=../cache")
    assert known("check", "--cache-dir=../cache") is not None
    write("archlint.toml", 'cache-dir = "kept/cache"\n')()
    said("check")
    assert known("check") is None


class Looks:
    """Notes what is looked at on the disk below a folder: ``there`` whether it is, ``within`` what is in it."""

    def __init__(self, folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
        self._folder = str(folder)
        self.there: set[str] = set()
        self.within: set[str] = set()
        for name in ("stat", "lstat", "readlink"):
            self._watch(monkeypatch, os, name, self.there)
        self._watch(monkeypatch, os, "open", self.within)
        self._watch(monkeypatch, os, "listdir", self.within)
        self._watch(monkeypatch, builtins, "open", self.within)
        self._watch(monkeypatch, io, "open", self.within)
        scandir = os.scandir
        monkeypatch.setattr(os, "scandir", lambda path=".": Listing(self, path, scandir(path)))

    def note(self, path: object, places: set[str]) -> None:
        if isinstance(path, (str, os.PathLike)):
            absolute = os.path.normpath(os.path.join(os.getcwd(), os.fspath(path)))
            if absolute.startswith(self._folder + os.sep) and ".archlint_cache" not in absolute:
                places.add(absolute)

    def _watch(self, monkeypatch: pytest.MonkeyPatch, module: object, name: str, places: set[str]) -> None:
        function = getattr(module, name)

        def watched(path: object, *arguments: object, **more: object) -> object:
            self.note(path, places)
            return function(path, *arguments, **more)

        monkeypatch.setattr(module, name, watched)


class Listing:
    """What ``os.scandir`` gives, with entries that note what they are asked."""

    def __init__(self, looks: Looks, path: object, listing: os.ScandirIterator[str]) -> None:
        looks.note(path, looks.within)
        self._looks, self._listing = looks, listing

    def __enter__(self) -> Listing:
        return self

    def __exit__(self, *error: object) -> None:
        self._listing.close()

    def close(self) -> None:
        self._listing.close()

    def __iter__(self) -> Iterator[Entry]:
        return (Entry(self._looks, entry) for entry in self._listing)

    def __next__(self) -> Entry:
        return Entry(self._looks, next(self._listing))


class Entry:
    def __init__(self, looks: Looks, entry: os.DirEntry[str]) -> None:
        self._looks, self._entry = looks, entry

    def __getattr__(self, name: str) -> object:
        return getattr(self._entry, name)

    def stat(self, *, follow_symlinks: bool = True) -> os.stat_result:
        self._looks.note(self._entry.path, self._looks.within)
        return self._entry.stat(follow_symlinks=follow_symlinks)

    def is_dir(self, *, follow_symlinks: bool = True) -> bool:
        if follow_symlinks and self._entry.is_symlink():
            self._looks.note(self._entry.path, self._looks.within)
        return self._entry.is_dir(follow_symlinks=follow_symlinks)


@pytest.mark.parametrize("words", COMMANDS, ids=" ".join)
def test_all_that_a_run_looks_at_is_part_of_the_state(workspace, said, monkeypatch, words):
    """What is read or listed is there with its stamp; what is only asked for by its name at least lies in a folder
    that is."""
    said(*words)  # what is known of files by their stamps is part of the result that is kept
    states: list[answers.State] = []
    monkeypatch.setattr("archlint.cli.known_answer", lambda *question: None, raising=False)
    monkeypatch.setattr(answers, "known_answer", lambda *question: None)
    monkeypatch.setattr(keeper, "State", lambda *fields: states.append(answers.State(*fields)) or states[-1])
    with monkeypatch.context() as patch:
        looks = Looks(workspace, patch)
        state_of = keeper.Keeper.keep
        patch.setattr(keeper.Keeper, "keep", lambda *_: None)  # it looks at all of the state once more
        said(*words)
    assert looks.within and looks.there
    monkeypatch.setattr(keeper.Keeper, "keep", state_of)
    said(*words)
    stamped, _, placed, _, folder, _, _ = states[-1].fields
    with_stamp = {os.path.normpath(os.path.join(workspace, path)) for path in (*stamped.split("\0"), folder)}
    with_kind = {os.path.normpath(path) for path in placed.split("\0")}
    assert looks.within - with_stamp == set()
    assert {path for path in looks.there - with_stamp - with_kind if os.path.dirname(path) not in with_stamp} == set()

"""A copy of a workspace in a git repository of its own, and a package that is added to it."""

from __future__ import annotations

import shutil
from collections.abc import Iterator
from pathlib import Path

from benchmarks.adoption.programs import Programs

NAME = "late_addition"
"""The package that is added, with and without a mistake."""
_NODE = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import {type}


class {name}(Node):
    def __init__(self):
        super().__init__('late_{node}')
        self.end = self.create_{end}


def main():
    rclpy.init()
    rclpy.spin({name}())
"""
_SETUP = f"""\
from setuptools import setup

setup(
    name='{NAME}',
    version='0.1.0',
    packages=['{NAME}'],
    data_files=[
        ('share/ament_index/resource_index/packages', ['resource/{NAME}']),
        ('share/{NAME}', ['package.xml']),
    ],
    extras_require={{'test': ['pytest']}},
    entry_points={{'console_scripts': [
        'talker = {NAME}.talker:main',
        'listener = {NAME}.listener:main',
    ]}},
)
"""
_MANIFEST = f"""\
<?xml version="1.0"?>
<package format="3">
  <name>{NAME}</name>
  <version>0.1.0</version>
  <description>Two nodes that came later.</description>
  <maintainer email="kim@example.com">Kim</maintainer>
  <license>Apache-2.0</license>
  <exec_depend>rclpy</exec_depend>
  <exec_depend>std_msgs</exec_depend>
  <test_depend>python3-pytest</test_depend>
  <export>
    <build_type>ament_python</build_type>
  </export>
</package>
"""
_TEST = """\
from archlint.testing import main_with_errors


def test_archlint():
    rc, errors = main_with_errors(argv=[])
    assert rc == 0, '\\n'.join(errors)
"""
_LEFT_OUT = shutil.ignore_patterns(".git", ".archlint_cache", "__pycache__", "build", "install", "log")


def checked_out(address: str, folder: Path, programs: Programs) -> Path:
    """``URL@COMMIT`` as a folder with this one commit.  Raises ``OSError`` where git cannot bring it."""
    url, _, commit = address.rpartition("@")
    checkout = folder / url.rstrip("/").rpartition("/")[2].removesuffix(".git")
    checkout.mkdir(parents=True)
    for words in (["init", "-q"], ["fetch", "-q", "--depth", "1", url, commit], ["checkout", "-q", "FETCH_HEAD"]):
        done = programs.git(checkout, *words)
        if done.status != 0:
            raise OSError(f"git cannot bring {address}: {done.said.strip()}")
    return checkout


class Workspace:
    """The copy, one commit old; a repository that is one package becomes a package of it."""

    def __init__(self, source: Path, folder: Path, programs: Programs) -> None:
        self.root = folder
        self.programs = programs
        inside = folder / "src" / source.name if (source / "package.xml").is_file() else folder
        shutil.copytree(source, inside, symlinks=True, ignore=_LEFT_OUT, dirs_exist_ok=True)
        programs.git(self.root, "init", "-q", "-b", "main")
        self.commit("what is there")

    @property
    def added(self) -> Path:
        """The folder of the package that is added."""
        return (self.root / "src" if (self.root / "src").is_dir() else self.root) / NAME

    def add_package(self, mistake: bool) -> None:
        """Two nodes and a test; with the mistake, the listener expects another type than the talker sends."""
        for path, text in self._package("Int32" if mistake else "String"):
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, "utf-8")

    def remove_package(self) -> None:
        shutil.rmtree(self.added, ignore_errors=True)

    def commit(self, subject: str, *options: str) -> tuple[bool, str]:
        """Whether git, and its hook, took all that has changed as a commit; and what was said."""
        self.programs.git(self.root, "add", "-A")
        done = self.programs.git(self.root, "commit", "-q", "-m", subject, *options)
        return done.status == 0, done.said

    def _package(self, received: str) -> Iterator[tuple[Path, str]]:
        talker = _NODE.format(type="String", name="Talker", node="talker", end="publisher(String, 'late_words', 10)")
        end = f"subscription({received}, 'late_words', print, 10)"
        yield self.added / NAME / "__init__.py", ""
        yield self.added / NAME / "talker.py", talker
        yield self.added / NAME / "listener.py", _NODE.format(type=received, name="Listener", node="listener", end=end)
        yield self.added / "setup.py", _SETUP
        yield self.added / "setup.cfg", f"[install]\ninstall_scripts=$base/lib/{NAME}\n"
        yield self.added / "package.xml", _MANIFEST
        yield self.added / "resource" / NAME, ""
        yield self.added / "test" / "test_archlint.py", _TEST

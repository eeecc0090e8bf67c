"""API001: values that are called as they are written."""

from __future__ import annotations

import pytest

from archlint.config.settings import load
from archlint.engine.pipeline import Request, check
from checks.judging import Judge

NODE = """
import rclpy
from rclpy.node import Node


class Driver(Node):
    def __init__(self):
        super().__init__('driver')
        {line}


rclpy.init()
rclpy.spin(Driver())
"""


@pytest.mark.parametrize(
    ("line", "what", "cure"),
    [
        ("rows = [('a', 1) ('b', 2)]", "a tuple", "a comma"),
        ("rows = [[1, 2], [3, 4] (5, 6)]", "a list", "a comma"),
        ("rows = {'a': {'b': 1} ('c')}", "a dict", "a comma"),
        ("print('a' ('b'))", "a text", "a comma"),
        ("print(f'{self}' ('b'))", "a text", "a comma"),
        ("x = 2 (3 + 4)", "a number", "the operator that is missing"),
    ],
)
def test_a_value_that_is_called(judge: Judge, line: str, what: str, cure: str):
    (finding,) = judge("API001", NODE.format(line=f"{line}  # here"))
    assert finding.message == f"{what} stands before these parentheses: this line raises TypeError, as it is called"
    assert finding.help == f"write {cure} behind {what}"


@pytest.mark.parametrize(
    "line",
    [
        "rows = [('a', 1), ('b', 2)]",
        "x = (print)('a')",
        "x = (lambda a: a)(1)",
        "x = [print][0]('a')",
        "x = {'a': print}['a']('b')",
        "x = 'a' 'b'",
        "x = 'a'.join('b')",
        "try:\n            x = 2 (3)\n        except TypeError:\n            pass",
    ],
)
def test_a_function_that_is_called(judge: Judge, line: str):
    judge("API001", NODE.format(line=line))


SETUP = """
from setuptools import setup

setup(
    name='robot',
    packages=['robot'],
    data_files=[
        ('share/ament_index/resource_index/packages', ['resource/robot']){comma}
        ('share/robot', ['package.xml']),
    ],
)
"""
MANIFEST = """<package format="3">
  <name>robot</name>
  <version>0.1.0</version>
  <description>An example</description>
  <maintainer email="a@example.org">A</maintainer>
  <license>MIT</license>
  <exec_depend>rclpy</exec_depend>
  <export><build_type>{build_type}</build_type></export>
</package>
"""


@pytest.mark.parametrize(
    ("comma", "build_type", "lines"), [("", "ament_python", [7]), (",", "ament_python", []), ("", "ament_cmake", [])]
)
def test_a_setup_file(judge: Judge, comma: str, build_type: str, lines: list[int]):
    """Nothing runs the one of a package of CMake."""
    (judge.folder / "setup.py").write_text(SETUP.format(comma=comma).lstrip(), encoding="utf-8")
    (judge.folder / "package.xml").write_text(MANIFEST.format(build_type=build_type), encoding="utf-8")
    (judge.folder / "robot").mkdir()
    (judge.folder / "robot" / "__init__.py").write_text("", encoding="utf-8")
    (judge.folder / "archlint.toml").write_text('select = ["API001"]\n', encoding="utf-8")
    findings = check(Request((".",), load(judge.folder), cached=False, jobs=1)).findings
    assert [one.place.line for one in findings] == lines
    assert all("the build of the package stops" in one.message for one in findings)

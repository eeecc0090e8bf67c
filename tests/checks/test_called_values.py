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


@pytest.mark.parametrize(("how", "lines"), [("import glob", [7]), ("from glob import glob", [])])
def test_a_setup_file_that_calls_a_module(judge: Judge, how: str, lines: list[int]):
    data = "data_files=[('share/robot', glob('*.xml'))]"
    setup = f"{how}\n\nfrom setuptools import setup\n\nsetup(\n    name='robot',\n    {data},\n)\n"
    (judge.folder / "setup.py").write_text(setup, encoding="utf-8")
    (judge.folder / "package.xml").write_text(MANIFEST.format(build_type="ament_python"), encoding="utf-8")
    (judge.folder / "archlint.toml").write_text('select = ["API001"]\n', encoding="utf-8")
    findings = check(Request((".",), load(judge.folder), cached=False, jobs=1)).findings
    assert [one.place.line for one in findings] == lines
    assert all("the build of the package stops as it is called" in one.message for one in findings)


MODULE = """
class node1:
    pass


class Arm:
    pass
"""


@pytest.mark.parametrize("how", ["import node1", "from . import node1"])
def test_a_module_that_is_called(judge: Judge, how: str):
    """It is called like the class in it, which nobody has imported."""
    code = f"{how}\n{NODE}"
    (finding,) = judge("API001", code.format(line="self.arm = node1()  # here"), MODULE)
    assert finding.message == "'node1' is the module node1.py, and calling it fails with a TypeError"
    assert finding.help == "call what is in it: node1.node1(…)"
    (finding,) = judge("API001", code.format(line="self.arm = node1()  # here"), "class Arm:\n    pass\n")
    assert finding.help == "call what is in it, as node1.NAME(…)"


def test_a_module_of_python_that_is_called_like_its_function(judge: Judge):
    (finding,) = judge("API001", "import glob\n" + NODE.format(line="self.maps = glob('maps/*.yaml')  # here"))
    assert finding.message == "'glob' is a module of Python, and calling it fails with a TypeError"
    assert finding.help == "call what is in it: glob.glob(…)"


@pytest.mark.parametrize(
    ("how", "line"),
    [
        ("import glob", "self.maps = glob.glob('maps/*.yaml')"),
        ("from glob import glob", "self.maps = glob('maps/*.yaml')"),
        ("import glob\nfrom glob import glob", "self.maps = glob('maps/*.yaml')"),
        ("import glob\n\ndef glob(pattern): ...", "self.maps = glob('maps/*.yaml')"),
        ("import time", "time = print; time('now')"),
        ("import glob as paths", "self.maps = paths.glob('maps/*.yaml')"),
    ],
)
def test_a_function_of_a_module_of_python(judge: Judge, how: str, line: str):
    assert not judge("API001", f"{how}\n{NODE.format(line=line)}")


@pytest.mark.parametrize(
    ("how", "line", "module"),
    [
        ("import node1", "self.arm = node1.Arm()", MODULE),
        ("from node1 import node1", "self.arm = node1()", MODULE),
        ("import node1\nnode1 = node1.Arm", "self.arm = node1()", MODULE),
        ("import node1", "self.arm = node1()", "import sys\n\nsys.modules[__name__] = print\n"),
        ("try:\n    import node1\nexcept ImportError:\n    node1 = print", "self.arm = node1()", MODULE),
        ("import node1", "try:\n            node1()\n        except TypeError:\n            pass", MODULE),
    ],
)
def test_what_is_called_may_be_no_module(judge: Judge, how: str, line: str, module: str):
    judge("API001", f"{how}\n{NODE.format(line=line)}", module)


@pytest.mark.parametrize(
    ("init", "told"), [("", True), ("from robot.Arm import Arm\n", False), ("def __getattr__(name): ...\n", False)]
)
def test_a_module_of_a_package_that_may_have_something_else_by_its_name(findings, init: str, told: bool):
    code = f"from robot import Arm\n{NODE.format(line='self.arm = Arm()')}"
    rows = findings(
        "API001",
        **{"robot/talker.py": code, "robot/Arm.py": "class Arm:\n    pass\n", "robot/__init__.py": init},
    )
    expected = ["'Arm' is the module robot/Arm.py, and calling it fails with a TypeError"]
    assert [row.message for row in rows] == (expected if told else [])

"""A failure of archlint's own stays where it happened: one LNT003 there, and the rest as if nothing were."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from archlint import fixes
from archlint.cli import main
from archlint.config.settings import Settings, load
from archlint.engine import pipeline
from archlint.engine.pipeline import Request
from archlint.faults import Fault
from archlint.finding import Finding
from archlint.interpreter import expressions
from archlint.launch import files as launch_files
from archlint.place import Place
from archlint.syntax import facts

GOOD = """\
import rclpy
from rclpy.node import Node
from std_srvs.srv import Trigger


class Asker(Node):
    def __init__(self):
        super().__init__('asker')
        self.other = self.create_client(Trigger, 'other')
        self.create_service(Trigger, 'mine', self.answer)

    def answer(self, request, response):
        self.other.call(Trigger.Request())
        return response
"""

NODE = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String

{module}


class Talker(Node):
    {body}

    def __init__(self):
        super().__init__('talker')
        {constructor}
        self.create_publisher(String, 'chatter', 10)
        self.create_timer(1.0, self.tick)

    def tick(self):
        {callback}
        self.create_publisher(String, 'late', 10)


def main():
    rclpy.init()
    {main}
    rclpy.spin(Talker())


if __name__ == '__main__':
    main()
"""
PARTS = ("module", "body", "constructor", "callback", "main")
BOOM = "print('boom')"

MANIFEST = "<package format='3'><name>{name}</name><version>0.0.0</version></package>\n"
SETUP = """\
from setuptools import setup

print('boom')
setup(name='{name}', entry_points={{'console_scripts': ['talk = {name}.node:main']}})
"""
LAUNCH = """\
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    print('boom')
    return LaunchDescription([Node(package='p', executable='talk', name='renamed')])
"""


@pytest.fixture(autouse=True)
def workspace(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    write("good.py", GOOD)
    return tmp_path


@pytest.fixture
def explode(monkeypatch: pytest.MonkeyPatch) -> Callable[[type[Exception]], None]:
    """From now on the literal ``'boom'`` raises when it is evaluated."""

    def arm(error: type[Exception]) -> None:
        literal = expressions.EXPRESSIONS[facts.Literal]

        def evaluate(run, expression):
            if expression.value == "boom":
                raise error("boom")
            return literal(run, expression)

        monkeypatch.setitem(expressions.EXPRESSIONS, facts.Literal, evaluate)

    return arm


def write(path: str, text: str) -> None:
    Path(path).parent.mkdir(parents=True, exist_ok=True)
    Path(path).write_text(text)


def node(**parts: str) -> str:
    return NODE.format(**{part: parts.get(part, "pass") for part in PARTS})


def findings() -> list[Finding]:
    return pipeline.check(Request((".",), load(Path()), cached=False, jobs=1)).findings


def of_the_good_file() -> list[Finding]:
    return [one for one in findings() if one.place.file == "good.py"]


def topics() -> list[str]:
    return sorted(pipeline.graph(Request((".",), Settings(), cached=False, jobs=1)).topics)


@pytest.mark.parametrize("part", PARTS)
def test_a_statement_that_fails_is_one_finding_there_and_the_code_behind_it_is_followed(part: str, explode):
    write("bad.py", node(**{part: BOOM}))
    before, seen = of_the_good_file(), topics()
    line = next(number for number, text in enumerate(node(**{part: BOOM}).splitlines(), 1) if "boom" in text)

    explode(ZeroDivisionError)
    after = findings()

    assert [one for one in after if one.place.file == "good.py"] == before != []
    assert [(one.place.file, one.place.line) for one in after if one.code == "LNT003"] == [("bad.py", line)]
    assert topics() == seen == ["/chatter", "/late"]


@pytest.mark.parametrize(
    ("part", "where"),
    [("module", 1), ("body", 1), ("constructor", 28), ("callback", 17), ("main", 28)],
)
def test_code_that_is_nested_too_deep_costs_its_own_root_alone(part: str, where: int, explode):
    write("bad.py", node(**{part: BOOM}))
    good = of_the_good_file()

    explode(RecursionError)
    after = findings()

    assert [one for one in after if one.place.file == "good.py"] == good != []
    [fault] = [one for one in after if one.code == "LNT003"]
    assert (fault.place.file, fault.place.line) == ("bad.py", where)


def test_a_setup_py_that_fails_leaves_its_package_open_and_the_others_as_they_are(explode):
    for name in ("p", "q"):
        write(f"{name}/package.xml", MANIFEST.format(name=name))
        write(f"{name}/{name}/__init__.py", "")
        write(f"{name}/{name}/node.py", node())
    write("p/setup.py", SETUP.format(name="p"))
    write("q/setup.py", SETUP.format(name="q").replace("boom", "fine"))
    before = findings()

    explode(ZeroDivisionError)
    after = findings()

    assert [one for one in after if one.code != "LNT003"] == before
    assert [(one.place.file, one.place.line) for one in after if one.code == "LNT003"] == [("p/setup.py", 3)]


def test_a_launch_file_that_fails_is_told_and_the_others_are_judged(explode, monkeypatch: pytest.MonkeyPatch):
    write("p/package.xml", MANIFEST.format(name="p"))
    write("p/launch/a.launch.py", LAUNCH)
    write("p/launch/b.launch.xml", "<launch><arg name='x' default='1'/></launch>")
    write("p/launch/c.launch.xml", "<launch><node pkg='p' exec='nowhere'/></launch>")
    before = [one for one in findings() if one.place.file != "p/launch/a.launch.py"]
    read = launch_files.launch_facts_of

    def fails(path, text):
        if path.endswith("b.launch.xml"):
            raise ZeroDivisionError("boom")
        return read(path, text)

    monkeypatch.setattr(launch_files, "launch_facts_of", fails)
    explode(ZeroDivisionError)
    after = findings()

    told = [(one.place.file, one.place.line) for one in after if one.code == "LNT003"]
    assert told == [("p/launch/a.launch.py", 6), ("p/launch/b.launch.xml", 1)]
    assert [one for one in after if one.code != "LNT003" and one.place.file != "p/launch/a.launch.py"] == before


def test_a_fix_that_fails_leaves_the_finding_without_one(monkeypatch: pytest.MonkeyPatch):
    def fails(limits, source):
        raise ZeroDivisionError("boom")

    write("waits.py", node(constructor="self.create_client(Trigger, 'other').wait_for_service()"))
    before = findings()
    [fixable] = [one for one in before if one.code == "TMO001"]
    monkeypatch.setattr(fixes, "limited", fails)
    after = findings()

    assert [(one.code, one.place) for one in after if one.code != "LNT003"] == [(one.code, one.place) for one in before]
    assert [one.place for one in after if one.code == "LNT003"] == [fixable.place]
    assert all(one.fix is None for one in after)


def test_the_exit_status_is_2_and_the_report_is_whole(explode, capsys: pytest.CaptureFixture[str]):
    write("bad.py", node(callback=BOOM))
    explode(ZeroDivisionError)

    assert main(["check", ".", "--no-cache", "--format", "concise"]) == 2
    shown = capsys.readouterr().out
    assert "SRV003" in shown
    assert shown.count("LNT003") == 1


def test_a_graph_with_a_hole_is_drawn_and_ends_with_2(explode, capsys: pytest.CaptureFixture[str]):
    write("bad.py", node(callback=BOOM))
    explode(ZeroDivisionError)

    assert main(["graph", ".", "--no-cache"]) == 2
    shown = capsys.readouterr()
    assert "/chatter" in shown.out
    assert "bad.py:18:9: following this statement failed with ZeroDivisionError: boom" in shown.err


DEEP = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String

{helpers}

class Deep(Node):
    def __init__(self):
        super().__init__('deep')
        self.create_publisher(String, h0('end'), 10)


def main():
    rclpy.init()
    rclpy.spin(Deep())


if __name__ == '__main__':
    main()
"""


def test_calls_as_deep_as_a_run_follows_fit_its_stack_whatever_their_arguments_look_like():
    """Forty calls, each inside six brackets and four branches, are some two thousand frames of the interpreter."""
    branches = "    if True:\n        if True:\n            if True:\n                if True:\n"
    rows = [
        f"def h{n}(x):\n{branches}                    return {'[' * 6}h{n + 1}(x){']' * 6}{'[0]' * 6}\n\n"
        for n in range(40)
    ]
    write("good.py", DEEP.format(helpers="\n".join([*rows, "def h40(x):\n    return x\n"])))

    assert topics() == ["/end"]
    assert not [one for one in findings() if one.code == "LNT003"]


def test_a_fault_says_the_same_in_every_run():
    fault = Fault.of("reading this", KeyError(object()), Place("a.py", 1, 1, 1, 1))
    assert fault.message == "KeyError: <object object>"

"""SRV006: nodes that wait for each other at their start."""

from __future__ import annotations

from pathlib import Path

import pytest

from archlint.config.settings import load
from archlint.engine.pipeline import Request, check
from archlint.finding import Finding
from learners import PACKAGE, Learned, complete

NODE = """\
import threading

import rclpy
from rclpy.node import Node
from std_srvs.srv import Trigger


class {cls}(Node):
    def __init__(self):
        super().__init__('{name}')
        {lines}

    def wait_for_other(self):
        self.{other}.wait_for_service()

    def serve(self, request, response):
        response.success = True
        return response


def main():
    rclpy.init()
    node = {cls}()
    rclpy.spin(node)
"""
LAUNCH = """<launch>
<node pkg="my_first_package" exec="arm"/>
<node pkg="my_first_package" exec="base"/>
</launch>
"""
FOREVER = "self.{other}.wait_for_service()"
LOOP = "while not self.{other}.wait_for_service(timeout_sec=1.0):\n            print('waiting')"
ASKS = (
    "if not self.{other}.wait_for_service(timeout_sec=30.0):\n            raise RuntimeError\n"
    "        rclpy.spin_until_future_complete(self, self.{other}.call_async(Trigger.Request()))"
)
METHOD = "self.wait_for_other()"
LIMITED = "print(self.{other}.wait_for_service(timeout_sec=5.0))"
SERVES = "self.create_service(Trigger, '{name}', self.serve)"
CLIENT = "self.{other} = self.create_client(Trigger, '{other}')"


def node(name: str, other: str, *lines: str) -> str:
    text = "\n        ".join((CLIENT, *lines)).format(name=name, other=other)
    return NODE.format(cls=name.title(), name=name, other=other, lines=text)


def arm(*lines: str) -> str:
    return node("arm", "base", *lines)


def base(*lines: str) -> str:
    return node("base", "arm", *lines)


def found(folder: Path, monkeypatch: pytest.MonkeyPatch, launch: str = LAUNCH, **modules: str) -> list[Finding]:
    files = {f"{PACKAGE}my_first_package/{name}.py": text for name, text in modules.items()}
    if launch:
        files[f"{PACKAGE}launch/robot.launch.xml"] = launch
    workspace = Learned("start", "robot", files)
    complete(workspace, [])
    workspace.write(folder)
    (folder / "archlint.toml").write_text('select = ["SRV006"]\n', encoding="utf-8")
    monkeypatch.chdir(folder)
    return check(Request((".",), load(folder), cached=False, jobs=1)).findings


@pytest.mark.parametrize("wait", [FOREVER, LOOP, METHOD])
def test_both_offer_their_service_only_after_the_wait(tmp_path, monkeypatch, wait: str):
    [finding] = found(tmp_path, monkeypatch, arm=arm(wait, SERVES), base=base(FOREVER, SERVES))
    assert finding.message == (
        "/arm and /base wait for each other at their start (/arm for /base, /base for /arm): none of them ever goes on"
    )
    assert finding.help == "make the servers before waiting for others"
    assert [row.message for row in finding.related] == [
        "/arm waits for /base here",
        "/arm is made only afterwards",
        "/base waits for /arm here",
        "/base is made only afterwards",
    ]


def test_without_a_launch_file_nodes_of_one_package_run_together(tmp_path, monkeypatch):
    assert len(found(tmp_path, monkeypatch, "", arm=arm(FOREVER, SERVES), base=base(FOREVER, SERVES))) == 1


def test_a_response_of_a_node_that_waits_for_what_comes_after_it(tmp_path, monkeypatch):
    """The base's service is there, but nobody spins the base until it has found the arm's."""
    [finding] = found(tmp_path, monkeypatch, arm=arm(ASKS, SERVES), base=base(SERVES, FOREVER))
    assert finding.help == "wait for others in a timer, once the node is spun"
    assert "/base does not answer before that" in [row.message for row in finding.related]


@pytest.mark.parametrize(
    ("first", "second"),
    [
        (arm(SERVES, FOREVER), base(FOREVER, SERVES)),
        (arm(SERVES, FOREVER), base(SERVES, FOREVER)),
        (arm(LIMITED, SERVES), base(FOREVER, SERVES)),
        (arm(FOREVER, SERVES), base(SERVES)),
        (arm(SERVES, ASKS), base(SERVES, FOREVER)),
        (arm(SERVES, ASKS), base(SERVES, ASKS)),
        (arm("if self.executor:", "    " + FOREVER, SERVES), base(FOREVER, SERVES)),
    ],
    ids=[
        *("one is there", "both are there", "one gives up", "one does not wait", "it is found, and answers"),
        *("both spin while they wait", "on a condition"),
    ],
)
def test_nodes_that_come_up(tmp_path, monkeypatch, first: str, second: str):
    assert found(tmp_path, monkeypatch, arm=first, base=second) == []


def test_another_node_that_offers_one_of_the_two(tmp_path, monkeypatch):
    other = node("base", "arm", SERVES).replace("Base", "Spare").replace("__('base')", "__('spare')")
    launch = LAUNCH.replace("</launch>", '<node pkg="my_first_package" exec="spare"/></launch>')
    modules = {"arm": arm(FOREVER, SERVES), "base": base(FOREVER, SERVES), "spare": other}
    assert found(tmp_path, monkeypatch, launch, **modules) == []


BOTH = """\
import rclpy
from my_first_package.arm import Arm
from my_first_package.base import Base
from rclpy.executors import SingleThreadedExecutor


def main():
    rclpy.init()
    {first}
    {second}
    executor = SingleThreadedExecutor()
    executor.add_node(arm)
    executor.add_node(base)
    executor.spin()
"""


def alone(text: str) -> str:
    return text[: text.index("def main")]


def test_a_program_that_makes_the_server_after_the_node_that_waits(tmp_path, monkeypatch):
    nodes = {"arm": alone(arm(FOREVER)), "base": alone(base(SERVES))}
    both = BOTH.format(first="arm = Arm()", second="base = Base()")
    [finding] = found(tmp_path / "late", monkeypatch, "", both=both, **nodes)
    assert finding.place.file.endswith("arm.py")
    assert finding.message == (
        "this waits for the service 'base', which the program itself makes only afterwards: it never goes on"
    )
    both = BOTH.format(first="base = Base()", second="arm = Arm()")
    assert found(tmp_path / "early", monkeypatch, "", both=both, **nodes) == []


def test_a_node_that_waits_for_its_own_service(tmp_path, monkeypatch):
    late = node("arm", "arm", FOREVER, SERVES)
    assert len(found(tmp_path / "late", monkeypatch, "", arm=late)) == 1
    assert found(tmp_path / "early", monkeypatch, "", arm=node("arm", "arm", SERVES, FOREVER)) == []

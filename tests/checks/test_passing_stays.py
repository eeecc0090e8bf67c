"""EXE003: stays that a callback does not come to, that are over soon, or that delay nothing which counts."""

from __future__ import annotations

import pytest

from checks.judging import Judge
from robot_package import write_robot

NODE = """
import asyncio
import subprocess
import sys
import threading
import time

import rclpy
from rclpy.node import Node
from std_msgs.msg import Empty
from std_srvs.srv import Trigger


class Robot(Node):
    def __init__(self):
        super().__init__('robot')
        {first}
        self.create_subscription(Empty, 'go', self.on_go, 10)
        {beside}

    def on_go(self, message):
        {body}

    {more}


def main():
    rclpy.init()
    rclpy.spin(Robot())


main()
"""
BESIDE = "self.create_subscription(Empty, 'beside', print, 10)"


def node(body: str, first: str = "pass", beside: str = BESIDE, more: str = "") -> str:
    return NODE.format(
        first=first.replace("\n", "\n        "),
        beside=beside,
        body=body.replace("\n", "\n        "),
        more=more.replace("\n", "\n    "),
    )


DELAY = "self.declare_parameter('delay', {default})\nself.delay = self.get_parameter('delay').value"
SLEEP = "if self.delay > 0.0:\n    time.sleep(self.delay)"


@pytest.mark.parametrize(
    ("default", "body"),
    [
        ("0.0", SLEEP),
        ("0.0", "if self.delay <= 0.0:\n    return\ntime.sleep(9.0)"),
        ("False", "if self.delay:\n    time.sleep(9.0)"),
        ("''", "if self.delay and message:\n    subprocess.run(self.delay)"),
    ],
)
def test_a_stay_behind_a_parameter_that_is_off(judge: Judge, default: str, body: str):
    judge("EXE003", node(body, DELAY.format(default=default)))


@pytest.mark.parametrize(
    ("default", "body", "more"),
    [
        ("2.0", f"{SLEEP}  # here", ""),
        ("0.0", "if self.delay >= 0.0:\n    time.sleep(9.0)  # here", ""),
        ("0.0", "if self.delay > 0.0 or message:\n    time.sleep(9.0)  # here", ""),
        ("0.0", f"{SLEEP}  # here", "def set(self, delay):\n    self.delay = delay"),
    ],
    ids=["on by default", "at the default", "or for another reason", "set by other code"],
)
def test_a_stay_that_the_default_comes_to(judge: Judge, default: str, body: str, more: str):
    judge("EXE003", node(body, DELAY.format(default=default), more=more))


@pytest.mark.parametrize("key", ["delay", "rate"])
def test_a_parameter_that_a_file_of_the_package_sets(judge: Judge, key: str):
    package = judge.folder / "robot"
    write_robot(package)
    (package / "robot.yaml").write_text(f"robot:\n  ros__parameters:\n    {key}: 2.0\n", encoding="utf-8")
    judge("EXE003", node(f"{SLEEP}{'  # here' if key == 'delay' else ''}", DELAY.format(default="0.0")))


THREAD = "self.loop = None\nthreading.Thread(target=self.serve, daemon=True).start()"
SERVE = "def serve(self):\n    {before}\n    self.loop = asyncio.new_event_loop()\n    self.loop.run_forever()"
WAIT = "while self.loop is None:\n    time.sleep(0.1)"


def test_a_loop_that_waits_for_what_a_thread_sets_at_once(judge: Judge):
    judge("EXE003", node(WAIT, THREAD, more=SERVE.format(before="print('starting')")))


@pytest.mark.parametrize(
    ("first", "more"),
    [
        (THREAD, SERVE.format(before="while not input():\n        pass")),
        ("self.loop = None", SERVE.format(before="pass")),
        (THREAD, SERVE.format(before="pass") + "\n\ndef stop(self):\n    self.loop = None"),
    ],
    ids=["late", "no thread that the constructor starts", "taken back"],
)
def test_a_loop_that_may_wait_for_long(judge: Judge, first: str, more: str):
    judge("EXE003", node(f"{WAIT}  # here", first, more=more))


SERVICE = "self.far = self.create_client(Trigger, 'far')"
FINDS = "if not self.far.wait_for_service(timeout_sec=5.0):{here}\n    {miss}\n    return\nself.far.call_async({{}})"
GIVE_UP = "def give_up(self):\n    if rclpy.ok():\n        rclpy.shutdown()"


@pytest.mark.parametrize(("miss", "here"), [("self.give_up()", ""), ("sys.exit(1)", ""), ("print('none')", "  # here")])
def test_a_wait_that_ends_the_program_where_it_is_in_vain(judge: Judge, miss: str, here: str):
    judge("EXE003", node(FINDS.format(miss=miss, here=here), SERVICE, more=GIVE_UP))


EARLIER = "self.far.call_async(Trigger.Request()).add_done_callback(self.on_answer)\ntime.sleep(0.9){here}"
ANSWER = "def on_answer(self, future):\n    {line}"


@pytest.mark.parametrize(
    ("line", "here"),
    [
        ("self.get_logger().info(f'done: {future.result().success}')", ""),
        ("self.answered = future.result().success", "  # here"),
        ("self.publisher.publish(Empty())", "  # here"),
    ],
)
def test_an_answer_that_is_only_logged_may_be_late(judge: Judge, line: str, here: str):
    body = EARLIER.format(here=here)
    judge("EXE003", node(body, SERVICE, beside="pass", more=ANSWER.format(line=line)))


def test_a_wait_for_a_server_before_the_request_that_can_never_be_answered(judge: Judge):
    body = "self.far.wait_for_service(timeout_sec=5.0){here}\nself.far.call{asks}(Trigger.Request())"
    judge("EXE003", node(body.format(asks="", here=""), SERVICE))  # EXE002 speaks of the request
    judge("EXE003", node(body.format(asks="_async", here="  # here"), SERVICE))


KEEPS = "self.create_subscription(Empty, 'beside', self.on_beside, 10)"


@pytest.mark.parametrize(
    ("seconds", "handler", "told"),
    [
        ("2.5", "self.latest = message", False),
        ("2.5", "'Keep it.'\n    self.latest = [0.0]\n    self.latest[0] = float(message.data)", False),
        ("4.0", "self.latest = message", True),
        ("2.5", "self.motor.stop()", True),
        ("2.5", "self.latest = message\n    self.publisher.publish(message)", True),
        ("2.5", "if self.running:\n        self.latest = message", True),
    ],
    ids=["keeps it", "keeps a part of it", "for long", "acts", "passes it on", "under a condition"],
)
def test_beside_a_subscription_that_only_keeps_messages(judge: Judge, seconds: str, handler: str, told: bool):
    """In a large workspace; whoever learns hears of it anyway."""
    more = f"def on_beside(self, message):\n    {handler}"
    body = f"self.gone = True\ntime.sleep({seconds}){'  # here' if told else ''}\nself.gone = False"
    others = (
        f"class Idle{n}(Node):\n    def __init__(self):\n        super().__init__('i{n}')\n\n\n" for n in range(5)
    )
    judge("EXE003", node(body, beside=KEEPS, more=more).replace("def main", f"{''.join(others)}def main"))

"""TMO006: results that are used before it is known whether they have arrived."""

from __future__ import annotations

from textwrap import indent

import pytest

from checks.judging import Judge

SCRIPT = """
import threading
import time

import rclpy
from example_interfaces.action import Fibonacci
from example_interfaces.srv import AddTwoInts
from rclpy.action import ActionClient
from somewhere import keep


def main():
    rclpy.init()
    node = rclpy.create_node('script')
    client = node.create_client(AddTwoInts, 'add')
    action = ActionClient(node, Fibonacci, 'count')
    future = client.call_async(AddTwoInts.Request())
{lines}


if __name__ == '__main__':
    main()
"""
NODE = """
import time

import rclpy
from example_interfaces.srv import AddTwoInts
from rclpy.node import Node
from somewhere import Answer


class Robot(Node):
    def __init__(self):
        super().__init__('robot')
        self.client = self.create_client(AddTwoInts, 'add')
        self.answer = None
        self.timer = self.create_timer(1.0, self.tick)
        self.create_service(AddTwoInts, 'more', self.more)

{methods}


def main():
    rclpy.init()
    robot = Robot()
{lines}
    rclpy.spin(robot)


if __name__ == '__main__':
    main()
"""
SPIN = "rclpy.spin_until_future_complete(node, future, timeout_sec=2.0)"


def script(*lines: str) -> str:
    return SCRIPT.format(lines=indent("\n".join(lines), "    "))


def node(methods: str, lines: str = "pass") -> str:
    return NODE.format(methods=indent(methods.strip(), "    "), lines=indent(lines, "    "))


# --- a wait with a timeout


@pytest.mark.parametrize(
    "lines",
    [
        "print(future.result().sum)  # here",
        "response = future.result()\nprint(response.sum)  # here",
        "node.get_logger().info('done')\nprint(future.result().sum)  # here",
        "if not future.done():\n    print('no response')\nprint(future.result().sum)  # here",
        "if future.result() is None:\n    print('no response')\nprint(future.result().sum)  # here",
        "try:\n    print(future.result().sum)  # here\nexcept KeyboardInterrupt:\n    pass",
        "if future.done():\n    print('done')\nelse:\n    print(future.result().sum)  # here",
    ],
)
def test_a_result_that_may_not_have_arrived(judge: Judge, lines: str):
    [finding] = judge("TMO006", script(SPIN, lines))
    assert "if no response from the service 'add' arrives within 2 s, result() is None here" in finding.message


@pytest.mark.parametrize(
    "lines",
    [
        "if future.done():\n    print(future.result().sum)",
        "if not future.done():\n    return\nprint(future.result().sum)",
        "if future.result() is not None:\n    print(future.result().sum)",
        "if future.result():\n    print(future.result().sum)",
        "response = future.result()\nif response is None:\n    raise RuntimeError\nprint(response.sum)",
        "response = future.result()\nif not response:\n    return\nprint(response.sum)",
        "assert future.done()\nprint(future.result().sum)",
        "done = future.done()\nprint(future.result().sum if done else 0)",
        "print(future.done() and future.result().sum)",
        "if rclpy.ok() and future.done():\n    print(future.result().sum)",
        "if not rclpy.ok() or not future.done():\n    return\nprint(future.result().sum)",
        "try:\n    print(future.result().sum)\nexcept AttributeError:\n    print('no response')",
        "try:\n    print(future.result().sum)\nexcept Exception as error:\n    print(error)",
        "keep(future)\nprint(future.result().sum)",
        "print(future.result())",
        "future = None",
        f"while not future.done():\n    {SPIN}\nprint(future.result().sum)",
        f"while True:\n    {SPIN}\n    if future.done():\n        break\nprint(future.result().sum)",
    ],
)
def test_a_result_that_is_asked_for(judge: Judge, lines: str):
    assert not judge("TMO006", script(SPIN, lines))


@pytest.mark.parametrize(
    "spin",
    ["rclpy.spin_until_future_complete(node, future)", "rclpy.spin_until_future_complete(node, future, None, None)"],
)
def test_without_a_timeout_the_spin_ends_with_the_response(judge: Judge, spin: str):
    assert not judge("TMO006", script(spin, "print(future.result().sum)"))


def test_a_goal_that_may_not_have_been_accepted(judge: Judge):
    lines = ("future = action.send_goal_async(Fibonacci.Goal())", SPIN, "print(future.result().accepted)  # here")
    [finding] = judge("TMO006", script(*lines))
    assert "the action 'count'" in finding.message


ASK = """
def ask(self):
    self.future = self.client.call_async(AddTwoInts.Request())
    rclpy.spin_until_future_complete(self, self.future, timeout_sec=2.0)
    {end}

def tick(self):
    pass

def more(self, request, response):
    return response
"""


@pytest.mark.parametrize(
    ("end", "lines"),
    [
        ("return self.future.result()", "print(robot.ask().sum)  # here"),
        ("return self.future.result()", "response = robot.ask()\nprint(response.sum)  # here"),
        ("return self.future.result().sum  # here", "print(robot.ask())"),
    ],
)
def test_a_function_that_returns_the_result(judge: Judge, end: str, lines: str):
    judge("TMO006", node(ASK.format(end=end), lines))


@pytest.mark.parametrize(
    ("end", "lines"),
    [
        ("return self.future.result()", "response = robot.ask()\nif response is not None:\n    print(response.sum)"),
        ("return self.future.result()", "response = robot.ask()\nprint(response)"),
        ("return self.future.result() if self.future.done() else Answer()", "print(robot.ask().sum)"),
        ("if not self.future.done():\n        raise TimeoutError\n    return self.future.result()", "robot.ask().sum"),
    ],
)
def test_a_caller_that_asks(judge: Judge, end: str, lines: str):
    assert not judge("TMO006", node(ASK.format(end=end), lines))


# --- nothing between the request and its result


@pytest.mark.parametrize(
    "lines",
    [
        "print(future.result())  # here",
        "node.get_logger().info('sent')\nresponse = future.result()  # here",
        "print(client.call_async(AddTwoInts.Request()).result())  # here",
    ],
)
def test_a_result_that_cannot_be_there_yet(judge: Judge, lines: str):
    [finding] = judge("TMO006", script(lines))
    assert "the service 'add' has not responded yet, so it is None" in finding.message


def test_sleeping_does_not_help(judge: Judge):
    [finding] = judge("TMO006", script("time.sleep(1.0)\nprint(future.result())  # here"))
    assert "nothing takes the response from the service 'add' meanwhile, so it is None" in finding.message


def test_sleeping_does_not_help_a_callback(judge: Judge):
    methods = """
def tick(self):
    future = self.client.call_async(AddTwoInts.Request())
    time.sleep(1.0)
    print(future.result())  # here

def more(self, request, response):
    return response
"""
    [finding] = judge("EXE002", node(methods))
    assert "no response from the service 'add' is taken meanwhile, so it is None" in finding.message


@pytest.mark.parametrize(
    "lines",
    [
        "rclpy.spin_until_future_complete(node, future)\nprint(future.result())",
        "threading.Thread(target=rclpy.spin, args=(node,)).start()\nfuture = client.call_async(AddTwoInts.Request())\n"
        "time.sleep(1.0)\nprint(future.result())",
        "while not future.done():\n    rclpy.spin_once(node)\nprint(future.result())",
        "node.sleep(1.0)\nprint(future.result())",
        "keep(node)\nprint(future.result())",
    ],
)
def test_a_result_after_a_wait(judge: Judge, lines: str):
    assert not judge("TMO006", script(lines))


def test_in_a_callback_another_rule_tells_of_it(judge: Judge):
    methods = """
def tick(self):
    print(self.client.call_async(AddTwoInts.Request()).result())

def more(self, request, response):
    return response
"""
    assert not judge("TMO006", node(methods))


# --- a future is not the response


@pytest.mark.parametrize(
    "lines",
    [
        "print(future.sum)  # here",
        "rclpy.spin_until_future_complete(node, future)\nprint(future.result.sum)  # here",
        "handle = action.send_goal_async(Fibonacci.Goal())\nif not handle.accepted:  # here\n    return",
    ],
)
def test_a_future_taken_for_its_result(judge: Judge, lines: str):
    [finding] = judge("TMO006", script(lines))
    assert "raises an AttributeError" in finding.message


@pytest.mark.parametrize(
    "lines",
    [
        "future.sum = 1\nprint(future.sum)",
        "future.number = 1\nprint(future.number)",
        "print(getattr(future, 'sum', 0))",
        "if hasattr(future, 'sum'):\n    print(future.sum)",
        "try:\n    print(future.sum)\nexcept AttributeError:\n    print('not yet')",
        "print(future.result.__name__)",
        "print(future.done(), future.cancelled())",
        "rclpy.spin_until_future_complete(node, future)\nfuture = future.result()\nprint(future.sum)",
    ],
)
def test_a_future_that_is_used_as_one(judge: Judge, lines: str):
    assert not judge("TMO006", script(lines))


TICK = """
def tick(self):
    {tick}

{handler}
"""
HANDLER = "def more(self, request, response):\n    return response"


@pytest.mark.parametrize(
    ("tick", "handler"),
    [
        ("self.answer = self.client.call_async(AddTwoInts.Request())\n    print(self.answer.sum)  # here", HANDLER),
        ("pass", "def more(self, request, response):\n    return self.client.call_async(request)  # here"),
        (
            "pass",
            "def more(self, request, response):\n    sent = self.client.call_async(request)\n    return sent  # here",
        ),
        (
            "pass",
            "async def more(self, request, response):\n    return self.client.call_async(request)  # here",
        ),
    ],
)
def test_a_callback_that_takes_a_future_for_the_response(judge: Judge, tick: str, handler: str):
    judge("TMO006", node(TICK.format(tick=tick, handler=handler)))


@pytest.mark.parametrize(
    ("tick", "handler"),
    [
        ("self.client.call_async(AddTwoInts.Request()).add_done_callback(self.on_sum)", HANDLER + ON_SUM)
        for ON_SUM in (
            "\n\ndef on_sum(self, future):\n    print(future.result().sum)",
            "\n\ndef on_sum(self, future):\n    self.answer = future.result()\n    print(self.answer.sum)",
        )
    ]
    + [
        ("pass", "async def more(self, request, response):\n    return await self.client.call_async(request)"),
        (
            "pass",
            "async def more(self, request, response):\n    answer = await self.client.call_async(request)\n"
            "    response.sum = answer.sum\n    return response",
        ),
        ("pass", "def more(self, request, response):\n    self.client.call_async(request)\n    return response"),
    ],
)
def test_a_callback_that_waits_for_the_response(judge: Judge, tick: str, handler: str):
    assert not judge("TMO006", node(TICK.format(tick=tick, handler=handler)))


def test_an_attribute_that_holds_the_response_later(judge: Judge):
    methods = """
def tick(self):
    if self.answer is None:
        self.answer = self.client.call_async(AddTwoInts.Request())
        self.answer.add_done_callback(self.on_sum)

def on_sum(self, future):
    self.answer = future.result()

def more(self, request, response):
    if self.answer is not None:
        response.sum = self.answer.sum
    return response
"""
    assert not judge("TMO006", node(methods))


# --- a result that a callback reads too early

SENT = """
def tick(self):
    {use}

def ask(self):
    self.future = self.client.call_async(AddTwoInts.Request())
    return self.future.result(){mark}

def more(self, request, response):
    return response
"""


def sent(use: str, main: str = "pass", mark: str = "  # here") -> str:
    return node(SENT.format(use=use, mark=mark), main)


@pytest.mark.parametrize(
    ("use", "told"),
    [
        ("self.ask()", False),
        ("if self.answer is None:\n        self.ask()", False),
        ("print(self.ask().sum)", True),
        ("self.answer = self.ask()", True),
        ("self.ask()\n    print(self.ask().sum)", True),
    ],
)
def test_a_result_that_comes_too_early_is_an_error_where_something_uses_it(judge: Judge, use: str, told: bool):
    judge("EXE002", sent(use, mark="  # here" if told else ""))


def test_what_a_callback_comes_to_is_told_once_whoever_else_does(judge: Judge):
    judge("EXE002", sent("print(self.ask())", "robot.ask()"))
    judge("TMO006", sent("print(self.ask())", "robot.ask()", mark=""))


def test_where_a_callback_may_come_nobody_is_told_to_spin(judge: Judge):
    [uncalled] = judge(
        "TMO006", sent("pass", "keep(robot.ask)").replace("from somewhere import Answer", "from somewhere import keep")
    )
    assert uncalled.help.startswith("read it in a done callback")
    [of_main] = judge("TMO006", sent("pass", "print(robot.ask())"))
    assert of_main.help.startswith("wait for it first: rclpy.spin_until_future_complete")


# ------------------------------------------------------------------------------- what a spin returns

RETURNED = """
import rclpy
from rclpy.executors import SingleThreadedExecutor
from somewhere import helper


def ask(node, future, executor):
    {line}
"""


@pytest.mark.parametrize(
    "line",
    [
        "if rclpy.spin_until_future_complete(node, future, timeout_sec=1.0):  # here\n        return future.done()",
        "if not rclpy.spin_until_future_complete(node, future):  # here\n        return None",
        "while rclpy.spin_until_future_complete(node, future) is None:  # here\n        pass",
        "if future.done() or executor.spin_until_future_complete(future):  # here\n        return True",
        "return 1 if rclpy.spin_until_future_complete(node, future) else 2  # here",
    ],
)
def test_what_a_spin_returns_decides_nothing(judge: Judge, line: str):
    (finding,) = judge("TMO006", RETURNED.format(line=line))
    assert finding.help == "call it, and then ask future.done()"


@pytest.mark.parametrize(
    "line",
    [
        "rclpy.spin_until_future_complete(node, future)\n    return future.done()",
        "if helper.spin_until_future_complete(node, future):\n        return None",  # one of another library
        "if helper.check(rclpy.spin_until_future_complete(node, future)):\n        return None",
        "return rclpy.spin_until_future_complete(node, future)",
    ],
)
def test_a_spin_whose_result_nobody_asks_for(judge: Judge, line: str):
    judge("TMO006", RETURNED.format(line=line))

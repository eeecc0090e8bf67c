"""API001: coroutines of own functions that nobody awaits."""

from __future__ import annotations

import pytest

from checks.judging import Judge

NODE = """
import asyncio
from contextlib import asynccontextmanager

import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Link:
    async def send(self, text):
        await asyncio.sleep(0.1)
        print(text)


class Bridge(Node):
    def __init__(self):
        super().__init__('bridge')
        self.link = Link()
        self.create_subscription(String, 'text', self.on_text, 10)
        {in_constructor}

    async def send(self, message):
        await self.link.send(message.data)

    def note(self, message):
        self.get_logger().info(message.data)

    async def each(self):
        yield 1

    @asynccontextmanager
    async def opened(self):
        yield self.link

    def on_text(self, message):
        {line}

    async def on_async(self, message):
        {in_async}


def main():
    rclpy.init()
    rclpy.spin(Bridge())


main()
"""


def node(line: str = "pass", in_async: str = "pass", in_constructor: str = "pass") -> str:
    return NODE.format(line=line, in_async=in_async, in_constructor=in_constructor)


AWAITS = "self.create_subscription(String, 'more', self.on_async, 10)"


@pytest.mark.parametrize(
    ("source", "name", "help"),
    [
        (node("self.send(message)  # here"), "send", "await it in an async function"),
        (node("self.link.send(message.data)  # here"), "send", "await it in an async function"),
        (node(in_async="self.send(message)  # here", in_constructor=AWAITS), "send", "write await self.send(…)"),
        (
            node(in_constructor="self.create_subscription(String, 'a', lambda m: self.send(m), 10)  # here"),
            "send",
            "pass self.send itself, or an async function that awaits it",
        ),
    ],
)
def test_a_coroutine_that_nobody_awaits(judge: Judge, source: str, name: str, help: str) -> None:
    (finding,) = judge("API001", source)
    assert finding.message == f"nothing of {name}() is run: the call makes a coroutine, and nobody awaits that"
    assert finding.help == help


@pytest.mark.parametrize(
    "source",
    [
        node("asyncio.run(self.send(message))"),
        node("self.executor.create_task(self.send(message))"),
        node("self.note(message)"),
        node("task = self.send(message)\n        asyncio.run(task)"),
        node("self.each()"),
        node("self.opened()"),
        node(in_async="await self.send(message)", in_constructor=AWAITS),
        node(in_constructor="self.create_subscription(String, 'a', self.send, 10)"),
        node(in_constructor="self.create_subscription(String, 'a', lambda m: self.note(m), 10)"),
    ],
)
def test_a_coroutine_that_somebody_gets_and_what_is_none(judge: Judge, source: str) -> None:
    judge("API001", source)

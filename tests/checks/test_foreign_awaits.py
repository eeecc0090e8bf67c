"""EXE010: what needs asyncio's event loop, in callbacks that rclpy runs."""

from __future__ import annotations

import pytest

from checks.judging import Judge

NODE = """
import asyncio
import subprocess
from asyncio import sleep

import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Robot(Node):
    def __init__(self):
        super().__init__('robot')
        self.declare_parameter('pause', 0.5)
        self.create_subscription(String, 'in', self.listen, 10)
        self.create_timer(1.0, self.tick)

    async def listen(self, message):
        {line}

    def tick(self):
        {tick}

    async def rest(self):
        {rest}


def main():
    rclpy.init()
    {main}


if __name__ == '__main__':
    main()
"""


def node(line: str = "pass", rest: str = "pass", tick: str = "pass", main: str = "rclpy.spin(Robot())") -> str:
    return NODE.format(line=line, rest=rest, tick=tick, main=main)


@pytest.mark.parametrize(
    ("line", "rest"),
    [
        ("await asyncio.sleep(0.5)  # here", "pass"),
        ("await sleep(1)  # here", "pass"),
        ("if message.data:\n            await asyncio.sleep(0.5)  # here", "pass"),
        ("await self.rest()", "await asyncio.sleep(0.5)  # here"),
        ("await asyncio.wait_for(self.rest(), 1.0)  # here", "pass"),
        ("await asyncio.gather(self.rest(), self.rest())  # here", "pass"),
        ("await asyncio.to_thread(print, 'hello')  # here", "pass"),
        ("await asyncio.create_subprocess_exec('ls')  # here", "pass"),
        ("try:\n            await asyncio.sleep(1)  # here\n        except ValueError:\n            pass", "pass"),
        ("subprocess.run('ls')\n        await asyncio.sleep(0.5)  # here", "pass"),
    ],
)
def test_an_await_that_raises(judge: Judge, line: str, rest: str):
    [finding] = judge("EXE010", node(line, rest))
    assert "raises a RuntimeError: rclpy's executor is no event loop of asyncio" in finding.message


@pytest.mark.parametrize(
    ("line", "either"),
    [
        ("await asyncio.wait_for(self.planner.call_async(Trigger.Request()), 1.0)  # here", True),
        ("sent = self.planner.call_async(Trigger.Request())\n        await asyncio.wait_for(sent, 1.0)  # here", True),
        ("await asyncio.wait_for(self.rest(), 1.0)  # here", False),
        ("rest = self.rest()\n        await asyncio.wait_for(rest, timeout=1.0)  # here", False),
    ],
)
def test_a_future_of_rclpy_needs_no_loop_and_gets_none_in_a_thread(judge: Judge, line: str, either: bool):
    """asyncio takes no Future of rclpy, in whatever loop."""
    text = node(line).replace("import String\n", "import String\nfrom std_srvs.srv import Trigger\n")
    planner = "super().__init__('robot')\n        self.planner = self.create_client(Trigger, 'plan')"
    [finding] = judge("EXE010", text.replace("super().__init__('robot')", planner))
    assert finding.help == (
        "await an rclpy.task.Future that a timer completes, or the answer in its add_done_callback()"
        if either
        else "do this in a thread of its own, with asyncio.run()"
    )


@pytest.mark.parametrize(
    "tick", ["asyncio.create_task(self.rest())  # here", "task = asyncio.create_task(sleep(1))  # here"]
)
def test_a_task_that_no_loop_can_run(judge: Judge, tick: str):
    [finding] = judge("EXE010", node(tick=tick))
    assert "calls asyncio.create_task()" in finding.message


@pytest.mark.parametrize(
    ("line", "rest"),
    [
        ("await asyncio.sleep(0)", "pass"),
        ("await asyncio.sleep(self.get_parameter('pause').value)", "pass"),
        ("await asyncio.sleep(message.data)", "pass"),
        ("asyncio.run(self.rest())", "await asyncio.sleep(0.5)"),
        ("asyncio.ensure_future(self.rest())", "await asyncio.sleep(0.5)"),
        ("self.rest()", "await asyncio.sleep(0.5)"),
        ("pass", "await asyncio.sleep(0.5)"),
        ("try:\n            await asyncio.sleep(1)\n        except RuntimeError:\n            pass", "pass"),
        ("await self.executor.create_task(self.rest)", "pass"),
    ],
)
def test_an_await_that_works_or_is_of_another_loop(judge: Judge, line: str, rest: str):
    assert not judge("EXE010", node(line, rest))


@pytest.mark.parametrize(
    "main",
    [
        "asyncio.run(Robot().rest())",
        "loop = asyncio.get_event_loop()\n    loop.run_until_complete(Robot().rest())",
        "asyncio.run_coroutine_threadsafe(Robot().rest(), None)\n    rclpy.spin(Robot())",
    ],
)
def test_where_a_loop_may_run_nothing_is_certain(judge: Judge, main: str):
    assert not judge("EXE010", node("await asyncio.sleep(0.5)", "await asyncio.sleep(0.5)", main=main))


def test_an_executor_that_is_not_rclpys_own(judge: Judge):
    text = """
        import asyncio

        import rclpy
        from rclpy.node import Node
        from somewhere import LoopExecutor
        from std_msgs.msg import String


        class Robot(Node):
            def __init__(self):
                super().__init__('robot')
                self.create_subscription(String, 'in', self.listen, 10)

            async def listen(self, message):
                await asyncio.sleep(0.5)


        def main():
            rclpy.init()
            executor = LoopExecutor()
            executor.add_node(Robot())
            executor.spin()


        if __name__ == '__main__':
            main()
        """
    assert not judge("EXE010", text)

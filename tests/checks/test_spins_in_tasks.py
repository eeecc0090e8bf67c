"""EXE010: spins without an end in coroutines that asyncio runs beside others."""

from __future__ import annotations

import pytest

from checks.judging import Judge

PROGRAM = """
import asyncio

import rclpy
from rclpy.executors import SingleThreadedExecutor
from rclpy.node import Node

node = None
executor = SingleThreadedExecutor()


async def spin():
    {spin}


async def serve():
    await asyncio.sleep(1.0)


async def both():
    {both}


def main():
    rclpy.init()
    asyncio.run(both())


main()
"""


@pytest.mark.parametrize("spin", ["rclpy.spin(node)", "executor.spin()"])
@pytest.mark.parametrize(
    "both",
    [
        "await asyncio.gather(spin(), serve())",
        "task = asyncio.create_task(spin())\n    await serve()\n    await task",
        "await asyncio.wait([serve()], spin())",
    ],
)
def test_a_spin_that_keeps_other_tasks_from_running(judge: Judge, spin: str, both: str) -> None:
    (finding,) = judge("EXE010", PROGRAM.format(spin=f"{spin}  # here", both=both))
    told = "spin() spins and never gives the thread back to asyncio: the tasks beside it stand still"
    assert finding.message == told


@pytest.mark.parametrize(
    ("spin", "both"),
    [
        ("rclpy.spin(node)", "await spin()"),
        ("rclpy.spin(node)", "await asyncio.gather(spin())"),
        ("await asyncio.to_thread(rclpy.spin, node)", "await asyncio.gather(spin(), serve())"),
        ("rclpy.spin_once(node, timeout_sec=0.0)", "await asyncio.gather(spin(), serve())"),
        ("node.wheel.spin()", "await asyncio.gather(spin(), serve())"),
    ],
)
def test_a_spin_that_keeps_nobody_waiting(judge: Judge, spin: str, both: str) -> None:
    judge("EXE010", PROGRAM.format(spin=spin, both=both))

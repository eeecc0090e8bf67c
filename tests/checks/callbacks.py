"""Runs the rules over one file of a node, so that tests of callbacks read like examples."""

from __future__ import annotations

import textwrap
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

from archlint.config.selection import Layer
from archlint.config.settings import load
from archlint.engine.pipeline import Request, check
from archlint.finding import Finding

Run = Callable[..., list[Finding]]

IMPORTS = """\
import asyncio
import subprocess
import threading
import time
from functools import partial

import rclpy
from example_interfaces.action import Fibonacci
from rclpy.action import ActionClient, ActionServer
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup, ReentrantCallbackGroup
from rclpy.duration import Duration
from rclpy.executors import MultiThreadedExecutor, SingleThreadedExecutor
from rclpy.node import Node
from std_msgs.msg import Empty
from std_srvs.srv import SetBool, Trigger
from tf2_ros import Buffer, TransformListener
"""

ON_ONE_THREAD = """
def main():
    rclpy.init()
    rclpy.spin(Robot())


if __name__ == '__main__':
    main()
"""

ON_SEVERAL_THREADS = """
def main():
    rclpy.init()
    executor = MultiThreadedExecutor()
    executor.add_node(Robot())
    executor.spin()


if __name__ == '__main__':
    main()
"""


def source(constructor: str, methods: str, main: str = ON_ONE_THREAD) -> str:
    """A file with the node ``Robot``: the body of its constructor, its methods, and what runs it."""
    body = textwrap.indent(textwrap.dedent(constructor).strip("\n"), " " * 8)
    rest = textwrap.indent(textwrap.dedent(methods).strip("\n"), " " * 4)
    head = f"class Robot(Node):\n    def __init__(self):\n        super().__init__('robot')\n{body}\n\n{rest}\n"
    return f"{IMPORTS}\n\n{head}\n{textwrap.dedent(main)}"


def findings(folder: Path, text: str, distro: str | None = None) -> list[Finding]:
    """What the rules that are on by default find in a file; those about API are left out: the callbacks of tests read
    attributes and call functions that no code of theirs defines, and make calls that fail on purpose."""
    (folder / "robot.py").write_text(text, encoding="utf-8")
    settings = load(folder)
    without = replace(settings, distro=distro, layers=(*settings.layers, Layer(ignore=("API",))))
    return list(check(Request((".",), without, cached=False, jobs=1)).findings)


def codes(found: list[Finding]) -> list[str]:
    return [one.code for one in found]

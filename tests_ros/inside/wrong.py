"""Runs pieces of code on a node, each in a process of its own, and says what each raises: JSON in, JSON out.

In: ``{name: code}``; out: ``{name: "TypeError: the message"}``, "" where nothing is raised, also not while the node is
spun for a moment, and ``dies of signal 6`` where the process does.
"""

from __future__ import annotations

import json
import os
import sys
import threading
import time

import rclpy
import rclpy.action
import rclpy.executors
import rclpy.time
from geometry_msgs.msg import PoseStamped, PoseWithCovariance, Twist
from nav_msgs.msg import Path
from rclpy.node import Node
from rclpy.parameter import Parameter
from rclpy.qos import QoSProfile
from std_msgs.msg import Int32, String
from std_srvs.srv import SetBool, Trigger
from test_msgs.action import Fibonacci

SPUN_S = 0.3


def main() -> None:
    json.dump({name: alone(code) for name, code in json.load(sys.stdin).items()}, sys.stdout)


def alone(code: str) -> str:
    reading, writing = os.pipe()
    child = os.fork()
    if not child:
        os.dup2(os.open(os.devnull, os.O_WRONLY), 1)
        rclpy.init()
        os.write(writing, raised(code).encode())
        os._exit(0)
    os.close(writing)
    with os.fdopen(reading, "rb") as pipe:
        said = pipe.read().decode()
    _, status = os.waitpid(child, 0)
    return f"dies of signal {os.WTERMSIG(status)}" if os.WIFSIGNALED(status) else said


def raised(code: str) -> str:
    executor = rclpy.executors.SingleThreadedExecutor()
    try:
        node = Node("asker")
        executor.add_node(node)
        names = {**globals(), "node": node, "executor": executor}
        exec(code, names)
        end = time.monotonic() + SPUN_S
        while time.monotonic() < end:
            executor.spin_once(timeout_sec=0.05)
    except BaseException as error:
        return f"{type(error).__name__}: {' '.join(str(error).split())[:100]}"
    finally:
        executor.shutdown()
    return ""


if __name__ == "__main__":
    assert threading and Parameter and QoSProfile and PoseStamped and PoseWithCovariance and Twist
    assert Int32 and Path and String and SetBool and Trigger and Fibonacci
    main()

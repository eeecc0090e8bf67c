"""Asks for advice on a small workspace."""

from __future__ import annotations

from pathlib import Path

from archlint.advice.advising import advice_of
from archlint.advice.model import Advice
from archlint.config.settings import Settings
from archlint.engine.pipeline import Request, asked_for
from archlint.ros.distros import DISTROS
from learners import Learned, complete

HEAD = """\
import random
import time

import rclpy
from example_interfaces.action import Fibonacci
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from rclpy.action import ActionClient, ActionServer
from rclpy.node import Node
from sensor_msgs.msg import BatteryState, Image
from std_msgs.msg import Bool, Float64, String
from std_srvs.srv import SetBool, Trigger
from my_robot_interfaces.srv import GetSensorData, SetMotorSpeed


"""
MAIN = """

def main():
    rclpy.init()
    rclpy.spin({cls}())
"""


def node(name: str, constructor: str, methods: str = "") -> str:
    """A module with one node: the lines of its constructor, and its methods."""
    cls = name.title().replace("_", "")
    body = "".join(f"        {line}\n" for line in constructor.strip().splitlines())
    rest = "".join(f"    {line}\n" if line else "\n" for line in methods.strip("\n").splitlines())
    return (
        f"{HEAD}class {cls}(Node):\n    def __init__(self):\n        super().__init__('{name}')\n{body}\n{rest}"
        + MAIN.format(cls=cls)
    )


def advised(root: Path, *beside: str, **modules: str) -> dict[str, Advice]:
    """What is advised for each connection of a package with these modules, by its name."""
    workspace = Learned("", "")
    for name, text in modules.items():
        folder = "launch/" if "/" in name or name.endswith("launch.xml") else "my_first_package/"
        suffix = "" if "." in name else ".py"
        workspace.files[f"src/my_first_package/{folder}{name}{suffix}"] = text
    complete(workspace, list(beside))
    workspace.write(root)
    systems = asked_for(Request((str(root),), Settings(), cached=False, jobs=1))
    return {advice.name: advice for advice in advice_of(systems, DISTROS)}

"""Systems made of the bodies of node classes, and what leads where in them."""

from __future__ import annotations

from pathlib import Path
from textwrap import dedent, indent

from archlint.config.settings import load
from archlint.dataflow.graph import flow_of
from archlint.dataflow.latency import terms
from archlint.dataflow.model import Flow, Link, Step
from archlint.dataflow.paths import reached
from archlint.dataflow.subjects import subjects
from archlint.dataflow.systems import traces_of
from archlint.dataflow.trace import Trace
from archlint.engine.pipeline import Request, systems
from archlint.systems.model import System

_HEAD = """\
import threading
import time
import message_filters
import rclpy
from rclpy.action import ActionClient, ActionServer
from rclpy.node import Node
from example_interfaces.action import Fibonacci
from geometry_msgs.msg import PointStamped, TransformStamped
from std_msgs.msg import Header, String
from std_srvs.srv import Trigger
from tf2_ros import Buffer, TransformBroadcaster, TransformListener


"""


class Traced:
    """``traced(talker=BODY, listener=BODY)`` makes a script for each node, whose class has that body."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder

    def __call__(self, **bodies: str) -> Traced:
        for name, body in bodies.items():
            code = f"class {name.title()}(Node):\n{indent(dedent(body).strip(), '    ')}\n"
            main = f"rclpy.init()\nrclpy.spin({name.title()}())\n"
            (self.folder / f"{name}.py").write_text(_HEAD + code + "\n\n" + main, encoding="utf-8")
        return self

    def file(self, name: str, text: str) -> Traced:
        """A file as it is."""
        (self.folder / name).write_text(dedent(text).lstrip("\n"), encoding="utf-8")
        return self

    @property
    def systems(self) -> list[System]:
        return systems(Request((".",), load(self.folder), cached=False, jobs=1))

    @property
    def flow(self) -> Flow:
        """The flow of the system of all nodes."""
        return flow_of(self.systems[0])

    def before(self, name: str) -> set[str]:
        """The callbacks, connections and attributes from which data comes to a name."""
        flow = self.flow
        [subject] = subjects(flow, name)
        seen = reached(flow, subject.arriving, "back")
        return {shown(step) for step in flow.steps if id(step) in seen} - {f"{subject.kind} {subject.name}"}

    def after(self, name: str) -> set[str]:
        """Those to which data goes from a name."""
        flow = self.flow
        [subject] = subjects(flow, name)
        seen = reached(flow, subject.leaving, "on")
        return {shown(step) for step in flow.steps if id(step) in seen} - {f"{subject.kind} {subject.name}"}

    def trace(self, name: str, origin: str | None = None, end: str | None = None) -> Trace:
        [trace] = traces_of(self.systems, name, origin, end)
        return trace

    def way(self, name: str, origin: str | None = None, end: str | None = None) -> list[tuple[float | None, str]]:
        """The times along the only way of a trace."""
        trace = self.trace(name, origin, end)
        [way] = trace.ways
        return [(term.seconds, term.words) for term in terms(trace.flow, way.links)]


def shown(step: Step) -> str:
    return f"{step.kind} {step.name}".removeprefix("callback ")


def links_of(flow: Flow, tail: str, head: str) -> list[Link]:
    return [link for link in flow.links if shown(link.tail) == tail and shown(link.head) == head]

"""Runs one program under a real rclpy and writes down, from inside, which nodes it has.

``main`` runs in a fork of ``server.py``: the target is ``module:function``, as in an entry point, or a script.  The
record gets JSON whenever something has changed, until the process is killed: a program that has ended is kept, to be
looked at from outside.
"""

from __future__ import annotations

import contextlib
import copy
import importlib
import json
import os
import runpy
import sys
import threading
import time
from collections.abc import Callable
from pathlib import Path
from types import FrameType
from typing import Any

from rclpy.action import (
    get_action_client_names_and_types_by_node,
    get_action_server_names_and_types_by_node,
)
from rclpy.client import Client
from rclpy.context import Context
from rclpy.executors import Executor
from rclpy.lifecycle import LifecycleNode
from rclpy.node import Node
from rclpy.publisher import Publisher
from rclpy.service import Service
from rclpy.subscription import Subscription

QUIET_S = 0.6
"""How long nothing new must come up until a program that spins counts as settled."""
WAITING_S = 6.0
"""How long nothing new must come up until a program that does not spin counts as waiting for something."""
LOOK_S = 0.2
SELDOM_S = 0.5
"""How often a program is looked at, and one that has settled."""

lines: set[tuple[str, int]] = set()
"""Executed lines of files below the root."""
nodes: list[Node] = []
"""All nodes that were made, which keeps them alive."""
seen: dict[str, dict[str, Any]] = {}
"""Each node by its name, as it last was before it was destroyed or shut down."""
left: list[Node] = []
"""Those that were destroyed or shut down."""
looking = threading.RLock()
going = threading.Event()
"""That an executor of the program spins, or that the program has ended: the constructors are through."""
ended: list[str] = []
"""What the program raised, or "", once it has ended."""


def main(record: str, root: str, target: str, arguments: list[str]) -> None:
    note_objects()
    trace = tracer(root)
    threading.Thread(target=watch, args=(Path(record), root, trace), daemon=True).start()
    threading.settrace(trace)
    sys.settrace(trace)
    ended.append(run(target, arguments))
    sys.settrace(None)
    going.set()
    threading.Event().wait()


def run(target: str, arguments: list[str]) -> str:
    """Runs the program to its end, if it has one; what it raised, as text."""
    sys.argv = [target, *arguments]
    try:
        if target.endswith(".py"):
            runpy.run_path(target, run_name="__main__")
        else:
            module, _, function = target.partition(":")
            getattr(importlib.import_module(module), function)()
    except BaseException as error:
        return repr(error)
    return ""


def tracer(root: str) -> Callable[[FrameType, str, Any], Any]:
    """Notes the executed lines of what is below ``root``."""

    def on_call(frame: FrameType, event: str, argument: Any) -> Any:
        return on_line if frame.f_code.co_filename.startswith(root) else None

    def on_line(frame: FrameType, event: str, argument: Any) -> Any:
        lines.add((frame.f_code.co_filename, frame.f_lineno))
        return on_line

    return on_call


def note_objects() -> None:
    """Hooks that only look: which nodes there are, with which QoS an end was made, and what was there at the end."""
    after(Node, "__init__", lambda node: None, first=nodes.append)
    for kind in (Publisher, Subscription, Service, Client):
        after(kind, "__init__", keep_profile)
    after(Executor, "wait_for_ready_callbacks", lambda executor: None, first=lambda executor: going.set())
    after(Node, "destroy_node", lambda node: None, first=lambda node: look([node], gone=True))
    after(Context, "shutdown", lambda context: None, first=lambda context: look(nodes, gone=True))


def after(kind: type, name: str, then: Callable[[Any], None], first: Callable[[Any], None] = lambda one: None) -> None:
    original = getattr(kind, name)

    def hooked(self: Any, *arguments: Any, **keywords: Any) -> Any:
        first(self)
        result = original(self, *arguments, **keywords)
        then(self)
        return result

    setattr(kind, name, hooked)


def keep_profile(end: Any) -> None:
    """A profile may be changed afterwards, which changes nothing of what was made with it."""
    end.profile_when_made = copy.copy(end.qos_profile)


def watch(record: Path, root: str, trace: Callable[[FrameType, str, Any], Any]) -> None:
    """Writes the record for as long as the process lives."""
    written, before, since = "", "", time.monotonic()
    brought_up = False
    while True:
        look(nodes)
        now = json.dumps(seen, sort_keys=True)
        if now != before:
            before, since = now, time.monotonic()
        quiet = time.monotonic() - since > (QUIET_S if going.is_set() else WAITING_S)
        if seen and quiet and not brought_up:
            brought_up = True
            since = bring_up(trace) or since
            continue
        text = written_down(root, settled=quiet and bool(seen))
        if text != written:
            write(record, text)
            written = text
        time.sleep(SELDOM_S if brought_up and quiet else LOOK_S)


def bring_up(trace: Callable[[FrameType, str, Any], Any]) -> float | None:
    """Configures and activates the lifecycle nodes, as whoever starts them would; when, if there are any."""
    sys.settrace(trace)
    managed = [node for node in alive() if isinstance(node, LifecycleNode)]
    for node in managed:
        node.trigger_configure()
        node.trigger_activate()
    sys.settrace(None)
    return time.monotonic() if managed else None


def written_down(root: str, settled: bool) -> str:
    ran = sorted([os.path.relpath(file, root), line] for file, line in lines.copy())
    return json.dumps({"nodes": seen, "lines": ran, "settled": settled, "ended": ended[0] if ended else None})


def write(record: Path, text: str) -> None:
    """In one step, for whoever reads it at the same time."""
    part = record.with_name(record.name + ".part")
    part.write_text(text)
    part.rename(record)


def look(at: list[Node], gone: bool = False) -> None:
    """Notes what nodes have; of one that is ``gone`` after this, for the last time."""
    with looking:
        for node in at.copy():
            with contextlib.suppress(Exception):  # half made, or being destroyed: the next look will tell
                if node in alive() and node not in left:
                    seen[node.get_fully_qualified_name()] = everything_of(node) | {"gone": gone}
                    if gone:
                        left.append(node)


def alive() -> list[Node]:
    return [node for node in nodes.copy() if made(node)]


def made(node: Node) -> bool:
    try:
        return bool(node.context.ok() and node.get_name())
    except Exception:  # half made, or destroyed
        return False


def everything_of(node: Node) -> dict[str, Any]:
    name, namespace = node.get_name(), node.get_namespace()
    return {
        "publishers": [[one.topic_name, type_name(one.msg_type), profile(one)] for one in node.publishers],
        "subscribers": [[one.topic_name, type_name(one.msg_type), profile(one)] for one in node.subscriptions],
        "services": [[one.service_name, type_name(one.srv_type), profile(one)] for one in node.services],
        "clients": [[one.service_name, type_name(one.srv_type), profile(one)] for one in node.clients],
        "action_servers": actions(get_action_server_names_and_types_by_node(node, name, namespace)),
        "action_clients": actions(get_action_client_names_and_types_by_node(node, name, namespace)),
        "timers": sorted(one.timer_period_ns / 1e9 for one in node.timers),
        "parameters": [[one.name, one.type_.name, plain(one.value)] for one in node._parameters.copy().values()],
    }


def actions(found: list[tuple[str, list[str]]]) -> list[list[Any]]:
    return [[name, type_, None] for name, types in found for type_ in types]


def type_name(type_: Any) -> str:
    package, kind, _ = type_.__module__.split(".", 2)
    return f"{package}/{kind}/{type_.__name__}"


def profile(end: Any) -> dict[str, Any]:
    made_with = end.profile_when_made
    return {
        "history": made_with.history.name.lower(),
        "depth": made_with.depth,
        "reliability": made_with.reliability.name.lower(),
        "durability": made_with.durability.name.lower(),
    }


def plain(value: Any) -> Any:
    return value if value is None or isinstance(value, (bool, int, float, str)) else [plain(one) for one in value]

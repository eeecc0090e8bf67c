"""Runs one program under a real rclpy and writes down, from inside, which nodes it has.

``runner.py RECORD ROOT LIMIT TARGET [argument …]``, as ``tests_ros/running.py`` starts it: TARGET is
``module:function``, as in an entry point, or a script.  RECORD gets JSON as soon as the program spins, or has ended,
and nothing new has come up for a while.  The program goes on, to be looked at from outside, and is killed after LIMIT
seconds.  ROOT is the folder whose executed lines are noted.
"""

from __future__ import annotations

import contextlib
import copy
import ctypes
import importlib
import json
import os
import runpy
import signal
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
"""How long nothing new must come up until a program that spins counts as started."""
WAITING_S = 15.0
"""How long nothing new must come up until a program that does not spin counts as waiting for something for ever."""

lines: set[tuple[str, int]] = set()
nodes: list[Node] = []
"""All nodes that were made, which keeps them alive."""
seen: dict[str, dict[str, Any]] = {}
"""Each node by its name, as it last was before it was destroyed or shut down."""
going = threading.Event()
"""That an executor of the program spins, or that the program has ended: the constructors are through."""


def main() -> None:
    record, root, limit, target, *arguments = sys.argv[1:]
    ctypes.CDLL(None).prctl(1, signal.SIGKILL)  # PR_SET_PDEATHSIG: not to outlive the test
    signal.alarm(int(limit))
    note_lines(root)
    note_objects()
    threading.Thread(target=watch, args=(Path(record), root), daemon=True).start()
    error = run(target, arguments)
    going.set()
    Path(record + ".ended").write_text(error)
    time.sleep(float(limit))


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


def note_lines(root: str) -> None:
    def on_call(frame: FrameType, event: str, argument: Any) -> Any:
        return on_line if frame.f_code.co_filename.startswith(root) else None

    def on_line(frame: FrameType, event: str, argument: Any) -> Any:
        lines.add((frame.f_code.co_filename, frame.f_lineno))
        return on_line

    threading.settrace(on_call)
    sys.settrace(on_call)


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


def watch(record: Path, root: str) -> None:
    while not settled():
        time.sleep(0.1)
    if [node.trigger_configure() and node.trigger_activate() for node in alive() if isinstance(node, LifecycleNode)]:
        settled()
    ran = sorted([os.path.relpath(file, root), line] for file, line in lines.copy())
    written = record.with_suffix(".part")
    written.write_text(json.dumps({"nodes": seen, "lines": ran}))
    written.rename(record)


def settled() -> bool:
    """Looks until nothing new comes up.  Whether a node is there at all."""
    quiet_since, before = time.monotonic(), ""
    while time.monotonic() - quiet_since < (QUIET_S if going.is_set() else WAITING_S):
        look(nodes)
        now = json.dumps(seen, sort_keys=True)
        if now != before:
            quiet_since, before = time.monotonic(), now
        time.sleep(0.05)
    return bool(seen)


def look(at: list[Node], gone: bool = False) -> None:
    for node in at.copy():
        with contextlib.suppress(Exception):  # half made, or being destroyed: the next look will tell
            if node in alive():
                seen[node.get_fully_qualified_name()] = everything_of(node) | {"gone": gone}


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


if __name__ == "__main__":
    main()

"""What runs in the nodes of a system: callbacks, ``main``, threads, with the calls of ROS that each comes to."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import field
from typing import TYPE_CHECKING

from archlint.analysis.reach import blueprints_of
from archlint.model import Role
from archlint.records import dataclass

if TYPE_CHECKING:
    from archlint.model import ApiCall, Blueprint, Callback, Program
    from archlint.systems.model import System
    from archlint.systems.nodes import Node

PUBLISH = "rclpy.publisher.Publisher.publish"
SEND_TRANSFORMS = frozenset(
    f"tf2_ros.{module}.{cls}.sendTransform"
    for module, cls in (
        ("transform_broadcaster", "TransformBroadcaster"),
        ("static_transform_broadcaster", "StaticTransformBroadcaster"),
    )
)
REQUESTS = frozenset(
    {
        "rclpy.client.Client.call",
        "rclpy.client.Client.call_async",
        "rclpy.action.client.ActionClient.send_goal",
        "rclpy.action.client.ActionClient.send_goal_async",
    }
)
ADD_DONE_CALLBACK = "rclpy.task.Future.add_done_callback"
WAIT_FOR_MESSAGE = "rclpy.wait_for_message.wait_for_message"
SENDS = frozenset({PUBLISH, *SEND_TRANSFORMS, *REQUESTS})


SCRIPT = frozenset({Role.MAIN, Role.MODULE})
"""What runs from the start of a program on, and sets its nodes up before it does anything else."""


@dataclass
class Run:
    """What runs on a node: ``calls`` are those of all programs that run it, each once."""

    node: Node
    callback: Callback
    program: Program
    calls: list[ApiCall] = field(default_factory=list)


_Key = tuple[object, ...]


class Runs:
    """All that runs in a system, by node and callback."""

    def __init__(self, system: System) -> None:
        self._nodes: dict[int, list[Node]] = {}
        """By the ``id`` of their blueprints."""
        for node in system.entries:
            for blueprint in node.blueprints:
                self._nodes.setdefault(id(blueprint), []).append(node)
        self._runs: dict[_Key, Run] = {}
        for program in system.programs:
            for callback in program.callbacks:
                for node in self.nodes_of(callback.node):
                    self._add(node, callback, program)
            self._add_calls(program)

    def nodes_of(self, blueprint: Blueprint | None) -> Sequence[Node]:
        """The nodes of the system that a blueprint became."""
        return self._nodes.get(id(blueprint), ())

    def __iter__(self) -> Iterator[Run]:
        return iter(self._runs.values())

    def of(self, node: Node, callback: Callback | None) -> Run | None:
        """What a callback is on a node."""
        return None if callback is None else self._runs.get(_key(node, callback))

    def _add_calls(self, program: Program) -> None:
        of_main: dict[int, dict[int, Node]] = {}
        """The nodes that what is no callback of a node works on, by its ``id``."""
        for call in program.calls:
            if call.context.node is None:
                of_main.setdefault(id(call.context), {}).update((id(node), node) for node in self._nodes_at(call))
        for call in program.calls:
            nodes = of_main.get(id(call.context), {})
            for node in self._nodes_at(call) or nodes.values():
                self._add(node, call.context, program).calls.append(call)

    def _nodes_at(self, call: ApiCall) -> Sequence[Node]:
        """The nodes on which a call is made."""
        nodes = {id(node): node for blueprint in blueprints_of(call) for node in self.nodes_of(blueprint)}
        return list(nodes.values())

    def _add(self, node: Node, callback: Callback, program: Program) -> Run:
        key = _key(node, callback)
        if key not in self._runs:
            self._runs[key] = Run(node, callback, program)
        return self._runs[key]


def _key(node: Node, callback: Callback) -> _Key:
    """One callback that several subscriptions have is one for each; what several executables run is one."""
    creation = callback.creation
    entity = None if creation is None else (creation.place, creation.name.text, creation.period)
    return id(node), callback.role, callback.name, callback.place, entity


def registered_at(runs: Runs) -> Mapping[object, list[Run]]:
    """What answers start, by the node (``id``) and the place of the call that registers it."""
    rows: dict[object, list[Run]] = {}
    for run in runs:
        if run.callback.role in (Role.DONE, Role.FEEDBACK):
            rows.setdefault((id(run.node), run.callback.registered), []).append(run)
    return rows


__all__ = [
    "ADD_DONE_CALLBACK",
    "PUBLISH",
    "REQUESTS",
    "SCRIPT",
    "SENDS",
    "SEND_TRANSFORMS",
    "WAIT_FOR_MESSAGE",
    "Run",
    "Runs",
    "registered_at",
]

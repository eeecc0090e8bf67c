"""Servers that a launch file leaves out although it starts all other nodes of their package."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.coexistence import certain
from archlint.analysis.kept import once
from archlint.launch_files.launch_code import words_of_launch_code
from archlint.model import SERVER_OF
from archlint.systems.nodes import key_of

if TYPE_CHECKING:
    from archlint.systems.model import System, WorkspaceIndex
    from archlint.systems.nodes import Endpoint, Node


def left_out_server(system: System, client: Endpoint) -> Endpoint | None:
    """The server of what a client writes, in the only node of its package that no launch file starts, while this one
    starts all others."""
    workspace, package = system.workspace, client.node.package
    if workspace is None or system.launched is None or system.is_included or package is None:
        return None
    here = {key_of(node.blueprint) for node in system.nodes if node.blueprint is not None}
    others = [node for node in _nodes_of(workspace) if node.package == package and _key(node) not in here]
    if len({_key(node) for node in others}) != 1 or _may_be_launched(workspace, others[0]):
        return None
    return next((end for end in others[0].endpoints if _serves(end, client)), None)


def _key(node: Node) -> object:
    assert node.blueprint is not None
    return key_of(node.blueprint)


def _serves(end: Endpoint, client: Endpoint) -> bool:
    same = (end.kind, end.type, end.written) == (SERVER_OF[client.kind], client.type, client.written)
    return same and client.type is not None and certain(end)


def _may_be_launched(workspace: WorkspaceIndex, node: Node) -> bool:
    spoken = words_of_launch_code(workspace)
    return _key(node) in workspace.started_by_launch or any(
        executable in words for executable in node.executables for words in spoken
    )


@once
def _nodes_of(workspace: WorkspaceIndex) -> list[Node]:
    """The nodes that executables of the workspace start."""
    return list(_started(workspace))


def _started(workspace: WorkspaceIndex) -> Iterator[Node]:
    for system in workspace.systems:
        if system.name is None:
            yield from (
                node for node in system.nodes if node.blueprint is not None and node.executables and not node.test
            )


__all__ = ["left_out_server"]

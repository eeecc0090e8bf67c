"""Workspaces of those who learn how to name topics: NME001 tells them what is said of no robot."""

from __future__ import annotations

import posixpath
import sys
from typing import TYPE_CHECKING

from archlint.checks.foreign_names import is_foreign
from archlint.connections.lessons import is_lesson
from archlint.packaging.imports import imports_at_start
from archlint.ros.python_modules import comes_with_ros
from archlint.systems.nodes import key_of

if TYPE_CHECKING:
    from archlint.systems.model import System, WorkspaceIndex
    from archlint.systems.nodes import Node

_PACKAGES_OF_A_LESSON = 2
"""One that learns has a package, and starts another."""


def is_lesson_about_names(system: System) -> bool:
    """Whether a workspace is small and of nothing but ROS: it starts nothing but its own nodes, each once, and drives,
    sees and simulates nothing.  Whoever has a robot knows how its topics are called."""
    workspace = system.workspace
    small = is_lesson(system) and _stands_alone(system) and _starts_each_once(workspace)
    return small and (workspace is None or not _works_with_more_than_ros(workspace))


def _stands_alone(system: System) -> bool:
    """Whether the nodes of a workspace are in two packages at most, and talk to no system of which there is one, such
    as PX4.  More packages make up a robot, and such a system has its names from elsewhere."""
    nodes = [node for node in system.nodes if not node.external and not node.test]
    written = (end for node in nodes for end in node.endpoints if (end.written or "").startswith("/"))
    packages = {node.package for node in nodes} | _with_programs(system.workspace)
    return len(packages) <= _PACKAGES_OF_A_LESSON and not any(is_foreign(system.workspace, end) for end in written)


def _with_programs(workspace: WorkspaceIndex | None) -> set[str | None]:
    """The packages that install programs, be it that no node is seen in them."""
    return set() if workspace is None else {name for name, row in workspace.installs.items() if row.executables}


def _starts_each_once(workspace: WorkspaceIndex | None) -> bool:
    """Whether launch files start nodes of the workspace alone, each once and in no namespace.  One with drivers or a
    simulator is for a robot that somebody has, and one with instances for several."""
    for system in () if workspace is None else workspace.systems:
        if system.launched is not None:
            keys = [None if node.blueprint is None else key_of(node.blueprint) for node in system.nodes]
            if None in keys or len(set(keys)) < len(keys) or any(namespace_of(node) for node in system.nodes):
                return False
    return True


_OF_ROS = (
    "action_msgs",
    "ament_",
    "builtin_interfaces",
    "launch",
    "message_filters",
    "rcl",
    "ros2launch",
    "rosidl_",
    "tf2",
    "tf_",
)
"""How the packages of ROS begin that every lesson may use: they come with no robot, no camera and no simulator."""
_INTERFACES = frozenset({"action", "msg", "srv"})


def _works_with_more_than_ros(workspace: WorkspaceIndex) -> bool:
    """Whether a node imports what neither Python nor ROS brings along nor the workspace has: a library for a device,
    pictures or a network, the Python of another system, such as Nav2.  Of C++, the package.xml says so."""
    own = set(workspace.packages)
    own |= {posixpath.splitext(posixpath.basename(file))[0] for name in own for file in workspace.code.files_of(name)}
    imported = (
        statement
        for statement in imports_at_start(workspace)
        if statement.file.package is not None and not workspace.roles.is_test(statement.file.relative)
    )
    if any(_is_of_more(statement.module, statement.names, own) for statement in imported):
        return True
    needed = {name for package in workspace.manifests.values() for name in package.runtime_dependencies()}
    return any(
        not (_is_of_ros(name) or name.startswith("python")) for name in needed - own
    )  # imports say more of those


def _is_of_more(module: str, names: tuple[str, ...], own: set[str]) -> bool:
    top, *below = module.split(".")
    if not _INTERFACES.isdisjoint({*below, *names}) or top in own or top in sys.stdlib_module_names:
        return False
    return not (comes_with_ros(top) or _is_of_ros(top))


def _is_of_ros(package: str) -> bool:
    return package.startswith(_OF_ROS) or package.endswith(("_msgs", "_srvs", "_interfaces"))


def namespace_of(node: Node) -> str:
    """The namespace in which a launch file starts a node, the root where it is not known."""
    given = None if node.started is None else node.started.namespace
    known = (node.name or "").rpartition("/")[0] if given is None or node.name is not None else given.text
    return f"/{known.strip('/')}" if known and known != "/" else ""


__all__ = ["is_lesson_about_names", "namespace_of"]

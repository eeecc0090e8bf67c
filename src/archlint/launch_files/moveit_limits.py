"""Limits of joints in the configuration of MoveIt whose type it refuses.

Source: ``RobotModelLoader::configure`` of moveit_ros_planning reads them as doubles, branches humble to main; the
exception of an integer, InvalidParameterTypeException, is none of those that it catches.
"""

from __future__ import annotations

import posixpath
from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.aside import is_aside
from archlint.launch_files.plugin_parameters import Mistyped
from archlint.place import Place
from archlint.ros.parameter_types import type_of
from archlint.syntax.joint_limits import read_limits

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex

_FILE = "config/joint_limits.yaml"
_ASSISTANT = ".setup_assistant"
"""What the packages have that MoveIt's assistant makes, of which its launch files load that file."""


def mistyped_limits(workspace: WorkspaceIndex) -> Iterator[Mistyped]:
    """The integers among them."""
    for folder in sorted(workspace.manifests):
        file, assistant = (posixpath.normpath(posixpath.join(folder, name)) for name in (_FILE, _ASSISTANT))
        package, tree = workspace.manifests[folder], workspace.tree
        if package.ros1 or is_aside(workspace, file) or not tree.is_file(file) or not tree.is_file(assistant):
            continue
        for row in read_limits(tree.text(file) or ""):
            if type_of(row.value) == "integer":
                yield Mistyped(
                    Place(file, *row.span), f"{row.joint}.{row.name}", row.value, "MoveIt", "double", "integer"
                )


__all__ = ["mistyped_limits"]

"""Absolute names that launch files, parameter files, models and displays write down: code that drops the '/' of such a
name no longer follows them in a namespace."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.kept import once
from archlint.workspace.comments import without_comments

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex

_DATA = (".yaml", ".yml", ".sdf", ".world", ".urdf", ".xacro", ".gazebo")
_DISPLAYS = (".rviz", ".perspective")
"""What RViz and rqt show: some are in a repository for one developer only, and count where they are installed."""
_ABSOLUTE_NAME = re.compile(r"(?<![\w./~)}$<-])(/[A-Za-z_]\w*(?:/[A-Za-z_]\w*)*)(?![\w./{$-])")
"""A name of ROS that stands alone: no path with a suffix, and no closing tag."""


def is_in_data(workspace: WorkspaceIndex | None, name: str) -> bool:
    """Whether something other than code holds to an absolute name."""
    return workspace is not None and name in _names(workspace)


@once
def _names(workspace: WorkspaceIndex) -> frozenset[str]:
    """What stands in launch files, but for what they remap to something else, and in parameter files, models and
    displays."""
    replaced = {
        remap.source.text for launched in workspace.launched for started in launched.started for remap in started.remaps
    }
    of_launch = {name for path in workspace.launch_files.all() for name in _in_text(workspace, path)}
    return frozenset((of_launch - replaced) | {name for path in _data(workspace) for name in _in_text(workspace, path)})


def _data(workspace: WorkspaceIndex) -> list[str]:
    paths = sorted({path for folder in workspace.manifests for path in workspace.tree.files_below(folder)})
    return [
        path for path in paths if path.endswith(_DATA) or (path.endswith(_DISPLAYS) and _is_installed(workspace, path))
    ]


def _is_installed(workspace: WorkspaceIndex, path: str) -> bool:
    """Whether a package installs a file, or may do so."""
    installs = workspace.installs.get(workspace.package_of(path) or "")
    return installs is None or installs.open_files or any(True for _ in installs.places_of(path))


def _in_text(workspace: WorkspaceIndex, path: str) -> Iterator[str]:
    text = workspace.tree.text(path) or ""
    return (match[1] for match in _ABSOLUTE_NAME.finditer(without_comments(text))) if "/" in text else iter(())


__all__ = ["is_in_data"]

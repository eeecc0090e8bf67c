"""Packages that launch files name and that are neither in the workspace nor known to rosdistro."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import TYPE_CHECKING

from archlint.analysis.cpp_nodes import CPP_SOURCES
from archlint.analysis.kept import once
from archlint.ros import packages
from archlint.suggestions import distance, nearest

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex

_PLACEHOLDER = re.compile(r"(?:.*_)?your_.+|package_name|(?:your|ros)?_?pkg_name|PACKAGE_NAME|YOUR_.+")
"""What stands in templates and instructions for the name of a package."""
_SLIP = 2
"""By how many letters a name that nobody declares may differ from that of a package which is there."""


def is_nowhere(workspace: WorkspaceIndex, package: str) -> bool:
    """Whether no package of the workspace has a name, none of them declares it, and rosdistro does not have it."""
    if package in workspace.packages or package in packages.table().names or package in workspace.installs:
        return False
    return package not in _declared(workspace)


@once
def _declared(workspace: WorkspaceIndex) -> frozenset[str]:
    return frozenset(d.name for own in workspace.packages.values() for d in own.dependencies)


def is_placeholder(package: str) -> bool:
    """Whether a name stands for another one that was to be put in."""
    return _PLACEHOLDER.fullmatch(package) is not None


def package_meant(workspace: WorkspaceIndex, package: str) -> str | None:
    """The package of the workspace whose name differs from one that is nowhere by a slip."""
    near = nearest(package, workspace.packages)
    return near if near is not None and distance(package, near, _SLIP) <= _SLIP else None


def owners_of_component(workspace: WorkspaceIndex, plugin: str) -> list[str]:
    """The packages whose CMake files, or C++ sources, register a component under its name."""
    name = rf"(?<![\w:])(?:::)?{re.escape(plugin)}(?![\w:])"
    macro = re.compile(rf"RCLCPP_COMPONENTS_REGISTER_NODE\(\s*{name}\s*\)")
    return sorted(
        package
        for package, installs in workspace.installs.items()
        if _stands_in(workspace, installs.build_files, re.compile(name))
        or _stands_in(workspace, _sources_below(workspace, installs.folder), macro)
    )


def _sources_below(workspace: WorkspaceIndex, folder: str) -> list[str]:
    return [path for path in workspace.tree.files_below(folder) if path.endswith(CPP_SOURCES)]


def _stands_in(workspace: WorkspaceIndex, files: Sequence[str], text: re.Pattern[str]) -> bool:
    return any(text.search(workspace.tree.text(file) or "") for file in files)


__all__ = ["is_nowhere", "is_placeholder", "owners_of_component", "package_meant"]

"""The packages whose CMake files a team maintains and builds for ROS 2."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.aside import is_aside

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex
    from archlint.workspace.installed import Installs
    from archlint.workspace.model import Package


def cmake_packages(workspace: WorkspaceIndex) -> Iterator[tuple[Package, Installs]]:
    """The packages that ament_cmake builds, by name, each with what it installs; none that are put aside."""
    for name in sorted(workspace.installs):
        installs = workspace.installs[name]
        package = workspace.manifests.get(installs.folder)
        if package is None or package.name != name or package.build_type != "ament_cmake" or package.ros1:
            continue
        if not is_aside(workspace, package.manifest.relative):
            yield package, installs


__all__ = ["cmake_packages"]

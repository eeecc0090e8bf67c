"""The ROS packages that CMake files ask for, held against package.xml.

Source: ``find_package(… REQUIRED)`` of CMake stops a build without the package; colcon builds what package.xml names
first, and rosdep installs no more than that.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING

from archlint.analysis.aside import is_aside
from archlint.ros import packages
from archlint.workspace.closure import closure
from archlint.workspace.manifest import condition_holds

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex
    from archlint.workspace.installed import FoundPackage
    from archlint.workspace.model import Package

_BUILD_TYPES = frozenset({"ament_cmake", "cmake"})
_LETTERS = re.compile(r"[^a-z0-9]+")


def packages_to_declare(
    workspace: WorkspaceIndex, brought_by: Callable[[str], set[str]]
) -> Iterator[tuple[Package, FoundPackage]]:
    """Each package that a build stops without and that nothing declares; ``brought_by`` says what a package brings
    along."""
    known = packages.table().names | workspace.packages.keys()
    for folder in sorted(workspace.manifests):
        package = workspace.manifests[folder]
        installs = workspace.installs.get(package.name)
        if installs is None or installs.folder != folder or package.build_type not in _BUILD_TYPES or package.ros1:
            continue
        if is_aside(workspace, package.manifest.relative) or not installs.required:
            continue
        declared = {
            d.name for d in package.dependencies if d.kind != "doc" and condition_holds(d.condition) is not False
        }
        there = closure([package.name, *declared], brought_by)
        own = [asked for asked in installs.required if folder == "." or asked.place.file.startswith(f"{folder}/")]
        for asked in own:
            if asked.name in known and asked.name not in there and not _is_of_system(asked.name, declared - known):
                yield package, asked


def _is_of_system(name: str, declared: set[str]) -> bool:
    """Whether a package of the system has a name that contains that of one of ROS: ``liburdfdom-dev``."""
    letters = _LETTERS.sub("", name.lower())
    return any(letters in _LETTERS.sub("", other.lower()) for other in declared)


__all__ = ["packages_to_declare"]

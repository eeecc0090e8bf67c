"""The package.xml files with which colcon cannot build what they describe."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

from archlint.analysis.aside import is_aside
from archlint.workspace.refused_manifests import Refusal, refusals

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex
    from archlint.workspace.model import Package

_PROJECTS = {"CMakeLists.txt": "plain CMake", "setup.py": "plain Python"}
"""What else colcon takes a folder for, by a file of it."""


@dataclass(frozen=True)
class RefusedManifest:
    """A mistake in a manifest, and what colcon does with the folder therefore: ``builds`` it as something else, or
    passes over it (empty)."""

    package: Package
    refusal: Refusal
    builds: str


def refused_manifests(workspace: WorkspaceIndex) -> Iterator[RefusedManifest]:
    """Each mistake in the manifests of ROS 2."""
    for package in _judged(workspace):
        for refusal in refusals(workspace.tree.text(package.manifest.relative) or ""):
            yield RefusedManifest(package, refusal, _instead(workspace, package))


def _instead(workspace: WorkspaceIndex, package: Package) -> str:
    """What colcon takes the folder for: it knows projects of CMake and Python, too."""
    files = {posixpath.normpath(posixpath.join(package.relative, file)): kind for file, kind in _PROJECTS.items()}
    return next((kind for path, kind in files.items() if workspace.tree.is_file(path)), "")


def _judged(workspace: WorkspaceIndex) -> Iterator[Package]:
    for folder in sorted(workspace.manifests):
        package = workspace.manifests[folder]
        if not package.ros1 and not is_aside(workspace, package.manifest.relative):
            yield package


__all__ = ["RefusedManifest", "refused_manifests"]

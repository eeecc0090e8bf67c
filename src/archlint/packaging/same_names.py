"""Packages side by side that have one name: colcon builds none of them."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.place import Place
from archlint.workspace.comments import blank_xml_comments
from archlint.workspace.pruning import MARKERS
from archlint.workspace.test_code import FileRoles

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex
    from archlint.workspace.model import Package

_NAME = re.compile(r"[a-z][a-z0-9]*(?:[_-][a-z0-9]+)*")
"""A name that a package may have."""


def copied_names(workspace: WorkspaceIndex) -> Iterator[tuple[Package, Place]]:
    """Each package that has the name of the one beside it, whose folder is called so, and where that one has it: it was
    copied from there.  Packages of one name in other folders may be for a workspace each, and so may those that are all
    called otherwise than their folders.

    Source: colcon stops with "Duplicate package names not supported".
    """
    for package in workspace.manifests.values():
        folder = posixpath.dirname(package.manifest.relative)
        original = posixpath.join(posixpath.dirname(folder), package.name)
        if package.ros1 or original == folder or not folder or FileRoles().is_put_aside(package.manifest.relative):
            continue
        name = _named(workspace, original, package.name)
        if name is not None and _NAME.fullmatch(posixpath.basename(folder)):
            yield package, name


def _named(workspace: WorkspaceIndex, folder: str, name: str) -> Place | None:
    """Where the manifest of a folder gives its package that name; None where colcon passes over it."""
    manifest = posixpath.join(folder, "package.xml")
    text = workspace.tree.text(manifest) or ""
    if any(workspace.tree.is_file(posixpath.join(folder, marker)) for marker in MARKERS):
        return None
    lines = enumerate(blank_xml_comments(text).splitlines(), 1)
    return next((Place(manifest, n, 1, n, 1) for n, line in lines if f"<name>{name}</name>" in line), None)


__all__ = ["copied_names"]

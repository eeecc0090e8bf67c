"""Files below the share folders of packages that descriptions of robots name: what they include, and meshes.

Source: xacro's ``$(find robot)`` and the ``package://robot`` of rviz, Gazebo and MoveIt are the share folder of the
package, and never its source.
"""

from __future__ import annotations

import posixpath
from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.aside import is_aside
from archlint.packaging.share_paths import Named
from archlint.packaging.uninstalled_files import understood
from archlint.syntax.description_files import files_named

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex
    from archlint.workspace.installed import Installs

_NO_CODE = frozenset({"__init__.py", "setup.py"})
_ENDINGS = (".urdf", ".xacro")


def paths_in_descriptions(workspace: WorkspaceIndex) -> Iterator[tuple[str, list[Named]]]:
    """The descriptions that packages install, or that are all that a package has, each with the files that it names."""
    for installs in understood(workspace).values():
        files = [
            file
            for file in workspace.tree.files_below(installs.folder)
            if file.endswith(_ENDINGS) and workspace.package_of(file) == installs.package
        ]
        here = [file for file in files if not is_aside(workspace, file) and not workspace.roles.is_test(file)]
        installed = [
            file for file in here if f"share/{installs.package}/{_below(installs, file)}" in installs.places_of(file)
        ]
        for file in installed or (here if _has_no_code(workspace, installs) else ()):
            named = list(_named(workspace.tree.text(file) or "", installs, file, file in installed))
            if named:
                yield file, named


def _named(text: str, installs: Installs, file: str, is_installed: bool) -> Iterator[Named]:
    for named in files_named(text):
        if named.package is not None:
            yield Named(named.package, posixpath.normpath(named.path.lstrip("/")), named.span)
        elif is_installed:
            path = posixpath.normpath(posixpath.join(posixpath.dirname(_below(installs, file)), named.path))
            if not path.startswith(".."):
                yield Named(installs.package, path, named.span)


def _below(installs: Installs, file: str) -> str:
    return posixpath.relpath(file, installs.folder)


def _has_no_code(workspace: WorkspaceIndex, installs: Installs) -> bool:
    """Whether a package builds nothing, so that its data is what it is for."""
    code = (
        file
        for file in workspace.code.files_of(installs.package)
        if posixpath.basename(file) not in _NO_CODE and not workspace.roles.is_test(file)
    )
    return not installs.executables and not installs.sources and not any(code)


__all__ = ["paths_in_descriptions"]

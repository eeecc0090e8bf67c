"""Python projects that lie inside of a ROS package, with a pyproject.toml or a setup.py of their own: libraries that
were copied into it.  Whoever imports them by their own name may get what pip has installed instead."""

from __future__ import annotations

import posixpath
from typing import TYPE_CHECKING

from archlint.analysis.kept import kept_for_each_file
from archlint.packaging.manifests import package_around
from archlint.syntax import facts
from archlint.syntax.parts import everything_in
from archlint.workspace.folders import folders_above

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex

_OF_PROJECTS = ("pyproject.toml", "setup.py")


def is_imported_by_its_own_name(workspace: WorkspaceIndex, importer: str, file: str) -> bool:
    """Whether a file is of such a project, and one outside of it imports that by the name which pip would install:
    ``camera_sdk.device`` for ``robot/third_party/camera_sdk/device.py``."""
    folder = _inner_distribution(workspace, file)
    if folder is None or importer.startswith(f"{folder}/"):
        return False
    top = posixpath.relpath(file, folder).partition("/")[0].removesuffix(".py")
    return top in (_imported(workspace, importer) or ())


def _inner_distribution(workspace: WorkspaceIndex, file: str) -> str | None:
    """The folder of the innermost such project around a file; None where the file is the package's own."""
    package = package_around(workspace, posixpath.dirname(file))
    root = None if package is None else posixpath.dirname(package.manifest.relative)
    for folder in folders_above(file) if root is not None else ():
        if folder == root:
            break
        if any(workspace.tree.is_file(posixpath.join(folder, name)) for name in _OF_PROJECTS):
            return folder
    return None


@kept_for_each_file
def _imported(code: facts.Facts) -> frozenset[str]:
    """The first words of the modules that a file imports."""
    modules = [part.module for part in everything_in(code.body, facts.Import)]
    modules += [part.module for part in everything_in(code.body, facts.ImportFrom) if not part.level]
    return frozenset(module.partition(".")[0] for module in modules)


__all__ = ["is_imported_by_its_own_name"]

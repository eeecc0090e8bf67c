"""Programs and dependencies whose lines in a build file or a package.xml are a comment: somebody has taken them out on
purpose, perhaps for a while."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Sequence
from typing import TYPE_CHECKING

from archlint.analysis.kept import once
from archlint.workspace.comments import xml_comments

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex
    from archlint.workspace.installed import Installs
    from archlint.workspace.model import Package


def commented_out_in(workspace: WorkspaceIndex, files: Sequence[str], program: str) -> str | None:
    """The build file in which the ``add_executable()`` of a program, or its entry among the console scripts, is a
    comment."""
    name = re.escape(program)
    line = re.compile(rf"""^[ \t]*#.*(?:\badd_executable[ \t]*\([ \t]*{name}\b|['"]{name}[ \t]*=)""", re.MULTILINE)
    return next((file for file in files if line.search(workspace.tree.text(file) or "")), None)


def absent_module_in_comment(workspace: WorkspaceIndex, installs: Installs, file: str, program: str) -> str | None:
    """The module that such an entry names, where the package has no file of it."""
    entry = re.compile(rf"""^[ \t]*#.*['"]{re.escape(program)}[ \t]*=[ \t]*(?P<module>[\w.]+)[ \t]*:""", re.MULTILINE)
    written = entry.search(workspace.tree.text(file) or "")
    if written is None:
        return None
    path = written["module"].replace(".", "/")
    ends = (f"/{path}.py", f"/{path}/__init__.py")
    there = workspace.tree.files_below(installs.folder or ".")
    return None if any(f"/{other}".endswith(ends) for other in there) else written["module"]


@once
def _taken_out(workspace: WorkspaceIndex) -> dict[str, frozenset[str]]:
    """What stands in comments of each package.xml as a dependency, by the folder of its package."""
    manifests = {
        package.relative: workspace.tree.text(posixpath.normpath(posixpath.join(package.relative, "package.xml")))
        for package in workspace.manifests.values()
    }
    return {
        folder: frozenset(match[1] for comment in xml_comments(text or "") for match in _DEPENDENCY.finditer(comment))
        for folder, text in manifests.items()
    }


_DEPENDENCY = re.compile(r"<(?:depend|exec_depend|run_depend|build_depend)\b[^>]*>\s*([\w.-]+)\s*</")


def is_dependency_taken_out(workspace: WorkspaceIndex, package: Package, name: str) -> bool:
    """Whether a package.xml has a dependency in a comment: it is known, and left out of what rosdep installs, as what
    is built from source is."""
    return name in _taken_out(workspace).get(package.relative, ())


__all__ = ["absent_module_in_comment", "commented_out_in", "is_dependency_taken_out"]

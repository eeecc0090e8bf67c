"""Packages of a workspace that its own scripts leave out of a build: colcon fails if another package depends on one."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING

from archlint.analysis.kept import once
from archlint.analysis.pinned import PINNING_FOLDERS
from archlint.place import Place

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex
    from archlint.workspace.tree import Tree

_SCRIPT = re.compile(r"(?:^|/)(?:[^/]*\.(?:sh|bash|zsh)|Makefile|justfile|[^/]*[Dd]ockerfile[^/]*|\.gitlab-ci\.yml)$")
_STEPS = re.compile(r"\.ya?ml$")
_SKIPS = re.compile(
    r"""^[^#\n]*?--packages-(?:skip|ignore)(?P<names>(?:(?:[ \t]+|[ \t]*\\\n[ \t]*)["']?[A-Za-z]\w*["']?)+)""",
    re.MULTILINE,
)


@once
def skipped_packages(workspace: WorkspaceIndex) -> Mapping[str, Place]:
    """Where a script, a Dockerfile or a workflow first leaves out each package, by ``--packages-skip`` or
    ``--packages-ignore``.

    Source: colcon_core/verb/build.py passes skipped packages on as dependencies, and the build of one that depends on
    them fails where their ``package.sh`` is not there.
    """
    places: dict[str, Place] = {}
    for path in _scripts(workspace.tree):
        text = workspace.tree.text(path) or ""
        for match in _SKIPS.finditer(text) if "--packages-" in text else ():
            for name in re.finditer(r"\w+", match["names"]):
                start = match.start("names") + name.start()
                line = text.count("\n", 0, start) + 1
                column = start - (text.rfind("\n", 0, start) + 1) + 1
                places.setdefault(name[0], Place(path, line, column, line, column + len(name[0])))
    return places


def _scripts(tree: Tree) -> Iterator[str]:
    yield from (path for path in tree.files_below(tree.top) if _SCRIPT.search(path))
    for folder in PINNING_FOLDERS:
        below = tree.files_below(posixpath.normpath(f"{tree.top}/{folder}"))
        yield from (path for path in below if _STEPS.search(path) or _SCRIPT.search(path))


__all__ = ["skipped_packages"]

"""Python classes that Webots loads as plugins of a robot: a description names each by its module."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import TYPE_CHECKING

from archlint.analysis.kept import once
from archlint.place import Place
from archlint.workspace.comments import without_comments

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex

_DESCRIPTIONS = (".urdf", ".xacro", ".xml", ".webots")
_PLUGIN = re.compile(r"<plugin\s+type\s*=\s*[\"']([A-Za-z_][\w.]*)\.(\w+)[\"']")


def loaded_by_webots(workspace: WorkspaceIndex, module: str) -> tuple[str, Place] | None:
    """The class of a module that a description of a robot has as a plugin, in full, and where it stands; None for
    none."""
    return _plugins(workspace).get(module)


@once
def _plugins(workspace: WorkspaceIndex) -> Mapping[str, tuple[str, Place]]:
    paths = sorted({path for folder in workspace.manifests for path in workspace.tree.files_below(folder)})
    plugins: dict[str, tuple[str, Place]] = {}
    for path in (path for path in paths if path.endswith(_DESCRIPTIONS)):
        text = workspace.tree.text(path) or ""
        used = _PLUGIN.findall(without_comments(text)) if "<plugin" in text else ()
        for match in _PLUGIN.finditer(text) if used else ():
            name, start = f"{match[1]}.{match[2]}", match.start(1)
            line, column = text.count("\n", 0, start) + 1, start - text.rfind("\n", 0, start)
            if match.groups() in used:
                plugins.setdefault(match[1], (name, Place(path, line, column, line, column + len(name))))
    return plugins


__all__ = ["loaded_by_webots"]

"""What C++ sources say, as far as their text does: they are not compiled."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex

CPP_SOURCES = (".cpp", ".cc", ".cxx", ".hpp")


def names_cpp_node(workspace: WorkspaceIndex, file: str, name: str) -> bool:
    """Whether a C++ source of the package that a parameter file lies in names a node so: one file may serve several
    programs, of which a launch file starts one."""
    installs = workspace.installs.get(workspace.package_of(file) or "")
    if installs is None:
        return False
    node = re.compile(rf'"{re.escape(name)}"')
    sources = [path for path in workspace.tree.files_below(installs.folder) if path.endswith(CPP_SOURCES)]
    texts = (workspace.tree.text(path) or "" for path in sources)
    return any("rclcpp" in text and node.search(text) is not None for text in texts)

"""Modules of Python itself that a package imports beside its nodes."""

from __future__ import annotations

import posixpath
import sys
from typing import TYPE_CHECKING

from archlint.syntax import facts

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex
    from archlint.workspace.model import Package


def imports_beside_nodes(workspace: WorkspaceIndex, package: Package, name: str) -> bool:
    """Whether the setup.py or a launch file of a package imports a module of Python itself, by its name."""
    if name not in sys.stdlib_module_names:
        return False
    setup = posixpath.join(posixpath.dirname(package.manifest.relative), "setup.py")
    launches = (path for path in workspace.launch_files.all() if workspace.package_of(path) == package.name)
    codes = (workspace.facts_at(path) for path in (setup, *launches) if path.endswith(".py"))
    statements = [each for code in codes for each in (() if code is None else code.body)]
    imports = (each for each in statements if isinstance(each, facts.Import))
    return any(each.module.partition(".")[0] == name for each in imports)


__all__ = ["imports_beside_nodes"]

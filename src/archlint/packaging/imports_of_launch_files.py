"""What the imports of a launch file in Python can find.

Source: ``load_python_launch_file_as_module`` of launch loads the file by its path; its folder does not come to
``sys.path``.
"""

from __future__ import annotations

import posixpath
import sys
from typing import TYPE_CHECKING

from archlint.packaging.absent_packages import is_nowhere
from archlint.packaging.imports_by_path import says_where_to_look
from archlint.packaging.left_out_code import changes_path
from archlint.ros.python_modules import is_known
from archlint.syntax.walk import main_guard

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex
    from archlint.workspace.model import SourceFile


def is_installed_package(workspace: WorkspaceIndex, module: str) -> bool:
    """Whether a dotted name begins with a Python package that a setup.py of the workspace installs, and not with a file
    such as ``launch/launch.py``."""
    top = module.partition(".")[0]
    having = (workspace.installs.get(package or "") for package in workspace.code.modules.get(top, ()))
    folders = (installs.python.folders for installs in having if installs is not None and installs.python is not None)
    return any(posixpath.basename(folder) == top for each in folders for folder in each)


def is_only_beside(workspace: WorkspaceIndex, file: SourceFile, module: str) -> bool:
    """Whether a launch file imports a module by its bare name that is nowhere but beside it.  One that is a
    program, too, finds that when it is started as such."""
    path = posixpath.join(posixpath.dirname(file.relative), f"{module}.py")
    if "." in module or not workspace.tree.is_file(path) or not _is_nowhere_else(workspace, file, module, path):
        return False
    code = workspace.facts_at(file.relative)
    if code is None or main_guard(code) is not None or changes_path(workspace, file.relative):
        return False
    return not says_where_to_look(workspace)


def _is_nowhere_else(workspace: WorkspaceIndex, file: SourceFile, module: str, path: str) -> bool:
    """Whether nothing but a file has the name of a module, and no setup.py installs that as one."""
    installs = workspace.installs.get(file.package or "")
    if installs is None or (installs.python is not None and installs.python.has(path)):
        return False
    known = module in sys.stdlib_module_names or is_known(module) or not is_nowhere(workspace, module)
    return not known and workspace.code.modules.get(module, frozenset()) <= {file.package}


__all__ = ["is_installed_package", "is_only_beside"]

"""Modules that scripts which CMake installs import from beside them, and that are not installed beside them.

A link leads Python to the folder that it points to, so that a build with ``--symlink-install`` has them.
"""

from __future__ import annotations

import posixpath
import sys
from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.packaging.left_out_code import LeftOut, certain_imports, changes_path, files_of_import
from archlint.packaging.uninstalled_files import understood
from archlint.place import Place
from archlint.ros.python_modules import is_known
from archlint.syntax import facts

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex
    from archlint.workspace.installed import Installs


def modules_beside_scripts(workspace: WorkspaceIndex) -> Iterator[LeftOut]:
    """Each such module, once for each script that imports it."""
    for package, installs in understood(workspace).items():
        manifest = workspace.packages.get(package)
        if manifest is None or manifest.build_type != "ament_cmake" or installs.open_executables:
            continue
        scripts = {row.script: row for row in installs.executables.values() if row.script is not None and not row.wrong}
        for script in sorted(scripts):
            for file, place in _beside(workspace, script):
                if file not in scripts and not _is_installed(workspace, installs, file):
                    yield LeftOut(file, package, place, scripts[script].name)


def _beside(workspace: WorkspaceIndex, script: str) -> Iterator[tuple[str, Place]]:
    """The files in the folder of a script that it imports whenever it starts."""
    file_facts = workspace.facts_at(script)
    if file_facts is None or changes_path(workspace, script):
        return
    for statement in certain_imports(file_facts.body):
        for file in files_of_import(workspace, script, statement):
            # Through a package, `from robot.tools import …`, it comes from where Python packages are installed.
            is_beside = f"{posixpath.join(posixpath.dirname(script), _name(statement))}.py" == file
            if is_beside and _is_nowhere_else(workspace, file):
                yield file, Place(script, *statement.span)


def _name(statement: facts.Import | facts.ImportFrom) -> str:
    """The module that an import names; empty for a relative one, which a script cannot use."""
    return "" if isinstance(statement, facts.ImportFrom) and statement.level else statement.module


def _is_nowhere_else(workspace: WorkspaceIndex, file: str) -> bool:
    """Whether nothing else has the name of a module: an installed script would find that."""
    name = posixpath.basename(file).removesuffix(".py")
    others = {path for package in workspace.packages for path in [workspace.code.modules_of(package).get(name)]}
    return name not in sys.stdlib_module_names and not is_known(name) and others <= {None, file}


def _is_installed(workspace: WorkspaceIndex, installs: Installs, file: str) -> bool:
    below = file if installs.folder == "." else file.removeprefix(f"{installs.folder}/")
    return any(installs.places_of(file)) or installs.may_install(below)


__all__ = ["modules_beside_scripts"]

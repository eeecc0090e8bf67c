"""Imports of the workspace's own modules by what their files are called, and not by the name that they are installed
under: ``src.robot.robot.camera`` and ``robot.robot.camera`` for ``robot.camera``.

Editors write them so.  Python finds them where it is started in the folder above, and no console script is.
"""

from __future__ import annotations

import posixpath
from collections.abc import Sequence
from typing import TYPE_CHECKING

from archlint.analysis.kept import once
from archlint.packaging.renamed_packages import is_no_package, is_unknown
from archlint.python_code.offered_names import offers
from archlint.suggestions import nearest
from archlint.syntax import facts
from archlint.syntax.parts import everything_in

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex
    from archlint.workspace.model import SourceFile

_SETS_PATH = (".bash", ".dsv", ".env", ".json", ".md", ".sh", ".toml", ".yaml", ".yml", "Dockerfile", "Makefile", "rc")
"""How the names of files end that may say where Python looks."""


def installed_name(workspace: WorkspaceIndex, file: SourceFile, module: str, names: Sequence[str]) -> str | None:
    """The name under which the module is installed that an import means by the path of its file; that of a module
    inside of it where only that one has the ``names`` that are imported.  None where it means none so, where Python may
    find it all the same, and where that is not known."""
    parts = module.split(".")
    if module in workspace.code.modules:
        return None  # robot/robot/robot.py is robot.robot
    for end in range(1, len(parts)):
        name = ".".join(parts[end:])
        path = workspace.code.file_of_import(file.relative, name) if name in workspace.code.modules else None
        if path is None or not _is_path_of(path, parts):
            continue
        doubled = parts[0] in workspace.code.modules and end == 1 and parts[0] == parts[1]
        if (doubled or is_no_package(workspace, parts[0])) and not says_where_to_look(workspace):
            return _inside(workspace, file, name, names)
    return None


def _inside(workspace: WorkspaceIndex, file: SourceFile, package: str, names: Sequence[str]) -> str:
    """The one module of a package that has some names, if the package itself lacks them; tests of it are not meant."""
    if _has(workspace, file, package, names):
        return package
    modules = sorted(name for name in workspace.code.modules if name.startswith(f"{package}."))
    having = [module for module in modules if _has(workspace, file, module, names)]
    paths = {module: workspace.code.file_of_import(file.relative, module) for module in having}
    having = [module for module, path in paths.items() if path is not None and not workspace.roles.is_test(path)]
    return having[0] if len(having) == 1 else package


def _is_path_of(path: str, parts: Sequence[str]) -> bool:
    """Whether a dotted name is the path of a file, from a folder of the workspace on, or from the one around it."""
    whole, inner = "/".join(parts), "/".join(parts[1:])
    for ending in (".py", "/__init__.py"):
        if f"/{path}".endswith(f"/{whole}{ending}") or path == f"{inner}{ending}":
            return True
    return False


@once
@once
def says_where_to_look(workspace: WorkspaceIndex) -> bool:
    """Whether a script, a container or a document of the workspace sets Python's path."""
    paths = workspace.tree.files_below(workspace.tree.top)
    return any("PYTHONPATH" in (workspace.tree.text(path) or "") for path in paths if path.endswith(_SETS_PATH))


def module_of_package(workspace: WorkspaceIndex, file: SourceFile, module: str, names: Sequence[str]) -> str | None:
    """The module of the package of a file that was meant by one that is nowhere: of this name in another folder, or of
    almost this name in the same one, if it defines all names that the file imports."""
    above = (file.module or "").rpartition(".")[0]
    if "." in module or not above or not is_unknown(workspace, file, module):
        return None
    top = above.partition(".")[0]
    own = [name for name in workspace.code.modules if name.startswith(f"{top}.")]
    alike = [name for name in own if name.rpartition(".")[2] == module]
    beside = {name.rpartition(".")[2]: name for name in own if name.rpartition(".")[0] == above}
    near = None if alike or not names else nearest(module, sorted(beside))
    meant = alike or ([beside[near]] if near is not None else [])
    is_meant = len(meant) == 1 and _has(workspace, file, meant[0], names)
    return meant[0] if is_meant and not _imports(workspace, file, meant[0], module) else None


def _imports(workspace: WorkspaceIndex, file: SourceFile, importer: str, module: str) -> bool:
    """Whether a module imports another one by itself, so that it is somewhere after all."""
    path = workspace.code.file_of_import(file.relative, importer)
    code = None if path is None else workspace.facts_at(path)
    if code is None:
        return False
    plain = (each.module for each in everything_in(code.body, facts.Import))
    from_modules = (each.module for each in everything_in(code.body, facts.ImportFrom))
    return any(name.partition(".")[0] == module for name in (*plain, *from_modules))


def _has(workspace: WorkspaceIndex, file: SourceFile, module: str, names: Sequence[str]) -> bool:
    path = workspace.code.file_of_import(file.relative, module)
    return path is not None and path != file.relative and all(offers(workspace, path, name) for name in names)


def absolute(file: SourceFile, module: str, level: int) -> str:
    """The whole name of a module that is imported by ``from .module import …``; empty where that is not known."""
    if not level:
        return module
    parts = (file.module or "").split(".")
    if posixpath.basename(file.relative) != "__init__.py":
        parts = parts[:-1]
    above = parts[: len(parts) - level + 1] if level <= len(parts) else []
    return ".".join(_filled((*above, module))) if _filled(above) else ""


def _filled(parts: Sequence[str]) -> list[str]:
    return [part for part in parts if part]


__all__ = ["absolute", "installed_name", "module_of_package"]

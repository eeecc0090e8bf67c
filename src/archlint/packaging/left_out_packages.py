"""Python packages that scripts which CMake installs, and launch files, import, and that no command installs.

Source: ``ament_python_install_package`` of ament_cmake_python, or an ``install()`` into ``PYTHON_INSTALL_DIR``, puts a
folder of the source where Python looks; a script alone has its own folder on the path, ``lib/PACKAGE``.
``rosidl_generate_interfaces`` of rosidl_generator_py installs a package of Python with the name of the project, which
has the interfaces and nothing else.
"""

from __future__ import annotations

import posixpath
import sys
from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.packaging.left_out_code import certain_imports, changes_path, has_init, launch_files_in_python
from archlint.packaging.uninstalled_files import understood
from archlint.place import Place
from archlint.records import dataclass
from archlint.ros.python_modules import is_known
from archlint.syntax import facts

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex
    from archlint.workspace.installed import Executable, Installs

_INSTALLS = frozenset({"ament_python_install_package", "ament_environment_hooks", "PYTHONPATH", "pybind11_add_module"})
"""Words of files that install Python packages, or may say themselves where Python looks."""


_GENERATES = "rosidl_generate_interfaces"
_OF_INTERFACES = frozenset({"msg", "srv", "action"})


@dataclass(frozen=True)
class LeftOutPackage:
    """A folder of Python code that an installed script imports by its name, or a launch file where that is None."""

    name: str
    folder: str
    package: str
    script: Executable | None
    needed_at: Place
    module: str = ""
    """The module that is lacking, where interfaces are generated under the name of the folder: Python finds these."""


def packages_of_scripts(workspace: WorkspaceIndex) -> Iterator[LeftOutPackage]:
    """Each such folder, once for each script."""
    for package, installs in understood(workspace).items():
        manifest = workspace.packages.get(package)
        if manifest is None or manifest.build_type != "ament_cmake" or installs.open_executables:
            continue
        if not _INSTALLS.isdisjoint(installs.words):
            continue
        for script in installs.executables.values():
            if script.script is not None and not script.wrong:
                yield from _left_out(workspace, installs, script, script.script)
        for file in launch_files_in_python(workspace):
            if workspace.package_of(file) == package:
                yield from _left_out(workspace, installs, None, file)


def _left_out(
    workspace: WorkspaceIndex, installs: Installs, script: Executable | None, path: str
) -> Iterator[LeftOutPackage]:
    code = workspace.facts_at(path)
    if code is None or changes_path(workspace, path):
        return
    told: set[str] = set()
    for statement in certain_imports(code.body):
        level = statement.level if isinstance(statement, facts.ImportFrom) else 0
        top = statement.module.partition(".")[0]
        if level or top in told or not _is_own(workspace, installs, statement):
            continue
        module = ""
        if top == installs.package and _GENERATES in installs.words:
            module = _beside_interfaces(workspace, installs, statement)
            if not module:
                continue
        told.add(top)
        folder = posixpath.normpath(posixpath.join(installs.folder, top))
        yield LeftOutPackage(top, folder, installs.package, script, Place(path, *statement.span), module)


def _beside_interfaces(
    workspace: WorkspaceIndex, installs: Installs, statement: facts.Import | facts.ImportFrom
) -> str:
    """The module of the source that an import names; empty where it is content with the interfaces."""
    top, *inside = statement.module.split(".")
    if inside:
        return "" if inside[0] in _OF_INTERFACES else statement.module
    names = [name for name, _ in statement.names] if isinstance(statement, facts.ImportFrom) else []
    folder = posixpath.join(installs.folder, top)
    paths = ((name, posixpath.normpath(posixpath.join(folder, name))) for name in names if name not in _OF_INTERFACES)
    there = (name for name, path in paths if workspace.tree.is_file(f"{path}.py") or workspace.tree.is_folder(path))
    return next((f"{top}.{name}" for name in there), "")


def _is_own(workspace: WorkspaceIndex, installs: Installs, statement: facts.Import | facts.ImportFrom) -> bool:
    """Whether an import means a folder of the package that nothing else is called like, and that nothing installs."""
    top, *inside = statement.module.split(".")
    folder = posixpath.normpath(posixpath.join(installs.folder, top))
    if not workspace.code.modules.get(top, frozenset()) <= {installs.package}:
        return False
    if not has_init(workspace, folder) or top in sys.stdlib_module_names or is_known(top):
        return False
    names = [inside] if inside else []
    if isinstance(statement, facts.ImportFrom):
        names += [[*inside, name] for name, _ in statement.names]
    files = [posixpath.join(folder, *parts[:-1], f"{parts[-1]}.py") for parts in names]
    files = [file for file in files if workspace.tree.is_file(file)] or [posixpath.join(folder, "__init__.py")]
    below = "" if installs.folder == "." else f"{installs.folder}/"
    return not any(any(installs.places_of(file)) or installs.may_install(file.removeprefix(below)) for file in files)


__all__ = ["LeftOutPackage", "packages_of_scripts"]

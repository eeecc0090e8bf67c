"""Sources and scripts of a package of CMake that are meant to be programs, and that its build does nothing with."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.aside import is_aside, starts_ros
from archlint.launch_files.launch_code import started_programs
from archlint.packaging.run_commands import told_to_run
from archlint.packaging.unbuilt_files import is_unknown_to_cmake, runs_nowhere
from archlint.place import Place
from archlint.records import dataclass
from archlint.syntax.walk import main_guard

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex
    from archlint.workspace.installed import Installs

_SOURCES = (".cc", ".cpp", ".cxx")
_MAIN = re.compile(r"^[ \t]*(?:int|auto)\s+main\s*\(", re.MULTILINE)


@dataclass(frozen=True)
class UnbuiltProgram:
    """A file that ``told`` says to run as ``name``; ``place`` is in the CMakeLists.txt that would have to name it."""

    package: str
    name: str
    file: str
    place: Place
    told: Place


def unbuilt_programs(workspace: WorkspaceIndex) -> Iterator[UnbuiltProgram]:
    """Each file with a program that a document says to start by ``ros2 run``; LCH001 tells of those that a launch file
    starts."""
    for (package, name), told in told_to_run(workspace).items():
        installs = workspace.installs.get(package)
        if installs is None or not _is_read(workspace, installs) or (package, name) in started_programs(workspace):
            continue
        if name in installs.executables or name in installs.mentioned:
            continue
        file, place = unbuilt_source(workspace, installs, {name}), _command_at(workspace, installs)
        file = file or _left_script(workspace, installs, name)
        below = posixpath.relpath(file, installs.folder) if file is not None else ""
        if file is None or installs.may_install(below) or is_aside(workspace, file):
            continue
        if place is not None:
            yield UnbuiltProgram(package, name, file, place, told)


def unbuilt_source(workspace: WorkspaceIndex, installs: Installs, names: set[str]) -> str | None:
    """The one C++ source of a package with a ``main()`` whose file has one of some names, and that no CMake file has a
    word for."""
    files = [
        file
        for file in workspace.tree.files_below(installs.folder)
        if file.endswith(_SOURCES) and posixpath.splitext(posixpath.basename(file))[0] in names
    ]
    if len(files) != 1 or workspace.roles.is_test(files[0]) or not runs_nowhere(workspace, files[0]):
        return None
    return files[0] if _MAIN.search(workspace.tree.text(files[0]) or "") else None


def _left_script(workspace: WorkspaceIndex, installs: Installs, name: str) -> str | None:
    """The one script of a package of a name, where no CMake file has a word for it; without its ending, too, as
    ``RENAME`` would have it."""
    files = [
        file
        for file in workspace.code.files_of(installs.package)
        if posixpath.basename(file) in (name, f"{name}.py") and is_unknown_to_cmake(workspace, installs, file)
    ]
    code = workspace.facts_at(files[0]) if len(files) == 1 and not workspace.roles.is_test(files[0]) else None
    is_program = code is not None and (main_guard(code) is not None or starts_ros(workspace, files[0]))
    return files[0] if is_program and not any(installs.places_of(files[0])) else None


def _is_read(workspace: WorkspaceIndex, installs: Installs) -> bool:
    package = workspace.packages.get(installs.package)
    is_built = package is not None and package.build_type == "ament_cmake" and bool(installs.build_files)
    return is_built and not installs.open_executables


def _command_at(workspace: WorkspaceIndex, installs: Installs) -> Place | None:
    """Where the CMakeLists.txt of a package calls ``ament_package()``, in front of which a target belongs."""
    path = posixpath.normpath(posixpath.join(installs.folder, "CMakeLists.txt"))
    lines = workspace.tree.lines_with(path, r"^\s*ament_(?:auto_)?package\s*\(")
    return Place(path, lines[0][0], 1, lines[0][0], 1) if lines else None


__all__ = ["UnbuiltProgram", "unbuilt_programs", "unbuilt_source"]

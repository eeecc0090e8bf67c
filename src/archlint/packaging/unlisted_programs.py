"""Modules of a Python package that are meant to be programs, and that no entry point makes one of.

Source: ``get_executable_paths`` of ros2pkg lists ``lib/PACKAGE``, and setuptools writes a file there for each entry
point alone.
"""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING

from archlint.analysis.aside import is_aside, starts_ros
from archlint.launch_files.launch_code import started_programs, words_of_launch_code
from archlint.packaging.run_commands import documents, told_to_run
from archlint.packaging.unlisted_modules import main_of
from archlint.place import Place
from archlint.records import dataclass

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex
    from archlint.workspace.installed import Installs

_FEWEST = 2
"""The programs that a package without any entry point has to have: a single one may be there to try it out."""


@dataclass(frozen=True)
class UnlistedProgram:
    """A module that is no program; ``told`` is the place that says to run it as ``name``, None where nothing does, and
    the package has no entry point at all."""

    package: str
    name: str
    module: str
    place: Place
    main: Place
    told: Place | None


def unlisted_programs(workspace: WorkspaceIndex) -> Iterator[UnlistedProgram]:
    """Each module that a document says to start by ``ros2 run``, and all of a package that has no entry point."""
    for name in sorted(workspace.installs):
        installs, package = workspace.installs[name], workspace.packages.get(name)
        if package is None or package.build_type != "ament_python" or installs.open_executables:
            continue
        place = _entry_points_at(workspace, installs)
        if place is None or is_aside(workspace, package.manifest.relative):
            continue
        mains = _mains(workspace, installs)
        told = [*_told(workspace, installs, mains, place)]
        yield from told or _of_no_entry(workspace, installs, mains, place)


def _told(
    workspace: WorkspaceIndex, installs: Installs, mains: Mapping[str, Place], place: Place
) -> Iterator[UnlistedProgram]:
    for (package, name), said in told_to_run(workspace).items():
        if package != installs.package or name in installs.executables or name in installs.mentioned:
            continue
        modules = [module for module in mains if module.rpartition(".")[2] == name.removesuffix(".py")]
        if len(modules) == 1 and (package, name) not in started_programs(workspace):
            yield UnlistedProgram(package, name, modules[0], place, mains[modules[0]], said)


def _of_no_entry(
    workspace: WorkspaceIndex, installs: Installs, mains: Mapping[str, Place], place: Place
) -> Iterator[UnlistedProgram]:
    started = any(package == installs.package for package, _ in started_programs(workspace))
    if installs.executables or len(mains) < _FEWEST or started:
        return  # LCH001 tells of what a launch file starts
    nodes = {module: main for module, main in mains.items() if _is_node(workspace, main.file)}
    if len(nodes) < _FEWEST or any(_is_started_otherwise(workspace, main.file) for main in nodes.values()):
        return
    for module, main in nodes.items():
        yield UnlistedProgram(installs.package, module.rpartition(".")[2], module, place, main, None)


def _mains(workspace: WorkspaceIndex, installs: Installs) -> dict[str, Place]:
    """The ``main()`` of each module that is installed and no entry point yet."""
    entries = {row.module for row in installs.executables.values()}
    rows: dict[str, Place] = {}
    for module, file in sorted(workspace.code.modules_of(installs.package).items()):
        if module in entries or "." not in module or workspace.roles.is_test(file) or is_aside(workspace, file):
            continue
        main = main_of(workspace, file) if installs.python is None or installs.python.has(file) else None
        if main is not None:
            rows[module] = main
    return rows


def _is_node(workspace: WorkspaceIndex, file: str) -> bool:
    spins = any(workspace.code.mentions(file, word) for word in ("spin", "spin_once", "spin_until_future_complete"))
    return spins and starts_ros(workspace, file)


def _is_started_otherwise(workspace: WorkspaceIndex, file: str) -> bool:
    return file in workspace.code.in_use or _is_named(workspace, file)


def _entry_points_at(workspace: WorkspaceIndex, installs: Installs) -> Place | None:
    """Where the entry points of a setup.py are written, or else its call of ``setup()``; None where there is none."""
    path = posixpath.normpath(posixpath.join(installs.folder, "setup.py"))
    if installs.data_files_at is None or installs.data_files_at.file != path:
        return None
    lines = workspace.tree.lines_with(path, r"console_scripts") or workspace.tree.lines_with(path, r"entry_points")
    return Place(path, lines[0][0], 1, lines[0][0], 1) if lines else installs.data_files_at


def _is_named(workspace: WorkspaceIndex, file: str) -> bool:
    """Whether a document, a script or a launch file has the name of a file, or of its module after ``-m``: that is how
    it is started."""
    stem = posixpath.basename(file).removesuffix(".py")
    named = re.compile(rf"(?<!\w){re.escape(stem)}\.py\b|-m\s+[\w.]*\b{re.escape(stem)}\b")
    if any(map(named.search, documents(workspace).values())):
        return True
    return any(f"{stem}.py" in text for words in words_of_launch_code(workspace) for text in words)


__all__ = ["UnlistedProgram", "unlisted_programs"]

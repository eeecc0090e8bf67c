"""Programs of C++ that CMake builds and that ``ros2 run`` does not find, as they are not installed in ``lib/PACKAGE``.

Source: ``get_executable_paths`` of ros2pkg lists ``lib/PACKAGE`` alone.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.aside import is_aside
from archlint.launch_files.launch_code import started_programs
from archlint.packaging.run_commands import told_to_run
from archlint.records import dataclass

if TYPE_CHECKING:
    from archlint.place import Place
    from archlint.systems.model import WorkspaceIndex
    from archlint.workspace.installed import Executable

_LIBRARIES = "lib"


@dataclass(frozen=True)
class BuiltOutOfSight:
    """A program that comes to ``folder``, or is not installed where that is empty."""

    executable: Executable
    place: Place
    folder: str


def built_out_of_sight(workspace: WorkspaceIndex) -> Iterator[BuiltOutOfSight]:
    """Each program that somebody starts by the name of its package, and is installed elsewhere; each with a node among
    the libraries; and of those that are not installed, each that a text says to run, as LCH001 tells the rest."""
    started = started_programs(workspace)
    for name in sorted(workspace.installs):
        installs = workspace.installs[name]
        package = workspace.manifests.get(installs.folder)
        if package is None or package.build_type != "ament_cmake" or is_aside(workspace, package.manifest.relative):
            continue
        for program, astray in installs.astray.items():
            executable = installs.executables.get(program)
            if executable is None or not executable.sources:
                continue
            launched, told = (name, program) in started, (name, program) in told_to_run(workspace)
            if not astray.folder and not launched and told:
                yield BuiltOutOfSight(executable, executable.place, "")
            amid_libraries = astray.folder == _LIBRARIES and _is_of_ros(workspace, executable)
            if astray.folder and (launched or told or amid_libraries):
                yield BuiltOutOfSight(executable, astray.place or executable.place, astray.folder)


def _is_of_ros(workspace: WorkspaceIndex, executable: Executable) -> bool:
    return any(workspace.code.mentions(source, "rclcpp") for source in executable.sources)


__all__ = ["BuiltOutOfSight", "built_out_of_sight"]

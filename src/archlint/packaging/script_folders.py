"""Where setuptools puts the programs of a package, and whether ``ros2 run`` and launch look there.

Source: colcon's task for ``ament_python`` hands ``setup.py`` a prefix and no folder for scripts, so that they go to
``bin`` unless the package's setup.cfg says otherwise; ``get_executable_paths`` of ros2pkg lists ``lib/PACKAGE`` alone.
"""

from __future__ import annotations

import configparser
import posixpath
import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.aside import is_aside
from archlint.finding import Place
from archlint.launch_files.launch_code import started_programs
from archlint.records import dataclass

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex
    from archlint.workspace.installed import Executable

_OPTION = "install_scripts"


@dataclass(frozen=True)
class OutOfSight:
    """A package whose programs go to ``folder``, or to ``bin`` where that is empty; ``executable`` is the first one,
    None where there is none yet."""

    package: str
    executable: Executable | None
    place: Place
    folder: str = ""


def out_of_sight(workspace: WorkspaceIndex) -> Iterator[OutOfSight]:
    """The packages of ``ament_python`` whose programs go where nobody looks for them."""
    for folder in sorted(workspace.manifests):
        package = workspace.manifests[folder]
        installs = workspace.installs.get(package.name)
        if package.build_type != "ament_python" or installs is None or installs.folder != folder:
            continue
        if is_aside(workspace, package.manifest.relative) or _says_elsewhere(workspace, folder):
            continue
        path = posixpath.normpath(posixpath.join(folder, "setup.cfg"))
        text = workspace.tree.text(path) if workspace.tree.is_file(path) else ""
        wanted = _folder_of_scripts(text or "")
        if text is None or wanted is None or (wanted and not _is_of_another(wanted, package.name)):
            continue
        if installs.is_indexed_as(posixpath.basename(wanted)):
            continue  # under that name it is found
        programs = [e for e in installs.executables.values() if _is_of_ros(workspace, folder, e)]
        if programs:
            first = min(programs, key=lambda executable: executable.place)
            place = _line_of(path, text) if wanted else first.place
            yield OutOfSight(package.name, first, place, posixpath.basename(wanted))
        elif wanted and not installs.executables and not installs.open_executables:
            yield OutOfSight(package.name, None, _line_of(path, text), posixpath.basename(wanted))


def _is_of_another(folder: str, package: str) -> bool:
    """Whether a folder for programs is the one of another package."""
    return posixpath.basename(folder) != package and re.fullmatch(r"\$base/lib/[\w.-]+", folder) is not None


def _is_of_ros(workspace: WorkspaceIndex, folder: str, executable: Executable) -> bool:
    """Whether a console script is one for ``ros2 run`` and launch: its module uses rclpy, or a launch file starts it.
    Command-line tools are at home in ``bin``."""
    if executable.function is None or executable.module is None or executable.wrong:
        return False
    path = posixpath.normpath(posixpath.join(folder, *executable.module.split(".")))
    started = started_programs(workspace)
    return (executable.package, executable.name) in started or workspace.code.mentions(f"{path}.py", "rclpy")


def _says_elsewhere(workspace: WorkspaceIndex, folder: str) -> bool:
    """Whether a setup.py or a pyproject.toml may name the folder, or put programs into it by itself."""
    for name in ("setup.py", "pyproject.toml"):
        text = workspace.tree.text(posixpath.normpath(posixpath.join(folder, name))) or ""
        if re.search(r"install[_-]scripts|script[_-]dir|cmdclass|['\"]lib['\"/]", text):
            return True
    return False


def _folder_of_scripts(text: str) -> str | None:
    """What a setup.cfg says; empty where it says nothing, None where it cannot be read."""
    reader = configparser.RawConfigParser(strict=False)
    try:
        reader.read_string(text)
    except configparser.Error:
        return None
    options = dict(reader.items("install")) if reader.has_section("install") else {}
    return options.get(_OPTION, options.get("install-scripts", "")).strip().rstrip("/")


def _line_of(path: str, text: str) -> Place:
    for number, line in enumerate(text.splitlines(), 1):
        if re.match(r"install[_-]scripts", line):
            return Place(path, number, 1, number, len(line.rstrip()) + 1)
    return Place(path, 1, 1, 1, 1)


__all__ = ["OutOfSight", "out_of_sight"]

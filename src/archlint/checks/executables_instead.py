"""What LCH001 says to start or to install in place of an executable that is not there."""

from __future__ import annotations

import posixpath
from collections.abc import Sequence
from typing import TYPE_CHECKING, NamedTuple

from archlint.checks.packages import is_ignored_by_cmake
from archlint.packaging.commented_out import absent_module_in_comment, commented_out_in
from archlint.packaging.entry_points import is_empty, starts_nothing
from archlint.packaging.unbuilt_programs import unbuilt_source
from archlint.ros.released_programs import owner_of_program, programs_of
from archlint.suggestions import did_you_mean, listed

if TYPE_CHECKING:
    from archlint.launch.started import Started
    from archlint.systems.model import WorkspaceIndex
    from archlint.workspace.installed import Astray, Executable, Installs


class Advice(NamedTuple):
    """What is said of an executable that is not there, beside that it is not."""

    hint: str
    help: str
    is_left_out: bool = False
    """Whether its file is there, so that one edit of a build file mends it together with others."""
    is_on_purpose: bool = False


def advice_on_launch_file(installs: Installs, started: Started, name: str, workspace: WorkspaceIndex) -> Advice | None:
    """What is said of a launch file of the package that is started as if it were a program."""
    files = [
        file
        for file in workspace.launch_files.all()
        if posixpath.basename(file) == name and workspace.package_of(file) == installs.package
    ]
    if len(files) != 1:
        return None
    return Advice(f": {files[0]} is a launch file, and no program", f"include it instead: {include_of(started)}")


def advice_on(installs: Installs, name: str, workspace: WorkspaceIndex) -> Advice:
    """What to start or to install instead of an executable that is not there: a hint and a line of help."""
    installed = installed_by(workspace, installs)
    known = sorted(name for name in installed if name not in installs.astray)
    advice = _on_what_is_installed(installs, name, workspace, known) or _on_file(installs, name, workspace, known)
    advice = advice or _on_package_of_ros(installs, name, workspace, known)
    if advice is not None:
        return advice
    if not known and len(installs.astray) == 1:
        return _only_program(*next(iter(installs.astray.items())))
    others = f", or start one that the package installs: {listed(known)}" if known else ""
    return Advice(did_you_mean(name, known), f"add it to {_build_file(installs, workspace)}{others}")


def _on_what_is_installed(
    installs: Installs, name: str, workspace: WorkspaceIndex, known: Sequence[str]
) -> Advice | None:
    """What is said where the program is installed under another name, elsewhere, or by another package."""
    stems = {program: stem_of(installs.executables[program]) for program in known}
    same = [program for program in known if stems[program] == name.removesuffix(".py")]
    if not same:
        same = [file for file in known if file.endswith(".py") and stems[file] == name.removesuffix("_node")]
    if len(same) == 1:
        source = installs.executables[same[0]]
        return Advice(f"; {source.script or source.module} is installed as '{same[0]}'", f"start '{same[0]}'")
    if name in installs.too_deep:
        where = installs.too_deep[name]
        return Advice(
            f": it is installed as {where}",
            "install the content of the folder, with a trailing slash: install(DIRECTORY …/ …)",
        )
    if elsewhere := _installed_elsewhere(installs, workspace, name):
        return elsewhere
    owners = [
        other.package
        for other in workspace.installs.values()
        if name in installed_by(workspace, other) and name not in other.astray
    ]
    if len(owners) == 1:
        return Advice(f"; package '{owners[0]}' installs it", f"start it from package '{owners[0]}'")
    return None


def _on_file(installs: Installs, name: str, workspace: WorkspaceIndex, known: Sequence[str]) -> Advice | None:
    """What is said where a file of the package is what the program would be made of."""
    build = _build_file(installs, workspace)
    files = workspace.code.files_of(installs.package)
    there = [file for file in files if posixpath.basename(file) == name]
    if len(there) == 1:
        return Advice(did_you_mean(name, known), f"install {there[0]} in {build}")
    if file := commented_out_in(workspace, installs.build_files, name):
        help = "remove the node, or take the marks of the comment away"
        if (module := absent_module_in_comment(workspace, installs, file, name)) is not None:
            help = f"remove the node: that line is of a module '{module}', which does not exist"
        return Advice(f": its lines in {file} are a comment", help, is_on_purpose=True)
    stems = {name, name.removesuffix("_node")} - set(map(stem_of, installed_by(workspace, installs).values()))
    meant = [file for file in files if posixpath.basename(file).removesuffix(".py") in stems]
    if len(meant) == 1:
        elsewhere = _installed_elsewhere(installs, workspace, posixpath.basename(meant[0]))
        return elsewhere or _on_source(workspace, meant[0], name, build)  # nearer than another node of a similar name
    if unbuilt := unbuilt_source(workspace, installs, stems):
        return Advice(
            f"; {unbuilt} exists, and no target compiles it", f"add a target for it to {build}, and install it"
        )
    return None


def _on_source(workspace: WorkspaceIndex, file: str, name: str, build: str) -> Advice:
    """What is said of the Python file of a program."""
    if is_empty(workspace, file):
        return Advice(f"; {file} is empty", f"remove the node, or write its program there and install it in {build}")
    if starts_nothing(workspace, file):
        return Advice(f"; {file} is not installed and starts nothing", f"give it a main(), and install it in {build}")
    help = f"install it in {build} under the name '{name}'"
    return Advice(f"; {file} exists but is not installed", help, is_left_out=True)


def _on_package_of_ros(installs: Installs, name: str, workspace: WorkspaceIndex, known: Sequence[str]) -> Advice | None:
    """What is said where a well-known package of ROS has the program."""
    if name in programs_of(installs.package):
        return Advice(
            "; the package of ROS with that name does, and this one hides it",
            "give this package a name of its own, so that launch finds that of ROS",
        )
    owner = owner_of_program(name)
    if owner is None or owner in workspace.packages or did_you_mean(name, known):
        return None
    return Advice(f"; package '{owner}' of ROS does", f"start it from package '{owner}'")


def _installed_elsewhere(installs: Installs, workspace: WorkspaceIndex, name: str) -> Advice | None:
    """What is said of a file of the package that is installed under a name, in another folder than that of programs."""
    if posixpath.splitext(name)[1] not in _PROGRAMS:
        return None
    places = [
        f"{row.destination}/{name}"
        for row in installs.files
        if not row.folder and name == (row.rename or posixpath.basename(row.source))
    ]
    places += [place for file in workspace.code.files_of(installs.package) for place in installs.places_of(file)]
    folders = {posixpath.dirname(place) for place in places if posixpath.basename(place) == name}
    if len(folders) != 1:
        return None
    by_setup = _build_file(installs, workspace) == "setup.py"
    return Advice(
        f": '{name}' is installed in {folders.pop()}, and launch looks in lib/{installs.package}",
        f"put it into the data_files of 'lib/{installs.package}' in setup.py, and start '{name}'"
        if by_setup
        else f"install it by install(PROGRAMS … DESTINATION lib/${{PROJECT_NAME}}), and start '{name}'",
    )


_PROGRAMS = ("", ".py", ".sh")
"""What the names of programs end in."""


def _only_program(program: str, astray: Astray) -> Advice:
    """What is said of the one program of a package that is out of sight."""
    if not astray.folder:
        install = f"install(TARGETS {program} DESTINATION lib/${{PROJECT_NAME}})"
        return Advice(
            f"; it builds '{program}', and installs that nowhere",
            f"add {install} to CMakeLists.txt, and start '{program}'",
        )
    return Advice(
        f"; its '{program}' is installed in {astray.folder}, where launch does not look",
        f"install '{program}' with DESTINATION lib/${{PROJECT_NAME}}, and start that",
    )


def stem_of(executable: Executable) -> str:
    """The file that an executable runs, by its name alone."""
    if executable.script is not None:
        return posixpath.basename(executable.script).removesuffix(".py")
    return (executable.module or "").rpartition(".")[2]


def _build_file(installs: Installs, workspace: WorkspaceIndex) -> str:
    """The file in which a package names its executables."""
    package = workspace.packages.get(installs.package)
    wanted = "setup.py" if package is not None and package.build_type == "ament_python" else "CMakeLists.txt"
    names = [posixpath.basename(file) for file in installs.build_files]
    return wanted if wanted in names else names[0]


def installed_by(workspace: WorkspaceIndex, installs: Installs) -> dict[str, Executable]:
    """The executables of a package without those of a setup.py that CMake does not read."""
    package = workspace.packages.get(installs.package)
    return {
        name: executable
        for name, executable in installs.executables.items()
        if not is_ignored_by_cmake(package, executable)
    }


def include_of(started: Started) -> str:
    return _INCLUDE.get(posixpath.splitext(started.file)[1], "include:")


_INCLUDE = {".py": "IncludeLaunchDescription(…)", ".xml": '<include file="…"/>'}


__all__ = ["Advice", "advice_on", "advice_on_launch_file", "include_of", "installed_by", "stem_of"]

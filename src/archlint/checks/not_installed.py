"""PKG004: what a package's setup.py or CMakeLists.txt leaves out, and another file needs."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.checks.data_beside_modules import of_data_beside_modules
from archlint.checks.files_in_index import of_files_in_index
from archlint.checks.folding import folds, with_others
from archlint.checks.left_out_by_cmake import left_out_by_cmake
from archlint.checks.left_out_headers import of_left_out_headers
from archlint.checks.listed_packages import of_packages_in_vain, packages_in_vain
from archlint.checks.packages import workspace_of
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.checks.script_imports import BESIDE, imports_of_scripts
from archlint.finding import Finding, Related
from archlint.launch_files.missing_files import namesake
from archlint.packaging.astray_launch_files import launch_files_astray
from archlint.packaging.copies import are_copies
from archlint.packaging.interface_dependencies import NotGenerated, not_generated
from archlint.packaging.left_out_code import LeftOut, has_init, left_out_code
from archlint.packaging.misplaced_folders import folder_meant, with_its_ending
from archlint.packaging.refused_manifests import is_passed_over
from archlint.packaging.uninstalled_data import DataLeftOut, data_left_out
from archlint.packaging.uninstalled_files import (
    FolderListed,
    LaunchFilesLeftOut,
    ListedInVain,
    MisnamedMarker,
    folders_listed,
    launch_files_left_out,
    listed_in_vain,
    misnamed_markers,
    understood,
)
from archlint.records import dataclass
from archlint.suggestions import listed, meant, nearest

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.systems.model import System, WorkspaceIndex
    from archlint.workspace.installed import AbsentFolder

_GENERATES = "rosidl_generate_interfaces()"
_SHOWN = 5
"""How many places that need something are related."""


@rule("PKG004", scope=Scope.WORKSPACE, in_use=True)
def not_installed(system: System, options: Options) -> Iterator[Finding]:
    """Code and launch files that the build of a package leaves out, and files that it lists in vain."""
    workspace = workspace_of(system)
    if workspace is not None:
        yield from (told for told in _all_left_out(workspace) if not is_passed_over(workspace, told.place.file))


def _all_left_out(workspace: WorkspaceIndex) -> Iterator[Finding]:
    needed: dict[str, list[LeftOut]] = {}
    for needing in left_out_code(workspace):
        needed.setdefault(needing.package, []).append(needing)
    in_vain = packages_in_vain(workspace)
    for package, rows in needed.items():
        if _absent_folder(workspace, package) is None and package not in in_vain:
            yield _code(workspace, package, rows)
    yield from _packages_nowhere(workspace)
    yield from of_packages_in_vain(workspace, needed)
    files_in_vain = list(listed_in_vain(workspace))
    left_out = list(launch_files_left_out(workspace))
    misspelt = {(row.place.file, row.file): right for row in files_in_vain if (right := _right_name(row, left_out))}
    spelt = {(file, right) for (file, _), right in misspelt.items()}
    for launch_row in left_out:
        files = tuple(file for file in launch_row.files if (launch_row.place.file, file) not in spelt)
        if files:
            yield _launch_files(replace(launch_row, files=files))
    named: dict[str, list[DataLeftOut]] = {}
    for named_row in data_left_out(workspace):
        named.setdefault(named_row.package, []).append(named_row)
    yield from map(_astray, launch_files_astray(workspace))
    yield from map(_data, named.values())
    yield from _all_in_vain(workspace, files_in_vain, misspelt)
    yield from map(_folder, folders_listed(workspace))
    yield from map(_misnamed, misnamed_markers(workspace))
    yield from of_files_in_index(workspace)
    commands = {row.place.file for row in files_in_vain if row.command == _GENERATES}
    yield from (_interfaces(row) for row in not_generated(workspace) if row.command.file not in commands)
    yield from imports_of_scripts(workspace)
    yield from left_out_by_cmake(workspace)
    yield from of_data_beside_modules(workspace)
    yield from of_left_out_headers(workspace)


# ------------------------------------------------------------------------------------------------- Python code


@dataclass(frozen=True)
class _Group:
    """What ``packages=`` leaves out: a package of Python, or a module that is in none (``folder`` is None then)."""

    name: str
    folder: str | None


def _code(workspace: WorkspaceIndex, package: str, rows: Sequence[LeftOut]) -> Finding:
    code = workspace.installs[package].python
    assert code is not None  # or nothing would be known to be left out
    names = {path: name for name, path in workspace.code.modules_of(package).items()}
    groups: dict[_Group, list[LeftOut]] = {}
    names |= {row.file: row.module for row in rows if row.module}
    for row in rows:  # a module beside a folder of its name shares that
        folder = workspace.installs[package].folder
        name = names.setdefault(row.file, posixpath.relpath(row.file, folder).removesuffix(".py").replace("/", "."))
        groups.setdefault(_group(row.file, name), []).append(row)
    [first, *others] = groups
    if others:
        what = f"packages= leaves out {listed([group.name for group in groups])}, which installed code needs"
    else:
        [row, *_] = groups[first]
        needed = f"in which the executable '{row.entry}' is" if row.entry else f"which {row.needed_at.file} imports"
        what = f"packages= leaves out '{first.name}', {needed}"
    places = {row.needed_at: row for group in groups.values() for row in group}
    related = [
        Related(place, f"the entry of '{row.entry}'" if row.entry else f"'{names[row.file]}' is imported here")
        for place, row in list(places.items())[:_SHOWN]
    ]
    return finding(
        "PKG004",
        code.place,
        f"{what}: a build without --symlink-install does not have it, and the import fails",
        help=_cure(workspace, list(groups), searched=code.searched),
        related=related,
        identity=(package, *(group.name for group in groups)),
    )


def _absent_folder(workspace: WorkspaceIndex, package: str) -> AbsentFolder | None:
    code = workspace.installs[package].python
    return None if code is None else code.absent


def _packages_nowhere(workspace: WorkspaceIndex) -> Iterator[Finding]:
    """Each ``package_dir=`` that leads to a folder which is not there: the build stops, so nothing else counts."""
    for package in understood(workspace):
        absent = _absent_folder(workspace, package)
        if absent is not None:
            yield finding(
                "PKG004",
                absent.place,
                f"package_dir= puts packages into '{absent.path}', a folder that is not there: the build stops",
                help="remove package_dir=: the packages are beside setup.py"
                if absent.unneeded
                else f"move the packages to '{absent.path}', or change package_dir=",
                identity=(package, "package_dir"),
            )


def _group(file: str, module: str) -> _Group:
    folder = posixpath.dirname(file) or "."
    if posixpath.basename(file) == "__init__.py":
        return _Group(module, folder)
    parent = module.rpartition(".")[0]
    return _Group(parent, folder) if parent else _Group(module, None)


def _folders_of(group: _Group) -> list[str]:
    """The folder of a Python package and those of the packages that it is in, the outermost first."""
    if group.folder is None:
        return []
    folders = [group.folder]
    for _ in range(group.name.count(".")):
        folders.insert(0, posixpath.dirname(folders[0]) or ".")
    return folders


def _cure(workspace: WorkspaceIndex, groups: Sequence[_Group], *, searched: bool) -> str:
    folders = (folder for group in groups for folder in _folders_of(group) if not has_init(workspace, folder))
    bare = [*dict.fromkeys(folders)]
    if searched and bare:
        files = listed([f"{folder}/__init__.py" for folder in bare])
        added = f"an empty file {files}" if len(bare) == 1 else f"empty files {files}"
        return f"add {added}: find_packages() passes over a folder without one"
    if all(group.folder is None for group in groups):
        return f"add py_modules=[{', '.join(repr(group.name) for group in groups)}]"
    if searched:
        return "change the include= or exclude= of find_packages(), which leaves it out"
    return f"add {', '.join(repr(group.name) for group in groups if group.folder is not None)} to packages="


# ---------------------------------------------------------------------------------------- launch files, data files


def _launch_files(row: LaunchFilesLeftOut) -> Finding:
    names = [posixpath.basename(file) for file in row.files]
    cmake = row.place.file.endswith("CMakeLists.txt")
    if len(names) == 1:
        message = f"package '{row.package}' does not install the launch file '{names[0]}'"
    else:
        message = f"package '{row.package}' does not install these {len(names)} launch files: {listed(names)}"
    # The files by their names: not every setup.py imports glob.
    more = "" if len(row.files) <= _SHOWN else ", and so the others,"
    line = (
        "write install(DIRECTORY launch DESTINATION share/${PROJECT_NAME}) before ament_package()"
        if cmake
        else _to_data_files(row.place, f"share/{row.package}/launch", row.files[:_SHOWN], more)
    )
    return finding(
        "PKG004",
        row.place,
        f"{message}: ros2 launch does not find {_it(len(names))}",
        help=line,
        related=[Related(place, "it is to be started like this") for place in row.told_at[:_SHOWN]],
        identity=(row.package, "launch", *names),
    )


def _astray(row: LaunchFilesLeftOut) -> Finding:
    names = [posixpath.basename(file) for file in row.files]
    what = f"the launch file '{names[0]}'" if len(names) == 1 else f"all {len(names)} launch files"
    return finding(
        "PKG004",
        row.place,
        f"package '{row.package}' installs {what} in '{row.instead}', where ros2 launch does not look",
        help=f"install {_it(len(names))} in 'share/{row.package}/launch'",
        identity=(row.package, "launch", *names),
    )


def _to_data_files(place: Place, folder: str, files: Sequence[str], more: str = "") -> str:
    """How to install files with setuptools: what a setup.py lists itself would hide the list of its setup.cfg."""
    if place.file.endswith("setup.cfg"):
        return f"add {listed(files)}{more} under '{folder} =' in [options.data_files]"
    return f"add ('{folder}', {list(files)}){more} to data_files="


def _data(named: Sequence[DataLeftOut]) -> Finding:
    """The finding for what code looks for; a folder in which a file is named, too, is not named by itself."""
    rows = [row for row in named if not any(other.file.startswith(f"{row.file}/") for other in named)]
    [first, *_] = rows
    files = list(dict.fromkeys(row.file for row in rows))
    kind = "folder" if all(row.folder for row in rows) else "file"
    what = f"the {kind} '{first.file}'" if len(files) == 1 else f"these {len(files)} {kind}s: {listed(files)}"
    told = (
        f"package '{first.package}' does not install {what}, which {first.named_at.file} looks for in its share folder"
    )
    if all(row.instead for row in rows):
        them, comes = ("it", "it comes") if len(files) == 1 else ("them", f"'{first.file}' comes")
        told = f"package '{first.package}' installs {what} elsewhere than where {first.named_at.file} looks for {them}"
        told += f": {comes} to '{first.instead}'"
    return finding(
        "PKG004",
        first.place,
        told,
        help=_installed_data(first, rows),
        related=[Related(row.named_at, f"'{row.file}' is named here") for row in rows[:_SHOWN]],
        identity=(first.package, *files),
    )


def _installed_data(first: DataLeftOut, rows: Sequence[DataLeftOut]) -> str:
    """How to install a folder, or a file and those beside it."""
    folder = posixpath.dirname(first.file)
    below, cmake = f"share/{first.package}", first.place.file.endswith("CMakeLists.txt")
    if first.folder and cmake:
        return f"write install(DIRECTORY {first.file} DESTINATION share/${{PROJECT_NAME}}/{folder}".rstrip("/") + ")"
    if first.folder and not first.place.file.endswith("setup.cfg"):
        return f"add ('{below}/{first.file}', glob('{first.file}/*')) to data_files="
    if first.folder:
        return _to_data_files(first.place, f"{below}/{first.file}", [f"{first.file}/*"])
    alike = [*dict.fromkeys(row.file for row in rows if posixpath.dirname(row.file) == folder)][:_SHOWN]
    if cmake:
        return f"write install(FILES {' '.join(alike)} DESTINATION share/${{PROJECT_NAME}}/{folder})"
    return _to_data_files(first.place, f"{below}/{folder}".rstrip("/"), alike)


def _right_name(row: ListedInVain, left_out: Sequence[LaunchFilesLeftOut]) -> str | None:
    """The launch file beside a listed one that is not there, which is not installed and has almost its name."""
    folder = posixpath.dirname(row.file)
    rows = [other for other in left_out if other.place.file == row.place.file]
    beside = [file for other in rows for file in other.files if posixpath.dirname(file) == folder]
    return nearest(row.file, beside)


def _all_in_vain(
    workspace: WorkspaceIndex, rows: Sequence[ListedInVain], misspelt: Mapping[tuple[str, str], str]
) -> Iterator[Finding]:
    """Each of these, those of one list and those of one folder that is not there with one group."""
    groups: dict[tuple[str, str], tuple[str, str]] = {}
    for row in rows:
        file, own = row.place.file, (row.place.file, row.command)
        group = groups.setdefault((file, row.within), own) if row.within else own
        right = misspelt.get((file, row.file)) or _elsewhere(workspace, row)
        told, original = _in_vain(row, right), _original(workspace, row, right)
        cure = told.help if original is None else f"delete this file, which is a copy of {original}"
        yield replace(told, help=cure, group=group)


def _original(workspace: WorkspaceIndex, row: ListedInVain, right: str | None) -> str | None:
    """The build file that one is a copy of, where that lies beside what the copy lists in vain."""
    if right is None or not right.endswith(f"/{row.file}"):
        return None
    folder, name = posixpath.split(row.place.file)
    beside = posixpath.join(folder, right[: -len(row.file)], name)
    return beside if are_copies(workspace, row.place.file, beside) else None


def _elsewhere(workspace: WorkspaceIndex, row: ListedInVain) -> str | None:
    """The only file of the package with the name of a listed one that is not there, in another folder; of a folder, the
    one of its name that is a level below."""
    package = workspace.package_of(row.place.file)
    if row.marker:
        return row.own_marker or None
    if package is None or row.command == "add_subdirectory()":
        return None
    if row.folder:
        return folder_meant(workspace, package, row.file)
    return namesake(workspace, package, row.file) or with_its_ending(workspace, package, row.file)


_A_FOLDER = "a folder"


def _in_vain(row: ListedInVain, right: str | None) -> Finding:
    kind = "folder" if row.folder else "file"
    what = "the marker of the package" if row.marker else _A_FOLDER if row.folder else "a file"
    verb, line = (
        ("needs", "remove the line") if row.command == "add_subdirectory()" else ("lists", "take it off the list")
    )
    cure = f"add an empty file '{row.file}'" if row.marker else f"add the {kind}, or {line}"
    return finding(
        "PKG004",
        row.place,
        f"{row.command} {verb} {what} that is not there: the build stops at '{row.file}'"
        + (meant(f"'{right}'") if right else ""),
        help=f"write '{right}'" if right else cure,
        identity=(row.file,),
        meant=right or "",
    )


def _misnamed(row: MisnamedMarker) -> Finding:
    right = f"resource/{row.package}"
    is_marker = posixpath.dirname(row.file) == "resource"  # else it is a file that has another use
    renamed = f"rename '{row.file}' to '{right}'" if is_marker else f"have an empty file '{right}'"
    renamed += f", and write '{row.package}' in setup.py and setup.cfg" if row.scripts_too else ", and write that here"
    return finding(
        "PKG004",
        row.place,
        f"the marker that data_files= installs is '{row.name}', and this is package '{row.package}': ROS takes this "
        f"package for '{row.name}', too",
        help=f"write <name>{row.name}</name> in package.xml, as it is started by that name" if row.used else renamed,
        identity=(row.package, row.name),
        group=(row.place.file, "marker"),
    )


def _folder(row: FolderListed) -> Finding:
    return finding(
        "PKG004",
        row.place,
        f"'{row.pattern}' in data_files= matches a folder, '{row.folder}': the build stops, as it copies files alone",
        help=f"list the files of '{row.folder}' in an entry of their own, and take only files here",
        identity=(row.folder,),
        group=(row.place.file, "folder"),
    )


def _interfaces(row: NotGenerated) -> Finding:
    what = f"'{row.files[0]}'" if len(row.files) == 1 else f"{len(row.files)} files that are named here"
    names = "" if len(row.files) == 1 else f": {listed(row.files)}"
    return finding(
        "PKG004",
        row.command,
        f"rosidl_generate_interfaces() is not given {what}{names}: nobody can import {_it(len(row.files))}",
        help="hand the list that names it to rosidl_generate_interfaces()",
        identity=(row.package.name, *row.files),
        group=(row.command.file, "interfaces"),
    )


def _it(number: int) -> str:
    return "it" if number == 1 else "them"


@folds("PKG004")
def _of_one_list(findings: Sequence[Finding]) -> Finding:
    """One finding for all files that one setup.py, or one kind of command of a CMake file, lists in vain, and for the
    folders that patterns match."""
    if len(findings) > 1 and findings[0].group[-1] == "folder":
        return with_others(findings, "another pattern of the file does", "more patterns of the file do", "the same")
    if findings[0].group[-1] == BESIDE:
        return with_others(findings, "another module is", "more modules are", "left out, too")
    kind = "folder" if all(_A_FOLDER in each.message for each in findings) else "file"
    return with_others(findings, f"another {kind} is", f"more {kind}s are", "not there, either")


__all__ = ["not_installed"]

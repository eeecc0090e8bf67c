"""What a package leaves out of its share folder: launch files, and files that its setup.py lists in vain.

A setup.py without the marker of its package is no mistake here: colcon writes one.  Source: ``AmentPythonBuildTask`` of
colcon-ros, ``copy_file`` of setuptools' distutils, ``get_share_file_path_from_package`` of ros2launch.
"""

from __future__ import annotations

import fnmatch
import posixpath
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING

from archlint.analysis.aside import is_aside
from archlint.analysis.kept import once
from archlint.launch.kinds import FileStatus
from archlint.launch_files.launch_code import writes_files
from archlint.packaging.foreign_launch_files import is_of_another_project
from archlint.packaging.generated_files import is_ignored, submodule_around
from archlint.packaging.told_scripts import tells_commands
from archlint.place import Place
from archlint.records import dataclass
from archlint.workspace.installed import MARKERS

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex
    from archlint.workspace.installed import InstalledFiles, Installs, NeededSource


@dataclass(frozen=True)
class LaunchFilesLeftOut:
    """Launch files that ``ros2 launch`` does not find; ``told_at`` are the places of texts that tell people to start
    them so."""

    package: str
    place: Place
    """Where the build should install them."""
    files: tuple[str, ...]
    """By their paths below the folder of the package."""
    told_at: tuple[Place, ...] = ()
    instead: str = ""
    """The folder, below the prefix, that the build puts them into; empty where it leaves them out."""


def launch_files_left_out(workspace: WorkspaceIndex) -> Iterator[LaunchFilesLeftOut]:
    """Of a package that installs none of the launch files in its folder ``launch``, these, and those that its list of
    them lacks; of any other package, those that a text of the workspace says to start by its name."""
    for installs in understood(workspace).values():
        place = mended_at(workspace, installs)
        own = own_launch_files(workspace, installs)
        missing = [
            file for file in own if not any(installs.places_of(file)) and file not in files_told_already(workspace)
        ]
        missing = [file for file in missing if not any(map(installs.may_install, paths_below(installs, [file])))]
        missing = [file for file in missing if not is_of_another_project(workspace, installs.package, file)]
        if place is None or not missing:
            continue
        told = {file: list(_told_at(workspace, installs.package, file)) for file in missing}
        some = len(missing) < len(own) and not _is_off_a_list(installs, own, missing)
        if some or any(_is_started_by_path(workspace, file) for file in missing):
            missing = [file for file in missing if told[file]]
        if missing:
            places = tuple(place for file in missing for place in told[file])
            yield LaunchFilesLeftOut(installs.package, place, tuple(paths_below(installs, missing)), places)


def _is_off_a_list(installs: Installs, own: Sequence[str], missing: Sequence[str]) -> bool:
    """Whether the build names the launch files that it installs one by one, and more of them than it leaves out: who
    adds a launch file forgets the list.  One that alone is installed may be all that is meant to be started."""
    listed = {row.source for row in installs.files if not _is_pattern(row)}
    return len(missing) < len(own) - len(missing) > 1 and listed.issuperset({*own} - {*missing})


def is_left_out_launch_file(workspace: WorkspaceIndex, file: str) -> bool:
    """Whether the package of a launch file does not install it, and no document, script or launch file names it.  One
    in the folder ``launch`` of a package that installs none is forgotten, and not left out."""
    installs = understood(workspace).get(workspace.package_of(file) or "")
    if (
        installs is None
        or _is_forgotten(workspace, installs, file)
        or any(installs.places_of(file))
        or any(map(installs.may_install, paths_below(installs, [file])))
    ):
        return False
    name = posixpath.basename(file)
    commanded = any(name in (posixpath.basename(first), second) for first, second, _ in _commands(workspace))
    naming = (other for other in _all_launch_files(workspace) if name in (workspace.tree.text(other) or ""))
    return not commanded and all(other == file or _is_elsewhere(workspace, other, name) for other in naming)


def _is_elsewhere(workspace: WorkspaceIndex, file: str, name: str) -> bool:
    """Whether a launch file means by the name of another one that of a package which is not here."""
    named = [row for launched in workspace.launched for row in launched.references if row.place.file == file]
    rows = [row for row in named if posixpath.basename(row.written or "") == name]
    return bool(rows) and all(row.status == FileStatus.EXTERNAL for row in rows)


def _is_forgotten(workspace: WorkspaceIndex, installs: Installs, file: str) -> bool:
    folder = posixpath.normpath(posixpath.join(installs.folder, "launch"))
    installed = (any(installs.places_of(other)) for other in workspace.tree.files_below(folder))
    return file.startswith(f"{folder}/") and not any(installed)


def paths_below(installs: Installs, files: Iterable[str]) -> Iterator[str]:
    """Paths as they are from the folder of a package on."""
    return (file if installs.folder == "." else file.removeprefix(f"{installs.folder}/") for file in files)


@once
def understood(workspace: WorkspaceIndex) -> Mapping[str, Installs]:
    """What packages of ROS 2 install, where all of it is known and there is one package of the name."""
    return {name: workspace.installs[name] for name in sorted(workspace.installs) if _is_understood(workspace, name)}


def _is_understood(workspace: WorkspaceIndex, name: str) -> bool:
    return not workspace.installs[name].open_files and _is_built(workspace, name)


def _is_built(workspace: WorkspaceIndex, name: str) -> bool:
    """Whether a package is one of ROS 2, in use, of which build files were read."""
    installs, package = workspace.installs[name], workspace.manifests.get(workspace.installs[name].folder)
    if package is None or package.ros1 or not installs.build_files:
        return False
    return not is_aside(workspace, package.manifest.relative)


def mended_at(workspace: WorkspaceIndex, installs: Installs) -> Place | None:
    """Where a package says which files it installs."""
    if installs.data_files_at is not None:
        return installs.data_files_at
    path = posixpath.normpath(posixpath.join(installs.folder, "CMakeLists.txt"))
    lines = (workspace.tree.text(path) or "").splitlines()
    for number, line in enumerate(lines, 1):
        called = re.match(r"\s*ament_(?:auto_)?package\s*\(", line)
        if called is not None:
            return Place(path, number, 1, number, len(line) + 1)
    return None


def own_launch_files(workspace: WorkspaceIndex, installs: Installs) -> list[str]:
    """The launch files in the folder ``launch`` of a package, that is in use, and that launch loads."""
    folder = posixpath.normpath(posixpath.join(installs.folder, "launch"))
    files = (file for file in _all_launch_files(workspace) if file.startswith(f"{folder}/"))
    in_use = (file for file in files if not is_aside(workspace, file) and not _is_of_ros1(workspace, file))
    return [file for file in in_use if file not in _rejected(workspace)]


@once
def _rejected(workspace: WorkspaceIndex) -> frozenset[str]:
    """The launch files that give an action what it does not take (LCH005): installed they would start nothing."""
    return frozenset(wrong.place.file for launched in workspace.launched for wrong in launched.unknown_attributes)


@once
def _all_launch_files(workspace: WorkspaceIndex) -> list[str]:
    return workspace.launch_files.all()


def _is_of_ros1(workspace: WorkspaceIndex, file: str) -> bool:
    return workspace.launch_files.is_frontend(file) and workspace.launch_files.frontend(file).ros1


@once
def files_told_already(workspace: WorkspaceIndex) -> frozenset[str]:
    """The files that a launch file names in vain, each of which has a finding of its own there."""
    references = (file for launched in workspace.launched for file in launched.references)
    return frozenset(file.source or "" for file in references if file.status == FileStatus.NOT_INSTALLED)


# ---------------------------------------------------------------------------------------- what texts say of launches

_COMMAND = re.compile(r"\bros2[ \t]+launch[ \t]+([\w./~${}-]+)(?:[ \t]+([\w./-]+))?")


@once
def _commands(workspace: WorkspaceIndex) -> list[tuple[str, str, Place]]:
    """The two words after each ``ros2 launch`` in the documents and scripts of a workspace, and where that is."""
    rows = []
    for path in workspace.tree.files_below(workspace.tree.top):
        text = workspace.tree.text(path) if tells_commands(path) else None
        for number, line in enumerate(text.splitlines() if text is not None and "ros2" in text else (), 1):
            for call in _COMMAND.finditer(line):
                rows.append((call[1], call[2] or "", Place(path, number, call.start() + 1, number, call.end() + 1)))
    return rows


def is_meant_to_start(workspace: WorkspaceIndex, file: str) -> bool:
    """Whether anything asks for a launch file, be it installed or not: a command of CMake that is not known here,
    another launch file, or a text that says to start it, by its package or by its path."""
    installs = workspace.installs.get(workspace.package_of(file) or "")
    given = installs is not None and any(map(installs.may_install, paths_below(installs, [file])))
    return given or is_told_to_start(workspace, file)


def is_told_to_start(workspace: WorkspaceIndex, file: str) -> bool:
    """Whether another launch file or a text asks for a launch file, be it installed or not."""
    told = any(_told_at(workspace, workspace.package_of(file) or "", file)) or _is_started_by_path(workspace, file)
    return told or file in files_told_already(workspace)


def _told_at(workspace: WorkspaceIndex, package: str, file: str) -> Iterator[Place]:
    """The places that say to start a launch file by the name of its package."""
    name = posixpath.basename(file)
    return (place for first, second, place in _commands(workspace) if (first, second) == (package, name))


def _is_started_by_path(workspace: WorkspaceIndex, file: str) -> bool:
    """Whether some place says to start a launch file from where it lies in the source."""
    return any(posixpath.basename(first) == posixpath.basename(file) for first, _, _ in _commands(workspace))


# ----------------------------------------------------------------------------------------- what a setup.py lists


@dataclass(frozen=True)
class ListedInVain:
    """A file or folder that the build lists and that is not there, so that it stops."""

    place: Place
    file: str
    """Its path below the folder of the package."""
    marker: bool = False
    command: str = "data_files="
    """What lists it: ``data_files=`` of a setup.py, or a command of CMake."""
    folder: bool = False
    within: str = ""
    """The outermost folder of its path that is not there either, from the folder of the package on."""
    own_marker: str = ""
    """For a marker: the file beside it that is there and has the name of the package, as a marker must."""


def listed_in_vain(workspace: WorkspaceIndex) -> Iterator[ListedInVain]:
    """Each such file that nothing makes before the build."""
    for name in sorted(workspace.installs):
        if _is_built(workspace, name):
            yield from _needed_in_vain(workspace, workspace.installs[name])
    for installs in understood(workspace).values():
        at = installs.data_files_at
        if at is None or writes_files(workspace, at.file):
            continue
        for row in installs.files:
            if (
                not _is_pattern(row)
                and not workspace.tree.is_file(row.source)
                and not workspace.tree.is_only_in_git(row.source)
                and not is_ignored(workspace, row.source)
            ):
                [below] = paths_below(installs, [row.source])
                within = _absent_folder(workspace, installs, below)
                marker = posixpath.normpath(row.destination) == MARKERS
                own = posixpath.join(posixpath.dirname(row.source), installs.package)
                [named] = paths_below(installs, [own]) if marker and workspace.tree.is_file(own) else [""]
                yield ListedInVain(row.place or at, below, marker, within=within, own_marker=named)


@dataclass(frozen=True)
class MisnamedMarker:
    """The only marker that a package installs, under the name of another one; ``file`` is below its folder."""

    place: Place
    package: str
    file: str
    name: str
    used: bool
    """Whether others start it under that name."""
    scripts_too: bool
    """Whether its setup.cfg puts the programs into the folder of that name."""


def misnamed_markers(workspace: WorkspaceIndex) -> Iterator[MisnamedMarker]:
    """Every such marker: who makes a package of another one forgets to rename it."""
    for installs in understood(workspace).values():
        at = installs.data_files_at
        rows = [row for row in installs.files if posixpath.normpath(row.destination) == MARKERS]
        if at is None or not rows or any(_is_pattern(row) or row.folder for row in rows):
            continue
        names = [row.rename or posixpath.basename(row.source) for row in rows]
        if installs.package not in names and workspace.tree.is_file(rows[0].source):
            [below] = paths_below(installs, [rows[0].source])
            used = names[0] == installs.package.lower() or names[0] in _named_packages(workspace)
            config = workspace.tree.text(posixpath.join(installs.folder, "setup.cfg")) or ""
            scripts = re.search(rf"/lib/{re.escape(names[0])}\s*$", config, re.MULTILINE) is not None
            yield MisnamedMarker(rows[0].place or at, installs.package, below, names[0], used, scripts)


@once
def _named_packages(workspace: WorkspaceIndex) -> frozenset[str]:
    """The packages whose programs and launch files somebody starts: a launch file, a document or a script."""
    started = {row.package.text for launched in workspace.launched for row in launched.started}
    return frozenset(filter(None, (*started, *(first for first, second, _ in _commands(workspace) if second))))


@dataclass(frozen=True)
class FolderListed:
    """A folder that a pattern in the ``data_files=`` of a setup.py matches: setuptools stops, as it copies files."""

    place: Place
    folder: str
    """Its path below the folder of the package."""
    pattern: str


_ASKS_FOR_FILES = ("isfile", "is_file", "isdir", "is_dir", "walk")
"""With these a setup.py may take the folders out of what a pattern matches."""


def folders_listed(workspace: WorkspaceIndex) -> Iterator[FolderListed]:
    """The first folder that each such pattern matches."""
    for installs in understood(workspace).values():
        at = installs.data_files_at
        if at is None:
            continue  # CMake builds the package, and nothing runs a setup.py beside it
        asks = any(workspace.code.mentions(at.file, word) for word in _ASKS_FOR_FILES)
        for row in installs.files if not asks else ():
            place, (where, name) = row.place or at, posixpath.split(posixpath.normpath(row.source))
            if row.folder or any(sign in where for sign in "*?[") or name == "**":
                continue
            below = (path.removeprefix(f"{where}/") for path in workspace.tree.files_below(where or "."))
            folders = dict.fromkeys(path.partition("/")[0] for path in below if "/" in path)
            matching = [folder for folder in folders if _is_pattern(row) and fnmatch.fnmatchcase(folder, name)]
            if matching:
                [folder, pattern] = paths_below(installs, [posixpath.join(where, matching[0]), row.source])
                yield FolderListed(place, folder, posixpath.normpath(pattern))


_BUILT = (".so", ".a", ".onnx", ".pt", ".pth", ".engine")
"""Libraries and models of a vendor or of a training, which are often fetched by hand."""


def _needed_in_vain(workspace: WorkspaceIndex, installs: Installs) -> Iterator[ListedInVain]:
    """What CMake files list and is not there; git keeps no empty folder, so that a new clone does not have one.  A
    folder of which git may ignore all files counts where the same file lists something else that is not there: the
    build stops at the first of them."""
    rows = [(needed, below) for needed in installs.needed if (below := _missing(workspace, installs, needed))]
    sure = {(needed.place.file, needed.command) for needed, _ in rows if not is_ignored(workspace, needed.path)}
    for needed, below in rows:
        if (needed.place.file, needed.command) in sure:
            within = _absent_folder(workspace, installs, f"{below}/" if needed.folder else below)
            yield ListedInVain(needed.place, below, command=f"{needed.command}()", folder=needed.folder, within=within)


def _missing(workspace: WorkspaceIndex, installs: Installs, needed: NeededSource) -> str | None:
    """The path below the package of what a command needs, if it is not there."""
    if installs.open_files and not needed.part:
        return None
    is_there = workspace.tree.is_folder if needed.folder else workspace.tree.is_file
    inside = installs.folder == "." or needed.path.startswith(f"{installs.folder}/")
    if not inside or needed.path.endswith(_BUILT) or is_there(needed.path):
        return None
    if workspace.tree.is_only_in_git(needed.path):
        return None
    if is_ignored(workspace, needed.path, by_name=True) or submodule_around(workspace, needed.path) is not None:
        return None
    [below] = paths_below(installs, [needed.path])
    return below


def _absent_folder(workspace: WorkspaceIndex, installs: Installs, below: str) -> str:
    """The outermost folder of a path below a package that is not there; empty where all are."""
    folders = [below[:at] for at, letter in enumerate(below) if letter == "/"]
    paths = ((folder, posixpath.normpath(posixpath.join(installs.folder, folder))) for folder in folders)
    return next((folder for folder, path in paths if not workspace.tree.is_folder(path)), "")


def _is_pattern(row: InstalledFiles) -> bool:
    return row.folder or any(sign in row.source for sign in "*?[")


__all__ = [
    "FolderListed",
    "LaunchFilesLeftOut",
    "ListedInVain",
    "MisnamedMarker",
    "files_told_already",
    "folders_listed",
    "is_left_out_launch_file",
    "launch_files_left_out",
    "listed_in_vain",
    "mended_at",
    "misnamed_markers",
    "understood",
]

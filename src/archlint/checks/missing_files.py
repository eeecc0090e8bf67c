"""LCH004: files that a launch file names and that are not where it looks."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, NamedTuple

from archlint.checks.folding import folds, with_places
from archlint.checks.joined_folders import WHAT, decided_at, is_joined_wrongly, joined_folders
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.finding import Finding, Related
from archlint.launch.kinds import FileKind, FileStatus
from archlint.launch_files.launch_code import writes_files
from archlint.launch_files.missing_files import (
    below_package,
    installed_paths,
    is_folder_missing,
    is_installed_nowhere,
    is_module_for_nothing,
    lacks_a_part,
    lies_in,
    may_do_without,
    mixtures,
    names_beside,
    namesake,
    other_package_with,
    path_of_these_parts,
)
from archlint.packaging.absent_packages import (
    folder_of_description,
    is_nowhere,
    is_placeholder,
    is_told_at_a_start,
    package_meant,
    package_with,
)
from archlint.packaging.generated_files import (
    has_template,
    is_called_generated,
    is_generated,
    is_ignored,
    is_ignored_by_name,
    is_kept_for_ignored,
)
from archlint.packaging.misplaced_folders import is_told_with_its_folder
from archlint.suggestions import common_words, distance, have_same_words, listed, meant, nearest

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.launch.named_files import FileReference
    from archlint.systems.model import System, WorkspaceIndex

_OF_NO_KIND = (FileKind.OTHER, FileKind.ARGUMENT)
_READ = (".lua", ".sdf", ".srdf", ".urdf", ".world", ".xacro")
"""What nodes are given to read: another file that is not there may be one that they write."""

_OF_SETTINGS = re.compile(r"(?:^|_)(?:config|configuration|param(?:eter)?s?|rviz|rvizconfig)(?:_|$)")
_SETTINGS = (".rviz", ".yaml", ".yml")
"""What an argument called ``params_file`` or ``rviz_config`` is set to: nothing writes these at run time."""

_TRAINED = (".engine", ".h5", ".onnx", ".pb", ".pt", ".pth", ".safetensors", ".tflite", ".trt", ".weights")
"""Models that are trained or downloaded, and seldom kept with the sources: that one is not there says nothing."""


@rule("LCH004", scope=Scope.LAUNCH_FILE, in_use=True)
def missing_launch_file(system: System, options: Options) -> Iterator[Finding]:
    """Included files, parameter files and RViz configurations that are not where the launch file looks."""
    yield from _relative_paths(system)
    yield from _absent_packages(system)
    yield from joined_folders(system)
    uses: dict[tuple[Place, str | None], list[FileReference]] = {}
    references = system.launched.references if system.launched is not None else ()
    mixed = mixtures(references)
    for reference in references:
        if reference.status not in (FileStatus.MISSING, FileStatus.NOT_INSTALLED) or reference.optional:
            continue
        if reference not in mixed and not lacks_a_part(reference) and not is_joined_wrongly(system, reference):
            uses.setdefault((decided_at(reference), reference.written), []).append(reference)
    for (place, written), references in uses.items():
        [reference, *others] = sorted(references, key=_by_kind)
        other = reference.kind in _OF_NO_KIND and reference.status == FileStatus.MISSING
        if other and not any(_is_read(system, use, written or "") for use in (reference, *others)):
            continue
        files = {place.file, reference.place.file, *(other.place.file for other in others)}
        if reference.status == FileStatus.MISSING and any(writes_files(system.workspace, file) for file in files):
            continue
        shown = below_package(written or "")
        if reference.status == FileStatus.MISSING and _need_not_be_here(system, reference, shown):
            continue
        if reference.status == FileStatus.MISSING:
            told = _missing(system, reference, shown)
            if told is None:
                continue
        elif is_module_for_nothing(system, (reference, *others)):
            continue
        else:
            told = _not_installed(system, reference, shown)
        uses_of_it = [use for use in (reference, *others) if use.kind != FileKind.ARGUMENT]
        read = dict.fromkeys(use.place for use in uses_of_it if use.place != place)
        spare = reference.status == FileStatus.MISSING and all(use.dormant for use in (reference, *others))
        yield finding(
            "LCH004",
            place,
            told.message + _SPARE * spare,
            help=told.help,
            related=[Related(used_at, "it is used here") for used_at in read],
            identity=(reference.package or "", written or ""),
            group=(told.status, reference.package or "", told.cause, *(("spare",) if spare else ())),
        )


_SPARE = "; with the default arguments nothing needs it"


class _Told(NamedTuple):
    """What is said of a file; ``cause`` is what those have in common that one change mends."""

    message: str
    help: str
    status: FileStatus
    cause: str


def _missing(system: System, reference: FileReference, shown: str) -> _Told | None:
    """What is said of a file that is not there; None where that is said of the build."""
    workspace, package, what = system.workspace, reference.package or "", WHAT[reference.kind]
    path = _in_package(system, reference, shown)
    near = _file_meant(workspace, package, shown)
    misplaced = near.endswith(f"/{path}") and workspace is not None and is_installed_nowhere(workspace, package, near)
    if workspace is not None and is_told_with_its_folder(workspace, package, path):
        return None
    if misplaced:  # the path is right, once the folder is installed
        message = f"package '{package}' does not install the {what} '{near}', which is looked for as '{path}'"
        cause = f"{posixpath.dirname(near)} as {posixpath.dirname(path)}"
        return _Told(message, _installed_as(path, near), FileStatus.NOT_INSTALLED, cause)
    message = f"package '{package}' has no {what} '{path}'" + (meant(f"'{near}'") if near else "")
    beside = (reference.written or "").startswith("$(workspace)")
    start = "installed folder of this launch file" if beside else "package's installed share folder"
    help = f"check the path; it is relative to the {start}"
    other = None if near or workspace is None else other_package_with(workspace, package, path)
    help += f"; '{other}' has a file of that path" if other else ""
    there = [] if near or other else _of_one_kind(workspace, package, shown)
    help += f", and its folder has {listed(there)}" if there else ""
    help += _not_installed_either(workspace, package, shown, near) if near else ""
    if not near and workspace is not None and is_ignored(workspace, _in_workspace(workspace, package, path)):
        help = _IGNORED
    return _Told(message, help, FileStatus.MISSING, _cause(system, reference, shown))


_IGNORED = "a .gitignore keeps it out of the repository: commit it with git add -f, or take out the pattern"


def _in_workspace(workspace: WorkspaceIndex, package: str, path: str) -> str:
    """The shown path of a file, by its path below its package."""
    installs = workspace.installs.get(package)
    return posixpath.normpath(posixpath.join("" if installs is None else installs.folder, path))


def _installed_as(path: str, source: str) -> str:
    """How to install a file, by its path in the package, so that it has another one in the share folder."""
    below, folder = posixpath.dirname(path), posixpath.dirname(source)
    if not below:
        return f"install {source} into the share folder itself (data_files in setup.py, install(FILES …) in CMake)"
    return f"install {folder} as {below} (data_files in setup.py, install(DIRECTORY {folder} …) in CMake)"


def _not_installed(system: System, reference: FileReference, shown: str) -> _Told:
    aside = _package_beside(system, reference.written or "")
    help = (
        f"start at the share folder of '{aside}', which lies beside this one in a merged install alone"
        if aside
        else _installed_so(system, reference, shown)
    )
    message = f"package '{reference.package}' does not install the {WHAT[reference.kind]} '{shown}'"
    return _Told(message, help, FileStatus.NOT_INSTALLED, _cause(system, reference, shown))


def _need_not_be_here(system: System, reference: FileReference, shown: str) -> bool:
    """Whether a file that is not there is made by the build, or may be where the project is used."""
    package = reference.package or ""
    trained = shown.endswith(_TRAINED) and not _file_meant(system.workspace, package, shown)
    if trained or _is_kept_out(system, reference, shown) or is_generated(system.workspace, package, shown):
        return True
    files = {reference.place.file, decided_at(reference).file}
    return system.workspace is not None and any(is_called_generated(system.workspace, file, shown) for file in files)


def _is_kept_out(system: System, reference: FileReference, shown: str) -> bool:
    """Whether git ignores a file that the launch file reads, or one of any kind by its name or in a folder that is
    there for such files: everyone who launches has one of his own."""
    installs = None if system.workspace is None else system.workspace.installs.get(reference.package or "")
    if system.workspace is None or installs is None:
        return False
    path = _in_workspace(system.workspace, installs.package, _in_package(system, reference, shown))
    ignores = is_ignored if reference.kind == FileKind.READ else is_ignored_by_name
    return ignores(system.workspace, path) or is_kept_for_ignored(system.workspace, path)


def _package_beside(system: System, written: str) -> str:
    """The package of the workspace to which a path leads out of the share folder of another one; empty for none."""
    leads_out, name, *_ = (*posixpath.normpath(below_package(written)).split("/"), "")
    known = system.workspace is not None and name in system.workspace.packages
    return name if leads_out == ".." and known and written.startswith("$(find-pkg-share ") else ""


def _relative_paths(system: System) -> Iterator[Finding]:
    """Files that launch looks for in the folder where it runs, and that lie in a package instead."""
    references = system.launched.references if system.launched is not None and system.workspace is not None else ()
    for reference in references:
        beside = None if system.workspace is None else lies_in(system.workspace, reference)
        if beside is None:
            continue
        written, frontend = reference.written or "", not reference.place.file.endswith(".py")
        start = "$(find-pkg-share {0})/{1}" if frontend else "os.path.join(get_package_share_directory('{0}'), '{1}')"
        yield finding(
            "LCH004",
            decided_at(reference),
            f"the {WHAT[reference.kind]} '{written}' has a relative path: it is looked for in the folder in which "
            "ros2 launch is started",
            help=f"write {start.format(*beside)}",
            identity=(beside[0], written),
            group=("relative", beside[0], written),
        )


def _absent_packages(system: System) -> Iterator[Finding]:
    """Share folders of packages that are nowhere, if another one was meant."""
    seen = set()
    for reference in system.launched.references if system.launched is not None else ():
        package, workspace = reference.package, system.workspace
        place = decided_at(reference)
        if workspace is None or package is None or reference.status != FileStatus.EXTERNAL or reference.conditional:
            continue
        if reference.optional or (place, package) in seen or not is_nowhere(workspace, package):
            continue
        seen.add((place, package))
        if system.launched is not None and is_told_at_a_start(workspace, system.launched, package):
            continue  # LCH001 says which package was meant, and shows this place
        named = below_package(reference.written or "")
        near = package_meant(workspace, package, named, reference.place.file) or package_with(
            workspace, package, named, reference.place.file
        )
        if near is None and reference.kind == FileKind.OTHER:
            near = folder_of_description(workspace, package, named, reference.place.file)
        if near is None and not is_placeholder(package):
            continue
        yield finding(
            "LCH004",
            place,
            f"there is no package '{package}', in which this looks for the {WHAT[reference.kind]} '{named}'"
            + (meant(f"'{near}'") if near is not None else ""),
            help=f"write '{near}'" if near is not None else "put in the name of the package that has the file",
            identity=(package, reference.written or ""),
            group=("absent", package, ""),
            meant=near or "",
        )


def _by_kind(reference: FileReference) -> int:
    """What says most of a file comes first."""
    return _OF_NO_KIND.index(reference.kind) + 1 if reference.kind in _OF_NO_KIND else 0


def _is_read(system: System, reference: FileReference, written: str) -> bool:
    """Whether a missing file of no known kind is one that has to be there: nothing makes it on each machine."""
    path = _in_package(system, reference, below_package(written))
    installs = None if system.workspace is None else system.workspace.installs.get(reference.package or "")
    if system.workspace is None or installs is None:
        return False
    if not path.endswith(_READ) and may_do_without(system, reference.name):
        return False
    is_meant = path.endswith(_READ) or _file_meant(system.workspace, installs.package, path) != ""
    if reference.kind == FileKind.ARGUMENT:
        is_meant = is_meant or _has_settings(reference, path)
        is_meant = is_meant or is_folder_missing(system.workspace, installs.package, path)
        is_meant = is_meant and not has_template(system.workspace, installs.package, path)
    return is_meant and not is_ignored(system.workspace, _in_workspace(system.workspace, installs.package, path))


def _has_settings(reference: FileReference, path: str) -> bool:
    """Whether an argument is for a file of parameters or of RViz, as its name says."""
    return path.endswith(_SETTINGS) and _OF_SETTINGS.search(reference.name or "") is not None


def _installed_so(system: System, reference: FileReference, shown: str) -> str:
    """How to install a file, which the build may put into another folder already."""
    installs = None if system.workspace is None else system.workspace.installs.get(reference.package or "")
    elsewhere = next(installs.places_of(reference.source), "") if installs is not None and reference.source else ""
    if elsewhere and "$" not in elsewhere:
        return f"the build puts it into '{elsewhere}'; it is looked for in 'share/{reference.package}/{shown}'"
    return f"install {reference.source} (data_files in setup.py, install(DIRECTORY …) in CMake)"


def _cause(system: System, reference: FileReference, shown: str) -> str:
    """What one change mends: the folder of a file, where none of its files is installed or where it is not there at
    all; or else the file."""
    path = _in_package(system, reference, shown)
    if reference.status == FileStatus.NOT_INSTALLED:
        return posixpath.dirname(path)
    missing = system.workspace is not None and is_folder_missing(system.workspace, reference.package or "", shown)
    return posixpath.dirname(path) if missing else path


@folds("LCH004", across_systems=True, common=3)
def _of_one_cause(several: Sequence[Finding]) -> Finding:
    """One finding for a file that is not there, however many launch files name it, and for all files of a folder that
    is not there or not installed."""
    spare = [len(each.group) > 3 for each in several]
    if not all(spare):  # something needs it, then
        rows = zip(several, spare, strict=True)
        several = [replace(each, message=each.message[: -len(_SPARE)]) if cut else each for each, cut in rows]
    first, *others = several
    names = list(dict.fromkeys(below_package(diagnostic.identity[1]) for diagnostic in several))
    if len(names) == 1:  # as of those with one relative path
        return with_places(several, "it is named here, too")
    status, package, folder, *_ = first.group
    if status == "absent":
        return with_places(several, "it is named here, too")
    places = [Related(other.place, f"'{below_package(other.identity[1])}' is named here") for other in others]
    if status == FileStatus.MISSING:
        message = f"package '{package}' has no folder '{folder}' with these {len(names)} files: {listed(names)}"
        help = "check the path of the folder; it is relative to the package's installed share folder"
        if all(diagnostic.help == _IGNORED for diagnostic in several):
            help = _IGNORED.replace("keeps it", "keeps them").replace("commit it", "commit them")
    else:
        message = f"package '{package}' does not install these {len(names)} files: {listed(names)}"
        help = "install the folder that they are in (data_files in setup.py, install(DIRECTORY …) in CMake)"
    identity = (package, *dict.fromkeys(diagnostic.identity[1] for diagnostic in several))
    return replace(first, message=message, help=help, related=(*first.related, *places), identity=identity)


def _in_package(system: System, reference: FileReference, shown: str) -> str:
    """The path of a file below its package: ``ThisLaunchFileDir()`` gives it below the workspace."""
    installs = None if system.workspace is None else system.workspace.installs.get(reference.package or "")
    return shown if installs is None else shown.removeprefix(f"{installs.folder}/")


def _file_meant(workspace: WorkspaceIndex | None, package: str, shown: str) -> str:
    """The file beside a missing one whose name is nearest to its name, or the path of the one file that has its very
    name in another folder: that to which it is installed."""
    name = posixpath.basename(posixpath.normpath(shown))
    beside = [] if workspace is None else names_beside(workspace, package, shown)
    beside = [other for other in beside if name.endswith(_SEMANTIC) or not other.endswith(_SEMANTIC)]
    same = [other for other in beside if have_same_words(name, other)]
    if len(same) == 1:
        return same[0]
    if workspace is not None and (parted := path_of_these_parts(workspace, package, shown)) is not None:
        return parted
    near = nearest(name, [other for other in beside if _is_like(name, other)])
    other = None if near or workspace is None else namesake(workspace, package, shown)
    if workspace is None or other is None:
        return near or ""
    return next(iter(installed_paths(workspace, package, other) or ()), other)


_SEMANTIC = (".srdf", ".srdf.xacro")
"""What MoveIt needs beside the description of a robot, and nothing that can stand for it."""


def _not_installed_either(workspace: WorkspaceIndex | None, package: str, shown: str, near: str) -> str:
    """What is left to do where nothing installs the file that was meant."""
    path = near if "/" in near else posixpath.normpath(posixpath.join(posixpath.dirname(shown), near))
    left_out = workspace is not None and is_installed_nowhere(workspace, package, path)
    return f"; '{path}' is not installed either" if left_out else ""


_FEW = 3


def _of_one_kind(workspace: WorkspaceIndex | None, package: str, shown: str) -> list[str]:
    """The files in the folder of a missing one that have its ending, where they are few enough to choose from."""
    ending = posixpath.splitext(shown)[1]
    beside = [] if workspace is None or not ending else names_beside(workspace, package, shown)
    same = [f"'{name}'" for name in sorted(beside) if name.endswith(ending)]
    return same if len(same) <= _FEW else []


def _is_like(name: str, other: str) -> bool:
    """Whether the names of two files are near, beyond the words that they begin with and the ending: these are alike
    in all files of a folder, without saying much."""
    rest = name.partition(".")[0].removeprefix(common_words(name, other))
    limit = max(1, len(rest) // 3)
    return distance(name, other, limit) <= limit

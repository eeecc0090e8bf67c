"""Files that a launch file names and that are not there."""

from __future__ import annotations

import posixpath
import re
from typing import TYPE_CHECKING

from archlint.analysis.declared_parameters import declared_by
from archlint.launch.kinds import FileKind, FileStatus

if TYPE_CHECKING:
    from collections.abc import Sequence

    from archlint.finding import Place
    from archlint.launch.named_files import FileReference
    from archlint.systems.model import System, WorkspaceIndex


def is_folder_missing(workspace: WorkspaceIndex, package: str, path: str) -> bool:
    """Whether the source of a package has nothing at all in the folder of a path, from its share folder on."""
    folder = _folder(workspace, package, path)
    return folder is not None and not any(workspace.tree.files_below(folder))


def names_beside(workspace: WorkspaceIndex, package: str, path: str) -> list[str]:
    """The names of the files in the folder in which a path of a package, from its share folder on, would be; but for
    those that name the missing file themselves: they need it, too, and would include themselves."""
    folder, name = _folder(workspace, package, path), posixpath.basename(posixpath.normpath(path))
    if folder is None:
        return []
    named = re.compile(rf"(?<![\w.-]){re.escape(name)}(?![\w.-])")
    files = (file for file in workspace.tree.files_below(folder) if posixpath.dirname(file) == folder)
    return [posixpath.basename(file) for file in files if not named.search(workspace.tree.text(file) or "")]


def namesake(workspace: WorkspaceIndex, package: str, path: str) -> str | None:
    """The only file of a package, below its folder, that has the name of a missing one, in another folder.  None in
    folders that go together, as ``visual`` and ``collision`` of meshes do: it is the other one of a pair."""
    installs = workspace.installs.get(package)
    if installs is None:
        return None
    name, top = posixpath.basename(posixpath.normpath(path)), installs.folder
    files = [
        file.removeprefix(f"{top}/")
        for file in workspace.tree.files_below(top)
        if posixpath.basename(file) == name and not workspace.roles.is_trial(file)
    ]
    return files[0] if len(files) == 1 and not _go_together(workspace, installs.folder, path, files[0]) else None


def _go_together(workspace: WorkspaceIndex, top: str, path: str, other: str) -> bool:
    """Whether the folders of two paths below a package have another file of one name and of their ending."""
    ending = posixpath.splitext(path)[1]
    folders = [posixpath.normpath(posixpath.join(top, posixpath.dirname(each))) for each in (path, other)]
    names = [
        {posixpath.basename(file) for file in workspace.tree.files_below(folder) if posixpath.dirname(file) == folder}
        for folder in folders
    ]
    return any(name.endswith(ending) for name in names[0] & names[1] - {posixpath.basename(path)})


def path_of_these_parts(workspace: WorkspaceIndex, package: str, path: str) -> str | None:
    """The only file of a package whose path differs from a missing one by slashes alone: ``launch/it.launch.py`` for
    ``launchit.launch.py``."""
    installs = workspace.installs.get(package)
    if installs is None:
        return None
    top, whole = installs.folder, path.replace("/", "")
    below = (file.removeprefix(f"{top}/") for file in workspace.tree.files_below(top))
    files = [file for file in below if file != path and file.replace("/", "") == whole]
    return files[0] if len(files) == 1 else None


def other_package_with(workspace: WorkspaceIndex, package: str, path: str) -> str | None:
    """The only other package of the workspace that has a file of a path, which says more than the name of the file."""
    path = posixpath.normpath(path)
    if posixpath.dirname(path) in ("", ".") or path.startswith(".."):
        return None
    having = [
        name
        for name, other in workspace.packages.items()
        if name != package and workspace.tree.is_file(posixpath.normpath(posixpath.join(other.relative, path)))
    ]
    return having[0] if len(having) == 1 else None


def installed_paths(workspace: WorkspaceIndex, package: str, path: str) -> list[str] | None:
    """Where a file of a package, by its path below the folder, is in the share folder; None where that is not known."""
    installs, share = workspace.installs.get(package), f"share/{package}/"
    if installs is None:
        return None
    source = posixpath.join(installs.folder, path)
    places = [place.removeprefix(share) for place in installs.places_of(source) if place.startswith(share)]
    return places if places or not installs.open_files else None


def is_installed_nowhere(workspace: WorkspaceIndex, package: str, path: str) -> bool:
    """Whether a package has a file, by its path below the folder, and certainly does not install it."""
    installs = workspace.installs.get(package)
    is_here = installs is not None and workspace.tree.is_file(posixpath.join(installs.folder, path))
    return is_here and installed_paths(workspace, package, path) == []


_ASKS = ("exists", "is_file", "is_open", "isfile")
"""What code calls to see whether a file is there, in Python or in C++."""


def may_do_without(system: System, parameter: str | None) -> bool:
    """Whether code that declares a parameter asks of some file whether it is there, as code does that goes on without
    one: state that is saved at the end of a run, for example."""
    workspace = system.workspace
    if workspace is None or parameter is None:
        return False
    rows = (row for node in system.nodes for row in node.parameters if row.name.text == parameter)
    files = dict.fromkeys(row.place.file for row in rows)
    return any(workspace.code.mentions(file, word) for file in files for word in _ASKS)


def is_module_for_nothing(system: System, uses: Sequence[FileReference]) -> bool:
    """Whether the path of a Python module of a package is only given to a parameter that no node declares: nothing ever
    looks there, and PRM004 says so."""
    return all(use.kind == FileKind.OTHER and _is_module(system, use) and _is_for_nobody(system, use) for use in uses)


def _is_module(system: System, use: FileReference) -> bool:
    installs = None if system.workspace is None else system.workspace.installs.get(use.package or "")
    python = None if installs is None else installs.python
    return python is not None and use.source is not None and python.has(use.source)


def _is_for_nobody(system: System, use: FileReference) -> bool:
    """Whether a file is the value of a parameter that none of the nodes declares which get it."""
    set_on = ((node, {*node.overrides, *(row.name for row in node.settings)}) for node in system.nodes)
    given = [node for node, names in set_on if use.name in names]
    declared = [None if node.external else declared_by(node) for node in given]
    return bool(given) and all(names is not None and use.name not in names for names in declared)


def lies_in(workspace: WorkspaceIndex, reference: FileReference) -> tuple[str, str] | None:
    """The package, and the path below its share folder, of a file that a launch file names by a relative path: it lies
    beside that launch file, or there from the folder of its package on, and not where all packages are seen from; a
    parameter file of such a name may lie anywhere in the package.  Who starts a launch file that no rule installs
    stands in its folder, and finds what is beside it."""
    written, file = reference.written or "", reference.place.file
    package = workspace.package_of(file)
    installs = workspace.installs.get(package or "")
    is_path = reference.status == FileStatus.EXTERNAL and reference.package is None and _RELATIVE.fullmatch(written)
    if package is None or installs is None or reference.conditional or not is_path:
        return None
    for folder in (installs.folder, posixpath.dirname(file)):
        path = posixpath.normpath(posixpath.join(folder, written))
        start = "" if installs.folder == "." else f"{installs.folder}/"
        if path.startswith(start) and workspace.tree.is_file(path) and not workspace.tree.is_file(written):
            if folder != installs.folder and not installs.open_files and not any(installs.places_of(file)):
                return None
            return package, path.removeprefix(start)
    same = [path for path in workspace.tree.files_below(installs.folder) if path.endswith(f"/{written}")]
    if reference.kind is FileKind.PARAMETERS and len(same) == 1 and not workspace.tree.is_file(written):
        return package, posixpath.relpath(same[0], installs.folder)
    return None


_RELATIVE = re.compile(r"(?![~$/])(?!\w+:)[\w./ -]+\.\w+")


def _folder(workspace: WorkspaceIndex, package: str, path: str) -> str | None:
    installs = workspace.installs.get(package)
    if installs is None:
        return None
    inside = path if path.startswith(f"{installs.folder}/") else posixpath.join(installs.folder, path)
    return posixpath.dirname(posixpath.normpath(inside))


# ------------------------------------------------------------------------------------------------- paths


def below_package(written: str) -> str:
    return re.sub(r"^\$\((?:find-pkg-share [\w.-]+|workspace)\)/?", "", written)


def mixtures(references: Sequence[FileReference]) -> set[FileReference]:
    """Files of one package under the path that is meant for another one.  Branches that choose a package choose the
    path in it, too; put together later, each package stands before each path, its own among them."""
    by_use: dict[Place, set[FileReference]] = {}
    for reference in references:
        by_use.setdefault(reference.place, set()).add(reference)
    mixed: set[FileReference] = set()
    for uses in by_use.values():
        packages: dict[str, set[str | None]] = {}
        for reference in uses:
            packages.setdefault(_path(reference), set()).add(reference.package)
        complete = {reference.package for reference in uses if reference.status == FileStatus.INSTALLED}
        mixed |= {use for use in uses if use.package in complete and len(packages[_path(use)]) > 1}
    return mixed


def lacks_a_part(reference: FileReference) -> bool:
    """Whether a folder in the middle of a path is empty, as ``robots//config`` where an argument has the default '':
    whoever launches the file is to say which."""
    return "//" in below_package(reference.written or "")


def _path(reference: FileReference) -> str:
    return below_package(reference.written or "")

"""Files and folders that code, or a description of a robot, looks for in the share folder of a package, and that the
build of it leaves out."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.analysis.aside import is_aside
from archlint.packaging.described_data import paths_in_descriptions
from archlint.packaging.share_paths import SHARE, Named, paths_in_code, paths_in_share
from archlint.packaging.uninstalled_files import files_told_already, mended_at, understood
from archlint.place import Place
from archlint.python_code.class_chains import files_with
from archlint.records import dataclass

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex
    from archlint.workspace.installed import Installs


@dataclass(frozen=True)
class DataLeftOut:
    """A file or folder, by its path below the folder of a package, and where code names it.  ``place`` is where the
    build should install it."""

    package: str
    file: str
    named_at: Place
    place: Place
    folder: bool = False
    instead: str = ""
    """Where a file is installed below the prefix, if not there."""


def data_left_out(workspace: WorkspaceIndex) -> Iterator[DataLeftOut]:
    """Each such file that is in the source, of a package whose build is understood, with each place that names it."""
    described = dict(paths_in_descriptions(workspace))
    for path, paths in (*_paths_in_code(workspace), *described.items()):
        for package, file, span in paths:
            installs = understood(workspace).get(package)
            place = None if installs is None else mended_at(workspace, installs)
            if installs is None or place is None or installs.may_install(file):
                continue
            if posixpath.normpath(file) == "package.xml" and place.file.endswith("CMakeLists.txt"):
                continue  # ament_package() installs it
            if _is_left_out(workspace, installs, file):
                folder = posixpath.dirname(file)
                if path in described and folder and _is_folder_left_out(workspace, installs, folder):
                    yield DataLeftOut(package, folder, Place(path, *span), place, folder=True)
                    continue
                elsewhere = installs.places_of(posixpath.join(installs.folder, file))
                yield DataLeftOut(package, file, Place(path, *span), place, instead=next(elsewhere, ""))
            elif _is_folder_left_out(workspace, installs, file):
                yield DataLeftOut(package, file, Place(path, *span), place, folder=True)


def _paths_in_code(workspace: WorkspaceIndex) -> Iterator[tuple[str, Sequence[Named]]]:
    for path in _asking(workspace):
        code = workspace.code.cpp_facts_at(path)
        yield path, (paths_in_share(workspace, path) if code is None else paths_in_code(code)) or ()


def _asking(workspace: WorkspaceIndex) -> Iterator[str]:
    """The files of Python and C++ in use that ask for a share folder, launch files among them."""
    launch_files = [
        path for path in workspace.launch_files.all() if path.endswith(".py") and workspace.code.mentions(path, SHARE)
    ]
    sources = [path for path in workspace.code.cpp_files_that_mention(SHARE) if not workspace.roles.is_test(path)]
    for path in dict.fromkeys((*files_with(workspace, SHARE), *launch_files, *sources)):
        if not is_aside(workspace, path):
            yield path


def _is_left_out(workspace: WorkspaceIndex, installs: Installs, file: str) -> bool:
    sources = installs.source_of(f"share/{installs.package}/{file}")
    path = posixpath.normpath(posixpath.join(installs.folder, file))
    there = workspace.tree.is_file(path) and path not in files_told_already(workspace)
    return there and not any(map(workspace.tree.is_file, sources))


def _is_folder_left_out(workspace: WorkspaceIndex, installs: Installs, folder: str) -> bool:
    """Whether nothing of a folder of the source is installed, and nothing that is comes to where it is looked for."""
    path = posixpath.normpath(posixpath.join(installs.folder, folder))
    files = [*workspace.tree.files_below(path)] if path != posixpath.normpath(installs.folder) else []
    if all(posixpath.basename(file) in _MEANS_NOTHING for file in files):
        return False
    told, target = files_told_already(workspace), f"share/{installs.package}/{posixpath.normpath(folder)}"
    rows = (posixpath.normpath(row.destination) for row in installs.files)
    if any(where == target or where.startswith(f"{target}/") for where in rows):
        return False
    if any(workspace.tree.is_folder(source) for source in installs.source_of(target)):
        return False
    return not any(file in told or any(installs.places_of(file)) for file in files)


_MEANS_NOTHING = frozenset({".gitkeep", ".gitignore", "README.md", "CMakeLists.txt", "package.xml"})
"""What keeps a folder in a repository, or is of another package."""


__all__ = ["DataLeftOut", "data_left_out"]

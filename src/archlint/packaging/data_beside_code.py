"""Files that an installed module opens by a path from its own file on, and that its setup.py does not install there.

Source: setuptools copies the modules of ``packages=`` alone, without ``package_data``; a build with --symlink-install
runs them from the source.
"""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.aside import is_aside
from archlint.analysis.pinned import names_no_distro, ubuntu_releases
from archlint.packaging.own_folder_paths import FILE, may_write, of_file, paths_beside
from archlint.packaging.uninstalled_files import understood
from archlint.place import Place
from archlint.records import dataclass
from archlint.ros.distros import PYTHON
from archlint.syntax import facts
from archlint.syntax.parts import everything_in

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex
    from archlint.workspace.installed import Installs

_CODE = (".py", ".pyc", ".so")


@dataclass(frozen=True)
class DataBeside:
    """A file or folder, by its path below the folder of a package, that a module looks for beside itself."""

    package: str
    module: str
    """The path of the module below that folder."""
    file: str
    place: Place
    folder: bool


def data_beside_code(workspace: WorkspaceIndex) -> Iterator[DataBeside]:
    """Each such file that is in the source, in the modules that programs of their package run."""
    for name, installs in understood(workspace).items():
        if installs.python is None:
            continue
        for file in sorted(_run_by_programs(workspace, installs)):
            code = workspace.facts_at(file) if workspace.code.mentions(file, FILE) else None
            if code is None or is_aside(workspace, file) or not installs.python.has(file):
                continue
            for path, span in paths_beside(code):
                wanted = of_file(path, file)
                is_folder = workspace.tree.is_folder(wanted)
                inside = wanted.startswith(f"{installs.folder}/") or installs.folder == "."
                if inside and (is_folder or workspace.tree.is_file(wanted)) and not _is_code(workspace, wanted):
                    below, module = (_below(installs, each) for each in (wanted, file))
                    if _is_brought_beside(workspace, installs, wanted, below) or _is_made(workspace, installs, wanted):
                        continue
                    yield DataBeside(name, module, below, Place(file, *span), is_folder)


def _is_made(workspace: WorkspaceIndex, installs: Installs, wanted: str) -> bool:
    """Whether a module of the package makes files, and names this one: a database, say, that another one reads."""
    name = posixpath.basename(wanted)
    for module in sorted(workspace.code.modules_of(installs.package).values()):
        code = workspace.facts_at(module)
        if code is not None and may_write(code) and _names(code, name):
            return True
    return False


def _names(code: facts.Facts, name: str) -> bool:
    """Whether a file has the text ``words.db``, or a path that ends in it."""
    texts = (literal.text for literal in everything_in(code.body, facts.Literal))
    return any(text is not None and posixpath.basename(text) == name for text in texts)


def _is_brought_beside(workspace: WorkspaceIndex, installs: Installs, wanted: str, below: str) -> bool:
    """Whether ``data_files=`` puts a file, or all files of a folder, beside the modules itself, for the Python that the
    distributions of the workspace have: ``('lib/python3.8/site-packages/robot', ['words.json'])``."""
    pythons = {PYTHON[release] for release in ubuntu_releases(workspace)}
    folders = [match for row in installs.files for match in [_BESIDE_MODULES.match(f"{row.destination}/")] if match]
    tops = {match[0] for match in folders if names_no_distro(workspace) or pythons == {match["python"]}}
    files = workspace.tree.files_below(wanted) if workspace.tree.is_folder(wanted) else [wanted]
    paths = [posixpath.normpath(f"{below}/{posixpath.relpath(file, wanted)}") for file in files]
    return any(
        all(any(map(workspace.tree.is_file, installs.source_of(f"{top}{path}"))) for path in paths) for top in tops
    )


_BESIDE_MODULES = re.compile(r"lib/python(?P<python>3\.\d+)/(?:site|dist)-packages/")


def _run_by_programs(workspace: WorkspaceIndex, installs: Installs) -> frozenset[str]:
    modules = workspace.code.modules_of(installs.package)
    starts = [modules[e.module] for e in installs.executables.values() if e.module in modules]
    own = {*modules.values()}
    return frozenset(own & ({*starts} | workspace.code.reached_from(starts)))


def _is_code(workspace: WorkspaceIndex, path: str) -> bool:
    """Whether there is nothing but code, which is installed, at a path."""
    files = workspace.tree.files_below(path) if workspace.tree.is_folder(path) else [path]
    return all(file.endswith(_CODE) for file in files)


def _below(installs: Installs, path: str) -> str:
    return path if installs.folder == "." else posixpath.relpath(path, installs.folder)


__all__ = ["DataBeside", "data_beside_code"]

"""Files that nothing of a workspace runs: not installed, started, imported, included or built, while their package
installs others.

Whether a file runs is asked of the build, of launch files, of imports and of the commands in documents and scripts.
Where any of these says more than can be read, a file counts as run.
"""

from __future__ import annotations

import fnmatch
import posixpath
import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.aside import (
    is_disused,
    is_left_alone,
    is_named_by_launch,
    is_not_installed,
    python_build_files,
)
from archlint.analysis.kept import kept, once
from archlint.analysis.reached_code import needed_packages
from archlint.packaging.told_scripts import is_told_to_run
from archlint.packaging.unbuilt_files import runs_nowhere
from archlint.packaging.uninstalled_files import is_left_out_launch_file, is_meant_to_start, is_told_to_start
from archlint.ros.packages import package_of_module
from archlint.syntax import facts
from archlint.syntax.parts import everything_in
from archlint.syntax.walk import main_guard
from archlint.workspace.model import LAUNCH_TEXT_KINDS

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex
    from archlint.workspace.installed import InstalledFiles, Installs


def nothing_runs(workspace: WorkspaceIndex, file: str) -> bool:
    """Whether nothing of the workspace runs a file of code or a launch file; False for all others, which are judged
    where something in use reads them."""
    return kept(workspace, (nothing_runs, file), lambda: _nothing_runs(workspace, file))


def _nothing_runs(workspace: WorkspaceIndex, file: str) -> bool:
    if _is_launch_file(workspace, file):
        # One that is not installed may be forgotten: PKG004 and whoever starts it by its path ask for it.
        return _is_put_aside(workspace, file) or _is_of_old(workspace, file)
    kind = workspace.code.kind_of(file)
    if kind == "cpp":
        return _is_put_aside(workspace, file) or runs_nowhere(workspace, file)
    if kind == "interface":
        return _is_put_aside(workspace, file)
    return kind == "python" and (
        _is_put_aside(workspace, file)
        or _is_spare_program(workspace, file)
        or _is_left_out(workspace, file)
        or _is_idle_module(workspace, file)
        or is_earlier_version(workspace, file)
    )


_VERSION = re.compile(
    r"(?P<name>.*[\W_])(?P<word>v|ver|version)(?P<gap>[\W_]?)(?P<number>\d+(?:\.\d+)*)\.py", re.IGNORECASE
)


def is_earlier_version(workspace: WorkspaceIndex, file: str) -> bool:
    """Whether a script that no build installs is called a version of something, a later one lies beside it
    (``pick v1.py``, ``pick v2.py``), and no code or document has a word for the earlier one."""
    folder, name = posixpath.split(file)
    version = _VERSION.fullmatch(name)
    if version is None or file in workspace.code.in_use or _may_be_installed(workspace, file, name):
        return False
    beside = (posixpath.split(path) for path in workspace.tree.files_below(folder or "."))
    if not any(_follows(version, _VERSION.fullmatch(other)) for place, other in beside if place == folder):
        return False
    mentions = workspace.code.files_that_mention(name.removesuffix(".py"))
    return all(path == file for path in mentions) and not is_told_to_run(workspace, file)


def _may_be_installed(workspace: WorkspaceIndex, file: str, name: str) -> bool:
    package = workspace.package_of(file)
    installs = None if package is None else workspace.installs.get(package)
    if package is None or installs is None:
        return package is not None
    return installs.open_executables or name in installs.words or any(_may_take(row, file) for row in installs.files)


def _follows(version: re.Match[str], other: re.Match[str] | None) -> bool:
    same = other is not None and other["name"].lower() == version["name"].lower()
    return other is not None and same and _parts(other) > _parts(version)


def _parts(version: re.Match[str]) -> list[int]:
    return [int(part) for part in version["number"].split(".")]


def _is_put_aside(workspace: WorkspaceIndex, file: str) -> bool:
    """Whether a file is put aside and no code names it, such as ``driver copy.py``.  The build of a package that is put
    aside itself says nothing of its launch files."""
    if _is_launch_file(workspace, file):
        package = workspace.packages.get(workspace.package_of(file) or "")
        whole = package is not None and is_disused(workspace, package.manifest.relative)
        wanted = is_told_to_start if whole else is_meant_to_start
        return is_disused(workspace, file) and not wanted(workspace, file)
    return is_left_alone(workspace, file) and is_disused(workspace, file)


def _is_of_old(workspace: WorkspaceIndex, file: str) -> bool:
    """Whether a launch file that its package leaves out is what an installed one beside it was ported from:
    ``robot.launch`` beside ``robot.launch.py``."""
    folder, name = posixpath.split(file)
    installs = workspace.installs.get(workspace.package_of(file) or "")
    if installs is None or not name.endswith(".launch") or not is_left_out_launch_file(workspace, file):
        return False
    ported = (posixpath.join(folder, f"{name}{ending}") for ending in (".py", ".xml", ".yaml"))
    return any(workspace.tree.is_file(other) and any(installs.places_of(other)) for other in ported)


def _is_launch_file(workspace: WorkspaceIndex, file: str) -> bool:
    """Whether launch may be given a file, be it one that cannot be read."""
    kind = workspace.code.kind_of(file)
    return kind in ("launch_python", *LAUNCH_TEXT_KINDS) or file in _launch_files(workspace)


@once
def _launch_files(workspace: WorkspaceIndex) -> frozenset[str]:
    return frozenset(workspace.launch_files.all())


def _is_spare_program(workspace: WorkspaceIndex, file: str) -> bool:
    """Whether a script lies in a package that installs other programs, no test imports it, and no document says to run
    it.  One beside the packages is for who works on them."""
    if workspace.package_of(file) is None or not is_not_installed(workspace, file):
        return False
    return not (file in _tested(workspace) or is_told_to_run(workspace, file))


def _is_left_out(workspace: WorkspaceIndex, file: str) -> bool:
    """Whether the setup.py of a package that installs programs leaves a module out, as ``find_packages()`` does where
    there is no ``__init__.py`` and a list does that lacks its folder, and nothing that runs imports it."""
    installs = workspace.installs.get(workspace.package_of(file) or "")
    if installs is None or installs.python is None or not installs.executables:
        return False
    if installs.open_executables or installs.open_files or installs.python.has(file) or not _is_below(installs, file):
        return False
    if file in workspace.code.in_use or file in _tested(workspace) or is_told_to_run(workspace, file):
        return False
    return not any(_may_take(row, file) for row in installs.files)


def _is_idle_module(workspace: WorkspaceIndex, file: str) -> bool:
    """Whether no program here comes to a module of a package that installs programs, and the module imports nothing of
    ROS, or no file that may run has a word for it: what is left of a library that was copied for another part of it,
    or of a node that nothing makes any more."""
    if not _is_uncalled_for(workspace, file):
        return False
    code = workspace.facts_at(file)
    return code is not None and (not _imports_ros(code) or _is_named_by_idle_ones(workspace, file))


def _is_uncalled_for(workspace: WorkspaceIndex, file: str) -> bool:
    installs = workspace.installs.get(workspace.package_of(file) or "")
    code = None if installs is None else workspace.facts_at(file)
    if installs is None or code is None or not installs.executables or installs.open_executables:
        return False
    if code.problems:  # who knows what it imports and calls
        return False
    if not _is_below(installs, file) or main_guard(code) is not None:
        return False
    used = file in workspace.code.in_use or file in _tested(workspace) or is_named_by_launch(workspace, _stem(file))
    return not used and not is_told_to_run(workspace, file) and not _calls_as_it_loads(code)


def _is_named_by_idle_ones(workspace: WorkspaceIndex, file: str) -> bool:
    """Whether only modules of that kind have a word for one, in a package that no other one here needs and that loads
    nothing by a name which is put together."""
    package, code = workspace.package_of(file) or "", workspace.code
    if package in needed_packages(workspace) or any(_may_take(row, file) for row in workspace.installs[package].files):
        return False
    if any(code.mentions(other, word) for other in code.files_of(package) for word in _LOADING):
        return False
    built = (*python_build_files(workspace.installs[package]), *_data_files(workspace, package))
    waiting, seen = [file], {file}
    while waiting and len(seen) <= _MANY:
        stem = _stem(waiting.pop())
        fresh = [other for other in code.files_that_mention(stem) if other not in seen]
        if stem == "__init__" or any(code.mentions(path, stem) for path in built):
            return False
        if not all(_is_uncalled_for(workspace, other) for other in fresh):
            return False
        seen.update(fresh)
        waiting += fresh
    return not waiting


def _data_files(workspace: WorkspaceIndex, package: str) -> Iterator[str]:
    """The files of a package by which others load its modules: descriptions of plugins, parameters."""
    folder = posixpath.dirname(workspace.packages[package].manifest.relative) or workspace.tree.top
    return (path for path in workspace.tree.files_below(folder) if path.endswith(_DATA))


_DATA = (".cfg", ".json", ".toml", ".xml", ".yaml", ".yml")
_LOADING = ("__import__", "importlib", "pkgutil", "exec")
_MANY = 10
"""Of how many modules it is asked who names them."""


def _imports_ros(code: facts.Facts) -> bool:
    rows: list[tuple[str, list[str]]] = [(part.module, []) for part in everything_in(code.body, facts.Import)]
    froms = everything_in(code.body, facts.ImportFrom)
    rows += [(part.module, [name for name, _ in part.names]) for part in froms]
    return any(package_of_module(module, names, lambda top: False) is not None for module, names in rows)


def _calls_as_it_loads(code: facts.Facts) -> bool:
    """Whether a file may be a program: it calls something as it is loaded."""
    return any(isinstance(part, facts.Expression) and isinstance(part.value, facts.Call) for part in code.body)


def _stem(file: str) -> str:
    return posixpath.basename(file).removesuffix(".py")


def _is_below(installs: Installs, file: str) -> bool:
    return installs.folder in ("", ".") or file.startswith(f"{installs.folder}/")


def _may_take(row: InstalledFiles, file: str) -> bool:
    """Whether a file is among those that are installed as data or as scripts."""
    return file.startswith(f"{row.source}/") if row.folder else fnmatch.fnmatchcase(file, row.source)


@once
def _tested(workspace: WorkspaceIndex) -> frozenset[str]:
    """The tests, and all that they import."""
    python = (file.relative for file, _ in workspace.code.asked_for() if file.kind == "python")
    return workspace.code.reached_from(path for path in python if workspace.roles.is_test(path))


__all__ = ["is_earlier_version", "nothing_runs"]

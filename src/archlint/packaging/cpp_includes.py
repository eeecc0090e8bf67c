"""The headers of other packages that the C++ code of a package includes.

A package of ROS installs its headers into a folder of its own name, so that an include says which package it needs.
"""

from __future__ import annotations

import posixpath
import re
from collections.abc import Container, Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.analysis.aside import is_disused
from archlint.analysis.kept import kept, once
from archlint.place import Place
from archlint.ros import packages, rosdep
from archlint.workspace.kinds import CPP_SUFFIXES

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex
    from archlint.workspace.installed import Installs

_DIRECTIVE = re.compile(r"\s*#\s*(\w+)\s*(.*)")
_HEADER = re.compile(r"[<\"]([\w.+/-]+)[\">]")
_HEADERS = (".h", ".hpp", ".hxx", ".hh")
_OPENS = frozenset({"if", "ifdef", "ifndef"})
_NOT_BUILT = frozenset({"test", "tests", "doc", "docs", "example", "examples", "benchmark", "benchmarks", "templates"})

_WITHOUT_HEADERS = frozenset({"moveit"})
"""Packages that have no headers, though the headers of others are in a folder of their name."""
_FETCHES = frozenset({"externalproject_add", "fetchcontent_declare", "cpmaddpackage"})


def packages_of_headers(workspace: WorkspaceIndex) -> Iterator[tuple[Place, str]]:
    """Each package of which a package of ament_cmake includes a header whatever the machine is: the first place in each
    file of the code that its CMakeLists.txt builds.  Nothing of a package that declares one of which nobody knows what
    it brings along."""
    brings = packages.table().brings
    of_ros = {name for name, brought in brings.items() if brought} - _WITHOUT_HEADERS  # others may be of the system
    for name in sorted(workspace.installs):
        installs = workspace.installs[name]
        package = workspace.manifests.get(installs.folder)
        if package is None or package.name != name or package.build_type != "ament_cmake" or package.ros1:
            continue
        read = brings.keys() | workspace.packages.keys() | rosdep.keys()
        if not read.issuperset(d.name for d in package.dependencies) or not _FETCHES.isdisjoint(installs.words):
            continue
        for path in _built(workspace, installs):
            seen = {name}
            for header, line in _includes(workspace, path):
                needed, _, inside = header.partition("/")
                known = has_header(workspace, needed, header) if needed in workspace.packages else needed in of_ros
                if inside and known and needed not in seen and not has_header(workspace, name, header):
                    seen.add(needed)
                    yield Place(path, line, 1, line, 1), needed


def _includes(workspace: WorkspaceIndex, path: str) -> Sequence[tuple[str, int]]:
    return kept(workspace, (includes_of, path), lambda: includes_of(workspace.tree.text(path) or ""))


def _built(workspace: WorkspaceIndex, installs: Installs) -> list[str]:
    """The sources that a CMakeLists.txt builds, and the headers of the package that they include."""
    code = _code(workspace).get(installs.package, ())
    idle = {path for path in code if workspace.roles.is_test(path) or is_disused(workspace, path)}
    todo = [path for path in code if path in installs.sources and path not in idle]
    by_name: dict[str, list[str]] = {}
    for path in code:
        by_name.setdefault(posixpath.basename(path), []).append(path)
    reached = dict.fromkeys(todo)
    while todo:
        for header, _ in _includes(workspace, todo.pop()):
            fitting = [
                path for path in by_name.get(posixpath.basename(header), ()) if f"/{path}".endswith(f"/{header}")
            ]
            todo += [path for path in fitting if path not in reached]
            reached |= dict.fromkeys(fitting)
    return sorted(reached)


def has_header(workspace: WorkspaceIndex, package: str, header: str) -> bool:
    """Whether a package of the workspace has a header, or makes it of an interface file."""
    makes = workspace.packages[package].is_interface_package and header.split("/")[1:2] in _OF_INTERFACES
    return makes or any(f"/{path}".endswith(f"/{header}") for path in _code(workspace).get(package, ()))


def includes_any_of(workspace: WorkspaceIndex, package: str, needed: str) -> bool:
    """Whether a file of C++ of a package includes a header of another one, or code that is made of its interfaces."""
    headers = (header for path in _code(workspace).get(package, ()) for header, _ in _includes(workspace, path))
    return any(header.partition("/")[0].partition(".")[0] == needed for header in headers)


def is_of_workspace(workspace: WorkspaceIndex, header: str) -> bool:
    """Whether any package of the workspace has the file of a header."""
    return any(f"/{path}".endswith(f"/{header}") for paths in _code(workspace).values() for path in paths)


def headers_with(workspace: WorkspaceIndex, word: str) -> list[str]:
    """The headers of the workspace in which a word stands, or that open all of ``std``."""
    headers = {path for paths in _code(workspace).values() for path in paths if path.endswith(_HEADERS)}
    texts = ((path, workspace.tree.text(path) or "") for path in sorted(headers))
    return [path for path, text in texts if word in text or "using namespace std;" in text]


def headers_of(workspace: WorkspaceIndex, package: str, header: str) -> list[str]:
    """The files of a package that an include may mean, by their paths below its folder."""
    folder = workspace.installs[package].folder
    paths = (path for path in _code(workspace).get(package, ()) if f"/{path}".endswith(f"/{header}"))
    return [path if folder == "." else path.removeprefix(f"{folder}/") for path in paths]


_OF_INTERFACES = (["msg"], ["srv"], ["action"])


@once
def _code(workspace: WorkspaceIndex) -> dict[str, list[str]]:
    """The files of C++ by their packages, but for those of tests and examples."""
    by_package: dict[str, list[str]] = {}
    folders = {installs.folder: name for name, installs in workspace.installs.items()}
    for path in workspace.tree.files_below(workspace.tree.top):
        if path.rpartition(".")[2] not in CPP_SUFFIXES:
            continue
        home = _home(path, folders)
        if home is not None and _NOT_BUILT.isdisjoint(path.removeprefix(f"{home}/").split("/")[:-1]):
            by_package.setdefault(folders[home], []).append(path)
    return by_package


def _home(path: str, folders: Container[str]) -> str | None:
    """The innermost folder of a package that a file is in."""
    folder = posixpath.dirname(path)
    while folder and folder not in folders:
        folder = posixpath.dirname(folder)
    return folder or ("." if "." in folders else None)


def includes_of(text: str) -> Sequence[tuple[str, int]]:
    """The headers that a file includes, with their lines, outside of conditions: but for the guard around a header."""
    rows: list[tuple[str, int]] = []
    depth, guard, before = 0, "", ""
    in_comment = False
    for number, line in enumerate(text.splitlines(), 1):
        if in_comment or line.lstrip().startswith("/*"):
            in_comment = "*/" not in line
            continue
        directive = _DIRECTIVE.match(line)
        if directive is None:
            continue
        word, rest = directive[1], directive[2].strip()
        if word in _OPENS:
            guard = rest if not before and word == "ifndef" else guard
            depth += 1
        elif word == "endif":
            depth -= 1
        elif word == "include" and depth <= bool(guard):
            header = _HEADER.match(rest)
            rows += [(header[1], number)] if header is not None else []
        before = word
    return rows


__all__ = ["has_header", "headers_of", "headers_with", "includes_of", "is_of_workspace", "packages_of_headers"]

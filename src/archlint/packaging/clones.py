"""What shows that a package was copied from somewhere: rosdistro has its name, its package.xml the address of a project
that is called like it, the README beside it says how to clone it; it lies in a folder that has what the root of a
repository has."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator, Set
from functools import partial
from typing import TYPE_CHECKING

from archlint.analysis.kept import kept
from archlint.ros.packages import released_names, table
from archlint.workspace.folders import folders_above

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex
    from archlint.workspace.model import Package

_LICENSES = ("LICENSE", "LICENSE.txt", "LICENSE.md", "LICENCE", "COPYING", "license.txt")
_FILES = (*_LICENSES, "CONTRIBUTING.md", ".travis.yml", ".gitlab-ci.yml")
_FOLDERS = (".github",)
_DOCUMENTS = ("README.md", "README.MD", "readme.md", "Readme.md", "README.rst", "README", "README.txt")
_CLONED = re.compile(r"\bgit clone\b[^\n]*?[/:][\w.-]+/([\w.-]+?)(?:\.git)?(?=[\s`'\")]|$)", re.MULTILINE)
_BRANCH = re.compile(
    r"[-_](?:main|master|ros2|devel|foxy|galactic|humble|iron|jazzy|kilted|rolling)(?:[ _-]*\([^()]*\))?$",
    re.IGNORECASE,
)
"""What the archive of a branch adds to the name of a repository, and what somebody notes behind it in brackets."""
_WORD = re.compile(r"[a-z0-9]+")
_SHORT = 3
_OF_TEMPLATES = frozenset({"moveit", "moveit2"})
"""What MoveIt's Setup Assistant writes into the manifest of each configuration that it makes."""
_CHANGED = re.compile(r"(?:^|[/_.-])(?:custom|customi[sz]ed|modified|my|own|patched)(?:[/_.-]|$)", re.IGNORECASE)
_NOBODY = re.compile(r"todo|example|you(?:r|@)|user@|@(?:mail|email|domain)\.")
"""Addresses that stand for others, in manifests that nobody has filled in."""
_SCAFFOLD = "0.0.0"
"""The version that ``ros2 pkg create`` writes."""


def is_published(package: Package) -> bool:
    """Whether the name of a package is that of one that somebody releases, or has released, or has a page for it."""
    if package.name in table().names or (package.name in released_names() and package.version != _SCAFFOLD):
        return True
    return any(_is_called_like(address, package.name) for address in package.addresses)


def _is_called_like(address: str, name: str) -> bool:
    """Whether an address has a word of a name that is longer than an abbreviation."""
    said = {*_WORD.findall(address.lower())} - _OF_TEMPLATES
    return any(len(word) > _SHORT and word in said for word in _WORD.findall(name.lower()))


def is_a_release(package: Package, versions: Set[str]) -> bool:
    """Whether all that a manifest says is what a release says, wherever the package lies: a name of more than one word
    that is released, a person who can be written to, and a version that is none of those ``versions`` of a team, nor
    the one of a scaffold.  Who works on a copy says so in the name of its folder."""
    if package.name not in released_names() or "_" not in package.name or _CHANGED.search(package.relative):
        return False
    known = any("@" in person and _NOBODY.search(person) is None for person in package.people)
    return known and package.version not in {"", _SCAFFOLD, *versions}


def repositories_around(workspace: WorkspaceIndex, folder: str) -> Iterator[str]:
    """The folders around a package, its own first, that look like the root of a repository and hold only a part of the
    packages."""
    for around in _parts_around(workspace, folder):
        if kept(workspace, (_is_like_a_root, around), partial(_is_like_a_root, workspace, around)):
            yield around


def _is_like_a_root(workspace: WorkspaceIndex, folder: str) -> bool:
    files = (posixpath.join(folder, name) for name in _FILES)
    folders = (posixpath.join(folder, name) for name in _FOLDERS)
    return any(map(workspace.tree.is_file, files)) or any(map(workspace.tree.is_folder, folders))


def _parts_around(workspace: WorkspaceIndex, folder: str) -> Iterator[str]:
    for around in (folder, *folders_above(folder)):
        if around == "." or all(is_in(other, around) for other in workspace.manifests):
            return
        yield around


def is_in(folder: str, around: str) -> bool:
    return folder == around or folder.startswith(f"{around}/")


def clone_around(workspace: WorkspaceIndex, folder: str) -> str | None:
    """The folder around a package, or its own, whose README says to clone a repository that is called like it."""
    names = {_plain(workspace.manifests[folder].name)}
    for around in _parts_around(workspace, folder):
        own = names | {_plain(_BRANCH.sub("", posixpath.basename(around)))}
        if not own.isdisjoint(kept(workspace, (_cloned_by, around), partial(_cloned_by, workspace, around))):
            return around
    return None


def clone_of_file(workspace: WorkspaceIndex, file: str) -> str | None:
    """The folder around a file of no package, which holds none, whose README says to clone a repository that is called
    like it: the archive of a library, unpacked beside the packages."""
    for around in folders_above(file):
        if around in (".", workspace.tree.top) or any(is_in(folder, around) for folder in workspace.manifests):
            return None
        cloned = kept(workspace, (_cloned_by, around), partial(_cloned_by, workspace, around))
        if _plain(_BRANCH.sub("", posixpath.basename(around))) in cloned:
            return around
    return None


def _cloned_by(workspace: WorkspaceIndex, folder: str) -> set[str]:
    """The names of the repositories that the README of a folder says to clone."""
    paths = [path for path in (posixpath.join(folder, name) for name in _DOCUMENTS) if workspace.tree.is_file(path)]
    return {_plain(name) for path in paths for name in _CLONED.findall(workspace.tree.text(path) or "")}


def _plain(name: str) -> str:
    return "".join(_WORD.findall(name.lower()))


def is_a_repository(workspace: WorkspaceIndex) -> bool:
    """Whether the top of the workspace looks like the root of a repository, in which copies of others lie."""
    names = (*_FILES, *_DOCUMENTS, ".gitignore")
    return any(workspace.tree.is_file(posixpath.join(workspace.tree.top, name)) for name in names)


__all__ = [
    "clone_around",
    "clone_of_file",
    "is_a_release",
    "is_a_repository",
    "is_in",
    "is_published",
    "repositories_around",
]

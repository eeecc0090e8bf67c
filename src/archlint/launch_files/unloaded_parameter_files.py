"""Parameter files that no launch file here gives to a node: a command line may, or another workspace.

What is wrong with such a file is wrong for every node, as far as it says by ``ros__parameters`` what it is.
"""

from __future__ import annotations

import posixpath
import re
from collections.abc import Collection, Iterator
from typing import TYPE_CHECKING

from archlint.analysis.aside import is_aside
from archlint.analysis.kept import once
from archlint.launch.parameter_sources import files_among
from archlint.launch_files.refused_parameter_files import (
    Misplaced,
    MisplacedIn,
    Misplacement,
    SetTwice,
    set_twice_in,
)
from archlint.syntax.parameter_structure import ROOT

if TYPE_CHECKING:
    from archlint.syntax.parameter_files import ParameterFacts
    from archlint.systems.model import WorkspaceIndex

_TEMPLATE = re.compile(r"\{\{|\{%|<%|\$\{")
_MISSPELT = re.compile(r"^\s+ros[_ -]*param\w*\s*:", re.MULTILINE)
"""A key that begins as ``ros__parameters`` does: another word may be anything."""


def is_template(text: str) -> bool:
    """Whether a program fills something in before a node reads a file."""
    return _TEMPLATE.search(text) is not None


_OF_OTHERS = (Misplacement.MISSING, Misplacement.LIST)
"""What a file for somebody else may have."""


def misplaced_in_unloaded(workspace: WorkspaceIndex) -> Iterator[MisplacedIn]:
    """The first such key of each file: a value without ``ros__parameters`` above it may be for somebody else."""
    for file, facts in _unloaded(workspace):
        wrong = facts.misplaced
        if wrong is not None and wrong.kind not in _OF_OTHERS and _is_meant(wrong):
            yield MisplacedIn(file, wrong, None, None)


def twice_in_unloaded(workspace: WorkspaceIndex) -> Iterator[SetTwice]:
    """The first parameter of each file that stands twice with two values."""
    for file, facts in _unloaded(workspace):
        yield from set_twice_in(file, None, None, facts)


def has_no_reader(workspace: WorkspaceIndex, file: str) -> bool:
    """Whether nobody is seen to read such a file: no package installs it, and no text for people names it."""
    installs = workspace.installs.get(workspace.package_of(file) or "")
    if installs is None or installs.open_files or any(True for _ in installs.places_of(file)):
        return False
    below, name = f"{installs.folder}/", posixpath.basename(file)
    if installs.may_install(file.removeprefix(below)):
        return False
    return not any(name in text for text in _told(workspace))


_NAMES = (
    ".py",
    ".xml",
    ".yaml",
    ".yml",
    ".xacro",
    ".urdf",
    ".sdf",
    ".world",
    ".cpp",
    ".hpp",
    ".h",
    ".sh",
    ".md",
    ".txt",
)
"""The files in which a parameter file may be named."""


def is_named(workspace: WorkspaceIndex, file: str) -> bool:
    """Whether any file of the workspace has the name of a parameter file, with its ending or, in quotation marks and to
    be put together, without."""
    stem, _ = posixpath.splitext(posixpath.basename(file))
    name = rf"(?<!\w){re.escape(stem)}\.|['\"/]{re.escape(stem)}['\"]"
    paths = (path for path in workspace.tree.files_below(workspace.tree.top) if path.endswith(_NAMES) and path != file)
    return any(workspace.code.mentions(path, stem) and workspace.tree.lines_with(path, name) for path in paths)


def is_left_out(workspace: WorkspaceIndex, file: str) -> bool:
    """Whether nothing but launch files names a file, all of which is followed, and they give it to nothing that they
    start: the action that would get it is left out of the description, say."""
    if file in loaded_files(workspace):
        return False
    name = posixpath.basename(file)
    paths = (path for path in workspace.tree.files_below(workspace.tree.top) if path.endswith(_NAMES) and path != file)
    naming = {path for path in paths if workspace.tree.lines_with(path, re.escape(name))}
    followed = {path for launched in workspace.launched if not launched.not_followed() for path in launched.sources}
    return bool(naming) and naming <= followed


def is_superseded(workspace: WorkspaceIndex, file: str, others: Collection[str]) -> bool:
    """Whether nothing names a file, and something names another one of its package, of ``others`` that have all that it
    has: it is what they were before."""
    beside = [other for other in others if workspace.package_of(other) == workspace.package_of(file) and other != file]
    return bool(beside) and not is_named(workspace, file) and any(is_named(workspace, other) for other in beside)


_TELLS = re.compile(r"(?:^|/)(?:README[^/]*|[^/]*\.(?:md|rst|sh|bash|txt)|[Dd]ockerfile[^/]*|Makefile)$", re.IGNORECASE)
"""What says how something is started."""


@once
def _told(workspace: WorkspaceIndex) -> list[str]:
    tree = workspace.tree
    return [tree.text(path) or "" for path in tree.files_below(tree.top) if _TELLS.search(path)]


def _is_meant(wrong: Misplaced) -> bool:
    return wrong.kind is not Misplacement.MISSPELT or _MISSPELT.match(f" {wrong.key}:") is not None


@once
def _unloaded(workspace: WorkspaceIndex) -> list[tuple[str, ParameterFacts]]:
    loaded = loaded_files(workspace)
    files = [(file, facts) for file, facts in parameter_files(workspace) if file not in loaded]
    return [(file, facts) for file, facts in files if not _is_named_in_code(workspace, file)]


@once
def parameter_files(workspace: WorkspaceIndex) -> list[tuple[str, ParameterFacts]]:
    """The parameter files of the packages, loaded or not, that are in use and that nothing is to be filled in."""
    files: list[tuple[str, ParameterFacts]] = []
    for folder in sorted(workspace.manifests):
        package = workspace.manifests[folder]
        if package.ros1 or package.manifest.context:
            continue
        for file in workspace.tree.files_below(folder):
            if not file.endswith((".yaml", ".yml")) or is_aside(workspace, file):
                continue
            text = workspace.tree.text(file) or ""
            of_parameters = ROOT in text or _MISSPELT.search(text) is not None
            if of_parameters and not is_template(text):
                files.append((file, workspace.parameters_of(file)))
    return files


@once
def loaded_files(workspace: WorkspaceIndex) -> set[str | None]:
    """The files that launch files name for whatever use: what they make of them is their own."""
    named = {reference.source for launched in workspace.launched for reference in launched.references}
    given = (
        use.reference.source
        for launched in workspace.launched
        for started in launched.started
        for use in files_among(started.parameters)
    )
    return named.union(given)


def _is_named_in_code(workspace: WorkspaceIndex, file: str) -> bool:
    """Whether code of a node that reads YAML has the name of a file."""
    name = posixpath.basename(file)
    return any(workspace.code.mentions(path, name) for path in workspace.code.files_that_mention("yaml"))


__all__ = [
    "has_no_reader",
    "is_left_out",
    "is_named",
    "is_superseded",
    "is_template",
    "loaded_files",
    "misplaced_in_unloaded",
    "parameter_files",
    "twice_in_unloaded",
]

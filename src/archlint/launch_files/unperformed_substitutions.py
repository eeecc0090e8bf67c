"""Substitutions in parameter files that launch does not perform, since nothing asks it to: ``allow_substs`` is off.

Source: ``ParameterFile`` in launch_ros, which otherwise passes the path of the file on as it is.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.kept import once
from archlint.finding import Place
from archlint.launch.parameter_sources import files_among
from archlint.records import dataclass

if TYPE_CHECKING:
    from archlint.launch.parameter_sources import ParameterFileUse
    from archlint.launch.started import Started
    from archlint.systems.model import System, WorkspaceIndex

_PERFORMED = re.compile(r"\$\((?:find-pkg-share|find-pkg-prefix|var|env|dirname)(?: [^()]*)?\)")


@dataclass(frozen=True)
class Unperformed:
    """A value with a substitution in a parameter file; ``given`` is where a launch file gives the file to a node."""

    place: Place
    name: str
    written: str
    given: Place


def unperformed_substitutions(system: System) -> Iterator[Unperformed]:
    """Those in the files that a launched system gives to nodes of the workspace, which know nothing of such texts."""
    workspace = system.workspace
    if system.launched is None or workspace is None:
        return
    for process in system.launched.started:
        for use in files_among(process.parameters):
            file = use.reference.source
            if file is None or use.changes or file in _performed(workspace):
                continue
            rows = [
                Unperformed(Place(file, *entry.span), entry.name, match[0], use.place)
                for section in workspace.launch_files.parameters(file).sections
                for entry in section.entries
                if isinstance(entry.value, str) and (match := _PERFORMED.search(entry.value)) is not None
            ]
            if rows and _is_plain(workspace, process):  # which reads all texts of a package
                yield from rows


def _is_plain(workspace: WorkspaceIndex, process: Started) -> bool:
    """Whether a process is of a package of the workspace that does not look for substitutions itself."""
    package = process.package.text
    if package is None or package not in workspace.packages:
        return False
    below = workspace.tree.files_below(workspace.packages[package].relative)
    code = (path for path in below if path.endswith((".py", ".cpp", ".hpp", ".cc", ".h")) and "launch" not in path)
    return not any("find-pkg-share" in (workspace.tree.text(path) or "") for path in code)


@once
def _performed(workspace: WorkspaceIndex) -> frozenset[str]:
    """The files in which some launch file lets launch perform what stands there, or which one changes."""
    files = (use.reference.source for use in _uses(workspace) if use.substitutions or use.changes)
    return frozenset(file for file in files if file is not None)


def _uses(workspace: WorkspaceIndex) -> Iterator[ParameterFileUse]:
    for system in workspace.systems:
        for process in system.launched.started if system.launched is not None else ():
            yield from files_among(process.parameters)


__all__ = ["Unperformed", "unperformed_substitutions"]

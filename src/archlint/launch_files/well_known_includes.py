"""Includes of launch files that are not in the workspace and of which the arguments are known all the same."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.analysis.kept import once
from archlint.analysis.pinned import may_be_on_focal
from archlint.launch.kinds import FileStatus
from archlint.records import dataclass
from archlint.ros.launch_arguments import well_known

if TYPE_CHECKING:
    from archlint.launch.model import Included, Launched
    from archlint.place import Place
    from archlint.systems.model import WorkspaceIndex


@dataclass(frozen=True)
class UnknownToInclude:
    """Arguments that a well-known launch file does not take, each with the place where it is given, and those that it
    takes."""

    package: str
    file: str
    given: tuple[tuple[str, Place], ...]
    taken: tuple[str, ...]


def taken_by(include: Included) -> Sequence[str] | None:
    """The arguments that an include of such a file may read; None for any other."""
    reference = include.reference
    if reference.status != FileStatus.EXTERNAL or reference.package is None or include.own_process:
        return None
    files = well_known().packages.get(reference.package, {})
    return files.get(posixpath.basename(reference.written or ""))


def unknown_to_includes(workspace: WorkspaceIndex, launched: Launched) -> Iterator[UnknownToInclude]:
    """What such includes of a launch are given and do not take, and nothing that comes after them either."""
    if launched.gaps or launched.reads_any or may_be_on_focal(workspace):
        return
    for number, include in enumerate(launched.included):
        taken = taken_by(include)
        if taken is None or _is_one_of_several(launched, include):
            continue
        later = [_read_by(workspace, other) for other in launched.included[number + 1 :]]
        if None in later:
            continue
        free = {name for names in later for name in names or ()} | {*taken}
        given = [
            (name, place)
            for name, place in include.arguments
            if name not in free
            and place not in launched.read_on
            and (include.file, name) not in launched.set_by_includes
            and name not in named_in_parameters(workspace)
        ]
        if given:
            file = posixpath.basename(include.reference.written or "")
            yield UnknownToInclude(include.reference.package or "", file, tuple(given), tuple(taken))


def _is_one_of_several(launched: Launched, include: Included) -> bool:
    """Whether one action may include one of several files: an argument is for the one that takes it."""
    at = include.place, include.called_at
    return any(other is not include and (other.place, other.called_at) == at for other in launched.included)


def _read_by(workspace: WorkspaceIndex, include: Included) -> Sequence[str] | None:
    """What an include further down may read; None where nobody knows."""
    source = include.reference.source
    if source is None:
        return taken_by(include)
    target = workspace.launched_alone.get(source)
    if target is None or target.gaps or target.reads_any:
        return None
    others = [taken_by(inner) for inner in target.included if inner.reference.source is None]
    if None in others:
        return None
    declared = [argument.name for argument in target.declared]
    return [*declared, *target.read, *(name for names in others for name in names or ())]


_IN_PARAMETERS = re.compile(r"\$\(var\s+([\w.-]+)")


@once
def named_in_parameters(workspace: WorkspaceIndex) -> frozenset[str]:
    """The launch arguments that YAML files of the workspace name: Nav2 lets its parameter files read any."""
    tree = workspace.tree
    files = (path for path in tree.files_below(tree.top) if path.endswith((".yaml", ".yml")))
    return frozenset(name for path in files for name in _IN_PARAMETERS.findall(tree.text(path) or ""))


__all__ = ["UnknownToInclude", "named_in_parameters", "taken_by", "unknown_to_includes"]

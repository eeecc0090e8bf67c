"""Values in parameter files that a controller of ros2_controllers has further down: ``goal_time`` of a trajectory
controller is read as ``constraints.goal_time`` only."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING

from archlint.launch_files.plugin_parameters import controllers_of
from archlint.launch_files.unloaded_parameter_files import parameter_files
from archlint.place import Place
from archlint.records import dataclass
from archlint.ros.plugin_parameters import Types, spelt, well_known
from archlint.suggestions import nearest

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex

_OF_NAV2 = ("nav2_", "dwb_", "opennav_")
"""How the packages of the other plugins in the table begin, of which it does not have all parameters."""


@dataclass(frozen=True)
class MisplacedValue:
    """A value for a controller, the name that it should have, and the class that declares that."""

    place: Place
    name: str
    meant: str
    owner: str


def misplaced_values(workspace: WorkspaceIndex) -> Iterator[MisplacedValue]:
    """All such values, file by file.  The file may be for MoveIt, too: the type of a controller is taken from whatever
    file has it, if all agree."""
    packages = {package.name for package in workspace.manifests.values()}
    files = parameter_files(workspace)
    types: dict[str, set[str]] = {}
    for _, facts in files:
        for name, kind in controllers_of(facts).items():
            types.setdefault(name, set()).add(spelt(kind))
    known = {name: _declared(kinds, packages) for name, kinds in types.items()}
    for file, facts in files:
        for section in facts.sections:
            node = section.path[-1].rpartition("/")[2] if section.path else ""
            owner, declared = known.get(node, ("", {}))
            for entry in section.entries if declared else ():
                meant = _further_down(entry.name, declared)
                if meant:
                    yield MisplacedValue(Place(file, *entry.span), entry.name, meant, owner)


def _declared(kinds: set[str], packages: set[str]) -> tuple[str, Types]:
    """The one class of a controller and what it declares; nothing where that may be another version."""
    [owner, *others] = sorted(kinds)
    if others or owner.startswith(_OF_NAV2) or owner.partition("::")[0] in packages:
        return owner, {}
    return owner, well_known().plugins.get(owner, {})


def _further_down(name: str, declared: Mapping[str, object]) -> str:
    """The one parameter whose name ends with one that is not declared, if that is no slip for another one; a plain word
    such as ``enable`` may be of anything."""
    if "_" not in name or name in declared:
        return ""
    below = [other for other in declared if other.endswith(f".{name}")]
    if len(below) != 1 or "*" in below[0] or nearest(name, [other for other in declared if other.count(".") == 0]):
        return ""
    return below[0]


__all__ = ["MisplacedValue", "misplaced_values"]

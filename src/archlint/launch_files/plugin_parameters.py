"""Values in parameter files whose type a well-known plugin or node refuses: those of Nav2 and of ros2_controllers.

Who gets the values, the file says itself: it names the class of a plugin, or the type of a controller.  No launch file
has to give it to anybody, as those of Nav2 that are included may.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING

from archlint.analysis.kept import once
from archlint.analysis.pinned import is_from_before_galactic
from archlint.finding import Place
from archlint.launch.named_files import Rewriting
from archlint.launch.parameter_sources import files_among
from archlint.launch_files.unloaded_parameter_files import is_superseded, parameter_files
from archlint.records import dataclass
from archlint.ros.parameter_types import ParameterType, type_of
from archlint.ros.plugin_parameters import spelt, type_in, well_known

if TYPE_CHECKING:
    from archlint.syntax.parameter_files import ParameterEntry, ParameterFacts, ParameterSection
    from archlint.systems.model import WorkspaceIndex

_MANAGER = "controller_manager"
_OLDER = re.compile(r"(?:^|[/_.-])(?:dashing|eloquent|foxy)(?:[/_.-]|$)", re.IGNORECASE)


@dataclass(frozen=True)
class Mistyped:
    """A value of another type than the one that ``owner``, a class or a node, declares the parameter with."""

    place: Place
    name: str
    value: object
    owner: str
    wanted: ParameterType
    given: ParameterType


def mistyped_values(workspace: WorkspaceIndex) -> Iterator[Mistyped]:
    """All such values, file by file."""
    if is_from_before_galactic(workspace):
        return
    packages = {package.name for package in workspace.manifests.values()}
    for file, facts in parameter_files(workspace):
        if _OLDER.search(file):
            continue
        set_elsewhere = _rewritten(workspace).get(file, ())
        for entry, rest, owner in _owned(facts):
            wanted, given = _wanted(owner, rest, packages), type_of(entry.value)
            if wanted is None or given is None or given == wanted or not _is_plain(entry.value):
                continue
            if not any(name.rpartition(".")[2] == entry.path[-1] for name in set_elsewhere):
                yield Mistyped(Place(file, *entry.span), entry.name, entry.value, owner, wanted, given)


def _owned(facts: ParameterFacts) -> Iterator[tuple[ParameterEntry, str, str]]:
    """The values of a file that are for a plugin, or for a node of Nav2: each with its name there."""
    types = controllers_of(facts)
    of_nav2 = _is_of_nav2(facts)
    for section in facts.sections:
        if of_nav2 and _misses_its_costmap(facts, section):
            continue
        node = section.path[-1].rpartition("/")[2] if section.path else ""
        plugins = _plugins(section)
        whole = types.get(node, node if of_nav2 else "")
        for entry in section.entries:
            above = next((path for path in plugins if entry.path[: len(path)] == path), None)
            if above is not None:
                yield entry, ".".join(entry.path[len(above) :]), plugins[above]
            elif whole:
                yield entry, entry.name, whole


def _plugins(section: ParameterSection) -> dict[tuple[str, ...], str]:
    """The classes that a section names, by the keys above ``plugin``, the innermost first."""
    split = ((tuple(entry.name.split(".")), entry.value) for entry in section.entries)
    named = {path[:-1]: value for path, value in split if path[-1] == "plugin" and isinstance(value, str)}
    return dict(sorted(named.items(), key=lambda row: -len(row[0])))


def controllers_of(facts: ParameterFacts) -> dict[str, str]:
    """The types of the controllers of a file, by their names: what the controller manager or they themselves get."""
    types: dict[str, str] = {}
    for section in facts.sections:
        node = section.path[-1].rpartition("/")[2] if section.path else ""
        for entry in section.entries:
            if entry.path[-1] == "type" and isinstance(entry.value, str):
                if node == _MANAGER and len(entry.path) == 2:
                    types[entry.path[0]] = entry.value
                elif len(entry.path) == 1:
                    types[node] = entry.value
    return types


def _is_of_nav2(facts: ParameterFacts) -> bool:
    """Whether a file is for the nodes of Nav2: it has several sections with their names."""
    names = {section.path[-1] for section in facts.sections if section.path}
    return len(names & well_known().nodes.keys()) > 1


_COSTMAPS = frozenset({"local_costmap", "global_costmap"})


def costmaps_without_namespace(workspace: WorkspaceIndex) -> Iterator[tuple[Place, str]]:
    """The sections of files of Nav2 that have the name of a costmap and lack its namespace, which has the same name:
    the node is ``/local_costmap/local_costmap``, and gets nothing of what is for ``/local_costmap``.  Source:
    ``Costmap2DROS`` of nav2_costmap_2d, since Dashing."""
    if "nav2_costmap_2d" in {package.name for package in workspace.manifests.values()}:
        return
    of_nav2 = {file: facts for file, facts in parameter_files(workspace) if _is_of_nav2(facts)}
    for file, facts in of_nav2.items():
        missing = [section for section in facts.sections if _misses_its_costmap(facts, section)]
        if missing and not is_superseded(workspace, file, of_nav2):
            yield from ((Place(file, *section.span), section.path[0].strip("/")) for section in missing)


def _misses_its_costmap(facts: ParameterFacts, section: ParameterSection) -> bool:
    """Whether a section is for a costmap without its namespace, and no other one is for the costmap itself."""
    name = section.path[0].strip("/") if len(section.path) == 1 else ""
    keys = {other.key.strip("/") for other in facts.sections}
    return name in _COSTMAPS and not any(key.endswith(f"{name}/{name}") or "*" in key for key in keys)


def _wanted(owner: str, name: str, packages: set[str]) -> ParameterType | None:
    """The type that an owner declares a parameter with; None where its package is here, which may differ."""
    table = well_known()
    plugin = spelt(owner)
    if owner in table.nodes:
        return None if "nav2_costmap_2d" in packages else type_in(table.nodes[owner], name)
    if plugin not in table.plugins or plugin.partition("::")[0] in packages:
        return None
    return type_in(table.plugins[plugin], name)


_NUMBER_OR_TRUTH = re.compile(r"[-+]?[\d.]+(?:e[-+]?\d+)?|true|false", re.IGNORECASE)


def _is_plain(value: object) -> bool:
    """Whether a value is what it looks like: any other text may stand for what a program puts in."""
    return not isinstance(value, str) or _NUMBER_OR_TRUTH.fullmatch(value) is not None


@once
def _rewritten(workspace: WorkspaceIndex) -> Mapping[str | None, set[str]]:
    """The names of which a launch file sets the values anew before a node reads a file, by the files."""
    names: dict[str | None, set[str]] = {}
    for launched in workspace.launched:
        for started in launched.started:
            for use in files_among(started.parameters):
                for change in use.changes:
                    if isinstance(change, Rewriting):
                        names.setdefault(use.reference.source, set()).update(name for name, _ in change.parameters)
    return names


__all__ = ["Mistyped", "controllers_of", "costmaps_without_namespace", "mistyped_values"]

"""What a change of a name, or its end, has consequences for: users, those who depend on them, files, packages."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import field
from typing import TYPE_CHECKING, Literal

from archlint.dataflow.consequences import Effect, effects_of
from archlint.dataflow.graph import flow_of
from archlint.dataflow.interface_users import InterfaceUse, interfaces_named, uses_of
from archlint.dataflow.subjects import SubjectKind, subjects
from archlint.dataflow.systems import ranked
from archlint.launch.parameter_sources import files_among
from archlint.lookup.ends import remap_of
from archlint.place import Place
from archlint.records import dataclass
from archlint.systems.externals import remapped_names
from archlint.systems.overrides import applied, key_matches

if TYPE_CHECKING:
    from archlint.dataflow.model import Flow, Step
    from archlint.dataflow.subjects import Subject
    from archlint.systems.model import System, WorkspaceIndex
    from archlint.systems.nodes import Endpoint, Node

ImpactKind = Literal["topic", "service", "action", "frame", "node", "interface"]


@dataclass(frozen=True, order=True)
class Mentioned:
    """A place in a launch file or a parameter file, and what it says there."""

    place: Place
    words: str


@dataclass
class Impact:
    """What depends on a name.  ``direct`` are those who use it, ``further`` what comes of these."""

    kind: ImpactKind
    name: str
    systems: list[str] = field(default_factory=list)
    direct: list[Effect] = field(default_factory=list)
    further: list[Effect] = field(default_factory=list)
    uses: list[InterfaceUse] = field(default_factory=list)
    """Of an interface: endpoints, interfaces that hold it, fields and imports."""
    launch_files: list[Mentioned] = field(default_factory=list)
    parameter_files: list[Mentioned] = field(default_factory=list)
    packages: list[str] = field(default_factory=list)
    """The packages of the workspace to build and test again."""
    drawn: list[tuple[Flow, Sequence[Step], frozenset[int]]] = field(default_factory=list)
    """For pictures: of each system the steps that depend on it, and those that it is (``id``)."""


def impacts_of(systems: Sequence[System], name: str) -> list[Impact]:
    """All that a name means, connections first, then nodes and interfaces.  What launch files start counts where one
    starts it."""
    rows: list[tuple[int, System, Flow, Subject]] = []
    best: dict[tuple[SubjectKind, str], int] = {}
    for system, rank in ranked(systems):
        flow = flow_of(system)
        for subject in subjects(flow, name):
            key = subject.kind, subject.name
            best[key] = min(rank, best.get(key, rank))
            rows.append((rank, system, flow, subject))
    impacts: dict[tuple[ImpactKind, str], Impact] = {}
    for rank, system, flow, subject in rows:
        key = subject.kind, subject.name
        if rank == best[key]:
            impact = impacts.setdefault(key, Impact(*key))
            _add(impact, system, flow, subject)
    for workspace in _workspaces(systems):
        for interface in interfaces_named(workspace, systems, name):
            impacts.setdefault(("interface", interface), _of_interface(workspace, systems, interface))
    for impact in impacts.values():
        _tidy(impact)
    return list(impacts.values())


def _workspaces(systems: Sequence[System]) -> list[WorkspaceIndex]:
    by_id = {id(system.workspace): system.workspace for system in systems if system.workspace is not None}
    return list(by_id.values())


def _add(impact: Impact, system: System, flow: Flow, subject: Subject) -> None:
    """What depends on a subject in one system."""
    if system.name is not None:
        impact.systems.append(system.name)
    direct, further, steps = effects_of(flow, subject)
    impact.direct += direct
    impact.further += further
    impact.drawn.append((flow, steps, frozenset(map(id, subject.leaving))))
    nodes = [subject.node] if subject.node is not None else [end.node for end in _ends(subject)]
    packages = [node.package for node in nodes] + [effect.package for effect in (*direct, *further)]
    impact.packages += [package for package in packages if package is not None]
    if subject.node is not None:
        impact.launch_files += _starts(subject.node)
        impact.parameter_files += _parameter_files(system, subject.node)
        return
    impact.launch_files += _remaps(system, subject)
    for end in _ends(subject):
        impact.parameter_files += _values(system, end)


def _ends(subject: Subject) -> list[Endpoint]:
    connection = subject.leaving[0].connection
    return [] if connection is None else [*connection.providers, *connection.users]


def _starts(node: Node) -> Iterator[Mentioned]:
    """The launch file that starts a node, and what it renames there."""
    if node.started is not None:
        yield Mentioned(node.started.place, "starts it")
        for remap in node.started.remaps:
            yield Mentioned(remap.place, f"remaps {remap.source.text or '?'} to {remap.target.text or '?'}")


def _parameter_files(system: System, node: Node) -> Iterator[Mentioned]:
    """The sections of parameter files that are for a node."""
    for use in () if node.started is None else files_among(node.started.parameters):
        source = use.reference.source
        if source is None or system.workspace is None:
            continue
        for section in system.workspace.parameters_of(source).sections:
            if key_matches(section.key, node.name):
                yield Mentioned(Place.of(source, section.span), f"sets its parameters under {section.written}")


def _remaps(system: System, subject: Subject) -> Iterator[Mentioned]:
    """The remappings that lead to a name."""
    for end in _ends(subject):
        remap = remap_of(end)
        if remap is not None:
            words = f"remaps {remap.source.text or '?'} of {end.node.name or '?'} to it"
            yield Mentioned(remap.place, words)
    for node in system.nodes:
        targets = {full: source for source, full in remapped_names(node)} if node.external else {}
        if subject.name in targets and node.started is not None:
            words = (
                f"remaps {targets[subject.name]} of {node.name or node.executable or '?'} to it; its source is not here"
            )
            yield Mentioned(node.started.place, words)


def _values(system: System, end: Endpoint) -> Iterator[Mentioned]:
    """Where a launch file or a parameter file sets the parameter that names an end."""
    if end.parameter is None or end.node.started is None or system.workspace is None:
        return
    for setting in applied(end.node.started, end.node.name, system.workspace.parameters_of):
        if setting.name == end.parameter:
            yield Mentioned(setting.place, f"names it in the parameter {setting.name} of {end.node.name or '?'}")


def _of_interface(workspace: WorkspaceIndex, systems: Sequence[System], interface: str) -> Impact:
    impact = Impact("interface", interface)
    impact.uses = uses_of(workspace, systems, interface)
    own = interface.partition("/")[0]
    dependent = {
        package for system in systems for package, needs in system.package_dependencies.items() if own in needs
    }
    users = {use.package for use in impact.uses if use.package is not None}
    impact.packages = [package for package in {own, *dependent, *users} if package in workspace.packages]
    return impact


def _tidy(impact: Impact) -> None:
    """Each thing once, in the order of the source."""
    impact.systems = list(dict.fromkeys(impact.systems))
    impact.direct = _once(impact.direct)
    known = {(effect.node, effect.place) for effect in impact.direct}
    impact.further = [effect for effect in _once(impact.further) if (effect.node, effect.place) not in known]
    impact.launch_files = sorted(set(impact.launch_files))
    impact.parameter_files = sorted(set(impact.parameter_files))
    impact.packages = sorted(set(impact.packages))


def _once(effects: Iterable[Effect]) -> list[Effect]:
    """Of effects at one place on one node that of which there is the least doubt."""
    best: dict[tuple[object, ...], Effect] = {}
    for effect in sorted(effects, key=lambda effect: effect.sort_key):
        best.setdefault((effect.node, effect.place, effect.name), effect)
    return list(best.values())


__all__ = ["Impact", "Mentioned", "impacts_of"]

"""LCH002: remappings of a launch file that do nothing."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import astuple, replace
from functools import partial
from typing import TYPE_CHECKING

from archlint.analysis.completeness import is_complete
from archlint.analysis.declared_parameters import always_declared
from archlint.analysis.kept import kept, once
from archlint.checks.folding import folds, with_places
from archlint.checks.launched_names import rejection_of
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.finding import Finding, Related
from archlint.launch_files.chosen_names import program_is_chosen
from archlint.model import EntityKind
from archlint.records import dataclass
from archlint.ros import names
from archlint.ros.well_known import OF_EVERY_NODE, OF_TRANSFORMS
from archlint.suggestions import did_you_mean, listed
from archlint.systems.instances import instantiate
from archlint.systems.resolution import endpoint_name

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.launch.model import Launched
    from archlint.launch.started import Remap, Started
    from archlint.systems.model import System, WorkspaceIndex
    from archlint.systems.nodes import Node


@rule("LCH002", scope=Scope.AS_LAUNCHED)
def dead_remapping(system: System, options: Options) -> Iterator[Finding]:
    """Remappings whose source is no name of any node of the process."""
    if system.launched is None:
        return
    for started, nodes in _by_started(system):
        # Of a program that arguments choose the default need not be the one that has the name.
        if all(_has_all_names(node) for node in nodes) and not program_is_chosen(system.launched, started):
            for remap in started.remaps:
                dead = None if remap.group else _dead(system, remap, nodes, started)
                if dead is None or _live_elsewhere(system, remap):
                    continue
                if _is_container(started):
                    if not _is_done_by_another(system.launched, started, remap):
                        yield replace(_finding(remap, nodes, dead), help=_ON_THE_COMPONENT)
                else:
                    yield _finding(remap, nodes, dead)


_ON_THE_COMPONENT = "write it on the ComposableNode: a container does not pass its remappings on"


def _is_container(started: Started) -> bool:
    executable = started.executable.text or ""
    return started.package.text == "rclcpp_components" and executable.startswith("component_container")


def _is_done_by_another(launched: Launched, started: Started, remap: Remap) -> bool:
    """Whether something else that the launch file starts has a remapping of the same name: that of a container, as Nav2
    writes it, is a copy then, and what it is meant for comes about."""
    others = (other for other in launched.started if other is not started)
    return any(row.source.text == remap.source.text for other in others for row in other.remaps)


def _by_started(system: System) -> list[tuple[Started, list[Node]]]:
    """What a launch file starts of code that is here, each with its nodes, and what they may have in it."""
    by_started: dict[int, tuple[Started, list[Node]]] = {}
    for node in system.entries:
        if node.started is not None and not node.is_stranger:
            by_started.setdefault(id(node.started), (node.started, []))[1].append(node)
    return list(by_started.values())


def _has_all_names(node: Node) -> bool:
    """Whether a node has no name but those that are known."""
    if node.external:
        return node.known is not None and node.known.complete and all(end.resolved for end in node.endpoints)
    return is_complete(node)


def _live_elsewhere(system: System, remap: Remap) -> bool:
    """Whether the same line may do something where another launch file includes this one, say in a namespace."""
    rows = [] if system.workspace is None else _by_place(system.workspace).get(remap.place, [])
    for other, other_remap, started, nodes in rows:
        if other is system:
            continue
        if not all(_has_all_names(node) for node in nodes) or _dead(other, other_remap, nodes, started) is None:
            return True
    return False


@once
def _by_place(workspace: WorkspaceIndex) -> dict[Place, list[tuple[System, Remap, Started, list[Node]]]]:
    """The remappings of all launch files by the line that says them, each with the process that it is for."""
    rows: dict[Place, list[tuple[System, Remap, Started, list[Node]]]] = {}
    for system in workspace.systems:
        for started, nodes in _by_started(system) if system.launched is not None else ():
            for remap in started.remaps:
                rows.setdefault(remap.place, []).append((system, remap, started, nodes))
    return rows


_PLAIN_SOURCE = re.compile(r"~?/?[A-Za-z_][\w/]*")


@dataclass(frozen=True)
class _Dead:
    """The full name that a remapping of ``source`` is for, and the names that the nodes have instead."""

    source: str
    expanded: str
    known: frozenset[str]


def _dead(system: System, remap: Remap, nodes: list[Node], started: Started) -> _Dead | None:
    """What is wrong with a remapping; None where it may do something."""
    source = remap.source.text
    if source is None or remap.source.resolution != "exact" or not _PLAIN_SOURCE.fullmatch(source):
        return None
    # One that says the name again is a note, and what rcl rejects ends the process: NME002 tells of it.
    if source.startswith("__") or source == remap.target.text or rejection_of(remap) is not None:
        return None
    known: set[str] = set()
    expanded = ""
    for node in nodes:
        own = kept(system, (_before_remapping, id(node)), partial(_before_remapping, node, started))
        if own is None:
            return None
        names_of_node, name, namespace = own
        full = names.expand(source, name, namespace)
        if not isinstance(full, str) or full in names_of_node or _implicit(full, name, namespace):
            return None
        expanded = full
        known |= names_of_node
        target = names.expand(remap.target.text or "", name, namespace)
        if remap.target.resolution == "exact" and target in names_of_node:
            return None  # it says what the node has anyway, as one that says the name again does
    if _is_for_another_value(system, source, nodes, started) or _is_of_no_clock(source, nodes):
        return None
    return _Dead(source, expanded, frozenset(known))


def _is_of_no_clock(source: str, nodes: Sequence[Node]) -> bool:
    """Whether a remapping is for ``clock``, which none of the nodes hears: they go by the time of the computer."""
    return source == "clock" and not any(node.overrides.get("use_sim_time") is True for node in nodes)


def _is_for_another_value(system: System, source: str, nodes: Sequence[Node], started: Started) -> bool:
    """Whether the same action has a name where a parameter has another value than is set now, or where another of an
    argument's ``choices`` is the executable."""
    if system.workspace is None:
        return False
    classes = {node.blueprint.place for node in nodes if node.blueprint is not None}
    others = _other_executables(system, started)
    for node in _of_all_code(system.workspace):
        is_other = node.package == started.package.text and not others.isdisjoint(node.executables)
        if node.blueprint is None or not (node.blueprint.place in classes or is_other):
            continue
        plain = instantiate(node.blueprint, node.program, name=started.name, namespace=started.namespace)
        namespace, _, name = (plain.name or "").rpartition("/")
        full = names.expand(source, name, namespace or "/")
        if any(end.name == full and end.creation.name.parameter is None for end in plain.endpoints):
            return True
    return False


def _other_executables(system: System, started: Started) -> set[str]:
    """What an action starts for the other choices of the argument that names its executable."""
    own = started.executable.text
    rows = [] if system.launched is None else system.launched.declared
    chosen = [row for row in rows if own in row.choices and row.default is not None and row.default.text == own]
    return {choice for row in chosen for choice in row.choices if choice != own}


@once
def _of_all_code(workspace: WorkspaceIndex) -> list[Node]:
    """The nodes of the code as no launch file starts them: what a parameter decides is open there."""
    return [node for system in workspace.systems if system.launched is None for node in system.entries]


def _finding(remap: Remap, nodes: list[Node], dead: _Dead) -> Finding:
    is_name = "/" not in dead.source.strip("/") and not dead.source.startswith("/")
    shown = [name.rpartition("/")[2] if is_name else name for name in dead.known]
    node_name, hint = nodes[0].name, did_you_mean(dead.source, shown)
    parameter = _parameter_meant(nodes, dead.source)
    return finding(
        "LCH002",
        remap.place,
        f"{node_name} has no name '{dead.expanded}', so this remapping has no effect{hint}",
        help=_advice(nodes, dead, hint) if parameter is None else _as_parameter(remap, parameter),
        node=node_name,
        identity=(node_name or "", dead.expanded),
        group=() if hint or parameter is not None else _source_of(nodes[0]),
    )


def _source_of(node: Node) -> tuple[str, ...]:
    """What the same node has in common in all launch files: its class, or the executable of an external one."""
    if node.blueprint is not None:
        return *map(str, astuple(node.blueprint.place)), node.blueprint.class_name
    started = node.started
    package, executable = (None, None) if started is None else (started.package.text, started.executable.text)
    return (package, executable, node.name) if package and executable and node.name else ()


def _parameter_meant(nodes: Sequence[Node], source: str) -> str | None:
    """The parameter of one of the nodes that a remapping names."""
    name = source.removeprefix("~/").strip("/").replace("/", ".")
    declared = any(name == row.name.text for node in nodes for row in node.parameters)
    return name if declared or always_declared(name) else None


def _as_parameter(remap: Remap, name: str) -> str:
    if remap.place.file.endswith(".py"):
        return f"'{name}' is a parameter: set it with parameters=[{{'{name}': …}}]"
    return (
        f"'{name}' is a parameter: set it with <param>"
        if remap.place.file.endswith(".xml")
        else (f"'{name}' is a parameter: set it under param:")
    )


_TOPICS = (EntityKind.PUBLISHER, EntityKind.SUBSCRIBER)


def _advice(nodes: Sequence[Node], dead: _Dead, hint: str) -> str:
    """A name of the node that may be meant; the only one that it has is no advice where it is nothing like it, nor are
    those of a well-known node.  Of two names that are nearly alike either may be the slip."""
    if dead.expanded == nodes[0].name:
        return "remove it, or rename the node with name=: a remapping is for topics, services and actions"
    if (full := f"/{dead.source}") in OF_EVERY_NODE:
        return f"write '{full}', which every node has by this name in any namespace, or remove it"
    own = sorted(name for name in dead.known if "/_action/" not in name)
    last = dead.source.rpartition("/")[2]
    is_alike = hint or any(name.endswith(f"/{last}") for name in own)
    if own and not is_alike and not any(end.kind in _TOPICS for node in nodes for end in node.endpoints):
        return f"remove it; the node has no topics, only {listed(own)}"
    if own and not is_alike and all(node.blueprint is None for node in nodes):
        return f"remove it, or move it to the node that has the name; this one has {listed(own)}"
    if len(own) > 1 or is_alike:
        return f"use a full name of the node: {listed(own)}" + (", or correct that one" if hint else "")
    return f"remove it; the only name of the node is {own[0]}" if own else "remove it; the node has no names"


@folds("LCH002", across_systems=True)
def _of_one_node(several: Sequence[Finding]) -> Finding:
    """One finding for all dead remappings of a node, in however many launch files: the next is a copy of the first."""
    names = list(dict.fromkeys(diagnostic.identity[1] for diagnostic in several))
    if len(names) == 1:
        return with_places(several, "it is remapped here, too")
    first, *others = several
    rows = tuple(Related(other.place, f"'{other.identity[1]}'") for other in others)
    return replace(
        first,
        message=f"{first.node} has none of these {len(names)} names, so these remappings have no effect: "
        f"{listed(names)}",
        related=(*first.related, *rows),
        identity=(first.identity[0], *names),
    )


def _before_remapping(node: Node, started: Started) -> tuple[set[str], str, str] | None:
    """The names of a node without the launch file's remappings, its own name and its namespace."""
    named = _plain_names(node, started)
    if named is None:
        return None
    full, ends = named
    namespace, _, name = full.rpartition("/")
    full_names: set[str] = set()
    for kind, end in ends:
        if end is None:
            return None
        full_names.add(end)
        if kind in (EntityKind.ACTION_SERVER, EntityKind.ACTION_CLIENT):
            full_names.update(names.action_entities(end).values())
    return full_names, name, namespace or "/"


def _plain_names(node: Node, started: Started) -> tuple[str, list[tuple[EntityKind, str | None]]] | None:
    """The full name that a node has, and those of its ends, where nothing is remapped."""
    if node.name is None:
        return None
    if node.blueprint is not None:
        plain = instantiate(node.blueprint, node.program, name=started.name, namespace=started.namespace)
        ends = [(end.kind, end.name) for end in plain.endpoints]
        return None if plain.name is None else (plain.name, ends)
    own = node.own
    if own is None or any(end.creation.name.parameter is not None for end in node.endpoints):
        return None
    return node.name, [(end.kind, endpoint_name(end.creation.name, end.kind, own, ()).name) for end in node.endpoints]


_SERVICES = frozenset(
    {
        "describe_parameters",
        "get_parameters",
        "get_parameter_types",
        "list_parameters",
        "set_parameters",
        "set_parameters_atomically",
        "get_logger_levels",
        "set_logger_levels",
        "get_type_description",
        "transition_event",
        "change_state",
        "get_state",
        "get_available_states",
        "get_available_transitions",
        "get_transition_graph",
    }
)


def _implicit(full: str, name: str, namespace: str) -> bool:
    """Names that rclpy gives every node.  Remapping /tf is a habit that harms nobody."""
    if full in OF_EVERY_NODE or full[full.rindex("/") :] in OF_TRANSFORMS:
        return True
    below = names.join(namespace, name) + "/"
    return full.startswith(below) and full[len(below) :] in _SERVICES

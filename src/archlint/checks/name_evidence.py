"""Which absolute names NME001 tells, and what the source shows to speak against them."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING

from archlint.analysis.kept import once
from archlint.checks.foreign_names import is_foreign
from archlint.checks.lessons_about_names import is_lesson_about_names, namespace_of
from archlint.checks.name_reasons import (
    FIXED,
    INSTANCES,
    REPEATED,
    Reason,
    beside_relative,
    for_each_instance,
    in_namespace,
    parted_from,
    unlike_another,
)
from archlint.model import EntityKind
from archlint.records import dataclass
from archlint.ros.well_known import ABSOLUTE, BY_CLICK
from archlint.systems.nodes import key_of

if TYPE_CHECKING:
    from archlint.model import Blueprint
    from archlint.systems.model import System, WorkspaceIndex
    from archlint.systems.nodes import Endpoint

Home = tuple[str, str]
"""The file and the class that a name is fixed in; the class is empty where there is none."""
_ROOT = frozenset({""})
_PROVIDES = frozenset({EntityKind.PUBLISHER, EntityKind.SERVICE, EntityKind.ACTION_SERVER})


@dataclass(frozen=True)
class FixedName:
    """A name that is fixed in the code of a class."""

    home: Home
    endpoint: Endpoint
    reason: Reason

    @property
    def text(self) -> str:
        return self.endpoint.written or ""

    @property
    def has_namespace(self) -> bool:
        """Whether it puts its topic into a namespace, as ``/robot/scan`` does and ``/scan`` does not."""
        return self.text.startswith("/") and "/" in self.text[1:]

    @property
    def is_own(self) -> bool:
        """Whether it is written in the file of the node, and not in one of constants."""
        return self.home[0] == self.endpoint.place.file

    @property
    def is_absolute(self) -> bool:
        """Whether it is, and nothing but the names around it can say why."""
        return self.reason.key == FIXED.key

    @property
    def is_relative(self) -> bool:
        """Whether it follows the namespace of the node, and not its name as well (``~/state``)."""
        return self.is_own and not self.text.startswith(("/", "~"))


def told(system: System, names: Sequence[FixedName], everywhere: bool) -> list[tuple[FixedName, Reason | None]]:
    """The names that are worth a finding, each with what speaks against the form that it has.

    Absolute names are how the robot of a workspace is built: with a bus that a fleet shares, or for a robot that is
    alone.  Only one whose other end is relative fits no robot: a namespace parts the two.  It is a slip where no class
    that has it has other absolute names; one that has some stays where it is in any namespace.  Who learns, in a small
    workspace that starts nothing but its own nodes, also hears of what else speaks against absolute names, and so does
    who wants to be told of all, ``everywhere``.
    """
    if everywhere or is_lesson_about_names(system):
        return _told_of_all(system.workspace, names, everywhere)
    parted = _without_exceptions(_well_founded(system.workspace, _parted(system.workspace, names), names), names)
    kept = _with_other_absolute_names(names, parted)
    meant = {_end_of(name) for name in names if name.home in kept}
    return [
        (name, parted.get(_end_of(name)))
        for name in names
        if name.text[:1] != "/" or (_end_of(name) in parted and _end_of(name) not in meant)
    ]


def _well_founded(
    workspace: WorkspaceIndex | None, parted: dict[tuple[str, str | None], Reason], names: Iterable[FixedName]
) -> dict[tuple[str, str | None], Reason]:
    """The names that two other ends at least, in packages, have as relative ones: of two ends that differ either may
    be meant, and where no launch file has a namespace it does not matter which."""
    if workspace is None or any(namespace for namespace, _ in _started_in(workspace)):
        return parted
    relative = {
        (f"/{name.text}", name.endpoint.type, name.endpoint.place)
        for name in names
        if name.is_relative and (not workspace.manifests or workspace.package_of(name.endpoint.place.file) is not None)
    }
    ends = Counter((text, type) for text, type, _ in relative)
    return {end: reason for end, reason in parted.items() if ends[end] > 1}


def _without_exceptions(
    parted: Mapping[tuple[str, str | None], Reason], names: Iterable[FixedName]
) -> dict[tuple[str, str | None], Reason]:
    """The names but for those of a family, such as all that begin with ``/robot/``, of which more are absolute than
    relative: there, the relative end is what does not fit."""
    written = {(name.text, name.is_absolute) for name in names if name.is_absolute or name.is_relative}
    begins = Counter((_family(text), absolute) for text, absolute in written if "/" in text[1:])
    return {
        (text, type): reason
        for (text, type), reason in parted.items()
        if "/" not in text[1:] or begins[_family(text), True] - 1 <= begins[_family(text), False]
    }


def _family(text: str) -> str:
    return text.strip("/").partition("/")[0]


def _with_other_absolute_names(
    names: Sequence[FixedName], parted: Mapping[tuple[str, str | None], Reason]
) -> set[Home]:
    """The classes with an absolute name whose other end is not relative, be it one that something outside of the code
    chooses, but for those that ROS itself makes absolute: dropping one '/' leaves the node where it is."""
    kept: set[Home] = set()
    for name in names:
        ends = [end for end in name.endpoint.node.endpoints if end.creation.name.resolution == "exact"]
        written = {(end.written or "", end.type) for end in ends if end.written not in ABSOLUTE | BY_CLICK}
        if any(text.startswith("/") and (text, kind) not in parted for text, kind in (_end_of(name), *written)):
            kept.add(name.home)
    return kept


def _told_of_all(
    workspace: WorkspaceIndex | None, names: Sequence[FixedName], everywhere: bool
) -> list[tuple[FixedName, Reason | None]]:
    """The names that launch files or relative names around them speak against, those of classes that have names of both
    forms, and of classes with the namespace of one robot in a name; or ``everywhere`` all of them."""
    by_home: dict[Home, list[FixedName]] = {}
    for name in names:
        by_home.setdefault(name.home, []).append(name)
    started = {home: reason for home, rows in by_home.items() if (reason := _as_started(workspace, rows)) is not None}
    others = {home: rows for home, rows in by_home.items() if home not in started}
    evidence = {**_mixed(others), **_in_namespace(workspace, others), **_relative_elsewhere(others)}
    fixed = {home for home, rows in others.items() if everywhere or any(name.has_namespace for name in rows)}
    chosen = _linked(others, [*evidence, *(home for home in fixed if not _is_tied(workspace, others[home]))])
    against = {**evidence, **started}
    return [
        (name, reason if (reason := against.get(name.home)) is not None and _is_of(reason, name) else None)
        for name in names
        if _is_told(workspace, name, started.get(name.home), name.home in chosen)
    ]


def _end_of(name: FixedName) -> tuple[str, str | None]:
    """What a name stands for: the two ends of a topic have it in common with its type."""
    return name.text, name.endpoint.type


def _parted(workspace: WorkspaceIndex | None, names: Iterable[FixedName]) -> dict[tuple[str, str | None], Reason]:
    """The absolute names whose other end has them as relative ones, if both meet as the launch files start them: in a
    namespace they do not.  Where more classes have the name as an absolute one, that is how it is meant."""
    ends: dict[tuple[str, str | None], list[FixedName]] = {}
    for name in names:
        if name.is_absolute or name.is_relative:
            ends.setdefault((name.text.removeprefix("/"), name.endpoint.type), []).append(name)
    parted: dict[tuple[str, str | None], Reason] = {}
    for (text, type), rows in ends.items():
        absolute = [name for name in rows if name.is_absolute]
        relative = [name for name in rows if name.is_relative]
        other = next((name for name in relative if any(_talk(workspace, end, name) for end in absolute)), None)
        if other is not None and len({name.home for name in absolute}) <= len({name.home for name in relative}):
            parted[f"/{text}", type] = parted_from(text, other.endpoint.place)
    return parted


_OTHER_END = {
    EntityKind.PUBLISHER: EntityKind.SUBSCRIBER,
    EntityKind.SERVICE: EntityKind.CLIENT,
    EntityKind.ACTION_SERVER: EntityKind.ACTION_CLIENT,
}
_OTHER_END |= {other: kind for kind, other in _OTHER_END.items()}


def _talk(workspace: WorkspaceIndex | None, absolute: FixedName, relative: FixedName) -> bool:
    """Whether two names are the ends of one connection, however launch files start the nodes."""
    kinds = _OTHER_END[absolute.endpoint.kind], relative.endpoint.kind
    if absolute.home == relative.home or kinds[0] != kinds[1]:
        return False
    blueprint = relative.endpoint.node.blueprint
    if workspace is None or blueprint is None:
        return True
    launched = workspace.launched_names(blueprint, relative.endpoint.kind, relative.endpoint.place)
    return launched <= {absolute.text} and namespaces_of(workspace, absolute.endpoint.node.blueprint) == _ROOT


def _is_of(reason: Reason, name: FixedName) -> bool:
    """Whether what speaks against the names of a class does so against this one."""
    return name.is_absolute and (reason.place is None or name.text[1:] == reason.other)


def _is_told(workspace: WorkspaceIndex | None, name: FixedName, started: Reason | None, is_chosen: bool) -> bool:
    if not name.text.startswith("/"):
        return True
    if started is not None and started.key == INSTANCES and name.is_absolute:
        return _instances(workspace, name.endpoint) > 1
    return started is not None or is_chosen


def _is_tied(workspace: WorkspaceIndex | None, names: Iterable[FixedName]) -> bool:
    """Whether a node with these names has another that something outside of the workspace fixes: a second one cannot be
    started beside it, whatever becomes of these."""
    ends = (end for node in {name.endpoint.node for name in names} for end in node.endpoints)
    return any((end.written or "").startswith("/") and is_foreign(workspace, end) for end in ends)


def _linked(homes: Mapping[Home, Sequence[FixedName]], evidence: Iterable[Home]) -> set[Home]:
    """The classes that something speaks against, and those that have a name with one of them in common: where one drops
    its '/', the others have to."""
    users: dict[str, list[Home]] = {}
    for home, rows in homes.items():
        for name in rows:
            if name.text.startswith("/"):
                users.setdefault(name.text, []).append(home)
    linked, waiting = set(evidence), list(evidence)
    while waiting:
        shared = [users.pop(name.text, []) for name in homes[waiting.pop()]]
        new = {home for group in shared for home in group} - linked
        linked |= new
        waiting += new
    return linked


def namespaces_of(workspace: WorkspaceIndex | None, blueprint: Blueprint | None) -> frozenset[str]:
    """The namespaces that launch files start a node in, the root where none starts it."""
    if workspace is None or blueprint is None:
        return _ROOT
    return workspace.namespaces.get(key_of(blueprint), _ROOT)


def is_needed_outside(workspace: WorkspaceIndex | None, endpoint: Endpoint) -> bool:
    """Whether launch files start a node in namespaces only, and a node that is in none of these has its absolute name,
    too, or must have it: without the '/', the two would no longer meet."""
    given = namespaces_of(workspace, endpoint.node.blueprint)
    if workspace is None or "" in given:
        return False
    users = _namespaces_of_users(workspace).get(endpoint.written or "", frozenset())
    return not users <= given or _is_provided_outside(workspace, endpoint, given)


def _is_provided_outside(workspace: WorkspaceIndex, endpoint: Endpoint, given: frozenset[str]) -> bool:
    """Whether a node that is alone in its namespaces takes in what no code of the workspace provides: a driver or a
    simulator does, elsewhere."""
    if endpoint.kind in _PROVIDES or (endpoint.written or "").lstrip("/") in _provided_by_code(workspace):
        return False
    around = {
        started
        for namespace, started in _started_in(workspace)
        if any(f"{namespace}/".startswith(f"{own}/") for own in given)
    }
    blueprint = endpoint.node.blueprint
    return blueprint is not None and around == {key_of(blueprint)}


@once
def _provided_by_code(workspace: WorkspaceIndex) -> frozenset[str]:
    """The names that code publishes or serves under, without their '/'."""
    code = (system for system in workspace.systems if system.name is None)
    ends = (end for system in code for end in system.endpoints if end.kind in _PROVIDES)
    return frozenset((end.written or "").lstrip("/") for end in ends)


@once
def _started_in(workspace: WorkspaceIndex) -> frozenset[tuple[str, object]]:
    """The namespaces in which launch files start nodes, each with a node: by :func:`key_of`, or its start where its
    source is not here."""
    return frozenset(
        (namespace_of(node), id(node.started) if node.blueprint is None else key_of(node.blueprint))
        for system in workspace.systems
        if system.launched is not None
        for node in system.nodes
    )


@once
def _namespaces_of_users(workspace: WorkspaceIndex) -> Mapping[str, frozenset[str]]:
    """The namespaces of the nodes whose code has each absolute name."""
    users: dict[str, set[str]] = {}
    for node in (node for system in workspace.systems if system.name is None for node in system.nodes):
        given = namespaces_of(workspace, node.blueprint)
        for end in node.endpoints:
            if (end.written or "").startswith("/"):
                users.setdefault(end.written or "", set()).update(given)
    return {name: frozenset(given) for name, given in users.items()}


def _in_namespace(workspace: WorkspaceIndex | None, homes: Mapping[Home, Sequence[FixedName]]) -> dict[Home, Reason]:
    """The classes whose node launch files start in one namespace, which their names do not follow."""
    reasons: dict[Home, Reason] = {}
    for home, rows in homes.items():
        blueprints = [name.endpoint.node.blueprint for name in rows if name.is_absolute]
        given = {namespace for blueprint in blueprints for namespace in namespaces_of(workspace, blueprint)}
        if len(given) == 1 and "" not in given and "?" not in given:
            reasons[home] = in_namespace(*given)
    return reasons


def _as_started(workspace: WorkspaceIndex | None, names: Sequence[FixedName]) -> Reason | None:
    """What launch files show of the names of a class."""
    repeated = next((name.reason for name in names if name.reason.key == REPEATED), None)
    if repeated is not None:
        return repeated
    count = max((_instances(workspace, name.endpoint) for name in names if name.is_absolute), default=0)
    return for_each_instance(count) if count > 1 else None


def _mixed(classes: Mapping[Home, Sequence[FixedName]]) -> dict[Home, Reason]:
    """The classes that have names of both forms."""
    relative = {home: [name.text for name in names if name.is_relative] for home, names in classes.items()}
    return {
        home: beside_relative(min(relative[home]))
        for home, names in classes.items()
        if relative[home] and any(name.is_absolute and name.is_own for name in names)
    }


def _instances(workspace: WorkspaceIndex | None, endpoint: Endpoint) -> int:
    """How many starts of one launched system provide the same under the name of an endpoint; what each of them only
    listens to or asks may well be one for all."""
    blueprint = endpoint.node.blueprint
    if workspace is None or blueprint is None:
        return 0
    return _provided(workspace).get((key_of(blueprint), endpoint.kind, endpoint.written), 0)


@once
def _provided(workspace: WorkspaceIndex) -> Mapping[tuple[object, EntityKind, str | None], int]:
    """How many times a launch file starts a node of one kind, by :func:`key_of`, that provides something under a name.
    Several that one process makes, perhaps one after the other, are started once."""
    most: Counter[tuple[object, EntityKind, str | None]] = Counter()
    for system in workspace.systems:
        nodes = [node for node in system.nodes if system.launched is not None and not node.alternatives]
        provided = {
            (id(node.started), key_of(node.blueprint), end.kind, end.name)
            for node in nodes
            if node.blueprint is not None
            for end in node.endpoints
            if end.kind in _PROVIDES
        }
        most |= Counter((key, kind, name) for _, key, kind, name in provided)
    return most


def _relative_elsewhere(homes: Mapping[Home, Sequence[FixedName]]) -> dict[Home, Reason]:
    """The classes with an absolute name that another class has as a relative one."""
    users: dict[tuple[str, str | None], dict[Home, FixedName]] = {}
    for home, rows in homes.items():
        for name in rows:
            if name.is_relative:
                users.setdefault((name.text, name.endpoint.type), {}).setdefault(home, name)
    reasons: dict[Home, Reason] = {}
    for home, rows in homes.items():
        for name in rows:
            others = users.get((name.text[1:], name.endpoint.type), {}) if name.is_absolute else {}
            other = next((user for user_home, user in others.items() if user_home != home), None)
            if other is not None:
                reasons.setdefault(home, unlike_another(other.text, other.endpoint.place))
    return reasons


__all__ = ["FixedName", "Home", "is_needed_outside", "namespaces_of", "told"]

"""Nodes whose source is not here, with what is known of them from elsewhere: the table of well-known nodes, and the
configuration."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import field
from typing import TYPE_CHECKING

import msgspec

from archlint.launch.parameter_sources import ParameterSetting
from archlint.model import Blueprint, Creation, EntityKind, ExecutorKind, ParameterDeclaration, Text
from archlint.records import dataclass
from archlint.ros import external_nodes
from archlint.ros.distros import DISTROS
from archlint.ros.qos import Qos
from archlint.systems.bridged import bridged_ends, ends_of_arguments, is_bridge, is_told_all
from archlint.systems.nodes import KnownExternal

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.launch.started import Started
    from archlint.ros.external_nodes import ExternalEnd, ExternalNode, ExternalParameter, ExternalQos, Programs

API = "external node"
"""What stands for the create call of an end that no code of the workspace makes."""


@dataclass(frozen=True)
class ExternalSources:
    """Where to look up what is not here: what the configuration says comes first."""

    configured: Programs = field(default_factory=dict)
    well_known: Callable[[], Programs] = external_nodes.well_known

    def nodes(self, started: Started, distro: str | None) -> Sequence[ExternalNode]:
        """The nodes of what a launch file starts; empty where nothing is known of it."""
        package, executable = started.package.text, started.executable.text
        if package is None or executable is None:
            return ()
        program = (package, executable)
        return _of_one_distro(self.configured.get(program) or self.well_known().get(program, ()), distro)


def _of_one_distro(rows: Sequence[ExternalNode], distro: str | None) -> Sequence[ExternalNode]:
    """The nodes that a program has in a distribution, or where none is asked for in the newest that was read: another
    may call them otherwise."""
    if distro is None or not any(distro in row.versions for row in rows):
        newest = [name for name in DISTROS if any(name in row.versions for row in rows)]
        distro = newest[-1] if newest else None
    return [row for row in rows if distro is None or distro in row.versions or not row.versions]


NO_EXTERNAL_NODES = ExternalSources(well_known=dict)


def blueprint_of(row: ExternalNode, started: Started, distro: str | None) -> tuple[Blueprint, KnownExternal]:
    """A node of the table as a launch file starts it, before that renames or remaps anything, in one distribution or
    in whichever of those that have it."""
    asked = tuple(row.versions) if distro is None else (distro,)
    read = distro is None or distro in row.versions or not row.versions
    blueprint = Blueprint(
        class_name=row.executables[0],
        name=_text(row.name),
        namespace=Text(row.namespace, "exact"),
        place=started.place,
        package=row.package,
        lifecycle=row.lifecycle,
        executor=ExecutorKind.UNKNOWN,
    )
    every = [*_ends_in(row.ends, asked, read), *ends_of_arguments(started)]
    bridges = is_bridge(started)
    if bridges:
        every += bridged_ends(started)
    blueprint.creations.extend(_creation(end, blueprint, started.place) for end in every)
    blueprint.parameters.extend(_declarations(row.parameters, blueprint, started.place, asked))
    questions = () if bridges and is_told_all(started) else row.open
    reasons = [
        question.reason
        for question in questions
        if _is_in(question.distros, asked)
        and (question.parameter is None or may_be_set(question.parameter, started) or not read)
    ]
    if not read:
        reasons.append(f"its source in {distro} was not read")
    versions = row.versions if distro is None or not read else {distro: row.versions.get(distro, "")}
    any_parameter = row.takes_any_parameter or not read
    name = None if row.own_name else row.name
    known = KnownExternal(row.source, dict(versions), tuple(reasons), any_parameter, row.conditional, name)
    return blueprint, known


def may_be_set(name: str, started: Started) -> bool:
    """Whether a launch file may give a process this parameter."""
    if started.may_read_arguments_for_ros:
        return True
    return any(
        not isinstance(row, ParameterSetting) or row.sets_anything or row.name == name for row in started.parameters
    )


def _text(name: str | None) -> Text:
    return (
        Text(None, "unknown", reason="its source does not say what it is called")
        if name is None
        else Text(name, "exact")
    )


def _is_in(distros: Sequence[str], asked: Sequence[str]) -> bool:
    return not distros or not asked or any(distro in distros for distro in asked)


def _ends_in(ends: Iterable[ExternalEnd], asked: Sequence[str], read: bool) -> Iterator[ExternalEnd]:
    """The ends that a node has in some distributions: certain is what all of them have alike."""
    alike: dict[tuple[str, str, str | None], list[ExternalEnd]] = {}
    for end in ends:
        if not read or _is_in(end.distros, asked):
            alike.setdefault((end.kind, end.name, end.parameter), []).append(end)
    for rows in alike.values():
        certain = {distro for row in rows if not row.conditional for distro in (row.distros or asked or ("",))}
        everywhere = read and (certain >= set(asked) if asked else bool(certain))
        types: list[str | None] = list(dict.fromkeys(row.type for row in rows if row.type is not None)) or [None]
        for type_name in types:
            same = [row for row in rows if row.type == type_name or (row.type is None and len(types) == 1)]
            yield msgspec.structs.replace(
                same[0],
                type=type_name,
                conditional=not everywhere or len(types) > 1,
                qos=_common_qos([row.qos for row in same]),
            )


def _common_qos(profiles: Sequence[ExternalQos | None]) -> ExternalQos | None:
    """What several distributions say alike of a profile."""
    first = profiles[0]
    if first is None or None in profiles:
        return None
    fields = ("history", "depth", "reliability", "durability")
    values = {name: {getattr(profile, name) for profile in profiles} for name in fields}
    return external_nodes.ExternalQos(
        **{name: getattr(first, name) if len(values[name]) == 1 else None for name in fields}
    )


def _creation(end: ExternalEnd, node: Blueprint, place: Place) -> Creation:
    qos = None
    if end.qos is not None:
        qos = Qos(end.qos.history, end.qos.depth, end.qos.reliability, end.qos.durability)
    resolution = "exact" if end.parameter is None else "parameter"
    return Creation(
        EntityKind(end.kind),
        API,
        node,
        place,
        Text(end.name, "exact") if resolution == "exact" else Text(end.name, "parameter", end.parameter),
        end.type,
        None if end.type is not None else "its source does not decide it",
        qos=qos,
        conditional=end.conditional,
    )


def _declarations(
    rows: Iterable[ExternalParameter], node: Blueprint, place: Place, asked: Sequence[str]
) -> Iterator[ParameterDeclaration]:
    by_name: dict[str, list[ExternalParameter]] = {}
    for row in rows:
        if _is_in(row.distros, asked):
            by_name.setdefault(row.name, []).append(row)
    for name, same in by_name.items():
        types = {row.type for row in same}
        defaults = [row.default for row in same]
        known = defaults[0] is not None and all(default == defaults[0] for default in defaults)
        everywhere = all(any(_is_in(row.distros, (distro,)) for row in same) for distro in asked)
        yield ParameterDeclaration(
            Text(name, "exact"),
            same[0].type if len(types) == 1 else None,
            defaults[0] if known else None,
            known,
            place,
            node,
            conditional=any(row.conditional for row in same) or not everywhere,
        )


__all__ = ["API", "NO_EXTERNAL_NODES", "ExternalSources", "blueprint_of"]

"""Load: from programs to a system of nodes under their final names."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Protocol

from archlint.model import (
    Blueprint,
    EntityKind,
    ExecutorKind,
    Program,
    Text,
)
from archlint.ros.remapping import RemapRule, rules_of_arguments
from archlint.systems.model import System
from archlint.systems.nodes import NamedCreation, Node
from archlint.systems.resolution import NodeName, endpoint_name, node_init
from archlint.workspace.closure import closure

if TYPE_CHECKING:
    from archlint.workspace.model import DependencyKind, Package, Workspace


class Settings(Protocol):
    """What is needed of the configuration."""

    @property
    def closed_world(self) -> bool: ...

    @property
    def distro(self) -> str | None: ...


class KnownNodes:
    """The nodes of the open system that earlier runs in the same process have made: programs that runs share do not
    change, and a node is a function of these and of the distribution that is configured."""

    def __init__(self) -> None:
        self._nodes: dict[tuple[object, ...], tuple[list[Twin], Node]] = {}
        """By the ids of what they are made of, which stays alive beside them."""

    def node(self, twins: list[Twin], distro: str | None) -> Node:
        """The node of these blueprints, which is made where it is not known."""
        key = (distro, *(id(part) for twin in twins for part in twin))
        if key not in self._nodes:
            self._nodes[key] = twins, _node_of_twins(twins, distro)
        return self._nodes[key][1]

    def forget_others(self, nodes: Iterable[Node]) -> None:
        """Keep these alone."""
        kept = set(map(id, nodes))
        self._nodes = {key: row for key, row in self._nodes.items() if id(row[1]) in kept}


def assemble(
    programs: Sequence[Program], workspace: Workspace, settings: Settings, known: KnownNodes | None = None
) -> list[System]:
    """Without launch files all nodes that the workspace can start make one system, each of them once."""
    known = known or KnownNodes()
    nodes = [known.node(twins, settings.distro) for twins in _twins(programs)]
    known.forget_others(nodes)
    return [
        System(
            name=None,
            nodes=sorted(nodes, key=_node_order),
            programs=list(programs),
            closed=settings.closed_world,
            package_dependencies=dependencies_within(workspace.packages),
        )
    ]


def instantiate(
    blueprint: Blueprint,
    program: Program | None,
    *,
    name: Text | str | None = None,
    namespace: Text | str | None = None,
    remaps: Sequence[RemapRule] = (),
    overrides: Mapping[str, object] | None = None,
    launched_by: str | None = None,
    distro: str | None = None,
) -> Node:
    """The node that ``blueprint`` becomes in one started process.

    ``name`` and ``namespace`` are what ``-r __node`` and ``-r __ns`` say (None: nothing), ``remaps`` the
    other rules of the process in the order of its command line, ``overrides`` parameter values by name; ``distro``
    is the one that is configured, if there is one.
    """
    local = rules_of_arguments(blueprint.cli_arguments)
    if not blueprint.use_global_arguments:
        name, namespace, remaps, overrides = None, None, (), None
    own = node_init(
        blueprint.name,
        blueprint.namespace,
        local,
        remaps,
        given_name=_text(name),
        given_namespace=_text(namespace),
    )
    executables = tuple(sorted(set(blueprint.executables)))
    overrides = dict(overrides or {})
    rules = tuple(rule.in_distro(distro) for rule in (*local, *remaps))
    return Node(
        # Whoever uses a helper may be any node of the process.
        name=None if blueprint.caller_unknown else own.full,
        blueprint=blueprint,
        package=blueprint.package,
        executable=executables[0] if executables else None,
        executor=blueprint.executor,
        launched_by=launched_by,
        program=program,
        overrides=overrides,
        resolution=own.resolution,
        error=own.error,
        executables=executables,
        own=own,
        rules=rules,
        creations=_named_creations(blueprint, overrides, own, rules),
    )


def _text(value: Text | str | None) -> Text | None:
    return Text(value, "exact") if isinstance(value, str) else value


def _named_creations(
    blueprint: Blueprint, overrides: Mapping[str, object], own: NodeName, rules: Sequence[RemapRule]
) -> tuple[NamedCreation, ...]:
    by_key: dict[tuple[object, ...], NamedCreation] = {}
    for creation in blueprint.creations:
        if creation.kind in _NO_ENDPOINT:
            continue
        text = _overridden(creation.name, blueprint, overrides)
        named = NamedCreation(creation, endpoint_name(text, creation.kind, own, rules))
        key = _key(named)
        if key not in by_key or by_key[key].creation.conditional:
            by_key[key] = named
    return tuple(sorted(by_key.values(), key=_order))


_NO_ENDPOINT = (EntityKind.TIMER, "guard_condition")


def _key(named: NamedCreation) -> tuple[object, ...]:
    """What distinguishes two endpoints of a node: one create call, reached on two ways with the same arguments,
    is one endpoint."""
    creation = named.creation
    callbacks = tuple(sorted((role, callback.name) for role, callback in creation.callbacks.items()))
    return (creation.place, creation.kind, named.final.name, creation.name.text, creation.type, callbacks)


def _order(named: NamedCreation) -> tuple[object, ...]:
    creation, name = named.creation, named.final.name
    return (name is None, name or "", creation.place, creation.kind, creation.type or "")


def _overridden(text: Text, blueprint: Blueprint, overrides: Mapping[str, object]) -> Text:
    """``text`` after the parameter that decides it is set from outside."""
    if text.parameter is None or text.parameter not in overrides:
        return text
    value = overrides[text.parameter]
    default = next((p.default for p in blueprint.parameters if p.name.text == text.parameter), None)
    if isinstance(value, str) and default == text.text:
        return Text(value, "parameter", text.parameter)
    reason = f"it is built from the parameter {text.parameter!r}, which a launch file or the command line may set"
    return Text(None, "unknown", text.parameter, reason)


Twin = tuple[Blueprint, Program]


def _twins(programs: Iterable[Program]) -> list[list[Twin]]:
    """Blueprints of all programs, those of one class (or create call) and one name together."""
    groups: dict[tuple[object, ...], list[Twin]] = {}
    for program in programs:
        for blueprint in program.nodes:
            text, namespace = blueprint.name.text, blueprint.namespace.text
            key = (blueprint.place, blueprint.class_name, text, namespace)
            groups.setdefault(key, []).append((blueprint, program))
    return list(groups.values())


def _node_of_twins(twins: list[Twin], distro: str | None) -> Node:
    """One node of all executables that start it.  What only tests do to it is left out."""
    ordered = sorted(twins, key=_twin_order)
    blueprint, program = ordered[0]
    node = instantiate(blueprint, program, distro=distro)
    real = [(twin, run) for twin, run in ordered if twin.test == blueprint.test]
    creations = {_key(named): named for named in node.creations}
    for twin, run in real[1:]:
        for named in instantiate(twin, run, distro=distro).creations:
            key = _key(named)
            if key not in creations or (creations[key].creation.conditional and not named.creation.conditional):
                creations[key] = named
    executables = tuple(sorted({name for twin, _ in real for name in twin.executables}))
    return replace(
        node,
        creations=tuple(sorted(creations.values(), key=_order)),
        executables=executables,
        executable=executables[0] if executables else None,
        executor=_common_executor([twin.executor for twin, _ in real]),
        merged=tuple(twin for twin, _ in ordered[1:]),
    )


def _twin_order(twin: Twin) -> tuple[object, ...]:
    blueprint, program = twin
    return (
        blueprint.test,
        blueprint.caller_unknown,
        not program.executable,
        program.package or "",
        program.name,
        program.file,
    )


def _common_executor(executors: Iterable[ExecutorKind]) -> ExecutorKind:
    """The executor that spins a node in every program that spins it."""
    spun = sorted({executor for executor in executors if executor != ExecutorKind.NONE})
    return ExecutorKind.NONE if not spun else spun[0] if len(spun) == 1 else ExecutorKind.UNKNOWN


def _node_order(node: Node) -> tuple[object, ...]:
    place = node.blueprint.place if node.blueprint else node.launch_place
    where = (place.file, place.line, place.column) if place else ("", 0, 0)
    return (node.name is None, node.name or "", *where, node.blueprint.class_name if node.blueprint else "")


_NEEDED_TO_RUN: tuple[DependencyKind, ...] = ("depend", "exec", "run", "build", "build_export")
"""Kinds of dependency without which a package does not run; one that only its tests need is none of them."""


def dependencies_within(packages: Iterable[Package]) -> dict[str, frozenset[str]]:
    """Package → the packages of the same workspace that it needs, directly or not."""
    direct = {package.name: _needs(package) for package in packages}
    here = {name: direct.keys() & needs for name, needs in direct.items()}
    return {name: closure([name], here.__getitem__) - {name} for name in sorted(here)}


def _needs(package: Package) -> list[str]:
    entries = package.dependencies
    return sorted({entry.name for entry in entries if entry.kind in _NEEDED_TO_RUN})

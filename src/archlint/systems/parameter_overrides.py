"""The parameter overrides and node names of a launch that a program has to be run again with."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence, Set
from typing import TYPE_CHECKING

from archlint.model import ENDPOINT_KINDS, Blueprint, Creation, Overrides, Program, Text, node_key
from archlint.systems.instances import instantiate
from archlint.systems.overrides import overrides_of

if TYPE_CHECKING:
    from archlint.launch.started import Started
    from archlint.ros.remapping import RemapRule
    from archlint.syntax.parameter_files import ParameterFacts
    from archlint.systems.nodes import Node

_NO_DEFAULT = object()


def known_name(node: Node) -> str | None:
    """The full name of a node, where it is one."""
    return node.name if node.resolution in ("exact", "parameter") else None


def parameter_overrides(
    started: Started,
    program: Program,
    parameters_of: Callable[[str], ParameterFacts],
    remaps: Sequence[RemapRule] = (),
) -> Overrides | None:
    """What is set on the nodes of a process, or named otherwise, and can change what the program creates; None where
    nothing is.

    ``remaps`` are the rules of its command line: they may rename a node, and parameter files go by final names.
    """
    by_node: dict[tuple[str | None, str | None], Mapping[str, object]] = {}
    names: dict[tuple[str | None, str | None], tuple[Text, Text]] = {}
    nodes = [blueprint for blueprint in program.nodes if not blueprint.test]
    for blueprint, node, values in _given(started, program, parameters_of, remaps):
        if program.reads_node_names and node.own is not None and node.own != instantiate(blueprint, program).own:
            names[node_key(blueprint)] = (node.own.name, node.own.namespace)
        by_node[node_key(blueprint)] = values
    everything, mentioned = _decided_by(program)
    decisive = {
        key: _decisive([node for node in nodes if node_key(node) == key], values, everything, mentioned)
        for key, values in by_node.items()
    }
    defaults = _defaults_that_hold(started, nodes, by_node)
    if not names and not any(decisive.values()) and not (defaults and is_undecided(nodes)):
        return None
    others = next(iter(decisive.values())) if len(decisive) == 1 else overrides_of(started, None, parameters_of)
    return Overrides(decisive, others, _settled(nodes, decisive) | defaults, names)


def with_what_came_up(
    before: Overrides,
    new: Set[str],
    started: Started,
    program: Program,
    parameters_of: Callable[[str], ParameterFacts],
    remaps: Sequence[RemapRule] = (),
) -> Overrides | None:
    """The overrides of a program together with those of the ``new`` parameters, which it has only declared since it
    runs with them, in a loop that goes on as long as another parameter says, for example; None where nothing sets
    one."""
    nodes = [blueprint for blueprint in program.nodes if not blueprint.test]
    came_up: dict[tuple[str | None, str | None], Mapping[str, object]] = {}
    for blueprint, node, values in _given(started, program, parameters_of, remaps):
        known = new if known_name(node) is not None else ()
        came_up[node_key(blueprint)] = {name: value for name, value in values.items() if name in known}
    if not any(came_up.values()):
        return None
    of_nodes = {key: {**came_up.get(key, {}), **before.of_nodes.get(key, {})} for key in {**before.of_nodes, **came_up}}
    others = next(iter(of_nodes.values())) if len(of_nodes) == 1 else before.others
    return Overrides(of_nodes, others, before.settled | _settled(nodes, came_up), before.names)


def _given(
    started: Started,
    program: Program,
    parameters_of: Callable[[str], ParameterFacts],
    remaps: Sequence[RemapRule],
) -> Iterator[tuple[Blueprint, Node, Mapping[str, object]]]:
    """What a launch sets on each node of a program, which has the name that it has there."""
    for blueprint in program.nodes:
        if not blueprint.test:
            node = instantiate(blueprint, program, name=started.name, namespace=started.namespace, remaps=remaps)
            reached = blueprint.use_global_arguments
            yield blueprint, node, overrides_of(started, known_name(node), parameters_of) if reached else {}


def declared_names(program: Program) -> frozenset[str]:
    """The parameters that the nodes of a program declare by names that are known."""
    every = (declaration.name.text for node in program.nodes for declaration in node.parameters)
    return frozenset(name for name in every if name is not None)


def is_undecided(nodes: Iterable[Blueprint]) -> bool:
    """Whether something that nodes create, or a name of theirs, depends on what has not been decided."""
    return any(
        node.name.resolution in _UNCLEAR
        or any(c.conditional or (c.kind in ENDPOINT_KINDS and _is_unclear(c)) for c in node.creations)
        for node in nodes
    )


def _is_unclear(creation: Creation) -> bool:
    return creation.name.resolution in _UNCLEAR or creation.type is None


_UNCLEAR = ("partial", "unknown")


def _defaults_that_hold(
    started: Started,
    nodes: list[Blueprint],
    values: Mapping[tuple[str | None, str | None], Mapping[str, object]],
) -> frozenset[str]:
    """Parameters that the launch is seen to leave alone: what starts has their defaults."""
    if not _all_is_known(started):
        return frozenset()
    every = [declaration for node in nodes for declaration in node.parameters]
    unclear = {declaration.name.text for declaration in every if not declaration.known}
    given = {name for settings in values.values() for name in settings}
    return frozenset({d.name.text for d in every if d.name.text is not None} - unclear - given)


def _all_is_known(started: Started) -> bool:
    """Whether everything that a launch file says about the parameters of a process could be read."""
    words = [*started.arguments, *started.ros_arguments]
    return (
        None not in words
        and "--params-file" not in words
        and all(parameter.followed for parameter in started.parameters)
    )


def _decided_by(program: Program) -> tuple[bool, set[str]]:
    """The parameters that names (those of other parameters, too), periods and QoS come from; first whether any other
    may matter."""
    mentioned: set[str] = set()
    everything = False
    for blueprint in program.nodes:
        everything |= _takes_any(blueprint)
        for declaration in blueprint.parameters:
            mentioned.update((declaration.name.parameter or "").split(","))
        for creation in blueprint.creations:
            unclear = creation.name.resolution in _UNCLEAR and creation.kind in ENDPOINT_KINDS
            everything |= creation.conditional or unclear
            qos = creation.qos and creation.qos.parameter
            for names in (creation.name.parameter, creation.period_parameter, creation.type_parameter, qos):
                mentioned.update((names or "").split(","))
    return everything, mentioned


def _takes_any(blueprint: Blueprint) -> bool:
    """Whether a node takes parameters that it does not declare by a known name."""
    unknown = any(declaration.name.text is None for declaration in blueprint.parameters)
    return unknown or blueprint.allow_undeclared_parameters or blueprint.automatically_declare_parameters


def _decisive(
    nodes: list[Blueprint], values: Mapping[str, object], everything: bool, mentioned: set[str]
) -> dict[str, object]:
    """The values of parameters that the nodes of one name declare (or may declare), where something that they
    create depends on them: with another default, or deciding a branch that a default does not."""
    defaults: dict[str, object] = {}
    for declaration in (declaration for node in nodes for declaration in node.parameters):
        if declaration.name.text is not None:
            defaults[declaration.name.text] = declaration.default if declaration.known else _NO_DEFAULT
    any_name = not defaults or any(map(_takes_any, nodes))
    return {
        name: value
        for name, value in values.items()
        if (everything and (any_name or name in defaults))
        or (name in mentioned and not _same(defaults.get(name, _NO_DEFAULT), value))
    }


def _same(default: object, value: object) -> bool:
    return type(default) is type(value) and default == value


def _settled(
    nodes: list[Blueprint], values: Mapping[tuple[str | None, str | None], Mapping[str, object]]
) -> frozenset[str]:
    set_names = {name for settings in values.values() for name in settings}
    for node in nodes:
        declared = {declaration.name.text for declaration in node.parameters}
        set_names -= {name for name in set_names & declared if name is not None and name not in values[node_key(node)]}
    return frozenset(set_names)

"""Create calls: publishers, subscriptions, services, clients, actions, timers."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint import model
from archlint.branches import BranchArm, ChoiceOfArgument
from archlint.finding import Place
from archlint.interpreter.formatting import plain_text
from archlint.interpreter.values import Instance, Known, Unknown, Value, alternatives, via
from archlint.libraries.api_use import ApiUse, argument_places
from archlint.libraries.rclpy import callbacks, nodes, profiles
from archlint.libraries.rclpy.groups import group_of
from archlint.libraries.rclpy.guards import guard_of
from archlint.libraries.rclpy.interface_types import may_be_type, types_of
from archlint.libraries.rclpy.proven_tests import proven_of
from archlint.libraries.texts import text_of_value
from archlint.libraries.values import EntityValue
from archlint.syntax import facts

if TYPE_CHECKING:
    from archlint.libraries.run import Run
    from archlint.ros.qos import Qos

COMBINATIONS = 32
"""How many combinations of names and types one create call may stand for."""


def _is_of_another_library(run: Run, call: ApiUse, on: Value | None) -> bool:
    """Whether a create call is none of ROS's: ``create_client('s3')`` on an object that we do not see is not.

    On a node it is one all the same, which we do not understand: the node is noted as one with a gap.
    """
    if call.api.type is None:
        return False
    if may_be_type(call.api, call.get(call.api.type)):
        return isinstance(on, Known)
    node = nodes.known_node(run, on)
    if node is not None and not node.caller_unknown and call.expression is not None:
        [(_, why)] = types_of(call)
        _note_gap(node, (run.place(call.expression.span), why or ""))
    return True


def _note_gap(node: model.Blueprint, gap: tuple[Place, str]) -> None:
    if gap not in node.gaps:
        node.gaps.append(gap)
    node.complete = False


def endpoint(run: Run, call: ApiUse) -> Value:
    """One create call of the table: an endpoint for each node, name and type it may have."""
    api = call.api
    on = call.get(api.node) if api.node is not None else call.receiver
    if _is_of_another_library(run, call, on):
        return Unknown(f"the result of {api.path}() of another library")
    of = nodes.nodes_of if api.node is None else nodes.given_nodes
    blueprints = of(run, on, plausible=api.node is None or isinstance(on, (Unknown, Instance)))
    if not blueprints:
        return Unknown("a create call on something that is not a node")
    missing = "passed by * or **" if call.open else "no name is given"
    names = _names(run, call, missing)
    types = types_of(call)
    creations = []
    profiles_ = profiles.resolve_all(run, call.get(api.qos), api.default_qos, call)
    rows = [(n, t, q) for n in names for t in types for q in profiles_][:COMBINATIONS]
    for blueprint in blueprints:
        for number, (name, (type_, why), qos) in enumerate(rows):
            creations.append(create(run, call, blueprint, name, type_, why, qos, number if len(rows) > 1 else None))
    return EntityValue(tuple(creations), api.returns or api.path, run.store.new_key())


def _names(run: Run, call: ApiUse, missing: str) -> list[model.Text]:
    api = call.api
    if api.fixed_name is not None:
        return [model.Text(api.fixed_name, "exact")]
    value = call.get(api.name)
    if value is None:
        return [text_of_value(None, missing)]
    return [text_of_value(plain_text(run, option), missing) for option in alternatives(value)]


def create(
    run: Run,
    call: ApiUse,
    blueprint: model.Blueprint,
    name: model.Text,
    type_: str | None,
    why: str | None,
    qos: Qos,
    alternative: int | None,
) -> model.Creation:
    place = run.place(call.expression.span) if call.expression is not None else Place("", 1, 1, 1, 1)
    arms = frozenset(run.branch_arms)
    if alternative is not None:
        arms |= {(ChoiceOfArgument(place.file, place.line, place.column), alternative)}
    policies = (qos.history, qos.depth, qos.reliability, qos.durability)
    kind = call.api.kind
    assert kind is not None, "a row that makes an endpoint says of which kind"
    base = (kind, id(blueprint), place, name.text, name.resolution, type_, policies)
    key = callbacks.creation_key(run, base, call)
    known = run.noted.creations.get(key)
    if known is not None:
        _note_again(run, known, arms)
        return known
    places = argument_places(run, call.api, call.expression)
    creation = model.Creation(
        kind,
        call.api.path,
        blueprint,
        place,
        name,
        type_,
        why,
        places.get(call.api.type or ""),
        qos,
        {},
        group_of(run, call.get(call.api.group)),
        bool(arms),
        arms,
        run.chain(),
        run.context,
        function=run.activation.qualified,
        guard=guard_of(run),
        proven=proven_of(run),
        name_place=places.get(call.api.name or ""),
        raw=call.get("raw") == Known(True),
        stored=is_stored(run, call),
    )
    run.noted.creations[key] = creation
    blueprint.creations.append(creation)
    creation.type_parameter = _chosen_by(call.get(call.api.type))
    creation.callbacks = callbacks.register_row(run, call, blueprint, creation, creation.group)
    return creation


def _note_again(run: Run, known: model.Creation, arms: frozenset[BranchArm]) -> None:
    """The same call on another way to it: what holds on both ways is left."""
    if not arms:
        known.conditional, known.branch_arms = False, frozenset()
    else:
        known.branch_arms &= arms
    known.proven = known.proven if known.proven == proven_of(run) else ()


def _chosen_by(type_: Value | None) -> str | None:
    """The parameters that a type depends on, separated by commas."""
    return ",".join(sorted(via(*alternatives(type_)))) or None if type_ is not None else None


def is_stored(run: Run, call: ApiUse) -> bool:
    statement = run.activation.statement
    return not (isinstance(statement, facts.Expression) and statement.value is call.expression)


def destroy(run: Run, call: ApiUse) -> Value:
    value = call.rest[0] if call.rest else next(iter(call.arguments.values()), None)
    if isinstance(value, EntityValue):
        for creation in value.creations:
            creation.destroyed = True
    return Known(True)

"""Timers and rates."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint import model
from archlint.finding import Place
from archlint.interpreter.values import (
    Known,
    Unknown,
    Value,
)
from archlint.libraries.api_use import ApiUse
from archlint.libraries.rclpy import callbacks, nodes
from archlint.libraries.rclpy.entities import is_stored
from archlint.libraries.rclpy.groups import group_of
from archlint.libraries.rclpy.guards import guard_of
from archlint.libraries.values import EntityValue

if TYPE_CHECKING:
    from archlint.libraries.run import Run


def timer(run: Run, call: ApiUse) -> Value:
    """``create_timer(period, callback)``."""
    if isinstance(call.receiver, Unknown) and call.get("callback") is None:
        return Unknown("the result of create_timer() of another library")
    place = run.place(call.expression.span) if call.expression is not None else Place("", 1, 1, 1, 1)
    period, parameter = _number(call.get("timer_period_sec"))
    creations = []
    for blueprint in nodes.nodes_of(run, call.receiver):
        key = callbacks.creation_key(run, (model.EntityKind.TIMER, id(blueprint), place, period), call)
        creation = run.noted.creations.get(key)
        if creation is None:
            creation = model.Creation(
                model.EntityKind.TIMER,
                call.api.path,
                blueprint,
                place,
                model.Text(None, "exact"),
                None,
                group=group_of(run, call.get("callback_group")),
                conditional=bool(run.branch_arms),
                branch_arms=frozenset(run.branch_arms),
                chain=run.chain(),
                context=run.context,
                period=period,
                period_parameter=parameter,
                function=run.activation.qualified,
                guard=guard_of(run),
                stored=is_stored(run, call),
            )
            run.noted.creations[key] = creation
            blueprint.creations.append(creation)
            creation.callbacks = callbacks.register_row(run, call, blueprint, creation, creation.group)
        elif not run.branch_arms:
            creation.conditional, creation.branch_arms = False, frozenset()
        creations.append(creation)
    return EntityValue(tuple(creations), "rclpy.timer.Timer", run.store.new_key())


def _number(value: Value | None) -> tuple[float | None, str | None]:
    match value:
        case Known(value=int() | float() as number, via=parameters):
            return float(number), ",".join(sorted(parameters)) or None
        case Unknown(parameter=parameter):
            return None, parameter
    return None, None


def rate(run: Run, call: ApiUse) -> Value:
    """``create_rate(frequency)``: its timer is of the node, and calls nothing but the rate itself."""
    node = nodes.known_node(run, call.receiver)
    if node is None or call.expression is None:
        return EntityValue((), "rclpy.timer.Rate", run.store.new_key())
    frequency, parameter = _number(call.get("frequency"))
    period = 1.0 / frequency if frequency is not None and frequency > 0 else None
    place = run.place(call.expression.span)
    key = (call.api.path, id(node), place, period)
    creation = run.noted.creations.get(key)
    if creation is None:
        name = model.Text(None, "exact")
        creation = model.Creation(
            model.EntityKind.TIMER, call.api.path, node, place, name, None, period=period, period_parameter=parameter
        )
        run.noted.creations[key] = creation
    return EntityValue((creation,), "rclpy.timer.Rate", run.store.new_key())

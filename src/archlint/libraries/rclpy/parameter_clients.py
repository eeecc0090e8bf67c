"""Clients of another node's parameters."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint import model
from archlint.interpreter.values import (
    Known,
    Value,
    join_texts,
)
from archlint.libraries.api_use import ApiUse
from archlint.libraries.rclpy import nodes, profiles
from archlint.libraries.rclpy.entities import create
from archlint.libraries.tables import Api
from archlint.libraries.texts import text_of_value
from archlint.libraries.values import EntityValue
from archlint.ros.parameter_services import PARAMETER_SERVICES

if TYPE_CHECKING:
    from archlint.libraries.run import Run


def parameter_client(run: Run, call: ApiUse) -> Value:
    """``AsyncParameterClient(node, 'other')``: a client for each of the six parameter services of the other.  In C++
    there may be no other: then it is for the node's own, which every node has."""
    row = Api(call.api.path, "", "endpoint", kind=model.EntityKind.CLIENT, default_qos="services_default")
    clients = []
    remote = call.get("remote_node_name")
    if remote is None:
        return EntityValue((), call.api.path, run.store.new_key())
    for blueprint in nodes.given_nodes(run, call.get("node")):
        for name, type_ in PARAMETER_SERVICES:
            text = text_of_value(join_texts((remote, Known(f"/{name}"))), "no name is given")
            part = ApiUse(row, None, {}, call.expression, False, [], {})
            profile = profiles.resolve(run, call.get("qos_profile"), "services_default", call)
            clients.append(create(run, part, blueprint, text, type_, None, profile, None))
    return EntityValue(tuple(clients), call.api.path, run.store.new_key())

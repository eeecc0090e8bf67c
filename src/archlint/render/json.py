"""The graph as JSON, version 1: names follow rosgraph's ComputationGraph.

Everything is in a fixed order, files have ``/``, and a key is always there: null where nothing is known.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from pathlib import PurePath
from typing import TYPE_CHECKING, Any

from archlint import model as program
from archlint.connections.delivery import undelivered_on
from archlint.json_text import json_text
from archlint.model import Creation, ParameterDeclaration
from archlint.render.definitions import interfaces, launch_arguments
from archlint.ros.parameter_types import type_of
from archlint.ros.qos import Qos
from archlint.syntax.parameter_files import NotKnown
from archlint.systems.model import System
from archlint.systems.nodes import Connection, Endpoint, KnownExternal, Node

if TYPE_CHECKING:
    from archlint.observed.model import Comparison, Difference
    from archlint.systems.overrides import Setting

VERSION = 1

_LISTS = {
    "publishers": program.EntityKind.PUBLISHER,
    "subscribers": program.EntityKind.SUBSCRIBER,
    "services": program.EntityKind.SERVICE,
    "clients": program.EntityKind.CLIENT,
    "action_servers": program.EntityKind.ACTION_SERVER,
    "action_clients": program.EntityKind.ACTION_CLIENT,
}
_CALLBACK = {
    program.EntityKind.SUBSCRIBER: program.Role.SUBSCRIPTION,
    program.EntityKind.SERVICE: program.Role.SERVICE,
    program.EntityKind.ACTION_SERVER: program.Role.EXECUTE,
    program.EntityKind.TIMER: program.Role.TIMER,
}
"""Which of an entity's callbacks is *the* callback."""


def render(system: System) -> str:
    return json_text(document(system), indent=2) + "\n"


def document(system: System) -> dict[str, Any]:
    """The whole graph as plain data; with ``observed`` where it was held against a running system."""
    compared = {} if system.compared is None else {"observed": _compared(system.compared)}
    return {
        "version": VERSION,
        "system": system.name,
        "nodes": [node_data(node) for node in system.entries],
        "topics": [
            {**_connection(c, "publishers", "subscribers"), "undelivered": _undelivered(system, c)}
            for c in system.topics.values()
        ],
        "services": [_connection(c, "servers", "clients") for c in system.services.values()],
        "actions": [_connection(c, "servers", "clients") for c in system.actions.values()],
        "unresolved": unresolved(system),
        "launch_arguments": launch_arguments(system),
        "interfaces": interfaces(system),
        **compared,
    }


def _compared(compared: Comparison) -> dict[str, Any]:
    return {
        "file": compared.observed.file,
        "form": compared.observed.form,
        "compared_with": compared.with_what,
        "nodes": compared.nodes,
        "endpoints": compared.ends,
        "differences": [_difference(difference) for difference in compared.differences],
        "left_open": list(compared.left_open),
        "notes": list(compared.notes),
    }


def _difference(difference: Difference) -> dict[str, Any]:
    return {
        "status": difference.status,
        "kind": difference.kind,
        "name": difference.name,
        "node": difference.node,
        "expected": difference.expected or None,
        "observed": difference.observed or None,
        "message": difference.message,
        "file": shown_file(difference.place.file),
        "line": difference.place.line,
        "column": difference.place.column,
    }


def node_data(node: Node) -> dict[str, Any]:
    """A node with all that it has."""
    blueprint = node.blueprint
    place = blueprint.place if blueprint else node.launch_place
    lists = {name: [endpoint_data(e) for e in node.of_kind(kind)] for name, kind in _LISTS.items()}
    return {
        "name": node.name,
        "class": blueprint.class_name if blueprint else None,
        "package": node.package,
        "executable": node.executable,
        "executables": list(node.executables),
        "file": shown_file(place.file) if place else None,
        "line": place.line if place else None,
        "is_node": node.is_node,
        "lifecycle": blueprint.lifecycle if blueprint else False,
        "executor": node.executor,
        "launched_by": node.launched_by,
        "external": node.external and node.unfollowed is None,
        "known_from": _known_from(node.known),
        "condition": node.condition,
        "remappings": _remappings(node),
        "test": node.test,
        "complete": node.unfollowed is None
        and node.doubt is None
        and all(b.complete for b in node.blueprints)
        and (node.known is None or node.known.complete),
        "error": node.error,
        **lists,
        "timers": [_timer(timer) for timer in node.timers],
        "parameters": [parameter_data(parameter, node) for parameter in node.parameters]
        + [*map(_setting, node.settings)],
        "overrides": sorted(node.overrides),
    }


def _known_from(known: KnownExternal | None) -> dict[str, Any] | None:
    """Where it is known from what a node has whose source is not here."""
    if known is None:
        return None
    return {"source": known.source, "versions": dict(known.versions), "open": list(known.open)}


def _remappings(node: Node) -> list[dict[str, Any]]:
    """The remappings of the launch file, in the order in which ROS tries them."""
    remaps = node.started.remaps if node.started is not None else ()
    return [{"from": remap.source.text, "to": remap.target.text} for remap in remaps]


def endpoint_data(endpoint: Endpoint) -> dict[str, Any]:
    """An end of a topic, service or action."""
    place = endpoint.place
    described = {
        "name": endpoint.name,
        "type": endpoint.type,
        "qos": qos_data(endpoint.qos),
        "file": shown_file(place.file),
        "line": place.line,
        "column": place.column,
        "end_line": place.end_line,
        "end_column": place.end_column,
        "written": endpoint.written,
        "resolution": endpoint.resolution,
        "parameter": endpoint.parameter,
        "conditional": endpoint.conditional,
        "callback_group": endpoint.creation.group.kind,
        "reason": endpoint.reason or endpoint.creation.type_reason,
        "error": endpoint.error,
    }
    if endpoint.kind in _CALLBACK:
        described["callback"] = _callback(endpoint.creation)
    return described


def _callback(creation: Creation) -> str | None:
    callback = creation.callbacks.get(_CALLBACK[creation.kind])
    return callback.name if callback else None


def qos_data(qos: Qos | None) -> dict[str, Any] | None:
    """A profile; None where nothing is known of it."""
    if qos is None:
        return None
    described: dict[str, Any] = {
        "history": qos.history,
        "depth": qos.depth,
        "reliability": qos.reliability,
        "durability": qos.durability,
    }
    durations = {"deadline_s": qos.deadline, "lifespan_s": qos.lifespan, "lease_s": qos.liveliness_lease}
    described |= {name: seconds for name, seconds in durations.items() if seconds}
    if qos.liveliness != "system_default":
        described["liveliness"] = qos.liveliness
    return described


def _timer(timer: Creation) -> dict[str, Any]:
    return {
        "period_s": plain(timer.period),
        "callback": _callback(timer),
        "file": shown_file(timer.place.file),
        "line": timer.place.line,
        "column": timer.place.column,
        "parameter": timer.period_parameter,
        "conditional": timer.conditional,
        "callback_group": timer.group.kind,
    }


def parameter_data(parameter: ParameterDeclaration, node: Node) -> dict[str, Any]:
    """A parameter that a node declares."""
    described = {
        "name": parameter.name.text,
        "type": parameter.type,
        "default": plain(parameter.default) if parameter.known else None,
        "file": shown_file(parameter.place.file),
        "line": parameter.place.line,
        "column": parameter.place.column,
        "conditional": parameter.conditional,
    }
    if parameter.given:
        described["override"] = plain(parameter.given[0])
    elif (name := parameter.name.text) is not None and name in node.overrides and not parameter.ignore_override:
        given = node.overrides[name]
        described |= {"override": plain(given), "override_reason": why_unknown(given)}
    return described


def _setting(setting: Setting) -> dict[str, Any]:
    """A parameter that is set on a node which is not here, at the place where it is set."""
    return {
        "name": setting.name,
        "type": type_of(setting.value),
        "default": None,
        "value": plain(setting.value),
        "reason": why_unknown(setting.value),
        "file": shown_file(setting.place.file),
        "line": setting.place.line,
        "column": setting.place.column,
        "conditional": False,
    }


def why_unknown(value: object) -> str | None:
    """The reason of a value that is not known."""
    match value:
        case NotKnown(reason=reason):
            return reason
    return None


def plain(value: object) -> object:
    """A parameter's value in JSON; what JSON has no word for (nan, infinity) is a string."""
    match value:
        case float() if not math.isfinite(value):
            return str(value)
        case bytes() | bytearray() | list() | tuple():
            return [plain(item) for item in value]
        case None | bool() | int() | float() | str():
            return value
    return None


def _connection(connection: Connection, providers: str, users: str) -> dict[str, Any]:
    return {
        "name": connection.name,
        "types": connection.types,
        providers: node_names(connection.providers),
        users: node_names(connection.users),
    }


def _undelivered(system: System, topic: Connection) -> list[dict[str, Any]]:
    """The pairs of ends between which quality of service lets no message through."""
    return [
        {"publisher": pair.offer.node.name, "subscriber": pair.request.node.name, "reason": pair.reason}
        for pair in undelivered_on(system, topic)
    ]


def node_names(endpoints: Iterable[Endpoint]) -> list[str | None]:
    """The nodes of some endpoints, each once; null comes last and stands for all whose name is not known."""
    names = {endpoint.node.name for endpoint in endpoints}
    known: list[str | None] = [*sorted(name for name in names if name is not None)]
    return [*known, None] if None in names else known


def unresolved(system: System) -> list[dict[str, Any]]:
    """Entities without a known name, calls that may create entities but could not be followed, and what a launch
    file starts by way of files or actions that could not be.

    A helper's entity appears once, however many nodes use the helper.
    """
    entries: dict[tuple[str, int, int, str, str], None] = {}
    if system.launched is not None:
        for gap in system.launched.not_followed():
            entries[shown_file(gap.place.file), gap.place.line, gap.place.column, gap.kind, gap.reason] = None
    for node in system.entries:
        place = node.launch_place
        why = node.unfollowed or node.doubt
        if why is not None and place is not None:
            entries[shown_file(place.file), place.line, place.column, "node", why] = None
        for endpoint in node.endpoints:
            if endpoint.resolution == "unknown":
                place = endpoint.place
                entries[shown_file(place.file), place.line, place.column, endpoint.kind, endpoint.reason or ""] = None
        for blueprint in node.blueprints:
            for place, reason in blueprint.gaps:
                entries[shown_file(place.file), place.line, place.column, "call", reason] = None
    return [
        {"kind": kind, "file": file, "line": line, "column": column, "reason": reason}
        for file, line, column, kind, reason in sorted(entries)
    ]


def shown_file(path: str) -> str:
    """A path with ``/``."""
    return PurePath(path).as_posix()

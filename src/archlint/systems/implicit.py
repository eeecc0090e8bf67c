"""What rclpy and rcl create for every node without being asked, for ``archlint graph --all``.

Sources: rclpy ``node.py``, ``parameter_service.py``, ``type_description_service.py`` and ``time_source.py``;
rcl_lifecycle ``com_interface.c``; rcl_action ``names.c``.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace

from archlint import model as program
from archlint.model import Blueprint, Creation, Text
from archlint.records import dataclass
from archlint.ros import names, qos
from archlint.ros.parameter_services import PARAMETER_SERVICES
from archlint.ros.qos import Qos
from archlint.systems.model import System
from archlint.systems.nodes import NamedCreation, Node
from archlint.systems.resolution import FinalName, endpoint_name

IMPLICIT = "implicit"
"""The ``api`` of the creations made here."""


@dataclass(frozen=True)
class _Entity:
    kind: program.EntityKind
    name: str
    type: str
    qos: Qos


def _service(name: str, type_: str, profile: Qos = qos.DEFAULT) -> _Entity:
    return _Entity(program.EntityKind.SERVICE, name, type_, profile)


_ROSOUT = _Entity(program.EntityKind.PUBLISHER, "/rosout", "rcl_interfaces/msg/Log", qos.ROSOUT)
_PARAMETER_EVENTS = _Entity(
    program.EntityKind.PUBLISHER, "/parameter_events", "rcl_interfaces/msg/ParameterEvent", qos.PARAMETERS
)
_CLOCK = _Entity(program.EntityKind.SUBSCRIBER, "/clock", "rosgraph_msgs/msg/Clock", qos.CLOCK)
_PARAMETER_SERVICES = tuple(_service(f"~/{name}", type_, qos.PARAMETERS) for name, type_ in PARAMETER_SERVICES)
_TYPE_DESCRIPTION = _service("~/get_type_description", "type_description_interfaces/srv/GetTypeDescription")
_LOGGER_SERVICES = (
    _service("~/get_logger_levels", "rcl_interfaces/srv/GetLoggerLevels"),
    _service("~/set_logger_levels", "rcl_interfaces/srv/SetLoggerLevels"),
)
"""With ``enable_logger_service``, since Jazzy."""
_LIFECYCLE = (
    _Entity(program.EntityKind.PUBLISHER, "~/transition_event", "lifecycle_msgs/msg/TransitionEvent", qos.DEFAULT),
    *(
        _service(f"~/{name}", f"lifecycle_msgs/srv/{type_}")
        for name, type_ in (
            ("change_state", "ChangeState"),
            ("get_available_states", "GetAvailableStates"),
            ("get_available_transitions", "GetAvailableTransitions"),
            ("get_state", "GetState"),
            ("get_transition_graph", "GetAvailableTransitions"),
        )
    ),
)


def with_implicit(system: System, distro: str | None = None, of_actions: bool = True) -> System:
    """A copy of ``system`` in which each node has its implicit endpoints too, those that actions are made of only
    where they are wanted."""

    def more(node: Node) -> Node:
        return replace(node, creations=(*node.creations, *_implicit_creations(node, distro, of_actions)))

    return replace(system, nodes=[more(node) for node in system.nodes])


def _implicit_creations(node: Node, distro: str | None, of_actions: bool) -> list[NamedCreation]:
    """What the code of ``node`` creates without mentioning it.  ``distro`` None stands for Jazzy and later.

    Those under a node whose name is not known have no name either; a node that is not in this workspace has
    none that are known.
    """
    if node.blueprint is None:
        return []
    own = [_named(entity, node.blueprint, node) for entity in _entities(node, node.blueprint, distro)]
    return [*own, *(_of_actions(node) if of_actions else ())]


def implicit_names(system: System) -> frozenset[str]:
    """Every name that some node of the system may serve, publish or subscribe to without its code saying so.

    Wider than :func:`with_implicit`: with what only a parameter or a constructor's option brings about.
    """
    own = [entity.name for entity in (*_PARAMETER_SERVICES, _TYPE_DESCRIPTION, *_LIFECYCLE, *_LOGGER_SERVICES)]
    below = {node.name + name[1:] for node in system.nodes if node.name is not None for name in own}
    return frozenset(below | {_ROSOUT.name, _PARAMETER_EVENTS.name, _CLOCK.name})


def _entities(node: Node, blueprint: Blueprint, distro: str | None) -> Iterator[_Entity]:
    if blueprint.enable_rosout:
        yield _ROSOUT
    yield _PARAMETER_EVENTS
    if node.overrides.get("use_sim_time") is True:
        yield _CLOCK
    if blueprint.start_parameter_services:
        yield from _PARAMETER_SERVICES
    if distro != "humble" and node.overrides.get("start_type_description_service") is not False:
        yield _TYPE_DESCRIPTION
    if blueprint.lifecycle:
        yield from _LIFECYCLE


def _named(entity: _Entity, blueprint: Blueprint, node: Node) -> NamedCreation:
    place = blueprint.place
    text = Text(entity.name, "exact")
    creation = Creation(entity.kind, IMPLICIT, blueprint, place, text, entity.type, qos=entity.qos)
    return NamedCreation(creation, _name(node, text, entity.kind))


def _name(node: Node, text: Text, kind: program.EntityKind) -> FinalName:
    """Remapped like any other, by what the node is started with."""
    if text.text is not None and text.text.startswith("~") and node.name is None:
        return FinalName(None, None, "unknown", reason="the node's name is not known")
    assert node.own is not None, "a node with a blueprint has a name, known or not"
    return endpoint_name(text, kind, node.own, node.rules)


def _of_actions(node: Node) -> Iterable[NamedCreation]:
    """The three services and two topics of each action that has a known name."""
    for endpoint in node.of_kind(program.EntityKind.ACTION_SERVER, program.EntityKind.ACTION_CLIENT):
        if endpoint.name is None:
            continue
        serves = endpoint.kind == program.EntityKind.ACTION_SERVER
        for part, name in names.action_entities(endpoint.name).items():
            kind, profile = _ACTION_PARTS[part]
            kind = kind if serves else _OTHER_END[kind]
            type_ = _action_type(endpoint.type, part)
            name = _name(node, Text(name, endpoint.resolution, endpoint.parameter), kind).name or name
            text = replace(endpoint.creation.name, text=name)
            creation = replace(endpoint.creation, kind=kind, api=IMPLICIT, name=text, type=type_, qos=profile)
            creation.callbacks = {}
            yield NamedCreation(creation, replace(endpoint.named.final, name=name))


_ACTION_PARTS: Mapping[names.ActionPart, tuple[program.EntityKind, Qos]] = {
    "send_goal": (program.EntityKind.SERVICE, qos.DEFAULT),
    "cancel_goal": (program.EntityKind.SERVICE, qos.DEFAULT),
    "get_result": (program.EntityKind.SERVICE, qos.DEFAULT),
    "feedback": (program.EntityKind.PUBLISHER, qos.DEFAULT),
    "status": (program.EntityKind.PUBLISHER, qos.ACTION_STATUS),
}
"""What an action server makes of each hidden name."""
_OTHER_END = {
    program.EntityKind.SERVICE: program.EntityKind.CLIENT,
    program.EntityKind.PUBLISHER: program.EntityKind.SUBSCRIBER,
}


def _action_type(action: str | None, part: names.ActionPart) -> str | None:
    """The type of a hidden name; None where it is the action's own and that is not known."""
    match part:
        case "cancel_goal":
            return "action_msgs/srv/CancelGoal"
        case "status":
            return "action_msgs/msg/GoalStatusArray"
        case "send_goal":
            suffix = "_SendGoal"
        case "get_result":
            suffix = "_GetResult"
        case "feedback":
            suffix = "_FeedbackMessage"
    return None if action is None else action + suffix

"""Systems written down by hand, for tests of what reads a system.

    system(
        node("/sensor", publisher("/x", "std_msgs/msg/String")),
        node("/control", subscriber("/x", "std_msgs/msg/String"), package="control"),
    )

Names of endpoints are resolved as for real code: ``"x"`` in ``node("/ns/sensor", …)`` becomes ``/ns/x``.
Each node has a file of its own and each entity a line, so that every place is different.
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import Any

from archlint import model as program
from archlint.finding import Place
from archlint.model import Blueprint, Callback, Creation, Group, ParameterDeclaration, Program, Text
from archlint.ros.qos import Qos
from archlint.systems.instances import instantiate
from archlint.systems.model import System
from archlint.systems.nodes import Node

KNOWN = Qos()
"""Keep last 10, reliable, volatile: what ``10`` means to rclpy."""


def exact(text: str) -> Text:
    return Text(text, "exact")


def from_parameter(parameter: str, default: str) -> Text:
    return Text(default, "parameter", parameter)


def partial(pattern: str, reason: str = "it depends on data") -> Text:
    return Text(pattern, "partial", reason=reason)


def unknown(reason: str = "it is read from a file at run time") -> Text:
    return Text(None, "unknown", reason=reason)


def as_text(name: str | Text) -> Text:
    return exact(name) if isinstance(name, str) else name


@dataclass(frozen=True)
class Entity:
    """What a create call of a node under construction will be; see :func:`publisher` and the others."""

    kind: str
    name: Text
    type: str | None = None
    callbacks: dict[str, str] = field(default_factory=dict)
    """Role → method name."""
    options: dict[str, Any] = field(default_factory=dict)


def publisher(name: str | Text, type: str | None = "std_msgs/msg/String", qos: Qos | None = KNOWN, **options: Any):
    return Entity(program.EntityKind.PUBLISHER, as_text(name), type, {}, {"qos": qos, **options})


def subscriber(
    name: str | Text,
    type: str | None = "std_msgs/msg/String",
    qos: Qos | None = KNOWN,
    *,
    callback: str = "on_message",
    **options: Any,
):
    return Entity(
        program.EntityKind.SUBSCRIBER, as_text(name), type, {"subscription": callback}, {"qos": qos, **options}
    )


def service(
    name: str | Text,
    type: str | None = "std_srvs/srv/Trigger",
    *,
    callback: str = "on_request",
    **options: Any,
):
    return Entity(program.EntityKind.SERVICE, as_text(name), type, {"service": callback}, {"qos": KNOWN, **options})


def client(name: str | Text, type: str | None = "std_srvs/srv/Trigger", **options: Any):
    return Entity(program.EntityKind.CLIENT, as_text(name), type, {}, {"qos": KNOWN, **options})


def action_server(
    name: str | Text,
    type: str | None = "example_interfaces/action/Fibonacci",
    *,
    callback: str = "on_goal",
    **options: Any,
):
    return Entity(program.EntityKind.ACTION_SERVER, as_text(name), type, {"execute": callback}, options)


def action_client(name: str | Text, type: str | None = "example_interfaces/action/Fibonacci", **options: Any):
    return Entity(program.EntityKind.ACTION_CLIENT, as_text(name), type, {}, options)


def timer(period: float | None = 1.0, *, callback: str = "on_timer", **options: Any):
    return Entity(program.EntityKind.TIMER, exact(""), None, {"timer": callback}, {"period": period, **options})


def parameter(name: str, default: object = None, type: str | None = "string", **options: Any):
    """A parameter that the node declares."""
    return Entity("parameter", exact(name), type, {}, {"default": default, **options})


def blueprint(
    name: str | Text,
    *entities: Entity,
    namespace: str | Text = "",
    class_name: str | None = None,
    package: str | None = "demo",
    file: str | None = None,
    **options: Any,
) -> Blueprint:
    """A node as a program makes it; ``name`` is the node's own name, without namespace."""
    name = as_text(name)
    class_name = class_name or "".join(part.title() for part in (name.text or "helper").split("_"))
    file = file or f"src/{package}/{package}/{name.text or class_name.lower()}.py"
    made = Blueprint(class_name, name, as_text(namespace), place(file, 6), package, **options)
    for line, entity in enumerate(entities, start=10):
        if entity.kind == "parameter":
            made.parameters.append(_declaration(entity, made, place(file, line)))
        else:
            made.creations.append(_creation(entity, made, place(file, line)))
    return made


def node(full_name: str, *entities: Entity, launched_by: str | None = None, **options: Any) -> Node:
    """A node of a system under its fully qualified name; options as for :func:`blueprint`."""
    namespace, _, name = full_name.rpartition("/")
    options.setdefault("executables", (name,))
    options.setdefault("executor", "single_threaded")
    made = blueprint(name, *entities, namespace=namespace, **options)
    run = Program(made.executables[0] if made.executables else name, made.package, made.place.file, [made])
    run.callbacks = made.callbacks
    return instantiate(made, run, launched_by=launched_by)


def system(*nodes: Node, name: str | None = None, **options: Any) -> System:
    return System(name, list(nodes), [n.program for n in nodes if n.program is not None], **options)


def programs(*blueprints: Blueprint) -> list[Program]:
    """One program for each blueprint, called after its first executable."""
    return [Program((*b.executables, b.class_name)[0], b.package, b.place.file, [b]) for b in blueprints]


def place(file: str, line: int, column: int = 9, width: int = 40) -> Place:
    return Place(file, line, column, line, column + width)


def _creation(entity: Entity, made: Blueprint, at: Place) -> Creation:
    options = {"api": f"rclpy.node.Node.create_{entity.kind}", **entity.options}
    creation = Creation(kind=entity.kind, node=made, place=at, name=entity.name, type=entity.type, **options)
    for role, method in entity.callbacks.items():
        callback = Callback(
            role,
            f"{made.class_name}.{method}",
            replace(at, line=at.line + 100, end_line=at.line + 100),
            None,
            made,
            creation,
            options.get("group", Group()),
            at,
            bound_arguments=1,
            file=at.file,
        )
        creation.callbacks[role] = callback
        made.callbacks.append(callback)
    return creation


def _declaration(entity: Entity, made: Blueprint, at: Place) -> ParameterDeclaration:
    options = {"known": True, **entity.options}
    return ParameterDeclaration(name=entity.name, type=entity.type, place=at, node=made, **options)

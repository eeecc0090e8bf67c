"""Nodes: made by a class of ours, by ``create_node``, or passed by nobody we can see."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint import model
from archlint.finding import Place
from archlint.interpreter.values import (
    AttributeOf,
    ClassValue,
    External,
    Instance,
    OneOf,
    Unknown,
    Value,
    alternatives,
)
from archlint.libraries.rclpy import node_classes
from archlint.libraries.rclpy.blueprints import new_blueprint
from archlint.libraries.rclpy.unknown_callers import blueprint_of_unknown_caller, unknown_caller_key
from archlint.libraries.values import NodeValue

if TYPE_CHECKING:
    from archlint.libraries.run import Run


def adopt(run: Run, instance: Instance) -> None:
    """Give an object its blueprint if its class is a node."""
    if instance.own_class is not None and node_classes.is_node(instance.own_class):
        blueprint_of_instance(run, instance)


def blueprint_of_instance(run: Run, instance: Instance) -> model.Blueprint:
    known = run.nodes.by_object.get(instance.key)
    if known is not None:
        return known
    cls = instance.cls
    assert isinstance(cls, ClassValue)
    place = Place(cls.scope.module.path, *cls.ir.name_span)
    again = _made_before(run, (place, instance.place, cls.qualified))
    if again is not None:
        run.nodes.by_object[instance.key] = again
        return again
    key = f"{place.file}:{place.line}#{instance.key}"
    blueprint = new_blueprint(run, cls.qualified, place, key, cls.scope.module.file.package)
    blueprint.object_key = instance.key
    blueprint.made_at = instance.place
    blueprint.lifecycle = node_classes.is_lifecycle(cls)
    blueprint.caller_unknown = not node_classes.may_be_node(cls)
    blueprint.classes = node_classes.described(cls)
    blueprint.runs_elsewhere = node_classes.may_spin_itself(cls)
    run.nodes.by_object[instance.key] = blueprint
    return blueprint


def _made_before(run: Run, same: tuple[Place, Place | None, str]) -> model.Blueprint | None:
    """The node that a callback made there the first time, where it runs for a second time."""
    if run.nodes.revisited is None:
        return None
    for node in run.nodes.by_key.values():
        if (node.place, node.made_at, node.class_name) == same and id(node) not in run.nodes.revisited:
            run.nodes.revisited.add(id(node))
            return node
    return None


def known_node(run: Run, value: Value | None) -> model.Blueprint | None:
    """The blueprint of a value that is a node for certain."""
    match value:
        case NodeValue(blueprint=node):
            return node
        case Instance(key=key):
            return run.nodes.by_object.get(key)
    return None


def note_replaced(run: Run, instance: Instance, before: object) -> None:
    """Note that a new node takes the place in a variable that one of its class and name had."""
    node = run.nodes.by_object.get(instance.key)
    for option in alternatives(before) if node is not None and isinstance(before, Value) else ():
        old = known_node(run, option)
        if node is None or old is None or old is node:
            continue
        if (old.place, old.class_name, old.name.text) == (node.place, node.class_name, node.name.text):
            node.instead_of = old
            return


def note_escaped_class(run: Run, value: ClassValue) -> None:
    """Note that the class of a node is given to code that we do not see."""
    if run.context.role == model.Role.MAIN and node_classes.may_be_node(value):
        run.escapes.classes.setdefault(id(value), value)


def node_key(run: Run, value: Value | None) -> int:
    """Where a node's parameters are kept in the store."""
    if isinstance(value, (NodeValue, Instance)):
        return value.key
    return unknown_caller_key(run)


def given_nodes(run: Run, value: Value | None, *, plausible: bool = True) -> list[model.Blueprint]:
    """The nodes that an argument stands for which ROS takes nothing but a node for."""
    nodes = nodes_of(run, value, plausible=plausible)
    for option in alternatives(value) if value is not None else ():
        node = known_node(run, option)
        if node is not None:
            node.caller_unknown = False
    return nodes


def nodes_of(run: Run, value: Value | None, *, plausible: bool = True) -> list[model.Blueprint]:
    """The nodes that a create call makes something on; an unseen one where nobody passes it."""
    match value:
        case OneOf(values=options):
            objects = [option for option in options if isinstance(option, (NodeValue, Instance))]
            nodes: list[model.Blueprint] = []
            for option in objects or options:
                nodes.extend(node for node in nodes_of(run, option, plausible=plausible) if node not in nodes)
            return nodes
        case NodeValue(blueprint=node):
            return [node]
        case Instance():
            return _nodes_of_object(run, value, plausible)
        case Unknown() | External() if plausible:
            return [blueprint_of_unknown_caller(run, annotated=_annotated(value))]
    return []


def _nodes_of_object(run: Run, value: Instance, plausible: bool) -> list[model.Blueprint]:
    known, cls = run.nodes.by_object.get(value.key), value.own_class
    if known is not None:
        return [known]
    if cls is not None and node_classes.may_inherit(cls):
        return [blueprint_of_instance(run, value)]
    if not plausible or value.cls.dotted.startswith("rclpy."):
        return []
    # A mixin: whoever inherits it is the node.
    return [blueprint_of_unknown_caller(run, value if cls is not None else None)]


def _annotated(value: Value) -> tuple[model.ClassKey, str] | None:
    match value:
        case Unknown(annotation=AttributeOf(cls=cls, name=name)):
            return node_classes.keys(cls)[0], name
        case Unknown(annotation=ClassValue() as cls):
            return node_classes.keys(cls)[0], ""
    return None

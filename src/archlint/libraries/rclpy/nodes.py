"""Nodes: made by a class of ours, by ``create_node``, or handed in by nobody we can see."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint import model
from archlint.finding import Place
from archlint.interpreter import containers
from archlint.interpreter.values import (
    TRUE,
    AttributeOf,
    ClassValue,
    External,
    Instance,
    Known,
    ListValue,
    OneOf,
    Unknown,
    Value,
    alternatives,
)
from archlint.libraries.rclpy import node_classes, short_lived
from archlint.libraries.rclpy.fields import OVERRIDES
from archlint.libraries.texts import text_of_value
from archlint.libraries.values import NodeValue
from archlint.reasons import NotPassed

if TYPE_CHECKING:
    from archlint.libraries.api_use import ApiUse
    from archlint.libraries.run import Run

_ROOT = model.Text("/", "exact")


def new_blueprint(run: Run, class_name: str, place: Place, key: str, package: str | None) -> model.Blueprint:
    blueprint = model.Blueprint(
        class_name,
        model.Text(None, "unknown", reason=model.NEVER_CONSTRUCTED),
        _ROOT,
        place,
        package,
        test=run.index.roles.is_test(place.file),
        number=len(run.nodes.by_key),
        branch_arms=frozenset(run.branch_arms),
        made_by=run.context,
    )
    run.nodes.by_key[key] = blueprint
    run.program.nodes.append(blueprint)
    return blueprint


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
    again = _met_again(run, (place, instance.place, cls.qualified))
    if again is not None:
        run.nodes.by_object[instance.key] = again
        return again
    key = f"{place.file}:{place.line}#{instance.key}"
    blueprint = new_blueprint(run, cls.qualified, place, key, cls.scope.module.file.package)
    blueprint.object_key = instance.key
    blueprint.made_at = instance.place
    blueprint.lifecycle = node_classes.is_lifecycle(cls)
    blueprint.caller_unknown = not node_classes.may_be_node(cls)
    blueprint.classes = node_classes.keys(cls)
    run.nodes.by_object[instance.key] = blueprint
    return blueprint


def _met_again(run: Run, same: tuple[Place, Place | None, str]) -> model.Blueprint | None:
    """The node that a callback made there the first time, where it runs for a second time."""
    if run.nodes.met_again is None:
        return None
    for node in run.nodes.by_key.values():
        if (node.place, node.made_at, node.class_name) == same and id(node) not in run.nodes.met_again:
            run.nodes.met_again.add(id(node))
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


def note_replaced(run: Run, made: Instance, before: object) -> None:
    """Note that a new node takes the place in a variable that one of its class and name had."""
    node = run.nodes.by_object.get(made.key)
    for option in alternatives(before) if node is not None and isinstance(before, Value) else ():
        old = known_node(run, option)
        if node is None or old is None or old is node:
            continue
        if (old.place, old.class_name, old.name.text) == (node.place, node.class_name, node.name.text):
            node.instead_of = old
            return


def hand_out_class(run: Run, value: ClassValue) -> None:
    """Note that the class of a node is given to code that we do not see."""
    if run.context.role == model.Role.MAIN and node_classes.may_be_node(value):
        run.escapes.classes.setdefault(id(value), value)


def node_key(run: Run, value: Value | None) -> int:
    """Where a node's parameters are kept in the store."""
    if isinstance(value, (NodeValue, Instance)):
        return value.key
    return held_key(run)


def given_nodes(run: Run, value: Value | None, *, plausible: bool = True) -> list[model.Blueprint]:
    """The nodes that an argument stands for which ROS takes nothing but a node for."""
    found = nodes_of(run, value, plausible=plausible)
    for option in alternatives(value) if value is not None else ():
        node = known_node(run, option)
        if node is not None:
            node.caller_unknown = False
    return found


def nodes_of(run: Run, value: Value | None, *, plausible: bool = True) -> list[model.Blueprint]:
    """The nodes that a create call makes something on; an unseen one where nobody hands it in."""
    match value:
        case OneOf(values=options):
            objects = [option for option in options if isinstance(option, (NodeValue, Instance))]
            found: list[model.Blueprint] = []
            for option in objects or options:
                found.extend(node for node in nodes_of(run, option, plausible=plausible) if node not in found)
            return found
        case NodeValue(blueprint=node):
            return [node]
        case Instance():
            return _nodes_of_object(run, value, plausible)
        case Unknown() | External() if plausible:
            return [held_blueprint(run, annotated=_annotated(value))]
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
    return [held_blueprint(run, value if cls is not None else None)]


def _annotated(value: Value) -> tuple[model.ClassKey, str] | None:
    match value:
        case Unknown(annotation=AttributeOf(cls=cls, name=name)):
            return node_classes.keys(cls)[0], name
        case Unknown(annotation=ClassValue() as cls):
            return node_classes.keys(cls)[0], ""
    return None


def _whose(cls: ClassValue) -> tuple[str, Place, str | None]:
    module = cls.scope.module
    return cls.qualified, Place(module.path, *cls.ir.name_span), module.file.package


def _holder(run: Run, instance: Instance | None = None) -> tuple[str, Place, str | None]:
    """Which class (or function) holds a node that nobody hands in: the object whose method is running."""
    cls = None if instance is None else instance.own_class
    if cls is not None:
        return _whose(cls)
    for activation in reversed(run.activations):
        cls = None if activation.self_value is None else activation.self_value.own_class
        if cls is not None:
            return _whose(cls)
        if activation.function is not None:
            place = Place(activation.module.path, *activation.function.ir.name_span)
            return activation.qualified, place, activation.module.file.package
    activation = run.activation
    return activation.qualified, Place(activation.module.path, 1, 1, 1, 1), activation.module.file.package


def held_blueprint(
    run: Run, instance: Instance | None = None, annotated: tuple[model.ClassKey, str] | None = None
) -> model.Blueprint:
    """The blueprint of a node that a helper is handed by nobody in the workspace."""
    name, place, package = _holder(run, instance)
    key = f"{place.file}:{place.line}#held" + (f" {annotated}" if annotated is not None else "")
    known = run.nodes.by_key.get(key)
    if known is not None:
        return known
    blueprint = new_blueprint(run, name, place, key, package)
    blueprint.caller_unknown = True
    blueprint.annotated = annotated
    blueprint.constructed = True
    blueprint.name = model.Text(None, "unknown", reason=NotPassed("nothing in the workspace passes a node"))
    # Like every node that no launch file puts elsewhere, it is in the root namespace.
    return blueprint


def held_key(run: Run) -> int:
    name, place, _ = _holder(run)
    return -abs(hash_of(f"{place.file}:{place.line}:{name}"))


def hash_of(text: str) -> int:
    """A number for a text that is the same in every process."""
    import zlib

    return zlib.crc32(text.encode("utf-8", "surrogatepass")) + 1


def create_node(run: Run, call: ApiUse) -> Value:
    """``rclpy.create_node('x')`` and ``Node('x')``."""
    place = run.place(call.expression.span) if call.expression is not None else Place("", 1, 1, 1, 1)
    text = text_of_value(call.get("node_name"), "a node without a name")
    key = f"{place.file}:{place.line}:{place.column}#{text.text}"
    known = run.nodes.by_key.get(key)
    if known is None:
        activation = run.activation
        known = new_blueprint(run, activation.qualified, place, key, activation.module.file.package)
        known.lifecycle = call.api.lifecycle
        _set_names(run, known, call)
        holder = short_lived.holder(run.activations, call.expression)
        if holder is not None:
            run.nodes.short_lived.setdefault(holder, []).append(known)
    elif known.until is not None and known.until < len(run.nodes.by_key):
        known.until = None  # made again, beside nodes that came later
    known.destroyed_at = None
    return NodeValue(known, run.store.new_key())


def node_init(run: Run, call: ApiUse) -> Value:
    """``super().__init__('x')`` of a node class."""
    receiver = call.receiver
    if isinstance(receiver, Instance) and receiver.own_class is not None:
        blueprint = blueprint_of_instance(run, receiver)
        _set_names(run, blueprint, call)
    return Known(None)


def destroy_node(run: Run, call: ApiUse) -> Value:
    """``node.destroy_node()``: from here on there is no such node, if no branch leaves it alive."""
    node = known_node(run, call.receiver)
    if node is not None and node.made_by is run.context and node.branch_arms.issuperset(run.branch_arms):
        node.destroyed_at = len(run.nodes.by_key)
    return Known(None)


def name_by_foreign_base(run: Run, receiver: Instance, path: str) -> None:
    """The constructor of a foreign base class decides the name of the node."""
    blueprint = run.nodes.by_object.get(receiver.key)
    if blueprint is not None and blueprint.name.resolution == "unknown":
        owner = path.removesuffix(".__init__")
        blueprint.constructed = True
        blueprint.name = model.Text(None, "unknown", reason=f"{owner}, outside of this workspace, names the node")


def _set_names(run: Run, blueprint: model.Blueprint, call: ApiUse) -> None:
    if call.open and "node_name" not in call.arguments:
        reason = "the node's name is passed by * or **"
        blueprint.constructed = True
        blueprint.name = model.Text(None, "unknown", reason=reason)
    else:
        blueprint.constructed = True
        blueprint.name = text_of_value(call.get("node_name"), "a node without a name")
    namespace = call.get("namespace")
    if namespace is None:
        # **kwargs may carry a namespace; rclpy's default is the root.
        blueprint.namespace = _ROOT
    elif isinstance(namespace, Known) and namespace.value in (None, ""):
        blueprint.namespace = _ROOT
    else:
        blueprint.namespace = text_of_value(namespace, "a namespace")
    blueprint.allow_undeclared_parameters = call.get("allow_undeclared_parameters") == TRUE
    blueprint.automatically_declare_parameters = call.get("automatically_declare_parameters_from_overrides") == TRUE
    blueprint.enable_rosout = call.get("enable_rosout") != Known(False)
    blueprint.use_global_arguments = call.get("use_global_arguments") != Known(False)
    blueprint.start_parameter_services = call.get("start_parameter_services") != Known(False)
    _note_overrides(run, call)
    arguments = call.get("cli_args")
    if isinstance(arguments, ListValue):
        items = containers.items_of(run, arguments)
        blueprint.cli_arguments = tuple(item.text for item in items.values if item.text is not None)


def _note_overrides(run: Run, call: ApiUse) -> None:
    """``parameter_overrides=[Parameter(…)]``: the constructor wins over every default and the command line."""
    given = call.get("parameter_overrides")
    items = containers.iterate(run, given) if given is not None else None
    key = call.receiver.key if isinstance(call.receiver, Instance) else None
    for item in items.values if items is not None else ():
        if key is not None and isinstance(item, Instance):
            name, value = run.store.get(item.key, "name"), run.store.get(item.key, "value")
            if isinstance(name, Known) and value is not None:
                run.store.set(key, OVERRIDES[str(name.value)], value)

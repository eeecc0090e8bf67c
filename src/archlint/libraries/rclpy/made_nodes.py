"""Nodes that a program makes, and what becomes of them."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint import model
from archlint.finding import Place
from archlint.interpreter.values import (
    TRUE,
    Instance,
    Known,
    ListValue,
    Value,
)
from archlint.libraries.rclpy import names, node_classes, refusals, short_lived
from archlint.libraries.rclpy.blueprints import ROOT, new_blueprint
from archlint.libraries.rclpy.fields import OVERRIDES
from archlint.libraries.rclpy.nodes import blueprint_of_instance, known_node
from archlint.libraries.texts import text_of_value
from archlint.libraries.values import NodeValue
from archlint.ros.distros import DISTROS

if TYPE_CHECKING:
    from archlint.libraries.api_use import ApiUse
    from archlint.libraries.run import Run


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
            run.nodes.short_lived.setdefault(holder[0], []).append((known, holder[1]))
    else:
        known.ended_arms &= run.ended_arms()
        if known.until is not None and known.until < len(run.nodes.by_key):
            known.until = None  # made again, beside nodes that came later
    known.destroyed_at, known.gone = None, ()
    if "context" not in call.arguments:
        _note_too_early(run, place, call.api.path.rpartition(".")[2])
    return NodeValue(known, run.store.new_key())


def initialise(run: Run, call: ApiUse) -> Value:
    """``rclpy.init()``: what made a node on the way to it has failed."""
    if "context" not in call.arguments and not run.branch_arms:
        for place, name in run.nodes.too_early:
            early = model.RefusedCall(place, "rclpy.init", model.Misuse.BEFORE_INIT, given=name, distros=DISTROS)
            refusals.keep(run, place, "rclpy.init", early)
    run.nodes.too_early.clear()
    run.nodes.initialised = True
    arguments, context = call.get("args"), _context_of(call)
    if isinstance(arguments, ListValue) and context is not None and not run.branch_arms:
        items = arguments.items(run)
        if not items.open and not items.values:
            run.nodes.without_arguments.add(context)
    return Known(None)


_DEFAULT_CONTEXT = -1


def _context_of(call: ApiUse) -> int | None:
    """The object that is the context of a call, by its key; None where that is not known."""
    context = call.get("context")
    return _DEFAULT_CONTEXT if context in (None, Known(None)) else context.heap_key


def _note_too_early(run: Run, place: Place | None, name: str) -> None:
    """Note that the program makes a node, if it has not called ``rclpy.init()``."""
    settled = not run.branch_arms and run.context.role in (model.Role.MAIN, model.Role.MODULE)
    if place is not None and settled and not run.nodes.initialised:
        run.nodes.too_early.append((place, name))


def node_init(run: Run, call: ApiUse) -> Value:
    """``super().__init__('x')`` of a node class."""
    receiver = call.receiver
    if isinstance(receiver, Instance) and receiver.own_class is not None:
        blueprint = blueprint_of_instance(run, receiver)
        _set_names(run, blueprint, call)
        if "context" not in call.arguments:
            _note_too_early(run, receiver.place, receiver.own_class.ir.name)
    return Known(None)


def destroy_node(run: Run, call: ApiUse) -> Value:
    """``node.destroy_node()``: from here on there is no such node, if no branch leaves it alive."""
    node = known_node(run, call.receiver)
    if node is not None and node.made_by is run.context:
        _end(run, node)
        if node.branch_arms.issuperset(run.branch_arms):
            node.destroyed_at = len(run.nodes.by_key)
    return Known(None)


def end_imported(run: Run) -> None:
    """A module that spins while it is imported: all nodes that the program has made by then are gone before the import
    ends, as ``rclpy.spin()`` returns when its context is shut down."""
    if run.context.role == model.Role.MODULE:
        for node in run.nodes.by_key.values():
            _end(run, node)


def _end(run: Run, node: model.Blueprint) -> None:
    node.gone += ((frozenset(run.branch_arms), len(run.nodes.by_key)),)


def name_by_foreign_base(run: Run, receiver: Instance, path: str) -> None:
    """The constructor of a foreign base class decides the name of the node."""
    blueprint = run.nodes.by_object.get(receiver.key)
    if blueprint is not None and blueprint.name.resolution == "unknown":
        owner = path.removesuffix(".__init__")
        blueprint.constructed = True
        blueprint.name = model.Text(None, "unknown", reason=f"{owner}, outside of this workspace, names the node")


def note_foreign_method(run: Run, receiver: Value | None, path: str) -> None:
    """A method of a base class that is neither here nor rclpy's nor Python's own runs on a node, which it may spin:
    ``isTaskComplete()`` of BasicNavigator does."""
    node = known_node(run, receiver)
    owner, _, name = path.rpartition(".")
    if node is not None and not names.is_node_attribute(name):
        node.runs_elsewhere |= not node_classes.is_harmless(owner)


def _set_names(run: Run, blueprint: model.Blueprint, call: ApiUse) -> None:
    if call.open and "node_name" not in call.arguments:
        reason = "the node's name is passed by * or **"
        blueprint.constructed = True
        blueprint.name = model.Text(None, "unknown", reason=reason)
    else:
        blueprint.constructed = True
        blueprint.name = text_of_value(call.get("node_name"), "a node without a name")
    namespace = call.get("namespace")
    options = call.get("rclcpp_options")
    if namespace is None and options is not None and options.text is not None:
        namespace = options  # a class of C++ that inherits the constructors of a node takes either
    if namespace is None:
        # **kwargs may carry a namespace; rclpy's default is the root.
        blueprint.namespace = ROOT
    elif isinstance(namespace, Known) and namespace.value in (None, ""):
        blueprint.namespace = ROOT
    else:
        blueprint.namespace = text_of_value(namespace, "a namespace")
    blueprint.allow_undeclared_parameters = _option(run, call, "allow_undeclared_parameters") == TRUE
    of_overrides = _option(run, call, "automatically_declare_parameters_from_overrides")
    blueprint.automatically_declare_parameters = of_overrides == TRUE
    blueprint.enable_rosout = _option(run, call, "enable_rosout") != Known(False)
    blueprint.use_global_arguments = (
        _option(run, call, "use_global_arguments") != Known(False)
        and _context_of(call) not in run.nodes.without_arguments
    )
    blueprint.start_parameter_services = _option(run, call, "start_parameter_services") != Known(False)
    _note_overrides(run, call)
    arguments = _option(run, call, "cli_args")
    if isinstance(arguments, ListValue):
        items = arguments.items(run)
        blueprint.cli_arguments = tuple(item.text for item in items.values if item.text is not None)


def _option(run: Run, call: ApiUse, name: str) -> Value | None:
    """An argument of the constructor; one of C++ takes it from its ``rclcpp::NodeOptions``."""
    options = call.get("rclcpp_options")
    if isinstance(options, Instance) and name not in call.arguments:
        return run.store.get(options.key, name)
    return call.get(name)


def _note_overrides(run: Run, call: ApiUse) -> None:
    """``parameter_overrides=[Parameter(…)]``: the constructor wins over every default and the command line."""
    given = _option(run, call, "parameter_overrides")
    items = given.items(run) if given is not None else None
    key = call.receiver.key if isinstance(call.receiver, Instance) else None
    for item in items.values if items is not None else ():
        if key is not None and isinstance(item, Instance):
            name, value = run.store.get(item.key, "name"), run.store.get(item.key, "value")
            if isinstance(name, Known) and value is not None:
                run.store.set(key, OVERRIDES[str(name.value)], value)

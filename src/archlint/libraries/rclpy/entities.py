"""Create calls: publishers, subscriptions, services, clients, actions, timers."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint import model
from archlint.branches import ChoiceOfArgument
from archlint.finding import Place
from archlint.interpreter.formatting import plain_text
from archlint.interpreter.values import (
    ClassValue,
    External,
    Instance,
    Known,
    Unknown,
    Value,
    alternatives,
    join_texts,
    via,
)
from archlint.libraries.api_use import ApiUse, argument_places
from archlint.libraries.rclpy import callbacks, nodes, profiles
from archlint.libraries.rclpy import names as rclpy_names
from archlint.libraries.rclpy.guards import guard_of, proven_of
from archlint.libraries.rclpy.interface_types import types_of
from archlint.libraries.tables import Api
from archlint.libraries.tables.api import DefaultQos
from archlint.libraries.texts import text_of_value
from archlint.libraries.values import EntityValue
from archlint.syntax import facts

if TYPE_CHECKING:
    from archlint.libraries.run import Run
    from archlint.ros.qos import Qos

COMBINATIONS = 32
"""How many combinations of names and types one create call may stand for."""


def _plausible(value: Value | None, receiver: Value | None) -> bool:
    """Whether a create call on an object that we do not see can be one on a node: ``create_client('s3')`` of
    another library is not."""
    return not isinstance(value, Known) and not isinstance(receiver, Known)


def endpoint(run: Run, call: ApiUse) -> Value:
    """One create call of the table: an endpoint for each node, name and type it may have."""
    api = call.api
    on = call.get(api.node) if api.node is not None else call.receiver
    type_value = call.get(api.type)
    if api.type is not None and not _plausible(type_value, on):
        return Unknown(f"the result of {api.path}() of another library")
    of = nodes.nodes_of if api.node is None else nodes.given_nodes
    blueprints = of(run, on, plausible=api.node is None or isinstance(on, (Unknown, Instance)))
    if not blueprints:
        return Unknown("a create call on something that is not a node")
    missing = "passed by * or **" if call.open else "no name is given"
    names = _names(run, call, missing)
    types = types_of(call)
    made = []
    profiles_ = profiles.resolve_all(run, call.get(api.qos), api.default_qos, call)
    rows = [(n, t, q) for n in names for t in types for q in profiles_][:COMBINATIONS]
    for blueprint in blueprints:
        for number, (name, (type_, why), qos) in enumerate(rows):
            made.append(_create(run, call, blueprint, name, type_, why, qos, number if len(rows) > 1 else None))
    return EntityValue(tuple(made), api.returns or api.path, run.store.new_key())


def _names(run: Run, call: ApiUse, missing: str) -> list[model.Text]:
    api = call.api
    if api.fixed_name is not None:
        return [model.Text(api.fixed_name, "exact")]
    value = call.get(api.name)
    if value is None:
        return [text_of_value(None, missing)]
    return [text_of_value(plain_text(run, option), missing) for option in alternatives(value)]


def _create(
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
        arms |= {(ChoiceOfArgument(f"{place.file}:{place.line}:{place.column}|"), alternative)}
    policies = (qos.history, qos.depth, qos.reliability, qos.durability)
    kind = call.api.kind
    assert kind is not None, "a row that makes an endpoint says of which kind"
    base = (kind, id(blueprint), place, name.text, name.resolution, type_, policies)
    key = callbacks.told_apart(run, base, call)
    known = run.noted.creations.get(key)
    if known is not None:
        if not arms:
            known.conditional, known.branch_arms = False, frozenset()
        else:
            known.branch_arms &= arms
        known.proven = known.proven if known.proven == proven_of(run) else ()
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
        stored=_stored(run, call),
    )
    run.noted.creations[key] = creation
    blueprint.creations.append(creation)
    creation.type_parameter = _chosen_by(call.get(call.api.type))
    creation.callbacks = callbacks.register_row(run, call, blueprint, creation, creation.group)
    return creation


def _chosen_by(type_: Value | None) -> str | None:
    """The parameters that a type depends on, separated by commas."""
    return ",".join(sorted(via(*alternatives(type_)))) or None if type_ is not None else None


def _stored(run: Run, call: ApiUse) -> bool:
    statement = run.activation.statement
    return not (isinstance(statement, facts.Expression) and statement.value is call.expression)


_GROUPS = {
    "rclpy.callback_groups.MutuallyExclusiveCallbackGroup": model.GroupKind.MUTUALLY_EXCLUSIVE,
    "rclpy.callback_groups.ReentrantCallbackGroup": model.GroupKind.REENTRANT,
}


def group_of(run: Run, value: Value | None) -> model.Group:
    """The callback group that an argument names."""
    match value:
        case None | Known(value=None):
            return model.Group(model.GroupKind.DEFAULT)
        case External(path=path) if path.endswith("default_callback_group"):
            return model.Group(model.GroupKind.DEFAULT)
        case Instance(cls=cls, key=key, place=place):
            bases = cls.external_bases() if isinstance(cls, ClassValue) else [cls.path]
            kinds = (_GROUPS.get(rclpy_names.canonical(base)) for base in bases)
            kind = next((kind for kind in kinds if kind is not None), None)
            if kind is not None:
                return model.Group(kind, str(key), place)
    return model.Group(model.GroupKind.UNKNOWN)


def timer(run: Run, call: ApiUse) -> Value:
    """``create_timer(period, callback)``."""
    if isinstance(call.receiver, Unknown) and call.get("callback") is None:
        return Unknown("the result of create_timer() of another library")
    place = run.place(call.expression.span) if call.expression is not None else Place("", 1, 1, 1, 1)
    period, parameter = _seconds(call.get("timer_period_sec"))
    made = []
    for blueprint in nodes.nodes_of(run, call.receiver):
        key = callbacks.told_apart(run, (model.EntityKind.TIMER, id(blueprint), place, period), call)
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
                stored=_stored(run, call),
            )
            run.noted.creations[key] = creation
            blueprint.creations.append(creation)
            creation.callbacks = callbacks.register_row(run, call, blueprint, creation, creation.group)
        elif not run.branch_arms:
            creation.conditional, creation.branch_arms = False, frozenset()
        made.append(creation)
    return EntityValue(tuple(made), "rclpy.timer.Timer", run.store.new_key())


def _seconds(value: Value | None) -> tuple[float | None, str | None]:
    match value:
        case Known(value=int() | float() as seconds, via=parameters):
            return float(seconds), ",".join(sorted(parameters)) or None
        case Unknown(parameter=parameter):
            return None, parameter
    return None, None


def rate(run: Run, call: ApiUse) -> Value:
    return EntityValue((), "rclpy.timer.Rate", run.store.new_key())


def transform_listener(run: Run, call: ApiUse) -> Value:
    """``TransformListener(buffer, node)`` subscribes to /tf and /tf_static in a reentrant group of its own."""
    topics: list[tuple[str, str, str, DefaultQos]] = [
        ("tf_topic", "/tf", "qos", "tf"),
        ("tf_static_topic", "/tf_static", "static_qos", "tf_static_listener"),
    ]
    if call.api.variant == "static" or call.get("static_only") == Known(True):
        topics = topics[-1:]
    made = []
    for blueprint in nodes.given_nodes(run, call.get("node")):
        for parameter, name, qos, default in topics:
            value = call.get(parameter)
            text = model.Text(name, "exact") if value is None else text_of_value(value, "no name is given")
            part = ApiUse(
                _subscription_of(call.api.path, qos, default), None, call.arguments, call.expression, False, [], {}
            )
            profile = profiles.resolve(run, call.get(qos), default, call)
            creation = _create(run, part, blueprint, text, "tf2_msgs/msg/TFMessage", None, profile, None)
            creation.group = model.Group(model.GroupKind.REENTRANT)
            made.append(creation)
    return EntityValue(tuple(made), call.api.path, run.store.new_key())


def _subscription_of(path: str, qos: str, default: DefaultQos) -> Api:
    return Api(path, "", "endpoint", kind=model.EntityKind.SUBSCRIBER, qos=qos, default_qos=default)


def transform_buffer(run: Run, call: ApiUse) -> Value:
    """``Buffer(cache_time, node)`` offers the service ``tf2_frames`` on the node it is given."""
    node = call.get("node")
    if node is not None and not node.is_none:
        row = Api(call.api.path, "", "endpoint", kind=model.EntityKind.SERVICE, default_qos="services_default")
        part = ApiUse(row, None, {}, call.expression, False, [], {})
        for blueprint in nodes.given_nodes(run, node):
            text = model.Text("tf2_frames", "exact")
            _create(run, part, blueprint, text, "tf2_msgs/srv/FrameGraph", None, profiles.DEFAULT, None)
    return Instance(External("tf2_ros.buffer.Buffer"), run.store.new_key())


_PARAMETER_SERVICES = (
    ("describe_parameters", "DescribeParameters"),
    ("get_parameter_types", "GetParameterTypes"),
    ("get_parameters", "GetParameters"),
    ("list_parameters", "ListParameters"),
    ("set_parameters", "SetParameters"),
    ("set_parameters_atomically", "SetParametersAtomically"),
)


def parameter_client(run: Run, call: ApiUse) -> Value:
    """``AsyncParameterClient(node, 'other')``: a client for each of the six parameter services of the other."""
    row = Api(call.api.path, "", "endpoint", kind=model.EntityKind.CLIENT, default_qos="services_default")
    made = []
    remote = call.get("remote_node_name") or Unknown("no name is given")
    for blueprint in nodes.given_nodes(run, call.get("node")):
        for name, type_ in _PARAMETER_SERVICES:
            text = text_of_value(join_texts((remote, Known(f"/{name}"))), "no name is given")
            part = ApiUse(row, None, {}, call.expression, False, [], {})
            profile = profiles.resolve(run, call.get("qos_profile"), "services_default", call)
            made.append(_create(run, part, blueprint, text, f"rcl_interfaces/srv/{type_}", None, profile, None))
    return EntityValue(tuple(made), call.api.path, run.store.new_key())


def destroy(run: Run, call: ApiUse) -> Value:
    value = call.rest[0] if call.rest else next(iter(call.arguments.values()), None)
    if isinstance(value, EntityValue):
        for creation in value.creations:
            creation.destroyed = True
    return Known(True)

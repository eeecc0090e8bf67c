"""What a call of a foreign function or method does to the run: the table's effects, by name."""

from __future__ import annotations

import re
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint import model
from archlint.interpreter.values import (
    ApiMethod,
    External,
    Instance,
    Known,
    OneOf,
    Unknown,
    Value,
    alternatives,
    one_of,
)
from archlint.libraries import tables
from archlint.libraries.api_use import ApiUse, Effect, Offers, argument_places, bind_api, creations_of
from archlint.libraries.python import clocks, command_line, effects
from archlint.libraries.rclpy import (
    callbacks,
    entities,
    escapes,
    executors,
    guards,
    messages,
    names,
    nodes,
    parameters,
    profiles,
)
from archlint.libraries.rclpy.values import EntityValue, ExecutorValue, FutureValue, MessageValue
from archlint.libraries.tables import Api
from archlint.syntax import facts

if TYPE_CHECKING:
    from archlint.interpreter.call_site import CallSite
    from archlint.libraries.run import Run


def call_external(run: Run, offers: Offers, function: External, site: CallSite) -> Value:
    """Call a foreign function or class by its dotted name."""
    path = names.canonical(function.path)
    interface, part = names.interface_and_part(path)
    if interface is not None:
        return _make_message(run, interface, part, site.keywords, site.expression)
    api = offers.row(path)
    if api is not None:
        receiver = None
        if _is_method(path) and site.args and api.node is None and api.effect != "qos_preset":
            receiver, site = site.args[0], replace(site, args=site.args[1:])  # Node.__init__(self, …) and the like
        return use(run, offers, api, receiver, site)
    plain = offers.plain.get(path)
    if plain is not None:
        return plain(run, site.args, site.keywords, site.expression)
    if not escapes.is_own(path):
        escapes.to_call(run, site.values, path, site.expression)
    name = path.rpartition(".")[2]
    if name[:1].isupper() or path in ("dataclasses.field",):
        place = run.place(site.expression.span) if site.expression is not None and run.activations else None
        arguments = {str(i): value for i, value in enumerate(site.args)} | site.keywords
        return Instance(External(path), run.store.new_key(), place, arguments, path)
    return Unknown(f"{path}() is outside of this workspace")


def _is_method(path: str) -> bool:
    owner = path.rpartition(".")[0].rpartition(".")[2]
    return owner[:1].isupper()


def call_method(run: Run, offers: Offers, function: ApiMethod, site: CallSite) -> Value:
    """Call a method of a foreign class, or one that a class of ours inherits from it."""
    path = function.path
    receiver = function.self_value
    api = offers.row(path)
    if api is None and path.endswith(".__init__") and isinstance(receiver, Instance):
        api = offers.row(path.removesuffix(".__init__"))
        if api is not None and api.effect == "executor":
            return executors.adopt_executor(run, api, receiver, site)
        if api is not None and api.effect in offers.bases:
            # A class of ours derived from, say, ActionServer.
            return use(run, offers, api, receiver, site)
        nodes.name_by_foreign_base(run, receiver, path)
        escapes.to_call(run, site.values, path, site.expression)
        return Unknown(f"{path} is outside of this workspace")
    if api is not None:
        return use(run, offers, api, receiver, site)
    method = offers.methods.get(path)
    if method is not None:
        return method(run, receiver, site.args, site.keywords, site.expression)
    if not escapes.is_own(path) or names.is_missing_method(path):
        escapes.to_call(run, site.values, path.removeprefix("?."), site.expression)
    return Unknown(f"{path.removeprefix('?.')}() is outside of this workspace")


def call_builtin(run: Run, offers: Offers, name: str, site: CallSite) -> Value:
    """``input()`` waits for a user; of ``open()`` only those who read files know what it gives."""
    api = offers.row(f"builtins.{name}")
    if api is not None and site.expression is not None:
        record(run, api, None, {}, site.expression)
    if name == "input":
        return Unknown("what a user types")
    plain = offers.plain.get(name)
    if plain is None:
        return Unknown(f"what {name}() gives")
    return plain(run, site.args, site.keywords, site.expression)


def use(run: Run, offers: Offers, api: Api, receiver: Value | None, site: CallSite) -> Value:
    if isinstance(receiver, OneOf):
        options = [option for option in receiver.values if not isinstance(option, Known)]
        if len(options) > 1:
            return one_of(use(run, offers, api, o, site) for o in options)
        receiver = options[0] if options else receiver
    bound, rest = bind_api(api, site.args, site.keywords)
    call = ApiUse(api, receiver, bound, site.expression, site.open, rest, site.keywords)
    if api.watched and site.expression is not None:
        record(run, api, receiver, bound, site.expression)
    return offers.effects[api.effect](run, call)


def record(run: Run, api: Api, receiver: Value | None, bound: dict[str, Value], e: facts.Call) -> None:
    """Note a call that checks want to see; one a place and context."""
    if not run.activations:
        return
    activation = run.activation
    place = run.place(e.span)
    on = creations_of(receiver)
    key: tuple[object, ...] = (api.path, place, id(run.context))
    if api.path == "rclpy.publisher.Publisher.publish" and len(on) == 1:
        key = (*key, id(on[0]))  # what is published where, for each publisher that a loop or a helper serves
    if api.path == "rclpy.timer.Timer.cancel":
        key = (*key, *(id(one) for one in on))  # which timers end here, whichever was there at first
    if api.path in parameters.BY_NAME:
        key = (*key, bound.get("name"))  # what a helper reads, for each name that it is given
    known = run.calls.get(key)
    cleaning = guards.is_cleaning_up(run)
    if known is not None:
        if known.cleaning and not cleaning:
            known.cleaning, known.chain, known.arms = False, run.chain(), tuple(run.arms)
        if known.creation is None and len(on) == 1:
            known.creation = on[0]
        known.conditional = known.conditional and bool(run.arms)
        chain, rounds = run.chain(), run.rounds()
        known.rounds = known.rounds or rounds
        is_new = chain != known.chain and all((chain, rounds) != way[:2] for way in known.ways)
        if is_new and tuple(run.arms) == known.arms:
            known.ways.append((chain, rounds, on or creations_of(bound.get("future"))))
        return
    first = on[0] if len(on) == 1 else None
    node = first.node if first is not None else nodes.known_node(run, receiver)
    loops = run.loops_of(activation)
    call = model.ApiCall(
        api.path,
        place,
        run.context,
        run.chain(),
        dict(bound),
        argument_places(run, api, e),
        receiver,
        first,
        node,
        activation.qualified,
        activation.module.path,
        e,
        activation.statement,
        tuple(loops),
        activation.body,
        bool(run.arms),
        False,
        any(one.tries for one in run.activations),
        run.rounds(),
        tuple(run.arms),
        tuple(clocks.limit_of(run, loop) for loop in loops),
        cleaning,
    )
    run.calls[key] = call
    run.program.calls.append(call)


# ------------------------------------------------------------------------------------------------ messages


def _make_message(
    run: Run, interface: str, part: str, keywords: dict[str, Value], expression: facts.Call | None
) -> Value:
    made = MessageValue(interface, part, run.store.new_key())
    messages.note_made(run, made, expression)
    for name, value in keywords.items():
        run.store.set(made.key, name, value)
    return made


def await_future(run: Run, future: FutureValue, expression: facts.Await) -> Value:
    """``await future``: the answer; noted as a wait."""
    api = Api(f"{future.api}.await", (), watched=True)
    place_call = facts.Call(expression.value, [], expression.span)
    record(run, api, future, {}, place_call)
    return answer(run, future)


def answer(run: Run, future: FutureValue) -> Value:
    """What a future gives."""
    if future.result is not None:
        return future.result
    if future.api.endswith("send_goal_async") and any(c.kind == model.ACTION_CLIENT for c in future.creations):
        return EntityValue(future.creations, "rclpy.action.client.ClientGoalHandle", run.store.new_key())
    answers = {creation.type: _answer_of(run, creation, future.api) for creation in future.creations}
    return one_of(answers.values()) if answers else Unknown("what a future gives")


def _answer_of(run: Run, creation: model.Creation, api: str) -> Value:
    if creation.kind == model.ACTION_CLIENT:
        return _action_answer(run, creation.type, api)
    if creation.type is None:
        return Unknown("the answer of a service of unknown type")
    return MessageValue(creation.type, "Response", run.store.new_key())


def _action_answer(run: Run, type_: str | None, api: str) -> Value:
    """What an action's server answers: to ``cancel_goal`` a message of its own; else the result and how it ended."""
    if "cancel_goal" in api:
        return MessageValue("action_msgs/srv/CancelGoal", "Response", run.store.new_key())
    if type_ is None:
        return Unknown("the answer of an action of unknown type")
    made = MessageValue(type_, "GetResultResponse", run.store.new_key())
    run.store.set(made.key, "result", MessageValue(type_, "Result", run.store.new_key()))
    return made


def _none(run: Run, call: ApiUse) -> Value:
    return Unknown(f"what {call.api.path}() gives")


def _register_on_client(run: Run, call: ApiUse) -> None:
    """What a client is given: a feedback callback runs in the client's group."""
    on = creations_of(call.receiver)
    node, group = (on[0].node, on[0].group) if on else (None, None)
    callbacks.register_row(run, call, node, None, group)


def _wait_answer(run: Run, call: ApiUse) -> Value:
    _register_on_client(run, call)
    on = creations_of(call.receiver)
    if on:
        return answer(run, FutureValue(on, call.api.path))
    return Unknown("the answer of a service")


def _call_async(run: Run, call: ApiUse) -> Value:
    _register_on_client(run, call)
    place = run.place(call.expression.span) if call.expression is not None else None
    return FutureValue(creations_of(call.receiver), call.api.path, place)


def _future_result(run: Run, call: ApiUse) -> Value:
    if isinstance(call.receiver, FutureValue):
        return answer(run, call.receiver)
    return Unknown("what a future gives")


def _callbacks(run: Run, call: ApiUse) -> Value:
    node = nodes.known_node(run, call.receiver)
    if node is None and isinstance(call.receiver, FutureValue) and call.receiver.creations:
        node = call.receiver.creations[0].node
    if node is None and isinstance(call.receiver, ExecutorValue):
        node = _node_of_a_task(run, call.receiver)
    callbacks.register_row(run, call, node, None, _group(run, call))
    return Unknown(f"what {call.api.path}() gives")


def _node_of_a_task(run: Run, executor: ExecutorValue) -> model.Blueprint | None:
    """The node that hands its executor a task, or the only one that the executor has."""
    served = executor.use.nodes
    return run.context.node if run.context.node in served else served[0] if len(served) == 1 else None


def _group(run: Run, call: ApiUse) -> model.Group | None:
    """Parameters are set by services of the node, which are in its default group."""
    if call.api.group is not None:
        return entities.group_of(run, call.get(call.api.group))
    return model.Group("default") if call.api.callbacks[0][1] == "parameter" else None


_GET_INTERFACE = re.compile(r"^([a-z][a-z0-9_]*)/(?:(msg|srv|action)/)?([A-Z]\w*)$")


def _get_interface(run: Run, call: ApiUse) -> Value:
    found: list[Value] = []
    for option in alternatives(call.arguments.get("identifier", Unknown("no name"))):
        match = (
            _GET_INTERFACE.match(option.value)
            if (isinstance(option, Known) and isinstance(option.value, str))
            else None
        )
        if match is None:
            found.append(Unknown("the interface is chosen by data"))
            continue
        package, kind, name = match.groups()
        found.append(External(f"{package}.{kind or call.api.kind}.{name}"))
    return one_of(found)


EFFECTS: dict[str, Effect] = {
    "none": _none,
    "create_node": nodes.create_node,
    "node_init": nodes.node_init,
    "destroy_node": nodes.destroy_node,
    "endpoint": entities.endpoint,
    "timer": entities.timer,
    "rate": entities.rate,
    "transform_listener": entities.transform_listener,
    "transform_buffer": entities.transform_buffer,
    "parameter_client": entities.parameter_client,
    "destroy": entities.destroy,
    "callbacks": _callbacks,
    "thread": callbacks.thread,
    "wait_answer": _wait_answer,
    "call_async": _call_async,
    "future_result": _future_result,
    "spin": executors.spin,
    "executor": executors.make_executor,
    "executor_spin": executors.executor_spin,
    "add_node": executors.add_node,
    "declare_parameter": parameters.declare_parameter,
    "declare_parameters": parameters.declare_parameters,
    "get_parameter": parameters.get_parameter,
    "get_parameters": parameters.get_parameters,
    "get_parameter_or": parameters.get_parameter_or,
    "get_parameters_by_prefix": parameters.get_parameters_by_prefix,
    "has_parameter": parameters.has_parameter,
    "set_parameters": parameters.set_parameters,
    "parameter": parameters.make_parameter,
    "get_name": nodes.get_name,
    "get_namespace": nodes.get_namespace,
    "get_fully_qualified_name": nodes.get_fully_qualified_name,
    "resolve_name": nodes.resolve_name,
    "qos_profile": profiles.make_profile,
    "qos_preset": profiles.preset_by_key,
    "duration": profiles.make_duration,
    "get_interface": _get_interface,
    "import_module": effects.import_module,
    "partial": effects.partial,
    "path_join": effects.path_join,
    "asks_for_file": effects.asks_for_file,
    "environment": effects.environment,
    "argument_parser": command_line.argument_parser,
}

OFFERS = Offers(
    tables.find,
    EFFECTS,
    command_line.METHODS,
    {**effects.PLAIN, **command_line.PLAIN},
    frozenset({"endpoint"}),
)
"""What Python's own library, rclpy and its kin offer."""

__all__ = ["EFFECTS", "OFFERS", "call_builtin", "call_external", "call_method"]

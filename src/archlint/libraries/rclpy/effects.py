"""What a call of rclpy or its companions does to the run: the table's effects, by name."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from archlint import model
from archlint.interpreter.values import External, Unknown, Value, alternatives, one_of
from archlint.libraries.api_use import ApiUse, Effect
from archlint.libraries.rclpy import (
    callbacks,
    declarations,
    entities,
    executors,
    groups,
    made_nodes,
    node_names,
    nodes,
    parameter_clients,
    parameter_values,
    parameters,
    presets,
    profiles,
    threads,
    timers,
    transforms,
)
from archlint.libraries.values import EntityValue, ExecutorValue, FutureValue, MessageValue, creations_of
from archlint.syntax import facts

if TYPE_CHECKING:
    from archlint.libraries.run import Run


def answer(run: Run, future: FutureValue) -> Value:
    """What a future gives."""
    if future.result is not None:
        return future.result
    if future.api.endswith("send_goal_async") and any(
        c.kind == model.EntityKind.ACTION_CLIENT for c in future.creations
    ):
        return EntityValue(future.creations, "rclpy.action.client.ClientGoalHandle", run.store.new_key())
    answers = {creation.type: _answer_of(run, creation, future.api) for creation in future.creations}
    return one_of(answers.values()) if answers else Unknown("the result of a future")


def _answer_of(run: Run, creation: model.Creation, api: str) -> Value:
    if creation.kind == model.EntityKind.ACTION_CLIENT:
        return _action_answer(run, creation.type, api)
    if creation.type is None:
        return Unknown("the response of a service of unknown type")
    response = MessageValue(creation.type, "Response", run.store.new_key())
    run.messages.answered[response.key] = creation
    return response


def _action_answer(run: Run, type_: str | None, api: str) -> Value:
    """What an action's server answers: to ``cancel_goal`` a message of its own; else the result and how it ended."""
    if "cancel_goal" in api:
        return MessageValue("action_msgs/srv/CancelGoal", "Response", run.store.new_key())
    if type_ is None:
        return Unknown("the response of an action of unknown type")
    response = MessageValue(type_, "GetResultResponse", run.store.new_key())
    run.store.set(response.key, "result", MessageValue(type_, "Result", run.store.new_key()))
    return response


def _none(run: Run, call: ApiUse) -> Value:
    return Unknown(f"the result of {call.api.path}()")


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
    return Unknown("the response of a service")


def _call_async(run: Run, call: ApiUse) -> Value:
    _register_on_client(run, call)
    place = run.place(call.expression.span) if call.expression is not None else None
    if place is not None and _is_of_own_client(call):
        run.messages.asked_in[place] = run.activation
    return FutureValue(creations_of(call.receiver), call.api.path, place)


def _is_of_own_client(call: ApiUse) -> bool:
    """``self.client.call_async(…)``: whoever calls the method gets an answer of the same type."""
    match call.expression:
        case facts.Call(func=facts.Attribute(value=facts.Attribute(value=facts.Name(id="self")))):
            return len({creation.type for creation in creations_of(call.receiver)}) == 1
    return False


def _future_result(run: Run, call: ApiUse) -> Value:
    if not isinstance(call.receiver, FutureValue):
        return Unknown("the result of a future")
    result, asked = answer(run, call.receiver), call.receiver.place
    if asked is not None and run.messages.asked_in.get(asked) is run.activation and isinstance(result, MessageValue):
        run.messages.made_in[result.key] = run.activation
    return result


def _callbacks(run: Run, call: ApiUse) -> Value:
    node = nodes.known_node(run, call.receiver)
    if node is None and isinstance(call.receiver, FutureValue) and call.receiver.creations:
        node = call.receiver.creations[0].node
    if node is None and isinstance(call.receiver, ExecutorValue):
        node = _node_of_a_task(run, call.receiver)
    if call.api.callbacks[0][1] == model.Role.TASK:
        callbacks.task(run, call, node)
        return Unknown(f"the result of {call.api.path}()")
    callbacks.register_row(run, call, node, None, _group(run, call))
    return Unknown(f"the result of {call.api.path}()")


def _node_of_a_task(run: Run, executor: ExecutorValue) -> model.Blueprint | None:
    """The node that gives its executor a task, or the only one that the executor has."""
    served = executor.use.nodes
    return run.context.node if run.context.node in served else served[0] if len(served) == 1 else None


def _group(run: Run, call: ApiUse) -> model.Group | None:
    """Parameters are set by services of the node, which are in its default group."""
    if call.api.group is not None:
        return groups.group_of(run, call.get(call.api.group))
    return model.Group(model.GroupKind.DEFAULT) if call.api.callbacks[0][1] == model.Role.PARAMETER else None


_GET_INTERFACE = re.compile(r"^([a-z][a-z0-9_]*)/(?:(msg|srv|action)/)?([A-Z]\w*)$")


def _get_interface(run: Run, call: ApiUse) -> Value:
    classes: list[Value] = []
    for option in alternatives(call.arguments.get("identifier", Unknown("no name"))):
        match = _GET_INTERFACE.match(option.text or "")
        if match is None:
            classes.append(Unknown("the interface is chosen at run time"))
            continue
        package, kind, name = match.groups()
        classes.append(External(f"{package}.{kind or call.api.makes}.{name}"))
    return one_of(classes)


EFFECTS: dict[str, Effect] = {
    "none": _none,
    "create_node": made_nodes.create_node,
    "initialise": made_nodes.initialise,
    "node_init": made_nodes.node_init,
    "destroy_node": made_nodes.destroy_node,
    "endpoint": entities.endpoint,
    "timer": timers.timer,
    "rate": timers.rate,
    "transform_listener": transforms.transform_listener,
    "static_transform_listener": transforms.static_transform_listener,
    "transform_buffer": transforms.transform_buffer,
    "parameter_client": parameter_clients.parameter_client,
    "destroy": entities.destroy,
    "callbacks": _callbacks,
    "thread": threads.thread,
    "submit": threads.submit,
    "submit_each": threads.submit_each,
    "wait_answer": _wait_answer,
    "call_async": _call_async,
    "future_result": _future_result,
    "spin": executors.spin,
    "executor": executors.make_executor,
    "executor_spin": executors.executor_spin,
    "add_node": executors.add_node,
    "remove_node": executors.remove_node,
    "declare_parameter": declarations.declare_parameter,
    "declare_parameters": declarations.declare_parameters,
    "get_parameter": parameters.get_parameter,
    "get_parameters": parameters.get_parameters,
    "get_parameter_or": parameters.get_parameter_or,
    "get_parameters_by_prefix": parameters.get_parameters_by_prefix,
    "has_parameter": parameters.has_parameter,
    "set_parameters": parameters.set_parameters,
    "parameter": parameter_values.make_parameter,
    "get_name": node_names.get_name,
    "get_namespace": node_names.get_namespace,
    "get_fully_qualified_name": node_names.get_fully_qualified_name,
    "resolve_name": node_names.resolve_name,
    "qos_profile": profiles.make_profile,
    "qos_preset": presets.preset_by_key,
    "duration": profiles.make_duration,
    "get_interface": _get_interface,
}
"""What a call of the table does, by the effect that its row names."""

__all__ = ["EFFECTS", "answer"]

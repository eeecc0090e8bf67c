"""Callbacks: what is handed to an executor, a future or a thread, noted to be run later."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING, Any

from archlint import model
from archlint.branches import ChoiceOfArgument
from archlint.finding import Place
from archlint.interpreter import containers
from archlint.interpreter.attributes import get_attribute
from archlint.interpreter.bindings import bound_names
from archlint.interpreter.call_site import CallSite
from archlint.interpreter.identity import Key, kind_key
from archlint.interpreter.modules import Scope
from archlint.interpreter.values import (
    ApiMethod,
    BoundMethod,
    Builtin,
    ClassValue,
    DictValue,
    External,
    FunctionValue,
    Instance,
    Known,
    ListValue,
    OneOf,
    Partial,
    Unknown,
    Value,
    alternatives,
)
from archlint.libraries import tables
from archlint.libraries.interest import interesting
from archlint.libraries.rclpy import messages, node_classes
from archlint.libraries.rclpy import names as rclpy_names
from archlint.libraries.rclpy.interface_types import types_of
from archlint.libraries.state import Pending
from archlint.libraries.uses import bare
from archlint.libraries.values import EntityValue, FutureValue, MessageValue, NodeValue
from archlint.syntax import facts
from archlint.syntax.parts import names_in

if TYPE_CHECKING:
    from archlint.libraries.api_use import ApiUse
    from archlint.libraries.run import Run

WAYS = 16
"""For how many values one place hands the same callback over: the next ones are taken to be like these."""
GOAL_HANDLE = External("rclpy.action.server.ServerGoalHandle")


def register_row(
    run: Run,
    call: ApiUse,
    node: model.Blueprint | None,
    creation: model.Creation | None,
    group: model.Group | None = None,
) -> dict[model.Role, model.Callback]:
    """Register all callbacks that a call of the table hands over."""
    found: dict[model.Role, model.Callback] = {}
    for parameter, role in call.api.callbacks:
        value = call.get(parameter)
        if value is None:
            continue
        callback = register(run, value, role, node, creation, group, call)
        if callback is not None:
            found[role] = callback
    return found


_IN_NO_GROUP = (model.Role.EXECUTE, model.Role.DONE, model.Role.TASK, model.Role.THREAD)


def register(
    run: Run,
    value: Value,
    role: model.Role,
    node: model.Blueprint | None,
    creation: model.Creation | None,
    group: model.Group | None,
    call: ApiUse,
    arguments: tuple[Value, ...] | None = None,
) -> model.Callback | None:
    """Note a callable under its role; the first callable of several alternatives names the callback."""
    made: model.Callback | None = None
    for option in _callables(value):
        callback = describe(run, option, role)
        callback.node = node
        callback.creation = creation
        callback.group = None if role in _IN_NO_GROUP else group
        callback.registered = run.place(call.expression.span) if call.expression is not None else None
        key = (role, callback.registered, callback.name, callback.place, id(creation), _receiver(option))
        if not _is_new(run, key, callback, (option, call.receiver, *(arguments or ()))):
            continue
        run.program.callbacks.append(callback)
        if node is not None:
            node.callbacks.append(callback)
        if callback.function is not None:
            given = arguments if arguments is not None else default_arguments(run, role, creation, call)
            if creation is not None and not _is_one_of_several(value, creation):
                messages.deliver(run, given, creation)
            run.callbacks.pending.append(Pending(callback, option, given, run.callbacks.lineage))
        elif isinstance(option, (Partial, ApiMethod)):
            run.library.escaped((option,), "it is bound to a callback that is not followed", call.expression)
        made = made or callback
    return made


def _callables(value: Value) -> list[Value]:
    """What a value may be, but for constants: None is no callback."""
    return [option for option in alternatives(value) if not isinstance(option, Known)]


def _is_one_of_several(value: Value, creation: model.Creation) -> bool:
    """Whether it is not known which of several callables, names or types the create call is given: they may belong
    together in pairs."""
    return len(_callables(value)) > 1 or any(isinstance(branch, ChoiceOfArgument) for branch, _ in creation.branch_arms)


def _is_new(run: Run, key: tuple[Any, ...], callback: model.Callback, given: Iterable[Value | None]) -> bool:
    """Whether a callback was not handed over in this way before; one place may do it for several futures, names or
    objects.  One that hands itself over again is not new, whatever it takes along."""
    ways = run.callbacks.registered.setdefault(key, set())
    if ways and callback.function in run.callbacks.lineage:
        return False
    way = tuple(kind_key(run.store, one) for one in given if one is not None)
    if way in ways or len(ways) >= WAYS:
        return False
    ways.add(way)
    return True


def hand_out(run: Run, values: Iterable[Value]) -> None:
    """Note functions that are given to code which we do not see (an event loop, a user interface): it may call
    them.  Methods of objects need a note only where a partial gives them something to work on, since all that can
    matter are run."""
    for option in (option for value in values for option in alternatives(value)):
        function, given = _taken_apart(option)
        inner = function.callee
        if not isinstance(inner, FunctionValue) or (inner is not function and not any(map(_holds_more, given))):
            continue
        if not (given or any(interesting(one.ir) or _passes_on(run, one) for one in _led_to(run, inner))):
            continue
        callback = describe(run, option, model.Role.METHOD)
        # Once a function, whatever scope it is defined in: one that defines others and hands them out has no end.
        key = (model.Role.METHOD, None, callback.name, callback.place, 0, 0)
        if key in run.callbacks.registered:
            continue
        run.callbacks.registered[key] = set()
        run.program.callbacks.append(callback)
        run.callbacks.pending.append(Pending(callback, option, (), run.callbacks.lineage))


def _holds_more(value: object) -> bool:
    """Whether a value is an object or a collection, from which others may be got."""
    return isinstance(value, (Instance, NodeValue, ListValue, DictValue))


def _taken_apart(value: Value) -> tuple[Value, list[Value]]:
    """A callable without its partials, and what these give it."""
    given: list[Value] = []
    while isinstance(value, Partial):
        given += [*value.args, *(one for _, one in value.keywords)]
        value = value.function
    return value, given


def _led_to(run: Run, function: FunctionValue) -> Iterator[FunctionValue]:
    """A function, and the functions that it names (so it may call them), and so on."""
    waiting = [function]
    seen: set[int] = set()
    while waiting:
        one = waiting.pop()
        if id(one.ir) in seen:
            continue
        seen.add(id(one.ir))
        yield one
        names = names_in(one.ir)
        scope: Scope | None = one.scope
        while scope is not None:
            values = (run.store.get(scope.key, name) for name in sorted(names) if scope.kind != "class")
            waiting += [value for value in values if isinstance(value, FunctionValue)]
            scope = scope.parent


def _passes_on(run: Run, function: FunctionValue) -> bool:
    """Whether a function hands on an object that it closes over."""
    own = bound_names(function.ir)[0]
    closed_over: set[str] = {name for name, value in function.defaults if _holds_more(value)}
    scope: Scope | None = function.scope
    while scope is not None and scope.kind != "module":
        if scope.kind != "class":
            names = names_in(function.ir) - own
            closed_over |= {name for name in names if _holds_more(run.store.get(scope.key, name))}
        scope = scope.parent
    return bool(closed_over) and bare(function.ir, frozenset(closed_over))


def _receiver(value: Value) -> int:
    match value:
        case BoundMethod(self_value=Instance(key=key)):
            return key
        case Partial(function=function):
            return _receiver(function)
    return 0


def told_apart(run: Run, base: Key, call: ApiUse) -> Key:
    """What tells a creation from others of the same place and name (``base``): the functions that are called, for
    timers with all that they take along.  Where callbacks run once more, the first one there is meant."""
    given = [call.get(parameter) for parameter, _ in call.api.callbacks]
    closely = call.api.effect == "timer"
    options = [option for value in given if value is not None for option in alternatives(value)]
    functions = options if closely else [_taken_apart(option)[0] for option in options]
    apart = tuple(kind_key(run.store, function, closely=closely) for function in functions)
    first = run.noted.told_apart.setdefault(base, apart)
    return (*base, apart if run.nodes.met_again is None else first)


def default_arguments(run: Run, role: model.Role, creation: model.Creation | None, call: ApiUse) -> tuple[Value, ...]:
    """What rclpy calls a callback of this role with."""
    type_ = creation.type if creation is not None and not _may_be_another_type(call) else None

    def message(part: str) -> Value:
        if type_ is None:
            return Unknown("a message of unknown type")
        return MessageValue(type_, part, run.store.new_key())

    if role == model.Role.SUBSCRIPTION:
        return (message(""),)
    if role == model.Role.SERVICE:
        return (message("Request"), message("Response"))
    if role in (model.Role.EXECUTE, model.Role.CANCEL, model.Role.ACCEPTED):
        goal = message("Goal")
        made = Instance(GOAL_HANDLE, run.store.new_key(), None, {"request": goal})
        run.store.set(made.key, "request", goal)
        return (made,)
    if role == model.Role.GOAL:
        return (message("Goal"),)
    if role == model.Role.DONE:
        return (call.receiver,) if isinstance(call.receiver, FutureValue) else (Unknown("a future"),)
    if role == model.Role.FEEDBACK:
        return (_feedback(run, call),)
    if role in (model.Role.PARAMETER, model.Role.EVENT, model.Role.FILTER):
        return (Unknown("an argument that rclpy passes to the callback"),)
    return ()


def _may_be_another_type(call: ApiUse) -> bool:
    """Whether the create call is given one of several types, not all of which are known: the callback may be for
    those alone."""
    types = types_of(call)
    return len(types) > 1 and any(type_ is None for type_, _ in types)


def _feedback(run: Run, call: ApiUse) -> Value:
    """What a feedback callback is called with: the feedback and the goal it is for."""
    creations = call.receiver.creations if isinstance(call.receiver, EntityValue) else ()
    type_ = creations[0].type if len(creations) == 1 else None
    if type_ is None:
        return Unknown("the feedback of an action of unknown type")
    made = MessageValue(type_, "FeedbackMessage", run.store.new_key())
    run.store.set(made.key, "feedback", MessageValue(type_, "Feedback", run.store.new_key()))
    return made


def describe(run: Run, value: Value, role: model.Role) -> model.Callback:
    """What a callable is, for people: its name and where it is defined."""
    here = run.place((1, 1, 1, 1))
    match value:
        case FunctionValue(ir=ir, qualified=qualified):
            place = Place(value.scope.module.path, *ir.name_span)
            code = model.FunctionRef(qualified, place, isinstance(ir, facts.Lambda))
            return model.Callback(role, qualified, place, code, is_async=ir.is_async, file=place.file)
        case BoundMethod(function=function):
            callback = describe(run, function, role)
            callback.bound_arguments += 1
        case Partial(function=function):
            callback = describe(run, function, role)
            callback.bound_arguments += len(value.args)
            callback.bound_keywords |= {name for name, _ in value.keywords}
        case Instance(cls=ClassValue(qualified=qualified)):
            method = get_attribute(run, value, "__call__")
            bound = isinstance(method, BoundMethod)
            callback = describe(run, method, role) if bound else model.Callback(role, qualified, here, None)
        case ApiMethod(path=name) | External(path=name) | Builtin(name=name):
            callback = model.Callback(role, name, here, None)
            callback.missing = _missing_method(value)
        case Unknown():
            callback = model.Callback(role, "?", here, None)
            callback.missing = value.missing
        case _:
            callback = model.Callback(role, "?", here, None)
    return callback


def function_of(run: Run, value: Value) -> FunctionValue | None:
    """The function that a callable runs in the end, whatever is bound to it."""
    match callee := value.callee:
        case FunctionValue():
            return callee
        case Instance(cls=ClassValue()):
            method = get_attribute(run, callee, "__call__")
            return function_of(run, method) if isinstance(method, BoundMethod) else None
    return None


def _missing_method(value: Value) -> str | None:
    """The name of a method that a node of ours is asked for and that neither its class nor rclpy's has."""
    match value:
        case ApiMethod(path=path, self_value=Instance(cls=ClassValue() as cls)):
            base, _, name = path.rpartition(".")
        case _:
            return None
    if base not in rclpy_names.NODE_CLASSES or (name.startswith("__") and name.endswith("__")):
        return None
    public = rclpy_names.is_node_attribute(name) and not name.startswith(("on_", "__"))
    of_rclpy = public or name in rclpy_names.PRIVATE_NODE_METHODS
    if node_classes.is_lifecycle(cls):
        of_rclpy = of_rclpy or name in rclpy_names.LIFECYCLE_METHODS
    return None if of_rclpy or not node_classes.has_only(cls) else name


def thread(run: Run, call: ApiUse) -> Value:
    """``threading.Thread(target=…, args=…)``."""
    arguments: list[Value] = []
    given = call.get("args")
    if isinstance(given, ListValue):
        arguments = list(containers.items_of(run, given).values)
    keywords = call.get("kwargs")
    for parameter, role in call.api.callbacks:
        value = call.get(parameter)
        if value is None:
            continue
        if isinstance(keywords, DictValue):
            entries = containers.entries_of(run, keywords).entries.values()
            pairs = tuple((key.text, item) for key, item in entries if key.text is not None)
            value = Partial(value, (), pairs) if pairs else value
        register(run, value, role, None, None, None, call, tuple(arguments))
        if isinstance(value, (Unknown, OneOf)):
            run.library.given_away(CallSite(arguments))
        _run_foreign_target(run, value, arguments, call)
    place = run.place(call.expression.span) if call.expression is not None else None
    return Instance(External(call.api.path), run.store.new_key(), place)


def _run_foreign_target(run: Run, value: Value, arguments: list[Value], call: ApiUse) -> None:
    """``Thread(target=executor.spin)`` and ``Thread(target=rclpy.spin, args=(node,))``: no function of ours, so
    nothing is left to be run later."""
    for option in alternatives(value):
        match option.callee:
            case ApiMethod(path=path) | External(path=path):
                _run_apart(run, option, path, arguments, call.expression)


def _run_apart(run: Run, target: Value, name: str, arguments: Iterable[Value], expression: facts.Call | None) -> None:
    """A function of a library runs in a thread that is started here."""
    kept = run.context
    place = kept.place if expression is None else run.place(expression.span)
    run.context = model.Callback(model.Role.THREAD, name, place, None, file=place.file)
    try:
        run.call(target, CallSite(list(arguments)))
    finally:
        run.context = kept


def run_handed_spins(run: Run, values: Iterable[Value], expression: facts.Call | None) -> None:
    """Run the spins of executors that code is given which we do not see: it can do nothing with one but call it, in a
    thread of its own most likely, as ``loop.run_in_executor(None, executor.spin)`` does."""
    for option in (option for value in values for option in alternatives(value)):
        path = option.path if isinstance(option, ApiMethod) else ""
        row = tables.find(path)
        if row is not None and row.effect == "executor_spin":
            _run_apart(run, option, path, (), expression)

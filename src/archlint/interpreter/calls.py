"""Calls: binding arguments, entering functions, making objects, defining functions and classes."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.finding import Place
from archlint.interpreter import hints, refusals, repeats
from archlint.interpreter.attributes import get_attribute
from archlint.interpreter.bindings import bound_names
from archlint.interpreter.builtin_functions import BUILTINS, call_builtin
from archlint.interpreter.definitions import instantiate
from archlint.interpreter.values import (
    NONE,
    ApiMethod,
    BoundMethod,
    Builtin,
    ClassValue,
    DictValue,
    External,
    FunctionValue,
    FutureValue,
    Instance,
    Known,
    ListValue,
    NodeValue,
    OneOf,
    Partial,
    PythonValue,
    SuperValue,
    Unknown,
    Value,
    alternatives,
    one_of,
)
from archlint.libraries.python import tasks
from archlint.libraries.rclpy import effects, escapes
from archlint.syntax import facts

if TYPE_CHECKING:
    from archlint.interpreter.machine import Run

__all__ = ["BUILTINS", "call"]


# ----------------------------------------------------------------------------------------- a call expression


def evaluate_call(run: Run, e: facts.Call) -> Value:
    if isinstance(e.func, facts.Name) and e.func.id == "super" and run.lookup("super") is None:
        return _super(run, e)
    if isinstance(e.func, facts.Name) and e.func.id in ("locals", "globals"):
        return Unknown("the variables as a dict")
    function = run.evaluate(e.func)
    tasks.note_started(run, e, function)
    args, keywords, open_ = evaluate_arguments(run, e.args)
    refusals.check_call(run, function, args, keywords, e, open_)
    with tasks.apart(run, e, function):
        return call(run, function, args, keywords, e, open_)


def evaluate_arguments(run: Run, arguments: list[facts.Argument]) -> tuple[list[Value], dict[str, Value], bool]:
    """Positional and keyword arguments; the flag says that more may follow than are known."""
    from archlint.interpreter import containers

    args: list[Value] = []
    keywords: dict[str, Value] = {}
    open_ = False
    for argument in arguments:
        value = run.evaluate(argument.value)
        if argument.star == "*":
            items = containers.iterate(run, value)
            if items is None or items.open:
                open_ = True
            if items is not None:
                args.extend(items.values[: max(0, containers.ITEM_LIMIT - len(args))])
                open_ = open_ or len(args) >= containers.ITEM_LIMIT
        elif argument.star == "**":
            if isinstance(value, DictValue):
                entries = containers.entries_of(run, value)
                open_ = open_ or entries.open
                for key, item in entries.entries.values():
                    if isinstance(key, Known) and isinstance(key.value, str):
                        keywords[key.value] = item
            else:
                open_ = True
        elif argument.keyword is not None:
            keywords[argument.keyword] = value
        else:
            args.append(value)
    return args, keywords, open_


def _super(run: Run, e: facts.Call) -> Value:
    if e.args:
        args, _, _ = evaluate_arguments(run, e.args)
        if len(args) >= 2 and isinstance(args[0], ClassValue):
            return SuperValue(args[0], args[1])
    for activation in reversed(run.activations):
        if activation.function is not None and activation.function.owner is not None:
            if activation.self_value is not None:
                return SuperValue(activation.function.owner, activation.self_value)
            break
        if activation.scope.kind not in ("function", "comprehension"):
            break
    return Unknown("super() outside of a method")


def call(
    run: Run,
    function: Value,
    args: list[Value],
    keywords: dict[str, Value],
    expression: facts.Call | None = None,
    open_arguments: bool = False,
) -> Value:
    """Call a value.  What is not known to be callable evaluates to unknown."""
    if isinstance(function, OneOf):
        return _call_alternatives(run, function, args, keywords, expression, open_arguments)
    if isinstance(function, BoundMethod):
        if isinstance(function.function, FunctionValue):
            self_value = function.self_value
            return call_function(
                run, function.function, [self_value, *args], keywords, expression, open_arguments, self_value
            )
        return call(run, function.function, [function.self_value, *args], keywords, expression, open_arguments)
    if isinstance(function, FunctionValue):
        return call_function(run, function, args, keywords, expression, open_arguments)
    if isinstance(function, ClassValue):
        return instantiate(run, function, args, keywords, expression, open_arguments)
    if isinstance(function, Partial):
        merged = {**dict(function.keywords), **keywords}
        return call(run, function.function, [*function.args, *args], merged, expression, open_arguments)
    if isinstance(function, PythonValue):
        return function.function(*args, **keywords)
    if isinstance(function, ApiMethod):
        return effects.call_method(run, function, args, keywords, expression, open_arguments)
    if isinstance(function, External):
        return effects.call_external(run, function, args, keywords, expression, open_arguments)
    if isinstance(function, Builtin):
        return call_builtin(run, function, args, keywords, expression, open_arguments)
    if isinstance(function, Instance) and isinstance(function.cls, ClassValue):
        method = get_attribute(run, function, "__call__")
        if isinstance(method, BoundMethod):
            return call(run, method, args, keywords, expression, open_arguments)
    escapes.to_call(run, [*args, *keywords.values()], "", expression)
    if isinstance(function, Unknown):
        return Unknown(function.reason, function.parameter)
    return Unknown("the result of a call that is not followed")


def _call_alternatives(
    run: Run,
    function: OneOf,
    args: list[Value],
    keywords: dict[str, Value],
    expression: facts.Call | None,
    open_arguments: bool,
) -> Value:
    callable_ = [f for f in function.values if not (isinstance(f, Known) and f.value is None)]
    if len(callable_) == 1:
        return call(run, callable_[0], args, keywords, expression, open_arguments)
    span = expression.span if expression is not None else (0, 0, 0, 0)
    key = run.key_of(span) + "?" if run.activations else "?"
    found = []
    layers = []
    for number, option in enumerate(callable_):
        with run.arm(key, number) as taken:
            found.append(call(run, option, list(args), dict(keywords), expression, open_arguments))
        layers.append(taken[0])
    run.store.merge(layers)
    return one_of(found)


# -------------------------------------------------------------------------------------- entering a function


def parameters_of(ir: facts.Function | facts.Lambda) -> list[facts.Param]:
    return ir.params


def bind_arguments(
    run: Run,
    function: FunctionValue,
    args: list[Value],
    keywords: dict[str, Value],
    open_arguments: bool,
) -> dict[str, Value]:
    """The parameters of a function as a call sets them."""
    from archlint.interpreter import containers

    defaults = dict(function.defaults)
    bound: dict[str, Value] = {}
    rest = list(args)
    left = dict(keywords)
    for param in function.ir.params:
        if param.kind == "star":
            bound[param.name] = containers.new_list(run, rest, "tuple", open_arguments)
            rest = []
        elif param.kind == "double_star":
            entries = {containers.hashable(Known(k)): (Known(k), v) for k, v in left.items()}
            bound[param.name] = containers.new_dict(
                run, {k: v for k, v in entries.items() if k is not None}, open_arguments
            )
            left = {}
        elif param.kind in ("positional_only", "normal") and rest:
            bound[param.name] = rest.pop(0)
        elif param.name in left and param.kind != "positional_only":
            bound[param.name] = left.pop(param.name)
        elif open_arguments:
            bound[param.name] = Unknown(f"the argument '{param.name}' is passed by * or **")
        elif param.name in defaults:
            bound[param.name] = defaults[param.name]
        else:
            meant = hints.class_named(run, function.scope, param.annotation)
            bound[param.name] = Unknown(f"nothing in the workspace passes '{param.name}'", None, meant, param.name)
    return bound


def call_function(
    run: Run,
    function: FunctionValue,
    args: list[Value],
    keywords: dict[str, Value],
    expression: facts.Call | None = None,
    open_arguments: bool = False,
    self_value: Value | None = None,
) -> Value:
    """Run a function of the workspace and return what it may return."""
    from archlint.interpreter.machine import DEPTH

    ir = function.ir
    running = sum(
        1 for activation in run.activations if activation.function is not None and activation.function.ir is ir
    )
    if running > 2:
        return Unknown(f"'{function.qualified}' calls itself")
    if len(run.activations) >= DEPTH:
        run.program.exhausted = True
        return Unknown("the chain of calls is too deep to follow")
    key = repeats.call_key(function, args, keywords)

    def enter() -> Value:
        return enter_function(run, function, args, keywords, expression, open_arguments, self_value)

    return repeats.follow(run, function, key, enter)


def enter_function(
    run: Run,
    function: FunctionValue,
    args: list[Value],
    keywords: dict[str, Value],
    expression: facts.Call | None,
    open_arguments: bool,
    self_value: Value | None,
) -> Value:
    from archlint.interpreter.machine import Activation

    ir = function.ir
    module = function.scope.module
    bound = bind_arguments(run, function, args, keywords, open_arguments)
    self_value = self_value or _self_of(function, bound)
    instance_key = self_value.key if isinstance(self_value, (Instance, NodeValue)) else 0
    run.executed.add((instance_key, id(ir)))
    run.ran.add(id(ir))
    names, outer = bound_names(ir)
    scope = run.new_scope(function.scope, module, "function", function.qualified, names, outer)
    body = ir.body if isinstance(ir, facts.Function) else []
    call_place = None
    if expression is not None and run.activations:
        call_place = run.place(expression.span)
        run.callers.setdefault(id(ir), set()).add(call_place)
    depth = run.store.depth
    activation = Activation(function.qualified, module, scope, body, depth, function, self_value, call_place)
    activation.arms = len(run.arms)
    activation.scopes.append(scope.key)
    run.store.push()
    for name, value in bound.items():
        run.store.set(scope.key, name, value)
    run.activations.append(activation)
    try:
        if isinstance(ir, facts.Lambda):
            result = run.evaluate(ir.body)
            status = None
        else:
            status = run.execute(body)
            result = NONE
    finally:
        run.activations.pop()
        layer = run.store.cut(depth)
        for node in activation.short_lived:
            node.until = len(run.nodes)
    if isinstance(ir, facts.Lambda):
        run.store.merge([layer])
        return result
    return _leave_function(run, ir, activation, status, layer)


def _self_of(function: FunctionValue, bound: dict[str, Value]) -> Value | None:
    """The object that a method of a class works on where it is called by way of the class: ``Base.__init__(self)``."""
    ir = function.ir
    if function.owner is None or not ir.params or "staticmethod" in function.decorators:
        return None
    first = bound.get(ir.params[0].name)
    return first if isinstance(first, (Instance, ClassValue)) else None


def _leave_function(run: Run, ir: facts.Function, activation: object, status: str | None, layer: object) -> Value:
    from archlint.interpreter import containers
    from archlint.interpreter.machine import Activation

    assert isinstance(activation, Activation) and isinstance(layer, dict)
    captured = [kept for _, kept in activation.returns if kept is not None]
    activation.forget([*captured, layer])
    falls_through = status not in ("return", "raise")
    straight = any(kept is None for _, kept in activation.returns)
    if not captured:
        run.store.layers[-1].update(layer)
    else:
        run.store.merge([*captured, layer] if falls_through or straight else captured)
    if ir.is_generator:
        return containers.new_list(run, activation.yields, "generator", True)
    values = [value for value, _ in activation.returns]
    if falls_through and not straight:
        values.append(NONE)
    if not values:
        return Unknown(f"'{activation.qualified}' raises")
    return one_of(values)


# ------------------------------------------------------------------------------------------- odds and ends


def awaited(run: Run, value: Value, expression: facts.Await) -> Value:
    """``await value``."""
    found = []
    for option in alternatives(value):
        if isinstance(option, FutureValue):
            found.append(effects.await_future(run, option, expression))
        else:
            found.append(option)
    return one_of(found)


def enter(run: Run, value: Value) -> Value:
    """What ``with value as x`` binds."""
    from archlint.interpreter import containers

    if isinstance(value, ListValue) and value.kind == "generator":
        items = containers.items_of(run, value)
        return items.values[0] if items.values else Unknown("what a context manager gives")
    if isinstance(value, Instance) and isinstance(value.cls, ClassValue):
        method = get_attribute(run, value, "__enter__")
        if isinstance(method, BoundMethod):
            return call(run, method, [], {})
    return value


_EXITS = frozenset({"sys.exit", "os._exit"})


def never_returns(run: Run, e: facts.Call) -> bool:
    """``sys.exit()`` and the like."""
    if isinstance(e.func, facts.Name):
        return e.func.id in ("exit", "quit") and run.lookup(e.func.id) is None
    if isinstance(e.func, facts.Attribute) and isinstance(e.func.value, facts.Name):
        value = run.lookup(e.func.value.id)
        return isinstance(value, External) and f"{value.path}.{e.func.attr}" in _EXITS
    return False


def place_of(function: FunctionValue) -> Place:
    span = function.ir.name_span if isinstance(function.ir, facts.Function) else function.ir.span
    return Place(function.scope.module.path, *span)

"""Calls: what runs, with which arguments, and what it leaves behind."""

from __future__ import annotations

from dataclasses import replace

from archlint.branches import ChoiceOfCallee
from archlint.interpreter import containers, hints, overloads, references, repeats
from archlint.interpreter.activation import Activation
from archlint.interpreter.attributes import method_of
from archlint.interpreter.bindings import bound_names
from archlint.interpreter.builtins import call_builtin
from archlint.interpreter.call_site import CallSite
from archlint.interpreter.heap import Layer
from archlint.interpreter.limits import DEPTH, NESTED_CALLS
from archlint.interpreter.machine import Machine, Status
from archlint.interpreter.objects.classes import instantiate
from archlint.interpreter.values import (
    NONE,
    ApiMethod,
    BoundMethod,
    Builtin,
    ClassValue,
    External,
    ForeignValue,
    FunctionValue,
    Holed,
    Instance,
    Known,
    OneOf,
    Partial,
    PythonValue,
    Unknown,
    Value,
    chosen_for,
    chosen_with,
    one_of,
)
from archlint.reasons import NotPassed
from archlint.syntax import facts

__all__ = ["call", "call_function"]


# ------------------------------------------------------------------------------------------- whatever is called


def call(machine: Machine, function: Value, site: CallSite) -> Value:
    """Call a value.  What is not known to be callable evaluates to unknown."""
    match function:
        case BoundMethod(function=FunctionValue() as method):
            return call_function(machine, method, site.after(function.self_value), function.self_value)
        case BoundMethod():
            return call(machine, function.function, site.after(function.self_value))
        case FunctionValue():
            return call_function(machine, function, site)
        case External():
            return machine.library.call_function(function, site)
        case ApiMethod():
            return machine.library.call_method(function, site)
        case Builtin():
            return call_builtin(machine, function, site)
        case ClassValue():
            return instantiate(machine, function, site)
        case OneOf():
            return _call_alternatives(machine, function, site)
        case Partial():
            merged = {**dict(function.keywords), **site.keywords}
            return call(machine, function.function, replace(site, args=[*function.args, *site.args], keywords=merged))
        case PythonValue():
            return function.function(*site.args, **site.keywords)
        case Instance(cls=ClassValue()):
            bound = method_of(machine, function, "__call__")
            if bound is not None:
                return call(machine, bound, site)
    machine.library.note_uncallable(function, site)
    machine.library.given_away(site)
    if isinstance(function, Unknown):
        return Unknown(function.reason, function.parameter)
    return Unknown("the result of a call that is not followed")


def _call_alternatives(machine: Machine, function: OneOf, site: CallSite) -> Value:
    callable_ = [option for option in function.values if not option.is_none]
    if len(callable_) == 1:
        return call(machine, callable_[0], site)
    line, column = site.expression.span[:2] if site.expression is not None else (0, 0)
    key = ChoiceOfCallee(machine.activation.module.path if machine.activations else "", line, column)
    results = []
    layers = []
    for number, option in enumerate(callable_):
        with machine.arm(key, number) as taken:
            results.append(call(machine, option, replace(site, args=list(site.args), keywords=dict(site.keywords))))
        layers.append(taken[0])
    machine.store.merge(layers)
    return chosen_with(one_of(results), function)


# -------------------------------------------------------------------------------------- entering a function


def bind_arguments(machine: Machine, function: FunctionValue, site: CallSite) -> dict[str, Value]:
    """The parameters of a function as a call sets them."""
    defaults = dict(function.defaults)
    bound: dict[str, Value] = {}
    rest = list(site.args)
    left = dict(site.keywords)
    for param in function.ir.params:
        if param.kind == "star":
            bound[param.name] = containers.new_list(machine, rest, "tuple", site.open)
            rest = []
        elif param.kind == "double_star":
            bound[param.name] = containers.dict_of_names(machine, left, site.open)
            left = {}
        elif param.kind in ("positional_only", "normal") and rest:
            bound[param.name] = rest.pop(0)
        elif param.name in left and param.kind != "positional_only":
            bound[param.name] = left.pop(param.name)
        elif site.open:
            bound[param.name] = Unknown(f"the argument '{param.name}' is passed by * or **")
        elif param.name in defaults:
            bound[param.name] = defaults[param.name]
        else:
            meant = hints.class_named(machine, function.scope, param.annotation)
            bound[param.name] = Unknown(NotPassed.as_parameter(param.name), None, meant, param.name)
    return bound


def call_function(machine: Machine, function: FunctionValue, site: CallSite, self_value: Value | None = None) -> Value:
    """Run a function of the workspace and return what it may return."""
    function = overloads.meant(machine.index.overloads, function, site)
    ir = function.ir
    if self_value is None and _lacks_self(function, site):
        return Unknown(f"'{function.qualified}' is called without its object")
    if _is_too_deep(machine, ir):
        machine.exhausted = True
        return Unknown(f"'{function.qualified}' calls itself")
    if len(machine.activations) >= DEPTH:
        machine.give_up()
        return Unknown("the chain of calls is too deep to follow")
    key = repeats.call_key(function, site.args, site.keywords)

    def enter() -> Value:
        return enter_function(machine, function, site, self_value)

    def follow() -> Value:
        return repeats.follow(machine, function, key, enter)

    return references.with_arguments_written(machine, ir, site, follow)


def _lacks_self(function: FunctionValue, site: CallSite) -> bool:
    """Whether a method is called by way of its class with a text or a number in place of the object:
    ``Base.__init__('name')``."""
    params = function.ir.params
    if function.owner is None or not site.args or not params or params[0].name != "self":
        return False
    return isinstance(site.args[0], (Known, Holed)) and function.scope.module.file.kind != "cpp"


def _is_too_deep(machine: Machine, ir: facts.Function | facts.Lambda) -> bool:
    """Whether a function has called itself as often as is followed."""
    running = [
        activation
        for activation in machine.activations
        if activation.function is not None and activation.function.ir is ir
    ]
    if len(running) < NESTED_CALLS:
        return False
    certain = len(machine.branch_arms) == running[0].branch_arms
    return not certain or len(running) >= machine.allowed_nesting


def enter_function(machine: Machine, function: FunctionValue, site: CallSite, self_value: Value | None) -> Value:
    """Run a function once more, whatever was followed before."""
    ir = function.ir
    bound = bind_arguments(machine, function, site)
    self_value = self_value or _self_of(function, bound)
    on_object = isinstance(self_value, (Instance, ForeignValue))
    machine.executed.add(((self_value.heap_key or 0) if on_object and self_value is not None else 0, id(ir)))
    machine.ran[id(ir)] = ir, function.scope.module.path
    activation = _activation(machine, function, site, self_value)
    depth = machine.store.depth
    machine.store.push()
    for name, value in bound.items():
        machine.store.set(activation.scope.key, name, value)
    machine.activations.append(activation)
    result: Value = NONE
    status: Status = None
    try:
        if isinstance(ir, facts.Lambda):
            result = machine.evaluate(ir.body)
        else:
            status = machine.execute(ir.body)
    finally:
        machine.activations.pop()
        layer = machine.store.cut(depth)
        machine.library.function_left(activation)
    if isinstance(ir, facts.Lambda):
        machine.store.merge([layer])
        return result
    return _leave_function(machine, ir, activation, status, layer)


def _activation(machine: Machine, function: FunctionValue, site: CallSite, self_value: Value | None) -> Activation:
    """The frame of a call, with a scope of its own."""
    ir, module = function.ir, function.scope.module
    names, outer = bound_names(ir)
    scope = machine.new_scope(function.scope, module, "function", function.qualified, names, outer)
    body = ir.body if isinstance(ir, facts.Function) else []
    call_place = None
    if site.expression is not None and machine.activations:
        call_place = machine.place(site.expression.span)
        machine.callers.setdefault(id(ir), set()).add(call_place)
    depth = machine.store.depth
    activation = Activation(function.qualified, module, scope, body, depth, function, self_value, call_place)
    activation.branch_arms = len(machine.branch_arms)
    activation.scopes.append(scope.key)
    return activation


def _self_of(function: FunctionValue, bound: dict[str, Value]) -> Value | None:
    """The object that a method of a class works on where it is called by way of the class: ``Base.__init__(self)``."""
    ir = function.ir
    if function.owner is None or not ir.params or "staticmethod" in function.decorators:
        return None
    first = bound.get(ir.params[0].name)
    return first if isinstance(first, (Instance, ClassValue)) else None


def _leave_function(
    machine: Machine, ir: facts.Function, activation: Activation, status: Status, layer: Layer
) -> Value:
    captured = [kept for _, kept in activation.returns if kept is not None]
    references.note(machine, ir, activation, [*captured, layer])
    activation.forget([*captured, layer])
    falls_through = status not in ("return", "raise")
    straight = any(kept is None for _, kept in activation.returns)
    if not captured:
        machine.store.apply(layer)
    else:
        machine.store.merge([*captured, layer] if falls_through or straight else captured)
    if ir.is_generator:
        return containers.new_list(machine, activation.yields, "generator", True)
    values = [value for value, _ in activation.returns]
    if falls_through and not straight:
        values.append(NONE)
    if not values:
        return Unknown(f"'{activation.qualified}' raises")
    return chosen_with(chosen_for(one_of(values), activation.open_test), *values)

"""Nodes that are gone when the function that makes them returns: only a variable of it holds them.

Source: rclpy keeps weak references to a plain node (parameter service, time source, context), so it is freed with the
last variable.  A callback may refer to the node and keep it: rules ask for that themselves.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

from archlint.interpreter.bindings import bound_names
from archlint.syntax import facts
from archlint.syntax.parts import everything_in, names_in

if TYPE_CHECKING:
    from archlint.interpreter.activation import Activation


def holder(activations: Sequence[Activation], made: facts.Call | None) -> Activation | None:
    """The running function that alone holds the node which ``made`` gives, in a variable with which it does no more
    than call its methods, spin it, and hand it to functions that do no more either: the last of
    ``activations``, or the one that it returns the node to.  None where something may hold the node for longer."""
    call = made
    for activation in reversed(activations):
        ir = None if activation.function is None else activation.function.ir
        if call is None or not isinstance(ir, facts.Function) or ir.is_generator:
            return None
        returned = isinstance(activation.statement, facts.Return) and activation.statement.value is call
        if not returned:
            name = _assigned(ir, activation.statement, call)
            if name is None:
                return None
            unharmed = _mentions(ir, name) - _harmless(ir, name, _functions_of(activation))
            if unharmed == 0:
                return activation
            if unharmed != _returned(ir, name):
                return None
        call = _call_of(activations, activation, ir)
    return None


def _assigned(ir: facts.Function, statement: facts.Stmt | None, call: facts.Call) -> str | None:
    """The variable of a function that a statement assigns what ``call`` gives to, and nothing else."""
    if not isinstance(statement, facts.Assign) or statement.value is not call or len(statement.targets) != 1:
        return None
    target = statement.targets[0]
    return target.id if isinstance(target, facts.Name) and target.id in bound_names(ir)[0] else None


def _call_of(activations: Sequence[Activation], callee: Activation, ir: facts.Function) -> facts.Call | None:
    """The call by name that runs a function, where the caller's statement takes what it returns."""
    at = next(number for number, one in enumerate(activations) if one is callee)
    statement = activations[at - 1].statement if at else None
    value = statement.value if isinstance(statement, (facts.Assign, facts.Return)) else None
    called = value.func if isinstance(value, facts.Call) else None
    return value if isinstance(value, facts.Call) and isinstance(called, facts.Name) and called.id == ir.name else None


def _functions_of(activation: Activation) -> dict[str, facts.Function]:
    """The functions of the module that a running function is in."""
    return {one.name: one for one in activation.module.facts.body if isinstance(one, facts.Function)}


def _returned(ir: facts.Function, name: str) -> int:
    returns = (item.value for item in everything_in(ir.body) if isinstance(item, facts.Return))
    return sum(isinstance(value, facts.Name) and value.id == name for value in returns)


def _mentions(ir: facts.Function, name: str) -> int:
    inner = sum(name in names_in(item) for item in everything_in(ir.body) if isinstance(item, _INNER))
    return inner + sum(isinstance(item, facts.Name) and item.id == name for item in everything_in(ir.body))


_INNER = (facts.Function, facts.Lambda)
"""What may outlive the function, with the variables that it uses."""


def _harmless(ir: facts.Function, name: str, functions: Mapping[str, facts.Function]) -> int:
    """How often a variable is set, its methods are called, rclpy spins it, or a function is given it that does no more
    than this with it."""
    count = 0
    for item in everything_in(ir.body):
        if isinstance(item, facts.Assign):
            count += sum(isinstance(target, facts.Name) and target.id == name for target in item.targets)
        elif isinstance(item, facts.Call) and isinstance(item.func, facts.Attribute):
            owner = item.func.value
            if isinstance(owner, facts.Name) and owner.id == name:
                count += 1
            elif isinstance(owner, facts.Name) and owner.id == "rclpy" and item.func.attr.startswith("spin"):
                count += sum(isinstance(one.value, facts.Name) and one.value.id == name for one in item.args)
        elif isinstance(item, facts.Call) and isinstance(item.func, facts.Name):
            count += _lent(item, functions.get(item.func.id), name, functions)
    return count


def _lent(call: facts.Call, function: facts.Function | None, name: str, functions: Mapping[str, facts.Function]) -> int:
    """How many arguments of a call are a variable with which the function that is called does no harm."""
    if function is None or function.is_generator or any(given.star for given in call.args):
        return 0
    others = {key: one for key, one in functions.items() if one is not function}
    count = 0
    for position, given in enumerate(call.args):
        if not (isinstance(given.value, facts.Name) and given.value.id == name):
            continue
        keywords = [one.name for one in function.params if one.name == given.keyword]
        names = keywords if given.keyword else [one.name for one in function.params[position : position + 1]]
        count += sum(_mentions(function, one) == _harmless(function, one, others) for one in names)
    return count

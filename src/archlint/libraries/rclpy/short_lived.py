"""Nodes that are gone when the function or block that makes them ends: only a variable of it holds them.

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
    from archlint.libraries.run import Run


def holder(activations: Sequence[Activation], creating_call: facts.Call | None) -> tuple[Activation, str] | None:
    """The running function that alone holds the node which ``creating_call`` gives, and the variable with which it does
    no more than call its methods, spin it, and hand it to functions that do no more either: the last of
    ``activations``, or the one that it returns the node to.  None where something may hold the node for longer."""
    call = creating_call
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
                return activation, name
            if unharmed != _returned(ir, name):
                return None
        call = _call_of(activations, activation, ir)
    return None


def free(run: Run, activation: Activation, name: str) -> None:
    """Note that the nodes are gone which a variable that ends alone has held, if no branch leaves them alive."""
    for node, variable in run.nodes.short_lived.get(activation, ()):
        if variable == name and node.branch_arms.issuperset(run.branch_arms):
            node.until = len(run.nodes.by_key)


def _assigned(ir: facts.Function, statement: facts.Stmt | None, call: facts.Call) -> str | None:
    """The variable of a function that a statement assigns what ``call`` gives to, and nothing else."""
    match statement:
        case facts.Assign([facts.Name(name)], value) if value is call and name in bound_names(ir)[0]:
            return name
    return None


def _call_of(activations: Sequence[Activation], callee: Activation, ir: facts.Function) -> facts.Call | None:
    """The call by name that runs a function, where the caller's statement takes what it returns."""
    at = next(number for number, activation in enumerate(activations) if activation is callee)
    match activations[at - 1].statement if at else None:
        case facts.Assign(value=facts.Call(func) as call) | facts.Return(facts.Call(func) as call):
            return call if func.variable == ir.name else None
    return None


def _functions_of(activation: Activation) -> dict[str, facts.Function]:
    """The functions of the module that a running function is in."""
    return {
        statement.name: statement for statement in activation.module.facts.body if isinstance(statement, facts.Function)
    }


def _returned(ir: facts.Function, name: str) -> int:
    values = (item.value for item in everything_in(ir.body, facts.Return))
    return sum(value is not None and value.variable == name for value in values)


def _mentions(ir: facts.Function, name: str) -> int:
    # A function inside may outlive this one, with the variables that it uses.
    inner = (item for kind in (facts.Function, facts.Lambda) for item in everything_in(ir.body, kind))
    return sum(name in names_in(item) for item in inner) + sum(
        item.id == name for item in everything_in(ir.body, facts.Name)
    )


def _harmless(ir: facts.Function, name: str, functions: Mapping[str, facts.Function]) -> int:
    """How often a variable is set or deleted, its methods are called, rclpy spins it, or a function is given it that
    does no more than this with it."""
    count = 0
    for item in everything_in(ir.body):
        match item:
            case facts.Assign(targets) | facts.Delete(targets):
                count += sum(target.variable == name for target in targets)
            case facts.Call(facts.Attribute(owner)) if owner.variable == name:
                count += 1
            case facts.Call(facts.Attribute(facts.Name("rclpy"), method), given) if method.startswith("spin"):
                count += sum(argument.value.variable == name for argument in given)
            case facts.Call(facts.Name(called)):
                count += _lent(item, functions.get(called), name, functions)
    return count


def _lent(call: facts.Call, function: facts.Function | None, name: str, functions: Mapping[str, facts.Function]) -> int:
    """How many arguments of a call are a variable with which the function that is called does no harm."""
    if function is None or function.is_generator or any(given.star for given in call.args):
        return 0
    others = {key: other for key, other in functions.items() if other is not function}
    count = 0
    for position, given in enumerate(call.args):
        if given.value.variable != name:
            continue
        keywords = [param.name for param in function.params if param.name == given.keyword]
        names = keywords if given.keyword else [param.name for param in function.params[position : position + 1]]
        count += sum(_mentions(function, parameter) == _harmless(function, parameter, others) for parameter in names)
    return count

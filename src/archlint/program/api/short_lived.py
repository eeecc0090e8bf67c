"""Nodes that are gone when the function that makes them returns: only a variable of it holds them.

Source: rclpy keeps weak references to a plain node (parameter service, time source, context), so it is freed with the
last variable.  A callback may refer to the node and keep it: rules ask for that themselves.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.facts import model as facts
from archlint.program.bindings import bound_names
from archlint.program.interest import names_in
from archlint.program.uses import everything_in

if TYPE_CHECKING:
    from archlint.program.run import Activation


def is_local(activation: Activation, made: facts.Call | None) -> bool:
    """Whether ``made``, a call that gives a node, is assigned to a variable of the running function, which does no
    more with it than call its methods and spin it."""
    ir = None if activation.function is None else activation.function.ir
    statement = activation.statement
    if made is None or not isinstance(ir, facts.Function) or ir.is_generator:
        return False
    if not isinstance(statement, facts.Assign) or statement.value is not made or len(statement.targets) != 1:
        return False
    target = statement.targets[0]
    if not isinstance(target, facts.Name) or target.id not in bound_names(ir)[0]:
        return False
    return _mentions(ir, target.id) == _harmless(ir, target.id)


def _mentions(ir: facts.Function, name: str) -> int:
    inner = sum(name in names_in(item) for item in everything_in(ir.body) if isinstance(item, _INNER))
    return inner + sum(isinstance(item, facts.Name) and item.id == name for item in everything_in(ir.body))


_INNER = (facts.Function, facts.Lambda)
"""What may outlive the function, with the variables that it uses."""


def _harmless(ir: facts.Function, name: str) -> int:
    """How often a variable is set, its methods are called, or rclpy spins it."""
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
    return count

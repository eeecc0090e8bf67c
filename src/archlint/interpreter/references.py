"""Arguments by reference: what a function of C++ assigns to such a parameter, it assigns to the argument."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING

from archlint.interpreter.assignment import assign_where_it_is
from archlint.interpreter.values import Unknown, Value, one_of
from archlint.syntax import facts
from archlint.syntax.parts import once_for

if TYPE_CHECKING:
    from archlint.interpreter.activation import Activation
    from archlint.interpreter.call_site import CallSite
    from archlint.interpreter.heap import Layer
    from archlint.interpreter.machine import Machine

Function = facts.Function | facts.Lambda


@once_for
def references(ir: Function) -> tuple[tuple[int, str], ...]:
    """The parameters that are references, with their numbers."""
    return tuple((number, param.name) for number, param in enumerate(ir.params) if param.by_reference)


def note(machine: Machine, ir: Function, activation: Activation, layers: Iterable[Layer]) -> None:
    """Keep what the parameters of a function hold where it ends, in any of these states."""
    rows = references(ir)
    if not rows:
        return
    layers = list(layers)
    machine.by_reference[id(ir)] = {
        name: one_of(value for layer in layers if isinstance(value := layer.get((activation.scope.key, name)), Value))
        for _, name in rows
        if any((activation.scope.key, name) in layer for layer in layers)
    }


def with_arguments_written(machine: Machine, ir: Function, site: CallSite, follow: Callable[[], Value]) -> Value:
    """Call a function, and assign to its arguments what it assigns to its references."""
    rows = references(ir)
    expression = site.expression
    if not rows or expression is None:
        return follow()
    machine.by_reference.pop(id(ir), None)
    result = follow()
    written = machine.by_reference.pop(id(ir), None)
    written_down = [argument.value for argument in expression.args if argument.keyword is None]
    before = len(site.args) - len(written_down)  # the object that a method is called on
    for number, name in rows:
        if not 0 <= number - before < len(written_down):
            continue
        target, given = written_down[number - before], site.args[number]
        value = Unknown("the function that it is given to changes it") if written is None else written.get(name, given)
        if value is not given and not isinstance(target, facts.Subscript):
            assign_where_it_is(machine, target, value)
    return result


__all__ = ["note", "references", "with_arguments_written"]

"""Where a run starts anew: the activation at the root of a chain of calls."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.interpreter.activation import Activation
from archlint.interpreter.values import FunctionValue, Value

if TYPE_CHECKING:
    from archlint.interpreter.machine import Machine
    from archlint.interpreter.modules import Module


def enter_root(machine: Machine, module: Module) -> None:
    """An activation at the root, so that what runs has a module and a scope."""
    scope = module.scope
    if scope is None:
        scope = machine.new_scope(None, module, "module", module.name)
    machine.activations.append(Activation(module.name, module, scope, [], machine.store.depth))


def module_of(value: Value) -> Module | None:
    """The module whose function a value is; None where it is none of the workspace's."""
    if isinstance(value, FunctionValue):
        return value.scope.module
    function = getattr(value, "function", None)
    return module_of(function) if isinstance(function, Value) else None

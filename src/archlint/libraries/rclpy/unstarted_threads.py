"""Threads that a function makes and, for all that can be seen, never starts."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.syntax import facts
from archlint.syntax.parts import everything_in

if TYPE_CHECKING:
    from archlint.libraries.run import Run

_LEAVE_IT = frozenset({"daemon", "name", "join", "is_alive", "ident", "native_id"})
"""What may be asked of a thread, or set, without starting it."""


def is_never_started(run: Run, creating_call: facts.Call | None) -> bool:
    """Whether the thread that a call makes is only a statement of its own, or the value of a local variable which
    nothing is done with that could start it."""
    if creating_call is None or not run.activations or run.activations[-1].function is None:
        return False
    body = run.activations[-1].body
    if any(statement.value is creating_call for statement in everything_in(body, facts.Expression)):
        return True
    assignments = [assign for assign in everything_in(body, facts.Assign) if assign.value is creating_call]
    names = [target.variable for assign in assignments for target in assign.targets]
    return len(names) == 1 and names[0] != "" and _is_left_alone(body, names[0])


def _is_left_alone(body: list[facts.Stmt], name: str) -> bool:
    """Whether a variable is set once, and every use of it is a harmless one."""
    if any(name in statement.names for statement in everything_in(body, facts.Global)):
        return False
    harmless = [attribute for attribute in everything_in(body, facts.Attribute) if attribute.attr in _LEAVE_IT]
    prints = [call for call in everything_in(body, facts.Call) if call.func.variable == "print"]
    printed = [argument.value for call in prints for argument in call.args]
    uses = sum(use.id == name for use in everything_in(body, facts.Name))
    known = sum(attribute.value.variable == name for attribute in harmless)
    known += sum(value.variable == name for value in printed)
    targets = [target for assign in everything_in(body, facts.Assign) for target in assign.targets]
    set_here = sum(target.variable == name for target in targets)
    return set_here == 1 and uses == known + set_here


__all__ = ["is_never_started"]

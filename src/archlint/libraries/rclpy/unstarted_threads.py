"""Threads that a function makes and, for all that can be seen, never starts."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.syntax import facts
from archlint.syntax.parts import everything_in

if TYPE_CHECKING:
    from archlint.libraries.run import Run

_LEAVE_IT = frozenset({"daemon", "name", "join", "is_alive", "ident", "native_id"})
"""What may be asked of a thread, or set, without starting it."""


def is_never_started(run: Run, made: facts.Call | None) -> bool:
    """Whether the thread that a call makes is only a statement of its own, or the value of a local variable which
    nothing is done with that could start it."""
    if made is None or not run.activations or run.activations[-1].function is None:
        return False
    body = run.activations[-1].body
    if any(one.value is made for one in everything_in(body, facts.Expression)):
        return True
    [*assigned] = [one for one in everything_in(body, facts.Assign) if one.value is made]
    names = [target.variable for one in assigned for target in one.targets]
    return len(names) == 1 and names[0] != "" and _is_left_alone(body, names[0])


def _is_left_alone(body: list[facts.Stmt], name: str) -> bool:
    """Whether a variable is set once, and every use of it is a harmless one."""
    if any(name in one.names for one in everything_in(body, facts.Global)):
        return False
    harmless = [one for one in everything_in(body, facts.Attribute) if one.attr in _LEAVE_IT]
    printed = [
        given.value for one in everything_in(body, facts.Call) if one.func.variable == "print" for given in one.args
    ]
    uses = sum(one.id == name for one in everything_in(body, facts.Name))
    known = sum(one.value.variable == name for one in harmless) + sum(one.variable == name for one in printed)
    set_here = [
        target for one in everything_in(body, facts.Assign) for target in one.targets if target.variable == name
    ]
    return len(set_here) == 1 and uses == known + len(set_here)


__all__ = ["is_never_started"]

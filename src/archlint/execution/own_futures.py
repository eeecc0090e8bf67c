"""Futures that a program makes and completes itself: no answer of a server is waited for."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.analysis.kept import once
from archlint.analysis.reach import argument, calls_of
from archlint.analysis.source_code import source_code
from archlint.finding import Place
from archlint.model import Role
from archlint.model.given import Object
from archlint.syntax import facts
from archlint.syntax.walk import called_name, calls_in, statements_of

if TYPE_CHECKING:
    from archlint.model import ApiCall, Program
    from archlint.model.given import ObjectIdentity
    from archlint.systems.model import System

_COMPLETE = tuple(f"rclpy.task.Future.{name}" for name in ("set_result", "set_exception", "cancel"))


def spins_for_own_future(call: ApiCall) -> bool:
    """Whether a spin is for a future that the code completes itself."""
    future = argument(call, "future")
    return isinstance(future, Object) and future.foreign_class is not None


def spins_for_a_message(system: System, call: ApiCall) -> bool:
    """Whether only a subscription completes the future of a spin, and what it brings is read afterwards.  A program may
    well spin until a message stops it; then nobody reads what the future holds."""
    future = argument(call, "future")
    if not isinstance(future, Object) or _completed_by(system).get(future.identity) != {Role.SUBSCRIPTION}:
        return False
    code = source_code(system)
    names = {given.value.dotted for given in code.arguments(call)} - {""}
    calls = list(calls_in(code.body(call)))
    asked = {call.func.dotted.rpartition(".")[0] for call in calls}
    return "result" in map(called_name, calls) and not names.isdisjoint(asked)


def spins_for_own_task(system: System, program: Program, call: ApiCall) -> bool:
    """Whether a spin is for a task of the program's own, ``executor.create_task(function)``, which awaits nothing: the
    spin calls the function, and asks for the time only once it has returned."""
    code = source_code(system)
    given = next(iter(code.arguments(call)), None)
    if given is None or given.keyword not in (None, "future"):
        return False
    expression = given.value
    if expression.variable:
        values = [
            assigned.value
            for assigned in statements_of(code.body(call), facts.Assign)
            if expression.variable in [target.variable for target in assigned.targets]
        ]
        if len(values) != 1:
            return False
        expression = values[0]
    if not isinstance(expression, facts.Call) or called_name(expression) != "create_task":
        return False
    place = Place.of(call.file, expression.span)
    tasks = [task for task in program.callbacks if task.registered == place]
    functions = [code.function(task) for task in tasks]
    return bool(functions) and all(function is not None and not function.is_async for function in functions)


@once
def _completed_by(system: System) -> dict[ObjectIdentity, set[Role]]:
    """The roles of the code that completes the futures which the program makes itself."""
    roles: dict[ObjectIdentity, set[Role]] = {}
    for _, call in calls_of(system, _COMPLETE):
        if isinstance(call.receiver, Object):
            roles.setdefault(call.receiver.identity, set()).add(call.context.role)
    return roles


__all__ = ["spins_for_a_message", "spins_for_own_future", "spins_for_own_task"]

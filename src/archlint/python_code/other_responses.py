"""Service handlers that return the response of another service.

Source: ``Service.send_response`` in rclpy/service.py refuses what is no instance of the service's own ``Response``.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.analysis.kept import once
from archlint.analysis.source_code import source_code
from archlint.model import Role
from archlint.python_code.annotations import interface_of
from archlint.syntax import facts
from archlint.syntax.parts import everything_in, targets_in

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.model import Callback
    from archlint.systems.model import System


def other_response(system: System, callback: Callback, value: facts.Expr | None) -> tuple[str, str] | None:
    """The service whose response a handler returns, and the one that it serves; None where these are the same, or one
    of them is not known."""
    served = _served_types(system).get(callback.place, frozenset())
    code, function = source_code(system).facts_at(callback.file), source_code(system).definition(callback)
    if value is None or len(served) != 1 or code is None or function is None:
        return None
    [wanted] = served
    bound = Counter(_names_bound(function))
    response = _only_value(function.body, value.variable) if bound[value.variable] == 1 else value
    if not isinstance(response, facts.Call) or bound[response.func.dotted.partition(".")[0]]:
        return None
    interface, section = interface_of(code, response.func.dotted)
    if wanted is None or interface is None or interface == wanted or section != "Response":
        return None
    return interface, wanted


@once
def _served_types(system: System) -> dict[Place, frozenset[str | None]]:
    """The types of the services that each handler is given to, by its place; None for one that is not known."""
    types: dict[Place, set[str | None]] = {}
    for callback in system.callbacks:
        if callback.role == Role.SERVICE:
            served = callback.creation.type if callback.creation is not None else None
            types.setdefault(callback.place, set()).add(served)
    return {place: frozenset(several) for place, several in types.items()}


def _only_value(body: Sequence[facts.Stmt], name: str) -> facts.Expr | None:
    """What the assignment of a variable gives it."""
    for assignment in everything_in(body, facts.Assign):
        match assignment.targets:
            case [facts.Name(id=own)] if own == name:
                return assignment.value
    return None


def _names_bound(function: facts.Function) -> Iterator[str]:
    """The names that a function binds, those of functions inside it too, each as often as it does."""
    yield from (param.name for param in function.params)
    for part in everything_in(function.body):
        targets = list(part.assigned)
        match part:
            case facts.With(items=items):
                targets += [item.target for item in items if item.target is not None]
            case facts.Assigned(target=target) | facts.Generator(target=target):
                targets.append(target)
            case facts.Global(names=names):
                yield from names
            case facts.Import(module=module, alias=alias):
                yield alias or module.partition(".")[0]
            case facts.ImportFrom(names=pairs):
                yield from (name for _, name in pairs)
            case facts.Function(name=name) | facts.Class(name=name) | facts.Handler(name=str(name)):
                yield name
        yield from (each.variable for target in targets for each in targets_in(target) if each.variable)


__all__ = ["other_response"]

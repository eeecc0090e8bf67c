"""Functions that are given to code which is not seen."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING

from archlint import model
from archlint.interpreter.bindings import bound_names
from archlint.interpreter.modules import Scope
from archlint.interpreter.values import (
    DictValue,
    FunctionValue,
    Instance,
    ListValue,
    Value,
    alternatives,
)
from archlint.libraries.interest import interesting
from archlint.libraries.rclpy.callables import describe, without_partials
from archlint.libraries.state import Pending
from archlint.libraries.uses import bare
from archlint.libraries.values import NodeValue
from archlint.syntax.parts import names_in

if TYPE_CHECKING:
    from archlint.libraries.run import Run


def note_escaped(run: Run, values: Iterable[Value]) -> None:
    """Note functions that are given to code which we do not see (an event loop, a user interface): it may call
    them.  Methods of objects need a note only where a partial gives them something to work on, since all that can
    matter are run."""
    for option in (option for value in values for option in alternatives(value)):
        function, given = without_partials(option)
        inner = function.callee
        if not isinstance(inner, FunctionValue) or (inner is not function and not any(map(_holds_more, given))):
            continue
        if not (given or any(interesting(called.ir) or _passes_on(run, called) for called in _led_to(run, inner))):
            continue
        callback = describe(run, option, model.Role.METHOD)
        # Once a function, whatever scope it is defined in: one that defines others and lets them escape has no end.
        key = (model.Role.METHOD, None, callback.name, callback.place, 0, 0)
        if key in run.callbacks.registered:
            continue
        run.callbacks.registered[key] = set()
        run.program.callbacks.append(callback)
        run.callbacks.pending.append(Pending(callback, option, (), run.callbacks.lineage))


def _holds_more(value: object) -> bool:
    """Whether a value is an object or a collection, from which others may be got."""
    return isinstance(value, (Instance, NodeValue, ListValue, DictValue))


def _led_to(run: Run, function: FunctionValue) -> Iterator[FunctionValue]:
    """A function, and the functions that it names (so it may call them), and so on."""
    waiting = [function]
    seen: set[int] = set()
    while waiting:
        current = waiting.pop()
        if id(current.ir) in seen:
            continue
        seen.add(id(current.ir))
        yield current
        names = names_in(current.ir)
        scope: Scope | None = current.scope
        while scope is not None:
            values = (run.store.get(scope.key, name) for name in sorted(names) if scope.kind != "class")
            waiting += [value for value in values if isinstance(value, FunctionValue)]
            scope = scope.parent


def _passes_on(run: Run, function: FunctionValue) -> bool:
    """Whether a function passes on an object that it closes over."""
    own = bound_names(function.ir)[0]
    closed_over: set[str] = {name for name, value in function.defaults if _holds_more(value)}
    scope: Scope | None = function.scope
    while scope is not None and scope.kind != "module":
        if scope.kind != "class":
            names = names_in(function.ir) - own
            closed_over |= {name for name in names if _holds_more(run.store.get(scope.key, name))}
        scope = scope.parent
    return bool(closed_over) and bare(function.ir, frozenset(closed_over))

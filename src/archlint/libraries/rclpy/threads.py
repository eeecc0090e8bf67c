"""Threads: what they are given to run."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from archlint import model
from archlint.interpreter.call_site import CallSite
from archlint.interpreter.values import (
    ApiMethod,
    DictValue,
    External,
    Instance,
    ListValue,
    OneOf,
    Partial,
    Unknown,
    Value,
    alternatives,
    one_of,
)
from archlint.libraries import tables
from archlint.libraries.rclpy.callbacks import register
from archlint.libraries.rclpy.unstarted_threads import is_never_started
from archlint.syntax import facts

if TYPE_CHECKING:
    from archlint.libraries.api_use import ApiUse
    from archlint.libraries.run import Run


def thread(run: Run, call: ApiUse) -> Value:
    """``threading.Thread(target=…, args=…)``."""
    arguments: list[Value] = []
    given = call.get("args")
    if isinstance(given, ListValue):
        arguments = list(given.items(run).values)
    keywords = call.get("kwargs")
    idle = is_never_started(run, call.expression)
    named: dict[str, Value] = {}
    if isinstance(keywords, DictValue):
        entries = keywords.entries(run).entries.values()
        named = {key.text: item for key, item in entries if key.text is not None}
    _run_later(run, call, arguments, named, idle)
    place = run.place(call.expression.span) if call.expression is not None else None
    return Instance(External(call.api.path), run.store.new_key(), place)


def submit(run: Run, call: ApiUse) -> Value:
    """``pool.submit(self.download, address)``: a thread of the pool calls ``self.download(address)``."""
    named = {name: value for name, value in call.keywords.items() if name != "fn"}
    _run_later(run, call, call.rest, named)
    place = run.place(call.expression.span) if call.expression is not None else None
    return Instance(External("concurrent.futures.Future"), run.store.new_key(), place)


def submit_each(run: Run, call: ApiUse) -> Value:
    """``pool.map(self.download, addresses)``: threads of the pool call ``self.download(address)`` for each."""
    arguments = []
    for iterable in call.rest:
        items = iterable.items(run)
        values = () if items is None else items.values
        arguments.append(one_of(values) if values else Unknown("an item of what is given to map()"))
    _run_later(run, call, arguments, {})
    return Unknown("the results of map()")


def _run_later(run: Run, call: ApiUse, arguments: list[Value], named: dict[str, Value], idle: bool = False) -> None:
    """Note what a thread runs, and what it is called with."""
    for parameter, role in call.api.callbacks:
        value = call.get(parameter)
        if value is None:
            continue
        value = Partial(value, (), tuple(named.items())) if named else value
        callback = register(run, value, role, None, None, None, call, tuple(arguments))
        if callback is not None:
            callback.never_starts = idle
        if isinstance(value, (Unknown, OneOf)):
            run.library.given_away(CallSite(arguments))
        _run_foreign_target(run, value, arguments, call, idle)


def _run_foreign_target(run: Run, value: Value, arguments: list[Value], call: ApiUse, idle: bool) -> None:
    """``Thread(target=executor.spin)`` and ``Thread(target=rclpy.spin, args=(node,))``: no function of ours, so
    nothing is left to be run later."""
    for option in alternatives(value):
        match option.callee:
            case ApiMethod(path=path) | External(path=path):
                _run_in_thread(run, option, path, arguments, call.expression, idle)


def _run_in_thread(
    run: Run,
    target: Value,
    name: str,
    arguments: Iterable[Value],
    expression: facts.Call | None,
    idle: bool = False,
) -> None:
    """A function of a library runs in a thread that is made here; an ``idle`` one is never started."""
    kept = run.context
    place = kept.place if expression is None else run.place(expression.span)
    run.context = model.Callback(model.Role.THREAD, name, place, None, file=place.file, never_starts=idle)
    try:
        run.call(target, CallSite(list(arguments)))
    finally:
        run.context = kept


def run_escaped_spins(run: Run, values: Iterable[Value], expression: facts.Call | None) -> None:
    """Run the spins of executors that code is given which we do not see: it can do nothing with one but call it, in a
    thread of its own most likely, as ``loop.run_in_executor(None, executor.spin)`` does."""
    for option in (option for value in values for option in alternatives(value)):
        path = option.path if isinstance(option, ApiMethod) else ""
        row = tables.find(path)
        if row is not None and row.effect == "executor_spin":
            _run_in_thread(run, option, path, (), expression)

"""Call expressions: what is called with what, ``super()``, ``await``, and calls that never come back."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.interpreter import containers, refusals
from archlint.interpreter.call_site import CallSite
from archlint.interpreter.calls import call
from archlint.interpreter.objects.methods import PUTS
from archlint.interpreter.text_methods import decodes
from archlint.interpreter.values import (
    ClassValue,
    Entries,
    ForeignValue,
    Items,
    SuperValue,
    Unknown,
    Value,
    alternatives,
    one_of,
)
from archlint.syntax import facts

if TYPE_CHECKING:
    from archlint.interpreter.machine import Machine


def evaluate_call(machine: Machine, e: facts.Call) -> Value:
    """The value of a call expression."""
    name = e.func.variable
    if name == "super" and machine.lookup("super") is None:
        return _super(machine, e)
    if name in ("locals", "globals"):
        return Unknown("the variables as a dict")
    function = machine.evaluate(e.func)
    machine.library.coroutines_started(function, e)
    site = call_site(machine, e)
    match e.func:
        case facts.Attribute(value=facts.Attribute() as container, attr=name) if name in PUTS:
            machine.library.put_into(container, name, site)
    if machine.activation.module.file.kind != "cpp":  # whose compiler has checked all of its calls
        refused = refusals.check_call(machine, function, site, e)
        if refused is not None:
            return refused
    context = machine.library.around_call(function, e)
    if context is None:
        result = call(machine, function, site)
    else:
        with context:
            result = call(machine, function, site)
    if isinstance(result, Unknown):
        machine.unknown_results += 1
        if result.of_class is None and decodes(e):
            return replace(result, of_class="str")
    return result


def call_site(machine: Machine, e: facts.Call) -> CallSite:
    """The arguments of a call expression."""
    args: list[Value] = []
    keywords: dict[str, Value] = {}
    complete = True
    for argument in e.args:
        value = machine.evaluate(argument.value)
        if argument.star == "*":
            complete &= _add_items(args, value.items(machine))
        elif argument.star == "**":
            complete &= _add_entries(keywords, value.entries(machine))
        elif argument.keyword is not None:
            keywords[argument.keyword] = value
        else:
            args.append(value)
    return CallSite(args, keywords, e, not complete)


def _add_items(args: list[Value], items: Items | None) -> bool:
    """Add the arguments of ``*items``; whether they are all."""
    if items is None:
        return False
    args.extend(items.values[: max(0, containers.ITEM_LIMIT - len(args))])
    return not items.open and len(args) < containers.ITEM_LIMIT


def _add_entries(keywords: dict[str, Value], entries: Entries | None) -> bool:
    """Add the arguments of ``**entries``; whether they are all."""
    if entries is None:
        return False
    keywords.update((key.text, value) for key, value in entries.entries.values() if key.text is not None)
    return not entries.open


def _super(machine: Machine, e: facts.Call) -> Value:
    if e.args:
        args = call_site(machine, e).args
        if len(args) >= 2 and isinstance(args[0], ClassValue):
            return SuperValue(args[0], args[1])
    for activation in reversed(machine.activations):
        if activation.function is not None and activation.function.owner is not None:
            if activation.self_value is not None:
                return SuperValue(activation.function.owner, activation.self_value)
            break
        if activation.scope.kind not in ("function", "comprehension"):
            break
    return Unknown("super() outside of a method")


def awaited(machine: Machine, value: Value, expression: facts.Await) -> Value:
    """``await value``."""
    return one_of(
        machine.library.awaited(option, expression) if isinstance(option, ForeignValue) else option
        for option in alternatives(value)
    )


_EXITS = frozenset({"sys.exit", "os._exit"})
_EXIT_NAMES = frozenset({"exit", "_exit", "quit"})


def never_returns(machine: Machine, e: facts.Call) -> bool:
    """``sys.exit()`` and the like."""
    if e.func.last_name not in _EXIT_NAMES:
        return False  # as of most calls
    match e.func:
        case facts.Name(id=name):
            return name in ("exit", "quit") and machine.lookup(name) is None
        case facts.Attribute(value=facts.Name(id=name), attr="exit" | "_exit" as attribute):
            value = machine.lookup(name)
            return value is not None and f"{value.dotted}.{attribute}" in _EXITS
    return False


__all__ = ["awaited", "evaluate_call", "never_returns"]

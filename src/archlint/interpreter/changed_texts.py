"""Methods of C++ that change a text in place: ``topic_.append("/raw")``, ``topic_.erase(0, 1)``."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.interpreter.assignment import assign_where_it_is
from archlint.interpreter.operators import binary
from archlint.interpreter.values import Holed, Known, Unknown, Value, via
from archlint.syntax import facts

if TYPE_CHECKING:
    from archlint.interpreter.call_site import CallSite
    from archlint.interpreter.machine import Machine

_CHANGES = frozenset({"append", "assign", "clear", "erase", "insert", "pop_back", "replace", "resize", "swap"})


def change(machine: Machine, text: Known | Holed, name: str, site: CallSite) -> Value | None:
    """What such a method makes of a text; the variable that it is called on holds it from then on.  None for any other
    method."""
    if name not in _CHANGES or machine.activation.module.file.kind != "cpp" or site.expression is None:
        return None
    changed: Value = Unknown("a text that is changed in place, in a loop")
    if not machine.activation.loops:
        changed = _changed(machine, text, name, site.args, site.expression.span)
    assign_where_it_is(machine, _called_on(site.expression, name), changed)
    return changed


def _changed(machine: Machine, text: Known | Holed, name: str, given: list[Value], span: facts.Span) -> Value:
    numbers = [value.whole_number for value in given]
    match name, given:
        case "append", [more]:
            return binary(machine, "+", text, more, span)
        case "assign", [other] if other.is_text:
            return other
        case "clear", []:
            return Known("")
        case "insert", [_, more] if numbers[0] == 0:
            return binary(machine, "+", more, text, span)
        case "pop_back", [] if text.text:
            return Known(text.text[:-1], via(text))
        case "erase", [_, *count] if text.text is not None and len(count) < 2 and None not in numbers:
            start, *many = (number for number in numbers if number is not None)
            end = start + many[0] if many else len(text.text)
            return Known(text.text[:start] + text.text[end:], via(text, *given))
        case _:
            return Unknown("a text that is changed in place")


def _called_on(call: facts.Call, name: str) -> facts.Expr:
    """The variable: ``text.method(…)``, or ``put(text, method, …)``."""
    func = call.func
    if isinstance(func, facts.Attribute) and func.attr == name:
        return func.value
    return call.args[0].value if call.args else func


__all__ = ["change"]

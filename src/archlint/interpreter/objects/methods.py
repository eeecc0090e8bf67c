"""Methods of Python's own texts, lists, sets and dicts."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.interpreter.changed_texts import change
from archlint.interpreter.objects import dicts, lists, texts
from archlint.interpreter.text_methods import result_of
from archlint.interpreter.values import DictValue, Holed, Known, ListValue, Unknown, Value

if TYPE_CHECKING:
    from archlint.interpreter.call_site import CallSite
    from archlint.interpreter.machine import Machine

PUTS = frozenset({"append", "add", "extend", "insert", "update", "setdefault", "appendleft", "extendleft"})
"""Methods that put what they are given into a container."""
_ASKS = frozenset({"index", "count", "remove", "discard"})


def call_method(machine: Machine, target: Value, name: str, site: CallSite) -> Value:
    """``target.name(…)``."""
    if (changed := change(machine, target, name, site) if isinstance(target, (Known, Holed)) else None) is not None:
        return changed
    match target:
        case Known(value=str(), kind=kind):
            why = f"str.{name}() is not followed"
            return texts.call(machine, target, name, site) or (Unknown(why) if kind == "path" else result_of(name, why))
        case Holed():
            return texts.call_holed(target, name, site)
        case ListValue() | DictValue():
            return _of_container(machine, target, name, site)
        case Unknown(of_class="str"):
            return result_of(name, target.reason)
    return Unknown(f"{name}() of a value that is not followed")


def _of_container(machine: Machine, target: ListValue | DictValue, name: str, site: CallSite) -> Value:
    given = site.values
    if name in PUTS:
        machine.library.kept(target.key, given)
    if isinstance(target, ListValue):
        result = lists.call(machine, target, name, site) or Unknown(f"{target.kind}.{name}() is not followed")
    else:
        result = dicts.call(machine, target, name, site) or Unknown(f"dict.{name}() is not followed")
    if name in _ASKS:
        return result
    inside = () if name in PUTS else (target,)
    return machine.library.lost(result, (*given, *inside), f"{name}() of a container has it")


__all__ = ["PUTS", "call_method"]

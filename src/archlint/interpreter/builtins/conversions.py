"""``str``, ``int``, ``bool`` and what else makes one constant of another."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from archlint.interpreter import formatting, refusals
from archlint.interpreter.builtins.handlers import Handler, because_of, first
from archlint.interpreter.constant_expressions import NotFollowed, evaluate
from archlint.interpreter.values import (
    FALSE,
    Known,
    Unknown,
    Value,
    alternatives,
    chosen_with,
    constant,
    constants_of,
    one_of,
    reason,
    via,
)

if TYPE_CHECKING:
    from archlint.interpreter.call_site import CallSite
    from archlint.interpreter.machine import Machine


def text(machine: Machine, site: CallSite) -> Value:
    """``str(value)``."""
    if not site.args:
        return Known("")
    texts = [_plain(formatting.text_of(machine, option)) for option in alternatives(site.args[0])]
    return chosen_with(one_of(texts), site.args[0])


def _plain(value: Value) -> Value:
    """A constant as a text; of a path, a text like any other."""
    match value:
        case Unknown():
            return replace(value, of_class="str")
        case Known(kind="other", origin=None) if value.is_closed:
            return value.shown
        case Known():
            return Known(str(value.value), value.via, value.origin, "other" if value.kind == "path" else value.kind)
    return value


def number(convert: Callable[..., Any]) -> Handler:
    """``int``, ``float``, ``abs``, ``round``."""

    def handler(machine: Machine, site: CallSite) -> Value:
        if not site.args:
            return Known(convert()) if isinstance(convert, type) else Unknown("a call that fails")
        rest = [*site.args[1:], *site.keywords.values()]
        base = constants_of(rest)
        if base is None:
            return Unknown(reason(*rest))
        options = alternatives(site.args[0])
        if len(options) == 1:
            _note_failure(machine, options[0], convert, base)
        return one_of(_converted(option, convert, base, via(*rest)) for option in options)

    return handler


def _note_failure(machine: Machine, value: Value, convert: Callable[..., Any], base: list[Any]) -> None:
    """``int('fast')`` raises a ValueError.  What a parameter decides may be another value in the next run."""
    if isinstance(value, Known) and not value.via:
        try:
            convert(value.value, *base)
        except (TypeError, ValueError, OverflowError) as error:
            refusals.note_error(machine, type(error))


_MAKE: dict[Callable[..., Any], str] = {int: "int", float: "float"}
"""The conversions that give an object of one class, whatever they are given."""


def _converted(value: Value, convert: Callable[..., Any], base: list[Any], parameters: frozenset[str]) -> Value:
    if not isinstance(value, Known):
        return replace(because_of(value), of_class=_MAKE.get(convert) or _class_kept(value, convert, base))
    try:
        return constant(convert(value.value, *base), value.via | parameters)
    except (TypeError, ValueError, OverflowError):
        return Unknown("a conversion that fails")


def _class_kept(value: Value, convert: Callable[..., Any], base: list[Any]) -> str | None:
    """The class of what is made of a number: its own, but that ``round()`` to no digits gives an int."""
    if value.number_class is None or (convert is round and None in base):
        return None
    return "int" if convert is round and not base else value.number_class


def boolean(machine: Machine, site: CallSite) -> Value:
    """``bool(value)``."""
    if not site.args:
        return FALSE
    value = site.args[0]
    if isinstance(value, Known):
        return Known(bool(value.value), value.via)
    known = value.truth(machine)
    return Unknown(reason(value)) if known is None else Known(known)


def evaluated(machine: Machine, site: CallSite) -> Value:
    """``eval('True')``: how launch files turn an argument's text into a value.  Constants only; nothing runs."""
    return one_of(_evaluated(option) for option in alternatives(first(site)))


def _evaluated(value: Value) -> Value:
    try:
        result = None if value.text is None else evaluate(value.text)
    except NotFollowed:
        result = None
    return Known(result, value.via) if isinstance(result, (str, int, float)) else Unknown("the result of eval()")


__all__ = ["boolean", "evaluated", "number", "text"]

"""Texts: what ``str``, ``%``, ``format`` and f-strings make of values."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

from archlint.interpreter.attributes import method_of
from archlint.interpreter.items import get_entry
from archlint.interpreter.values import (
    TEXT_LIMIT,
    ClassValue,
    DictValue,
    Holed,
    Instance,
    Known,
    ListKind,
    ListValue,
    Unknown,
    Value,
    alternatives,
    chosen_with,
    constant,
    constants_of,
    depends_on,
    join_texts,
    one_of,
    reason,
    via,
)
from archlint.syntax import facts

if TYPE_CHECKING:
    from archlint.interpreter.machine import Machine

CONVERSIONS: dict[str | None, Callable[[object], str]] = {"r": repr, "a": ascii, "s": str}
"""What ``!r``, ``!a`` and ``!s`` stand for."""
CARTESIAN = 36
"""How many combinations of alternatives one operation follows."""
_PERCENT = re.compile(r"%(?:%|[-#0 +]*(?:[1-9.][\d.]*)?[hlL]?[a-zA-Z])")
_PERCENT_OF_DICT = re.compile(r"%(?:%|\((\w+)\)([-#0 +]*(?:[1-9.][\d.]*)?[a-zA-Z]))")
_WIDE = re.compile(r"\d{5,}")
"""A width or a precision that nobody asks for; Python would make a text as long as that."""


def percent_format(machine: Machine, template: Value, argument: Value, span: facts.Span) -> Value:
    """``'…%s…' % argument``."""
    match template, argument:
        case Known(value=str(text)), ListValue(kind="tuple"):
            items = argument.items(machine)
            if items.open:
                return Unknown("the arguments of % are not known")
            return _percent_items(machine, text, template.via, list(items.values), span)
        case Known(value=str(text)), DictValue():
            return _percent_dict(machine, text, template.via, argument, span)
        case Known(value=str(text)), _:
            return _percent_items(machine, text, template.via, [argument], span)
    return Unknown(reason(template))


def _percent_items(
    machine: Machine, text: str, parameters: frozenset[str], arguments: list[Value], span: facts.Span
) -> Value:
    parts: list[Value] = []
    at = 0
    for match in _PERCENT.finditer(text):
        parts.append(Known(text[at : match.start()], parameters))
        at = match.end()
        if match.group() == "%%":
            parts.append(Known("%"))
            continue
        if not arguments:
            return Unknown("% has too few arguments")
        parts.append(_formatted(match.group(), arguments.pop(0)))
    parts.append(Known(text[at:], parameters))
    if arguments or "%" in re.sub(_PERCENT, "", text):
        return Unknown(reason(*arguments, Unknown("the arguments of % do not fit the string")))
    return combine(machine, parts, span)


def _formatted(conversion: str, value: Value) -> Value:
    return one_of(_formatted_constant(conversion, option) for option in alternatives(value))


def _formatted_constant(conversion: str, value: Value) -> Value:
    if not isinstance(value, Known):
        return value if conversion == "%s" else Unknown(reason(value))
    try:
        text = None if _WIDE.search(conversion) else conversion % (value.value,)
    except (TypeError, ValueError, OverflowError):
        return Unknown("a format that fails")
    return _short(text, value)


def _percent_dict(
    machine: Machine, text: str, parameters: frozenset[str], argument: DictValue, span: facts.Span
) -> Value:
    parts: list[Value] = []
    at = 0
    if "%" in re.sub(_PERCENT_OF_DICT, "", text):
        return Unknown("the arguments of % do not fit the string")
    for match in _PERCENT_OF_DICT.finditer(text):
        parts.append(Known(text[at : match.start()], parameters))
        at = match.end()
        if match.group(1) is None:
            parts.append(Known("%"))
        else:
            value = get_entry(machine, argument, Known(match.group(1)), None)
            parts.append(_formatted("%" + match.group(2), value))
    parts.append(Known(text[at:], parameters))
    return combine(machine, parts, span)


def combine(machine: Machine, parts: Sequence[Value], span: facts.Span | None) -> Value:
    """Join text parts over all combinations of their alternatives."""
    rows: list[list[Value]] = [[]]
    for part in parts:
        options = _meant(part)
        if len(rows) * len(options) > CARTESIAN:
            options = (Unknown("more values than can be followed"),)
        rows = [[*row, option] for row in rows for option in options]
    place = None if span is None else machine.place(span)
    return chosen_with(one_of(join_texts([text_of(machine, part) for part in row], place) for row in rows), *parts)


def _meant(part: Value) -> Sequence[Value]:
    """The alternatives of a part.  ``None`` among others is what stands there until a value comes: nobody means a text
    with that word in it, so what the text then is counts as not known."""
    options = alternatives(part)
    if len(options) == 1:
        return options
    return [Unknown("it may be None in this string") if option.is_none else option for option in options]


def plain_text(machine: Machine, value: Value) -> Value:
    """A member of ``class X(str, Enum)`` is the text it holds; everything else is itself."""
    if isinstance(value, Instance) and value.is_member:
        bases = () if value.own_class is None else value.own_class.external_bases()
        return (value.member_value(machine) if {"str", "enum.StrEnum"} & set(bases) else None) or value
    return value


def text_of(machine: Machine, value: Value) -> Value:
    """``str(value)``."""
    match value:
        case Known() | Holed() | Unknown():
            return value
        case ListValue(kind="list" | "tuple" as kind):
            return _text_of_list(machine, value, kind)
        case Instance(cls=ClassValue() as cls):
            member = value.member_value(machine)
            if isinstance(member, Known) and "enum.StrEnum" in cls.external_bases():
                return member
            for name in ("__str__", "__repr__"):
                method = method_of(machine, value, name)
                if method is not None:
                    return machine.call(method)
    return Unknown(reason(value))


def _text_of_list(machine: Machine, value: ListValue, kind: ListKind) -> Value:
    """``str([1, 'a'])``, of constants."""
    items = value.items(machine)
    constants = constants_of(items.values)
    if items.open or constants is None:
        return Unknown(reason(value, *items.values))
    text = repr(tuple(constants) if kind == "tuple" else constants)
    return constant(text, via(*items.values))


def format_one(value: Value, conversion: str | None, spec: str | None) -> Value:
    """What one ``{value!conversion:spec}`` gives."""
    if isinstance(value, Holed):
        return Unknown(value.reason, depends_on(value))
    if not isinstance(value, Known):
        return value
    if value.is_closed and not spec and conversion in (None, "s"):
        return value.shown
    try:
        shown = CONVERSIONS[conversion](value.value) if conversion in CONVERSIONS else value.value
        text = None if _WIDE.search(spec or "") else format(shown, spec or "")
    except (TypeError, ValueError, OverflowError):
        return Unknown("a format that fails")
    return _short(text, value)


def _short(text: str | None, value: Known) -> Value:
    too_long = text is None or len(text) > TEXT_LIMIT
    return Unknown("a string too long to follow") if too_long else Known(text, value.via)

"""Texts: what ``str``, ``%``, ``format`` and f-strings make of values."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

from archlint.interpreter.attributes import get_attribute
from archlint.interpreter.containers import items_of
from archlint.interpreter.items import get_entry
from archlint.interpreter.values import (
    TEXT_LIMIT,
    BoundMethod,
    ClassValue,
    DictValue,
    Holed,
    Instance,
    Known,
    ListValue,
    Unknown,
    Value,
    alternatives,
    join_texts,
    one_of,
    reason,
)
from archlint.syntax import facts

if TYPE_CHECKING:
    from archlint.interpreter.machine import Machine

CONVERSIONS: dict[str | None, Callable[[object], str]] = {"r": repr, "a": ascii, "s": str}
"""What ``!r``, ``!a`` and ``!s`` stand for."""
CARTESIAN = 36
"""How many combinations of alternatives one operation follows."""
_PERCENT = re.compile(r"%(?:%|[-#0 +]*[\d.]*[hlL]?[a-zA-Z])")
_PERCENT_OF_DICT = re.compile(r"%(?:%|\((\w+)\)([-#0 +]*[\d.]*[a-zA-Z]))")
_WIDE = re.compile(r"\d{5,}")
"""A width or a precision that nobody asks for; Python would make a text as long as that."""


def percent_format(machine: Machine, template: Value, argument: Value, span: facts.Span) -> Value:
    """``'…%s…' % argument``."""
    if not isinstance(template, Known) or not isinstance(template.value, str):
        return Unknown(reason(template))
    if isinstance(argument, ListValue) and argument.kind == "tuple":
        items = items_of(machine, argument)
        if items.open:
            return Unknown("the arguments of % are not known")
        arguments = list(items.values)
    elif isinstance(argument, DictValue):
        return _percent_dict(machine, template, argument, span)
    else:
        arguments = [argument]
    parts: list[Value] = []
    text = template.value
    at = 0
    for match in _PERCENT.finditer(text):
        parts.append(Known(text[at : match.start()], template.via))
        at = match.end()
        if match.group() == "%%":
            parts.append(Known("%"))
            continue
        if not arguments:
            return Unknown("% has too few arguments")
        parts.append(_formatted(match.group(), arguments.pop(0)))
    parts.append(Known(text[at:], template.via))
    if arguments or "%" in re.sub(_PERCENT, "", text):
        return Unknown(reason(*arguments, Unknown("the arguments of % do not fit the string")))
    return combine(machine, parts, span)


def _formatted(conversion: str, value: Value) -> Value:
    found: list[Value] = []
    for alternative in alternatives(value):
        if isinstance(alternative, Known):
            try:
                text = None if _WIDE.search(conversion) else conversion % (alternative.value,)
            except (TypeError, ValueError, OverflowError):
                found.append(Unknown("a format that fails"))
                continue
            found.append(_short(text, alternative))
        elif conversion == "%s":
            found.append(alternative)
        else:
            found.append(Unknown(reason(alternative)))
    return one_of(found)


def _percent_dict(machine: Machine, template: Known, argument: DictValue, span: facts.Span) -> Value:
    assert isinstance(template.value, str)
    parts: list[Value] = []
    at = 0
    if "%" in re.sub(_PERCENT_OF_DICT, "", template.value):
        return Unknown("the arguments of % do not fit the string")
    for match in _PERCENT_OF_DICT.finditer(template.value):
        parts.append(Known(template.value[at : match.start()], template.via))
        at = match.end()
        if match.group(1) is None:
            parts.append(Known("%"))
        else:
            value = get_entry(machine, argument, Known(match.group(1)), None)
            parts.append(_formatted("%" + match.group(2), value))
    parts.append(Known(template.value[at:], template.via))
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
    return one_of(join_texts([text_of(machine, part) for part in row], place) for row in rows)


def _meant(part: Value) -> Sequence[Value]:
    """The alternatives of a part.  ``None`` among others is what stands there until a value comes: nobody means a text
    with that word in it, so what the text then is counts as not known."""
    options = alternatives(part)
    if len(options) == 1:
        return options
    return [Unknown("it may be None in this text") if _is_none(option) else option for option in options]


def _is_none(value: Value) -> bool:
    """Whether a value is ``None``, whichever parameter chose it."""
    return isinstance(value, Known) and value.value is None


def plain_text(machine: Machine, value: Value) -> Value:
    """A member of ``class X(str, Enum)`` is the text it holds; everything else is itself."""
    if isinstance(value, Instance) and value.is_member:
        bases = () if value.own_class is None else value.own_class.external_bases()
        return (value.member_value(machine) if {"str", "enum.StrEnum"} & set(bases) else None) or value
    return value


def text_of(machine: Machine, value: Value) -> Value:
    """``str(value)``."""
    if isinstance(value, (Known, Holed, Unknown)):
        return value
    if isinstance(value, Instance) and isinstance(value.cls, ClassValue):
        enum = value.member_value(machine)
        if isinstance(enum, Known) and _is_text_enum(value.cls):
            return enum
        for name in ("__str__", "__repr__"):
            method = get_attribute(machine, value, name)
            if isinstance(method, BoundMethod):
                return machine.call(method)
    return Unknown(reason(value))


def _is_text_enum(cls: ClassValue) -> bool:
    return any(path in ("enum.StrEnum",) for path in cls.external_bases())


def format_one(value: Value, conversion: str | None, spec: str | None) -> Value:
    """What one ``{value!conversion:spec}`` gives."""
    if isinstance(value, Holed):
        return Unknown(value.reason, next(iter(sorted(value.via)), None))
    if not isinstance(value, Known):
        return value
    try:
        shown = CONVERSIONS[conversion](value.value) if conversion in CONVERSIONS else value.value
        text = None if _WIDE.search(spec or "") else format(shown, spec or "")
    except (TypeError, ValueError, OverflowError):
        return Unknown("a format that fails")
    return _short(text, value)


def _short(text: str | None, value: Known) -> Value:
    too_long = text is None or len(text) > TEXT_LIMIT
    return Unknown("a string too long to follow") if too_long else Known(text, value.via)

"""Constants and defaults in interface files, by the rules of ``rosidl_adapter``."""

from __future__ import annotations

import re
from typing import Literal

Value = bool | int | float | str
ArrayKind = Literal["", "fixed", "bounded", "unbounded"]

INTEGER_RANGES = {
    "byte": (0, 255),
    "char": (0, 255),
    **{f"int{bits}": (-(2 ** (bits - 1)), 2 ** (bits - 1) - 1) for bits in (8, 16, 32, 64)},
    **{f"uint{bits}": (0, 2**bits - 1) for bits in (8, 16, 32, 64)},
}
_STRINGS = ("string", "wstring")
PRIMITIVE_TYPES = frozenset({"bool", "float32", "float64", "duration", "time", *_STRINGS, *INTEGER_RANGES})

_BOOLEANS = {"true": True, "1": True, "false": False, "0": False}
_ELEMENT = re.compile(r"""\s*(?:"((?:[^"\\]|\\.)*)"|'((?:[^'\\]|\\.)*)'|[^,]*)\s*(?:,|\Z)""")


class InvalidValue(ValueError):
    """A value that its type does not allow, in words."""


def parse_value(
    type_name: str, text: str, array: ArrayKind, size: int | None, string_bound: int | None
) -> Value | list[Value]:
    """The default of a field of a primitive type; a list for arrays."""
    if not array:
        return parse_primitive(type_name, text, string_bound)
    if not (text.startswith("[") and text.endswith("]")):
        raise InvalidValue(f"the default of an array must be written in brackets, not {text!r}")
    values = [parse_primitive(type_name, item, string_bound) for item in _items(type_name, text[1:-1])]
    if array == "fixed" and len(values) != size:
        raise InvalidValue(f"expected exactly {size} values, found {len(values)}")
    if array == "bounded" and size is not None and len(values) > size:
        raise InvalidValue(f"expected at most {size} values, found {len(values)}")
    return values


def _items(type_name: str, text: str) -> list[str]:
    if not text.strip():
        return []
    if type_name not in _STRINGS:
        return [item.strip() for item in text.split(",")]
    # A comma may stand inside a quoted string.
    items, position = [], 0
    while position < len(text):
        match = _ELEMENT.match(text, position)
        if match is None:
            raise InvalidValue(f"cannot read the strings in [{text}]")
        items.append(text[position : match.end()].strip().removesuffix(",").strip())
        position = match.end()
    return items


def parse_primitive(type_name: str, text: str, string_bound: int | None = None) -> Value:
    """One value.  Raises :class:`InvalidValue`."""
    if type_name in _STRINGS:
        return _string(text, string_bound)
    if type_name == "bool":
        if text.lower() not in _BOOLEANS:
            raise InvalidValue(f"{text!r} is not a bool: expected true, false, 1 or 0")
        return _BOOLEANS[text.lower()]
    if type_name in ("float32", "float64"):
        try:
            return float(text)
        except ValueError:
            raise InvalidValue(f"{text!r} is not a number") from None
    if type_name not in INTEGER_RANGES:
        raise InvalidValue(f"a {type_name} cannot be written as a value")
    return _integer(type_name, text)


def _integer(type_name: str, text: str) -> int:
    low, high = INTEGER_RANGES[type_name]
    try:
        value = int(text) if text.lstrip("+-").isdigit() else int(text, 0)
    except ValueError:
        raise InvalidValue(f"{text!r} is not an integer") from None
    if not low <= value <= high:
        raise InvalidValue(f"{text} does not fit {type_name}: expected {low} to {high}")
    return value


def _string(text: str, bound: int | None) -> str:
    for quote in "\"'":
        if len(text) > 1 and text.startswith(quote) and text.endswith(quote):
            text = text[1:-1]
            if re.search(rf"(?<!\\){quote}", text):
                raise InvalidValue(f"a {quote} inside the string must be written as \\{quote}")
            text = text.replace(f"\\{quote}", quote)
            break
    if bound is not None and len(text) > bound:
        raise InvalidValue(f"a string of {len(text)} characters, where at most {bound} are allowed")
    return text

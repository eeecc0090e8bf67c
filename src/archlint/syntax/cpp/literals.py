"""Literals of C++: texts, numbers, characters, durations."""

from __future__ import annotations

import math
import re

_ESCAPE = re.compile(r"\\(?:([0-7]{1,3})|x([0-9a-fA-F]+)|u([0-9a-fA-F]{4})|U([0-9a-fA-F]{8})|(.))", re.DOTALL)
_PLAIN = {"n": "\n", "t": "\t", "r": "\r", "0": "\0", "a": "\a", "b": "\b", "f": "\f", "v": "\v", "\n": ""}
_RAW = re.compile(r'R"([^()\\\s]{0,16})\((.*)\)\1"\Z', re.DOTALL)
_QUOTED = re.compile(r'(?:u8|u|U|L)?"(.*)"\Z', re.DOTALL)
_NUMBER = re.compile(r"(0[xX][0-9a-fA-F]+|0[bB][01]+|[0-9]*\.?[0-9]*(?:[eE][+-]?[0-9]+)?)[uUlLfFzZ]*\Z")

SECONDS = {"h": 3600.0, "min": 60.0, "s": 1.0, "ms": 1e-3, "us": 1e-6, "ns": 1e-9}
"""The suffixes of ``std::chrono_literals``, and how long each is."""

CONSTANTS = {"M_E": math.e, "M_PI": math.pi, "M_PI_2": math.pi / 2, "M_PI_4": math.pi / 4}
"""The numbers that ``<cmath>`` has names for."""


def text_of(written: str) -> str | None:
    """The text of a string literal; None for one that is not understood."""
    raw = _RAW.match(written)
    if raw is not None:
        return raw[2]
    quoted = _QUOTED.match(written)
    return None if quoted is None else _unescaped(quoted[1])


def character_of(written: str) -> str | None:
    """The character of a literal in single quotes."""
    return _unescaped(written[1:-1]) if len(written) > 2 and written[0] == written[-1] == "'" else None


def _unescaped(content: str) -> str | None:
    if "\\" not in content:
        return content
    text = _ESCAPE.sub(_replaced, content)
    return None if any("\ud800" <= character <= "\udfff" for character in text) else text


def _replaced(match: re.Match[str]) -> str:
    octal, *hexadecimal, plain = match.groups()
    if octal is not None:
        return chr(int(octal, 8))
    digits = next((digits for digits in hexadecimal if digits is not None), None)
    if digits is not None:
        number = int(digits, 16)
        return chr(number) if number < 0x110000 else ""
    return _PLAIN.get(plain, plain)


def number_of(written: str) -> int | float | None:
    """The number of a literal; None for one that is not understood."""
    sign = -1 if written.startswith("-") else 1  # the grammar counts a sign to the number
    match = _NUMBER.match(written.lstrip("+-").replace("'", ""))
    if match is None or not match[1]:
        return None
    digits = match[1].lower()
    try:
        if digits.startswith(("0x", "0b")):
            number: int | float = int(digits, 0)
        elif digits.isdigit() and not written.lower().endswith("f"):
            number = int(digits, 8) if digits.startswith("0") and len(digits) > 1 else int(digits)
        else:
            number = float(digits)
    except ValueError:
        return None
    return sign * number if abs(number) < 2**63 else None


__all__ = ["CONSTANTS", "SECONDS", "character_of", "number_of", "text_of"]

"""Macros of C++ that take arguments: ``#define PUB(T, name) create_publisher<T>(name, 10)``."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import NamedTuple

_COMMENT = re.compile(r"//[^\n]*|/\*.*?\*/", re.DOTALL)
_TOKEN = re.compile(r'"(?:[^"\\\n]|\\.)*"|\'(?:[^\'\\\n]|\\.)*\'|[A-Za-z_]\w*|##|#|\s+|.', re.DOTALL)
MOST_CHARACTERS = 4000
"""Longer texts are no plain macros, nor is what they become."""


class Macro(NamedTuple):
    """A macro with its parameters and its text."""

    parameters: tuple[str, ...]
    text: str


def macro(parameters: str, written: str) -> Macro | None:
    """A macro by its parameters in brackets and its text; None for one that is not plain."""
    names = tuple(name.strip() for name in parameters.strip()[1:-1].split(",") if name.strip())
    text = _COMMENT.sub(" ", written.replace("\\\n", " ").replace("\\\r\n", " ")).strip()
    if "..." in names or "__VA_ARGS__" in text or not text or len(text) > MOST_CHARACTERS:
        return None
    return Macro(names, text)


def expanded(of: Macro, arguments: list[str], others: Mapping[str, str]) -> str | None:
    """The text of a macro with these arguments in it, and with other macros that are texts; None where they do not
    fit."""
    if len(arguments) != len(of.parameters):
        return None
    given = {**others, **dict(zip(of.parameters, arguments, strict=True))}
    tokens: list[str] = _TOKEN.findall(of.text)
    text: list[str] = []
    at = 0
    while at < len(tokens):
        token = tokens[at]
        if token == "##":
            text = [*_without_space(text)]
            at += 1
            while at < len(tokens) and tokens[at].isspace():
                at += 1
            continue
        if token == "#" and at + 1 < len(tokens) and tokens[at + 1] in of.parameters:
            at += 1
            text.append('"' + given[tokens[at]].replace("\\", "\\\\").replace('"', '\\"') + '"')
        else:
            text.append(given.get(token, token))
        at += 1
    whole = "".join(text)
    return whole if len(whole) <= MOST_CHARACTERS else None


def _without_space(text: list[str]) -> list[str]:
    while text and text[-1].isspace():
        text = text[:-1]
    return text


__all__ = ["Macro", "expanded", "macro"]

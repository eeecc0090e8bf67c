"""Which fields of a class of facts may hold facts: asked at every step of every walk."""

from __future__ import annotations

import re
from functools import cache
from inspect import get_annotations

import msgspec

_PLAIN = re.compile(
    r"(?:str|int|float|bool|bytes|None|tuple|list|dict|frozenset|Span|Constant|Star|\w+Kind|\w+Operator|[\W\d])+"
)
"""Annotations of fields that no fact stands in."""


@cache
def fields_with_facts(kind: type[msgspec.Struct]) -> tuple[str, ...]:
    """The fields whose annotations name more than plain values, in their order."""
    annotations = {name: text for base in reversed(kind.__mro__) for name, text in get_annotations(base).items()}
    return tuple(name for name in kind.__struct_fields__ if not _PLAIN.fullmatch(annotations[name]))


__all__ = ["fields_with_facts"]

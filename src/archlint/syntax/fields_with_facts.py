"""Which fields of a class of facts may hold facts: asked at every step of every walk."""

from __future__ import annotations

import re
from functools import cache
from inspect import get_annotations
from typing import NamedTuple

import msgspec

_PLAIN = re.compile(
    r"typing\.Literal\[.*\]|(?:str|int|float|bool|bytes|None|tuple|list|dict|frozenset|Span|Constant|Star|\w+Kind|\w+Operator|[\W\d])+"
)
"""Annotations of fields that hold no fact."""


class Holding(NamedTuple):
    """A field that holds a fact or None, or facts (``is_list``), or a list of facts and other things (``is_mixed``)."""

    name: str
    is_list: bool
    is_mixed: bool


@cache
def fields_with_facts(kind: type[msgspec.Struct]) -> tuple[Holding, ...]:
    """The fields whose annotations name more than plain values, in their order."""
    annotations = {name: text for base in reversed(kind.__mro__) for name, text in get_annotations(base).items()}
    holding = [(name, annotations[name]) for name in kind.__struct_fields__ if not _PLAIN.fullmatch(annotations[name])]
    return tuple(Holding(name, text.startswith("list["), text.startswith("list[Union[")) for name, text in holding)


__all__ = ["fields_with_facts"]

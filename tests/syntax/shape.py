"""Facts as short text, so that a test can say what it expects without spans."""

from __future__ import annotations

import msgspec

from archlint.syntax.python.lowering import lower

SPANS = ("span", "name_span")


def shape(fact: object) -> str:
    """``Call(Name('f'), [Argument(Literal(1))])``: without spans and without defaults at the end."""
    if isinstance(fact, list):
        return "[" + ", ".join(map(shape, fact)) + "]"
    if not isinstance(fact, msgspec.Struct):
        return repr(fact)
    fields = [field for field in msgspec.structs.fields(fact) if field.name not in SPANS]
    values = [getattr(fact, field.name) for field in fields]
    while fields and not fields[-1].required and values[-1] in (fields[-1].default, None, "", []):
        fields.pop()
        values.pop()
    return f"{type(fact).__name__}({', '.join(map(shape, values))})"


def statements(text: str) -> list[str]:
    return [shape(statement) for statement in lower(text).body]


def statement(text: str) -> str:
    (only,) = statements(text)
    return only


def expression(text: str) -> str:
    (assignment,) = lower(f"target = {text}\n").body
    return shape(assignment.value)

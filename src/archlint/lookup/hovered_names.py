"""What a hover says of a topic, a service, an action or a parameter."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from archlint.lookup.index import Index
from archlint.lookup.mentions import Mention, SubjectKind
from archlint.lookup.summaries import connection_summary, parameter_summary
from archlint.lookup.words import code, ends_list, qos_words, where
from archlint.ros.parameter_types import type_of
from archlint.syntax.parameter_files import NotKnown

_ENDS: Mapping[SubjectKind, tuple[str, str]] = {
    "topic": ("Published by", "Subscribed by"),
    "service": ("Served by", "Called by"),
    "action": ("Served by", "Called by"),
}


def connection_lines(index: Index, mention: Mention) -> Iterator[str]:
    subject = mention.subject
    match subject.kind:
        case "topic" | "service" | "action" as kind:
            known = connection_summary(index, kind, subject.name)
            types = f": {', '.join(map(code, known.types))}" if known.types else ""
            yield f"{kind} {code(subject.name)}{types}"
            yield ends_list(_ENDS[kind][0], known.providers, known.rates)
            yield ends_list(_ENDS[kind][1], known.users, ())
            yield from (f"No message arrives: {reason}" for reason in known.undelivered)


def unnamed_lines(index: Index, mention: Mention) -> Iterator[str]:
    end = mention.end
    if end is None:
        return
    kind = end.kind.replace("_", " ")
    yield f"{kind}" + (f": {code(end.type)}" if end.type else "")
    yield f"its name is not known: {end.error or end.reason}" if end.error or end.reason else "its name is not known"
    if end.qos is not None and end.kind in ("publisher", "subscriber"):
        yield qos_words(end.qos)


def parameter_lines(index: Index, mention: Mention) -> Iterator[str]:
    """Its type and default, what sets it and where it is read."""
    known = parameter_summary(index, mention.subject)
    if not known.declarations:
        yield f"parameter {code(known.name)}"
        if any(node.blueprint is not None and node.blueprint.complete for node in known.nodes):
            yield "It is declared nowhere in this workspace."
    for declaration in known.declarations[:1]:
        default = f" = {code(repr(declaration.default))}" if declaration.known else ""
        yield f"parameter {code(known.name)}: {declaration.type or 'type not known'}{default}"
        yield f"Declared at {where(declaration.place)}"
    rows = dict.fromkeys(f"- {code(node.name or '?')}: {_value(value)}" for node, value in known.values)
    if rows:
        yield "Value when launched:\n" + "\n".join(rows)
    for words, places in (("Set at", known.set_at), ("Read at", known.read_at)):
        if places:
            yield f"{words} " + ", ".join(map(where, places))


def _value(value: object) -> str:
    match value:
        case NotKnown(reason=reason):
            return f"not known: {reason}"
    kind = type_of(value)
    return code(repr(value)) + (f" ({kind})" if kind else "")


__all__ = ["connection_lines", "parameter_lines", "unnamed_lines"]

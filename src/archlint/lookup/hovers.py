"""What there is to know of a name: who publishes, who listens, with what type and quality of service."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping

from archlint.lookup.answers import Hover
from archlint.lookup.index import Index
from archlint.lookup.mentions import Mention, Subject, SubjectKind
from archlint.lookup.moved import Moves
from archlint.lookup.rule_codes import rule_at
from archlint.lookup.summaries import connection_summary, parameter_summary
from archlint.lookup.texts import Texts
from archlint.lookup.words import code, ends_list, node_words, qos_words, where
from archlint.ros.parameter_types import type_of
from archlint.syntax.parameter_files import NotKnown

MOST = 6
"""How many names one hover tells of, where several launch files give a place several."""


def hover(index: Index, texts: Texts, file: str, line: int, column: int) -> Hover | None:
    """What is known of the name, create call, node, executable, type or rule code at a position; None for anything
    else, and for names that are not known."""
    rule = rule_at(texts, file, line, column)
    if rule is not None:
        return rule
    mentions = index.at(texts, file, line, column)
    by_subject: dict[Subject, Mention] = {}
    for mention in mentions:
        by_subject.setdefault(mention.subject, mention)
    parts = [
        "\n\n".join(lines)
        for subject, mention in by_subject.items()
        if (lines := [*_TELL.get(subject.kind, _nothing)(index, mention)])
    ]
    place = Moves(index.texts, texts).place_now(mentions[0].place) if parts else None
    if place is None:
        return None
    more = f"\n\n---\n\nand {len(parts) - MOST} more" if len(parts) > MOST else ""
    return Hover("\n\n---\n\n".join(dict.fromkeys(parts[:MOST])) + more, place)


def _nothing(index: Index, mention: Mention) -> Iterable[str]:
    return ()


_ENDS: Mapping[SubjectKind, tuple[str, str]] = {
    "topic": ("Published by", "Subscribed by"),
    "service": ("Served by", "Called by"),
    "action": ("Served by", "Called by"),
}


def _connection(index: Index, mention: Mention) -> Iterator[str]:
    subject = mention.subject
    match subject.kind:
        case "topic" | "service" | "action" as kind:
            known = connection_summary(index, kind, subject.name)
            types = f": {', '.join(map(code, known.types))}" if known.types else ""
            yield f"{kind} {code(subject.name)}{types}"
            yield ends_list(_ENDS[kind][0], known.providers, known.rates)
            yield ends_list(_ENDS[kind][1], known.users, ())
            yield from (f"No message arrives: {reason}" for reason in known.undelivered)


def _unnamed(index: Index, mention: Mention) -> Iterator[str]:
    end = mention.end
    if end is None:
        return
    kind = end.kind.replace("_", " ")
    yield f"{kind}" + (f": {code(end.type)}" if end.type else "")
    yield f"its name is not known: {end.error or end.reason}" if end.error or end.reason else "its name is not known"
    if end.qos is not None and end.kind in ("publisher", "subscriber"):
        yield qos_words(end.qos)


def _parameter(index: Index, mention: Mention) -> Iterator[str]:
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


def _node(index: Index, mention: Mention) -> Iterator[str]:
    if mention.node is not None:
        yield from node_words(mention.node)


def _executable(index: Index, mention: Mention) -> Iterator[str]:
    subject = mention.subject
    yield f"executable {code(subject.name)} of package {code(subject.owner)}"
    if mention.node is not None:
        yield from node_words(mention.node)


def _package(index: Index, mention: Mention) -> Iterator[str]:
    name = mention.subject.name
    package = index.workspace.packages.get(name)
    if package is None:
        yield f"package {code(name)}, not in this workspace"
        return
    yield f"package {code(name)}, in {code(package.relative)}"
    installs = index.workspace.installs.get(name)
    if installs is not None and installs.executables:
        yield "Executables: " + ", ".join(map(code, sorted(installs.executables)))


def _interface(index: Index, mention: Mention) -> Iterator[str]:
    text = index.definition_text(mention.subject.name)
    if text is not None:
        yield f"{code(mention.subject.name)}"
        yield f"```\n{text.strip()}\n```"


def _file(index: Index, mention: Mention) -> Iterator[str]:
    """The path, and of a launch file the arguments that it declares."""
    name = mention.subject.name
    yield f"file {code(name)}"
    launch = next((launched for launched in index.workspace.launched if launched.file == name), None)
    arguments = [argument for argument in launch.declared if argument.file == name] if launch is not None else []
    declared = {argument.name: argument.default.text if argument.default else None for argument in arguments}
    rows = [
        f"- {code(argument)}" + (f", by default {code(default)}" if default else "")
        for argument, default in declared.items()
    ]
    if rows:
        yield "Launch arguments:\n" + "\n".join(rows)


_TELL: Mapping[SubjectKind, Callable[[Index, Mention], Iterable[str]]] = {
    "topic": _connection,
    "service": _connection,
    "action": _connection,
    "unnamed": _unnamed,
    "parameter": _parameter,
    "node": _node,
    "executable": _executable,
    "package": _package,
    "interface": _interface,
    "file": _file,
}

__all__ = ["hover"]

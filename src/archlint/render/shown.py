"""One name with both ends and all places, for a terminal and as JSON."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import partial
from typing import TYPE_CHECKING, Any

from archlint.json_text import json_text
from archlint.lookup.summaries import ConnectionSummary, FrameSummary, NodeSummary, ParameterSummary, Summary
from archlint.model import EntityKind
from archlint.render import json, look, text

if TYPE_CHECKING:
    from archlint.analysis.transforms import Transform
    from archlint.place import Place
    from archlint.render.text import Cell, Paint
    from archlint.systems.nodes import Endpoint

VERSION = 1
_SIDES = {"topic": ("publishers", "subscribers"), "service": ("servers", "clients"), "action": ("servers", "clients")}
_NO_FRAME = "a frame that is not known"
_OF_TOPICS = (EntityKind.PUBLISHER, EntityKind.SUBSCRIBER)


def render_text(answers: Sequence[Summary], *, color: bool = False) -> str:
    """What is known of a name, for a terminal; several answers are apart."""
    paint = partial(text.painted_text, color)
    return "\n\n".join("\n".join(_block(answer, paint)) for answer in answers) + "\n"


def _block(answer: Summary, paint: Paint) -> Iterator[str]:
    match answer:
        case ConnectionSummary():
            yield from _connection(answer, paint)
        case ParameterSummary():
            yield from _parameter(answer, paint)
        case FrameSummary():
            yield from _frame(answer, paint)
        case NodeSummary(node=node):
            launched = f"  {paint(node.launched_by, 'quiet')}" if node.launched_by else ""
            first, *rest = text.entry(node, paint).split("\n")
            yield f"{paint('node', 'plain')} {first}{launched}"
            yield from rest


def _frame(answer: FrameSummary, paint: Paint) -> Iterator[str]:
    yield f"{paint('frame', 'plain')} {paint(answer.name, 'name')}"
    rows = [_transform_row("sent by", row, f"in {row.parent or _NO_FRAME}") for row in answer.sent]
    rows += [_transform_row("sent in it", row, row.child or _NO_FRAME) for row in answer.hanging]
    rows += [
        _transform_row("looked up by", row, f"from {row.child or _NO_FRAME} to {row.parent or _NO_FRAME}")
        for row in answer.looked_up
    ]
    if not answer.sent:
        rows.insert(0, [("sent by", "plain"), ("no node here", "quiet"), ("", "plain"), ("", "plain")])
    if not answer.looked_up:
        rows.append([("looked up by", "plain"), ("no node here", "quiet"), ("", "plain"), ("", "plain")])
    yield from text.table(rows, paint)


def _transform_row(words: str, row: Transform, frames: str) -> Sequence[Cell]:
    name = "?" if row.node is None else row.node.name or "a node whose name is not known"
    notes = [frames, *([] if row.certain else ["perhaps"])]
    notes += [row.node.launched_by] if row.node is not None and row.node.launched_by else []
    return [(words, "plain"), (name, "node"), (_where(row.place), "quiet"), (", ".join(notes), "quiet")]


def _connection(answer: ConnectionSummary, paint: Paint) -> Iterator[str]:
    types = " ≠ ".join(answer.types) or "type not known"
    style: text.Style = "alarm" if len(answer.types) > 1 else "plain"
    yield f"{paint(answer.kind, 'plain')} {paint(answer.name, 'name')}  {paint(types, style)}"
    rates = [*answer.rates, *(None for _ in answer.users)]
    sides = [(words, end) for words, ends in zip(text.SIDES[answer.kind], _ends(answer), strict=True) for end in ends]
    rows = [_end_row(words, end, rate) for (words, end), rate in zip(sides, rates, strict=True)]
    rows += (
        [(words, "plain"), ("no node here", "quiet"), ("", "plain"), ("", "plain")]
        for words, ends in zip(text.SIDES[answer.kind], _ends(answer), strict=True)
        if not ends
    )
    yield from text.table(rows, paint)
    yield from (f"  {paint(f'no message arrives: {reason}', 'alarm')}" for reason in answer.undelivered)
    yield from _places("named at", answer.mentioned, paint, rows)


def _ends(answer: ConnectionSummary) -> tuple[Sequence[Endpoint], Sequence[Endpoint]]:
    return answer.providers, answer.users


def _end_row(words: str, end: Endpoint, rate: float | None) -> Sequence[Cell]:
    notes = [look.qos_words(end.qos)] if end.qos is not None and end.kind in _OF_TOPICS else []
    notes += [f"{rate:g} Hz"] if rate is not None else []
    notes += ["only under a condition"] if end.conditional else []
    notes += [end.node.launched_by] if end.node.launched_by else []
    name = end.node.name or "a node whose name is not known"
    return [(words, "plain"), (name, "node"), (_where(end.place), "quiet"), (", ".join(notes), "quiet")]


def _where(place: Place) -> str:
    return f"{place.file}:{place.line}:{place.column}"


def _places(words: str, places: Sequence[Place], paint: Paint, rows: Sequence[Sequence[Cell]]) -> Iterator[str]:
    """One to a line, below the second column of the rows above."""
    width = max(len(row[0][0]) for row in rows)
    for number, place in enumerate(places):
        yield f"  {words if number == 0 else '':<{width}}  {paint(_where(place), 'quiet')}"


def _parameter(answer: ParameterSummary, paint: Paint) -> Iterator[str]:
    nodes = ", ".join(dict.fromkeys(node.name or "?" for node in answer.nodes))
    of = paint(nodes, "node")
    yield f"{paint('parameter', 'plain')} {paint(answer.name, 'name')}  {paint('of', 'plain')} {of}"
    rows: list[Sequence[Cell]] = []
    for declaration in answer.declarations:
        default = f"= {declaration.default!r}" if declaration.known else ""
        kind = " ".join(filter(None, [declaration.type or "type not known", default]))
        rows.append([("declared", "plain"), (kind, "plain"), (_where(declaration.place), "quiet")])
    for node, value in answer.values:
        launch = f"{node.name or '?'}, {node.launched_by}" if node.launched_by else node.name or "?"
        rows.append([("launched with", "plain"), (text.given_words(value), "plain"), (launch, "quiet")])
    if not answer.declarations:
        rows.append([("declared", "plain"), ("nowhere in this workspace", "quiet"), ("", "plain")])
    yield from text.table(rows, paint)
    yield from _places("set at", answer.set_at, paint, rows)
    yield from _places("read at", answer.read_at, paint, rows)


def render_json(name: str, answers: Sequence[Summary]) -> str:
    """The same as data; a key is always there, null where nothing is known."""
    return json_text({"version": VERSION, "name": name, "matches": [*map(_document, answers)]}, indent=2) + "\n"


def _document(answer: Summary) -> dict[str, Any]:
    match answer:
        case ConnectionSummary(kind=kind):
            providers, users = _SIDES[kind]
            rates = dict(zip(map(id, answer.providers), answer.rates, strict=True))
            return {
                "kind": kind,
                "name": answer.name,
                "types": list(answer.types),
                providers: [_end_document(end, rates[id(end)]) for end in answer.providers],
                users: [_end_document(end, None) for end in answer.users],
                "undelivered": list(answer.undelivered),
                "places": [*map(_place_document, answer.mentioned)],
            }
        case ParameterSummary():
            return {"kind": "parameter", **_parameter_document(answer)}
        case FrameSummary():
            return {
                "kind": "frame",
                "name": answer.name,
                "sent": [_transform_document(row, "parent", "child") for row in answer.sent],
                "sent_in_it": [_transform_document(row, "parent", "child") for row in answer.hanging],
                "looked_up": [_transform_document(row, "target", "source") for row in answer.looked_up],
            }
    return {"kind": "node", **json.node_data(answer.node)}


def _transform_document(row: Transform, parent: str, child: str) -> dict[str, Any]:
    node = row.node
    return {
        "node": None if node is None else node.name,
        "launched_by": None if node is None else node.launched_by,
        parent: row.parent,
        child: row.child,
        "certain": row.certain,
        **_place_document(row.place),
    }


def _end_document(end: Endpoint, rate: float | None) -> dict[str, Any]:
    return {
        "node": end.node.name,
        "launched_by": end.node.launched_by,
        **json.endpoint_data(end),
        "rate_hz": rate,
    }


def _parameter_document(answer: ParameterSummary) -> dict[str, Any]:
    first = answer.declarations[0] if answer.declarations else None
    return {
        "name": answer.name,
        "nodes": list(dict.fromkeys(node.name for node in answer.nodes)),
        "type": first.type if first is not None else None,
        "default": json.plain(first.default) if first is not None and first.known else None,
        "declared": [_place_document(declaration.place) for declaration in answer.declarations],
        "values": [
            {
                "node": node.name,
                "launched_by": node.launched_by,
                "value": json.plain(value),
                "reason": json.why_unknown(value),
            }
            for node, value in answer.values
        ],
        "set": [*map(_place_document, answer.set_at)],
        "read": [*map(_place_document, answer.read_at)],
    }


def _place_document(place: Place) -> dict[str, Any]:
    return {
        "file": json.shown_file(place.file),
        "line": place.line,
        "column": place.column,
        "end_line": place.end_line,
        "end_column": place.end_column,
    }


__all__ = ["render_json", "render_text"]

"""The graph for a terminal: nodes with what they create, then who talks to whom, then what is not known."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import partial
from typing import TYPE_CHECKING, Literal

from archlint import cells
from archlint import model as program
from archlint.architecture import ConnectionKind
from archlint.connections.unconnected import unconnected_on
from archlint.counted import counted
from archlint.model import Creation, ParameterDeclaration, Role
from archlint.observed.model import DIFFERENT, MISSING, UNEXPECTED, Difference, Status
from archlint.observed.words import comparison_words
from archlint.render import json, look
from archlint.render.partial import only
from archlint.render.text_marks import Marks, marks_of
from archlint.render.view import WHOLE, View
from archlint.ros.parameter_types import type_of
from archlint.syntax.parameter_files import NotKnown
from archlint.systems import pattern
from archlint.systems.externals import connections_of_externals, remapped_names
from archlint.systems.model import System
from archlint.systems.nodes import Connection, Endpoint, Node
from archlint.systems.overrides import Setting
from archlint.visible import visible

if TYPE_CHECKING:
    from archlint.finding import Finding

_VERBS = {
    program.EntityKind.PUBLISHER: "publishes",
    program.EntityKind.SUBSCRIBER: "subscribes",
    program.EntityKind.SERVICE: "serves",
    program.EntityKind.CLIENT: "calls",
    program.EntityKind.ACTION_SERVER: "acts on",
    program.EntityKind.ACTION_CLIENT: "sends goals",
}
SIDES: Mapping[ConnectionKind, tuple[str, str]] = {
    "topic": ("published by", "subscribed by"),
    "service": ("served by", "called by"),
    "action": ("served by", "called by"),
}
"""What the two sides of a connection are called."""
Style = Literal["plain", "title", "node", "name", "quiet", "alarm", "added", "changed"]
_STYLES: Mapping[Style, str] = {
    "plain": "",
    "title": "1",
    "node": "1;34",
    "name": "36",
    "quiet": "2",
    "alarm": "31",
    "added": "32",
    "changed": "33",
}
_STATUS: Mapping[Status, Style] = {MISSING: "alarm", UNEXPECTED: "added", DIFFERENT: "changed"}
_WIDEST = 48
"""A text longer than this does not push its column aside for all others."""

Cell = tuple[str, Style]
"""A text and its style."""
Paint = Callable[[str, Style], str]


def render(system: System, *, color: bool = False, view: View = WHOLE, findings: Sequence[Finding] = ()) -> str:
    """Raises :class:`archlint.render.selection.NothingOfThatName`."""
    paint = partial(painted_text, color)
    remapped = _remapped(system)
    marks = marks_of(system, view, findings)
    part = only(system, marks.keys)
    sections = [
        _nodes(part, marks, paint),
        _unowned(part, paint),
        _connections(system, "topic", system.topics.values(), remapped, marks, paint),
        _connections(system, "service", system.services.values(), remapped, marks, paint),
        _connections(system, "action", system.actions.values(), remapped, marks, paint),
        _shape(system, paint),
        _unresolved(part, paint),
        _compared(system, paint),
    ]
    blocks = [block for section in sections for block in section]
    return "\n\n".join(blocks or ["no nodes"]) + "\n"


def painted_text(color: bool, text: str, style: Style) -> str:
    """``text`` made safe to show, and marked up where colour is on."""
    shown = visible(text)
    code = _STYLES[style]
    return f"\x1b[{code}m{shown}\x1b[0m" if color and code and shown else shown


def _nodes(system: System, marks: Marks, paint: Paint) -> Iterator[str]:
    if system.nodes:
        yield paint(counted(len(system.nodes), "node"), "title")
    for node in system.nodes:
        yield entry(node, paint, [(words, "alarm") for words in marks.of_node(node)])


def _unowned(system: System, paint: Paint) -> Iterator[str]:
    """The classes and functions that are no nodes, and what they create on one that is not known."""
    if system.unowned:
        yield paint(look.UNOWNED, "title")
    yield from (entry(node, paint) for node in system.unowned)


def entry(node: Node, paint: Paint, marks: Sequence[Cell] = ()) -> str:
    """A node with what it has, a line each."""
    heading = "  ".join(paint(*cell) for cell in (*_heading(node), *marks) if cell[0])
    return "\n".join([heading, *table([*_rows(node)], paint)])


def _heading(node: Node) -> Iterator[Cell]:
    if node.is_node:
        yield (node.name, "node") if node.name else ("name not known", "alarm")
    if node.blueprint is None:
        where = "not followed" if node.unfollowed else f"not in this workspace{_known_from(node)}"
        yield f"{node.package}/{node.executable}, {where}", "quiet"
        yield look.condition_words(node), "quiet"
        return
    place = node.blueprint.place
    yield node.blueprint.class_name, "plain"
    yield "/".join(filter(None, [node.package, ", ".join(node.executables)])), "plain"
    yield "lifecycle" if node.blueprint.lifecycle else "", "plain"
    yield f"{place.file}:{place.line}", "quiet"
    yield look.condition_words(node), "quiet"
    yield "test code" if node.test else "", "quiet"
    yield node.error or "", "alarm"


def _known_from(node: Node) -> str:
    """Where it is known from what an external node has."""
    if node.known is None:
        return ""
    versions = list(dict.fromkeys(node.known.versions.values()))
    read = f"version {' to '.join(dict.fromkeys((versions[0], versions[-1])))}" if versions else node.known.source
    return f", {'known' if node.known.complete else 'known in part'} from {read}"


def _rows(node: Node) -> Iterator[Sequence[Cell]]:
    if node.external:
        yield from (_remap_row(old, new) for old, new in remapped_names(node))
    for kind, verb in _VERBS.items():
        yield from (_endpoint_row(endpoint, verb) for endpoint in node.of_kind(kind))
    yield from map(_timer_row, node.timers)
    yield from (_parameter_row(parameter, node) for parameter in node.parameters)
    yield from map(_setting_row, node.settings)


def _endpoint_row(endpoint: Endpoint, verb: str) -> Sequence[Cell]:
    style: Style = "alarm" if endpoint.error or endpoint.name is None else "name"
    notes = ", ".join([_where(endpoint), *_notes(endpoint)])
    type_ = endpoint.type or "type not known"
    return [(verb, "plain"), (endpoint.name or "?", style), (type_, "plain"), (notes, "quiet")]


def _where(endpoint: Endpoint) -> str:
    """The line, and the file where it is not the node's own."""
    place, node = endpoint.place, endpoint.node.blueprint
    return f"line {place.line}" if node and node.place.file == place.file else f"{place.file}:{place.line}"


def _notes(endpoint: Endpoint) -> Iterator[str]:
    if endpoint.qos is not None and endpoint.kind in (program.EntityKind.PUBLISHER, program.EntityKind.SUBSCRIBER):
        yield look.qos_words(endpoint.qos)
    if endpoint.parameter and endpoint.resolution == "parameter":
        yield f"from the parameter {endpoint.parameter}"
    if endpoint.conditional:
        yield "only under a condition"
    if endpoint.error:
        yield endpoint.error


def _timer_row(timer: Creation) -> Sequence[Cell]:
    period = "?" if timer.period is None else f"{timer.period:g}"
    callback = timer.callbacks.get(Role.TIMER)
    return [
        ("timer", "plain"),
        (f"every {period} s", "plain"),
        (callback.name if callback else "", "plain"),
        (f"line {timer.place.line}", "quiet"),
    ]


def _setting_row(setting: Setting) -> Sequence[Cell]:
    known = given_words(setting.value)
    kind = type_of(setting.value) or ""
    place = f"{setting.place.file}:{setting.place.line}"
    return [("parameter", "plain"), (setting.name, "plain"), (f"{kind} {known}".strip(), "plain"), (place, "quiet")]


def given_words(value: object) -> str:
    """``= 2.0``, or why the value is not known."""
    return f"= ? ({value.reason})" if isinstance(value, NotKnown) else f"= {value!r}"


def _parameter_row(parameter: ParameterDeclaration, node: Node) -> Sequence[Cell]:
    default = f"= {parameter.default!r}" if parameter.known and parameter.default is not None else ""
    name = parameter.name.text
    if name is not None and name in node.overrides and not parameter.ignore_override:
        given = node.overrides[name]
        default = f"{given_words(given)}, set by the launch" + (f" (default {default[2:]})" if default else "")
    return [
        ("parameter", "plain"),
        (name or "?", "plain"),
        (" ".join(filter(None, [parameter.type, default])), "plain"),
        (f"line {parameter.place.line}", "quiet"),
    ]


def _remapped(system: System) -> dict[str, list[str]]:
    """The external nodes that are remapped to a name, by that name."""
    names: dict[str, list[str]] = {}
    for node, name in connections_of_externals(system):
        names.setdefault(name, []).append(look.node_label(node).partition("\n")[0])
    return names


def _connections(
    system: System,
    kind: ConnectionKind,
    connections: Iterable[Connection],
    remapped: dict[str, list[str]],
    marks: Marks,
    paint: Paint,
) -> Iterator[str]:
    every = [connection for connection in connections if (kind, connection.name) in marks.keys]
    if every:
        yield paint(counted(len(every), kind), "title")
    for connection in every:
        types = paint(
            " ≠ ".join(connection.types) or "type not known",
            "alarm" if len(connection.types) > 1 else "plain",
        )
        ends = zip(SIDES[kind], (connection.providers, connection.users), strict=True)
        lines = [f"  {words:<13}  {_names(endpoints, paint)}" for words, endpoints in ends]
        if connection.name in remapped:
            lines.append(f"  {'remapped for':<13}  {paint(', '.join(remapped[connection.name]), 'plain')}")
        lines += (f"  {paint(words, 'alarm')}" for words in _broken(system, connection))
        told = (f"  {paint(words, 'alarm')}" for words in marks.of((kind, connection.name)))
        yield "\n".join([f"{paint(connection.name, 'name')}  {types}{''.join(told)}", *lines])


def _broken(system: System, connection: Connection) -> Iterator[str]:
    for pair in unconnected_on(system, connection):
        source, target = pair.offer.node.name, pair.request.node.name
        if connection.kind == "topic":
            yield f"no message from {source} reaches {target}: {pair.reason}"
        else:
            yield f"no request from {target} reaches {source}: {pair.reason}"


def _names(endpoints: Sequence[Endpoint], paint: Paint) -> str:
    names = [name or "a node whose name is not known" for name in json.node_names(endpoints)]
    return paint(", ".join(names), "plain") if names else paint("no node here", "quiet")


def _shape(system: System, paint: Paint) -> Iterator[str]:
    """Which architecture pattern the system resembles, with its figures."""
    if system.nodes:
        yield paint("shape", "title")
        yield "\n".join(f"  {paint(line, 'plain')}" for line in pattern.words(pattern.figures(system)))


def _remap_row(old: str, new: str) -> Sequence[Cell]:
    return [("remaps", "plain"), (old, "name"), (f"to {new}", "plain"), ("", "plain")]


def _unresolved(system: System, paint: Paint) -> Iterator[str]:
    entries = json.unresolved(system)
    if entries:
        yield paint(f"{len(entries)} not resolved", "title")
        yield "\n".join(table([_unresolved_row(entry) for entry in entries], paint))


def _unresolved_row(entry: dict[str, object]) -> Sequence[Cell]:
    kind = str(entry["kind"]).replace("_", " ")
    return [(f"{entry['file']}:{entry['line']}", "quiet"), (kind, "plain"), (str(entry["reason"]), "plain")]


def _compared(system: System, paint: Paint) -> Iterator[str]:
    """What came of holding the system against a running one."""
    compared = system.compared
    if compared is None:
        return
    yield paint("running system", "title")
    yield "\n".join(f"  {paint(line, 'plain')}" for line in comparison_words(compared))
    if compared.differences:
        rows = sorted(compared.differences, key=lambda difference: (difference.status, difference.message))
        yield "\n".join(table([_difference_row(row) for row in rows], paint))
    quiet = [*(f"not compared: {words}" for words in compared.left_open), *compared.notes]
    if quiet:
        yield "\n".join(f"  {paint(line, 'quiet')}" for line in quiet)


def _difference_row(difference: Difference) -> Sequence[Cell]:
    place = f"{difference.place.file}:{difference.place.line}"
    return [(difference.status, _STATUS[difference.status]), (difference.message, "plain"), (place, "quiet")]


def table(rows: Sequence[Sequence[Cell]], paint: Paint) -> Iterator[str]:
    """Rows with aligned columns, indented by two; the last column is as wide as it is."""
    texts = [[visible(text) for text, _ in row] for row in rows]
    painted = [[paint(text, style) for text, style in row] for row in rows]
    for line in cells.columns(texts, _WIDEST, painted):
        yield f"  {line}"

"""A trace for a terminal: what leads to a name and on from it as trees, then times, misfits and assumptions."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from functools import partial
from typing import TYPE_CHECKING

from archlint.counted import counted
from archlint.dataflow.latency import ASSUMED, is_known_in_part, total
from archlint.dataflow.model import Link, Step, StepKind
from archlint.render.text import painted_text
from archlint.render.tracing.relations import doubts, relation
from archlint.render.tracing.step_notes import notes
from archlint.render.tracing.words import node_words, place_words, step_name, title

if TYPE_CHECKING:
    from archlint.dataflow.latency import Term
    from archlint.dataflow.model import Flow
    from archlint.dataflow.paths import Branch, Direction
    from archlint.dataflow.subjects import SubjectKind
    from archlint.dataflow.trace import Trace, Way
    from archlint.render.text import Paint

MOST_ROWS = 150
"""Lines of one tree; a way to or from one node is shorter."""
MOST_SYSTEMS = 4
"""Traces that differ from launch file to launch file."""
_SHORTEN = "--from and --to show the ways between two names"


def render(traces: Sequence[Trace], *, color: bool = False) -> str:
    """Traces for a terminal; systems in which a trace is the same are named together."""
    paint = partial(painted_text, color)
    blocks: dict[str, list[Trace]] = {}
    for trace in traces:
        blocks.setdefault("\n".join(_body(trace, paint)), []).append(trace)
    shown = list(blocks.items())[:MOST_SYSTEMS]
    parts = ["\n".join([_heading(alike, paint), body]) for body, alike in shown]
    if len(blocks) > len(shown):
        more = counted(len(blocks) - len(shown), "more trace")
        parts.append(paint(f"… and {more}, in other systems: --launch FILE shows that of one launch file", "quiet"))
    assumed = "\n".join([paint("assumed", "title"), *(f"  {paint(words, 'quiet')}" for words in ASSUMED)])
    return "\n\n".join([*parts, assumed]) + "\n"


def _heading(alike: Sequence[Trace], paint: Paint) -> str:
    subject = alike[0].subject
    types = ", ".join(type_ for step in subject.arriving if step.connection for type_ in step.connection.types)
    words = [paint(subject.kind, "plain"), paint(subject.name, "name"), paint(types, "plain")]
    names = [trace.system.name for trace in alike if trace.system.name]
    if names:
        others = f" and {counted(len(names) - 1, 'more launch file')}" if len(names) > 1 else ""
        words.append(paint(f"{names[0]}{others}", "quiet"))
    return "  ".join(filter(None, words)).replace("   ", "  ")


def _body(trace: Trace, paint: Paint) -> Iterator[str]:
    sections: tuple[tuple[str, Direction, Sequence[Branch]], ...] = (
        ("comes from", "back", trace.back),
        ("goes to", "on", trace.on),
    )
    for words, direction, branches in sections:
        rows = [row for branch in branches for row in _tree(trace.flow, branch, direction, paint, len(branches) > 1)]
        if branches:
            yield paint(words, "title")
            yield from rows[:MOST_ROWS] or [f"  {paint(_nothing(trace, direction), 'quiet')}"]
        if len(rows) > MOST_ROWS:
            yield f"  {paint(f'… and {len(rows) - MOST_ROWS} more lines: {_SHORTEN}', 'quiet')}"
    if trace.beside:
        yield paint("also, in nodes that no launch file starts", "title")
        for end in trace.beside:
            words = f"{end.kind.replace('_', ' ')} of {node_words(end.node)}"
            yield f"  {paint(words, 'plain')}  {paint(place_words(end.place), 'quiet')}"
    yield from _times(trace, paint)
    if trace.misfits:
        yield paint("does not fit", "title")
        for misfit in trace.misfits:
            yield f"  {paint(_step_words(misfit.step), 'node')}: {paint(misfit.words, 'alarm')}"


def _nothing(trace: Trace, direction: Direction) -> str:
    return _NOTHING[direction].get(trace.subject.kind, "nothing that is known")


_NOTHING: Mapping[Direction, Mapping[SubjectKind, str]] = {
    "back": {
        "topic": "nobody here publishes it",
        **dict.fromkeys(("service", "action"), "nobody here calls it"),
        "frame": "no node here is seen to send it as the child of another frame",
    },
    "on": {
        "topic": "nobody here subscribes to it",
        **dict.fromkeys(("service", "action"), "nobody here serves it"),
        "frame": "no transform that is looked up is seen to depend on it",
    },
}
"""What is said where a trace has nothing to show, by what is traced."""


# -------------------------------------------------------------------------------------------------- the tree


def _tree(flow: Flow, root: Branch, direction: Direction, paint: Paint, with_root: bool) -> Iterator[str]:
    """A line for each branch, the root first where there are several."""
    if with_root and (root.branches or root.step.kind == StepKind.CALLBACK):
        yield f"  {_step_line(flow, root, direction, paint)}"
    stack = [(branch, 1 + with_root) for branch in reversed(root.branches)]
    while stack:
        branch, depth = stack.pop()
        yield f"{'  ' * depth}{_step_line(flow, branch, direction, paint)}"
        stack += [(below, depth + 1) for below in reversed(branch.branches)]


def _step_line(flow: Flow, branch: Branch, direction: Direction, paint: Paint) -> str:
    step, link = branch.step, branch.link
    if link is None and (step.connection is not None or step.kind == StepKind.FRAME):
        return paint(title(step), "name")
    words = [paint(relation(link, direction), "plain")] if link is not None else []
    if step.node is not None and step.kind != StepKind.STRANGER:
        words.append(paint(node_words(step.node), "node"))
    words.append(paint(step_name(step), "node" if step.kind == StepKind.STRANGER else "name"))
    words = [word for word in words if word]
    place = _place(step, link)
    remarks = [place] if place else []
    remarks += ["shown elsewhere"] if branch.again else notes(flow, step)
    line = f"{' '.join(words)}  {paint(', '.join(remarks), 'quiet')}".rstrip()
    alarm = ", ".join(doubts(link))
    return f"{line}  {paint(alarm, 'alarm')}" if alarm else line


def _place(step: Step, link: Link | None) -> str:
    """Where a callback sends, or else where it is defined."""
    place = step.place
    if step.kind == StepKind.CALLBACK and link is not None and link.tail is step and link.place is not None:
        place = link.place
    elif step.kind == StepKind.UNKNOWN and link is not None:
        place = link.place or place
    return "" if place is None else place_words(place)


# -------------------------------------------------------------------------------------------------- the times


def _times(trace: Trace, paint: Paint) -> Iterator[str]:
    ways = [way for way in trace.ways if is_known_in_part(way.terms)]
    if not ways:
        return
    alike: dict[tuple[object, ...], list[Way]] = {}
    for way in ways:
        alike.setdefault(tuple((term.seconds, term.words) for term in way.terms), []).append(way)
    yield paint("takes at most", "title")
    for first, *others in alike.values():
        more = f", and {counted(len(others), 'more way')} like it" if others else ""
        yield f"  {paint(way_words(first), 'name')}{paint(more, 'quiet')}"
        yield f"    {paint(sum_words(first.terms), 'plain')}"
        for term in first.terms:
            seconds = "not known" if term.seconds is None else f"{term.seconds:.3g} s"
            yield f"    {paint(f'{seconds:>9}', 'plain')}  {paint(term.words, 'quiet')}"
    if trace.more_ways:
        more = counted(trace.more_ways, "more way")
        yield f"  {paint(f'… and {more}: {_SHORTEN}', 'quiet')}"


def way_words(way: Way) -> str:
    """``/sensor_node → /scan → /control_node``: nodes and connections along a way, with the callbacks at its ends."""
    names: list[str] = []
    steps = [way.links[0].tail, *(link.head for link in way.links)]
    for step in steps:
        name = node_words(step.node) if step.node is not None else step.name
        if not names or names[-1] != name:
            names.append(name)
    for step, position in ((steps[0], 0), (steps[-1], -1)):
        if step.kind == StepKind.CALLBACK:
            names[position] += f" {step.name}"
    return " → ".join(names)


def sum_words(terms: Sequence[Term]) -> str:
    """``1 s + 2 s = 3 s, and the service /set_motor``."""
    known = [f"{term.seconds:.3g} s" for term in terms if term.seconds is not None]
    unknown = list(dict.fromkeys(term.short for term in terms if term.seconds is None))
    figure = " + ".join(known) + (f" = {total(terms):.3g} s" if len(known) > 1 else "")
    return ", and ".join(filter(None, [figure, " and ".join(unknown)]))


def _step_words(step: Step) -> str:
    return f"{node_words(step.node)} {step_name(step)}"


__all__ = ["render", "sum_words", "way_words"]

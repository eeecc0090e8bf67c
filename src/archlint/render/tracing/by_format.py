"""The formats of traces: each a function of the name that was asked for, what was found, and colours."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Final

from archlint.render.tracing import json, picture, text

if TYPE_CHECKING:
    from archlint.dataflow.trace import Trace
    from archlint.render.tracing.picture import Row, Rows

TRACES: Final[Mapping[str, Callable[[str, Sequence[Trace], bool], str]]] = {
    "text": lambda name, traces, color: text.render(traces, color=color),
    "json": lambda name, traces, color: json.render(name, traces),
    "mermaid": lambda name, traces, color: picture.mermaid(_rows(traces)),
    "dot": lambda name, traces, color: picture.dot(_rows(traces)),
    "svg": lambda name, traces, color: picture.svg(_rows(traces)),
}


def _rows(traces: Sequence[Trace]) -> Rows:
    """What is drawn of traces: a picture that differs from the others for each system."""
    unlike: dict[str, Row] = {}
    for trace in traces:
        row = trace.flow, trace.steps, trace.links, frozenset(map(id, trace.subject.arriving))
        unlike.setdefault(picture.mermaid([row]), row)
    return list(unlike.values())[: text.MOST_SYSTEMS]


__all__ = ["TRACES"]

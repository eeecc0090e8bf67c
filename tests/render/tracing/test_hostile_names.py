"""No name becomes anything but a name, in any format of a trace."""

from __future__ import annotations

import json
import re

import pytest

from archlint.dataflow.trace import Trace
from archlint.dataflow.traces import traces
from archlint.render.tracing.by_format import TRACES
from render.hostile import NAMES, hostile

_CONTROL = re.compile(r"[\x00-\x09\x0b-\x1f\x7f-\x9f\u200b-\u200f\u202a-\u202e]")


@pytest.fixture
def hostile_traces() -> list[Trace]:
    """A trace of each node, which publishes a topic with a hostile name."""
    system = hostile()
    return [trace for number in range(len(NAMES)) for trace in traces(system, f"/n{number}")]


@pytest.mark.parametrize("format", ["text", "mermaid", "dot"])
def test_no_control_character_is_shown(hostile_traces: list[Trace], format: str) -> None:
    assert len(hostile_traces) == len(NAMES)
    drawn = [TRACES[format]("name", [trace], False) for trace in hostile_traces]
    assert [text for text in drawn if _CONTROL.search(text)] == []


def test_a_label_of_mermaid_ends_where_it_should(hostile_traces: list[Trace]) -> None:
    for trace in hostile_traces:
        for line in TRACES["mermaid"]("name", [trace], False).splitlines():
            assert line.count('"') in (0, 2)
            assert "<script" not in line


def test_a_text_of_dot_ends_where_it_should(hostile_traces: list[Trace]) -> None:
    quoted = re.compile(r'"(?:[^"\\]|\\.)*"')
    for trace in hostile_traces:
        bare = quoted.sub("", TRACES["dot"]("name", [trace], False))
        assert re.fullmatch(r"[\w\s{}\[\];=,.>-]*", bare), bare


def test_data_has_the_names_as_they_are(hostile_traces: list[Trace]) -> None:
    for name, trace in zip(NAMES, hostile_traces, strict=True):
        steps = json.loads(TRACES["json"]("name", [trace], False))["traces"][0]["steps"]
        if name.isprintable():
            assert f"/{name}" in [step["name"] for step in steps]

"""D2: one statement of ours for each line, whatever names are like."""

from __future__ import annotations

import re

import pytest

from archlint.render import render
from archlint.render.d2 import quote
from render.hostile import hostile
from render.lesson import lesson
from systems.builders import node, publisher, system


def test_the_lesson() -> None:
    drawn = str(render("d2", lesson()))
    assert 'service_set_motor: "/set_motor\\nSetMotorSpeed" {\n  shape: hexagon\n' in drawn
    assert "node_control_node -> service_set_motor: {\n" in drawn
    assert "pattern: request clusters" in drawn


def test_groups_are_containers() -> None:
    drawn = str(render("d2", system(node("/a", publisher("/x"), package="p"), node("/b", package="q"))))
    assert 'g0: "p"\ng1: "q"\n' in drawn
    assert "g0.node_a -> g0.topic_x: {\n" in drawn


@pytest.mark.parametrize(
    ("text", "quoted"), [('a"b', '"a\\"b"'), ("a\\", '"a\\\\"'), ("${x}", '"\\${x}"'), ("a\nb", '"a\\nb"')]
)
def test_quoting(text: str, quoted: str) -> None:
    assert quote(text) == quoted


def test_no_name_leaves_its_quotes() -> None:
    text, id = r'"(?:[^"\\]|\\.)*"', r"(?:g\d+\.)?(?:(?:node|topic)_[A-Za-z0-9_]*|caption)"
    style = rf"style: \{{fill: {text}; stroke: {text}; font-color: {text}|style: \{{stroke: {text}; font-color: {text}"
    statement = (
        rf"direction: right|g\d+: {text}|{id}: {text} \{{|{id} (->|--) {id}:( {text})? \{{|(shape|near): [a-z-]+"
        rf"|tooltip: {text}|{style}|(border-radius|stroke-dash|stroke-width): \d+|\}}"
    )
    others = [line for line in str(render("d2", hostile())).splitlines() if not re.fullmatch(statement, line.strip())]
    assert others == []

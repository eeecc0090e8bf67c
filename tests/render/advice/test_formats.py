"""Advice for a terminal, as data and as Markdown."""

from __future__ import annotations

import json

from archlint.advice.model import Advice, Evidence, Judged, Use, unknown
from archlint.place import Place
from archlint.render.advice import FORMAT_NAMES, FORMATS

PLACE = Place("robot/node.py", 3, 5, 3, 9)
STREAM = Judged(Use.STREAM, "topic", "it is asked too often", "publish it", 10.0, (Evidence(PLACE, "/a calls it"),))
ROWS = [
    Advice("topic", "/scan", ("std_msgs/msg/String",), Judged(Use.STREAM, "topic", "nobody has to answer", rate=2.5)),
    Advice("service", "/level", (), STREAM, ("a.launch.py", "b.launch.py")),
    Advice("action", "/move", ("a/action/B",), unknown("no node here sends a goal")),
]


def test_what_should_be_something_else_comes_first():
    lines = FORMATS["text"](ROWS, False).splitlines()
    assert lines[:7] == [
        "something else fits better (1)",
        "  service /level  type not known",
        "    in a.launch.py, b.launch.py",
        "    used as a stream, 10 Hz",
        "    a topic fits better: it is asked too often",
        "    instead: publish it",
        "      /a calls it  robot/node.py:3",
    ]
    assert [line for line in lines if not line.startswith(" ") and line][1:] == ["fits (1)", "not known (1)"]
    assert lines[-2:] == ["    how it is used is not known", "    no node here sends a goal"]


def test_long_evidence_is_cut():
    many = tuple(Evidence(Place("a.py", line, 1, line, 2), "here") for line in range(1, 10))
    lines = FORMATS["text"]([Advice("topic", "/a", (), Judged(Use.STREAM, "topic", "why", evidence=many))], False)
    assert lines.count("here") == 6
    assert "… and 3 more" in lines


def test_each_key_is_always_there():
    rows = json.loads(FORMATS["json"](ROWS, False))["connections"]
    assert len({frozenset(row) for row in rows}) == 1
    assert [(row["fits"], row["better"]) for row in rows] == [(True, None), (False, "topic"), (None, None)]
    assert rows[2]["reason"] == "no node here sends a goal"


def test_nothing_of_a_name_becomes_markup():
    text = FORMATS["markdown"]([Advice("topic", "/a|b<i>", (), STREAM)], False)
    assert "| topic | `/a\\|b<i>` | stream | 10 Hz | yes |" in text


def test_nothing_at_all():
    assert all(FORMATS[name]([], False) for name in FORMAT_NAMES)

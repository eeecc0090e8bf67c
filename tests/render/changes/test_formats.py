"""What a comparison looks like: as text, Markdown, Mermaid and JSON."""

from __future__ import annotations

import json as json_module
import re

from archlint.comparing.compare import compare
from archlint.comparing.graphs import Graph
from archlint.render.changes import choosing, json, markdown, mermaid, picture, text
from archlint.render.changes.model import Difference, SideName
from small_systems import end, node, parameter, system

PLANNER = node("/planner", subscribers=[end("/scan")])
BEFORE = system(node("/sensor", publishers=[end("/scan", line=12)], parameters=[parameter("rate", 1.0)]), PLANNER)
AFTER = system(
    node("/sensor", parameters=[parameter("rate", 2.0)]),
    PLANNER,
    node("/light", services=[end("/light/set", "std_srvs/srv/SetBool")], parameters=[]),
)


def difference(before: Graph = BEFORE, after: Graph = AFTER) -> Difference:
    compared = compare([before], [after])
    return Difference(SideName("main", "3f2a" * 10), SideName("the working tree"), compared.changes, compared.sketch)


def test_text():
    assert (
        text.render(difference())
        == """\
main (3f2a3f2a3f2a) → the working tree

breaking
  /sensor: publisher of /scan removed
    /planner still subscribes to it, and no node here offers it
    robot/node.py:12 (base)

risky
  /sensor: parameter rate, default: 1.0 → 2.0
    a node that nobody sets it for behaves otherwise
    robot/node.py:5

safe
  node /light added
    it serves /light/set
    robot/light.py:3

1 breaking, 1 risky, 1 safe changes
"""
    )


def test_a_node_that_went_is_told_once_and_what_others_miss_of_it():
    before = system(node("/sensor", publishers=[end("/scan"), end("/status")]), PLANNER)
    shown = text.render(difference(before, system(PLANNER)))
    assert shown.splitlines()[2:8] == [
        "breaking",
        "  node /sensor removed",
        "    others still use /scan",
        "    it publishes /scan, /status",
        "    breaking: /scan: /planner still subscribes to it, and no node here offers it",
        "    robot/sensor.py:3 (base)",
    ]
    assert "/status:" not in shown


def test_only_what_changed_is_in_the_picture():
    bystander = node("/bystander", publishers=[end("/other")])
    before, after = (system(node("/sensor", publishers=ends), PLANNER, bystander) for ends in ([end("/scan")], []))
    chart = mermaid.render(difference(before, after).sketch).splitlines()
    assert chart[:6] == [
        "flowchart LR",
        '  n0(["/sensor"])',
        '  n1["/scan"]',
        '  n2(["/planner"])',
        "  n0 -.-x|breaking| n1",
        "  n1 --> n2",
    ]


def test_the_picture_has_the_colours_of_the_changes():
    before = system(node("/sensor", publishers=[end("/scan"), end("/old")]), PLANNER)
    after = system(node("/sensor", publishers=[end("/new")]), PLANNER)
    drawn = picture.diagram_of(difference(before, after))
    assert {shape.title: (shape.tone, shape.stroke) for shape in drawn.shapes.values()} == {
        "/sensor": ("aside", "solid"),
        "/planner": ("aside", "solid"),
        "/scan": ("aside", "solid"),
        "/old": ("missing", "dashed"),
        "/new": ("unexpected", "solid"),
    }
    assert {(line.tail[1], line.head[1]): (line.tone, line.labels) for line in drawn.lines} == {
        ("/sensor", "/scan"): ("wrong", ("breaking",)),
        ("/sensor", "/old"): ("missing", ("removed",)),
        ("/sensor", "/new"): ("unexpected", ("new",)),
        ("/scan", "/planner"): ("aside", ()),
    }
    assert drawn.caption[-1] == (
        "red: breaks what others use  ·  red and dashed: gone  ·  green: new  ·  grey: as it was"
    )


def test_a_picture_says_what_is_not_drawn():
    after = system(node("/sensor", publishers=[end(f"/new{number:03}") for number in range(200)]), PLANNER)
    assert "142 more connections are not drawn" in picture.diagram_of(difference(BEFORE, after)).caption


def test_a_picture_of_changes_that_are_no_nodes_and_connections_says_so():
    before, after = (system(node("/sensor", parameters=[parameter("rate", value)])) for value in (1.0, 2.0))
    changed = difference(before, after)
    assert changed.changes
    assert "archlint diff says them in words" in " ".join(picture.diagram_of(changed).caption)
    assert "in words" not in " ".join(picture.diagram_of(difference(BEFORE, BEFORE)).caption)


def test_nothing_to_draw():
    assert mermaid.render(difference(BEFORE, BEFORE).sketch) == ""


def test_a_picture_is_bounded_and_shows_first_what_breaks():
    many = [end(f"/new{number:03}") for number in range(200)]
    after = system(node("/sensor", publishers=many), PLANNER)
    chart = mermaid.render(difference(BEFORE, after).sketch)
    lines = re.findall(r"^  n\d+ \S*[-=]", chart, re.MULTILINE)
    assert len(lines) == choosing.MOST_LINES
    assert chart.index("|breaking|") < chart.index("|new|")
    assert 'more["… and 142 more connections"]' in chart


HOSTILE = '/a"]; click n0 "x`<script>|**@me**\n# b'


def test_names_stay_names():
    after = system(node("/sensor", publishers=[end(HOSTILE)]))
    shown = markdown.render(difference(system(node("/sensor")), after))
    chart = shown.partition("```mermaid\n")[2].partition("```")[0]
    assert "<script>" not in shown
    assert '"x' not in chart
    assert shown.count("```") == 2
    [row] = [line for line in shown.partition("```mermaid")[0].splitlines() if "publisher" in line]
    assert re.sub(r"\\.", "", row).count("|") == 4
    assert "@" not in row
    assert "\n# b" not in text.render(difference(system(node("/sensor")), after))


def test_a_comment_is_bounded():
    many = [end(f"/old{number:03}") for number in range(100)]
    shown = markdown.render(difference(system(node("/sensor", publishers=many)), system(node("/sensor"))))
    assert "### Risky (100)" in shown
    assert shown.count("| /sensor: publisher of /old") == markdown.MOST_ROWS
    assert "… and 60 more." in shown


def test_no_change():
    assert markdown.render(difference(BEFORE, BEFORE)) == (
        "## Architecture: no change of the architecture\n\nmain (3f2a3f2a3f2a) → the working tree\n"
    )


def test_json():
    document = json_module.loads(json.render(difference()))
    assert document["base"] == {"name": "main", "commit": "3f2a" * 10}
    assert document["summary"] == {"breaking": 1, "risky": 1, "safe": 2}
    assert document["findings"] is None
    assert [(change["subject"], change["status"], change["side"]) for change in document["changes"]] == [
        ("publisher", "removed", "base"),
        ("parameter", "changed", "head"),
        ("node", "added", "head"),
        ("service", "added", "head"),
    ]

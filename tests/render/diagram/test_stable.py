"""A small edit changes little of a picture: what Graphviz reads is the same but for what is about the edit."""

from __future__ import annotations

from collections.abc import Sequence

import pytest

from archlint.render.diagram.crowded import MANY_LINES
from archlint.render.diagram.large import MOST_NODES
from archlint.render.view import View
from archlint.ros.qos import Qos
from archlint.systems.nodes import Node
from render.pictures import diagram, dot
from systems.builders import node, publisher, subscriber, system

BELOW, ABOVE = 8, 25
"""Pairs of nodes whose lines are drawn each, and pairs whose lines are too many for that."""
GROUPS = 24
"""Packages of three nodes each, which are too many to draw each node."""
NEW = node("/new", publisher("/news"), package="m")


def pairs(number: int, more: tuple[str, ...] = ()) -> list[Node]:
    """Nodes that talk two by two, half of them without success, which is said on the line; the first two also over
    ``more`` topics."""
    made = []
    for n in range(number):
        topics = (f"/data{n}", *(more if n == 0 else ()))
        asked = Qos(reliability="reliable" if n % 2 else "best_effort")
        senders = [publisher(topic, qos=Qos(reliability="best_effort")) for topic in topics]
        takers = [subscriber(topic, qos=asked) for topic in topics]
        made += [
            node(f"/from{n}", *senders, package=f"a{n % 3}"),
            node(f"/to{n}", *takers, package=f"a{n % 3}"),
        ]
    return made


def groups() -> list[Node]:
    return [
        node(f"/{side}{n}", publisher(f"/x{n}"), subscriber(f"/x{n + 1}"), package=f"p{n:02}")
        for n in range(GROUPS)
        for side in ("a", "b", "c")
    ]


def statements(nodes: Sequence[Node], view: View) -> list[str]:
    """All that Graphviz reads but for the caption, which counts."""
    return [line for line in dot(system(*nodes), view).splitlines() if not line.startswith("  graph ")]


SYSTEMS = {"few lines": pairs(BELOW), "many lines": pairs(ABOVE), "many nodes": groups()}
VIEWS = (View(), View(style="nodes"), View(style="topics"), View(group="package"), View(every_line=True))


def test_the_systems_lie_on_both_sides_of_what_changes_a_picture() -> None:
    lines = {name: len(diagram(system(*nodes), View(every_line=True)).lines) for name, nodes in SYSTEMS.items()}
    assert lines["few lines"] < MANY_LINES < lines["many lines"]
    assert len(SYSTEMS["many lines"]) < MOST_NODES < len(SYSTEMS["many nodes"])


@pytest.mark.parametrize("name", SYSTEMS)
@pytest.mark.parametrize("view", VIEWS, ids=str)
def test_a_node_with_a_topic_more(name: str, view: View) -> None:
    before = statements(SYSTEMS[name], view)
    for place in (0, len(SYSTEMS[name]) // 2, len(SYSTEMS[name])):
        after = statements([*SYSTEMS[name][:place], NEW, *SYSTEMS[name][place:]], view)
        assert only_added(before, after)


@pytest.mark.parametrize("number", [BELOW, ABOVE])
@pytest.mark.parametrize("view", VIEWS, ids=str)
def test_a_topic_more_between_two_nodes(number: int, view: View) -> None:
    """Nothing of the other nodes changes; what two nodes share may be listed in one shape."""
    before, after = statements(pairs(number), view), statements(pairs(number, more=("/a_new",)), view)
    about = ("from0", "to0", "data0", "a_new")
    assert [line for line in before if not is_about(line, about)] == [
        line for line in after if not is_about(line, about)
    ]
    assert any("a_new" in line for line in after)


def is_about(line: str, names: Sequence[str]) -> bool:
    return any(f"{name}{after}" in line for name in names for after in ' _"<\\,:')


def only_added(before: Sequence[str], after: Sequence[str]) -> bool:
    """Whether all of ``before`` is in ``after``, in its order, and all else is about what is new."""
    rest = iter(after)
    new = len(after) - len(before)
    return all(line in rest for line in before) and 0 < new <= len(NEW_STATEMENTS)


NEW_STATEMENTS = ("node", "topic", "line", "frame", "look of the frame", "end of the frame")

"""Which parts of a system a view shows, by names and ties alone."""

from __future__ import annotations

import pytest

from archlint.render.selection import Network, NothingOfThatName, selected
from archlint.render.view import View

LINES = {
    "/camera": ["/image", "/rosout"],
    "/detector": ["/image", "/objects", "/rosout"],
    "/planner": ["/objects", "/path", "/rosout"],
    "/arm/driver": ["/path", "/arm/state", "/arm/driver/get_parameters"],
}
"""Nodes and what they have: camera -image- detector -objects- planner -path- driver, and a state that nobody reads."""


def network() -> Network:
    ties: dict[tuple[str, str], list[tuple[str, str]]] = {}
    for node, names in LINES.items():
        for name in names:
            kind = "service" if "get_" in name else "topic"
            ties.setdefault(("node", node), []).append((kind, name))
            ties.setdefault((kind, name), []).append(("node", node))
    matched = frozenset(key for key, ends in ties.items() if key[0] != "node" and len(ends) > 1)
    return Network(ties, matched)


def shown(**options: object) -> set[str]:
    return {name for _, name in selected(network(), View(**options))}


NODES = {*LINES}
TOPICS = {"/image", "/objects", "/path", "/arm/state"}


def test_what_every_node_has_is_hidden() -> None:
    assert shown() == NODES | TOPICS


def test_all_of_it_on_request() -> None:
    assert shown(everything=True) == NODES | TOPICS | {"/rosout", "/arm/driver/get_parameters"}


def test_what_is_asked_for_by_name_is_not_hidden() -> None:
    assert shown(only=("/rosout",)) == {"/rosout", "/camera", "/detector", "/planner"}


@pytest.mark.parametrize(
    ("depth", "near"),
    [
        (1, {"/detector", "/image", "/objects", "/camera", "/planner"}),
        (2, {"/detector", "/image", "/objects", "/camera", "/planner", "/path", "/arm/driver"}),
    ],
)
def test_the_focus_on_a_node(depth: int, near: set[str]) -> None:
    assert shown(focus=("/detector",), depth=depth) == near


def test_the_focus_on_a_topic_has_both_ends() -> None:
    assert shown(focus=("/objects",)) == {"/objects", "/detector", "/planner"}
    assert shown(focus=("/objects",), depth=2) == shown(focus=("/objects",)) | {"/image", "/path", "/camera"} | {
        "/arm/driver"
    }


def test_a_name_needs_no_slash() -> None:
    assert shown(focus=("objects",)) == shown(focus=("/objects",))


def test_only_shows_things_with_their_ends() -> None:
    assert shown(only=("/arm/*",)) == {"/arm/driver", "/arm/state", "/path", "/arm/driver/get_parameters"} - {
        "/arm/driver/get_parameters"
    }
    assert shown(only=("/path",)) == {"/path", "/planner", "/arm/driver"}


def test_hidden_nodes_take_along_what_only_they_have() -> None:
    assert shown(hide=("/arm/*",)) == {"/camera", "/detector", "/planner", "/image", "/objects", "/path"}
    assert shown(hide=("/camera", "/detector")) == {"/planner", "/arm/driver", "/objects", "/path", "/arm/state"}


def test_ends_that_nobody_uses_are_left_out() -> None:
    assert shown(matched=True) == NODES | {"/image", "/objects", "/path"}


def test_topics_alone() -> None:
    assert "/arm/driver/get_parameters" not in shown(style="topics", everything=True)
    assert shown(style="topics") > TOPICS


def test_a_name_that_nothing_has() -> None:
    with pytest.raises(NothingOfThatName, match=r"^nothing here is called /detectr; did you mean '/detector'\?$"):
        shown(focus=("/detectr",))

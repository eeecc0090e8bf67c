"""Loops over the containers of C++'s standard library."""

from __future__ import annotations

import pytest
from tests.cpp_nodes import graph_of

CREATE = "create_publisher<std_msgs::msg::String>"


def names(statements: str) -> list[str | None]:
    [node] = graph_of(statements)
    return [end["name"] for end in node["publishers"]]


@pytest.mark.parametrize(
    "loop",
    [
        "for (const auto & [name, depth] : topics) %s(name, depth);",
        "for (auto && [name, depth] : topics) { %s(name, depth); }",
        "for (const auto & topic : topics) %s(topic.first, topic.second);",
        "for (auto topic : topics) { %s(topic.first, topic.second); }",
    ],
)
@pytest.mark.parametrize("container", ["std::map<std::string, int>", "std::vector<std::pair<std::string, int>>"])
def test_a_loop_over_pairs(container: str, loop: str) -> None:
    statements = f'{container} topics = {{{{"a", 1}}, {{"b", 2}}}};' + loop % CREATE
    assert names(statements) == ["/a", "/b"]


def test_a_loop_over_a_map_that_is_not_known() -> None:
    assert names(f"for (const auto & [name, depth] : acme::topics()) {CREATE}(name, depth);") == [None]
    assert names(f"for (const auto & topic : acme::topics()) {CREATE}(topic.first, 10);") == [None]

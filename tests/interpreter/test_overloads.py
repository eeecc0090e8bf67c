"""Functions of C++ that share a name: how many of them a call is held against."""

from __future__ import annotations

import pytest
from tests.cpp_nodes import NODE, graph

from archlint.interpreter import overloads


@pytest.mark.parametrize(("functions", "compared"), [(20, 20), (400, 0)])
def test_a_call_is_held_against_a_hundred_at_most(functions: int, compared: int, monkeypatch: pytest.MonkeyPatch):
    asked = 0
    accepted = overloads._accepted

    def counted(function: overloads.FunctionValue) -> int:
        nonlocal asked
        asked += 1
        return accepted(function)

    monkeypatch.setattr(overloads, "_accepted", counted)
    head, _, rest = NODE.partition("class Robot")
    crowd = "\n".join(f"void say(int a{number}) {{}}" for number in range(functions))
    text = f"{head}{crowd}\nclass Robot{rest}" % 'say(1); create_publisher<std_msgs::msg::String>("after", 10);'
    [node] = graph({"src/robot.cpp": text})["nodes"]
    assert asked == compared  # of a crowd the last one is meant
    assert [end["name"] for end in node["publishers"]] == ["/after"]

"""What is around a piece of facts, and what a file stores in and reads."""

from __future__ import annotations

import pytest

from archlint.syntax import facts
from archlint.syntax.python.lowering import lower
from archlint.syntax.tree import Tree, span_of

CODE = """\
import rclpy


class Talker:
    TOPIC = '/said'

    def __init__(self):
        if rclpy.ok():
            self.pub = self.make('a', lambda: self.late())
            first, *rest = self.pub.names
            print(first)

    def make(self, name, what):
        for one in name:
            del what
        with open(name) as stream:
            total = (count := 1)
        return [each for each in stream]
"""


@pytest.fixture
def tree() -> Tree:
    return Tree(lower(CODE))


def call_of(tree: Tree, name: str) -> facts.Call:
    [call] = [one for one in tree.of_kind(facts.Call) if getattr(one.func, "attr", "") == name]
    return call


def test_what_is_around_a_call(tree: Tree):
    call = call_of(tree, "late")
    function, cls = tree.function_around(call), tree.class_around(call)
    assert function is not None and function.name == "__init__"
    assert cls is not None and cls.name == "Talker"
    kinds = [type(one).__name__ for one in tree.around(call)]
    assert kinds == ["Lambda", "Argument", "Call", "Assign", "If", "Function", "Class"]


def test_what_a_call_is_given_is_known_by_where_it_stands():
    tree = Tree(lower("outer(inner(name), *names, key=name)\n"))
    [outer, inner] = tree.of_kind(facts.Call)
    given = {(span, call.func.variable) for span, (call, _) in tree.given.items()}
    assert given == {((1, 13, 1, 17), "inner"), ((1, 7, 1, 18), "outer"), ((1, 32, 1, 36), "outer")}
    assert tree.given[inner.span] == (outer, inner)


def test_a_call_is_known_by_where_it_stands(tree: Tree):
    call = call_of(tree, "ok")
    assert tree.calls[call.span] is call and span_of(call) == (8, 12, 8, 22)


def test_what_is_stored(tree: Tree):
    stored = [getattr(target, "id", getattr(target, "attr", "")) for _, target in tree.stored]
    assert sorted(stored) == sorted(
        ["TOPIC", "pub", "first", "rest", "total", "what", "one", "each", "count", "stream"]
    )


@pytest.mark.parametrize(("name", "inside", "read"), [
    ("first", "__init__", True),
    ("rest", "__init__", False),  # only stored
    ("first", "make", False),  # in another function
    ("name", "make", True),
    ("total", None, False),
])  # fmt: skip
def test_what_is_read(tree: Tree, name: str, inside: str | None, read: bool):
    function = next((one for one in tree.of_kind(facts.Function) if one.name == inside), None)
    assert tree.reads(name, function) is read

"""What code must show before a fix may move it: that it runs once, that a name is constant, whose node it is."""

from __future__ import annotations

import pytest

from archlint.analysis.limit_sites import same_code
from archlint.analysis.surrounding_code import as_code, is_constant, own_node, runs_once, statement_before
from archlint.syntax import facts
from archlint.syntax.python.lowering import lower
from archlint.syntax.tree import Tree
from archlint.syntax.walk import called_name


def tree_and_call(code: str) -> tuple[Tree, facts.Call]:
    """The tree of a piece of code, and its call of ``here()``."""
    tree = Tree(lower(code))
    [call] = [one for one in tree.of_kind(facts.Call) if called_name(one) == "here"]
    return tree, call


IN_CLASS = """
from rclpy.node import Node
from other import Other, NAME
FIXED = '/fixed'
CHANGED = '/one'
CHANGED = '/other'


class Talker({bases}):
    TOPIC = '/said'
    SET = '/set'

    def __init__(self, given):
        super().__init__('talker')
        self.open()
        self.SET = given

    def open(self):
        {line}
"""


@pytest.mark.parametrize(("line", "before"), [
    ("here('x')", "Expression"),
    ("a = b + here('x')", "Assign"),
    ("a: int = here('x')", "Annotated"),
    ("return here('x')", "Return"),
    ("if here('x'): pass", None),
    ("for _ in 'ab': here('x')", None),
    ("while here('x'): pass", None),
    ("a = [here('x') for _ in 'ab']", None),
    ("a = lambda: here('x')", None),
    ("with here('x'): pass", None),
    ("match here('x'):\n            case 1: pass", None),
])  # fmt: skip
def test_the_statement_that_a_call_is_in(line: str, before: str | None):
    tree, call = tree_and_call(IN_CLASS.format(bases="Node", line=line))
    statement = statement_before(tree, call)
    assert (None if statement is None else type(statement).__name__) == before


@pytest.mark.parametrize(("name", "constant"), [
    ("'/x'", True),
    ("FIXED", True),
    ("CHANGED", False),
    ("NAME", True),
    ("self.TOPIC", True),
    ("Talker.TOPIC", True),
    ("self.SET", False),  # an assignment to the attribute, too
    ("other.NAME", False),  # nothing imports such a module
    ("f'{FIXED}/x'", True),
    ("FIXED + CHANGED", False),
    ("call()", False),
])  # fmt: skip
def test_what_is_constant(name: str, constant: bool):
    tree, call = tree_and_call(IN_CLASS.format(bases="Node", line=f"here({name})"))
    statement = statement_before(tree, call)
    assert statement is not None
    assert is_constant(tree, call.args[0].value, statement) is constant


@pytest.mark.parametrize(("code", "own"), [
    ("def main():\n    node = rclpy.create_node('x')\n    node.here()", True),
    ("def main():\n    node = make()\n    node.here()", False),
    ("def main():\n    node = Node('x')\n    node = Node('y')\n    node.here()", False),
    ("def main():\n    node = Node('x', automatically_declare_parameters_from_overrides=True)\n    node.here()", False),
    ("def main(node):\n    node.here()", False),
])  # fmt: skip
def test_whose_node_it_is(code: str, own: bool):
    tree, call = tree_and_call(code)
    statement = statement_before(tree, call)
    assert statement is not None and isinstance(call.func, facts.Attribute)
    assert own_node(tree, call.func.value, statement) is own


@pytest.mark.parametrize(("before", "once"), [
    ("self.open()", True),
    ("self.open(); self.open()", False),
    ("for _ in 'ab': self.open()", False),
    ("other.open()", False),
])  # fmt: skip
def test_what_runs_once(before: str, once: bool):
    tree, call = tree_and_call(IN_CLASS.format(bases="Node", line="here()").replace("self.open()", before))
    assert runs_once(tree, tree.function_around(call)) is once


@pytest.mark.parametrize(("one", "other", "same"), [
    ("self.asked", "self .asked", True),
    ("asked['a']", 'asked["a"]', True),
    ("self.asked", "self.answered", False),
    ("asked[0]", "asked[1]", False),
])  # fmt: skip
def test_code_that_is_written_alike(one: str, other: str, same: bool):
    _, call = tree_and_call(f"here({one}, {other})")
    assert same_code(call.args[0].value, call.args[1].value) is same


@pytest.mark.parametrize(("text", "code"), [
    ("'a'", "'a'"),
    ('"a"', "'a'"),
    ("self.base + '/x'", "(self.base + '/x')"),
    ("str(x)", None),
    ("names[0]", None),
    ("'a' % x", None),
])  # fmt: skip
def test_names_in_one_form(text: str, code: str | None):
    _, call = tree_and_call(f"here({text})")
    assert as_code(call.args[0].value) == code

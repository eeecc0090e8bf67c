"""Walking facts, and what any fact can be asked."""

from __future__ import annotations

import textwrap

import pytest

from archlint.syntax import facts
from archlint.syntax.parts import everything_in
from archlint.syntax.python.lowering import lower
from archlint.syntax.walk import called_name, calls_in, parts_of, statements_of


def body(source: str) -> list[facts.Stmt]:
    return lower(textwrap.dedent(source)).body


def expression(source: str) -> facts.Expr:
    [statement] = body(source)
    assert isinstance(statement, facts.Expression)
    return statement.value


@pytest.mark.parametrize(
    ("source", "dotted", "last", "variable"),
    [
        ("goal", "goal", "goal", "goal"),
        ("self.node.client", "self.node.client", "client", ""),
        ("make().client", "", "client", ""),
        ("clients[0]", "", "", ""),
        ("['goal']", "", "", ""),
    ],
)
def test_how_an_expression_is_written(source: str, dotted: str, last: str, variable: str) -> None:
    asked = expression(source)
    assert (asked.dotted, asked.last_name, asked.variable) == (dotted, last, variable)


@pytest.mark.parametrize(
    ("source", "text", "number", "is_true"),
    [
        ("f(1)", None, 1.0, False),
        ("f(0.5)", None, 0.5, False),
        ("f('1')", "1", None, False),
        ("f(True)", None, None, True),
        ("f(False)", None, None, False),
        ("f(None)", None, None, False),
        ("f(x)", None, None, False),
    ],
)
def test_what_a_literal_says(source: str, text: str | None, number: float | None, is_true: bool) -> None:
    call = expression(source)
    assert isinstance(call, facts.Call)
    given = call.args[0].value
    assert (given.text, given.number, given.is_true) == (text, number, is_true)


NESTED = """
    first()
    if second():
        with third():
            fourth = lambda: hidden()
    def inner():
        inside()
    last()
"""


def test_parts_leave_out_what_is_inside_other_functions() -> None:
    assert [called_name(call) for call in calls_in(body(NESTED))] == ["first", "second", "third", "last"]
    assert [one.variable for one in parts_of(body(NESTED), facts.Name) if one.id == "hidden"] == []


def test_everything_has_what_is_inside_other_functions_in_the_order_of_the_source() -> None:
    found = [called_name(call) for call in everything_in(body(NESTED), facts.Call)]
    assert found == ["first", "second", "third", "hidden", "inside", "last"]


def test_statements_of_a_kind_are_those_of_the_blocks_too() -> None:
    source = """
        a = 1
        while True:
            try:
                b = 2
            except ValueError:
                c = 3
            finally:
                d = 4
        else:
            e = 5
    """
    found = [one.targets[0].variable for one in statements_of(body(source), facts.Assign)]
    assert found == ["a", "b", "c", "d", "e"]
    assert [type(one) for one in statements_of(body(source))][:3] == [facts.Assign, facts.While, facts.Try]


@pytest.mark.parametrize(
    ("source", "truth"), [("True", True), ("1", True), ("''", False), ("None", False), ("0.0", False), ("x", None)]
)
def test_whether_a_literal_is_true(source: str, truth: bool | None) -> None:
    call = expression(f"f({source})")
    assert isinstance(call, facts.Call)
    assert call.args[0].value.truth is truth


@pytest.mark.parametrize(
    ("source", "endless"),
    [
        ("while True: pass", True),
        ("while 1: pass", True),
        ("while rclpy.ok(): pass", False),
        ("while 0: pass", False),
        ("for x in rows: pass", False),
    ],
)
def test_which_loops_are_written_without_an_end(source: str, endless: bool) -> None:
    [loop] = body(source)
    assert isinstance(loop, (facts.While, facts.For))
    assert loop.is_endless is endless


def test_an_attribute_knows_what_the_first_is_read_of() -> None:
    chain = expression("make().client.name")
    assert isinstance(chain, facts.Attribute)
    assert isinstance(chain.owner, facts.Call)


def test_a_fact_is_made_of_its_children_in_order() -> None:
    [statement] = body("if a:\n    b()\nelse:\n    c()")
    assert [type(child).__name__ for child in statement.children()] == ["Name", "Expression", "Expression"]
    assert [[one.span[0] for one in block] for block in statement.blocks] == [[2], [4]]

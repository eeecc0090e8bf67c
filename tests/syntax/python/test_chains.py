"""Chains too long for the parser are told apart from files that are merely long."""

from __future__ import annotations

import pytest

from archlint.syntax.python.chains import longest_chain


@pytest.mark.parametrize(
    ("expression", "links"),
    [
        ("a + b - c", 2),
        ("a ** b // c", 2),
        ("a.b.c.d", 3),
        ("a()()()", 3),
        ("a[0][1]", 2),
        ("not not a", 2),
        ("- - -a", 3),
        ("'a' 'b' \"c\"", 3),
        ("a if b else c", 2),
        ("lambda: lambda: a", 2),
        ("a and b or c in d", 3),
        ("f(a + b, c + d)", 1),
        ("f(a + b) + f(c + d)", 3),
        ("'+ + + +'", 1),
        ("a  # + + +", 0),
        ("notable + order", 1),
        ("(a\n + b\n + c)", 2),
        ("a + \\\n b + \\\n c", 2),
        ("[1, 2, 3, -4]", 1),
    ],
)
def test_links_of_one_expression(expression, links):
    assert longest_chain(f"{expression}\n", 0)[0] == links


def test_statements_are_not_one_chain():
    assert longest_chain("a + b\nc + d; e + f\n", 0) == (1, 1)


def test_the_line_is_where_the_chain_grows_longest():
    assert longest_chain("a + b\n\nc + d + e\n", 0) == (2, 3)


def test_a_file_with_too_few_characters_is_not_scanned():
    assert longest_chain("a + b + c\n", 100) == (0, 1)


@pytest.mark.parametrize(
    ("text", "longest"),
    [
        ("x = a" + ".b" * 300_000, 300_001),
        ("x = " + "a + " * 150_000 + "a", 150_001),
        ("x = " + "'a' " * 150_000, 150_001),
        ("x = " + "(" * 600_000, 2),  # what is in brackets is an expression of its own
        ("x = '" + "\\'" * 300_000, 2),  # one string that does not end
        ("x = [" + "1.0, " * 120_000 + "]", 2),
    ],
    ids=["attributes", "sum", "strings", "brackets", "escapes", "list"],
)
def test_a_large_file_is_scanned_in_one_pass(text: str, longest: int):
    """Quadratic time would be hours here."""
    assert longest_chain(text, 2_500) == (longest, 1)

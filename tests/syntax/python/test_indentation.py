"""Indentation of spaces and tabs mixed, as CPython reads it: by columns."""

from __future__ import annotations

import ast

import pytest

from archlint.syntax.compile import compile_python
from archlint.syntax.python.indentation import with_even_indentation

ACCEPTED = {
    "a tab behind spaces ends at the same column": (
        "def main():\n    if 1:\n    \tif 1:\n            \tx = f(1)\n    \ty = g(2)\n    z = h(3)\n"
    ),
    "with Windows newlines": (
        "def main():\r\n    if 1:\r\n    \tif 1:\r\n            \tx = f(1)\r\n    \ty = g(2)\r\n    z = h(3)\r\n"
    ),
    "a string goes over lines that begin with a tab": (
        "if 1:\n    if 1:\n    \tif 1:\n            \tx = f('''a\n\tb''', 1)\n    \ty = g(2)\n"
    ),
    "arguments on a line of their own": (
        "if 1:\n    if 1:\n    \tif 1:\n            \tx = f(\n\t\t  a, g(1))\n    \ty = g(2)\n"
    ),
}


def _calls(text: str) -> list[tuple[int, int, int, int]]:
    """Where CPython sees calls; columns from 1.  The texts are ASCII, so bytes are characters."""
    nodes = [node for node in ast.walk(ast.parse(text)) if isinstance(node, ast.Call)]
    return sorted((n.lineno, n.col_offset + 1, n.end_lineno, n.end_col_offset + 1) for n in nodes)


def _spans(found: object) -> list[tuple[int, int, int, int]]:
    from archlint.syntax import facts

    if isinstance(found, (list, tuple)):
        return [span for one in found for span in _spans(one)]
    if not hasattr(found, "__struct_fields__"):
        return []
    own = [found.span] if isinstance(found, facts.Call) else []
    return own + [span for name in found.__struct_fields__ for span in _spans(getattr(found, name))]


@pytest.mark.parametrize("text", ACCEPTED.values(), ids=ACCEPTED)
def test_a_file_that_python_compiles_is_read_and_its_places_are_those_of_the_file(text):
    found = compile_python(text)
    assert found.problems == []
    assert sorted(_spans(found.body)) == _calls(text)


def test_the_text_in_a_string_keeps_its_tabs():
    (test,) = compile_python(ACCEPTED["a string goes over lines that begin with a tab"]).body
    assert "'a\\n\\tb'" in repr(test)


def test_comments_have_their_place_too():
    text = "if 1:\n    if 1:\n    \tif 1:\n            \tx = f(1)  # archlint: ignore[NME001]\n    \ty = 2\n"
    (suppression,) = compile_python(text).suppressions
    assert (suppression.line, suppression.column) == (4, text.splitlines()[3].index("#") + 1)


@pytest.mark.parametrize(
    ("text", "line"),
    [("if a:\n\tb\n        c\n", 3), ("if 1:\n    if 1:\n    \tx = 1\n   z = 3\n", 4)],
    ids=["a tab that stands for eight spaces", "a dedent to nowhere"],
)
def test_what_python_refuses_is_a_problem_at_its_line(text, line):
    (problem,) = compile_python(text).problems
    assert problem.line == line and problem.message.startswith("syntax error: ")


def test_an_even_text_is_left_alone():
    assert with_even_indentation("if a:\n    b('\tc')\n") is None

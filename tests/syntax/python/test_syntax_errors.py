"""What is said about a file that cannot be parsed."""

from __future__ import annotations

import pytest

from archlint.syntax.python.syntax_errors import explain_syntax_error

LIBCST = "parser error: error at 3:7: expected one of "


@pytest.mark.parametrize(
    ("text", "line", "words"),
    [
        ("def f(:\n", 1, "syntax error: "),
        ("x = 1\ny = 'abc\n", 2, "unterminated string literal"),
        ("if a:\nb\n", 2, "expected an indented block"),
        ("if a:\n\tb\n        c\n", 3, "inconsistent use of tabs and spaces"),
        ("if a:\n    b\n  c\n", 3, "unindent does not match"),
        ("x = 0777\n", 1, "leading zeros"),
    ],
)
def test_pythons_own_words(text, line, words):
    problem = explain_syntax_error(text, "tokenizer error: whatever")
    assert problem.line == line
    assert words in problem.message


@pytest.mark.parametrize(
    "statement", ["print 'x'", "print x, y", "exec 'x'", "raise E, 'x'", "try:\n  a\nexcept E, e:\n  b"]
)
def test_python_2_is_called_by_its_name(statement):
    problem = explain_syntax_error(f"import a\n{statement}\n", LIBCST + "NEWLINE")
    assert "Python 2" in problem.message or "exception types" in problem.message


def test_print_in_a_docstring_is_not_python_2():
    problem = explain_syntax_error("'''\nprint the value\n'''\nx = (\n", LIBCST + "NAME")
    assert problem.message.startswith("syntax error: ")
    assert problem.line == 4


@pytest.mark.parametrize(
    ("message", "expected"),
    [
        ("parser error: error at 1:2: expected INDENT", (1, 3, "cannot be parsed: expected INDENT")),
        (
            "parser error: error at 1:2: expected one of (, ), *, +, -",
            (1, 3, "cannot be parsed: invalid syntax"),
        ),
        ("tokenizer error: no matching outer block", (1, 1, "cannot be parsed: no matching outer block")),
        ("parser error: error at 9:0: expected )", (2, 1, "cannot be parsed: expected )")),
    ],
)
def test_the_parsers_words_where_python_has_nothing_to_say(message, expected):
    problem = explain_syntax_error("x = 1\n", message)
    assert (problem.line, problem.column, problem.message) == expected


@pytest.mark.parametrize(
    ("text", "line", "column", "head"),
    [
        (
            "class A:\n    def stop(self):\n        # to be written\n\n    def go(self):\n        pass\n",
            2,
            5,
            "def stop(self):",
        ),
        ("for a in b:\n    # later\nc()\n", 1, 1, "for a in b:"),
    ],
)
def test_a_block_that_is_still_to_be_written(text: str, line: int, column: int, head: str):
    problem = explain_syntax_error(text, LIBCST + "INDENT")
    assert (problem.line, problem.column) == (line, column)
    assert problem.message == (
        f"syntax error: '{head}' has a comment only: Python needs a statement there, such as pass"
    )

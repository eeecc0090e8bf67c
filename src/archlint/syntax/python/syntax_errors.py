"""Why a file cannot be parsed, in words that help.

libcst decides whether there is an error; its wording lists the tokens of a grammar.  Python's own compiler
says it better wherever it refuses the file, too.
"""

from __future__ import annotations

import ast
import re
import warnings

from archlint.syntax.facts import FileProblem
from archlint.syntax.python.gate import looks_like_python_2

_POSITION = re.compile(r"error at (\d+):(\d+): ")
_EXPECTED = re.compile(r"expected (?:one of )?(.+)", re.DOTALL)
_MOST_ALTERNATIVES = 3


def explain_syntax_error(text: str, message: str) -> FileProblem:
    """The problem for a text that libcst refuses with ``message``."""
    return python_refusal(text) or _parser_refusal(text, message)


def python_refusal(text: str) -> FileProblem | None:
    """What this Python's own parser has against a text; None where it accepts it, or does not know."""
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            ast.parse(text)
    except SyntaxError as error:
        line, column = max(error.lineno or 1, 1), max(error.offset or 1, 1)
        if looks_like_python_2(_line(text, line)):
            return FileProblem(line, column, "this is Python 2, which no ROS 2 release runs")
        return _only_a_comment(text, line, error.msg) or FileProblem(line, column, f"syntax error: {error.msg}")
    except (ValueError, RecursionError, MemoryError):
        return None
    return None


_WITHOUT_BLOCK = re.compile(r"expected an indented block after .* on line (\d+)")


def _only_a_comment(text: str, line: int, message: str) -> FileProblem | None:
    """The problem for a function or another block of which a comment is all there is, as of one that is still to be
    written; None for another mistake."""
    refused = _WITHOUT_BLOCK.match(message)
    if refused is None:
        return None
    start = int(refused[1])
    between = [shown for number in range(start + 1, line) if (shown := _line(text, number).strip())]
    head = _line(text, start)
    if not between or not all(shown.startswith("#") for shown in between) or not head.rstrip().endswith(":"):
        return None
    column = len(head) - len(head.lstrip()) + 1
    return FileProblem(
        start,
        column,
        f"syntax error: '{head.strip()}' has a comment only: Python needs a statement there, such as pass",
    )


def _parser_refusal(text: str, message: str) -> FileProblem:
    """For code that only a newer Python, or nobody but libcst, could judge."""
    position = _POSITION.search(message)
    line, column = (int(position[1]), int(position[2]) + 1) if position else (1, 1)
    line = min(line, text.count("\n") + 1)
    detail = message[position.end() :] if position else message
    detail = detail.removeprefix("tokenizer error: ").removeprefix("parser error: ")
    expected = _EXPECTED.match(detail)
    if expected is not None and expected[1].count(", ") >= _MOST_ALTERNATIVES:
        detail = "invalid syntax"
    return FileProblem(line, column, f"cannot be parsed: {detail}")


def _line(text: str, number: int) -> str:
    lines = re.split(r"\r\n|\n|\r", text)
    return lines[number - 1] if number <= len(lines) else ""

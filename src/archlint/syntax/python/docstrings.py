"""What the docstring of a class or function says."""

from __future__ import annotations

from collections.abc import Callable
from inspect import cleandoc

import libcst as cst

from archlint.syntax import facts
from archlint.syntax.facts import Expr

DOCSTRING_LIMIT = 2_000
"""How many characters are kept: facts of a library are not to be its manual."""


def docstring_of(suite: cst.BaseSuite, lower: Callable[[cst.CSTNode], Expr]) -> str:
    """The first statement of a suite, where it is a text, without its indentation; empty where there is none.

    As Python has it: strings in a row are one text, and neither bytes nor an f-string are a docstring.
    """
    statement = suite.body[0] if suite.body else None
    small = statement.body[0] if isinstance(statement, cst.SimpleStatementLine) else statement
    if not isinstance(small, cst.Expr) or not isinstance(small.value, (cst.SimpleString, cst.ConcatenatedString)):
        return ""
    text = lower(small.value)
    if not isinstance(text, facts.Literal) or not isinstance(text.value, str):
        return ""
    return _cut(cleandoc(text.value).strip())


def _cut(text: str) -> str:
    return text if len(text) <= DOCSTRING_LIMIT else f"{text[:DOCSTRING_LIMIT].rstrip()} …"


__all__ = ["DOCSTRING_LIMIT", "docstring_of"]

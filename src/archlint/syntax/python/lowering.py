"""A Python file lowered to facts.

The caller has seen to it that the text is safe to parse (see :mod:`archlint.syntax.python.gate`) and that the stack
is deep enough (see :mod:`archlint.syntax.compile`).
"""

from __future__ import annotations

from collections.abc import Mapping

import libcst

from archlint.syntax.comment_words import lookalike
from archlint.syntax.facts import FACTS_VERSION, Facts
from archlint.syntax.parts import names_in
from archlint.syntax.python.comments import find_suppressions
from archlint.syntax.python.exports import find_exports
from archlint.syntax.python.indentation import with_even_indentation
from archlint.syntax.python.lower_statements import Lowering
from archlint.syntax.python.positions import CommentPositions, Positions, SpanFinder

SUPPRESSION_MARK = "archlint:"


def lower(text: str) -> Facts:
    """The facts of a Python file.

    Raises ``libcst.ParserSyntaxError`` for what is not Python 3, and ``RecursionError`` for what is nested
    too deeply for the stack at hand.
    """
    text = text.removeprefix("\ufeff")  # no column counts the byte order mark
    shifts: Mapping[int, tuple[int, int]] = {}
    try:
        module = libcst.parse_module(text)
    except libcst.ParserSyntaxError:
        even = with_even_indentation(text)
        if even is None:
            raise
        module, text, shifts = libcst.parse_module(even.text), even.text, even.shifts
    with_comments = SUPPRESSION_MARK in text or lookalike(text) is not None
    positions = CommentPositions(module) if with_comments else Positions(module)
    spans = SpanFinder(text, positions, shifts)
    lowering = Lowering(spans)
    body = lowering.block(module.body)
    suppressions = []
    if isinstance(positions, CommentPositions):
        suppressions = find_suppressions(text, positions, spans.lines)
    return Facts(
        FACTS_VERSION,
        body=body,
        suppressions=suppressions,
        problems=lowering.problems,
        exports=find_exports(body),
        names=sorted(names_in(body)),
    )

"""TMO001 to TMO003: give a wait a limit, and have somebody look at what came of it.

What was waited for may come later than the limit, so that none of these is safe.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

from archlint.finding import Edit, Fix

if TYPE_CHECKING:
    from archlint.edit_sites import AnswerCheck, LimitlessCall, LogLoop
    from archlint.fixes.source import Source
    from archlint.place import Place

SECONDS = "5.0"


def limited(calls: Sequence[LimitlessCall], source: Source) -> Fix | None:
    """The fix that limits all of some calls of a file that can be limited."""
    edits: dict[Edit, None] = {}
    keywords = []
    for call in calls:
        edits_of_call = _edits(call, source)
        if edits_of_call is not None:
            edits.update(dict.fromkeys(edits_of_call))
            keywords.append(call.keyword)
    if not edits:
        return None
    return Fix("unsafe", tuple(sorted(edits, key=lambda edit: edit.place)), f"set {keywords[0]} to {SECONDS} s")


def _edits(call: LimitlessCall, source: Source) -> list[Edit] | None:
    """None where one part cannot be had: a limit alone would only hide the wait."""
    limit = _limit(call, source)
    looked_at: list[Edit] | None = []
    if call.loop is not None:
        looked_at = _in_loop(call.loop, source)
    elif call.check is not None:
        looked_at = _checked(call.check, source)
    elif call.negated is not None:
        looked_at = [_insertion(source, source.span(call.negated)[0], "rclpy.ok() and ")]
    return None if limit is None or looked_at is None else [limit, *looked_at]


def _limit(call: LimitlessCall, source: Source) -> Edit | None:
    """Where something stands for no limit, in place of that; else as a keyword."""
    if call.value is not None:
        return Edit(call.value, SECONDS)
    tokens = source.tokens(*source.span(call.arguments))
    if len(tokens) < 2 or tokens[-1][0] != ")":
        return None
    before = tokens[-3] if tokens[-2][0] == "," else tokens[-2]
    separator = "" if len(tokens) == 2 else ", "
    return _insertion(source, before[2], f"{separator}{call.keyword}={SECONDS}")


def _in_loop(loop: LogLoop, source: Source) -> list[Edit] | None:
    """``while rclpy.ok() and not …:`` with a warning, in place of the statement."""
    warning = f"{loop.node}.get_logger().warning('waiting for the {loop.waiting_for}')"
    after = _line_after(source, loop.statement, lambda indent, step: [f"{indent}{step}{warning}"])
    if after is None:
        return None
    start, end = source.span(loop.statement)
    return [_insertion(source, start, "while rclpy.ok() and not "), _insertion(source, end, ":"), after]


def _checked(check: AnswerCheck, source: Source) -> list[Edit] | None:
    """``if not …: raise TimeoutError(…)`` behind the statement."""
    test = check.test.format(source.at(check.answer))
    raised = f"raise TimeoutError('{check.words} within {SECONDS} s')"
    after = _line_after(
        source, check.statement, lambda indent, step: [f"{indent}if {test}:", f"{indent}{step}{raised}"]
    )
    return None if after is None else [after]


def _line_after(source: Source, statement: Place, lines: Callable[[str, str], list[str]]) -> Edit | None:
    """Lines behind a statement, made of its indentation and one step more; None where it has not its lines for
    itself."""
    indent, end = source.indent(statement), source.span(statement)[1]
    if indent is None or not _ends_line(source, end):
        return None
    step = "\t" if indent.startswith("\t") else "    "
    text = "".join(f"{line}{source.newline}" for line in lines(indent, step))
    return _insertion(source, source.starts[statement.end_line], text)


def _ends_line(source: Source, end: int) -> bool:
    """Whether nothing but a comment, and the end of the line, follows."""
    return re.match(r"[ \t]*(#[^\r\n]*)?(\r\n|\r|\n)", source.text[end:]) is not None


def _insertion(source: Source, at: int, text: str) -> Edit:
    return Edit(source.place(at, at), text)

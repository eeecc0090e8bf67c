"""``// archlint: ignore[…]`` comments of C++, and the lines that they cover."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from archlint.syntax.comment_words import SUPPRESSION, codes_in, gives_reason, listed_at, lookalike
from archlint.syntax.facts import Suppression

if TYPE_CHECKING:
    from tree_sitter import Node

    from archlint.syntax.cpp.source import SourceText

_SUPPRESSION = re.compile(rf"//\s*{SUPPRESSION}")
_MARK = b"archlint:"


def find_suppressions(source: SourceText, root: Node) -> list[Suppression]:
    """All suppressions of a file, and what only looks like one, in the order in which they stand there."""
    if _MARK not in source.data and b"noqa" not in source.data:
        return []
    suppressions = []
    for comment, before, after in _comments(root):
        text = source.text(comment)
        line, column, *_ = source.span(comment)
        other = lookalike(text)
        if other is not None:
            start = column + other.start()
            suppressions.append(
                Suppression(line, start, start + len(other[0]), (line, line), [], not_understood=other[0])
            )
        for match in _SUPPRESSION.finditer(text):
            covered = (1, source.data.count(b"\n") + 1) if match[1] else _covered(comment, before, after)
            suppressions.append(
                Suppression(
                    line,
                    column + match.start(),
                    column + match.end(),
                    covered,
                    codes_in(match),
                    "file" if match[1] else "line",
                    listed=listed_at(match, column + match.start()),
                    reason=gives_reason(text, match.end()),
                )
            )
    return suppressions


def _comments(root: Node) -> list[tuple[Node, Node | None, Node | None]]:
    """Each comment, what stands before it, and what follows that is no comment; in one walk, because a node finds its
    siblings by going through all of them."""
    comments: list[tuple[Node, Node | None, Node | None]] = []
    waiting = [root]
    while waiting:
        children = waiting.pop().children
        after: Node | None = None
        for at in range(len(children) - 1, -1, -1):
            child = children[at]
            if child.type == "comment":
                comments.append((child, children[at - 1] if at else None, after))
            else:
                after = child
        waiting.extend(children)
    return sorted(comments, key=lambda row: row[0].start_byte)


def _covered(comment: Node, before: Node | None, after: Node | None) -> tuple[int, int]:
    """The statement that a comment ends or, on a line of its own, the next one."""
    line = comment.start_point[0]
    if before is not None and before.end_point[0] == line:
        return before.start_point[0] + 1, line + 1
    return (line + 1, line + 1) if after is None else (after.start_point[0] + 1, after.end_point[0] + 1)


__all__ = ["find_suppressions"]

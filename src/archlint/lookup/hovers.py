"""What a hover says of a position: all that is named there, each by its kind."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping

from archlint.lookup.answers import Hover
from archlint.lookup.hovered_files import executable_lines, file_lines, interface_lines, node_lines, package_lines
from archlint.lookup.hovered_names import connection_lines, parameter_lines, unnamed_lines
from archlint.lookup.index import Index
from archlint.lookup.mentions import Mention, Subject, SubjectKind
from archlint.lookup.moved import Moves
from archlint.lookup.rule_codes import rule_at
from archlint.lookup.texts import Texts

MOST = 6
"""How many names one hover tells of, where several launch files give a place several."""


def hover(index: Index, texts: Texts, file: str, line: int, column: int) -> Hover | None:
    """What is known of the name, create call, node, executable, type or rule code at a position; None for anything
    else, and for names that are not known."""
    rule = rule_at(texts, file, line, column)
    if rule is not None:
        return rule
    mentions = index.at(texts, file, line, column)
    by_subject: dict[Subject, Mention] = {}
    for mention in mentions:
        by_subject.setdefault(mention.subject, mention)
    parts = [
        "\n\n".join(lines)
        for subject, mention in by_subject.items()
        if (lines := [*_TELL.get(subject.kind, _nothing)(index, mention)])
    ]
    place = Moves(index.texts, texts).place_now(mentions[0].place) if parts else None
    if place is None:
        return None
    more = f"\n\n---\n\nand {len(parts) - MOST} more" if len(parts) > MOST else ""
    return Hover("\n\n---\n\n".join(dict.fromkeys(parts[:MOST])) + more, place)


def _nothing(index: Index, mention: Mention) -> Iterable[str]:
    return ()


_TELL: Mapping[SubjectKind, Callable[[Index, Mention], Iterable[str]]] = {
    "topic": connection_lines,
    "service": connection_lines,
    "action": connection_lines,
    "unnamed": unnamed_lines,
    "parameter": parameter_lines,
    "node": node_lines,
    "executable": executable_lines,
    "package": package_lines,
    "interface": interface_lines,
    "file": file_lines,
}

__all__ = ["hover"]

"""A comparison in sentences."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from archlint.observed.model import Comparison


def comparison_words(compared: Comparison | None) -> Iterator[str]:
    """A sentence on what was compared with what, and what came of it."""
    if compared is None:
        return
    status = Counter(difference.status for difference in compared.differences)
    counts = ", ".join(f"{status[word]} {word}" for word in ("missing", "unexpected", "different") if status[word])
    what = [(compared.nodes, "node"), (compared.ends, "endpoint" if compared.nodes else "topic")]
    same = " and ".join(f"{count} {word}{'' if count == 1 else 's'}" for count, word in what if count)
    yield f"Compared {compared.observed.file} with {compared.with_what}."
    yield f"{same or 'Nothing'} on both sides; {counts or 'no difference'}."


def comparison_notices(compared: Comparison | None) -> Iterator[str]:
    """What a running system was held against, and what of it could not be."""
    if compared is None:
        return
    observed = compared.observed
    yield from compared.notes
    if not observed.nodes and not observed.topics:
        yield f"{observed.file} contains no running nodes or topics"
    if compared.left_open:
        more = len(compared.left_open) - 1
        rest = f"; and {more} more, which `archlint graph --observed` lists" if more else ""
        yield f"not compared, because the source does not say: {compared.left_open[0]}{rest}"

"""Advice for a terminal: what should be something else first, then what fits, then what is not known."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import partial
from typing import TYPE_CHECKING

from archlint.render.advice.words import TITLES, of_section, used_words, verdict
from archlint.render.text import painted_text
from archlint.render.tracing.words import place_words

if TYPE_CHECKING:
    from archlint.advice.model import Advice
    from archlint.render.text import Paint

MOST_EVIDENCE = 6
"""Lines of evidence for one connection; ``--format json`` has all of them."""


def render(rows: Sequence[Advice], *, color: bool = False) -> str:
    """A section for each answer to whether the kind of a connection fits."""
    paint = partial(painted_text, color)
    sections = []
    for fitting, title in TITLES:
        among = of_section(rows, fitting)
        if among:
            lines = [line for advice in among for line in _lines(advice, paint)]
            sections.append("\n".join([paint(f"{title} ({len(among)})", "title"), *lines]))
    return "\n\n".join(sections or [paint("no topic, service or action is here", "quiet")]) + "\n"


def _lines(advice: Advice, paint: Paint) -> Iterator[str]:
    judged = advice.judged
    types = " ≠ ".join(advice.types) or "type not known"
    yield f"  {paint(advice.kind, 'plain')} {paint(advice.name, 'name')}  {paint(types, 'quiet')}"
    if advice.systems:
        yield f"    {paint('in ' + ', '.join(advice.systems), 'quiet')}"
    yield f"    {paint(used_words(advice), 'plain')}"
    yield f"    {paint(verdict(advice), 'alarm' if advice.is_fitting is False else 'plain')}"
    if judged.instead:
        yield f"    {paint('instead: ' + judged.instead, 'plain')}"
    for evidence in judged.evidence[:MOST_EVIDENCE]:
        yield f"      {paint(evidence.words, 'plain')}  {paint(place_words(evidence.place), 'quiet')}"
    if len(judged.evidence) > MOST_EVIDENCE:
        yield f"      {paint(f'… and {len(judged.evidence) - MOST_EVIDENCE} more', 'quiet')}"


__all__ = ["render"]

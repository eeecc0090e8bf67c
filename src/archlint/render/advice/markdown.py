"""Advice as Markdown: a table of all connections, then what should be something else, with the evidence."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.render import markdown
from archlint.render.advice.words import of_section, used_words, verdict
from archlint.render.json import shown_file

if TYPE_CHECKING:
    from archlint.advice.model import Advice


def render(rows: Sequence[Advice]) -> str:
    """A page, or a comment on a change."""
    return "\n".join(_lines(rows)) + "\n"


def _lines(rows: Sequence[Advice]) -> Iterator[str]:
    yield "# Topics, services and actions"
    yield ""
    if not rows:
        yield "No topic, service or action is here."
        return
    titles = ("kind", "name", "used as", "rate", "fits", "launch file")
    yield from markdown.table(titles, map(_row, rows))
    for advice in of_section(rows, False):
        yield ""
        yield f"## {advice.kind.capitalize()} {markdown.code(advice.name)}"
        yield ""
        judged = advice.judged
        yield f"{markdown.text(used_words(advice).capitalize())}. {markdown.text(verdict(advice).capitalize())}."
        if judged.instead:
            yield ""
            yield f"**Instead**: {markdown.text(judged.instead)}."
        yield ""
        for evidence in judged.evidence:
            file = shown_file(evidence.place.file)
            place = markdown.link(markdown.text(f"{file}:{evidence.place.line}"), file, evidence.place.line)
            yield f"- {markdown.text(evidence.words)} ({place})"


def _row(advice: Advice) -> list[str]:
    judged = advice.judged
    fits = "not known" if judged.fits is None else "yes" if advice.is_fitting else f"better: {judged.fits}"
    rate = "" if judged.rate is None else f"{judged.rate:.3g} Hz"
    systems = ", ".join(map(markdown.code, advice.systems))
    return [advice.kind, markdown.code(advice.name), str(judged.use), rate, fits, systems]


__all__ = ["render"]

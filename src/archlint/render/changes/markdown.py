"""A comparison as Markdown, for the comment of a pull request: bounded, and with a picture of what changed."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Final

from archlint.comparing.changes import Change, Impact
from archlint.render import markdown
from archlint.render.changes import mermaid, words
from archlint.render.changes.model import Difference

if TYPE_CHECKING:
    from archlint.finding import Finding

MOST_ROWS: Final = 40
"""Rows of each table: a comment with more is not read, and GitHub takes 65,536 characters."""
_LONGEST: Final = 300
"""Characters of a text of the user's."""


def render(difference: Difference) -> str:
    base, head = (_text(side.words) for side in (difference.base, difference.head))
    parts = [f"## Architecture: {words.counted(difference)}\n", f"{base} → {head}\n"]
    told, inside = words.folded(list(difference.changes))
    for impact in Impact:
        changes = [change for change in told if change.impact == impact]
        if changes:
            parts.append("\n".join(_section(impact, changes, inside)) + "\n")
    picture = mermaid.render(difference.sketch)
    if picture:
        parts.append(f"<details open><summary>What changed</summary>\n\n```mermaid\n{picture}```\n\n</details>\n")
    parts += _findings("New findings", difference.appeared)
    parts += _findings("Fixed findings", difference.vanished)
    return "\n".join(parts)


def _section(impact: Impact, changes: Sequence[Change], inside: dict[str, list[Change]]) -> Iterator[str]:
    title = f"{impact.value.capitalize()} ({len(changes)})"
    safe = impact == Impact.SAFE
    yield f"<details><summary>{title}</summary>\n" if safe else f"### {title}\n"
    yield "| what | why | where |"
    yield "|---|---|---|"
    for change in changes[:MOST_ROWS]:
        what = _text(words.headline(change, str))
        ends = inside.get(change.name, []) if change.subject == "node" else []
        why = [change.reason, *([f"it {words.ends_in_short(ends)}"] if ends else [])]
        why += [f"{end.name}: {end.reason}" for end in words.worth_telling(change, ends)][:5]
        about = filter(None, (words.place(change.spot) if change.spot else "", words.where(change)))
        yield f"| {what} | {_text('; '.join(why))} | {_text(', '.join(about))} |"
    if len(changes) > MOST_ROWS:
        yield f"\n… and {len(changes) - MOST_ROWS} more."
    if safe:
        yield "\n</details>"


def _findings(title: str, findings: Sequence[Finding] | None) -> Iterator[str]:
    if not findings:
        return
    rows = [
        f"<details><summary>{title} ({len(findings)})</summary>\n",
        "| | rule | where | what |",
        "|---|---|---|---|",
    ]
    for finding in findings[:MOST_ROWS]:
        place = f"{finding.place.file}:{finding.place.line}"
        rows.append(f"| {finding.severity.label} | {finding.code} | {_text(place)} | {_text(finding.message)} |")
    if len(findings) > MOST_ROWS:
        rows.append(f"\n… and {len(findings) - MOST_ROWS} more.")
    yield "\n".join([*rows, "\n</details>\n"])


def _text(text: str) -> str:
    """Text of the user's as Markdown that says the same and nothing else: no markup, no mention, no row of its own."""
    return markdown.text(text if len(text) <= _LONGEST else f"{text[:_LONGEST]}…")

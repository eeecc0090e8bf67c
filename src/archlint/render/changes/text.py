"""A comparison for a terminal."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import partial
from typing import TYPE_CHECKING

from archlint.comparing.changes import Change, Impact
from archlint.render.changes import words
from archlint.render.changes.model import Difference
from archlint.render.text import painted_text
from archlint.visible import visible

if TYPE_CHECKING:
    from archlint.finding import Finding
    from archlint.render.text import Paint, Style

_STYLES: dict[Impact, Style] = {Impact.BREAKING: "alarm", Impact.RISKY: "name", Impact.SAFE: "quiet"}


def render(difference: Difference, color: bool = False) -> str:
    paint = partial(painted_text, color)
    lines = [f"{visible(difference.base.words)} → {visible(difference.head.words)}", ""]
    told, inside = words.folded(list(difference.changes))
    for impact in Impact:
        changes = [change for change in told if change.impact == impact]
        if changes:
            lines += [paint(impact.value, _STYLES[impact])]
            lines += [line for change in changes for line in _change(change, inside, paint)]
            lines.append("")
    lines += _findings("new findings", difference.appeared, paint)
    lines += _findings("fixed findings", difference.vanished, paint)
    lines.append(", ".join(filter(None, (words.counted(difference), words.findings_counted(difference)))))
    return "\n".join(lines) + "\n"


def _change(change: Change, inside: dict[str, list[Change]], paint: Paint) -> Iterator[str]:
    yield f"  {words.headline(change, visible)}"
    if change.impact != Impact.SAFE:
        yield f"    {visible(change.reason)}"
    ends = inside.get(change.name, []) if change.subject == "node" else []
    if ends:
        yield f"    it {visible(words.ends_in_short(ends))}"
    for end in words.worth_telling(change, ends):
        yield f"    {end.impact}: {visible(end.name)}: {visible(end.reason)}"
    about = ", ".join(filter(None, (words.place(change.spot) if change.spot else "", words.where(change))))
    if about and (change.impact != Impact.SAFE or change.subject == "node"):
        yield f"    {paint(visible(about), 'quiet')}"


def _findings(title: str, findings: Sequence[Finding] | None, paint: Paint) -> Iterator[str]:
    if not findings:
        return
    yield paint(title, "plain")
    for finding in findings:
        place = f"{finding.place.file}:{finding.place.line}"
        yield f"  {finding.code} {visible(finding.message)}"
        yield f"    {paint(visible(place), 'quiet')}"
    yield ""

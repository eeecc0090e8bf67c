"""What ``--watch`` shows: the last result, what came and went since the one before, and the time."""

from __future__ import annotations

import sys
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from datetime import datetime
from typing import TYPE_CHECKING

from rich.console import Console
from rich.text import Text

from archlint.cli.console import noted, wants_color
from archlint.visible import visible

if TYPE_CHECKING:
    from archlint.cli.console import When
    from archlint.engine.answers import Answer
    from archlint.finding import Finding

_NAMED = 5
"""How many findings that came are named, and how many that went."""


class View:
    """A terminal, of which each run takes the whole."""

    def __init__(self, color: When, quiet: bool) -> None:
        no_color = not wants_color(color, sys.stdout)
        self._console = Console(force_terminal=True, force_interactive=False, highlight=False, no_color=no_color)
        self._quiet = quiet

    def show(
        self, answer: Answer, findings: Sequence[Finding], before: Sequence[Finding] | None, seconds: float
    ) -> None:
        """The result of a run, which took so many ``seconds``; ``before`` are the findings of the one before it."""
        self._begin(f"{answer.text}{answer.warnings}{answer.notes}")
        if before is not None:
            self._show_changes(before, findings)
        self._end(f"checked in {seconds:.1f} s")

    def show_error(self, message: str) -> None:
        """Why there is no result."""
        self._begin(noted(f"archlint: error: {message}"))
        self._end("not checked")

    def _begin(self, text: str) -> None:
        if self._console.is_dumb_terminal:
            self._console.print()
        self._console.clear()
        self._console.file.write(text)

    def _show_changes(self, before: Sequence[Finding], after: Sequence[Finding]) -> None:
        came, went = list(_beyond(after, before)), list(_beyond(before, after))
        if came or went:
            self._console.print(f"Since the last run: {len(came)} new, {len(went)} gone")
        for sign, style, findings in (("+", "red", came), ("-", "green", went)):
            for finding in findings[:_NAMED]:
                self._console.print(Text(f"  {sign} {_line(finding)}", style=style), no_wrap=True, overflow="ellipsis")
            if len(findings) > _NAMED:
                self._console.print(Text(f"  {sign} and {len(findings) - _NAMED} more", style=style))

    def _end(self, words: str) -> None:
        if not self._quiet:
            self._console.print(Text(f"[{datetime.now():%H:%M:%S}] {words}; waiting for changes, Ctrl-C ends", "dim"))
        self._console.file.flush()


def _beyond(findings: Sequence[Finding], others: Iterable[Finding]) -> Iterator[Finding]:
    """The findings that are not among others, wherever they stand in their files."""
    left = Counter(map(_identity, others))
    for finding in findings:
        if left[_identity(finding)]:
            left[_identity(finding)] -= 1
        else:
            yield finding


def _identity(finding: Finding) -> object:
    return (finding.code, finding.severity, finding.place.file, finding.message, finding.system)


def _line(finding: Finding) -> str:
    place = finding.place
    return f"{visible(place.file)}:{place.line} {finding.severity.label} {finding.code} {visible(finding.message)}"


__all__ = ["View"]

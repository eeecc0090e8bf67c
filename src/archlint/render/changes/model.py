"""All that there is to say of two sides."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from archlint.records import dataclass

if TYPE_CHECKING:
    from archlint.comparing.changes import Change, Impact
    from archlint.comparing.sketch import Sketch
    from archlint.finding import Finding


@dataclass(frozen=True)
class SideName:
    """How a side is called; ``commit`` is that of a revision."""

    shown: str
    commit: str | None = None

    @property
    def words(self) -> str:
        if self.commit is None or self.commit.startswith(self.shown):
            return self.shown
        return f"{self.shown} ({self.commit[:12]})"


@dataclass(frozen=True)
class Difference:
    """``appeared`` and ``vanished`` are findings, None where a side has none to compare."""

    base: SideName
    head: SideName
    changes: Sequence[Change]
    sketch: Sketch
    appeared: Sequence[Finding] | None = None
    vanished: Sequence[Finding] | None = None
    notices: Sequence[str] = ()

    def of(self, impact: Impact) -> list[Change]:
        return [change for change in self.changes if change.impact == impact]

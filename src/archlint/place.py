"""A place in the source: what findings, facts and edits stand at."""

from __future__ import annotations

from archlint.records import dataclass


@dataclass(frozen=True, order=True)
class Place:
    """A span of source: ``file`` as the user would type it, lines and columns from 1, end column exclusive."""

    file: str
    line: int
    column: int
    end_line: int
    end_column: int

    @classmethod
    def of(cls, file: str, span: tuple[int, int, int, int]) -> Place:
        return cls(file, *span)

    @property
    def span(self) -> tuple[int, int, int, int]:
        """The place within its file."""
        return (self.line, self.column, self.end_line, self.end_column)

"""A drawing, and what there is to say beside it."""

from __future__ import annotations

from archlint.records import dataclass


@dataclass(frozen=True)
class Drawn:
    """A system in one of the formats of ``archlint graph``: ``data`` of a binary one, ``text`` of the others."""

    text: str
    data: bytes
    notices: list[str]
    """What the arguments of the launch file are about."""
    compared: list[str]
    """Sentences on a running system that it was held against."""
    compared_notices: list[str]
    """What of that could not be compared."""
    faults: list[str]
    """Parts that are missing by a fault of archlint's."""

    @property
    def output(self) -> str | bytes:
        return self.data or self.text

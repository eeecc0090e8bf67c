"""The words every floor above the ground speaks: places, severities, findings and fixes."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field
from enum import IntEnum
from typing import Literal

from archlint.edit_sites import Sites
from archlint.place import Place
from archlint.records import dataclass

__all__ = ["Edit", "Finding", "Fix", "Place", "Related", "Severity", "SeverityLabel"]


SeverityLabel = Literal["info", "warning", "error"]


class Severity(IntEnum):
    """How much a finding weighs; a larger value is more severe."""

    INFO = 1
    WARNING = 2
    ERROR = 3

    @classmethod
    def parse(cls, text: str) -> Severity:
        """The severity called ``text``; raises ``KeyError`` for any other word."""
        return cls[text.upper()]

    @property
    def label(self) -> SeverityLabel:
        return _LABELS[self]


_LABELS: Mapping[Severity, SeverityLabel] = {
    Severity.INFO: "info",
    Severity.WARNING: "warning",
    Severity.ERROR: "error",
}


@dataclass(frozen=True)
class Related:
    """Another place that belongs to a finding, and what it shows."""

    place: Place
    message: str
    again: bool = field(default=False, compare=False)
    """Whether what the finding says is so at this place, too."""


@dataclass(frozen=True)
class Edit:
    """Replace the text of ``place`` by ``text``."""

    place: Place
    text: str


@dataclass(frozen=True)
class Fix:
    """Edits that mend a finding."""

    safety: Literal["safe", "unsafe"]
    edits: tuple[Edit, ...]
    title: str = ""


@dataclass(frozen=True)
class Finding:
    """One thing that a rule found.

    ``identity`` names what the finding is about without line numbers (node, interface name, kind), so that
    a baseline survives edits elsewhere in the file.  Severity is that of the rule unless a rule or the
    configuration says otherwise.
    """

    code: str
    name: str
    severity: Severity
    message: str
    place: Place
    help: str = ""
    node: str | None = None
    system: str | None = None
    related: tuple[Related, ...] = ()
    fix: Fix | None = None
    identity: tuple[str, ...] = field(default=(), compare=False)
    condition: str | None = None
    """The launch arguments (``name:=value``) under which it holds, where no default decides, or another choice than the
    default shows it; None for always.  The message of a finished finding says so, too."""
    group: tuple[str, ...] = field(default=(), compare=False)
    """What it has in common with the findings of its rule that are shown as one with it; empty in a finished one."""

    meant: str = field(default="", compare=False)
    """The name that was perhaps meant, as the message says; empty where none is near."""

    sites: Sites | None = field(default=None, compare=False)
    """What a fix would edit; None where no edit of the text can be right, such as for a wait that is wrong where it
    stands, limit or not."""

    fails: bool = field(default=False, compare=False)
    """Whether what stands at its place raises an exception whenever it is evaluated."""

    @property
    def sort_key(self) -> tuple[str, int, int, str, str, str]:
        place = self.place
        return (place.file, place.line, place.column, self.code, self.message, self.system or "")

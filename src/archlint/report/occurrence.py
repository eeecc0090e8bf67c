"""What a finding is about, in words that stay the same while the code around it moves."""

from __future__ import annotations

import os
import posixpath
import re
from collections.abc import Set

from archlint.finding import Finding, Place, Severity
from archlint.records import dataclass
from archlint.visible import visible

_LINE_NUMBER = re.compile(r"\bline \d+")


@dataclass(frozen=True, order=True)
class Key:
    """What identifies a finding: its rule, its file (absolute) and what it is about."""

    code: str
    file: str
    what: str


@dataclass(frozen=True)
class Occurrence:
    """A finding as its rule made it, before those with one cause are folded into one."""

    code: str
    place: Place
    what: str
    """The names that it is about, safe to show and without line numbers."""
    severity: Severity
    known: bool = False
    """Whether a baseline or an earlier revision has it, too."""

    @classmethod
    def of(cls, finding: Finding, files: Set[str] = frozenset()) -> Occurrence:
        """``files`` are those of the workspace, as findings name them."""
        return cls(finding.code, finding.place, _what(finding, files), finding.severity)

    @property
    def key(self) -> Key:
        return Key(self.code, visible(os.path.abspath(self.place.file)), self.what)


def _what(finding: Finding, files: Set[str]) -> str:
    """The names that a finding is about.  Files are named as seen from its own, wherever archlint was started."""
    parts = finding.identity or (finding.node or "", finding.message)
    own = {finding.place.file, finding.system, *(related.place.file for related in finding.related)}
    folder = posixpath.dirname(finding.place.file) or "."
    shown = [posixpath.relpath(part, folder) if part in own or part in files else part for part in parts if part]
    return _LINE_NUMBER.sub("line", visible(", ".join(shown))).strip()


__all__ = ["Key", "Occurrence"]

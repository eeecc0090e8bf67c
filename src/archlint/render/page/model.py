"""What a page is made of."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import field
from typing import TYPE_CHECKING

from archlint.records import dataclass

if TYPE_CHECKING:
    from archlint.finding import Finding
    from archlint.render.view import GroupBy
    from archlint.systems.model import System


@dataclass(frozen=True)
class PageSystem:
    """A system that the page can show, with the launch arguments that make it."""

    system: System
    arguments: Mapping[str, str] = field(default_factory=dict)

    @property
    def title(self) -> str:
        """``launch/robot.launch.py  use_sim:=true``."""
        words = [self.system.name or "all nodes", *(f"{name}:={value}" for name, value in self.arguments.items())]
        return "  ".join(words)


@dataclass(frozen=True)
class SourceLink:
    """Where the places of a page lead.

    ``address`` has ``{line}``, ``{column}`` and ``{path}``, the absolute path of a file, or ``{file}``, its path in the
    repository.  ``root`` is the folder that files are shown from, and ``folder`` the same in the repository.
    """

    address: str
    root: str
    folder: str


@dataclass(frozen=True)
class PageContents:
    """The systems of a page, the first of which it opens with, and what was found in them."""

    systems: Sequence[PageSystem]
    findings: Sequence[Finding] = ()
    link: SourceLink | None = None
    group: GroupBy | None = None
    """What groups are made of at first; None for what the places were worked out for."""
    collapse: Sequence[str] = ()
    """The groups, by patterns of their titles, that are closed at first."""


__all__ = ["PageContents", "PageSystem", "SourceLink"]

"""What one analysis of a workspace has found, with everything that it was made from."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import field, replace
from functools import cached_property
from typing import TYPE_CHECKING

from archlint.finding import Finding, Related
from archlint.fixes import Surroundings, attach
from archlint.live.buffers import Buffers, Shifts
from archlint.lookup.index import Index
from archlint.records import dataclass
from archlint.workspace.tree import decoded

if TYPE_CHECKING:
    from archlint.config.settings import Settings
    from archlint.live.tree import LiveTree
    from archlint.systems.model import System
    from archlint.workspace.model import Workspace


@dataclass(frozen=True)
class Snapshot:
    """One state of a workspace.  Nothing of it changes afterwards, so that any thread may read it.

    Files are named by their paths from ``root``, with ``/``, as findings and systems name them.
    """

    root: str
    settings: Settings
    buffers: Buffers
    """What the editor held, by absolute path."""
    workspace: Workspace
    tree: LiveTree
    """All files as they were analysed: of one that did not compile, the text that did last."""
    systems: Sequence[Sequence[System]] = ()
    """For each of the workspaces side by side the open system, then one for each launch file."""
    findings: Sequence[Finding] = ()
    judged: Sequence[Finding] = ()
    """The findings at their lines in the texts that were analysed; without those about files that do not compile."""
    shifts: Mapping[str, Shifts] = field(default_factory=dict)
    """Where the lines of files that do not compile now are, by absolute path, beside the text that was analysed."""
    notices: Sequence[str] = ()

    @cached_property
    def indexes(self) -> Sequence[Index]:
        """What the files mention, for each of the workspaces side by side; made when it is first asked for."""
        return [Index(systems, self.tree.text) for systems in self.systems]

    def path(self, file: str) -> str:
        """The absolute path of a file."""
        return os.path.normpath(os.path.join(self.root, file))

    def text(self, file: str) -> str | None:
        """The text of a file as the editor has it, or as it is on the disk; None where it cannot be read."""
        buffer = self.buffers.get(self.path(file))
        if buffer is None:
            return self.tree.text(file)
        try:
            return decoded(buffer.data)
        except UnicodeDecodeError:
            return None

    def mended(self, file: str) -> list[Finding]:
        """The findings of a file with their fixes.  None is made for a file that does not compile now."""
        mine = [finding for finding in self.findings if finding.place.file == file]
        if self.path(file) in self.shifts:
            return mine
        paths = [source.path for source in self.workspace.of_kind("python", "launch_python", "setup_py")]
        return attach(mine, Surroundings(paths, self.tree.given, self.tree.base, self.workspace.inside))


def shown_now(findings: Iterable[Finding], shifts: Mapping[str, Shifts]) -> list[Finding]:
    """Findings of a state in which some files, by the paths of findings, had other lines: at their lines of now, and
    without those whose lines have changed."""
    shown = []
    for finding in findings:
        if shifts.keys().isdisjoint((finding.place.file, *(related.place.file for related in finding.related))):
            shown.append(finding)
            continue
        shift = shifts.get(finding.place.file)
        place = finding.place if shift is None else shift.of(finding.place)
        if place is not None:
            shown.append(replace(finding, place=place, related=tuple(_related_now(finding, shifts))))
    return shown


def _related_now(finding: Finding, shifts: Mapping[str, Shifts]) -> Iterator[Related]:
    for related in finding.related:
        shift = shifts.get(related.place.file)
        place = related.place if shift is None else shift.of(related.place)
        if place is not None:
            yield replace(related, place=place)


__all__ = ["Snapshot", "shown_now"]

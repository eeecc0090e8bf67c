"""What comments in the source keep quiet."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

from archlint.analysis.kept import once

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.syntax.facts import Suppression
    from archlint.systems.model import WorkspaceIndex


def words_ignored_at(workspace: WorkspaceIndex, place: Place) -> list[str]:
    """The codes and names of rules that comments keep quiet at a place, as they are written."""
    known = _suppressions(workspace).get(place.file, ())
    return [word for suppression in known if suppression.covers(place.line) for word in suppression.codes]


@once
def _suppressions(workspace: WorkspaceIndex) -> Mapping[str, Sequence[Suppression]]:
    asked_for = workspace.code.asked_for()
    python = {file.relative: facts.suppressions for file, facts in asked_for if facts.suppressions}
    return {**python, **workspace.launch_files.suppressions()}


__all__ = ["words_ignored_at"]

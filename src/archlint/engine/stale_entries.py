"""Entries of a baseline that no finding matches any more, as findings of their own (LNT004)."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.checks.registry import finding
from archlint.engine.inputs import is_subset
from archlint.finding import Place
from archlint.records import dataclass
from archlint.rulebook import may_be_rule
from archlint.workspace.around import is_below

if TYPE_CHECKING:
    from archlint.engine.inputs import Inputs
    from archlint.engine.known import Entry
    from archlint.finding import Finding

_CANNOT_SAY = ("LNT002", "LNT003")
"""Where something could not be read, or a rule failed, a finding may be missing for that."""


@dataclass(frozen=True)
class Judgement:
    """What a run can say of entries: ``ran`` are the rules that judged everything they can judge."""

    ran: frozenset[str]
    reported: Sequence[Finding]

    def stale(self, idle: Iterable[Entry], inputs: Inputs) -> Iterator[Entry]:
        """The entries of which this run would have reported the finding, if it were still there."""
        if any(finding.code in _CANNOT_SAY for finding in self.reported):
            return
        scope = _Scope(inputs)
        for entry in idle:
            if (entry.key.code in self.ran and scope.holds(entry.key.file)) or not may_be_rule(entry.key.code):
                yield entry


class _Scope:
    """The files that a run reports on."""

    def __init__(self, inputs: Inputs) -> None:
        request = inputs.request
        paths = request.paths if request.linked is None else (os.curdir,)
        self._asked = [os.path.abspath(path) for path in paths]
        # What is declared in a configuration is about all that it is for.
        self._configuration = () if is_subset(request, inputs.workspace) else request.settings.read

    def holds(self, file: str) -> bool:
        return any(is_below(file, path) for path in self._asked) or any(
            file == os.path.abspath(path) for path in self._configuration
        )


def stale_entry(entry: Entry, baseline: str) -> Finding:
    """The finding for an entry of the baseline in a file."""
    key = entry.key
    what = f"{key.code} is no longer found here" if may_be_rule(key.code) else f"there is no rule {key.code}"
    file = os.path.relpath(key.file).replace(os.sep, "/")
    return finding(
        "LNT004",
        Place(baseline, entry.line, 1, entry.line, 1),
        f"this entry of the baseline holds back nothing: {what}: {file}: {key.what}",
        help="`archlint check --prune-baseline` removes it",
        identity=(key.code, file, key.what),
    )


__all__ = ["Judgement", "stale_entry"]

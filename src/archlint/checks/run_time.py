"""GRF005, GRF006 and GRF007: how a running system differs from its source, where `--observed` names a recording."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.finding import Finding, Related, Severity
from archlint.observed.model import DIFFERENT, MISSING, UNEXPECTED

if TYPE_CHECKING:
    from archlint.observed.model import Status
    from archlint.systems.model import System


@rule("GRF005", scope=Scope.RUNNING)
def missing_at_run_time(system: System, options: Options) -> Iterator[Finding]:
    """What the source says of a system, and the running one does not have."""
    yield from _findings("GRF005", MISSING, system)


@rule("GRF006", scope=Scope.RUNNING)
def unexpected_at_run_time(system: System, options: Options) -> Iterator[Finding]:
    """What a running system has, and its source does not."""
    yield from _findings("GRF006", UNEXPECTED, system)


@rule("GRF007", scope=Scope.RUNNING)
def different_at_run_time(system: System, options: Options) -> Iterator[Finding]:
    """What a running system has otherwise than its source."""
    yield from _findings("GRF007", DIFFERENT, system)


def _findings(code: str, status: Status, system: System) -> Iterator[Finding]:
    for difference in system.compared.differences if system.compared is not None else ():
        if difference.status != status:
            continue
        diagnostic = finding(
            code,
            difference.place,
            difference.message,
            help=difference.help,
            related=[Related(place, words) for place, words in difference.related],
            node=difference.node,
            identity=(difference.kind, difference.name, difference.node or ""),
        )
        yield replace(diagnostic, severity=Severity.INFO) if difference.doubtful else diagnostic

"""``--baseline`` and what goes with it: which findings are held back, and the file that says so."""

from __future__ import annotations

import argparse
from collections import Counter
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from archlint.cli.exits import UsageError
from archlint.records import dataclass
from archlint.report.model import recounted

if TYPE_CHECKING:
    from archlint.config.settings import Settings
    from archlint.engine.known import Baseline, Older
    from archlint.engine.request import Request
    from archlint.report.model import Report
    from archlint.report.occurrence import Key


def add_baseline(parser: argparse.ArgumentParser) -> None:
    group = parser.add_argument_group("known findings")
    either = group.add_mutually_exclusive_group()
    either.add_argument("--baseline", metavar="FILE", help="hold back the findings that this file lists")
    either.add_argument("--no-baseline", action="store_true", help="report them, too")
    group.add_argument(
        "--new-only",
        metavar="REV",
        help="report only what the change since the git revision REV brings in; both are checked whole",
    )
    writing = group.add_mutually_exclusive_group()
    writing.add_argument(
        "--write-baseline", action="store_true", help="write the findings of this run to the baseline, and exit with 0"
    )
    writing.add_argument(
        "--prune-baseline", action="store_true", help="remove entries of the baseline that nothing matches; add none"
    )


@dataclass(frozen=True)
class UsedBaseline:
    """The baseline of a run, and whether it is to be written or pruned afterwards."""

    path: Path
    held: Baseline
    writes: bool
    prunes: bool

    def written(self, report: Report) -> tuple[Report, str]:
        """The report with the baseline as it is once it is written, and a sentence on what was done.

        Raises :class:`UsageError` where it cannot be written.
        """
        from archlint.engine.known import NEVER_HELD

        idle = set(report.idle)
        kept = Counter(entry.key for entry in self.held.entries if entry.line not in idle)
        said = f"removed {_entries(len(idle))} from" if idle else "nothing to remove from"
        findings = [finding for finding in report.findings if finding.code != "LNT004"]
        summary = report.summary
        if self.writes:
            _refuse_failures(report)
            new = Counter(occurrence.key for occurrence in report.occurrences if occurrence.code not in NEVER_HELD)
            kept |= new  # what this run did not look at stays
            said = f"wrote {_entries(sum(kept.values()))} to"
            summary = replace(summary, baselined=summary.baselined + len(findings) + summary.older, older=0)
            findings = []
        self._write(kept)
        report = replace(report, findings=findings, summary=recounted(summary, findings), idle=())
        return report, f"{said[0].upper()}{said[1:]} {self.held.file}."

    def _write(self, keys: Counter[Key]) -> None:
        from archlint.engine import baseline_file

        try:
            baseline_file.write(self.path, keys.elements())
        except baseline_file.BaselineError as error:
            raise UsageError(str(error)) from None


def findings_before(request: Request, revision: str | None) -> tuple[tuple[Older, ...] | None, Sequence[str]]:
    """The findings of the revision of ``--new-only``, None without one, and what is to be said of the comparison.

    Raises :class:`UsageError` where they are not known, and ``NothingToDo``.
    """
    if revision is None:
        return None, ()
    from archlint.engine import new_only  # most runs look at one revision

    try:
        before = new_only.findings_before(request, revision)
    except new_only.GitError as error:
        raise UsageError(f"--new-only: {error}") from None
    except OSError as error:
        raise UsageError(f"--new-only: the earlier revision cannot be read: {error.strerror}") from None
    return before.findings, before.notices


def baseline_of(arguments: argparse.Namespace, settings: Settings) -> UsedBaseline | None:
    """The baseline of the command line, else of the configuration; None without one.

    Raises :class:`UsageError` for one that cannot be used.
    """
    path = _path(arguments, settings)
    if path is None:
        return None
    from archlint.engine import baseline_file  # most runs have none

    try:
        if arguments.write_baseline:
            held = baseline_file.read_to_rewrite(path)
        elif not path.exists():
            raise baseline_file.BaselineError(_missing(arguments, settings))
        else:
            held = baseline_file.read(path)
    except baseline_file.BaselineError as error:
        raise UsageError(str(error)) from None
    return UsedBaseline(path, held, arguments.write_baseline, arguments.prune_baseline)


def _path(arguments: argparse.Namespace, settings: Settings) -> Path | None:
    named = arguments.baseline or (None if arguments.no_baseline else settings.baseline)
    option = "write" if arguments.write_baseline else "prune" if arguments.prune_baseline else None
    if named is None and option is not None:
        raise UsageError(
            f"--{option}-baseline needs a file: add `--baseline archlint-baseline.txt`, or "
            '`baseline = "archlint-baseline.txt"` to the configuration'
        )
    return None if named is None else Path(named)


def _missing(arguments: argparse.Namespace, settings: Settings) -> str:
    advice = "to create it, add --write-baseline"
    if arguments.baseline is not None:
        return f"--baseline: no such file: {arguments.baseline}; {advice}"
    return f"{settings.origins.get('baseline', settings.file)}: `baseline` names a file that does not exist; {advice}"


def _refuse_failures(report: Report) -> None:
    failure = next((finding for finding in report.findings if finding.code == "LNT003"), None)
    if failure is not None:
        place = f"{failure.place.file}:{failure.place.line}"
        raise UsageError(f"the baseline is not written, for it would not be complete: {place}: {failure.message}")


def _entries(number: int) -> str:
    return f"{number} {'entry' if number == 1 else 'entries'}"


__all__ = ["UsedBaseline", "add_baseline", "baseline_of", "findings_before"]

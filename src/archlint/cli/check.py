"""``archlint check``: lint."""

from __future__ import annotations

import argparse
import os
import sys
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from archlint import report as reports
from archlint.cli import console, exits
from archlint.cli.baseline import UsedBaseline, baseline_of, findings_before
from archlint.cli.check_options import asks_for_fixes, parser, refuse_combinations
from archlint.cli.exits import UsageError
from archlint.cli.options import (
    observed_of,
    plugins_of,
    pool_of,
)
from archlint.cli.progress import Progress
from archlint.cli.requests import request_of
from archlint.cli.said import Checked, remarks, written
from archlint.engine.answers import Answer
from archlint.engine.keeper import Keeper
from archlint.engine.pipeline import NothingToDo, check
from archlint.finding import Severity
from archlint.report.fix_marks import fix_line
from archlint.report.model import Report
from archlint.report.paths import folder_in_repository
from archlint.visible import visible_text

if TYPE_CHECKING:
    from archlint.engine.request import Request
    from archlint.systems.model import System


def run(arguments: argparse.Namespace) -> int:
    refuse_combinations(arguments)
    if arguments.watch:
        from archlint.cli.watch import watch  # with rich, and what looks for changes

        return watch(arguments, checked)
    done = checked(arguments)
    status = console.give(done.answer)
    done.progress.note_costs()
    if done.request.keeper is not None:
        done.request.keeper.keep(done.answer)
    return status


def checked(arguments: argparse.Namespace) -> Checked:
    """Do what the options say, up to what is printed.  Raises :class:`UsageError`."""
    request = request_of(arguments, plugins_of(arguments))
    settings = request.settings
    baseline = baseline_of(arguments, settings)
    request = replace(
        request,
        observed=observed_of(arguments),
        fixes=asks_for_fixes(arguments),
        keeper=None if settings.plugins else _keeper(arguments, baseline),  # plugins may depend on anything
        baseline=None if baseline is None else baseline.held,
        occurrences=baseline is not None and baseline.writes,
    )
    progress = Progress(sys.stderr, arguments.quiet, arguments.verbose)
    shown: list[System] = []
    try:
        with pool_of(arguments) as pool, progress as monitor:
            running = replace(request, monitor=monitor, pool=pool)
            before, notices = findings_before(running, arguments.new_only)
            request = replace(request, before=before)
            report = check(replace(running, before=before), shown)
            report = replace(report, notices=[*notices, *report.notices])
    except NothingToDo as error:
        raise UsageError(str(error)) from None
    if arguments.diff:
        return Checked(report, _difference(report, arguments), request, progress)
    failing = Severity.parse(arguments.severity)
    report, done = _after_changes(report, request, baseline, progress, arguments)
    if arguments.fix or arguments.add_ignores:
        shown = []  # the files are others now
    folder = folder_in_repository(Path.cwd(), os.environ)
    text = written(replace(report, failing=failing, folder=folder), arguments)
    warnings, notes = ("", "") if arguments.quiet else remarks(report, done, request, shown, arguments)
    answer = Answer(text, warnings, notes, exit_status(report, failing, arguments.exit_zero))
    return Checked(report, answer, request, progress)


def _after_changes(
    report: Report, request: Request, baseline: UsedBaseline | None, progress: Progress, arguments: argparse.Namespace
) -> tuple[Report, list[str]]:
    """Change the files that the command is to change; returns the report on what is left, and what was done."""
    done: list[str] = []
    if arguments.fix:
        from archlint.cli.fix import mend  # with what takes files apart, which most checks do without

        with progress as monitor:
            fixed = mend(replace(request, monitor=monitor), report, arguments.unsafe_fixes)
        report = fixed.report
        done += [f"Fixed {fixed.count} finding{'s' if fixed.count > 1 else ''}."] if fixed.count else []
    if arguments.add_ignores:
        from archlint.cli.ignores import ignore  # as above

        with progress as monitor:
            ignored = ignore(replace(request, monitor=monitor), arguments.reason)
        report = ignored.report
        done.append(ignored.said)
    if baseline is not None and (baseline.writes or baseline.prunes):
        report, said = baseline.written(report)
        done.append(said)
    return report, done


def _keeper(arguments: argparse.Namespace, baseline: UsedBaseline | None) -> Keeper | None:
    """Who keeps what is said, where that is all that the command does, and each time the same."""
    does_more = (
        arguments.file,
        arguments.output,
        arguments.observed,
        arguments.facts,
        arguments.scheduler,
        arguments.fix,
        arguments.diff,
        arguments.write_baseline,
        arguments.prune_baseline,
        arguments.new_only,
        arguments.add_ignores,
    )
    says_more = arguments.statistics, arguments.verbose, not reports.FORMATS[arguments.format].lasting
    if any((*does_more, *says_more, arguments.no_cache)):
        return None
    files = [*(arguments.launch or ())[:1], *([] if baseline is None else [str(baseline.path)])]
    return Keeper(arguments.words, console.terminal(), files)


def _difference(report: Report, arguments: argparse.Namespace) -> Answer:
    """The diff, safe to show, if it is not for a file; exit status 1 where there is one, for a run in CI."""
    from archlint.cli.fix import difference  # as above

    text = difference(report, arguments.unsafe_fixes)
    to_file = arguments.file not in (None, "-")
    if to_file:
        console.write(text, arguments.file)
    status = exits.FINDINGS if text and not arguments.exit_zero else exits.CLEAN
    unsafe = [finding for finding in report.findings if finding.fix is not None and finding.fix.safety == "unsafe"]
    left = "" if arguments.unsafe_fixes else fix_line(unsafe)
    notes = "" if text or arguments.quiet else f"{left or 'No fixes.'}\n"
    return Answer("" if to_file else visible_text(text), "", notes, status)


def exit_status(report: Report, failing: Severity, exit_zero: bool) -> int:
    if any(finding.code == "LNT003" for finding in report.findings):
        return exits.FAILED
    if any(finding.severity >= failing for finding in report.findings):
        return exits.CLEAN if exit_zero else exits.FINDINGS
    return exits.CLEAN


__all__ = ["checked", "exit_status", "parser", "run"]

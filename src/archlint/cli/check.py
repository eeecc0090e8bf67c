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
from archlint.cli.baseline import UsedBaseline, add_baseline, baseline_of, findings_before
from archlint.cli.exits import UsageError
from archlint.cli.options import (
    add_configuration,
    add_facts,
    add_launch,
    add_observed,
    add_paths,
    add_running,
    add_scheduler,
    add_talking,
    launch_of,
    linked_of,
    observed_of,
    paths_of,
    plugins_of,
    pool_of,
    positive,
    settings_of,
)
from archlint.cli.parser import Parser
from archlint.cli.said import STATISTICS, remarks, written
from archlint.cli.watch import Watch
from archlint.engine.answers import Answer
from archlint.engine.keeper import Keeper
from archlint.engine.pipeline import NothingToDo, Request, check
from archlint.finding import Severity
from archlint.report.groups import GROUPS
from archlint.report.model import Report
from archlint.report.paths import folder_in_repository

if TYPE_CHECKING:
    from archlint.systems.model import System


def parser() -> argparse.ArgumentParser:
    parser = Parser("check", "Find what is wrong between the nodes of a ROS 2 system and inside their callbacks.")
    add_paths(parser)
    rules = parser.add_argument_group(
        "rules", "CODES: rule codes, prefixes such as SRV, names or ALL, separated by commas; repeatable"
    )
    rules.add_argument("--select", metavar="CODES", action="append", help="run these rules only")
    rules.add_argument("--extend-select", metavar="CODES", action="append", help="run these rules too")
    rules.add_argument("--ignore", metavar="CODES", action="append", help="do not run these rules")
    output = parser.add_argument_group("output")
    formats = ", ".join(reports.FORMATS)
    output.add_argument(
        "--format", metavar="F", choices=list(reports.FORMATS), default="text", help=f"one of {formats}"
    )
    output.add_argument("-o", metavar="FILE", dest="file", help="write the findings to FILE")
    output.add_argument(
        "--output",
        metavar="FORMAT=FILE",
        action="append",
        type=_output,
        default=[],
        help="write them to FILE in this format too; repeatable",
    )
    output.add_argument(
        "--statistics", action="store_true", help="count the findings of each rule instead of showing them"
    )
    output.add_argument(
        "--group-by", metavar="WHAT", choices=list(GROUPS), help=f"group the findings by {', '.join(GROUPS)}"
    )
    output.add_argument("--max", metavar="N", type=positive, help="show the N most important findings only")
    mending = parser.add_argument_group("fixes")
    mending.add_argument("--fix", action="store_true", help="apply safe fixes")
    mending.add_argument("--unsafe-fixes", action="store_true", help="with --fix or --diff: unsafe fixes too")
    mending.add_argument("--diff", action="store_true", help="show what fixes would change, and write nothing")
    levels = parser.add_argument_group("exit status")
    levels.add_argument(
        "--severity",
        metavar="LEVEL",
        choices=[level.label for level in Severity],
        default="warning",
        help="the lowest severity that fails the run: info, warning (default) or error",
    )
    levels.add_argument("--exit-zero", action="store_true", help="findings do not fail the run")
    add_baseline(parser)
    suppressing = parser.add_argument_group("suppressions")
    suppressing.add_argument("--add-ignores", action="store_true", help="suppress what is found where it stands")
    suppressing.add_argument("--reason", metavar="TEXT", default="", help="with --add-ignores: why, for each comment")
    add_launch(parser)
    add_observed(parser)
    add_facts(parser)
    add_configuration(parser, with_plugins=True)
    add_running(parser)
    add_scheduler(parser)
    add_talking(parser)
    return parser


def _output(text: str) -> tuple[reports.FormatName, str]:
    name, _, file = text.partition("=")
    format = next((format for format in reports.FORMATS if format == name), None)
    if format is None or not file:
        raise argparse.ArgumentTypeError(f"must be FORMAT=FILE with a format of {', '.join(reports.FORMATS)}")
    return format, file


def run(arguments: argparse.Namespace) -> int:
    _refuse_combinations(arguments)
    launch, launch_arguments = launch_of(arguments)
    linked = linked_of(arguments)
    paths = paths_of(arguments)
    settings = settings_of(arguments, paths[0], plugins_of(arguments))
    baseline = baseline_of(arguments, settings)
    request = Request(
        paths if linked is None else tuple(arguments.facts),
        settings,
        cached=not arguments.no_cache and linked is None,
        jobs=arguments.jobs,
        launch=launch,
        launch_arguments=launch_arguments,
        observed=observed_of(arguments),
        fixes=_asks_for_fixes(arguments),
        keeper=None if settings.plugins else _keeper(arguments, baseline),  # plugins may depend on anything
        baseline=None if baseline is None else baseline.held,
        occurrences=baseline is not None and baseline.writes,
        linked=linked,
    )
    watch = Watch(sys.stderr, arguments.quiet, arguments.verbose)
    shown: list[System] = []
    try:
        with pool_of(arguments) as pool, watch as monitor:
            running = replace(request, monitor=monitor, pool=pool)
            before, notices = findings_before(running, arguments.new_only)
            request = replace(request, before=before)
            report = check(replace(running, before=before), shown)
            report = replace(report, notices=[*notices, *report.notices])
    except NothingToDo as error:
        raise UsageError(str(error)) from None
    failing = Severity.parse(arguments.severity)
    if arguments.diff:
        return _show_difference(report, arguments)
    report, done = _after_changes(report, request, baseline, watch, arguments)
    if arguments.fix or arguments.add_ignores:
        shown = []  # the files are others now
    folder = folder_in_repository(Path.cwd(), os.environ)
    text = written(replace(report, failing=failing, folder=folder), arguments)
    warnings, notes = ("", "") if arguments.quiet else remarks(report, done, request, shown, arguments)
    answer = Answer(text, warnings, notes, exit_status(report, failing, arguments.exit_zero))
    status = console.give(answer)
    watch.note_costs()
    if request.keeper is not None:
        request.keeper.keep(answer)
    return status


def _after_changes(
    report: Report, request: Request, baseline: UsedBaseline | None, watch: Watch, arguments: argparse.Namespace
) -> tuple[Report, list[str]]:
    """Change the files that the command is to change; returns the report on what is left, and what was done."""
    done: list[str] = []
    if arguments.fix:
        from archlint.cli.fix import mend  # with what takes files apart, which most checks do without

        with watch as monitor:
            fixed = mend(replace(request, monitor=monitor), report, arguments.unsafe_fixes)
        report = fixed.report
        done += [f"Fixed {fixed.count} finding{'s' if fixed.count > 1 else ''}."] if fixed.count else []
    if arguments.add_ignores:
        from archlint.cli.ignores import ignore  # as above

        with watch as monitor:
            ignored = ignore(replace(request, monitor=monitor), arguments.reason)
        report = ignored.report
        done.append(ignored.said)
    if baseline is not None and (baseline.writes or baseline.prunes):
        report, said = baseline.written(report)
        done.append(said)
    return report, done


def _refuse_combinations(arguments: argparse.Namespace) -> None:
    if arguments.statistics and arguments.format not in STATISTICS:
        raise UsageError(f"--statistics is written as text, concise or json, not as {arguments.format}")
    if arguments.group_by is not None or arguments.max is not None:
        option = "--max" if arguments.group_by is None else "--group-by"
        if not reports.FORMATS[arguments.format].arranged:
            raise UsageError(f"{option} is for text and concise: {arguments.format} has all findings, in its own order")
        if arguments.statistics:
            raise UsageError(f"{option} does not go together with --statistics, which shows no findings")
    if arguments.unsafe_fixes and not (arguments.fix or arguments.diff):
        raise UsageError("--unsafe-fixes needs --fix or --diff")
    if arguments.facts and (arguments.fix or arguments.diff):
        raise UsageError("--fix and --diff need the sources: check them without --facts")
    if arguments.diff and (arguments.write_baseline or arguments.prune_baseline):
        raise UsageError("--diff writes nothing: leave it out to write the baseline")
    if arguments.new_only and (arguments.write_baseline or arguments.prune_baseline):
        raise UsageError("--new-only looks at a part of the findings: leave it out to write the baseline")
    if arguments.add_ignores and (arguments.diff or arguments.facts or arguments.write_baseline):
        other = "--diff" if arguments.diff else "--facts" if arguments.facts else "--write-baseline"
        raise UsageError(f"--add-ignores does not go together with {other}")
    if arguments.reason and not (arguments.add_ignores and arguments.reason.isprintable()):
        raise UsageError("--reason is one line, and needs --add-ignores")
    if arguments.new_only and arguments.facts:
        raise UsageError("--new-only needs the sources: check them without --facts")


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


def _asks_for_fixes(arguments: argparse.Namespace) -> bool:
    formats = (arguments.format, *(format for format, _ in arguments.output))
    shows_them = arguments.statistics or any(reports.FORMATS[format].with_fixes for format in formats)
    return bool(arguments.fix or arguments.diff or shows_them)


def _show_difference(report: Report, arguments: argparse.Namespace) -> int:
    """Print the diff; exit status 1 where there is one, for a run in CI."""
    from archlint.cli.fix import difference  # as above

    text = difference(report, arguments.unsafe_fixes)
    console.write(text, arguments.file)
    return exits.FINDINGS if text and not arguments.exit_zero else exits.CLEAN


def exit_status(report: Report, failing: Severity, exit_zero: bool) -> int:
    if any(finding.code == "LNT003" for finding in report.findings):
        return exits.FAILED
    if any(finding.severity >= failing for finding in report.findings):
        return exits.CLEAN if exit_zero else exits.FINDINGS
    return exits.CLEAN

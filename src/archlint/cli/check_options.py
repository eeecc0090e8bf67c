"""The options of ``archlint check``, and which of them do not go together."""

from __future__ import annotations

import argparse

from archlint import report as reports
from archlint.cli.baseline import add_baseline
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
    positive,
)
from archlint.cli.parser import Parser
from archlint.cli.said import STATISTICS
from archlint.finding import Severity
from archlint.report.groups import GROUPS


def parser() -> Parser:
    """The options of ``archlint check``."""
    parser = Parser("check", "Find what is wrong between the nodes of a ROS 2 system and inside their callbacks.")
    parser.usage = f"{parser.prog} [OPTIONS] [PATH ...]"
    add_paths(parser)
    add_launch(parser)
    add_observed(parser)
    add_facts(parser)
    rules = parser.add_argument_group(
        "rules", "CODES: rule codes, prefixes such as SRV, names or ALL, separated by commas; repeatable"
    )
    rules.add_argument("--select", metavar="CODES", action="append", help="run these rules only")
    rules.add_argument("--extend-select", metavar="CODES", action="append", help="run these rules too")
    rules.add_argument("--ignore", metavar="CODES", action="append", help="do not run these rules")
    _add_output(parser)
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
    add_configuration(parser, with_plugins=True)
    add_running(parser)
    add_scheduler(parser)
    add_talking(parser)
    return parser


def _add_output(parser: argparse.ArgumentParser) -> None:
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
        "--group-by", metavar="WHAT", choices=list(GROUPS), help="group the findings by rule, package, node or file"
    )
    output.add_argument("--max", metavar="N", type=positive, help="show the N most important findings only")
    output.add_argument(
        "--all-files",
        action="store_true",
        help="show findings in files and functions that nothing runs, and in packages that others maintain, too",
    )
    output.add_argument("--watch", action="store_true", help="check again whenever a file has changed; Ctrl-C ends")


def _output(text: str) -> tuple[reports.FormatName, str]:
    name, _, file = text.partition("=")
    format = next((format for format in reports.FORMATS if format == name), None)
    if format is None or not file:
        raise argparse.ArgumentTypeError(f"must be FORMAT=FILE with a format of {', '.join(reports.FORMATS)}")
    return format, file


def refuse_combinations(arguments: argparse.Namespace) -> None:
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


def asks_for_fixes(arguments: argparse.Namespace) -> bool:
    formats = (arguments.format, *(format for format, _ in arguments.output))
    shows_them = arguments.statistics or any(reports.FORMATS[format].with_fixes for format in formats)
    return bool(arguments.fix or arguments.diff or shows_them)

"""What ``archlint check`` says: the findings or their statistics, and what is to be said beside them."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint import report as reports
from archlint.cli import console
from archlint.engine.pipeline import NothingToDo, Request, graph
from archlint.records import dataclass
from archlint.report import statistics
from archlint.report.fix_marks import fix_line
from archlint.report.groups import most_important
from archlint.report.model import Report, summary_line, unreached_line, unused_line, vendored_line
from archlint.report.starting_points import starting_points

if TYPE_CHECKING:
    import argparse

    from archlint.cli.progress import Progress
    from archlint.engine.answers import Answer
    from archlint.finding import Finding
    from archlint.systems.model import System

STATISTICS: Mapping[str, Callable[[Iterable[Finding]], str]] = {
    "text": statistics.as_text,
    "concise": statistics.as_text,
    "json": statistics.as_json,
}
"""The formats of ``--statistics``."""


@dataclass(frozen=True)
class Checked:
    """What a run found, what is to be said of it, what was asked, and how it went."""

    report: Report
    answer: Answer
    request: Request
    progress: Progress


def written(report: Report, arguments: argparse.Namespace) -> str:
    """Write the findings to files; returns what is for standard output."""
    to_terminal = arguments.file in (None, "-")
    color = to_terminal and console.wants_color(arguments.color, sys.stdout)
    if arguments.statistics:
        text = STATISTICS[arguments.format](report.findings)
    else:
        columns = console.columns(sys.stdout) if to_terminal else None
        text = reports.render(arguments.format, _arranged(report, arguments), color, columns)
    if not to_terminal:
        console.write(text, arguments.file)
    for format, file in arguments.output:
        console.write(reports.render(format, report), file)
    return text if to_terminal else ""


def _arranged(report: Report, arguments: argparse.Namespace) -> Report:
    """The findings as ``--max`` and ``--group-by`` want them shown."""
    few = report.findings if arguments.max is None else most_important(report, arguments.max)
    return replace(report, findings=few, grouping=arguments.group_by)


def _left_out(report: Report, arguments: argparse.Namespace) -> str:
    every = len(report.findings)
    if arguments.max is None or arguments.max >= every:
        return ""
    return f"Shown: the {arguments.max} most important of {every} findings; {every - arguments.max} more without --max."


def remarks(
    report: Report, done: Sequence[str], request: Request, shown: Sequence[System], arguments: argparse.Namespace
) -> tuple[str, str]:
    """What is to be said beside the findings: what was ``done`` and warnings, and notes after them."""
    warnings = [*done, *(f"archlint: warning: {notice}" for notice in report.notices)]
    notes = [*report.remarks]
    if arguments.statistics:
        notes.append(_shape(request, shown))
    elif reports.FORMATS[arguments.format].arranged:
        notes += [_left_out(report, arguments), starting_points(report)]
    if reports.FORMATS[arguments.format].for_people or arguments.file is not None:
        notes += [
            summary_line(report.summary),
            unused_line(report.summary),
            unreached_line(report.summary),
            vendored_line(report.summary),
            fix_line(report.findings),
        ]
    if arguments.verbose:
        settings = request.settings
        cache = settings.cache_folder if request.cached else "none"
        notes.append(f"configuration: {settings.file or 'none'}; cache: {cache}")
        notes.append(f"took {report.summary.elapsed_s:.2f} s")
    said = "".join(map(console.noted, warnings)), "".join(map(console.noted, notes))
    return _apart(*said) if _ends_in_a_frame(report, arguments) else said


def _ends_in_a_frame(report: Report, arguments: argparse.Namespace) -> bool:
    """Whether the line before the remarks is one of a finding in full, on the terminal."""
    in_full = arguments.format == "text" and not arguments.statistics
    return bool(report.findings) and in_full and arguments.file in (None, "-") and sys.stdout.isatty()


def _apart(warnings: str, notes: str) -> tuple[str, str]:
    """The remarks after an empty line."""
    return (f"\n{warnings}", notes) if warnings else (warnings, f"\n{notes}")


def _shape(request: Request, shown: Sequence[System]) -> str:
    """The architecture pattern of what was checked, with its figures; ``shown`` are its systems, if the check had to
    make them."""
    from archlint.engine.loading import combined
    from archlint.systems import pattern  # with the systems, which a known result does without

    try:
        return "\n".join(pattern.words(pattern.figures(combined(shown) if shown else graph(request))))
    except NothingToDo:  # only manifests or interfaces, say
        return ""

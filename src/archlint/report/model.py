"""What a run has to report: findings in order, counts, and a way to look at the source."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import field, replace
from typing import Literal

from archlint.counted import counted
from archlint.finding import Finding, Severity
from archlint.records import dataclass
from archlint.report.occurrence import Occurrence

GroupName = Literal["rule", "package", "node", "file"]
"""What findings are grouped by."""
SourceLine = Callable[[str, int], "str | None"]
"""The text of a line of a file, as a :class:`~archlint.finding.Place` names them; None if there is none."""


@dataclass(frozen=True)
class Summary:
    """The figures of a run; ``unresolved`` counts endpoints whose name is not known, times are in
    seconds."""

    files: int
    nodes: int
    errors: int
    warnings: int
    infos: int
    suppressed: int
    unresolved: int
    elapsed_s: float
    baselined: int = 0
    """Findings that the baseline holds back."""
    older: int = 0
    """Findings that the revision of ``--new-only`` has, too."""
    unused: int = 0
    """Findings that are not shown, for they are in files that nothing runs."""
    unused_files: int = 0
    """How many files these are in."""
    vendored: int = 0
    """Findings that are not shown, for they are in packages that others maintain."""
    unreached: int = 0
    """Findings that are not shown, for they are about lines to which no program comes."""

    @property
    def findings(self) -> int:
        return self.errors + self.warnings + self.infos


@dataclass(frozen=True)
class Report:
    """``findings`` are in the order of ``Finding.sort_key``; ``notices`` is what to say beside them.

    ``failing`` is the severity from which on a finding fails the run; ``folder`` the path of the working
    directory in its repository, for formats that a service reads (``.`` for the repository's root).
    """

    findings: Sequence[Finding]
    summary: Summary
    source_line: SourceLine
    notices: Sequence[str] = ()
    failing: Severity = Severity.WARNING
    folder: str = "."
    remarks: Sequence[str] = ()
    """What to say beside them that is no warning."""
    occurrences: Sequence[Occurrence] = ()
    """All that the rules have reported, known or not, where a request asks for it."""
    idle: Sequence[int] = ()
    """The lines of the baseline that no finding matches any more."""
    launched: Collection[str] = ()
    """The files of findings in which there is code of nodes that launch files start."""
    inside: Collection[str] = ()
    """The real paths of what may be changed: the repository, and what was asked for; all where there are none."""
    packages: Mapping[str, str] = field(default_factory=dict)
    """The packages of files that lie in one."""
    grouping: GroupName | None = None
    """What the findings are grouped by, in formats for people."""


@dataclass(frozen=True)
class Judged:
    """What is kept of a report for an equal run: all but the source, and ``elapsed_s`` of another run."""

    findings: list[Finding]
    summary: Summary
    notices: list[str]
    remarks: list[str] = field(default_factory=list)
    mended: bool = False
    """Whether the findings have their fixes, beside the sites that these are made at."""
    occurrences: list[Occurrence] = field(default_factory=list)
    idle: list[int] = field(default_factory=list)
    launched: list[str] = field(default_factory=list)

    def unmended(self) -> Judged:
        """The same without fixes."""
        return replace(self, findings=[replace(finding, fix=None) for finding in self.findings], mended=False)


def summarise(
    findings: Sequence[Finding],
    *,
    files: int,
    nodes: int,
    suppressed: int,
    unresolved: int,
    elapsed_s: float,
    baselined: int = 0,
    older: int = 0,
    unused: int = 0,
    unused_files: int = 0,
    vendored: int = 0,
    unreached: int = 0,
) -> Summary:
    count = Counter(finding.severity for finding in findings)
    return Summary(
        files=files,
        nodes=nodes,
        errors=count[Severity.ERROR],
        warnings=count[Severity.WARNING],
        infos=count[Severity.INFO],
        suppressed=suppressed,
        unresolved=unresolved,
        elapsed_s=elapsed_s,
        baselined=baselined,
        older=older,
        unused=unused,
        unused_files=unused_files,
        vendored=vendored,
        unreached=unreached,
    )


def recounted(summary: Summary, findings: Sequence[Finding]) -> Summary:
    """The figures of a run that reports these findings instead."""
    count = Counter(finding.severity for finding in findings)
    errors, warnings, infos = (count[level] for level in (Severity.ERROR, Severity.WARNING, Severity.INFO))
    return replace(summary, errors=errors, warnings=warnings, infos=infos)


def summary_line(summary: Summary) -> str:
    """The run in one sentence."""
    where = f"{counted(summary.files, 'file')} with {counted(summary.nodes, 'node')}"
    notes = [
        f"{summary.suppressed} suppressed" if summary.suppressed else "",
        f"{summary.baselined} held by the baseline" if summary.baselined else "",
        f"{summary.older} not new" if summary.older else "",
        f"{summary.unresolved} unresolved" if summary.unresolved else "",
    ]
    tail = "".join(f"; {note}" for note in notes if note)
    if not summary.findings:
        return f"No findings in {where}{tail}."
    levels = [(summary.errors, "error"), (summary.warnings, "warning"), (summary.infos, "info")]
    counts = ", ".join(counted(number, word) for number, word in levels if number)
    return f"Found {counts} in {where}{tail}."


def vendored_line(summary: Summary) -> str:
    """What is not shown of packages that others maintain, in one sentence; empty where all is shown."""
    if not summary.vendored:
        return ""
    if summary.vendored == 1:
        return "1 finding in a package that others maintain is not shown; --all-files shows it."
    return f"{summary.vendored} findings in packages that others maintain are not shown; --all-files shows them."


def unreached_line(summary: Summary) -> str:
    """What is not shown of lines to which no program comes, in one sentence; empty where all is shown."""
    if not summary.unreached:
        return ""
    if summary.unreached == 1:
        return "1 finding in a function or class that nothing calls is not shown; --all-files shows it."
    return (
        f"{summary.unreached} findings in functions and classes that nothing calls are not shown; "
        "--all-files shows them."
    )


def unused_line(summary: Summary) -> str:
    """What is not shown of files that nothing runs, in one sentence; empty where all is shown."""
    if not summary.unused:
        return ""
    where = counted(summary.unused_files, "file")
    if summary.unused == 1:
        return f"1 finding in {where} that nothing runs is not shown; --all-files shows it."
    return f"{summary.unused} findings in {where} that nothing runs are not shown; --all-files shows them."

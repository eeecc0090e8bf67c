"""How a rule makes one finding of several with one cause.

A rule that finds the same mistake at several places yields a finding for each, all with the same ``group``.  What
the user suppresses or ignores at one place leaves the others; the rest becomes one finding, with one fix.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.edit_sites import Sites
from archlint.finding import Finding, Related
from archlint.records import dataclass

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex


@dataclass(frozen=True)
class Fold:
    """What makes one finding of several of a rule, which come in the order of their places."""

    code: str
    function: Callable[[Sequence[Finding]], Finding]
    across_systems: bool
    """Whether it also folds what several launch files show."""
    across_severities: bool = False
    """Whether it also folds what weighs more with what weighs less."""
    common: int | None = None
    """How many of the first parts of a group findings have in common; the others tell the fold more of each.  All of
    them, if None."""
    across_workspaces: bool = False
    """Whether it also folds what several workspaces show that stand side by side."""
    rows: Callable[[Sequence[Finding]], Iterable[Sequence[Finding]]] | None = None
    """Which findings of a group become one, where that depends on what else there is; all of them, if None."""

    def __call__(self, findings: Sequence[Finding]) -> Finding:
        return self.function(findings)

    def each(self, group: Sequence[Finding]) -> Iterable[Finding]:
        """What the findings of a group become."""
        for row in (group,) if self.rows is None else self.rows(group):
            yield row[0] if len(row) == 1 else self(row)


def folds(
    code: str,
    *,
    across_systems: bool = False,
    across_severities: bool = False,
    common: int | None = None,
    across_workspaces: bool = False,
    rows: Callable[[Sequence[Finding]], Iterable[Sequence[Finding]]] | None = None,
) -> Callable[[Callable[[Sequence[Finding]], Finding]], Fold]:
    """Make the decorated function the fold of the rule with this code."""
    return lambda function: Fold(code, function, across_systems, across_severities, common, across_workspaces, rows)


def with_the_same_cause(
    findings: Sequence[Finding], cause: Callable[[Finding], tuple[str, ...]]
) -> Iterable[Sequence[Finding]]:
    """The findings of several files by their cause, if that is in more than one file; by their file, else."""
    files: dict[tuple[str, ...], set[str]] = {}
    for finding in findings:
        files.setdefault(cause(finding), set()).add(finding.place.file)
    rows: dict[tuple[bool, tuple[str, ...]], list[Finding]] = {}
    for finding in findings:
        common = len(files[cause(finding)]) > 1
        rows.setdefault((common, cause(finding) if common else (finding.place.file,)), []).append(finding)
    return rows.values()


def all_sites(findings: Sequence[Finding]) -> Sites | None:
    """What a finding that stands for several would have edited: what each of them would."""
    sites = [finding.sites for finding in findings if finding.sites is not None]
    return sum(sites, Sites()) if sites else None


def with_others(findings: Sequence[Finding], another: str, more: str, rest: str = "", beside: str = "") -> Finding:
    """The first of several findings, which stands for all: its message says how many others there are, and where these
    are is related.

    ``another`` and ``more`` are subject and verb for one other finding and for several, "another call is" and "more
    calls are"; ``rest`` ends the sentence.  ``beside`` is said at the place of each other, by default its own message.
    """
    first, others = with_places(findings, beside), len(findings) - 1
    words = another if others == 1 else f"{others} {more}"
    words += f" {rest}" if rest else ""
    return replace(first, message=f"{first.message}; {words}", sites=all_sites(findings))


def with_places(findings: Sequence[Finding], beside: str = "") -> Finding:
    """The first of several findings, with the places of the others related; ``beside`` is said at each of these, by
    default its own message."""
    first, *others = findings
    return replace(
        first, related=(*first.related, *(Related(other.place, beside or other.message) for other in others))
    )


def with_other_places(findings: Sequence[Finding], beside: str) -> Finding:
    """As :func:`with_places`, each place but that of the first once."""
    first, *others = findings
    places = dict.fromkeys(other.place for other in others if other.place != first.place)
    return replace(first, related=(*first.related, *(Related(place, beside) for place in places)))


def of_one_function(findings: Sequence[Finding], noun: str, beside: str) -> Finding:
    """The first finding of a function for all that do the same in it; ``beside`` is said at the others."""
    inside = f"in {findings[0].group[1]}()"
    return with_others(findings, f"another {noun} {inside} does", f"more {noun}s {inside} do", "the same", beside)


def of_one_class(findings: Sequence[Finding], noun: str, beside: str) -> Finding:
    """The first finding of a class, or of a file outside of any, for all that do the same in it.  ``group`` begins with
    the file and that class, ``identity`` with the function."""
    owner, functions = findings[0].group[1], {finding.identity[0] for finding in findings}
    inside = f"in {functions.pop()}()" if len(functions) == 1 else f"in the class {owner}" if owner else "in this file"
    return with_others(findings, f"another {noun} {inside} does", f"more {noun}s {inside} do", "the same", beside)


def of_one_package(findings: Sequence[Finding], noun: str, beside: str) -> Finding:
    """The first finding of a package, or of a file in none, for all that do the same in it: ``group`` begins with what
    :func:`package_around` gives."""
    kind, name, *_ = findings[0].group
    inside = f"of the package '{name}'" if kind == _PACKAGE else "in this file"
    return with_others(findings, f"another {noun} {inside} does", f"more {noun}s {inside} do", "the same", beside)


_PACKAGE = "package"


def package_around(workspace: WorkspaceIndex | None, file: str) -> tuple[str, str]:
    """What the findings of a package have in common, or those of a file in none."""
    package = None if workspace is None else workspace.package_of(file)
    return ("file", file) if package is None else (_PACKAGE, package)


def class_around(function: str) -> str:
    """The class of a method, by its qualified name; empty for a function outside of any."""
    return function.rpartition(".")[0]

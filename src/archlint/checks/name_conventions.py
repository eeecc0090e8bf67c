"""What NME001 says once of several nodes of a workspace."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace

from archlint.checks.folding import all_sites
from archlint.checks.name_evidence import Home
from archlint.finding import Finding, Related

CONVENTION = "convention"
"""The key of the findings that become one for the workspace."""
_RELATED = 10
"""How many places the finding of a workspace relates: its message counts all."""


def one_of_several_nodes(findings: Sequence[Finding], packages: Sequence[str], other: str = "") -> Finding:
    """The finding for the absolute names of several nodes: at the first, with the first name of others related;
    ``packages`` are those of the findings, empty where there is none, ``other`` is a relative name beside them."""
    first, severity = findings[0], max(finding.severity for finding in findings)
    by_home: dict[Home, list[Finding]] = {}
    for diagnostic in findings:
        by_home.setdefault(home_of(diagnostic), []).append(diagnostic)
    nodes = max(len({diagnostic.node or home_of(diagnostic) for diagnostic in findings}), _classes(by_home))
    names = sorted({diagnostic.identity[-1] for diagnostic in findings})
    subject = f"{len(names)} absolute names" if len(names) > 1 else f"the absolute name '{names[0]}'"
    whose = f"{nodes} nodes{_in(packages)} fix" if nodes > 1 else f"the code{_in(packages)} fixes"
    effect = f": no namespace applies to {'any of them' if len(names) > 1 else 'it'}"
    if other:
        effect = f", beside relative ones such as '{other}': in a namespace, only those move"
    return replace(
        first,
        severity=severity,
        message=f"{whose} {subject}{effect}",
        help=_help(findings),
        related=(*first.related, *(_related(home, rows) for home, rows in list(by_home.items())[1 : _RELATED + 1])),
        sites=all_sites(findings),
        identity=("absolute names",),  # neither a count nor the names, so that it stays the same finding
    )


def _classes(homes: Iterable[Home]) -> int:
    """How many classes there are: several may give their nodes one name."""
    return sum(bool(class_name) for _, class_name in homes)


def home_of(diagnostic: Finding) -> Home:
    """The file and the class of a finding."""
    return diagnostic.place.file, diagnostic.identity[0]


def _in(packages: Sequence[str]) -> str:
    known = sorted(set(packages) - {""})
    if not known:
        return ""
    return f" of package '{known[0]}'" if len(known) == 1 else f" in {len(known)} packages"


def _help(findings: Sequence[Finding]) -> str:
    fixed = any(diagnostic.place.file.endswith(".py") for diagnostic in findings)
    parameters = ", or make parameters of them with `archlint check --fix --unsafe-fixes`" if fixed else ""
    return (
        f"remove the leading '/' of each, in all these nodes together{parameters}; if there will never be a second "
        'robot of its kind, turn the rule off: `ignore = ["NME001"]`'
    )


def _related(home: Home, findings: Sequence[Finding]) -> Related:
    """What is said at the first name of a further class."""
    _, word, name = findings[0].identity
    count = len({diagnostic.identity[1:] for diagnostic in findings})
    subject = home[1] or "this file"
    more = f" and {count - 1} more" if count > 1 else ""
    return Related(findings[0].place, f"{subject} fixes the {word} '{name}'{more}")


__all__ = ["CONVENTION", "home_of", "one_of_several_nodes"]

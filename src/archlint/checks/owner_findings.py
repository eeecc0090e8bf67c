"""The finding for a name that several nodes own."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import astuple, replace
from typing import TYPE_CHECKING

from archlint.analysis.owners import some_coexist
from archlint.checks.registry import finding
from archlint.finding import Finding, Related, Severity

if TYPE_CHECKING:
    from archlint.systems.model import System
    from archlint.systems.nodes import Endpoint


def finding_for_owners(
    code: str, system: System, owners: list[Endpoint], message: str, does: str, help: str
) -> Finding:
    """The finding at the last owner; for information only where nothing is seen to start any two of them."""
    last, others = owners[-1], owners[:-1]
    proven = some_coexist(system, owners)
    diagnostic = finding(
        code,
        last.place,
        message if proven else f"{message}, if they run together: no launch file here starts both by default",
        help=help,
        related=[Related(other.place, f"{other.node.name} {does}") for other in others],
        node=last.node.name,
        identity=(last.kind, last.name or "", *_names(owners)),
    )
    if code == "OWN001":
        diagnostic = replace(diagnostic, group=_cause(last))
    return diagnostic if proven else replace(diagnostic, severity=Severity.INFO)


def _cause(last: Endpoint) -> tuple[str, ...]:
    """What findings have in common that one change mends: the node that was added last."""
    node = last.node.blueprint
    return (last.place.file, "") if node is None else (*map(str, astuple(node.place)), node.class_name)


def all_of(owners: Iterable[Endpoint]) -> str:
    names = _names(owners)
    both = "both" if len(names) == 2 else "all"
    return f"{', '.join(names[:-1])} and {names[-1]} {both}"


def _names(owners: Iterable[Endpoint]) -> list[str]:
    return sorted({endpoint.node.name or "" for endpoint in owners})

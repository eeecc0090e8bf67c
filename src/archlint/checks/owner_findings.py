"""The finding for a name that several nodes own."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import astuple, replace
from typing import TYPE_CHECKING

from archlint.checks.registry import finding
from archlint.finding import Finding, Related

if TYPE_CHECKING:
    from archlint.systems.nodes import Endpoint


def finding_for_owners(code: str, owners: list[Endpoint], message: str, does: str, help: str) -> Finding:
    """The finding at the last owner."""
    last, others = owners[-1], owners[:-1]
    diagnostic = finding(
        code,
        last.place,
        message,
        help=help,
        related=[Related(other.place, f"{other.node.shown} {does}") for other in others],
        node=last.node.name,
        identity=(last.kind, last.name or "", *_names(owners)),
    )
    group = _cause(last) if code == "OWN001" else tuple(_names(owners))
    return replace(diagnostic, group=group)


def _cause(last: Endpoint) -> tuple[str, ...]:
    """What findings have in common that one change mends: the node that was added last."""
    node = last.node.blueprint
    return (last.place.file, "") if node is None else (*map(str, astuple(node.place)), node.class_name)


def all_of(owners: Iterable[Endpoint]) -> str:
    names = _names(owners)
    both = "both" if len(names) == 2 else "all"
    return f"{', '.join(names[:-1])} and {names[-1]} {both}"


def _names(owners: Iterable[Endpoint]) -> list[str]:
    return sorted({endpoint.node.shown for endpoint in owners})

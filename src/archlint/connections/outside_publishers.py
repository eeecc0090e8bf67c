"""Subscriptions to what a flight controller publishes, which runs outside of every workspace, with a profile that its
own one does not serve."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING

from archlint.analysis.aside import is_disused
from archlint.analysis.coexistence import certain
from archlint.analysis.kept import once
from archlint.model import EntityKind
from archlint.records import dataclass
from archlint.ros.flight_controllers import publisher_of
from archlint.ros.qos import Verdict, compatible

if TYPE_CHECKING:
    from archlint.systems.model import System, WorkspaceIndex
    from archlint.systems.nodes import Endpoint


@dataclass(frozen=True)
class FromOutside:
    """A subscription that never gets what ``publisher`` sends, and the policies that say so."""

    request: Endpoint
    publisher: str
    verdicts: tuple[Verdict, ...]


def undelivered_from_outside(system: System) -> Iterator[FromOutside]:
    """Such subscriptions of a system, where no node of the workspace publishes the topic, or might."""
    workspace = system.workspace
    if workspace is None:
        return
    for node in system.nodes:
        if node.external or node.test or not node.is_node:
            continue
        for end in node.of_kind(EntityKind.SUBSCRIBER):
            name, type_name, qos = end.name, end.type, end.qos
            if name is None or type_name is None or qos is None or not certain(end):
                continue
            publisher = publisher_of(name, type_name)
            if publisher is None or qos.overridable or qos.parameter is not None:
                continue
            errors = tuple(verdict for verdict in compatible(publisher.qos, qos) if verdict.level == "error")
            if errors and not _is_published(workspace, name, type_name) and not is_disused(workspace, end.place.file):
                yield FromOutside(end, publisher.name, errors)


def _is_published(workspace: WorkspaceIndex, name: str, type_name: str) -> bool:
    """Whether a node of the workspace may publish a topic: one of that name, or one whose name is not known."""
    return any(other in (name, None) for other in _published(workspace).get(type_name, ()))


@once
def _published(workspace: WorkspaceIndex) -> Mapping[str, Sequence[str | None]]:
    """The names that nodes of the workspace publish, by their types."""
    names: dict[str, dict[str | None, None]] = {}
    for system in workspace.systems:
        for node in system.nodes:
            for end in node.of_kind(EntityKind.PUBLISHER):
                if end.type is not None:
                    names.setdefault(end.type, {})[end.name] = None
    return {kind: list(rows) for kind, rows in names.items()}


__all__ = ["FromOutside", "undelivered_from_outside"]

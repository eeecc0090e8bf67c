"""Which findings belong to what is drawn: those whose badge other pictures have there, those that name a node, and
those about what a place creates.  A picture has a badge once; here each thing has all that is about it.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Any

from archlint.render.json import shown_file

if TYPE_CHECKING:
    from archlint.finding import Finding
    from archlint.place import Place
    from archlint.render.page.model import PageSystem
    from archlint.systems.nodes import Endpoint, Node


class FindingIndex:
    """The findings that hold in one system, by their numbers in the list of all."""

    def __init__(self, findings: Sequence[Finding], shown: PageSystem) -> None:
        self._here = [number for number, finding in enumerate(findings) if _holds(finding, shown)]
        self.here = [findings[number] for number in self._here]
        self._of_node: dict[str, list[int]] = {}
        self._of_line: dict[tuple[str, int], list[int]] = {}
        self._shown: set[int] = set()
        self._number_of = {id(finding): number for number, finding in enumerate(findings)}
        for number in self._here:
            finding = findings[number]
            if finding.node is not None:
                self._of_node.setdefault(finding.node, []).append(number)
            for place in (finding.place, *(related.place for related in finding.related)):
                self._of_line.setdefault((place.file, place.line), []).append(number)

    def of_node(self, node: Node) -> list[int]:
        """Those that name a node, and those about the line of something that it creates."""
        places = [creation.place for blueprint in node.blueprints for creation in blueprint.creations]
        places += [blueprint.place for blueprint in node.blueprints]
        places += [parameter.place for parameter in node.parameters]
        if node.launch_place is not None:
            places.append(node.launch_place)
        named = self._of_node.get(node.name, []) if node.name is not None else []
        return self._noted([*named, *(number for place in places for number in self._at(place))])

    def of_end(self, endpoint: Endpoint) -> list[int]:
        """Those about the line that creates an end."""
        return self._noted(self._at(endpoint.place))

    def of_badges(self, findings: Iterable[Finding]) -> list[int]:
        """Those whose badge a picture has at one thing."""
        return self._noted(self._number_of[id(finding)] for finding in findings)

    def elsewhere(self) -> list[int]:
        """Those that belong to nothing that was asked for."""
        return [number for number in self._here if number not in self._shown]

    def _at(self, place: Place) -> list[int]:
        return self._of_line.get((place.file, place.line), [])

    def _noted(self, numbers: Iterable[int]) -> list[int]:
        noted = sorted(set(numbers))
        self._shown.update(noted)
        return noted


def _holds(finding: Finding, shown: PageSystem) -> bool:
    """Whether a finding says something about a system: of all code, or of this launch file with these arguments."""
    if shown.system.name is not None and finding.system not in (None, shown.system.name):
        return False
    if finding.condition is None or not shown.arguments:
        return True
    held = {f"{name}:={value}" for name, value in shown.arguments.items()}
    return held.issuperset(finding.condition.split(" "))


def finding_data(finding: Finding) -> dict[str, Any]:
    """As in ``check --format json``, without its fix and where it ends."""
    related = [{**_place_data(related.place), "message": related.message} for related in finding.related]
    return {
        "code": finding.code,
        "name": finding.name,
        "severity": finding.severity.label,
        "message": finding.message,
        **({"help": finding.help} if finding.help else {}),
        **_place_data(finding.place),
        **({"system": finding.system} if finding.system else {}),
        **({"related": related} if related else {}),
    }


def _place_data(place: Place) -> dict[str, Any]:
    return {"file": shown_file(place.file), "line": place.line, "column": place.column}


__all__ = ["FindingIndex", "finding_data"]

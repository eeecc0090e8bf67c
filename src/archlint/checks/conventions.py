"""NME003: names against the patterns of a team."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.model import NAMED
from archlint.name_patterns import matches

if TYPE_CHECKING:
    from archlint.finding import Finding, Place
    from archlint.model import Text
    from archlint.systems.model import System

_HIDDEN = "_"
"""What ROS hides from its lists: the parts of an action, and names that want to be out of the way."""
_LOWER_SNAKE_CASE = "[a-z][a-z0-9_]*"


@rule(
    "NME003",
    scope=Scope.CODE,
    node=_LOWER_SNAKE_CASE,
    topic=_LOWER_SNAKE_CASE,
    service=_LOWER_SNAKE_CASE,
    action=_LOWER_SNAKE_CASE,
    parameter=_LOWER_SNAKE_CASE,
)
def name_convention(system: System, options: Options) -> Iterator[Finding]:
    """Names of which a part does not match the pattern for their kind; each place once."""
    misnamed: dict[tuple[Place, str, str], str | None] = {}
    for kind, text, separator, place, node in _names(system):
        part = _part_against(options.text(kind), text, separator)
        if part is not None and text.text is not None:
            misnamed.setdefault((place, kind, text.text), node)
    for place, kind, name in sorted(misnamed):
        yield finding(
            "NME003",
            place,
            f"the {kind} name '{name}' does not match the pattern {options.text(kind)}",
            help="rename it at both ends, or change the pattern in the configuration",
            node=misnamed[(place, kind, name)],
            identity=(kind, name),
        )


def _names(system: System) -> Iterator[tuple[str, Text, str, Place, str | None]]:
    """Kind, name as written, separator of its parts, place and node of every name."""
    for node in system.entries:
        if node.test:
            continue
        if node.blueprint is not None and node.is_node:
            yield "node", node.blueprint.name, "/", node.blueprint.name.origin or node.blueprint.place, node.name
        for end in node.endpoints:
            if end.creation.name_place is not None or end.creation.name.origin is not None:
                yield NAMED[end.kind], end.creation.name, "/", end.place, node.name
        for parameter in node.parameters:
            yield "parameter", parameter.name, ".", parameter.place, node.name


def _part_against(pattern: str, name: Text, separator: str) -> str | None:
    """The first part of a known name that does not match; what the code or rcl fills in is passed over."""
    if name.text is None:
        return None
    for part in name.text.split(separator):
        if not part or part.startswith(_HIDDEN) or set(part) & set("*{}~"):
            continue
        if matches(pattern, part) is False:
            return part
    return None

"""Values of a parameter file that rcl refuses or makes something else of.

Source: ``parse_value`` and ``parse_file_events`` of rcl_yaml_param_parser: "No value at line", "Will not support
aliasing", "Sequences cannot be key".  A map in a list becomes parameters of its keys' names, or is refused.  The end of
any list ends the outer one, too, for the parser; so a map that is the only item of a list, and whose first value is a
list, is read like a map without the dash.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.records import dataclass
from archlint.string_enum import StringEnum
from archlint.syntax.facts import Span
from archlint.syntax.parameter_structure import ROOT
from archlint.syntax.safe_yaml import span_of

if TYPE_CHECKING:
    import yaml


class Refusal(StringEnum):
    """Why a value is none of a parameter."""

    EMPTY = "empty"
    """Nothing stands behind the colon."""
    ALIAS = "alias"
    """``*defaults``: rcl knows no aliases."""
    NESTED = "nested"
    """A list in a list."""
    MAPS = "maps"
    """A map in a list."""


@dataclass(frozen=True)
class RefusedParameter:
    """One parameter, by its name below ``ros__parameters``."""

    kind: Refusal
    name: str
    span: Span


def first_refused(root: yaml.Node) -> RefusedParameter | None:
    """The first such value of a document."""
    return next(_of_map(root, None, set()), None)


def _of_map(node: yaml.Node, above: tuple[str, ...] | None, seen: set[int]) -> Iterator[RefusedParameter]:
    """What is refused below a map; ``above`` are the keys below ``ros__parameters``, None outside of it."""
    import yaml

    if not isinstance(node, yaml.MappingNode):
        return
    for key, value in node.value:
        name = str(key.value)
        path = () if name == ROOT else None if above is None else (*above, name)
        kind = Refusal.ALIAS if id(value) in seen or name == "<<" else _kind(value) if path else None
        seen.add(id(value))
        if kind is not None:
            yield RefusedParameter(kind, ".".join(path or (name,)), span_of(key))
            return
        yield from _of_map(value, path, seen)


def _kind(value: yaml.Node) -> Refusal | None:
    import yaml

    match value:
        case yaml.ScalarNode(value="", style=style) if not style:
            return Refusal.EMPTY
        case yaml.SequenceNode(value=[_, _, *_] as items) if all(isinstance(i, yaml.SequenceNode) for i in items[:2]):
            return Refusal.NESTED
        case yaml.SequenceNode(value=[yaml.MappingNode() as only]) if _starts_with_list(only):
            return None
        case yaml.SequenceNode(value=[yaml.MappingNode(), *_]):
            return Refusal.MAPS
    return None


def _starts_with_list(node: yaml.Node) -> bool:
    """Whether the first value in a map, or in the map that this is, is a list of plain values."""
    import yaml

    while isinstance(node, yaml.MappingNode) and node.value:
        node = node.value[0][1]
    return isinstance(node, yaml.SequenceNode) and all(isinstance(item, yaml.ScalarNode) for item in node.value)


__all__ = ["Refusal", "RefusedParameter", "first_refused"]

"""Parameter overrides: what the launch of one process sets, and how it names the nodes."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from archlint.model.nodes import Blueprint
    from archlint.model.texts import Text


@dataclass(frozen=True)
class Overrides:
    """The values of parameters that one process is started with, and the names of its nodes.

    ``of_nodes`` are those of its nodes, by the name and namespace that their constructors give; ``others`` are
    for a node that is not among them.  ``settled`` are the parameters whose values are certain while the
    process starts: set on every node that has them, or left to their defaults for sure.  ``names`` has the final
    name and namespace of each node that is given others than its constructor's.
    """

    of_nodes: Mapping[tuple[str | None, str | None], Mapping[str, object]] = field(default_factory=dict)
    others: Mapping[str, object] = field(default_factory=dict)
    settled: frozenset[str] = frozenset()
    names: Mapping[tuple[str | None, str | None], tuple[Text, Text]] = field(default_factory=dict)

    def of(self, node: Blueprint | None) -> Mapping[str, object]:
        """Values by parameter name."""
        return self.others if node is None else self.of_nodes.get(node_key(node), self.others)

    @property
    def key(self) -> tuple[object, ...]:
        """What distinguishes two of them."""
        rows = [(repr(node), _rows(values)) for node, values in self.of_nodes.items()]
        names = [(repr(node), repr(names)) for node, names in self.names.items()]
        return (*sorted(rows), _rows(self.others), *sorted(self.settled), *sorted(names))


def _rows(values: Mapping[str, object]) -> tuple[tuple[str, str], ...]:
    return tuple(sorted((name, repr(value)) for name, value in values.items()))


def node_key(node: Blueprint) -> tuple[str | None, str | None]:
    """The name and namespace that a node's constructor gives."""
    return node.name.text, node.namespace.text

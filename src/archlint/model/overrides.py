"""Parameter overrides: what the launch of one process sets, and how it names the nodes."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

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

    @property
    def key(self) -> tuple[object, ...]:
        """What distinguishes two of them."""
        rows = [(repr(node), _rows(values)) for node, values in self.of_nodes.items()]
        names = [(repr(node), repr(names)) for node, names in self.names.items()]
        return (*sorted(rows), _rows(self.others), *sorted(self.settled), *sorted(names))


@dataclass
class Asked:
    """What a program asks of its overrides, and what they say: with others that say the same it does the same."""

    overrides: Overrides
    _answers: dict[tuple[object, ...], str] = field(default_factory=dict)

    def value(self, node: Blueprint | None, name: str) -> tuple[object, ...]:
        """The value of a parameter, in a tuple; an empty one where nothing sets it."""
        return self._ask(("value", None if node is None else node_key(node), name))

    def are_settled(self, parameters: frozenset[str]) -> bool:
        """Whether the values of parameters are certain while the process starts."""
        return bool(self._ask(("settled", parameters)))

    @property
    def are_none(self) -> bool:
        """Whether nothing is set at all."""
        return not self._ask(("all",))

    def names(self, node: Blueprint) -> tuple[Text, Text]:
        """The final name and namespace of a node."""
        [names] = self._ask(("names", node_key(node))) or [(node.name, node.namespace)]
        return names

    def hold_for(self, others: Overrides) -> bool:
        """Whether other overrides say the same."""
        return all(repr(_answer(others, question)) == said for question, said in self._answers.items())

    def _ask(self, question: tuple[object, ...]) -> tuple[Any, ...]:
        answer = _answer(self.overrides, question)
        if question not in self._answers:
            self._answers[question] = repr(answer)
        return answer


def _answer(overrides: Overrides, question: tuple[Any, ...]) -> tuple[object, ...]:
    match question:
        case ("value", node, name):
            values = overrides.others if node is None else overrides.of_nodes.get(node, overrides.others)
            return (values[name],) if name in values else ()
        case ("settled", parameters):
            return (True,) if parameters <= overrides.settled else ()
        case ("names", node):
            return (overrides.names[node],) if node in overrides.names else ()
    return () if overrides == Overrides() else (True,)


def _rows(values: Mapping[str, object]) -> tuple[tuple[str, str], ...]:
    return tuple(sorted((name, repr(value)) for name, value in values.items()))


def node_key(node: Blueprint) -> tuple[str | None, str | None]:
    """The name and namespace that a node's constructor gives."""
    return node.name.text, node.namespace.text

"""Parameter overrides: what the launch of one process sets, and how it names the nodes."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import field, replace
from typing import TYPE_CHECKING, Any

from archlint.model.texts import Text
from archlint.records import dataclass

if TYPE_CHECKING:
    from typing import TypeAlias

    from archlint.model.nodes import Blueprint

    _Question: TypeAlias = tuple[Any, ...]


SHORT = 1000
"""The most characters of a text of which the length, too, is no matter."""


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
        names = [(repr(node), *map(repr, map(_unplaced, names))) for node, names in self.names.items()]
        return (*sorted(rows), _rows(self.others), *sorted(self.settled), *sorted(names))


@dataclass(frozen=True)
class Look:
    """Notes, when it is called, that a program does something that depends on an answer."""

    question: _Question
    ask: Callable[[_Question], object] = field(compare=False)

    def __call__(self) -> None:
        self.ask(self.question)


@dataclass
class Asked:
    """What a program asks of its overrides, and what they say: with others that say the same it does the same."""

    overrides: Overrides
    _answers: dict[_Question, str] = field(default_factory=dict)

    def value(self, node: Blueprint | None, name: str) -> tuple[object, ...]:
        """The value of a parameter, in a tuple; an empty one where nothing sets it.  What the program does depends on
        no more than its type until it calls what :meth:`look_at_value` gives."""
        return self._of_any_kind(_value_of(node, name))

    def look_at_value(self, node: Blueprint | None, name: str) -> Look:
        """To be called when the program does something that depends on the value of a parameter."""
        return Look(_value_of(node, name), self._ask)

    def are_settled(self, parameters: frozenset[str]) -> bool:
        """Whether the values of parameters are certain while the process starts."""
        return bool(self._ask(("settled", parameters)))

    @property
    def are_none(self) -> bool:
        """Whether nothing is set at all."""
        return not self._ask(("all",))

    def name(self, node: Blueprint) -> tuple[Text, Look]:
        """The final name of a node, and what to call when the program does something that depends on how it reads."""
        return self._name(("name", node_key(node)), node.name)

    def namespace(self, node: Blueprint) -> tuple[Text, Look]:
        """The same of its namespace."""
        return self._name(("namespace", node_key(node)), node.namespace)

    def _name(self, question: _Question, own: Text) -> tuple[Text, Look]:
        [final] = self._of_any_kind(question) or [own]
        return final, Look(question, self._ask)

    def _of_any_kind(self, question: _Question) -> tuple[Any, ...]:
        self._ask(("kind", *question))
        return _answer(self.overrides, question)

    def hold_for(self, others: Overrides) -> bool:
        """Whether other overrides say the same."""
        return all(repr(_answer(others, question)) == said for question, said in self._answers.items())

    def _ask(self, question: _Question) -> tuple[Any, ...]:
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
        case ("name" | "namespace" as which, node):
            final = overrides.names.get(node)
            return () if final is None else (_unplaced(final[which == "namespace"]),)
        case ("kind", *inner):
            return tuple(map(_kind, _answer(overrides, tuple(inner))))
    return () if overrides == Overrides() else (True,)


def _unplaced(name: Text) -> Text:
    """A name without the place where it is written: no program asks for that."""
    return replace(name, origin=None)


def _value_of(node: Blueprint | None, name: str) -> _Question:
    return "value", None if node is None else node_key(node), name


def _kind(answer: object) -> object:
    """All of an answer but the constants and the names in it."""
    if isinstance(answer, (list, tuple)):
        return list(map(_kind, answer))
    if isinstance(answer, (str, int, float)):
        is_plain = not isinstance(answer, str) or 0 < len(answer) < SHORT
        return type(answer).__name__ if is_plain else answer
    if isinstance(answer, Text):
        known = 0 < len(answer.text or "") < SHORT and answer.resolution in ("exact", "parameter")
        return replace(answer, text=None) if known else answer
    return answer


def _rows(values: Mapping[str, object]) -> tuple[tuple[str, str], ...]:
    return tuple(sorted((name, repr(value)) for name, value in values.items()))


def node_key(node: Blueprint) -> tuple[str | None, str | None]:
    """The name and namespace that a node's constructor gives."""
    return node.name.text, node.namespace.text

"""Launch's objects as XML and YAML launch files make them, and the texts with ``$(…)`` that these give."""

from __future__ import annotations

from collections.abc import Hashable, Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.finding import Place
from archlint.interpreter import containers
from archlint.interpreter.objects.dicts import update_entries
from archlint.interpreter.values import External, Instance, Known, Unknown, Value
from archlint.launch.frontends.tables import SUBSTITUTIONS
from archlint.launch.frontends.texts import closing, unquoted, words_of
from archlint.launch.objects import OWN, LaunchObject, launch_object
from archlint.launch.tables import LaunchClass

if TYPE_CHECKING:
    from archlint.launch.run import LaunchRun
    from archlint.syntax.launch_elements import Attribute, Element

NESTING = 20
"""How deep substitutions are followed into each other."""


class Frontend:
    """Makes launch's objects of what one file says."""

    def __init__(self, run: LaunchRun, file: str) -> None:
        self.run = run
        self.file = file

    def place(self, span: tuple[int, int, int, int]) -> Place:
        return Place(self.file, *span)

    def make(
        self,
        kind: LaunchClass,
        place: Place,
        arguments: dict[str, Value],
        places: dict[str, Place] | None = None,
        rest: tuple[Value, ...] = (),
    ) -> LaunchObject:
        return launch_object(self.run.store.new_key(), kind, place, arguments, places=places, rest=rest)

    def unknown(self, element: Element) -> Instance:
        """What an element makes that no table has."""
        return Instance(External(f"{OWN}<{element.tag}>"), self.run.store.new_key(), self.place(element.span))

    def list(self, values: Sequence[Value]) -> Value:
        return containers.new_list(self.run, values)

    def dict_of(self, pairs: Sequence[Value]) -> Value:
        entries: dict[Hashable, tuple[Value, Value]] = {}
        known = all(update_entries(self.run, entries, self.list([pair])) for pair in pairs)
        return containers.new_dict(self.run, entries, not known)

    def text(self, attribute: Attribute) -> Value:
        """The value of an attribute, with its substitutions."""
        if isinstance(attribute.value, list):
            parts = [Known(item) if not isinstance(item, str) else self.parse(item) for item in attribute.value]
            return self.list(parts)
        if isinstance(attribute.value, str):
            return self.parse(attribute.value, self.place(attribute.span))
        return Known(attribute.value, origin=self.place(attribute.span))

    def get(self, element: Element, *names: str) -> Value | None:
        for name in names:
            if name in element.attributes:
                return self.text(element.attributes[name])
        return None

    def arguments(self, element: Element, names: dict[str, str]) -> tuple[dict[str, Value], dict[str, Place]]:
        """Constructor arguments from attributes: ``names`` maps attributes to parameters."""
        arguments: dict[str, Value] = {}
        places: dict[str, Place] = {}
        for name, parameter in names.items():
            attribute = element.attributes.get(name)
            if attribute is not None:
                arguments[parameter] = self.text(attribute)
                places[parameter] = self.place(attribute.span)
        return arguments, places

    # ------------------------------------------------------------------------------------ substitutions

    def parse(self, text: str, place: Place | None = None) -> Value:
        """A text with ``$(…)`` in it."""
        if "$(" not in text:
            return Known(text, origin=place, kind="literal")
        parts = list(self.parts(text, place, 0))
        return parts[0] if len(parts) == 1 else self.list(parts)

    def parts(self, text: str, place: Place | None, depth: int) -> Iterator[Value]:
        at = 0
        while at < len(text):
            start = text.find("$(", at)
            if start < 0:
                yield Known(text[at:], origin=place)
                return
            if depth > NESTING:
                yield Unknown("substitutions nested too deeply")
                return
            if start > 0 and text[start - 1] == "\\":
                yield Known(text[at : start - 1] + "$(")
                at = start + 2
                continue
            end = closing(text, start + 2)
            if end < 0:
                yield Unknown("a substitution that is not closed")
                return
            if start > at:
                yield Known(text[at:start], origin=place)
            yield self._substitution(text[start + 2 : end], place, depth)
            at = end + 1

    def _substitution(self, text: str, place: Place | None, depth: int) -> Value:
        words = list(words_of(text))
        if not words:
            return Unknown("an empty substitution")
        name, rest = words[0], words[1:]
        build = SUBSTITUTIONS.get(name)
        if build is None:
            return Unknown(f"the substitution $({name} …)")
        kind, parameters = build
        if name == "eval":
            rest = [unquoted(text[text.index("eval") + 4 :].strip())]
        values = [self.list(list(self.parts(unquoted(word), place, depth + 1))) for word in rest]
        given = dict(zip(parameters, values, strict=False))
        beyond = tuple(values[len(parameters) :])
        return self.make(kind, place or Place(self.file, 1, 1, 1, 1), given, rest=beyond)

"""The facts of one file as a tree: what is around a piece of them, all pieces of a kind, and what is stored in."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Sequence
from functools import cached_property
from typing import TypeVar, cast

from archlint.syntax import facts
from archlint.syntax.parts import targets_in

_Fact = TypeVar("_Fact", bound=facts.Base)


class Tree:
    """``body`` holds the statements of the module.  A fact is known by its identity, for equal ones may stand at
    several places."""

    def __init__(self, code: facts.Facts) -> None:
        self._root = code
        self.body = code.body
        self._kinds: dict[type[facts.Base], list[facts.Base]] = defaultdict(list)
        self._holders: list[tuple[facts.Base, list[facts.Base]]] = []
        """The facts that others stand in, each with these."""
        stack: list[facts.Base] = [code]
        while stack:
            fact = stack.pop()
            self._kinds[type(fact)].append(fact)
            inside = fact.children()
            if inside:
                self._holders.append((fact, inside))
                stack += inside[::-1]

    @cached_property
    def _parents(self) -> dict[int, facts.Base]:
        return {id(fact): holder for holder, inside in self._holders for fact in inside}

    def of_kind(self, kind: type[_Fact]) -> Sequence[_Fact]:
        """Every fact of a kind, in the order of the source."""
        return cast("Sequence[_Fact]", self._kinds.get(kind, []))

    def parent(self, fact: facts.Base) -> facts.Base | None:
        return self._parents.get(id(fact))

    def around(self, fact: facts.Base) -> Iterator[facts.Base]:
        """What holds a fact, from the inside out; the module itself is left out."""
        outer = self.parent(fact)
        while outer is not None and outer is not self._root:
            yield outer
            outer = self.parent(outer)

    def function_around(self, fact: facts.Base) -> facts.Function | None:
        """The innermost function; None at the level of the module."""
        for outer in self.around(fact):
            match outer:
                case facts.Function():
                    return outer
        return None

    def classes_around(self, fact: facts.Base) -> Iterator[facts.Class]:
        """The classes that a fact is in, the innermost first."""
        for outer in self.around(fact):
            match outer:
                case facts.Class():
                    yield outer

    def class_around(self, fact: facts.Base) -> facts.Class | None:
        return next(self.classes_around(fact), None)

    def last_of_block(self, statement: facts.Base) -> facts.Base:
        """The last statement of the block that a statement stands in; the statement itself where it stands in none."""
        return self._last_of_blocks.get(id(statement), statement)

    @cached_property
    def _last_of_blocks(self) -> dict[int, facts.Base]:
        blocks = (block for holder, _ in self._holders for block in _lists(holder))
        return {id(item): cast("facts.Base", block[-1]) for block in blocks for item in block}

    @cached_property
    def given(self) -> dict[facts.Span, tuple[facts.Call, facts.Expr]]:
        """What calls are given, by where it stands, but for what a ``*`` takes apart."""
        return {
            span_of(argument.value): (call, argument.value)
            for call in reversed(self.of_kind(facts.Call))
            for argument in reversed(call.args)
            if not argument.star
        }

    @cached_property
    def calls(self) -> dict[facts.Span, facts.Call]:
        """The calls by where they stand."""
        return {call.span: call for call in reversed(self.of_kind(facts.Call))}

    @cached_property
    def stored(self) -> Sequence[tuple[facts.Base, facts.Expr]]:
        """What is stored in or deleted, with the statement (or part of an expression) that does it: the names,
        attributes and items, those inside of a tuple each by itself."""
        return [(fact, expression) for fact, target in self._targets() for expression in targets_in(target)]

    def _targets(self) -> Iterator[tuple[facts.Base, facts.Expr]]:
        yield from ((fact, target) for fact in self.of_kind(facts.Assign) for target in fact.targets)
        yield from ((fact, target) for fact in self.of_kind(facts.Delete) for target in fact.targets)
        yield from ((fact, fact.target) for fact in self.of_kind(facts.Annotated))
        yield from ((fact, fact.target) for fact in self.of_kind(facts.Augmented))
        yield from ((fact, fact.target) for fact in self.of_kind(facts.For))
        yield from ((fact, fact.target) for fact in self.of_kind(facts.Generator))
        yield from ((fact, fact.target) for fact in self.of_kind(facts.Assigned))
        yield from ((fact, fact.target) for fact in self.of_kind(facts.WithItem) if fact.target is not None)

    @cached_property
    def _stored_ids(self) -> frozenset[int]:
        return frozenset(id(expression) for _, expression in self.stored)

    def reads(self, name: str, inside: facts.Function | None) -> bool:
        """Whether a function, or without one the module, reads a variable."""
        return any(
            use.id == name
            and id(use) not in self._stored_ids
            and (inside is None or any(outer is inside for outer in self.around(use)))
            for use in self.of_kind(facts.Name)
        )


def _lists(fact: facts.Base) -> Iterator[list[object]]:
    for name in fact.__struct_fields__:
        match getattr(fact, name):
            case list() as block:
                yield block


_NOWHERE: facts.Span = (0, 0, 0, 0)


def span_of(fact: facts.Base) -> facts.Span:
    """Where a fact stands; zeros for one that keeps no place, such as ``global``."""
    return cast("facts.Span", getattr(fact, "span", _NOWHERE))

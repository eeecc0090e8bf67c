"""What a piece of facts holds: every fact inside it, and the names that it uses."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import Generic, TypeVar, Union, overload

from archlint.syntax import facts
from archlint.syntax.fields_with_facts import Holding, fields_with_facts

Kind = TypeVar("Kind", bound=facts.Base)
Source = Union[facts.Base, Sequence[facts.Base], None]
"""A piece of source: one fact, several in their order, or none."""
T = TypeVar("T")
Result = TypeVar("Result")


class Itself(Generic[T]):
    """A fact as a key: equal to itself alone, for comparing by content would cost a walk."""

    __slots__ = ("fact",)

    def __init__(self, fact: T) -> None:
        self.fact = fact

    def __hash__(self) -> int:
        return id(self.fact)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Itself) and other.fact is self.fact


def once_for(function: Callable[[T], Result]) -> Callable[[T], Result]:
    """Keep what a function says of each fact.  For what is asked at every step of a run: a look-up by ``id`` takes a
    fraction of one by a key such as :class:`Itself`."""
    known: dict[int, tuple[T, Result]] = {}

    def ask(fact: T) -> Result:
        row = known.get(id(fact))
        if row is None:
            if len(known) >= _KEPT:
                known.clear()
            row = known[id(fact)] = fact, function(fact)  # with the fact, whose id is nobody else's for as long
        return row[1]

    return ask


_KEPT = 50_000


_HELD = 2_000_000
"""How many facts are kept as parts of blocks: those of some hundred thousand lines, 16 MB."""
_FEW = 32
"""How many facts nobody needs to keep: a walk takes no longer than to find them."""


class _Walks:
    """Every fact of a block of source, kept for the next who asks.  Each rule goes through the same files, classes and
    functions, and a walk takes ten times as long as a list."""

    def __init__(self) -> None:
        self._known: dict[tuple[int, ...], list[facts.Base]] = {}
        self._held = 0

    def of(self, block: Sequence[facts.Base]) -> list[facts.Base]:
        """Every fact in a block."""
        key = tuple(map(id, block))  # with the facts of the block, whose ids are nobody else's for as long
        every = self._known.get(key)
        if every is None:
            every = _every(block)
            if len(every) > _FEW:
                self._keep(key, every)
        return every

    def _keep(self, key: tuple[int, ...], every: list[facts.Base]) -> None:
        if self._held > _HELD:
            self._known.clear()
            self._held = 0
        self._known[key] = every
        self._held += len(every)


_walks = _Walks()


@overload
def everything_in(fact: Source) -> Iterator[facts.Base]: ...


@overload
def everything_in(fact: Source, kind: type[Kind]) -> Iterator[Kind]: ...


def everything_in(fact: Source, kind: type[facts.Base] = facts.Base) -> Iterator[facts.Base]:
    """Every fact (of a kind) inside another, those of the functions inside it too, in the order of the source."""
    if isinstance(fact, facts.Base):
        block: Sequence[facts.Base] = (fact,) if fact.is_scope else ()
    else:
        block = fact or ()
    if not block or issubclass(kind, facts.Statement):  # a walk for statements is short
        return _walk(fact, kind, True)
    every = _walks.of(block)
    return iter(every) if kind is facts.Base else (item for item in every if isinstance(item, kind))


@overload
def parts_of(fact: Source) -> Iterator[facts.Base]: ...


@overload
def parts_of(fact: Source, kind: type[Kind]) -> Iterator[Kind]: ...


def parts_of(fact: Source, kind: type[facts.Base] = facts.Base) -> Iterator[facts.Base]:
    """Every fact (of a kind) inside another, that one first; what is in functions and classes inside it is left
    out."""
    return _walk(fact, kind, False)


def _walk(fact: Source, kind: type[facts.Base], into_scopes: bool) -> Iterator[facts.Base]:
    stack = [fact] if isinstance(fact, facts.Base) else list(reversed(fact or ()))
    of_statements = issubclass(kind, facts.Statement)  # none of them is in an expression
    while stack:
        item = stack.pop()
        if kind is facts.Base or isinstance(item, kind):
            yield item
        if into_scopes or item is fact or not item.is_scope:
            if of_statements:
                stack += item.statements[::-1]
            elif rows := _backwards[type(item)]:
                _push(stack, item, rows)


def _every(block: Sequence[facts.Base]) -> list[facts.Base]:
    """As :func:`_walk`, of everything at once: most facts are names and literals, which nothing is inside of."""
    every: list[facts.Base] = []
    stack = list(reversed(block))
    while stack:
        item = stack.pop()
        every.append(item)
        if rows := _backwards[type(item)]:
            _push(stack, item, rows)
    return every


class _Backwards(dict[type[facts.Base], tuple[Holding, ...]]):
    """The fields of each class that may hold facts, the last one first."""

    def __missing__(self, kind: type[facts.Base]) -> tuple[Holding, ...]:
        rows = self[kind] = fields_with_facts(kind)[::-1]
        return rows


_backwards = _Backwards()


def _push(stack: list[facts.Base], fact: facts.Base, rows: tuple[Holding, ...]) -> None:
    """Put the facts that a fact is made of on a stack, the first one on top."""
    for name, is_list, is_mixed in rows:
        value = getattr(fact, name)
        if is_mixed:
            stack += [item for item in reversed(value) if isinstance(item, facts.Base)]
        elif is_list:
            stack += value[::-1]
        elif value is not None:
            stack.append(value)


@once_for
def names_in(ir: Source) -> frozenset[str]:
    """All names and attributes that a piece of facts uses."""
    return frozenset(name for item in everything_in(ir) if (name := item.last_name))


def targets_in(target: facts.Expr) -> Iterator[facts.Expr]:
    """What an assignment to a target sets: the target, or the parts of a tuple of targets."""
    match target:
        case facts.Sequence(elements=elements):
            for element in elements:
                yield from targets_in(element)
        case facts.Starred(value=value):
            yield from targets_in(value)
        case _:
            yield target


__all__ = ["Itself", "everything_in", "names_in", "once_for", "parts_of", "targets_in"]

"""Attributes of ``self`` that a constructor reads before it assigns them: an AttributeError whenever an object is made.

No way through ``__init__`` leads past an assignment to the read; or ``__init__`` calls a method that reads them for
certain, before it assigns them.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING

from archlint.place import Place
from archlint.python_code.block_bindings import after, bound_at, is_plain, read_at, run_before
from archlint.python_code.class_chains import (
    Chain,
    ClassInFile,
    chain_of,
    classes_asked_for,
    derived_from,
    kept_for_each_class,
    methods_of,
    targets_of,
)
from archlint.python_code.methods_at_work import INIT, of_self
from archlint.python_code.unassigned_attributes import has_self, may_get, members_of, names_of_body
from archlint.python_code.unshared_objects import KEEPS_OUT, texts_given_to
from archlint.records import dataclass
from archlint.syntax import facts
from archlint.syntax.control_flow import graph_of
from archlint.syntax.flow_blocks import without_exceptions
from archlint.syntax.parts import Itself, everything_in, once_for, parts_of

if TYPE_CHECKING:
    from archlint.syntax.flow_blocks import Block
    from archlint.syntax.flow_graph import Graph
    from archlint.systems.model import WorkspaceIndex

_CATCH = frozenset({"AttributeError", "Exception", "BaseException"})
_ASKS = frozenset({"hasattr", "getattr"})


@dataclass(frozen=True)
class EarlyRead:
    """A read of an attribute before the constructor assigns it; ``called`` is where it calls the ``method`` that reads
    it."""

    place: Place
    cls: str
    name: str
    assigned: Place
    method: str = ""
    called: Place | None = None


@dataclass(frozen=True)
class _Early:
    """The same by the text of the class; ``mentioned`` are the attributes of ``self`` that code before it has, which
    may be methods that run, and ``given`` says whether other code has the object by then."""

    name: str
    span: facts.Span
    assigned: facts.Span
    mentioned: frozenset[str] = frozenset()
    given: bool = False
    method: str = ""
    called: facts.Span | None = None


def early_attribute_reads(workspace: WorkspaceIndex) -> Iterator[EarlyRead]:
    """Every such read in the files that were asked for: the first of each attribute."""
    for cls in classes_asked_for(workspace):
        for row in _early(workspace, cls):
            if _is_certain(workspace, cls, row):
                at = partial(Place, cls.file)
                called = None if row.called is None else at(*row.called)
                yield EarlyRead(at(*row.span), cls.code.name, row.name, at(*row.assigned), row.method, called)


def _is_certain(workspace: WorkspaceIndex, cls: ClassInFile, row: _Early) -> bool:
    """Whether nothing that runs before a read can have assigned the attribute: no base, no derived class, no method."""
    chain = chain_of(workspace, cls)
    if members_of(workspace, chain) is None or any("__new__" in set(names_of_body(base.code)) for base in chain.own):
        return False  # what makes the object, once for all perhaps, may have given it anything
    bases = [base for base in chain.own if base.code is not cls.code]
    if any(row.name in gives(base.code) for base in bases) or is_of_class(workspace, chain, row.name):
        return False
    for other in derived_from(workspace, cls):
        if {row.name, row.method} & gives(other.code):
            return False
    if _assigns_on_the_way(cls, bases, row):
        return False
    return not row.given or not may_get(workspace, cls, row.name)


def is_of_class(workspace: WorkspaceIndex, chain: Chain, name: str, *, own: bool = True) -> bool:
    """Whether an object has an attribute without any assignment to it: one of rclpy's, or of its ``own`` classes."""
    bare = replace(chain, own=[])
    foreign = members_of(workspace, bare) or []
    classes = chain.own if own else []
    return any(name in names for names in foreign) or any(name in set(names_of_body(c.code)) for c in classes)


def gives(code: facts.Class) -> frozenset[str]:
    """The methods of a class, and all that it assigns to an object."""
    assigned = (target.attr for target in targets_of(code.body) if isinstance(target, facts.Attribute))
    return frozenset((*names_of_body(code), *assigned))


def _assigns_on_the_way(cls: ClassInFile, bases: Sequence[ClassInFile], row: _Early) -> bool:
    """Whether a method that may run before a read assigns the attribute."""
    mentions = {function.name: _mentioned(function.body) for base in bases for function in methods_of(base.code)}
    waiting = [*row.mentioned, *mentions.get(INIT, ())]
    setters: set[str] = set()
    for function in methods_of(cls.code):
        if function.name != INIT:
            mentions[function.name] = mentions.get(function.name, frozenset()) | _mentioned(function.body)
            if any(of_self(target) == row.name for target in targets_of(function.body)):
                setters.add(function.name)
    seen: set[str] = set()
    while waiting:
        name = waiting.pop()
        if name in setters:
            return True
        if name not in seen:
            seen.add(name)
            waiting += mentions.get(name, ())
    return False


# ---------------------------------------------------------------------------------------- by the text of the class


@kept_for_each_class
def _early(code: facts.Class) -> list[_Early]:
    methods = {function.name: function for function in methods_of(code)}
    init = methods.get(INIT)
    if init is None or not has_self(init):
        return []
    return [*_in_constructor(init, methods, texts_given_to(_ASKS, code.body).union(names_of_body(code)))]


def _in_constructor(
    init: facts.Function, methods: Mapping[str, facts.Function], others: frozenset[str]
) -> Iterator[_Early]:
    """The first read of each attribute, but for those of which nothing can be said."""
    graph, caught, seen = graph_of(init.body), caught_in(init.body), set(others)
    assigned = {name: rows for name, rows in _assigned(graph).items() if name not in others}
    later = {name: after([block for block, _ in rows]) for name, rows in assigned.items()}
    for block in graph.blocks:
        if block.statement is None or Itself(block.statement) in caught:
            continue
        for row in (*_direct(block), *_in_methods(methods, block)):
            if row.name in seen or row.name not in assigned or block in later[row.name]:
                continue
            if is_plain(block) or all(block is not other for other, _ in assigned[row.name]):
                seen.add(row.name)
                before = run_before(graph, block)
                yield replace(
                    row,
                    assigned=assigned[row.name][0][1],
                    mentioned=(mentioned_in(before) - {row.method}) | row.mentioned,
                    given=row.given or _is_given(before),
                )


def _assigned(graph: Graph) -> dict[str, list[tuple[Block, facts.Span]]]:
    """The blocks that give each attribute of ``self`` a value; a function counts where it is defined."""
    assigned: dict[str, list[tuple[Block, facts.Span]]] = {}
    for block in graph.blocks:
        for target in assigned_at(block):
            assigned.setdefault(target.attr, []).append((block, target.span))
    return assigned


@once_for
def assigned_at(block: Block) -> list[facts.Attribute]:
    """The attributes of ``self`` to which a block assigns something, or a function that it defines."""
    targets = [
        each
        for target in bound_at(block)
        for each in (targets_of(target.body) if isinstance(target, facts.Function) else [target])
    ]
    return [each for each in targets if isinstance(each, facts.Attribute) and of_self(each) is not None]


def _direct(block: Block) -> Iterator[_Early]:
    for part, _ in read_at(block):
        name = of_self(part)
        if name is not None and isinstance(part, facts.Attribute):
            yield _Early(name, part.span, part.span)


def _in_methods(methods: Mapping[str, facts.Function], block: Block) -> Iterator[_Early]:
    """What the methods read for certain that a block calls."""
    for call in () if block.fact is None else parts_of(block.fact, facts.Call):
        method = methods.get(of_self(call.func) or "")
        if method is not None and method.name != INIT:
            for read in _surely_read(method):
                yield replace(read, method=method.name, called=call.span)


@once_for
def _surely_read(method: facts.Function) -> list[_Early]:
    """What every run of a method reads before it assigns it."""
    if method.decorators or method.is_async or method.is_generator or not has_self(method):
        return []
    graph, caught = graph_of(method.body), caught_in(method.body)
    assigned, rows = _assigned(graph), list[_Early]()
    for block in graph.blocks:
        reads = [part for part, surely in read_at(block) if surely and of_self(part) is not None]
        if not reads or block.statement is None or Itself(block.statement) in caught:
            continue
        if not graph.post_dominates([block], graph.entry, without_exceptions):
            continue
        before = run_before(graph, block)
        mentioned, given = mentioned_in(before), _is_given(before)
        for part in reads:
            if isinstance(part, facts.Attribute) and part.attr not in assigned:
                rows.append(_Early(part.attr, part.span, part.span, mentioned, given))
    return rows


def caught_in(body: Sequence[facts.Stmt]) -> set[Itself[facts.Base]]:
    """The statements that are tried in case that they fail so."""
    return {
        Itself(part)
        for attempt in parts_of(body, facts.Try)
        if any(handler.type is None or handler.caught & _CATCH for handler in attempt.handlers)
        for part in parts_of(attempt.body, facts.Statement)
    }


def _mentioned(body: Sequence[facts.Base]) -> frozenset[str]:
    return frozenset(name for part in everything_in(body) if (name := of_self(part)) is not None)


def mentioned_in(blocks: Collection[Block]) -> frozenset[str]:
    """The attributes of ``self`` that some blocks have, or functions that they define."""
    return frozenset().union(*map(_mentioned_at, blocks))


@once_for
def _mentioned_at(block: Block) -> frozenset[str]:
    return _mentioned(_evaluated(block))


def _evaluated(block: Block) -> Sequence[facts.Base]:
    """All that a block runs, or may run later."""
    parts = [*bound_at(block)] + ([] if block.fact is None else [block.fact])
    return [child for part in parts for child in ([part] if not part.is_scope else part.children())]


def _is_given(blocks: Collection[Block]) -> bool:
    """Whether something else gets the object itself."""
    for block in blocks:
        parts = _evaluated(block)
        owners = {Itself(part.value) for part in everything_in(parts, facts.Attribute)}
        known = {
            Itself(argument.value)
            for call in everything_in(parts, facts.Call)
            if call.func.last_name in KEEPS_OUT
            for argument in call.args
        }
        for name in everything_in(parts, facts.Name):
            if name.id == "self" and Itself[facts.Base](name) not in owners | known:
                return True
    return False


__all__ = [
    "EarlyRead",
    "assigned_at",
    "caught_in",
    "early_attribute_reads",
    "gives",
    "is_of_class",
    "mentioned_in",
]

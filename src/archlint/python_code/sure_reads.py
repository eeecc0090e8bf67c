"""What a method reads of its object whenever it runs, or whenever a few conditions hold that can be named."""

from __future__ import annotations

import builtins
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

from archlint.python_code.block_bindings import is_plain, read_at, run_before
from archlint.python_code.class_chains import targets_of
from archlint.python_code.early_attribute_reads import assigned_at, caught_in, mentioned_in
from archlint.python_code.first_values import first_values, holds
from archlint.python_code.methods_at_work import MethodsAtWork, of_self
from archlint.python_code.unassigned_attributes import has_self
from archlint.records import dataclass
from archlint.syntax import facts
from archlint.syntax.bindings import names_bound
from archlint.syntax.control_flow import graph_of
from archlint.syntax.flow_blocks import Block, without_exceptions
from archlint.syntax.flow_graph import Graph
from archlint.syntax.parts import Itself, everything_in, once_for, parts_of

_DEPTH = 4
"""How many methods that call each other are looked into."""
_WAITS = frozenset({"wait", "wait_for_service", "wait_for_server", "acquire", "sleep", "join", "result"})
_BUILT_IN = frozenset(dir(builtins))
_OF_NODE = frozenset({"get_clock", "get_logger"})
"""The methods of a node whose results say nothing of its state."""
_ANYTHING = ""
"""Stands for what a condition asks for and cannot be named."""


@dataclass(frozen=True)
class SureRead:
    """A read of ``self.name`` in a method, or in one that it calls.  ``before`` are the methods that may have run by
    then; where it is not ``is_sure``, it depends on what the method was called with, and on the attributes and methods
    that it ``asks``."""

    name: str
    span: facts.Span
    before: frozenset[str]
    is_sure: bool
    asks: frozenset[str] = frozenset()


def sure_reads(work: MethodsAtWork, method: str, names: frozenset[str], depth: int = _DEPTH) -> list[SureRead]:
    """The reads of some attributes before which a method waits for nothing, and asks for nothing that is not named."""
    function = work.methods[method]
    if function.decorators or function.is_async or function.is_generator or not has_self(function):
        return []
    graph, caught = graph_of(function.body), caught_in(function.body)
    rows: list[SureRead] = []
    for block in graph.blocks:
        reads = [*_of_self_at(block)]
        if not reads or block.statement is None or Itself(block.statement) in caught:
            continue
        nested = _called_at(work, method, block, depth)
        if not nested and all(part.attr not in names for part in reads):
            continue
        is_sure = graph.post_dominates([block], graph.entry, without_exceptions)
        asks = frozenset[str]() if is_sure else _asked_by(function, _deciders(work, method, graph, block))
        before = [] if _ANYTHING in asks else run_before(graph, block)
        if not before or any(_waits(each) for each in before if each is not block):
            continue
        rows += _at(work, method, names, block, before, is_sure, asks)
        rows += _nested(work, method, names, nested, before, is_sure, asks, depth)
    return rows


def _at(
    work: MethodsAtWork,
    method: str,
    names: frozenset[str],
    block: Block,
    before: Sequence[Block],
    is_sure: bool,
    asks: frozenset[str],
) -> Iterator[SureRead]:
    assigned = {
        target.attr for each in before for target in assigned_at(each) if each is not block or not is_plain(block)
    }
    run = _run_in(work, method, before)
    for part in _of_self_at(block):
        if part.attr in names and part.attr not in assigned:
            yield SureRead(part.attr, part.span, run, is_sure, asks)


def _nested(
    work: MethodsAtWork,
    method: str,
    names: frozenset[str],
    called: Sequence[str],
    before: Sequence[Block],
    is_sure: bool,
    asks: frozenset[str],
    depth: int,
) -> Iterator[SureRead]:
    assigned = {target.attr for each in before for target in assigned_at(each)}
    for each in called:
        run = _run_in(work, method, before) - {each}
        for row in sure_reads(work, each, names, depth - 1):
            if row.name not in assigned:
                yield replace(row, before=row.before | run, is_sure=row.is_sure and is_sure, asks=row.asks | asks)


def _run_in(work: MethodsAtWork, method: str, blocks: Sequence[Block]) -> frozenset[str]:
    """The methods that some blocks of one may have run: not those that it only registers."""
    return mentioned_in(blocks).intersection(work.leads_to.get(method, ()))


def _of_self_at(block: Block) -> Iterator[facts.Attribute]:
    for part, surely in read_at(block):
        if surely and isinstance(part, facts.Attribute) and of_self(part) is not None:
            yield part


def _called_at(work: MethodsAtWork, method: str, block: Block, depth: int) -> list[str]:
    """The methods that a block calls for certain."""
    if depth <= 0 or block.fact is None:
        return []
    called = {Itself[facts.Base](call.func) for call in parts_of(block.fact, facts.Call)}
    names = [part.attr for part in _of_self_at(block) if Itself[facts.Base](part) in called]
    return [name for name in names if name in work.methods and name != method]


def _waits(block: Block) -> bool:
    """Whether a block waits for another thread, or asks again and again."""
    fact = block.fact
    if fact is None:
        return False
    if any(call.func.last_name in _WAITS for call in parts_of(fact, facts.Call)):
        return True
    return isinstance(block.statement, facts.While) and any(name.id == "self" for name in parts_of(fact, facts.Name))


# ------------------------------------------------------------------------------------ what conditions ask for


def _deciders(work: MethodsAtWork, method: str, graph: Graph, block: Block) -> list[Block]:
    """The conditions that decide about a block, but for those that come out so with what the constructor assigns, where
    the method has not changed it by then."""
    come_out = {edge.source: edge for edge in graph.outcomes([block]) if edge.test is not None}
    deciders: list[Block] = []
    for decider in graph.deciders([block]):
        edge, changed = come_out.get(decider), _changed_before(work, method, graph, decider)
        values = {name: value for name, value in first_values(work).items() if name not in changed}
        if edge is None or edge.test is None or holds(edge.test, values) is not edge.holds:
            deciders.append(decider)
    return deciders


def _changed_before(work: MethodsAtWork, method: str, graph: Graph, block: Block) -> set[str]:
    """The attributes of ``self`` that a method, or one that it calls, may assign before it comes to a block."""
    before = [each for each in run_before(graph, block) if each is not block]
    changed = {target.attr for each in before for target in assigned_at(each)}
    for other in work.after(_run_in(work, method, before)):
        changed |= _assigned_in(work.methods[other])
    return changed


@once_for
def _assigned_in(method: facts.Function) -> frozenset[str]:
    """The attributes of ``self`` that a method assigns, or a function inside it."""
    return frozenset(name for target in targets_of(method.body) if (name := of_self(target)) is not None)


def _asked_by(function: facts.Function, deciders: Sequence[Block]) -> frozenset[str]:
    """The attributes of ``self`` for which conditions ask."""
    if any(isinstance(decider.statement, facts.Try) for decider in deciders):
        return frozenset({_ANYTHING})
    known, asked = _known_in(function), set[str]()
    for decider in deciders:
        parts: list[facts.Base] = [] if decider.fact is None else [decider.fact]
        if isinstance(decider.statement, facts.For):
            parts.append(decider.statement.iterable)  # whether there is anything to go through
        for name in _names_asked(parts):
            asked |= {name} if name.startswith("self.") else known.get(name, {_ANYTHING})
    return frozenset(name.removeprefix("self.") for name in asked)


def _names_asked(parts: Sequence[facts.Base]) -> Iterator[str]:
    """The variables and the attributes of ``self`` that an expression asks for, but for functions of modules and for
    what is written in capitals."""
    stack = list(parts)
    while stack:
        part = stack.pop()
        match part:
            case facts.Call(func=facts.Name(id=name), args=args) if name in _BUILT_IN:
                stack += [argument.value for argument in args]
                continue
            case facts.Call(func=facts.Attribute(value=facts.Name(id="self"), attr=name)) if name in _OF_NODE:
                continue
            case facts.Call(func=facts.Attribute() as func, args=args) if func.dotted.split(".")[0] in _MODULES:
                stack += [argument.value for argument in args]
                continue
            case facts.Comprehension(generators=generators):
                own = {name.id for each in generators for name in everything_in([each.target], facts.Name)}
                yield from (name for name in _names_asked(part.children()) if name not in own)
                continue
            case facts.Attribute(value=facts.Name(id="self"), attr=name):
                yield f"self.{name}"
                continue
            case facts.Attribute(attr=name) if name.isupper() and part.dotted:
                continue
            case facts.Name(id=name):
                yield name
        stack += part.children()


_MODULES = frozenset({"math", "m", "np", "numpy", "rclpy", "json", "time"})
"""Modules whose functions know nothing of a node."""


@once_for
def _known_in(function: facts.Function) -> Mapping[str, set[str]]:
    """The parameters of a method and its variables, with the attributes of ``self`` that each may depend on."""
    known: dict[str, set[str]] = {param.name: set() for param in function.params if param.name != "self"}
    values: dict[str, set[str]] = {name: set() for name in known}
    for part in everything_in(function.body):
        targets: list[facts.Base] = [*part.assigned]
        if isinstance(part, facts.WithItem) and part.target is not None:
            targets = [part.target]
        for variable in everything_in(targets, facts.Name):
            values.setdefault(variable.id, set()).update(_names_asked(_values(part)))
    for inner in parts_of(function.body, facts.Function):
        own = {param.name for param in inner.params}.union(names_bound(inner.body))
        values[inner.name] = {name for name in _names_asked(inner.body) if name not in own}
    for statement in parts_of(function.body, facts.Global):
        values.update((name, {_ANYTHING}) for name in statement.names)
    for name in values:
        known[name] = _depends_on(name, values)
    return known


def _depends_on(name: str, values: Mapping[str, set[str]]) -> set[str]:
    seen, waiting, others = {name}, [name], set[str]()
    while waiting:
        for source in values.get(waiting.pop(), ()):
            if source.startswith("self.") or source not in values:
                others.add(source if source.startswith("self.") else _ANYTHING)
            elif source not in seen:
                seen.add(source)
                waiting.append(source)
    return others


def _values(part: facts.Base) -> list[facts.Base]:
    targets = {Itself(target) for target in part.assigned}
    body = {Itself(statement) for statement in part.statements}
    return [child for child in part.children() if Itself(child) not in targets | body]


__all__ = ["SureRead", "sure_reads"]

"""A name that a launch file in Python reads and nothing defines: a NameError before anything is started."""

from __future__ import annotations

import builtins
from collections.abc import Iterator, Sequence

from archlint.syntax import facts
from archlint.syntax.bindings import names_bound
from archlint.syntax.control_flow import graph_of
from archlint.syntax.flow_blocks import Block, Kind, reach, without_exceptions
from archlint.syntax.parts import everything_in

_ALWAYS = frozenset(dir(builtins)) | {"__file__", "__name__", "__doc__", "__package__", "__spec__", "__loader__"}


def undefined_name(module: facts.Facts, function: str) -> facts.Name | None:
    """The first name that a module, or a ``function`` of it, surely reads and that no line of the file binds."""
    if _may_bind_anything(module.body):
        return None
    bound = _ALWAYS.union(names_bound(module.body))
    functions = (
        statement.body
        for statement in module.body
        if isinstance(statement, facts.Function) and statement.name == function
    )
    return next((name for body in (module.body, *functions) for name in _read(body) if name.id not in bound), None)


_MAKES_NAMES = frozenset({"exec", "globals", "vars", "setattr"})


def _may_bind_anything(body: Sequence[facts.Stmt]) -> bool:
    stars = (name == "*" for statement in everything_in(body, facts.ImportFrom) for name, _ in statement.names)
    makers = (variable.id in _MAKES_NAMES for variable in everything_in(body, facts.Name))
    return any(stars) or any(makers) or any(True for _ in everything_in(body, facts.Opaque))


def _read(body: Sequence[facts.Stmt]) -> Iterator[facts.Name]:
    """The names that a body reads whatever happens, and where nothing catches a NameError."""
    graph = graph_of(body)
    for block in graph.blocks:
        caught = reach([edge.target for edge in block.edges if edge.kind is Kind.RAISE]) - {graph.raised}
        if caught.isdisjoint(graph.exits) and graph.post_dominates([block], graph.entry, without_exceptions):
            for part in _evaluated(block):
                yield from _names(part)


def _evaluated(block: Block) -> Sequence[facts.Base | None]:
    """What a statement, or the head of one, evaluates first of all."""
    match block.fact:
        case facts.Assign() | facts.Annotated() | facts.Augmented() | facts.Expression() | facts.Return() as statement:
            return [statement.value]
    match block.statement:
        case facts.Function(params=params, decorators=decorators):
            return [*decorators, *(param.default for param in params)]
    return [] if block.fact is block.statement else [block.fact]


def _names(value: facts.Base | None) -> Iterator[facts.Name]:
    """The names in an expression that are looked up whenever it is evaluated, in the order of the source."""
    stack: list[facts.Base] = [] if value is None else [value]
    while stack:
        part = stack.pop()
        match part:
            case facts.Name():
                yield part
            case facts.Conditional(test=first) | facts.Boolean(values=[first, *_]):
                stack.append(first)
            case facts.Lambda() | facts.Comprehension() | facts.Yield() | facts.Await():
                pass  # they run later, or their names are their own
            case _:
                stack.extend(reversed(part.children()))

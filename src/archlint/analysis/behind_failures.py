"""Code to which no run comes, since a line before it always raises an exception."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.analysis.source_code import code_of
from archlint.place import Place
from archlint.syntax import facts
from archlint.syntax.control_flow import graph_of
from archlint.syntax.flow_blocks import Block, Edge, Kind, reach
from archlint.syntax.flow_facts import covers, holds
from archlint.syntax.parts import Itself, everything_in, parts_of

if TYPE_CHECKING:
    from archlint.syntax.flow_graph import Graph
    from archlint.systems.model import WorkspaceIndex

_SWALLOWS = frozenset({"suppress", "raises", "assertRaises"})
"""Contexts behind which code goes on whatever was raised in them."""


class BehindFailures:
    """What no run comes to, where what stands at some places raises an exception whenever it is evaluated."""

    def __init__(self, workspace: WorkspaceIndex, failing: Iterable[Place]) -> None:
        by_file: dict[str, list[facts.Span]] = {}
        for place in failing:
            by_file.setdefault(place.file, []).append(place.span)
        self._workspace, self._failing = workspace, by_file
        self._lines = {file: [*_skipped(workspace, file, spans)] for file, spans in by_file.items()}
        self._functions = {
            file: [*_called_from(workspace, file, parts)] for file, parts in self._lines.items() if parts
        }

    def skips(self, place: Place) -> bool:
        """Whether all ways to a place lead past one that fails."""
        return self.leaves_out(place) or _covered(self._lines.get(place.file, ()), place)

    def is_never_left(self, handler: Place) -> bool:
        """Whether an ``except``, by its place, always fails itself, so that nothing behind it runs."""
        spans = [span for span in self._failing.get(handler.file, ()) if holds(handler.span, span)]
        body = code_of(self._workspace).body_at(handler) if spans else ()
        attempts = (attempt for attempt in parts_of(body, facts.Try))
        around = (each for attempt in attempts for each in attempt.handlers if each.span == handler.span)
        simple = [statement for each in around for statement in each.body if not statement.blocks]
        return any(covers(statement, span) and _is_sure(statement, span) for statement in simple for span in spans)

    def leaves_out(self, place: Place) -> bool:
        """Whether a place is in a function that is called behind such places alone."""
        return _covered(self._functions.get(place.file, ()), place)


def _covered(parts: Iterable[facts.Base], place: Place) -> bool:
    return any(covers(part, place.span) for part in parts)


def _skipped(workspace: WorkspaceIndex, file: str, failing: Sequence[facts.Span]) -> Iterator[facts.Base]:
    """The parts of a file that are not reached in the code around what fails."""
    code = code_of(workspace)
    ending: dict[Itself[Sequence[facts.Stmt]], set[Block]] = {}
    for span in failing:
        body = code.body_at(Place(file, *span))
        if body and not _is_swallowed(body, span):
            sure = (block for block in graph_of(body).evaluating(span) if _is_sure(block.fact, span))
            ending.setdefault(Itself(body), set()).update(sure)
    for known, blocks in ending.items():
        yield from _behind(graph_of(known.fact), known.fact, blocks)


def _behind(graph: Graph, body: Sequence[facts.Stmt], ending: set[Block]) -> Iterator[facts.Base]:
    """What a piece of code evaluates in no run if some of its blocks do nothing but raise."""
    missed = _missed(graph, body)
    reached = reach([graph.entry], lambda edge: edge.source not in ending and not _is_of_head(edge))
    landed: set[Block] = set()
    while new := (ending & reached) - landed:
        landed |= new
        raised = [edge.target for block in new for edge in block.edges if edge.kind is Kind.RAISE]
        starts = [target for each in raised for target in ([] if each in reached else _landing(each, missed))]
        reached |= reach(starts, lambda edge: edge.source not in ending and not _is_of_head(edge), avoiding=reached)
    known = {Itself(part) for block in reached for part in _evaluated(block)}
    for block in graph.blocks:
        if block not in reached:
            yield from (part for part in _evaluated(block) if Itself(part) not in known)


_OTHER_FAILURES = frozenset(
    {
        *("ConnectionError", "ConnectionRefusedError", "EOFError", "ExternalShutdownException", "FileExistsError"),
        *(
            "FileNotFoundError",
            "IOError",
            "ImportError",
            "IsADirectoryError",
            "KeyboardInterrupt",
            "ModuleNotFoundError",
        ),
        *("OSError", "PermissionError", "SerialException", "SystemExit", "TimeoutError", "TransformException"),
        *("YAMLError", "ZeroDivisionError"),
    }
)
"""What no line raises by mistake: an ``except`` for these misses what a wrong name or argument raises."""
_MODULES = frozenset({"rclpy", "executors", "serial", "socket", "tf2_ros", "yaml"})


def _missed(graph: Graph, body: Sequence[facts.Stmt]) -> set[Block]:
    """The blocks with which those handlers begin to which no mistake leads."""
    handlers = (handler for attempt in parts_of(body, facts.Try) for handler in attempt.handlers)
    missing = (each for each in handlers if each.body and each.caught and each.caught <= _OTHER_FAILURES | _MODULES)
    return {block for handler in missing for block in graph.of(handler.body[0])}


def _is_of_head(edge: Edge) -> bool:
    """Whether an exception would come from ``try:`` itself, which does nothing."""
    return edge.kind is Kind.RAISE and edge.source.fact is None and isinstance(edge.source.statement, facts.Try)


def _landing(raised: Block, missed: set[Block]) -> Iterator[Block]:
    """Where code goes on after a mistake that leads to a block."""
    if all(edge.target not in missed for edge in raised.edges):
        yield raised
        return
    for edge in raised.edges:
        if edge.kind is Kind.RAISE:
            yield from _landing(edge.target, missed)
        elif edge.target not in missed:
            yield edge.target


def _evaluated(block: Block) -> Iterator[facts.Base]:
    """What a block evaluates, or the function or class that it defines: a ``finally`` has a block for each way out."""
    if block.fact is not None:
        yield block.fact
    elif block.statement is not None and (block.statement.is_scope or not block.statement.blocks):
        yield block.statement


def _is_swallowed(body: Sequence[facts.Stmt], span: facts.Span) -> bool:
    """Whether code goes on after what is raised at a place."""
    around = (part for part in parts_of(body, facts.With) if covers(part, span))
    calls = (item.value for part in around for item in part.items if isinstance(item.value, facts.Call))
    return any(call.func.last_name in _SWALLOWS for call in calls)


def _is_sure(fact: facts.Base | None, span: facts.Span) -> bool:
    """Whether what stands at a place is evaluated whenever a fact is: it is in no lambda, and not behind ``and``."""
    doubtful = (part for each in everything_in([] if fact is None else [fact]) for part in _not_always(each))
    return not any(covers(part, span) for part in doubtful)


def _not_always(part: facts.Base) -> Sequence[facts.Base]:
    """What of an expression need not be evaluated with it."""
    match part:
        case facts.Lambda(body=body):
            return [body]
        case facts.Conditional(body=body, orelse=orelse):
            return [body, orelse]
        case facts.Boolean(values=[_, *others]) | facts.Compare(comparators=[_, *others]):
            return others
        case facts.Comprehension(generators=[first, *_]):
            return [child for child in part.children() if child is not first] + first.conditions
    return []


def _called_from(workspace: WorkspaceIndex, file: str, parts: Sequence[facts.Base]) -> Iterator[facts.Function]:
    """The functions at the top of a file, no program itself, that are called in parts of it which are not reached, and
    nowhere else."""
    code = workspace.facts_at(file)
    if code is None or file in workspace.code.installed_programs:
        return
    skipped = [*parts]
    functions = [part for part in code.body if isinstance(part, facts.Function) and not part.decorators]
    for _ in range(_HOPS):
        called = [each for each in functions if _is_named_in(code, each.name, skipped)]
        alone = [
            each for each in called if all(other == file for other in workspace.code.files_that_mention(each.name))
        ]
        functions = [each for each in functions if all(each is not other for other in alone)]
        yield from alone
        skipped += alone


_HOPS = 3
"""How many functions that call each other are looked through."""


def _is_named_in(code: facts.Facts, name: str, parts: Sequence[facts.Base]) -> bool:
    """Whether a file names a function in some parts of it, and in no other."""
    uses = [use for use in everything_in(code.body, facts.Name) if use.id == name]
    return bool(uses) and all(any(covers(part, use.span) for part in parts) for use in uses)


__all__ = ["BehindFailures"]

"""Local variables that are read where nothing has given them a value: an UnboundLocalError.

Either no way leads to the read past an assignment, or the one in a ``try`` fails and its ``except`` goes on there, or
a branch without one does (``branch_values.py``).
"""

from __future__ import annotations

import builtins
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Literal

from archlint.analysis.kept import kept_for_each_file
from archlint.analysis.source_code import code_of
from archlint.place import Place
from archlint.python_code.block_bindings import after, bound_at, is_plain, read_at
from archlint.python_code.branch_values import Reading, past_branch
from archlint.python_code.likely_failures import failing_before
from archlint.python_code.offered_names import bound_in, makers_in, makers_of_names, own_names, stars
from archlint.python_code.raising_helpers import is_caught_inside, never_returns
from archlint.records import dataclass
from archlint.syntax import facts
from archlint.syntax.control_flow import graph_of
from archlint.syntax.flow_blocks import Block, Edge, Kind, reach, without_exceptions
from archlint.syntax.flow_facts import covers
from archlint.syntax.parts import Itself, everything_in, parts_of, targets_in

if TYPE_CHECKING:
    from archlint.syntax.flow_graph import Graph
    from archlint.systems.model import WorkspaceIndex

_ENDS = frozenset(
    {
        "BaseException",
        "ExternalShutdownException",
        "GeneratorExit",
        "KeyboardInterrupt",
        "ROSInterruptException",
        "SystemExit",
    }
)
"""What ends a program, at any place: whoever catches it cares for nothing else.  No constructor of a node raises it."""
_OPTIONAL = frozenset({"ImportError", "ModuleNotFoundError", "NameError", "UnboundLocalError"})


WayOut = Literal["continue", "raise", "return"]


@dataclass(frozen=True)
class UnboundLocal:
    """A read of a variable of a function before it has a value; ``caught`` is the ``except`` that leads to it, if the
    variable has one otherwise."""

    place: Place
    name: str
    assigned: Place
    caught: Place | None = None
    failing: int = 0
    """The line whose failure leads to that ``except``."""
    way_out: WayOut = "return"
    """How the code leaves that ``except`` without coming to the read."""
    branch: Place | None = None
    """Where the branch begins that leads to it without a value, if the others have given the variable one."""
    hidden: str = ""
    """What of the file has the same name, if it is a class or a function: nobody can mean it in this function."""
    own_assignment: bool = False
    """Whether the assignment that comes first reads it: ``first = first[0]``."""
    of_file: bool = False
    """Whether the file has a variable of that name, which the function does not declare ``global``."""


@dataclass(frozen=True)
class _Row:
    name: str
    span: facts.Span
    assigned: facts.Span
    caught: facts.Span | None = None
    failing: int = 0
    way_out: WayOut = "return"
    branch: facts.Span | None = None
    hidden: str = ""
    own_assignment: bool = False
    of_file: bool = False


def unbound_locals(workspace: WorkspaceIndex) -> Iterator[UnboundLocal]:
    """Every such read in the files that were asked for: the first of each variable."""
    for file, _ in workspace.code.judged():
        path = file.relative
        if file.kind not in ("python", "launch_python") or workspace.roles.is_test(path):
            continue
        for row in _rows(workspace, path) or ():
            caught = None if row.caught is None else Place(path, *row.caught)
            if caught is not None and _never_goes_on(workspace, Place(path, *row.span), caught):
                continue
            if row.branch is not None and _branch_never_goes_on(workspace, Place(path, *row.span), row.branch):
                continue
            assigned = Place(path, *row.assigned)
            read = Place(path, *row.span)
            branch = None if row.branch is None else Place(path, *row.branch)
            yield UnboundLocal(
                read,
                row.name,
                assigned,
                caught,
                row.failing,
                row.way_out,
                branch,
                row.hidden,
                row.own_assignment,
                row.of_file,
            )


def _never_goes_on(workspace: WorkspaceIndex, read: Place, caught: Place) -> bool:
    """Whether a handler calls what always raises, ``except OSError as error: give_up(error)``, so that it goes on to no
    read behind it, or has nothing to handle, since what is tried calls what handles the same itself."""
    function = code_of(workspace).function_at(read)
    if function is None:
        return False
    ends = never_returns(workspace, read.file, function)
    return any(
        any(map(ends, handler.body)) or is_caught_inside(workspace, read.file, function, attempt, handler)
        for attempt in parts_of(function.body, facts.Try)
        for handler in attempt.handlers
        if handler.span == caught.span
    )


def _branch_never_goes_on(workspace: WorkspaceIndex, read: Place, branch: facts.Span) -> bool:
    """Whether a branch that begins at a place calls what always raises."""
    function = code_of(workspace).function_at(read)
    if function is None:
        return False
    ends = never_returns(workspace, read.file, function)
    chains = parts_of(function.body, facts.If)
    bodies = (body for chain in chains for body in (chain.body, chain.orelse) if body and branch == _span(body[0]))
    return any(map(ends, (part for body in bodies for part in parts_of(body))))


def _span(statement: facts.Stmt) -> facts.Span | None:
    return None if isinstance(statement, facts.Global) else statement.span


@kept_for_each_file
def _rows(code: facts.Facts) -> list[_Row]:
    known = None if stars(code) or makers_of_names(code) else own_names(code).union(dir(builtins))
    rows = [row for function in _functions(code) for row in _in_function(function, known)]
    hidden, variables = (_defined_in(code), _variables_of(code)) if rows else ({}, frozenset())
    return [
        row
        if row.caught or row.branch
        else replace(row, hidden=hidden.get(row.name, ""), of_file=row.name in variables)
        for row in rows
    ]


def _functions(code: facts.Facts) -> Iterator[facts.Function]:
    """The functions of a file but for those that ask which variables there are: ``'voltage' in locals()``."""
    for function in everything_in(code.body, facts.Function):
        if not makers_of_names(code) or not makers_in(function.body):
            yield function


def _defined_in(code: facts.Facts) -> dict[str, str]:
    """What the classes and functions of a file are, by their names."""
    classes = {part.name: "class" for part in code.body if isinstance(part, facts.Class)}
    return {part.name: "function" for part in code.body if isinstance(part, facts.Function)} | classes


def _variables_of(code: facts.Facts) -> frozenset[str]:
    """The variables that a file has: what it assigns outside of functions, or in one that declares it ``global``."""
    rows = (part for part in everything_in(code.body, facts.Global) if part.kind == "global")
    declared = frozenset(name for part in rows for name in part.names)
    targets = (target for part in parts_of(code.body, facts.Statement) for target in part.assigned)
    return declared.union(name for target in targets for each in targets_in(target) if (name := each.variable))


def _in_function(function: facts.Function, known: frozenset[str] | None) -> Iterator[_Row]:
    """The first such read of each variable; ``known`` are the names that the file can read, None for any."""
    graph = graph_of(function.body)
    bound = _bound(function, graph)
    reads: dict[str, list[Reading]] = {}
    attempts = parts_of(function.body, facts.Try) if bound else ()
    expected = {part for attempt in attempts for part in _expected(attempt)}
    for block in graph.blocks if bound else ():
        names = ((part, surely) for part, surely in read_at(block) if isinstance(part, facts.Name))
        for read, surely in sorted(names, key=lambda row: row[0].span):
            if read.id in bound and Itself[facts.Base](read) not in expected:
                reads.setdefault(read.id, []).append((block, read, surely))
    for name, rows in reads.items():
        blocks = [block for block, _ in bound[name]]
        first = bound[name][0][1]
        early = _never_before(blocks, rows)
        if early is not None:
            statement = bound[name][0][0].statement
            own = isinstance(statement, facts.Assign) and covers(statement, early.span)
            yield _Row(name, early.span, first, own_assignment=own)
            continue
        for attempt in parts_of(function.body, facts.Try):
            told = _told_elsewhere(function, attempt)
            caught = _past_handler(
                graph, attempt, blocks, [row for row in rows if Itself[facts.Base](row[1]) not in told]
            )
            if caught is not None and _is_defined(caught[1], function, known):
                tried = graph.inside(attempt.body)
                assigned = next(span for block, span in bound[name] if block in tried)
                read, handler, failing = caught
                way_out = _way_out(function, attempt, read)
                yield _Row(name, read.span, assigned, handler.span, failing, way_out)
                break
        else:
            left = past_branch(graph, function, blocks, rows)
            if left is not None:
                yield _Row(name, left[0].span, min(span for _, span in bound[name]), branch=left[1])


def _way_out(function: facts.Function, attempt: facts.Try, read: facts.Name) -> WayOut:
    """How an ``except`` of an attempt leaves out what comes to a read: a loop goes round once more, and no constructor
    returns before the object is whole."""
    loops = (part for part in parts_of(function.body) if isinstance(part, facts.For | facts.While))
    inside = ({Itself(part) for part in parts_of(loop.body)} for loop in loops)
    if any(Itself[facts.Base](attempt) in parts and Itself[facts.Base](read) in parts for parts in inside):
        return "continue"
    return "raise" if function.name == "__init__" else "return"


def _expected(attempt: facts.Try) -> Iterator[Itself[facts.Base]]:
    """What is tried by somebody who expects that a variable has no value, or to whom all is one."""
    if any(handler.caught & _OF_NAMES or _is_silent(handler) for handler in attempt.handlers):
        yield from map(Itself, everything_in(attempt.body))


def _told_elsewhere(function: facts.Function, attempt: facts.Try) -> set[Itself[facts.Base]]:
    """What other attempts of a function try that catch whatever happens: where an earlier one has failed, they say that
    they have, too."""
    return {
        Itself(part)
        for other in parts_of(function.body, facts.Try)
        if any(handler.type is None or handler.caught & _ANYTHING for handler in other.handlers)
        if all(part is not attempt for part in everything_in([other]))
        for part in everything_in(other.body)
    }


_ANYTHING = frozenset({"BaseException", "Exception"})
_OF_NAMES = frozenset({"NameError", "UnboundLocalError"})


def _is_silent(handler: facts.Handler) -> bool:
    """``except: pass``, be it for ``Exception``."""
    does_nothing = all(isinstance(statement, facts.Jump) and statement.kind == "pass" for statement in handler.body)
    return does_nothing and (handler.type is None or not handler.caught.isdisjoint({"Exception", "BaseException"}))


def _bound(function: facts.Function, graph: Graph) -> dict[str, list[tuple[Block, facts.Span]]]:
    """Where each local variable of a function is bound."""
    others = {param.name for param in function.params}
    others.update(name for part in parts_of(function.body, facts.Global) for name in part.names)
    bound: dict[str, list[tuple[Block, facts.Span]]] = {}
    unclear: set[str] = set()
    for block in graph.blocks:
        for part in bound_at(block):
            match part:
                case facts.Name(id=name, span=span) if name not in others:
                    bound.setdefault(name, []).append((block, span))
                case facts.Import(module=module, alias=alias):
                    unclear.add(alias or module.partition(".")[0])
                case facts.ImportFrom(names=names):
                    unclear.update(name for _, name in names)
                case facts.Function(name=str(name)) | facts.Class(name=str(name)):
                    unclear.add(name)
                case facts.Handler(name=str(name)) | facts.Pattern(name=str(name)):
                    unclear.add(name)
    inner = (part for part in parts_of(function.body, facts.Function))
    unclear.update(name for each in inner for part in everything_in(each.body, facts.Global) for name in part.names)
    return {name: rows for name, rows in bound.items() if name not in unclear and not _is_only_added_to(rows)}


def _is_only_added_to(rows: Sequence[tuple[Block, facts.Span]]) -> bool:
    """Whether `+=` is all that binds a variable: of such ones all reads are wrong."""
    return all(isinstance(block.statement, facts.Augmented) for block, _ in rows)


def _never_before(bound: Collection[Block], rows: Collection[Reading]) -> facts.Name | None:
    """The first read to which no way leads past an assignment."""
    later = after(bound)
    for block, name, _ in rows:
        if block not in later and (block not in bound or is_plain(block)):
            return name
    return None


def _past_handler(
    graph: Graph, attempt: facts.Try, bound: Collection[Block], rows: Sequence[Reading]
) -> tuple[facts.Name, facts.Handler, int] | None:
    """The read to which a handler surely leads, where what it handles keeps the variable from its only assignment, and
    the line that fails then."""
    tried = graph.inside(attempt.body)
    inside = [block for block in bound if block in tried]
    starts = graph.of(attempt)
    failing = failing_before(inside, tried)
    if not inside or not starts or failing is None:
        return None
    before = _onward([edge.target for block in bound for edge in block.edges if _goes_on(edge)])
    if any(start in before for start in starts):
        return None
    reading = {block: name for block, name, surely in reversed(rows) if surely and block not in tried}
    final = graph.inside(attempt.final)
    for handler in attempt.handlers:
        if not handler.body or not handler.caught or handler.caught & (_ENDS | _OPTIONAL):
            continue  # a bare one is for Ctrl-C, too
        for start in graph.of(handler.body[0]):
            read = _surely_read(graph, start, bound, reading)
            if read is not None and read not in final:
                return reading[read], handler, failing
    return None


def _is_defined(handler: facts.Handler, function: facts.Function, known: frozenset[str] | None) -> bool:
    """Whether something defines the classes that a handler asks for: otherwise it does not go on, but fails itself."""
    if known is None or handler.type is None:
        return True
    names = {part.id for part in everything_in([handler.type], facts.Name)}
    return names <= known.union(bound_in(function.body), (param.name for param in function.params))


def _surely_read(
    graph: Graph, start: Block, bound: Collection[Block], reading: Mapping[Block, facts.Name]
) -> Block | None:
    """The block, of some, that every way from another one on comes to first, with no assignment before."""
    clear = reach([start], without_exceptions, avoiding=reading)
    if not clear.isdisjoint(graph.exits) or not clear.isdisjoint(bound):
        return None
    edges = [edge for block in clear for edge in block.edges if without_exceptions(edge)]
    if any(edge.kind is not Kind.NEXT for edge in edges):
        return None  # round a loop, or out of the function
    reads = [edge.target for edge in edges if edge.target in reading]
    return min(reads, key=lambda block: reading[block].span, default=None)


def _goes_on(edge: Edge) -> bool:
    return edge.kind is not Kind.BACK


def _onward(starts: Collection[Block]) -> set[Block]:
    return reach(starts, _goes_on)


__all__ = ["UnboundLocal", "unbound_locals"]

"""Waits for threads that wait for a response themselves: it cannot come before the wait for them is over."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.analysis.kept import once
from archlint.analysis.order import dominates
from archlint.analysis.reach import argument, has_limit, judged_calls
from archlint.analysis.source_code import SourceCode, source_code
from archlint.branches import ChoiceOfCallee
from archlint.execution.blocking import CALL
from archlint.execution.callback_roles import runs_in_executor
from archlint.execution.deadlock import Verdict, judge_wait
from archlint.execution.spins import is_spin_call, is_spun_in_sight
from archlint.execution.waits import Wait, waits
from archlint.finding import Place
from archlint.model import Role
from archlint.model.given import Constant, Object
from archlint.records import dataclass
from archlint.syntax import facts
from archlint.syntax.flow_facts import covers
from archlint.syntax.parts import everything_in

if TYPE_CHECKING:
    from archlint.model import ApiCall, Callback, Program
    from archlint.systems.model import System

_JOINS = frozenset({"threading.Thread.join", "threading.Timer.join", "concurrent.futures.Future.result"})
_POOL = "concurrent.futures.ThreadPoolExecutor"
_SUBMIT, _MAP, _SHUTDOWN = f"{_POOL}.submit", f"{_POOL}.map", f"{_POOL}.shutdown"
_GIVES = frozenset({_SUBMIT, _MAP})
"""The calls that give a pool something to do; they wait only where the code around them does."""
_OF_SEVERAL = frozenset({"concurrent.futures.wait", "concurrent.futures.as_completed"})
_COLLECTS = frozenset({"list", "tuple", "set", "sorted", "sum", "dict", "any", "all", "max", "min", "enumerate", "zip"})
_AT_START = (Role.INIT, Role.MAIN, Role.MODULE)


@dataclass(frozen=True)
class JoinedWait:
    """A wait for a thread, and what that thread waits for."""

    join: ApiCall
    thread: Callback
    wait: Wait
    program: Program
    limited: bool
    """Whether a timeout ends the wait for the thread, or that of the thread."""

    def verdict(self, distros: Sequence[str]) -> Verdict:
        """What becomes of it where a callback waits for the thread, and so for what the thread waits for."""
        call = replace(self.wait.call, context=self.join.context)
        return judge_wait(CALL, call, self.wait.client, self.program, self.limited, distros)


def stuck_joins(system: System, distros: Sequence[str]) -> list[JoinedWait]:
    """The waits for threads that keep out the response which the thread waits for."""
    return [row for row in joined_waits(system) if _is_stuck(row, distros)]


def _is_stuck(row: JoinedWait, distros: Sequence[str]) -> bool:
    if runs_in_executor(row.join.context):
        verdict = row.verdict(distros)
        return not verdict.safe and not verdict.unknown
    program, node = row.program, row.wait.client.node
    known = program.executable and not program.exhausted and row.join.context.role in _AT_START
    return known and is_spun_in_sight(node) and not any(use.in_thread for use in program.executors_of(node))


@once
def joined_waits(system: System) -> list[JoinedWait]:
    """The waits for threads that are made just before, and wait for a response for certain."""
    by_thread: dict[int, list[Wait]] = {}
    for wait in waits(system):
        if wait.kind == CALL and wait.call.context.role == Role.THREAD and _is_certain(wait.call):
            by_thread.setdefault(id(wait.call.context), []).append(wait)
    rows = [row for program, call in judged_calls(system) for row in _of_join(system, program, call, by_thread)]
    joined = {id(row.thread) for row in rows if row.join.api not in _GIVES}
    rows = [row for row in rows if row.join.api not in _GIVES or id(row.thread) not in joined]
    return sorted(rows, key=lambda row: (row.join.place, row.wait.call.place))


def _is_certain(call: ApiCall) -> bool:
    """Whether a thread makes a call whatever holds: with one of several clients that it is given, or always."""
    return all(isinstance(branch, ChoiceOfCallee) for branch, _ in call.branch_arms)


def _of_join(system: System, program: Program, join: ApiCall, by_thread: dict[int, list[Wait]]) -> Iterator[JoinedWait]:
    if join.context.is_async or not (made_at := _made_at(system, program, join)):
        return
    threads = [thread for thread in program.callbacks if thread.role == Role.THREAD and thread.registered in made_at]
    if not threads or not all(_is_made_here(system, program, join, thread.registered) for thread in threads):
        return
    waiting = [by_thread.get(id(thread), []) for thread in threads]
    if all(waiting):
        limited = has_limit(join, "timeout") or waiting[0][0].limited
        yield JoinedWait(join, threads[0], waiting[0][0], program, limited)


def _made_at(system: System, program: Program, join: ApiCall) -> Sequence[Place]:
    """Where the threads are made that a call waits for; nothing where one is not known, or it waits for none."""
    code = source_code(system)
    if join.api in _GIVES:
        waits = _ends_its_pool(code, join) or (join.api == _MAP and _is_gone_through(code, join))
        return (join.place,) if waits else ()
    if join.api == _SHUTDOWN:
        return _given_to_its_pool(program, join) if argument(join, "wait") in (None, Constant(True)) else ()
    if join.api in _OF_SEVERAL:
        return _futures_of(code, program, join)
    if join.api not in _JOINS or join.receiver is None:
        return ()
    places = [option.place if isinstance(option, Object) else None for option in join.receiver.alternatives]
    return [place for place in places if place is not None] if None not in places else ()


def _given_to_its_pool(program: Program, shutdown: ApiCall) -> Sequence[Place]:
    """What the same callback or program has given a pool that it shuts down."""
    pool = shutdown.receiver
    if not isinstance(pool, Object) or pool.place is None:
        return ()
    calls = (call for call in program.calls if call.api in _GIVES and call.context is shutdown.context)
    return [call.place for call in calls if isinstance(call.receiver, Object) and call.receiver.place == pool.place]


def _futures_of(code: SourceCode, program: Program, join: ApiCall) -> Sequence[Place]:
    """Where the futures come from that ``wait()`` is given: a list that is written there or assigned to a variable."""
    given = code.arguments(join)
    if not given or given[0].star or given[0].keyword not in (None, "fs"):
        return ()
    held: list[facts.Base] = [given[0].value]
    if name := given[0].value.variable:
        held = [part.value for part in _assigning(code.body(join), name)]
    spans = {call.span for part in held for call in everything_in(part, facts.Call)}
    return [
        call.place
        for call in program.calls
        if call.api == _SUBMIT and call.file == join.file and call.place.span in spans and call.context is join.context
    ]


def _assigning(body: Sequence[facts.Stmt], name: str) -> Iterator[facts.Assign]:
    for part in everything_in(body, facts.Assign):
        if any(target.variable == name for target in part.targets):
            yield part


def _is_gone_through(code: SourceCode, given: ApiCall) -> bool:
    """Whether the results of ``pool.map()`` are taken where it stands, or by way of a variable."""
    body = code.body(given)
    taken: list[facts.Base] = []
    for part in everything_in(body):
        match part:
            case facts.For(iterable=iterable) | facts.Generator(iterable=iterable):
                taken.append(iterable)
            case facts.Call(func=facts.Name(id=name), args=args) if name in _COLLECTS:
                taken += [argument.value for argument in args]
            case facts.Starred(value=value):
                taken.append(value)
    names = {part.variable for part in taken if isinstance(part, facts.Name)}
    results = [part.value for name in names for part in _assigning(body, name)]
    return any(isinstance(part, facts.Call) and part.span == given.place.span for part in (*taken, *results))


def _ends_its_pool(code: SourceCode, submit: ApiCall) -> bool:
    """Whether a ``with`` around a call makes the pool that it is of: at its end it waits for the threads."""
    pool = submit.receiver
    if not isinstance(pool, Object) or pool.place is None:
        return False
    around = [block for block in everything_in(code.body(submit), facts.With) if covers(block, submit.place.span)]
    return any(
        isinstance(item.value, facts.Call) and Place.of(submit.file, item.value.span) == pool.place
        for block in around
        for item in block.items
    )


def _is_made_here(system: System, program: Program, join: ApiCall, made_at: Place | None) -> bool:
    """Whether the function that waits for a thread makes it first, and nothing spins between: one that was made before
    may be over."""
    if made_at is None or made_at.file != join.place.file:
        return False
    begin, end = join.place.span[:2], join.place.span[2:]
    inside = begin <= made_at.span[:2] and made_at.span[2:] <= end
    return inside or (
        dominates(source_code(system), made_at, join.place) and not _spins_between(program, made_at, join)
    )


def _spins_between(program: Program, made_at: Place, join: ApiCall) -> bool:
    """Whether the function may spin after it has made a thread: then the thread gets its response."""
    places = [frame.place for call in program.calls if is_spin_call(call) for frame in call.chain]
    places += [call.place for call in program.calls if is_spin_call(call)]
    return any(place.file == join.file and made_at < place < join.place for place in places)


__all__ = ["JoinedWait", "stuck_joins"]

"""EXE009 and EXE002: waits for threads that wait for what these waits keep out."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.reach import endpoint_words, node_name, related_creation
from archlint.checks.registry import Options, finding
from archlint.checks.wait_words import kind_of, name_of, when_done
from archlint.execution.blocking import Outcome
from archlint.execution.callback_roles import callback_words, related_to, runs_in_executor
from archlint.execution.joined_threads import JoinedWait, stuck_joins
from archlint.finding import Finding, Related

if TYPE_CHECKING:
    from archlint.systems.model import System

_AT_START = "future = ….call_async(request) and rclpy.spin_until_future_complete(node, future, timeout_sec=2.0)"


def endless_joins(system: System, options: Options) -> Iterator[Finding]:
    """What EXE009 says of the waits that nothing ends."""
    for row in stuck_joins(system, options.distros):
        if not row.limited:
            in_callback = runs_in_executor(row.join.context)
            why = row.verdict(options.distros).why if in_callback else "nothing spins its node while this thread waits"
            words = f"{_what(row)} never returns: the thread waits for {_asked(row)}, and {why}"
            yield _finding("EXE009", system, row, words)


def vain_joins(system: System, options: Options) -> Iterator[Finding]:
    """What EXE002 says of those of callbacks that always take until a timeout."""
    for row in stuck_joins(system, options.distros):
        if row.limited and runs_in_executor(row.join.context):
            words = f"{callback_words(row.join.context)} waits for a thread that waits for {_asked(row)}, and"
            verdict = row.verdict(options.distros)
            end = verdict.words if row.wait.limited else Outcome.TIMES_OUT
            yield _finding("EXE002", system, row, f"{words} {end}: {verdict.why}")


def _what(row: JoinedWait) -> str:
    """What waits for the thread: ``join()``."""
    method = row.join.api.rpartition(".")[2]
    if method == "map":
        return "what goes through the results of map()"
    return "the `with` of this pool waits for its threads and" if method == "submit" else f"{method}()"


def _asked(row: JoinedWait) -> str:
    return endpoint_words(row.wait.client, kind_of(row.wait.call))


def _finding(code: str, system: System, row: JoinedWait, message: str) -> Finding:
    join, wait = row.join, row.wait
    in_callback = runs_in_executor(join.context)
    return finding(
        code,
        join.place,
        message,
        help=when_done(join.context, wait.call, wait.client) if in_callback else _AT_START,
        related=[
            *(related_to(join, row.program) if in_callback else ()),
            Related(row.thread.registered or join.place, "the thread is made here"),
            Related(wait.call.place, "it waits for the response here"),
            *related_creation(wait.client),
        ],
        node=node_name(system, join.context.node or wait.client.node),
        identity=(join.context.name, name_of(wait.client), "join"),
    )


__all__ = ["endless_joins", "vain_joins"]

"""TMO006: results that are used before it is known whether they have arrived."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.analysis.reach import (
    argument,
    creations_of,
    endpoint_words,
    node_name,
    one_for_each_place,
    related_creation,
)
from archlint.checks.folding import folds, with_others
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.checks.uncalled import unless_uncalled
from archlint.checks.wait_words import name_of, related_path
from archlint.execution.callback_roles import may_run_in_executor, runs_in_executor
from archlint.execution.early_results import EarlyResult, early_results
from archlint.execution.unchecked_results import UncheckedResult, unchecked_results
from archlint.finding import Finding, Place, Related
from archlint.python_code.mistaken_futures import function_of, mistaken_futures, returned_at
from archlint.python_code.spin_results import tested_spins

if TYPE_CHECKING:
    from archlint.model import MistakenFuture
    from archlint.systems.model import System


_IN_A_DONE_CALLBACK = "read it in a done callback: future.add_done_callback(…), and there future.result()"
_WAIT_FIRST = "wait for it first: rclpy.spin_until_future_complete(node, future, timeout_sec=5.0)"


@rule("TMO006", scope=Scope.CODE)
def unchecked_result(system: System, options: Options) -> Iterator[Finding]:
    """Results that may not be there, or cannot be there yet."""
    early = early_results(system)
    # EXE002 tells of those that a callback reads, whoever else comes there: a spin would run inside the callback.
    in_callbacks = {result.call.place for result in early if runs_in_executor(result.call.context)}
    yield from one_for_each_place(
        (
            *(_unchecked(system, use) for use in unchecked_results(system)),
            *(_too_early(system, result) for result in early if result.call.place not in in_callbacks),
            *(told for use in mistaken_futures(system) for told in unless_uncalled(system, _mistaken(system, use))),
            *(map(_tested, tested_spins(system.workspace)) if system.workspace is not None else ()),
        )
    )


def _tested(place: Place) -> Finding:
    return finding(
        "TMO006",
        place,
        "spin_until_future_complete() returns None, whatever becomes of the future: asking for it decides nothing",
        help="call it, and then ask future.done()",
        identity=("spin", "tested"),
    )


def _unchecked(system: System, use: UncheckedResult) -> Finding:
    call = use.spin
    clients = creations_of(argument(call, "future"))
    client = clients[0] if len({creation.place for creation in clients}) == 1 else None
    limit = argument(call, "timeout_sec")
    seconds = None if limit is None else limit.seconds
    wait = f"within {seconds:g} s" if seconds is not None else "in time"
    whose = f" from {endpoint_words(client)}" if client else ""
    read = f"reading .{use.attribute}" if use.attribute else "taking an item of it"
    return finding(
        "TMO006",
        use.place,
        f"if no response{whose} arrives {wait}, result() is None here, and {read} raises an exception",
        help="check future.done() after the wait",
        related=[Related(call.place, "the wait with a timeout"), *related_path(call, client)],
        node=node_name(system, call.context.node),
        identity=(call.function, name_of(client), "result"),
        group=(use.place.file, function_of(system, use.place), "unchecked"),
    )


def _too_early(system: System, early: EarlyResult) -> Finding:
    call = early.call
    return finding(
        "TMO006",
        call.place,
        _too_early_words(early),
        help=_IN_A_DONE_CALLBACK if may_run_in_executor(call.context) else _WAIT_FIRST,
        related=related_path(call, early.client),
        node=node_name(system, call.context.node),
        identity=(call.function, name_of(early.client), "early"),
        group=(call.place.file, call.function, "early"),
    )


def _too_early_words(early: EarlyResult) -> str:
    asked = endpoint_words(early.client)
    if early.slept:
        return f"sleeps and then reads result(): nothing takes the response from {asked} meanwhile, so it is None"
    return f"reads result() right after the request is sent: {asked} has not responded yet, so it is None"


_HELD = {
    "send_goal_async": "the handle of the goal",
    "get_result_async": "the result",
}
"""What the future of a call holds; that of any other, the response."""


def _mistaken(system: System, use: MistakenFuture) -> Finding:
    call = use.api.rpartition(".")[2]
    held = _HELD.get(call, "the response")
    return finding(
        "TMO006",
        use.place if use.attribute else returned_at(system, use),
        _what_is_wrong(use, call, held),
        help=_help(use),
        related=[
            *([] if use.sent is None else [Related(use.sent, "the future comes from this call")]),
            *related_creation(use.client),
        ],
        node=node_name(system, use.context.node),
        identity=(use.context.name, name_of(use.client), use.attribute),
        group=(use.place.file, function_of(system, use.place), "future" if use.attribute else "returned"),
    )


def _what_is_wrong(use: MistakenFuture, call: str, held: str) -> str:
    if not use.attribute:
        return (
            f"the handler of {endpoint_words(use.context.creation)} returns the future of {call}(), not a response: "
            "rclpy raises a TypeError, and the caller never gets a response"
        )
    raises = f"reading .{use.attribute} raises an AttributeError"
    if use.uncalled:
        return f"result is a method of the future, and it is not called here: {raises}"
    return f"{call}() returns a future, not {held}: {raises}"


def _help(use: MistakenFuture) -> str:
    if use.uncalled:
        return f"call it: .result().{use.attribute}"
    if not use.attribute:
        return "make the handler async and await the future; its client needs a callback group of its own"
    return _IN_A_DONE_CALLBACK if may_run_in_executor(use.context) else f"{_WAIT_FIRST}, and use future.result()"


@folds("TMO006")
def of_one_function(findings: Sequence[Finding]) -> Finding:
    """The first such line of a function, with which it ends."""
    return with_others(findings, "another line of this function does", "more lines of this function do", "the same")

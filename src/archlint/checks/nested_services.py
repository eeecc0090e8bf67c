"""SRV003: a service handler that waits for another service or action."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.checks.deadlock import AWAIT, CALL, SPIN, Verdict, judge_wait, related_executor
from archlint.checks.reach import (
    endpoint_words,
    node_name,
    related_chain,
    related_creation,
)
from archlint.checks.registry import Options, finding, rule
from archlint.checks.waits import Wait, waits
from archlint.finding import Finding, Related, Severity

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.program.model import Callback
    from archlint.system.model import System

_OTHERS_SHOWN = 5

_INSTEAD = (
    "answer from what a topic has told, or send the request with call_async(), return, and report the "
    "outcome on a topic; a task of several steps is an action"
)
_HELP = {
    CALL: f"{_INSTEAD}; if the call must stay, give the client a callback group of its own and spin the node "
    "with a MultiThreadedExecutor",
    AWAIT: "give the client a callback group of its own (callback_group=MutuallyExclusiveCallbackGroup()), "
    f"or {_INSTEAD}",
    SPIN: f"a callback cannot spin its own node: {_INSTEAD}",
}
_HELP_WHERE_SAFE = "the caller waits for both services, and a slow one makes the other slow: " + _INSTEAD


@rule("SRV003")
def nested_service_call(system: System, options: Options) -> Iterator[Finding]:
    """Waits that the handler of a service reaches; one finding a place, for the handler that is worst off."""
    judged: dict[Place, list[tuple[Wait, Verdict]]] = {}
    for wait in waits(system):
        if wait.call.context.role == "service":
            verdict = judge_wait(wait.kind, wait.call, wait.client, wait.program, wait.limited, options.distros)
            judged.setdefault(wait.call.place, []).append((wait, verdict))
    for place in sorted(judged):
        ordered = sorted(judged[place], key=_worst_first)
        yield _nested(system, *ordered[0], [wait for wait, _ in ordered[1:]])


def _worst_first(row: tuple[Wait, Verdict]) -> tuple[object, ...]:
    wait, verdict = row
    return (verdict.safe, verdict.unknown, len(wait.call.chain), wait.call.context.place, wait.call.context.name)


def _nested(system: System, wait: Wait, verdict: Verdict, others: list[Wait]) -> Finding:
    call, handler = wait.call, wait.call.context
    service = endpoint_words(handler.creation)
    found = finding(
        "SRV003",
        call.place,
        f"the handler of {service} waits for {endpoint_words(wait.client)}{_outcome(verdict)}",
        help=_HELP_WHERE_SAFE if verdict.safe else _HELP[wait.kind],
        related=[
            Related(handler.place, f"{handler.name} handles {service}"),
            *related_chain(call),
            *related_creation(wait.client),
            *related_executor(handler.node, wait.program),
            *_other_handlers(handler, others),
        ],
        node=node_name(system, handler.node),
        identity=(handler.name, wait.client.name.text or "", call.api),
    )
    return replace(found, severity=Severity.WARNING) if verdict.safe else found


def _other_handlers(first: Callback, waits: list[Wait]) -> Iterator[Related]:
    """Further handlers that reach the same call."""
    seen = {first.name}
    for wait in waits:
        handler = wait.call.context
        if handler.name not in seen and len(seen) <= _OTHERS_SHOWN:
            seen.add(handler.name)
            service = endpoint_words(handler.creation)
            yield Related(handler.place, f"{handler.name}, which handles {service}, gets there too")


def _outcome(verdict: Verdict) -> str:
    if verdict.safe:
        return f", which only stalls its callback group: {verdict.why}"
    if verdict.unknown:
        return f", which may never come: {verdict.why}"
    return f" and {verdict.words}: {verdict.why}"

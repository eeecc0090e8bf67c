"""SRV003: a service handler that waits for another service or action."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.checks.deadlock import AWAIT, CALL, SPIN, Verdict, judge_wait
from archlint.checks.reach import (
    endpoint_words,
    node_name,
    one_for_each_place,
    related_chain,
    related_creation,
)
from archlint.checks.registry import Options, finding, rule
from archlint.checks.waits import Wait, waits
from archlint.finding import Finding, Related, Severity

if TYPE_CHECKING:
    from archlint.system.model import System

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
    """Waits that the handler of a service reaches."""
    nested = [wait for wait in waits(system) if wait.call.context.role == "service"]
    yield from one_for_each_place(_nested(system, wait) for wait in nested)


def _nested(system: System, wait: Wait) -> Finding:
    call, handler = wait.call, wait.call.context
    verdict = judge_wait(wait.kind, call, wait.client, wait.program)
    service = endpoint_words(handler.creation)
    found = finding(
        "SRV003",
        call.place,
        f"the handler of {service} waits for {endpoint_words(wait.client)}: {_outcome(wait, verdict)}",
        help=_HELP_WHERE_SAFE if verdict.safe else _HELP[wait.kind],
        related=[
            Related(handler.place, f"{handler.name} handles {service}"),
            *related_chain(call),
            *related_creation(wait.client),
        ],
        node=node_name(system, handler.node),
        identity=(handler.name, wait.client.name.text or "", call.api),
    )
    return replace(found, severity=Severity.WARNING) if verdict.safe else found


def _outcome(wait: Wait, verdict: Verdict) -> str:
    if verdict.safe:
        return f"{verdict.why}, and so it only blocks"
    if wait.kind == CALL and wait.limited:
        return f"{verdict.why} before the time is up"
    return verdict.why

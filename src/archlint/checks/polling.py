"""SRV004: services that are asked again and again."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.analysis.reach import (
    calls_of,
    endpoint_words,
    node_name,
    one_for_each_place,
    related_chain,
    related_creation,
)
from archlint.analysis.source_code import source_code
from archlint.checks.folding import folds, with_others
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.connections.request_uses import (
    Overrun,
    answer_fields,
    is_command,
    is_own,
    overrun,
    sends_measures,
    tells_only_success,
)
from archlint.execution.callback_roles import callback_words, related_to, runs_in_executor
from archlint.execution.polling import sends_the_same
from archlint.execution.request_paces import RequestPace, pace_of_request
from archlint.finding import Finding, Related
from archlint.model import EntityKind

if TYPE_CHECKING:
    from archlint.model import ApiCall, Creation, Program
    from archlint.systems.model import System

_REQUESTS = ("rclpy.client.Client.call", "rclpy.client.Client.call_async")
_Said = tuple[str, str, tuple[Related, ...]]
"""What a finding says after who sends to what; what to do; and where else to look."""


@rule("SRV004", scope=Scope.AS_LAUNCHED, rate=1.0)
def service_for_continuous_data(system: System, options: Options) -> Iterator[Finding]:
    """Requests that are sent again and again without an occasion."""
    rate = options.number("rate")
    yield from one_for_each_place(
        _polled(system, program, call, said)
        for program, call in calls_of(system, _REQUESTS)
        for pace in [None if call.creation is None else pace_of_request(system, call)]
        if pace is not None and (pace.seconds is None or pace.seconds * rate <= 1)
        for said in [_what_is_wrong(system, program, call, pace)]
        if said is not None
    )


def _what_is_wrong(system: System, program: Program, call: ApiCall, pace: RequestPace) -> _Said | None:
    """Why requests at such a pace should be none, in the order of what can be proven best."""
    client = call.creation
    assert client is not None
    late = overrun(system, call, pace)
    if late is not None:
        return _too_late(late, pace)
    asks = _takes_data(program, client) and not is_command(system, client)
    if asks and _hears_the_server(system, client):
        return None
    if pace.kind != "message" and asks and sends_the_same(source_code(system), call):
        words = f"the same request {pace.words}: use a topic for this data"
        return words, "let the server publish the data, and subscribe to it", ()
    if sends_measures(call) and is_own(system, client) and tells_only_success(system, client):
        words = f"numbers {pace.words}, and only whether that worked comes back: use a topic for this data"
        return words, "publish the data, and let the server subscribe to it", ()
    return None


def _too_late(late: Overrun, pace: RequestPace) -> _Said:
    words = f"a request {pace.words}, and each keeps its handler for {late.seconds:.3g} s: the requests pile up"
    related = (Related(late.place, f"the handler sleeps here; it takes {late.seconds:.3g} s in all"),)
    return words, "send the next request when the last one is answered, or less often", related


def _hears_the_server(system: System, client: Creation) -> bool:
    """Whether the node that asks already subscribes to something that the server's node publishes: there is a topic,
    and what it asks for besides is chosen."""
    ends = [end for end in system.endpoints if end.creation.place == client.place and end.name is not None]
    asked = {end.name for end in ends if end.kind == EntityKind.CLIENT}
    servers = [end.node for end in system.endpoints if end.kind == EntityKind.SERVICE and end.name in asked]
    published = {end.name for node in servers for end in node.of_kind(EntityKind.PUBLISHER)} - {None}
    return any(end.name in published for own in ends for end in own.node.of_kind(EntityKind.SUBSCRIBER))


def _takes_data(program: Program, client: Creation) -> bool:
    """Whether the program reads what a service answers; whether it worked is no data, but what a command answers."""
    return client.type is None or any(use.name != "success" for use in answer_fields(program, client))


def _polled(system: System, program: Program, call: ApiCall, said: _Said) -> Finding:
    callback, (words, help, related) = call.context, said
    who = callback_words(callback) if runs_in_executor(callback) else f"{callback.name}()"
    assert call.creation is not None
    return finding(
        "SRV004",
        call.place,
        f"{who} sends {endpoint_words(call.creation)} {words}",
        help=help,
        related=tuple(
            related_to(call, program, call.creation)
            if runs_in_executor(callback)
            else [*related_chain(call), *related_creation(call.creation)]
        )
        + related,
        node=node_name(system, call.node),
        identity=(callback.name, call.creation.name.text or ""),
        group=(call.place.file, callback.name, help),
    )


@folds("SRV004")
def _of_one_callback(findings: Sequence[Finding]) -> Finding:
    """One finding for the requests of a callback that are wrong in the same way."""
    return with_others(findings, "another request is", "more requests are", "sent like that")

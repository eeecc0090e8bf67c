"""How a service is used: who asks, how often, what for, and how long its handler takes."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from enum import Enum, auto
from typing import TYPE_CHECKING

from archlint.advice.model import Evidence, Judged, Use, unknown
from archlint.advice.words import asked_words, node_name, occasion_words, pace_evidence, rate_of, why_unknown
from archlint.analysis.source_code import source_code
from archlint.checks.long_services import long_handlers
from archlint.connections.request_uses import (
    answer_fields,
    is_command,
    is_own,
    overrun,
    sends_measures,
    tells_only_success,
)
from archlint.dataflow.model import How, StepKind
from archlint.dataflow.pace import sending_interval
from archlint.dataflow.runs import REQUESTS
from archlint.execution.polling import sends_the_same
from archlint.execution.request_paces import pace_of_request
from archlint.records import dataclass

if TYPE_CHECKING:
    from archlint.dataflow.model import Flow, Link, Step
    from archlint.execution.request_paces import RequestPace
    from archlint.model import ApiCall, Creation, Program

OFTEN = 1.0
"""The seconds between two requests, or fewer, that make asking a habit and no occasion."""
_AN_ACTION = "make it an action: clients then get feedback and a result, and can cancel"
_TASK = "its handler takes long, and the caller can neither see how far it is nor cancel"
_DATA = "what is asked for again and again is a stream, of which a topic sends each value once to all who want it"
_SET_POINTS = "data is sent again and again, and nothing comes back but that it arrived"
_TOO_OFTEN = "requests come faster than the handler answers them, and pile up"
_COMMAND = "something is to be done, seldom or on an occasion, and the answer says whether it was"
_AGAIN = "the same is commanded again and again, and each answer says whether it was done"
_QUERY = "data is asked for, seldom or on an occasion"
_ASKED_WITH_DATA = "each answer depends on what the request carries"


def judge_service(flow: Flow, step: Step, distros: Sequence[str]) -> Judged:
    """How a service is used, and whether something else fits better; ``distros`` are the distributions it is for."""
    links = flow.into(step)
    askers = [asker for link in links for asker in _askers(flow, link)]
    task = _task(flow, step, distros)
    if task is not None:
        return Judged(Use.TASK, "action", _TASK, _AN_ACTION, evidence=(task, *_evidence(askers)))
    streams = [asker for asker in askers if asker.use == Use.STREAM]
    if streams:
        first = streams[0]
        rates = [rate for rate in (asker.rate for asker in streams) if rate is not None]
        instead = _as_topic(flow, step, first)
        return Judged(Use.STREAM, "topic", first.reason, instead, sum(rates) or None, _evidence(askers))
    known = [asker for asker in askers if asker.use != Use.UNKNOWN]
    if not known:
        reasons = (asker.reason for asker in askers)
        return unknown(next(reasons, why_unknown(links, "calls", "no node here calls it")), _evidence(askers))
    best = next((asker for asker in known if asker.use == Use.QUERY), known[0])
    return Judged(best.use, "service", best.reason, rate=best.rate, evidence=_evidence(askers))


class _Data(Enum):
    """Where the data of a call is."""

    SENT = auto()
    ANSWERED = auto()
    SERVED = auto()
    """Of an answer that its handler has when it has it."""


@dataclass(frozen=True)
class _Asker:
    """One callback that sends requests."""

    use: Use
    reason: str
    node: str
    rate: float | None
    data: _Data
    evidence: tuple[Evidence, ...]


def _askers(flow: Flow, link: Link) -> Iterator[_Asker]:
    """What calls the service through a link."""
    step = link.tail
    if link.how != How.SEND or link.broken or link.doubt or step.callback is None or step.program is None:
        return
    call = next((call for call in step.calls if call.place == link.place and call.api in REQUESTS), None)
    if call is not None and call.receiver is not None and call.receiver.creations:
        client = call.creation or call.receiver.creations[0]
        yield _asker(flow, link, call, client, step.program)


def _asker(flow: Flow, link: Link, call: ApiCall, client: Creation, program: Program) -> _Asker:
    system, step = flow.system, link.tail
    pace = pace_of_request(system, call)
    seconds = pace.seconds if pace is not None else sending_interval(flow, link)
    use, reason, data = _use(flow, call, client, program, pace, seconds)
    often = asked_words(pace, seconds) or occasion_words(step.callback)
    evidence = [Evidence(call.place, f"{node_name(step.node)} calls it {often}"), *pace_evidence(pace, call)]
    read = answer_fields(program, client)
    if read:
        names = ", ".join(dict.fromkeys(use.name for use in read))
        evidence.append(Evidence(read[0].place, f"{node_name(step.node)} reads {names} of the answer"))
    return _Asker(use, reason, node_name(step.node), rate_of(seconds), data, tuple(evidence))


def _use(
    flow: Flow, call: ApiCall, client: Creation, program: Program, pace: RequestPace | None, seconds: float | None
) -> tuple[Use, str, _Data]:
    """What a call is for, why that is so, and where its data is."""
    system = flow.system
    is_data = any(use.name != "success" for use in answer_fields(program, client)) and not is_command(system, client)
    is_often = (pace is not None and pace.seconds is None) or (seconds is not None and seconds <= OFTEN)
    if not is_often:
        return (Use.QUERY, _QUERY, _Data.ANSWERED) if is_data else _command(call)
    if pace is not None and overrun(system, call, pace) is not None:
        return Use.STREAM, _TOO_OFTEN, _Data.SERVED
    if sends_measures(call) and is_own(system, client) and tells_only_success(system, client):
        return Use.STREAM, _SET_POINTS, _Data.SENT
    if is_data and sends_the_same(source_code(system), call):
        return Use.STREAM, _DATA, _Data.ANSWERED
    if is_data:
        return Use.QUERY, _ASKED_WITH_DATA, _Data.ANSWERED
    if is_command(system, client):
        return Use.COMMAND, _AGAIN, _Data.SENT
    return Use.UNKNOWN, "it is called often, and what for is not seen: nothing of the answers is read", _Data.ANSWERED


def _command(call: ApiCall) -> tuple[Use, str, _Data]:
    if call.node is not None and not call.node.complete:
        return Use.UNKNOWN, "code that is not followed may use the answer", _Data.ANSWERED
    return Use.COMMAND, _COMMAND, _Data.SENT


def _task(flow: Flow, step: Step, distros: Sequence[str]) -> Evidence | None:
    """Where a handler takes so long that its service is a task."""
    handlers = {id(link.head.callback) for link in flow.out_of(step) if link.how == How.ARRIVE}
    for callback, diagnostic in long_handlers(flow.system, distros):
        if id(callback) in handlers:
            return Evidence(diagnostic.place, diagnostic.message)
    return None


def _as_topic(flow: Flow, step: Step, asker: _Asker) -> str:
    handlers = [link.head for link in flow.out_of(step) if link.head.kind == StepKind.CALLBACK]
    server = node_name(handlers[0].node) if handlers else "the server"
    if asker.data == _Data.SERVED:
        return f"let {server} publish what it has, at its own pace, and subscribe to it in {asker.node}"
    if asker.data == _Data.SENT:
        return f"publish the data in {asker.node}, and subscribe to it in {server}"
    return f"publish the data in {server}, and subscribe to it in {asker.node}"


def _evidence(askers: Sequence[_Asker]) -> tuple[Evidence, ...]:
    return tuple(dict.fromkeys(evidence for asker in askers for evidence in asker.evidence))


__all__ = ["OFTEN", "judge_service"]

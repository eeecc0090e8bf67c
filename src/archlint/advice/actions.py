"""How an action is used: who sends goals, how often, and whether working on one takes any time."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.advice.model import Evidence, Judged, Use, unknown
from archlint.advice.words import asked_words, node_name, occasion_words, rate_of
from archlint.analysis.source_code import source_code
from archlint.connections.request_uses import sends_measures
from archlint.dataflow.durations import pauses
from archlint.dataflow.model import How
from archlint.dataflow.runs import REQUESTS
from archlint.execution.request_paces import pace_of_request
from archlint.model import Role
from archlint.syntax import facts
from archlint.syntax.parts import everything_in
from archlint.syntax.walk import called_name

if TYPE_CHECKING:
    from archlint.dataflow.model import Flow, Link, Step

_OFTEN = 1.0
_TASK = "it takes a while, and clients get feedback and a result, and can cancel"
_AT_ONCE = "a goal is done as soon as it is accepted, so that there is no progress to see and nothing to cancel"
_QUICK = frozenset(
    {"succeed", "abort", "canceled", "publish", "get_logger", "debug", "info", "warn", "warning", "error", "Result"}
    | {"bool", "float", "int", "len", "max", "min", "round", "str"}
)
"""Calls that take no time."""


def judge_action(flow: Flow, step: Step) -> Judged:
    """How an action is used, and whether something else fits better."""
    goals = [goal for link in flow.into(step) for goal in [_goal(flow, link)] if goal is not None]
    evidence = tuple(evidence for evidence, _ in goals)
    rates = [rate for _, rate in goals if rate is not None]
    if rates:
        instead = "publish the set-points on a topic"
        reason = "each goal is soon replaced by the next, so that none is ever reached"
        return Judged(Use.STREAM, "topic", reason, instead, sum(rates), evidence)
    handlers = [link.head for link in flow.out_of(step) if link.how == How.ARRIVE]
    works = [handler for handler in handlers if handler.callback is not None and handler.callback.role == Role.EXECUTE]
    if not works:
        return unknown("the code that works on its goals is not here", evidence)
    shown = [proof for handler in works for proof in [_takes_time(flow, handler)] if proof is not None]
    if shown:
        return Judged(Use.TASK, "action", _TASK, evidence=(*shown, *evidence))
    if all(_is_done_at_once(flow, handler) for handler in works):
        return Judged(Use.COMMAND, "service", _AT_ONCE, "a service is enough", evidence=evidence)
    return unknown("how long its goals take is not known", evidence)


def _goal(flow: Flow, link: Link) -> tuple[Evidence, float | None] | None:
    """Where goals are sent, and how often, if that is so often that each replaces the one before."""
    step = link.tail
    if link.how != How.SEND or link.broken or step.callback is None:
        return None
    call = next((call for call in step.calls if call.place == link.place and call.api in REQUESTS), None)
    if call is None:
        return None
    pace = pace_of_request(flow.system, call)
    often = asked_words(pace, None) or occasion_words(step.callback)
    evidence = Evidence(call.place, f"{node_name(step.node)} sends a goal {often}")
    is_often = pace is not None and pace.seconds is not None and pace.seconds <= _OFTEN and sends_measures(call)
    return evidence, rate_of(pace.seconds) if pace is not None and is_often else None


def _takes_time(flow: Flow, step: Step) -> Evidence | None:
    """What shows that working on a goal takes time: a pause, feedback, a loop."""
    for pause in pauses(flow.system, step):
        return Evidence(pause.place, f"{node_name(step.node)} {pause.words} while it works on a goal")
    function = None if step.callback is None else source_code(flow.system).function(step.callback)
    if step.place is None or not isinstance(function, facts.Function):
        return None
    for part in everything_in(function.body):
        if isinstance(part, (facts.While, facts.Await)):
            return Evidence(step.place, f"{node_name(step.node)} works on a goal step by step")
        if isinstance(part, facts.Call) and called_name(part) in ("publish_feedback", "is_cancel_requested"):
            return Evidence(step.place, f"{node_name(step.node)} gives feedback while it works on a goal")
    return None


def _is_done_at_once(flow: Flow, step: Step) -> bool:
    """Whether all that is called for a goal takes no time."""
    function = None if step.callback is None else source_code(flow.system).function(step.callback)
    if not isinstance(function, facts.Function):
        return False
    parts = list(everything_in(function.body))
    if any(isinstance(part, (facts.For, facts.While)) for part in parts):
        return False
    return all(called_name(part) in _QUICK for part in parts if isinstance(part, facts.Call))


__all__ = ["judge_action"]

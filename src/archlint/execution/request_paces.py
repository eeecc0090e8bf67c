"""How often a request is sent where nothing but readiness decides about each: by a timer, in a loop that goes on, with
each message, or as soon as the last one is answered."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Literal

from archlint.analysis.kept import once
from archlint.analysis.reach import judged_calls
from archlint.analysis.source_code import source_code
from archlint.execution.loop_paces import paced_loop
from archlint.execution.own_timers import timer_period
from archlint.execution.paces import pace_of
from archlint.execution.polling import goes_on, is_decided, is_unpaced, notes_that_it_ran
from archlint.model import Role
from archlint.records import dataclass

if TYPE_CHECKING:
    from archlint.analysis.source_code import SourceCode
    from archlint.finding import Place
    from archlint.model import ApiCall, Callback
    from archlint.systems.model import System

ADD_DONE_CALLBACK = "rclpy.task.Future.add_done_callback"
PaceKind = Literal["timer", "loop", "message", "answer"]


@dataclass(frozen=True)
class RequestPace:
    """What sends a request again and again, and where that is written; every ``seconds``, or as fast as it is answered
    (None)."""

    kind: PaceKind
    seconds: float | None
    place: Place

    @property
    def words(self) -> str:
        """``10 times a second``."""
        if self.seconds is None:
            return "as soon as the last one is answered" if self.kind == "answer" else "in every iteration of the loop"
        up_to = "up to " if self.kind == "loop" else ""
        return (
            up_to
            + (f"{1 / self.seconds:.3g} times" if self.seconds < 1 else "once")
            + (" a second" if self.seconds <= 1 else f" in {self.seconds:.3g} s")
        )


def pace_of_request(system: System, call: ApiCall) -> RequestPace | None:
    """How often a request is sent; None where that is not known, or where each has an occasion."""
    match call.context.role:
        case Role.TIMER:
            return _by_timer(system, call)
        case Role.MAIN | Role.THREAD | Role.MODULE:
            return _in_loop(system, call)
        case Role.SUBSCRIPTION:
            return _with_message(system, call)
        case Role.DONE:
            return _after_answer(system, call)
    return None


def _by_timer(system: System, call: ApiCall) -> RequestPace | None:
    seconds, timer = timer_period(system, call.context), call.context.creation
    if seconds is None or timer is None or not _comes_each_time(system, call):
        return None
    return RequestPace("timer", seconds, timer.place)


def _with_message(system: System, call: ApiCall) -> RequestPace | None:
    subscription = call.context.creation
    if subscription is None or not _comes_each_time(system, call):
        return None
    pace = pace_of(system, call.context)
    return None if pace is None else RequestPace("message", pace.period, subscription.place)


def _in_loop(system: System, call: ApiCall) -> RequestPace | None:
    code = source_code(system)
    paced = paced_loop(calls_in(system, call.context), call)
    place, seconds = paced if paced is not None else (None, None)
    if place is None:
        unpaced = [loop for loop in call.loops if is_unpaced(code.loop_at(loop))]
        place = unpaced[-1] if unpaced else None
    if place is None or not goes_on(code.loop_at(place)) or not _is_unguarded(code, call, place):
        return None
    return RequestPace("loop", seconds, place)


def _after_answer(system: System, call: ApiCall) -> RequestPace | None:
    """A done callback that waits for its next call in the same way: each answer sends the next request."""
    callback = call.context
    again = [
        other
        for other in calls_in(system, callback)
        if other.api == ADD_DONE_CALLBACK and other.place == callback.registered
    ]
    code = source_code(system)
    if not again or not all(_is_unguarded(code, other) for other in (call, *again)) or call.looped:
        return None
    mine = [creation for other in again if other.receiver is not None for creation in other.receiver.creations]
    return RequestPace("answer", None, again[0].place) if any(client is call.creation for client in mine) else None


def _comes_each_time(system: System, call: ApiCall) -> bool:
    code = source_code(system)
    return not call.looped and _is_unguarded(code, call) and not notes_that_it_ran(code, call)


def _is_unguarded(code: SourceCode, call: ApiCall, loop: Place | None = None) -> bool:
    """Whether nothing but the readiness of the service decides whether a request is sent: each time that a callback
    runs, or in each round of a loop."""
    places = [*(frame.place for frame in call.chain), call.place]
    if loop is not None:
        inside = [number for number, place in enumerate(places) if _holds(loop, place)]
        around = code.loop_at(loop)
        if not inside or around is None:
            return False
        if is_decided(around.body, places[inside[0]]) is not False:
            return False
        places = places[inside[0] + 1 :]
    return all(_is_reached(code, call, place) for place in places)


def _is_reached(code: SourceCode, call: ApiCall, place: Place) -> bool:
    body = code.body_at(place)
    return is_decided(body, place) is False if body else not call.conditional


def _holds(outer: Place, place: Place) -> bool:
    return outer.file == place.file and outer.span[:2] <= place.span[:2] and place.span[2:] <= outer.span[2:]


_SENDS = (".call_async", ".send_goal_async")


def is_pause_before_the_next(system: System, call: ApiCall) -> bool:
    """Whether a done callback pauses before it sends the next request, and no loop of its file sends several at once:
    until then no answer is on its way."""
    own = any(other.api.endswith(_SENDS) for other in calls_in(system, call.context))
    return own and not any(
        other.api.endswith(_SENDS) and (other.looped or other.enclosing_loops)
        for _, other in judged_calls(system)
        if other.file == call.file
    )


def calls_in(system: System, callback: Callback) -> Sequence[ApiCall]:
    """The calls that a callback comes to."""
    return _calls_by_callback(system).get(id(callback), ())


@once
def _calls_by_callback(system: System) -> Mapping[int, list[ApiCall]]:
    by_callback: dict[int, list[ApiCall]] = {}
    for _, call in judged_calls(system):
        by_callback.setdefault(id(call.context), []).append(call)
    return by_callback


__all__ = ["RequestPace", "calls_in", "pace_of_request"]

"""How often callbacks start, where the source says so: timers, and what comes from a timer of another node."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING

from archlint.analysis.coexistence import certain, coexist
from archlint.analysis.kept import once
from archlint.analysis.reach import calls_of
from archlint.analysis.source_code import source_code
from archlint.execution.own_timers import timer_period
from archlint.execution.polling import is_unguarded, notes_that_it_ran
from archlint.model import GroupKind, Role
from archlint.records import dataclass

if TYPE_CHECKING:
    from archlint.model import ApiCall, Callback, Creation
    from archlint.systems.model import System
    from archlint.systems.nodes import Endpoint

_PUBLISH = "rclpy.publisher.Publisher.publish"
_SEND_GOAL = "rclpy.action.client.ActionClient.send_goal_async"
_SEND_REQUEST = "rclpy.client.Client.call_async"


@dataclass(frozen=True)
class Pace:
    """A callback starts every ``period`` seconds; ``sends`` is the call of another timer that brings it about."""

    period: float
    sends: ApiCall | None = None


def runs_beside_itself(callback: Callback) -> bool:
    """Whether a callback may start again while it still runs; the goals of an action server are in no group."""
    return callback.role == Role.EXECUTE or (callback.group is not None and callback.group.kind == GroupKind.REENTRANT)


def pace_of(system: System, callback: Callback) -> Pace | None:
    """How often a callback starts at least, for certain; None where that is not known."""
    match callback.role:
        case Role.TIMER:
            period = timer_period(system, callback)
            return None if period is None else Pace(period)
        case Role.SUBSCRIPTION:
            senders = _others(system, callback.creation, _PUBLISH)
        case Role.EXECUTE:
            senders = _others(system, callback.creation, _SEND_GOAL)
        case Role.SERVICE:
            senders = _others(system, callback.creation, _SEND_REQUEST)
        case _:
            return None
    return min(senders, key=lambda pace: pace.period, default=None)


def _others(system: System, creation: Creation | None, api: str) -> list[Pace]:
    """How often the other ends of a connection send."""
    mine = only_end(system, creation)
    if mine is None or mine.name is None or not certain(mine):
        return []
    return [
        Pace(period, call)
        for call, period in _regular_sends(system)
        if call.api == api
        for other in [only_end(system, call.creation)]
        if other is not None and other.name == mine.name and certain(other) and coexist(system, other, mine)
    ]


def only_end(system: System, creation: Creation | None) -> Endpoint | None:
    """The endpoint that a create call stands for; None where it stands for several."""
    return _only_ends(system).get(id(creation))


@once
def _only_ends(system: System) -> dict[int, Endpoint]:
    """The endpoints by their create calls (``id``) that stand for one each."""
    by_creation: dict[int, list[Endpoint]] = {}
    for end in system.endpoints:
        by_creation.setdefault(id(end.creation), []).append(end)
    return {key: ends[0] for key, ends in by_creation.items() if len(ends) == 1}


@once
def _regular_sends(system: System) -> list[tuple[ApiCall, float]]:
    """The calls that a timer comes to at each tick, with its period in seconds."""
    return list(_sends(system, (_PUBLISH, _SEND_GOAL, _SEND_REQUEST)))


def _sends(system: System, apis: Iterable[str]) -> Iterator[tuple[ApiCall, float]]:
    code = source_code(system)
    for _, call in calls_of(system, apis):
        period = timer_period(system, call.context)
        if period is None or call.creation is None or call.conditional:
            continue
        if is_unguarded(code, call) and not notes_that_it_ran(code, call):
            yield call, period


__all__ = ["Pace", "only_end", "pace_of", "runs_beside_itself"]

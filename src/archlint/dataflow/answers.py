"""Where the answers of services and actions go: to callbacks of futures, and to code that waits for them."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.analysis.reach import creations_of
from archlint.dataflow.model import How
from archlint.dataflow.runs import ADD_DONE_CALLBACK, REQUESTS, Run, registered_at
from archlint.execution.waits import waits
from archlint.model import Role

if TYPE_CHECKING:
    from archlint.dataflow.builder import Builder
    from archlint.model import ApiCall

_RESULT = "rclpy.task.Future.result"
_TAKES_BACK = frozenset({ADD_DONE_CALLBACK, _RESULT, *REQUESTS})


def answers_of(builder: Builder) -> None:
    """Link what comes back with what gets it."""
    waiting = {id(wait.call) for wait in waits(builder.system)}
    registered = registered_at(builder.runs)
    for run in builder.runs:
        for call in run.calls:
            if id(call) in waiting or call.api in _TAKES_BACK:
                for taker in _takers(run, call, id(call) in waiting, registered):
                    _link(builder, call, taker)


def _takers(run: Run, call: ApiCall, waits_here: bool, registered: object) -> list[Run]:
    """What gets the answer that a call is about."""
    assert isinstance(registered, dict)
    if waits_here or call.api == _RESULT:
        return [run]
    later: list[Run] = registered.get((id(run.node), call.place), [])
    wanted = Role.DONE if call.api == ADD_DONE_CALLBACK else Role.FEEDBACK
    return [other for other in later if other.callback.role == wanted]


def _link(builder: Builder, call: ApiCall, taker: Run) -> None:
    clients = creations_of(call.receiver) or creations_of(call.arguments.get("future"))
    doubt = "" if len(clients) == 1 else "which of several clients it comes from is not known"
    for client in clients:
        for end in builder.ends(client, taker.node):
            builder.link(builder.answer(end), builder.step_of(taker), How.ARRIVE, call.place, doubt)


__all__ = ["answers_of"]

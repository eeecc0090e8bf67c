"""SRV003: a service handler that waits for another service or action."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import pairwise
from typing import TYPE_CHECKING

from archlint.analysis.pinned import distros_to_judge
from archlint.analysis.reach import (
    endpoint_words,
    node_name,
    one_for_each_place,
    related_chain,
    related_creation,
)
from archlint.analysis.source_code import source_code
from archlint.analysis.unused_results import stands_alone
from archlint.checks.nested_spins import OWN_EXECUTOR
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.checks.service_cycles import Edge, waits_behind
from archlint.checks.wait_words import to_await
from archlint.execution.blocking import ONE
from archlint.execution.busy_flags import returns_while_busy
from archlint.execution.callback_roles import runs_in_executor
from archlint.execution.called_here import is_called_directly
from archlint.execution.deadlock import AWAIT, CALL, SPIN, Verdict, related_executor, threads_of
from archlint.execution.present_servers import is_looked_for
from archlint.execution.spins import is_spun_for_moments
from archlint.execution.stuck import nested_waits
from archlint.execution.waits import BLOCKING_CALLS, DONE, Wait, waits
from archlint.finding import Finding, Related, Severity
from archlint.model import GroupKind, Role

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.model import Callback
    from archlint.systems.model import System

_OTHERS_SHOWN = 5

_NAMES_SHOWN = 3

_GO_ON = "send the request with {}, return, and publish the outcome from the done callback"
_AWAIT = "make the handler async, give the client its own callback group, and await {}"
_ONLY_AWAIT = "make the handler async, and await {}: no thread is blocked then"
_NO_WAIT = "send the request with call_async() and do not wait: nobody looks at the response here"
_EVENT = "send the request with call_async(), and wait with a limit for a threading.Event that its done callback sets"
_OWN_GROUP = "give {} its own callback group, so that the other callbacks keep running"
_MORE_THREADS = "spin the node with a MultiThreadedExecutor, and give {} its own callback group"
_NOT_WITH_IT = "give {} a different callback group from the handlers that wait here"
_LONGER = "make the timeout here longer than the total time that {} may wait"
_LIMIT_EVENT = "set a limit, event.wait(timeout=…), and respond that it failed when the wait returns False"
_LIMIT_LOOP = "end the loop after a time limit, too, and respond that it failed then"
_KEEP = "keep the timeout, and give the callers of {} a longer one"
_IF_IT_CAN = "if the caller does not need the outcome, return at once and publish it from the done callback"
_BOUND = (
    "add a timeout: a timer in the client's callback group calls future.set_result(None), and the code after the "
    "await checks for None"
)
_SET_LIMIT = "set timeout_sec, and check future.done() afterwards"
_GROUP = "give the client its own callback group (callback_group=MutuallyExclusiveCallbackGroup())"

_WITHOUT_LIMIT = {"threading.Event.wait": _LIMIT_EVENT, DONE: _LIMIT_LOOP}
"""What to do about a wait that can be given a limit in its own line."""

_Row = tuple[Wait, Verdict, "list[Wait]"]
"""A wait, what becomes of it, and the waits of other handlers at the same place."""


@rule("SRV003", scope=Scope.CODE, lost_answers=False)
def nested_service_call(system: System, options: Options) -> Iterator[Finding]:
    """Waits that the handler of a service reaches: one finding a handler, and a place for the handler that is worst
    off.  That a wait which works has no limit is for ``lost-answers``, where its server has been found."""
    seldom = options.flag("lost-answers")
    judged: dict[Place, list[tuple[Wait, Verdict]]] = {}
    for wait, verdict in nested_waits(system, distros_to_judge(system.workspace, options.distros)):
        judged.setdefault(wait.call.place, []).append((wait, verdict))
    handlers: dict[tuple[Place, str], list[_Row]] = {}
    for place in sorted(judged):
        (wait, verdict), *others = sorted(judged[place], key=_worst_first)
        handler = wait.call.context
        row = (wait, verdict, [other for other, _ in others])
        handlers.setdefault((handler.place, handler.name), []).append(row)
    yield from one_for_each_place(
        _nested(system, rows)
        for rows in handlers.values()
        if not all(_is_done_right(system, row) or (not seldom and _comes_as_a_rule(system, row)) for row in rows)
    )


def _is_done_right(system: System, row: _Row) -> bool:
    """Whether a wait has an end and its answer is used, and neither a callback nor a further service is behind it."""
    wait, verdict, _ = row
    careful = verdict.safe and wait.kind != AWAIT and _careful(system, wait)
    return careful and not _held_up(system, wait) and not waits_behind(system, wait)


def _comes_as_a_rule(system: System, row: _Row) -> bool:
    """Whether all that is wrong with a wait is that it has no limit, and the code has looked for the server."""
    wait, verdict, _ = row
    if not verdict.safe or wait.kind == SPIN or _thrown_away(system, wait) or not is_looked_for(system, wait.client):
        return False
    return not _held_up(system, wait) and not waits_behind(system, wait)


def _held_up(system: System, wait: Wait) -> list[Callback]:
    """The callbacks that cannot run meanwhile, without those that wait at the same line."""
    handler = wait.call.context
    rivals = {rival.call.context.place for rival in waits(system) if rival.call.place == wait.call.place}
    return [callback for callback in _blocked_callbacks(wait) if callback.place not in rivals - {handler.place}]


def _worst_first(row: tuple[Wait, Verdict]) -> tuple[object, ...]:
    wait, verdict = row
    return (verdict.safe, verdict.unknown, len(wait.call.chain), wait.call.context.place, wait.call.context.name)


def _nested(system: System, rows: list[_Row]) -> Finding:
    # Where one wait hangs, those that follow are never reached.
    wait, verdict, others = min(rows, key=lambda row: (row[1].safe, row[1].unknown, row[0].call.place))
    call, handler = wait.call, wait.call.context
    further = [row[0] for row in rows if row[0] is not wait]
    service = endpoint_words(handler.creation)
    awaited = _all_words([wait, *further]) if verdict.safe else endpoint_words(wait.client)
    blocked = _held_up(system, wait)
    has_rivals = any(
        rival.call.place == call.place and rival.call.context.place != handler.place for rival in waits(system)
    )
    behind = waits_behind(system, wait) if verdict.safe else []
    outcome = _outcome(system, wait, verdict, blocked, behind)
    diagnostic = finding(
        "SRV003",
        call.place,
        f"the handler of {service} {_waits_for(wait, verdict, awaited)}{outcome}",
        help=_help(system, wait, verdict, blocked, behind, has_rivals),
        related=[
            Related(handler.place, f"{handler.name} handles {service}"),
            *related_chain(call),
            *related_creation(wait.client),
            *related_executor(handler.node, wait.program),
            *(
                Related(other_wait.call.place, f"it waits for {endpoint_words(other_wait.client)}, too")
                for other_wait in further
            ),
            *(Related(edge.wait.call.place, f"the handler of {edge.server.name} waits here") for edge in behind[:1]),
            *_other_handlers(handler, others),
        ],
        node=node_name(system, handler.node),
        identity=(handler.name, wait.client.name.text or "", call.api),
    )
    # What becomes of the spin of another node is not always known: that the caller waits, is.
    mild = verdict.safe or (wait.kind == SPIN and verdict.unknown)
    if (
        verdict.safe
        and not blocked
        and not behind
        and all(_careful(system, each_wait) for each_wait in (wait, *further))
    ):
        return replace(diagnostic, severity=Severity.INFO)
    return replace(diagnostic, severity=Severity.WARNING) if mild else diagnostic


def _careful(system: System, wait: Wait) -> bool:
    """Whether a wait has an end, and what it brings is looked at, or an await holds no thread: there is nothing to do
    but to know of it."""
    return wait.kind == AWAIT or (wait.bounded and wait.kind != SPIN and not _thrown_away(system, wait))


def _thrown_away(system: System, wait: Wait) -> bool:
    """Whether nobody looks at the answer: ``self.client.call(request)`` as a line of its own."""
    return wait.call.api in BLOCKING_CALLS and stands_alone(source_code(system), wait.call)


def _holds_all(wait: Wait) -> bool:
    """Whether a wait keeps the only thread of its node, whoever processes the response."""
    return wait.kind != AWAIT and threads_of(wait.call.context.node, wait.program) == ONE


def _blocked_callbacks(wait: Wait) -> list[Callback]:
    """The callbacks that cannot run meanwhile: those of the exclusive group that the handler holds to its end; all of
    the node where it holds the only thread."""
    handler, holds_all = wait.call.context, _holds_all(wait)
    if handler.node is None:
        return []
    if not holds_all and (handler.group is None or handler.group.kind == GroupKind.REENTRANT):
        return []
    by_place: dict[Place, Callback] = {}
    for other in sorted(handler.node.callbacks, key=lambda callback: (callback.place, callback.name)):
        if (holds_all or other.group == handler.group) and other.place != handler.place and runs_in_executor(other):
            by_place.setdefault(other.place, other)
    return list(by_place.values())


def _waits_for(wait: Wait, verdict: Verdict, awaited: str) -> str:
    if wait.kind == SPIN and not verdict.safe:
        return f"spins until {awaited} has responded"
    return f"waits for {awaited}"


def _all_words(waits: list[Wait]) -> str:
    """``the service 'a' and the service 'b' one after the other``."""
    words = list(dict.fromkeys(endpoint_words(wait.client) for wait in waits))
    if len(waits) == 1:
        return words[0]
    if len(words) == 1:
        return f"{words[0]}, at {len(waits)} places"
    if len(words) > _NAMES_SHOWN:
        words[_NAMES_SHOWN - 1 :] = [f"{len(words) - _NAMES_SHOWN + 1} more"]
    if not _on_one_path(waits):
        return f"{', '.join(words[:-1])} or {words[-1]}"
    return f"{', '.join(words[:-1])} and {words[-1]} one after the other"


def _on_one_path(waits: list[Wait]) -> bool:
    """Whether one way through the branches comes to all of the waits."""
    arms = sorted((wait.call.branch_arms for wait in waits), key=len)
    return all(longer[: len(shorter)] == shorter for shorter, longer in pairwise(arms))


def _help(
    system: System,
    wait: Wait,
    verdict: Verdict,
    blocked: Sequence[Callback],
    behind: Sequence[Edge],
    has_rivals: bool,
) -> str:
    """What to do: whoever looks at the answer needs it before the handler returns."""
    if wait.kind == AWAIT:
        if verdict.safe and not blocked:
            return _BOUND
        return _IF_IT_CAN if verdict.safe else _GROUP
    resumes = _resumes(wait, verdict)
    if wait.kind == CALL and _thrown_away(system, wait) and (wait.bounded or not resumes):
        return _GO_ON.format(to_await(wait.call, wait.client).replace("(…)", "()"))
    service = endpoint_words(wait.call.context.creation)
    if verdict.safe and wait.bounded and wait.kind != SPIN:
        if behind:
            return _LONGER.format(behind[0].server.name)
        if blocked and _holds_all(wait):
            return _MORE_THREADS.format(service)
        if blocked and has_rivals:
            return _NOT_WITH_IT.format(_names_of(blocked))
        return _OWN_GROUP.format(service) if blocked else _KEEP.format(service)
    if wait.kind == SPIN and _is_spun_here(wait):
        return _advice_for_another_node(wait, verdict, service)
    if verdict.safe and wait.limited:
        return _IF_IT_CAN
    if verdict.safe and not blocked and wait.call.api in _WITHOUT_LIMIT:
        return _WITHOUT_LIMIT[wait.call.api]
    if is_called_directly(source_code(system), wait.call.context):
        return _NO_WAIT if _thrown_away(system, wait) else _EVENT
    advice = _ONLY_AWAIT if resumes else _AWAIT
    return advice.format(to_await(wait.call, wait.client))


def _resumes(wait: Wait, verdict: Verdict) -> bool:
    """Whether an ``await`` in the handler goes on when the response is there, without any other change: the groups
    allow it, and the same executor runs both."""
    return verdict.safe and wait.client.node is wait.call.context.node


def _is_spun_here(wait: Wait) -> bool:
    """Whether the client's node is another one, which runs only while something waits for it: no done callback is
    called and nothing that is awaited goes on once the handler has returned."""
    node = wait.client.node
    return node is not wait.call.context.node and is_spun_for_moments(node, wait.program)


def _advice_for_another_node(wait: Wait, verdict: Verdict, service: str) -> str:
    if not verdict.safe:
        return OWN_EXECUTOR.format(wait.call.api.rpartition(".")[2])
    return _KEEP.format(service) if wait.limited else _SET_LIMIT


def _other_handlers(first: Callback, waits: list[Wait]) -> Iterator[Related]:
    """Further handlers that reach the same call."""
    seen = {first.name}
    for wait in waits:
        handler = wait.call.context
        if handler.name not in seen and len(seen) <= _OTHERS_SHOWN:
            seen.add(handler.name)
            service = endpoint_words(handler.creation)
            yield Related(handler.place, f"{handler.name}, the handler of {service}, gets here too")


def _outcome(system: System, wait: Wait, verdict: Verdict, blocked: Sequence[Callback], behind: Sequence[Edge]) -> str:
    if verdict.safe:
        if not wait.bounded and wait.kind != AWAIT:
            meanwhile = "has no time limit: if the response never comes, the handler never returns; until then "
        else:
            meanwhile = "" if wait.kind == AWAIT and not blocked else "meanwhile "
        return (
            f"{_second_level(behind)}, which works here ({verdict.why}), but {meanwhile}{_cost(system, wait, blocked)}"
        )
    if wait.kind == SPIN:
        return f", and {verdict.why}" + ("" if verdict.unknown else f": this {verdict.words}")
    if verdict.unknown:
        return f", which may never respond: {verdict.why}"
    return f" and {verdict.words}: {verdict.why}"


def _second_level(behind: Sequence[Edge]) -> str:
    if not behind:
        return ""
    names = list(dict.fromkeys(edge.target[1] for edge in behind))
    further = f" and {len(names) - 1} more" if len(names) > 1 else ""
    return f" (the handler of {behind[0].server.name} itself waits for {names[0]}{further})"


def _cost(system: System, wait: Wait, blocked: Sequence[Callback]) -> str:
    """What a wait costs that ends well."""
    if blocked:
        of = "node" if _holds_all(wait) else "group"
        return f"its own caller waits, and the other callbacks of its {of} cannot run: {_names_of(blocked)}"
    if wait.kind == AWAIT:
        return "the await has no timeout: if the response never comes, the handler and its caller wait forever"
    if _may_take_all_threads(system, wait):
        return (
            "its own caller waits, and as many simultaneous requests as there are threads leave no thread to "
            "process a response"
        )
    return "its own caller waits, and one thread is blocked"


def _may_take_all_threads(system: System, wait: Wait) -> bool:
    """Whether requests that come together may leave no thread for a response: a spin processes it itself, and a handler
    may refuse all but the first."""
    handler = wait.call.context
    if wait.kind == SPIN or handler.group is None or handler.group.kind != GroupKind.REENTRANT:
        return False
    function = source_code(system).definition(handler)
    return function is None or not returns_while_busy(function.body)


def _names_of(callbacks: Sequence[Callback]) -> str:
    """``the service 'stop' and tick``."""
    words = [
        endpoint_words(callback.creation) if callback.role == Role.SERVICE else callback.name for callback in callbacks
    ]
    if len(words) > _NAMES_SHOWN:
        words[_NAMES_SHOWN - 1 :] = [f"{len(words) - _NAMES_SHOWN + 1} more"]
    return words[0] if len(words) == 1 else f"{', '.join(words[:-1])} and {words[-1]}"

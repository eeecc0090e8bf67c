"""EXE003, EXE004, EXE007 and SRV008: callbacks that keep their thread while nothing else can run on it."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.checks import blocking
from archlint.checks.callback_roles import callback_words, related_to, runs_in_executor
from archlint.checks.deadlock import threads_of
from archlint.checks.reach import argument, calls_of, endpoint_words, judged_calls, node_name, one_for_each_place
from archlint.checks.registry import Options, finding, rule
from archlint.checks.sleeps import Stay, longest, stay_of
from archlint.checks.timeouts import MAKE_IT_EARLIER, made_here
from archlint.facts import model as facts
from archlint.facts.walk import called_name
from archlint.finding import Finding, Related, Severity
from archlint.program.interest import names_in
from archlint.program.model import PUBLISHER
from archlint.program.values import Known, alternatives

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.program.model import ApiCall, Callback, Program
    from archlint.system.model import System

MOMENT = 0.1
"""Seconds of a sleep that are not worth a word, unless a loop adds them up."""
LONG = 1.0
"""Seconds that a service handler may sleep, all in all: nobody writes an action for less."""
TINY = 0.01
"""Seconds of a pause between the items of something."""
DISCOVERY = 1.0
"""Seconds that a callback may look for a server."""

_TRIFLES = frozenset({"clear", "cls", "reset", ""})

_RATE_SLEEP = "rclpy.timer.Rate.sleep"
_LOOKUPS = ("tf2_ros.buffer.Buffer.lookup_transform", "tf2_ros.buffer.Buffer.can_transform")
_LISTENER = "tf2_ros.transform_listener.TransformListener"


# ------------------------------------------------------------------------------------------ EXE003, SRV008


_Row = tuple["Program", "ApiCall", Stay]


@rule("EXE003", taste=True)
def slow_callback(system: System, options: Options) -> Iterator[Finding]:
    """Sleeps and waits for the world outside that callbacks reach: one finding for the function that holds them."""
    functions: dict[tuple[str, str], dict[Place, _Row]] = {}
    for program, call, stay in _stays(system):
        if call.context.role == "service" and stay.kind == "sleep":
            continue  # SRV008 has a bound of its own for these
        rows = functions.setdefault((call.file, call.function), {})
        known = rows.get(call.place)
        if known is None or len(call.chain) < len(known[1].chain):
            rows[call.place] = (program, call, stay)
    yield from one_for_each_place(_slow(system, [rows[place] for place in sorted(rows)]) for rows in functions.values())


@rule("SRV008", taste=True)
def long_running_service(system: System, options: Options) -> Iterator[Finding]:
    """Service handlers that sleep, once for long or again and again; one finding a handler."""
    handlers: dict[tuple[Program, Place], list[tuple[ApiCall, Stay]]] = {}
    for program, call in judged_calls(system):
        stay = stay_of(call) if call.context.role == "service" else None
        if stay is not None and stay.kind == "sleep" and not _around_future(call):
            handlers.setdefault((program, call.context.place), []).append((call, stay))
    yield from one_for_each_place(
        _long_service(system, program, sorted(sleeps, key=_endless_first))
        for (program, _), sleeps in handlers.items()
        if _in_all(sleeps) >= LONG
    )


def _endless_first(sleep: tuple[ApiCall, Stay]) -> tuple[bool, Place]:
    """What has no known end is what makes a handler long."""
    return (not math.isinf(_in_loops(*sleep)), sleep[0].place)


def _in_all(sleeps: Sequence[tuple[ApiCall, Stay]]) -> float:
    """Seconds that a handler sleeps for certain, each way through its branches by itself; what nobody knows has no
    end."""
    arms: dict[tuple[tuple[str, int], ...], dict[Place, float]] = {}
    for call, stay in sleeps:
        arms.setdefault(call.arms, {})[call.place] = _in_loops(call, stay)
    always = sum(arms.pop((), {}).values())
    return always + max((sum(found.values()) for found in arms.values()), default=0.0)


def _in_loops(call: ApiCall, stay: Stay) -> float:
    """How long a sleep takes with the loops around it; what nobody knows has no end."""
    if stay.seconds is None:
        return math.inf
    # The loops of callers are places only: how often they go round is not looked at.
    times = [_times(loop) for loop in call.loops] + [math.inf] * (len(call.rounds) - len(call.loops))
    seconds = stay.seconds * math.prod(times) if stay.seconds > 0 else 0.0
    if math.isinf(seconds) and stay.seconds <= TINY and not any(isinstance(loop, facts.While) for loop in call.loops):
        return stay.seconds  # a pause between the bytes or lines of something: it takes many to make it long
    return seconds


def _times(loop: facts.While | facts.For) -> float:
    """How often a loop goes round at most."""
    if isinstance(loop, facts.While):
        return math.inf
    if isinstance(loop.iterable, facts.Sequence):
        return len(loop.iterable.elements)
    given = (
        loop.iterable.args if isinstance(loop.iterable, facts.Call) and called_name(loop.iterable) == "range" else []
    )
    bounds = [one.value.value for one in given if isinstance(one.value, facts.Literal)]
    numbers = [bound for bound in bounds if isinstance(bound, int)]
    return len(range(*numbers)) if given and len(numbers) == len(given) else math.inf


def _stays(system: System) -> Iterator[_Row]:
    for program, call in judged_calls(system):
        stay = stay_of(call) if runs_in_executor(call.context) else None
        if stay is None or _trifle(call) or not _is_long(call, stay) or _harmless(call.context, program):
            continue
        yield program, call, stay


def _is_long(call: ApiCall, stay: Stay) -> bool:
    if stay.kind == "discovery":
        return stay.seconds is not None and stay.seconds > DISCOVERY
    if _around_future(call):
        return False
    if stay.kind != "sleep" or stay.seconds is None:
        return True
    period, seconds = _period(call.context), _in_loops(call, stay)
    return seconds >= MOMENT or (period is not None and seconds > period)


def _around_future(call: ApiCall) -> bool:
    """A loop around a future: that wait is what is wrong, not its pace."""
    return any(isinstance(loop, facts.While) and "done" in names_in(loop.test) for loop in call.loops)


def _trifle(call: ApiCall) -> bool:
    """``os.system('clear')``: over before anybody notices."""
    command = argument(call, "command")
    return command is not None and all(
        isinstance(option, Known) and option.value in _TRIFLES for option in alternatives(command)
    )


def _period(callback: Callback) -> float | None:
    return None if callback.creation is None else callback.creation.period


def _harmless(callback: Callback, program: Program) -> bool:
    """Whether nothing else has to wait meanwhile: other threads take the work that is in other groups."""
    threads = threads_of(callback.node, program)
    if threads != blocking.SEVERAL:
        # What holds no group is harmless under several threads, and nobody says that there are none.
        return callback.group is None and threads in (blocking.ANY, blocking.NOBODY)
    group = callback.group
    if group is None or group.kind == "reentrant":
        return True
    if group.kind != "mutually_exclusive" or callback.node is None:
        return False
    others = [one for one in callback.node.callbacks if one.group == group and one.place != callback.place]
    return not others


def _is_alone(callback: Callback, program: Program) -> bool:
    """Whether nothing else could have to wait: the node, and whoever shares its executor, takes in nothing else."""
    node = callback.node
    if callback.creation is None or callback.role not in _ITS_NEXT or node is None or node.lifecycle:
        return False
    if node.executor not in ("single_threaded", "multi_threaded"):
        return False
    nodes = [node, *(one for use in program.executors_of(node) for one in use.nodes if one is not node)]
    return all(one.complete for one in nodes) and all(
        (creation is callback.creation or creation.kind == PUBLISHER)
        and all(other.place == callback.place for other in creation.callbacks.values())
        for one in nodes
        for creation in one.creations
    )


_ITS_NEXT = {"subscription": "message", "timer": "turn", "service": "request", "execute": "goal"}


def _slow(system: System, rows: Sequence[_Row]) -> Finding:
    (program, call, stay), *others = rows
    callback = call.context
    period = _period(callback)
    if stay.kind == "sleep" and stay.seconds is not None and period is not None and stay.seconds > period:
        end = f", longer than its period of {period:g} s"
    else:
        end = " each time round a loop" if stay.kind == "sleep" and call.looped else ""
    if others:
        end += f", as {'does another line' if len(others) == 1 else f'do {len(others)} more lines'} of {call.function}"
    alone = all(_is_alone(row[1].context, row[0]) for row in rows)
    meanwhile = (
        f"the node has nothing else to do meanwhile, but its next {_ITS_NEXT[callback.role]} waits"
        if alone
        else _meanwhile(callback, program)
    )
    found = finding(
        "EXE003",
        call.place,
        f"{callback_words(callback)} {stay.words}{end}: {meanwhile}",
        help=_instead(call, stay),
        related=(
            *related_to(call, program),
            *(Related(other.place, f"here it {words.words}") for _, other, words in others),
        ),
        node=node_name(system, callback.node),
        identity=(callback.name, call.api),
    )
    return replace(found, severity=Severity.INFO) if alone else found


def _instead(call: ApiCall, stay: Stay) -> str:
    """What to do; where the callback's return value is the answer, nothing can go on later."""
    if stay.kind == "discovery" and made_here(call):
        return MAKE_IT_EARLIER
    if stay.kind == "discovery" and call.context.role in _ANSWERS:
        return "look once, without waiting, and answer that it is not there"
    if call.context.role == "service":
        return "what takes its time is an action: its execute callback may take it"
    if call.context.role in _ANSWERS:
        return "spin the node with a MultiThreadedExecutor, and give what must go on a callback group of its own"
    return _INSTEAD.get(stay.kind, "do it in a thread (or a ThreadPoolExecutor) of your own")


_ANSWERS = frozenset({"service", "lifecycle", "goal", "cancel", "parameter", "execute"})
"""Roles of callbacks that somebody waits for: what they return is the answer."""

_INSTEAD = {
    "sleep": "let a timer go on later, instead of sleeping",
    "discovery": "look once, without waiting, and try again from a timer",
    "message": "subscribe, and go on in the callback",
}


def _meanwhile(callback: Callback, program: Program) -> str:
    threads = threads_of(callback.node, program)
    if threads == blocking.SEVERAL:
        return "no other callback of its group runs meanwhile"
    if threads == blocking.ONE:
        return "no other callback of the node runs meanwhile"
    return "on an executor with one thread no other callback runs meanwhile"


def _reads(call: ApiCall, loop: facts.For) -> bool:
    """Whether what a call is given depends on the round: ``sleep(PAUSE * (attempt + 1))``."""
    return call.expression is not None and not names_in(call.expression).isdisjoint(names_in(loop.target))


def _long_service(system: System, program: Program, sleeps: Sequence[tuple[ApiCall, Stay]]) -> Finding:
    (call, stay), *others = sleeps
    callback = call.context
    further = {other.place: Related(other.place, f"then it {words.words}") for other, words in others}
    further.pop(call.place, None)
    words, total = stay.words, _in_all(sleeps)
    if further and not math.isinf(total):
        words = f"sleeps for {total:.3g} s in all"
    elif call.looped and not math.isinf(total):
        varies = any(isinstance(loop, facts.For) and _reads(call, loop) for loop in call.loops)
        words = (
            "sleeps again and again, for a time that the loop sets"
            if varies
            else f"sleeps for {total:.3g} s in all, in a loop"
        )
    again = " each time round a loop" if call.looped and math.isinf(total) else ""
    waits = "without knowing for how long, and cannot cancel" if math.isinf(total) else "meanwhile, and cannot cancel"
    return finding(
        "SRV008",
        call.place,
        f"the handler of {endpoint_words(callback.creation)} {words}{again}: the caller waits {waits}",
        help="what takes its time is an action: it has feedback, a result and cancelling",
        related=(*related_to(call, program), *further.values()),
        node=node_name(system, callback.node),
        identity=(callback.name, call.api),
    )


# --------------------------------------------------------------------------------------------------- EXE004


@rule("EXE004")
def rate_sleep_in_callback(system: System, options: Options) -> Iterator[Finding]:
    """Rates that sleep on the only thread that could wake them."""
    yield from one_for_each_place(
        finding(
            "EXE004",
            call.place,
            f"{callback_words(call.context)} sleeps on a Rate and {verdict.words}: the timer that wakes it needs the "
            "thread that sleeps",
            help="let a timer do the work step by step, or spin the node with a MultiThreadedExecutor",
            related=tuple(related_to(call, program)),
            node=node_name(system, call.context.node),
            identity=(call.context.name, "Rate.sleep"),
        )
        for program, call in calls_of(system, (_RATE_SLEEP,))
        if runs_in_executor(call.context)
        for verdict in [_rate_verdict(call, program, options)]
        if not verdict.safe and not verdict.unknown
    )


def _rate_verdict(call: ApiCall, program: Program, options: Options) -> blocking.Verdict:
    threads = threads_of(call.context.node, program)
    return blocking.look_up(blocking.RATE, threads, blocking.OTHER, "", options.distros)


# --------------------------------------------------------------------------------------------------- EXE007


@rule("EXE007")
def blocking_tf_lookup(system: System, options: Options) -> Iterator[Finding]:
    """Transform lookups with a timeout on the only thread that could bring the transform."""
    threaded = {id(program) for program, call in calls_of(system, (_LISTENER,)) if _spins_itself(call)}
    yield from one_for_each_place(
        finding(
            "EXE007",
            call.place,
            f"{callback_words(call.context)} waits{_limit_words(call)} for a transform that cannot come meanwhile: "
            "the listener needs the thread that waits",
            help="look up what is there now (no timeout) and try again next time; or wait_for_transform_async(); or "
            "spin the node with a MultiThreadedExecutor",
            related=tuple(related_to(call, program)),
            node=node_name(system, call.context.node),
            identity=(call.context.name, call.api),
        )
        for program, call in calls_of(system, _LOOKUPS)
        if runs_in_executor(call.context)
        and _waits(call)
        and threads_of(call.context.node, program) == blocking.ONE
        and id(program) not in threaded
    )


def _waits(call: ApiCall) -> bool:
    seconds = longest(argument(call, "timeout"))
    return seconds is not None and seconds > 0


def _limit_words(call: ApiCall) -> str:
    seconds = longest(argument(call, "timeout"))
    return "" if seconds is None else f" {seconds:g} s"


def _spins_itself(call: ApiCall) -> bool:
    """``TransformListener(…, spin_thread=True)``, or an argument that may be true."""
    value = argument(call, "spin_thread")
    return value is not None and not (isinstance(value, Known) and not value.value)

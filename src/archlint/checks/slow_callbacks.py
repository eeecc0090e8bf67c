"""EXE003, EXE004, EXE007 and SRV008: callbacks that keep their thread while nothing else can run on it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.checks import blocking
from archlint.checks.callback_roles import callback_words, related_to, runs_in_executor
from archlint.checks.deadlock import threads_of
from archlint.checks.reach import argument, calls_of, endpoint_words, judged_calls, node_name, one_for_each_place
from archlint.checks.registry import Options, finding, rule
from archlint.checks.sleeps import Stay, longest, stay_of
from archlint.facts import model as facts
from archlint.finding import Finding, Related
from archlint.program.interest import names_in
from archlint.program.values import Known, alternatives

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.program.model import ApiCall, Callback, Program
    from archlint.system.model import System

MOMENT = 0.1
"""Seconds of a sleep that are not worth a word, unless a loop adds them up."""
LONG = 1.0
"""Seconds of a sleep that a caller notices, where nobody else does."""
DISCOVERY = 1.0
"""Seconds that a callback may look for a server."""

_TRIFLES = frozenset({"clear", "cls", "reset", ""})

_RATE_SLEEP = "rclpy.timer.Rate.sleep"
_LOOKUPS = ("tf2_ros.buffer.Buffer.lookup_transform", "tf2_ros.buffer.Buffer.can_transform")
_LISTENER = "tf2_ros.transform_listener.TransformListener"


# ------------------------------------------------------------------------------------------ EXE003, SRV008


@rule("EXE003")
def slow_callback(system: System, options: Options) -> Iterator[Finding]:
    """Sleeps and waits for the world outside that callbacks reach."""
    yield from one_for_each_place(
        _slow(system, program, call, stay)
        for program, call, stay in _stays(system)
        if not (call.context.role == "service" and stay.kind == "sleep")
    )


@rule("SRV008")
def long_running_service(system: System, options: Options) -> Iterator[Finding]:
    """Service handlers that sleep, once for long or again and again; one finding a handler."""
    handlers: dict[tuple[Program, Place], list[tuple[ApiCall, Stay]]] = {}
    for program, call, stay in _stays(system):
        if call.context.role == "service" and stay.kind == "sleep":
            handlers.setdefault((program, call.context.place), []).append((call, stay))
    yield from one_for_each_place(
        _long_service(system, program, sorted(sleeps, key=lambda one: one[0].place))
        for (program, _), sleeps in handlers.items()
    )


def _stays(system: System) -> Iterator[tuple[Program, ApiCall, Stay]]:
    for program, call in judged_calls(system):
        stay = stay_of(call) if runs_in_executor(call.context) else None
        if stay is None or _trifle(call) or not _is_long(call, stay):
            continue
        if not _harmless(call.context, program) or _keeps_the_caller(call, stay):
            yield program, call, stay


def _keeps_the_caller(call: ApiCall, stay: Stay) -> bool:
    """Whether a handler sleeps so long that its caller suffers, however many threads there are."""
    if call.context.role != "service" or stay.kind != "sleep":
        return False
    return call.looped or stay.seconds is None or stay.seconds >= LONG


def _is_long(call: ApiCall, stay: Stay) -> bool:
    if stay.kind == "discovery":
        return stay.seconds is not None and stay.seconds > DISCOVERY
    if any(isinstance(loop, facts.While) and "done" in names_in(loop.test) for loop in call.loops):
        return False  # a loop around a future: that wait is what is wrong, not its pace
    if stay.kind != "sleep" or stay.seconds is None:
        return True
    period = _period(call.context)
    # A loop makes a long sleep of short ones; how long, nobody knows.
    return (
        stay.seconds >= MOMENT or (call.looped and stay.seconds > 0) or (period is not None and stay.seconds > period)
    )


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


def _slow(system: System, program: Program, call: ApiCall, stay: Stay) -> Finding:
    callback = call.context
    period = _period(callback)
    if stay.kind == "sleep" and stay.seconds is not None and period is not None and stay.seconds > period:
        end = f", longer than its period of {period:g} s"
    else:
        end = " each time round a loop" if stay.kind == "sleep" and call.looped else ""
    return finding(
        "EXE003",
        call.place,
        f"{callback_words(callback)} {stay.words}{end}: {_meanwhile(callback, program)}",
        help="let a timer go on later, instead of sleeping"
        if stay.kind == "sleep"
        else "look once, without waiting, and try again from a timer"
        if stay.kind == "discovery"
        else "subscribe, and go on in the callback"
        if stay.kind == "message"
        else "do it in a thread (or a ThreadPoolExecutor) of your own",
        related=tuple(related_to(call, program)),
        node=node_name(system, callback.node),
        identity=(callback.name, call.api),
    )


def _meanwhile(callback: Callback, program: Program) -> str:
    threads = threads_of(callback.node, program)
    if threads == blocking.SEVERAL:
        return "no other callback of its group runs meanwhile"
    if threads == blocking.ONE:
        return "no other callback of the node runs meanwhile"
    return "on an executor with one thread no other callback runs meanwhile"


def _long_service(system: System, program: Program, sleeps: Sequence[tuple[ApiCall, Stay]]) -> Finding:
    (call, stay), *others = sleeps
    callback = call.context
    further = {other.place: Related(other.place, f"then it {words.words}") for other, words in others}
    further.pop(call.place, None)
    again = " each time round a loop" if call.looped else ""
    return finding(
        "SRV008",
        call.place,
        f"the handler of {endpoint_words(callback.creation)} {stay.words}{again}: the caller waits without "
        "knowing for how long, and cannot cancel",
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

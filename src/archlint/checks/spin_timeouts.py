"""TMO003: spins for a future without a limit."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.analysis.aside import is_example
from archlint.analysis.copied_classes import is_in_copied_class
from archlint.analysis.limit_sites import sites_of_spin, spins_for_a_result
from archlint.analysis.order import always_comes_before
from archlint.analysis.reach import argument, calls_of, creations_of, node_name, one_for_each_place, waits_for_ever
from archlint.analysis.source_code import SourceCode, source_code
from archlint.analysis.unused_results import is_thrown_away
from archlint.checks.folding import class_around, folds, of_one_class, of_one_package, package_around
from archlint.checks.limitless_calls import never_returns
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.checks.uncalled import uncalled_in_program
from archlint.checks.wait_words import (
    READY,
    WAIT_FOR_SERVER,
    WAIT_FOR_SERVICE,
    is_at_its_default,
    name_of,
    passed_on,
    related_path,
    server_words,
)
from archlint.connections.lessons import is_lesson
from archlint.connections.own_servers import is_served_by_its_node
from archlint.execution.asking_scripts import has_only_clients, is_step_of_asking_script
from archlint.execution.deaf_loops import DeafLoop, deaf_loops
from archlint.execution.expected_failures import expects_no_answer
from archlint.execution.future_loops import is_done_before
from archlint.execution.idle_nodes import taking_calls
from archlint.execution.own_futures import spins_for_a_message, spins_for_own_future, spins_for_own_task
from archlint.execution.present_servers import until_it_comes, was_waited_for
from archlint.execution.retries import is_retried
from archlint.execution.spins_beside import SpunBeside, spun_beside
from archlint.execution.stuck import spoken_of
from archlint.finding import Finding, Related, Severity
from archlint.model import Role
from archlint.model.given import Constant
from archlint.python_code.unspun_reads import unspun_reads

if TYPE_CHECKING:
    from archlint.model import ApiCall, Program
    from archlint.systems.model import System
_OF_A_SCRIPT = "script"
_BESIDE = "beside"
_DEAF = "deaf"
_LOOKS_FOR_SERVER = (WAIT_FOR_SERVICE, WAIT_FOR_SERVER, *READY)
_SPIN = "rclpy.spin_until_future_complete"
_EXECUTOR_SPIN = "rclpy.executors.Executor.spin_until_future_complete"


@rule("TMO003", scope=Scope.CODE, by_program=True, taste=True, lost_answers=False)
def spin_without_timeout(system: System, options: Options) -> Iterator[Finding]:
    """Spins until a future is complete that nothing limits.  Of a method that nothing calls, and of a client that
    nothing is seen to make, nobody knows whether it is ever there; a trial is ended by whoever runs it.  The answer of
    a server that has been found seldom gets lost: that is for ``lost-answers``."""
    reported = spoken_of(system, options.distros) | taking_calls(system)  # EXE008 says that these must not spin
    seldom = options.flag("lost-answers")
    yield from one_for_each_place(
        _limitless_spin(system, program, call, options)
        for program, call in calls_of(system, (_SPIN, _EXECUTOR_SPIN))
        if waits_for_ever(source_code(system), call, "timeout_sec") and call.place not in reported
        if not spins_for_own_future(call) or spins_for_a_message(system, call)
        if not spins_for_own_task(system, program, call)
        if call.context.role != Role.METHOD or _may_be_called(program, call)
        if not _is_refused(program, call) and not _may_be_meant_as_a_limit(source_code(system), call)
        if not _fails_before(system, call) and not is_in_copied_class(system, call)
        if not _is_uncalled(system, call) and not _is_all_there_is_to_do(system, program, call)
        if not is_done_before(source_code(system), call)
        if not _is_part_of_start(system, call) and not _is_never_reached(source_code(system), program, call)
        if seldom or not _comes_as_a_rule(system, program, call, options)
    )
    yield from one_for_each_place(_deaf(system, loop) for loop in deaf_loops(system))


def _may_be_called(program: Program, call: ApiCall) -> bool:
    """Whether a method that the program is not seen to call spins for the answer of a client that is known, and the
    program calls it on no other object of its class: if it does, that call says what the method is for."""
    if not creations_of(argument(call, "future")):
        return False
    others = (other for other in program.calls if other.place == call.place and other.api == call.api)
    return all(other.context.role == Role.METHOD for other in others)


def _fails_before(system: System, call: ApiCall) -> bool:
    """Whether a spin is given an attribute that nothing has assigned by then (API002)."""
    reads = () if system.workspace is None else unspun_reads(system.workspace)
    start, end = call.place.span[:2], call.place.span[2:]
    return any(read.place.file == call.file and start <= read.place.span[:2] <= end for read in reads)


def _is_uncalled(system: System, call: ApiCall) -> bool:
    """Whether a call is in a method of a program that nothing calls."""
    return call.context.role == Role.METHOD and uncalled_in_program(system, call.place) is not None


def _is_never_reached(code: SourceCode, program: Program, call: ApiCall) -> bool:
    """Whether a call in front of a spin never returns, as nothing can answer it: EXE009 tells of that one."""
    return any(
        never_returns(code, program, other) and always_comes_before(code, other, call) for other in program.calls
    )


def _is_all_there_is_to_do(system: System, program: Program, call: ApiCall) -> bool:
    """Whether a script that somebody starts by hand waits for an answer after it has found a server (of several, often
    not each is looked for), or for the end of a motion: it is there for nothing else, and Ctrl-C ends it."""
    if not is_step_of_asking_script(system, program, call) or not has_only_clients(program):
        return False
    if spins_for_a_result(system.workspace, call.place):
        return True
    code, clients = source_code(system), {client.place for client in creations_of(argument(call, "future"))}
    return any(
        other.api in _LOOKS_FOR_SERVER
        and (
            not clients.isdisjoint(client.place for client in creations_of(other.receiver))
            or always_comes_before(code, other, call)
        )
        and (waits_for_ever(code, other, "timeout_sec") or not is_thrown_away(code, other))
        for other in program.calls
    )


def _is_part_of_start(system: System, call: ApiCall) -> bool:
    """Whether a constructor has waited for the server until it came: without its answer the node has nothing to do."""
    functions = (call.function, *(hop.caller for hop in call.chain))
    in_constructor = any(name.rpartition(".")[2] == "__init__" for name in functions)
    return in_constructor and was_waited_for(system, call, creations_of(argument(call, "future")))


def _comes_as_a_rule(system: System, program: Program, call: ApiCall, options: Options) -> bool:
    """Whether the server has been looked for on every way to a spin, and no code is made for an answer that does not
    come, or the node that spins is the server itself.  The tutorial has such code, too: a program that only asks, or
    that has waited for the server until it came, has nothing else to do than to wait for its answer.  In a lesson, it
    is found only where something looks at what the wait says.  Whoever runs an example looks on."""
    code, clients = source_code(system), creations_of(argument(call, "future"))
    if spun_beside(code, call, program, options.distros) is not None:
        return False
    if is_example(call.file):
        return True
    if not clients:
        return False
    if all(map(is_served_by_its_node, clients)):
        return True
    places = {client.place for client in clients}
    looks = [
        other
        for other in program.calls
        if other.api in _LOOKS_FOR_SERVER
        and not places.isdisjoint(client.place for client in creations_of(other.receiver))
        and always_comes_before(code, other, call)
        and not (is_lesson(system) and is_thrown_away(code, other) and not until_it_comes(code, other))
    ]
    if not looks or not expects_no_answer(code, call):
        return bool(looks)
    if call.context.role not in (Role.MAIN, Role.MODULE):
        return False
    return has_only_clients(program) or (not call.looped and any(until_it_comes(code, other) for other in looks))


def _is_refused(program: Program, call: ApiCall) -> bool:
    """Whether it never comes to spin (API001)."""
    return any(refused.place == call.place for refused in program.refused_calls)


def _may_be_meant_as_a_limit(code: SourceCode, call: ApiCall) -> bool:
    """Whether something that may be a number stands where rclpy's function takes the executor, before the timeout."""
    executor = argument(call, "executor")
    if executor is None or any(given.keyword == "executor" for given in code.arguments(call)):
        return False
    return not any(option.executor or option == Constant(None) for option in executor.alternatives)


def _limitless_spin(system: System, program: Program, call: ApiCall, options: Options) -> Finding:
    beside = spun_beside(source_code(system), call, program, options.distros)
    if beside is not None:
        return _second_spin(system, call, beside)
    clients = creations_of(argument(call, "future"))
    client = clients[0] if len({creation.place for creation in clients}) == 1 else None
    result = _wait_for_its_result(system, program, call)
    awaited = f"the response from {server_words(system, client)} arrives" if client else "the future is complete"
    if spins_for_own_future(call):
        awaited = "the message that completes the future arrives"
    if result is not None or spins_for_a_result(
        system.workspace, call.place
    ):  # a server that is there answers a goal at once; how long a motion takes, nobody knows
        awaited = f"the result from {server_words(system, client)} arrives" if client else "the result arrives"
    at = result or call
    sent = [] if result is None else [Related(call.place, "so it spins for the answer to the goal")]
    diagnostic = finding(
        "TMO003",
        at.place,
        f"spins until {awaited}, without a timeout: if that never happens, the next line never runs",
        help=_help(system, at),
        related=[*sent, *related_path(at, client)],
        node=node_name(system, call.context.node),
        identity=(call.function, name_of(client), "spin_until_future_complete"),
        sites=sites_of_spin(system.workspace, at.place),
    )
    own = package_around(system.workspace, call.file)
    if is_step_of_asking_script(system, program, call):
        return replace(diagnostic, severity=Severity.INFO, group=(*own, _OF_A_SCRIPT))
    return replace(diagnostic, group=(*own, str(is_at_its_default(call))))


def _wait_for_its_result(system: System, program: Program, call: ApiCall) -> ApiCall | None:
    """The spin for the result of a goal whose answer a function has spun for before, where nothing limits either: a
    server that is there answers a goal at once, and how long a motion takes, nobody knows."""
    if spins_for_a_result(system.workspace, call.place):
        return None
    later = (other for other in program.calls if other.function == call.function and other.api == call.api)
    return next(
        (
            other
            for other in later
            if waits_for_ever(source_code(system), other, "timeout_sec")
            and spins_for_a_result(system.workspace, other.place)
            and always_comes_before(source_code(system), call, other)
        ),
        None,
    )


def _second_spin(system: System, call: ApiCall, beside: SpunBeside) -> Finding:
    """A limit is no cure: it does not come to wait, or it takes the node from its executor."""
    spun = [] if beside.place is None else [Related(beside.place, "the node is spun here")]
    diagnostic = finding(
        "TMO003",
        call.place,
        f"spins a node, and {beside.verdict.why}: this {beside.verdict.words}",
        help="wait here for a threading.Event that the future's done callback sets: the other thread gets the answer",
        related=[*spun, *related_path(call, None)],
        node=node_name(system, call.context.node),
        identity=(call.function, "", "spin_until_future_complete"),
    )
    return replace(diagnostic, group=(call.file, class_around(call.function), _BESIDE))


def _deaf(system: System, loop: DeafLoop) -> Finding:
    """A loop that asks for something between spins which never end."""
    call = loop.call
    spin = "rclpy.spin()" if call.api == "rclpy.spin" else "spin()"
    once = "rclpy.spin_once(…, timeout_sec=0.1)" if call.api == "rclpy.spin" else "spin_once(timeout_sec=0.1)"
    cure = f"write {once}, after which the loop asks again"
    misses, there = f"ask for {loop.asked} again", f"the loop asks for {loop.asked} here"
    if not loop.asked:
        cure = "add the nodes to one executor, and spin that"
        misses, there = "come to the next one", "the loop takes one after the other"
    diagnostic = finding(
        "TMO003",
        call.place,
        f"{spin} returns only when ROS is shut down: the loop does not {misses}",
        help=cure,
        related=[Related(loop.loop, there)],
        node=node_name(system, call.context.node),
        identity=(call.function, loop.asked, "loop"),
    )
    return replace(diagnostic, group=(call.file, class_around(call.function), _DEAF))


def _help(system: System, call: ApiCall) -> str:
    """What to write; how long a motion takes, its caller knows best."""
    if is_at_its_default(call):
        return passed_on(call)
    if spins_for_a_result(system.workspace, call.place):
        return "set a timeout_sec that is longer than any goal takes, and cancel the goal when it is over"
    if is_retried(source_code(system), call):
        return "set timeout_sec, and end the loop after some attempts"
    return "set timeout_sec, and check future.done() afterwards"


@folds("TMO003")
def _of_one_owner(findings: Sequence[Finding]) -> Finding:
    """The finding for all such spins of a package: its nodes ask in one way, and an action's goal is sent, and then its
    result awaited.  Those beside another spin are one for a class."""
    if findings[0].group[-1] in (_BESIDE, _DEAF):
        return of_one_class(findings, "line", "it spins here, too")
    return of_one_package(findings, "line", "it spins without a timeout here, too")

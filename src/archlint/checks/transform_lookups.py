"""EXE007: callbacks that wait for a transform which only their own thread could bring."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.analysis.reach import argument, calls_of, one_for_each_place
from archlint.analysis.source_code import SourceCode, source_code
from archlint.checks.callback_findings import finding_in_callback
from archlint.checks.folding import class_around, folds, with_places
from archlint.checks.registry import Options, rule
from archlint.checks.scope import Scope
from archlint.connections.lessons import is_lesson
from archlint.execution import blocking
from archlint.execution.callback_roles import callback_words, runs_in_executor
from archlint.execution.deadlock import threads_of
from archlint.execution.kept_waiting import Waiting, who_waits
from archlint.execution.sleeps import longest
from archlint.execution.spins import spun_node
from archlint.finding import Finding
from archlint.model.given import Constant

if TYPE_CHECKING:
    from archlint.model import ApiCall, Blueprint, Program
    from archlint.systems.model import System
_LOOKUPS = ("tf2_ros.buffer.Buffer.lookup_transform", "tf2_ros.buffer.Buffer.can_transform")
_LISTENER = "tf2_ros.transform_listener.TransformListener"


@rule("EXE007", scope=Scope.CODE)
def blocking_tf_lookup(system: System, options: Options) -> Iterator[Finding]:
    """Transform lookups with a timeout on the only thread that could bring the transform; in a lesson also where that
    delays nothing."""
    threaded = [
        (program, spun_node(call, program)) for program, call in calls_of(system, (_LISTENER,)) if _spins_itself(call)
    ]
    yield from one_for_each_place(
        finding_in_callback(
            "EXE007",
            system,
            program,
            call,
            f"{callback_words(call.context)} waits{_limit_words(call)} for a transform that cannot arrive: the "
            f"listener needs the thread that is waiting{_in_spite_of(threaded, program)}",
            help=(
                "look up the transform without a timeout and try again next time, or spin the node with a "
                "MultiThreadedExecutor"
            ),
            identity=(call.api,),
            group=(call.file, class_around(call.function)),
        )
        for program, call in calls_of(system, _LOOKUPS)
        if runs_in_executor(call.context)
        and _waits(call)
        and (is_lesson(system) or not _delays_nothing(source_code(system), program, call))
        and threads_of(call.context.node, program) == blocking.ONE
        # A thread of its own helps a listener that has a node of its own: this node's executor takes the node from it.
        and all(node is call.context.node for other, node in threaded if other is program)
    )


def _in_spite_of(threaded: Sequence[tuple[Program, Blueprint | None]], program: Program) -> str:
    """What became of a thread that the listener was given; the node is that of the callback."""
    if not any(other is program for other, _ in threaded):
        return ""
    return " (spin_thread=True does not help: the executor that spins the node takes it from the listener's thread)"


@folds("EXE007")
def _of_one_class(findings: Sequence[Finding]) -> Finding:
    """The finding for all lookups of a class: whether a transform is there, and then what it is, be it in another
    callback.  One executor is the cure, and what comes after a lookup that has succeeded hardly waits."""
    return with_places(findings, "it looks up a transform here, too")


def _delays_nothing(code: SourceCode, program: Program, call: ApiCall) -> bool:
    """Whether a timer's callback waits for less than its period, in a node that has nothing else to do: it looks again
    in its next turn, which comes in time."""
    period, seconds = None if call.context.creation is None else call.context.creation.period, _seconds(call)
    short = period is not None and seconds is not None and seconds < period and not call.looped
    return short and who_waits(code, call, program, but_listeners=True) == Waiting.NOBODY


def _seconds(call: ApiCall) -> float | None:
    return longest(argument(call, "timeout"))


def _waits(call: ApiCall) -> bool:
    seconds = _seconds(call)
    return seconds is not None and seconds > 0


def _limit_words(call: ApiCall) -> str:
    seconds = _seconds(call)
    return "" if seconds is None else f" {seconds:g} s"


def _spins_itself(call: ApiCall) -> bool:
    """``TransformListener(…, spin_thread=True)``, or an argument that may be true."""
    value = argument(call, "spin_thread")
    return value is not None and not (isinstance(value, Constant) and not value.value)

"""EXE009: waits that nothing can end."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.analysis.reach import node_name, one_for_each_place
from archlint.checks.folding import folds, with_others
from archlint.checks.joins import endless_joins
from archlint.checks.limitless_calls import unanswerable_calls, unanswerable_loops
from archlint.checks.rate_sleeps import endless_sleeps
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.execution.attribute_loops import AttributeLoop, attribute_loops
from archlint.execution.callback_roles import callback_words
from archlint.execution.queue_waits import QueueWait, queue_waits
from archlint.finding import Finding, Related
from archlint.model import Role

if TYPE_CHECKING:
    from archlint.systems.model import System


@rule("EXE009", scope=Scope.CODE, by_program=True, in_use=True)
def unanswerable_wait(system: System, options: Options) -> Iterator[Finding]:
    """Calls that nobody can answer while they wait, and loops that wait for what they keep from happening."""
    yield from one_for_each_place(unanswerable_calls(system, options))
    yield from one_for_each_place(unanswerable_loops(system))
    yield from one_for_each_place(endless_sleeps(system))
    yield from one_for_each_place(endless_joins(system, options))
    for loop in attribute_loops(system):
        yield _endless(system, loop)
    for wait in queue_waits(system):
        yield _empty(system, wait)


def _endless(system: System, loop: AttributeLoop) -> Finding:
    setter, waiting = loop.setter, loop.waiting
    who = "the program" if waiting is None else callback_words(waiting)
    return finding(
        "EXE009",
        loop.place,
        f"once {who} is in this loop, it never ends: {_who_changes(loop)} run meanwhile, since {loop.why}",
        help=_instead(loop),
        related=[Related(setter.place, f"{setter.name} changes {loop.attribute}")],
        node=node_name(system, loop.node),
        identity=("" if waiting is None else waiting.name, loop.attribute.partition(".")[2]),
        group=(loop.place.file, loop.attribute, setter.name.rpartition(".")[0]),
    )


def _who_changes(loop: AttributeLoop) -> str:
    if not loop.others:
        return f"only {loop.setter.name} changes {loop.attribute}, and it cannot"
    return f"only callbacks such as {loop.setter.name} change {loop.attribute}, and none of them can"


@folds("EXE009")
def _of_one_attribute(findings: Sequence[Finding]) -> Finding:
    """One finding for the loops of a class that wait for the same attribute."""
    return with_others(findings, "another loop waits", "more loops wait", f"for {findings[0].group[1]} like that")


def _empty(system: System, wait: QueueWait) -> Finding:
    setter, waiting, name = wait.setter, wait.waiting, wait.attribute
    fills, state = _FILLED.get(wait.made_by, ("puts something into", " where {} is empty"))
    it = "it" if state else name
    return finding(
        "EXE009",
        wait.place,
        f"{wait.method}() never returns{state.format(name)}: only {setter.name} {fills} {it}, and it cannot run "
        f"meanwhile, since {wait.why}",
        help=f"go on in {setter.name}" if waiting is not None else "spin until it is there, instead of waiting",
        related=[Related(setter.place, f"{setter.name} {fills} {name}")],
        node=node_name(system, wait.node),
        identity=("" if waiting is None else waiting.name, name.partition(".")[2], wait.method),
    )


_FILLED = {
    "threading.Event": ("sets", " where {} is not set"),
    "threading.Condition": ("notifies", ""),
    "threading.Semaphore": ("releases", " where {} is 0"),
    "threading.BoundedSemaphore": ("releases", " where {} is 0"),
}
"""What is done to that which is waited for, and when the wait has no end."""


_ANSWERS = (Role.EXECUTE, Role.SERVICE)


def _instead(loop: AttributeLoop) -> str:
    if loop.waiting is None:
        return f"spin in the loop: rclpy.spin_once({loop.attribute.partition('.')[0]}, timeout_sec=0.1)"
    if loop.waiting.role in _ANSWERS:  # what it returns is the answer: it cannot go on elsewhere
        return "give this callback its own callback group, and spin the node with a MultiThreadedExecutor"
    return f"return instead, and go on in {loop.setter.name}"

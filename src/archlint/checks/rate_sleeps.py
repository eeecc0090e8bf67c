"""What EXE009 says of rates: those that sleep on the thread that would have to spin their node meanwhile.

Source: ``Rate`` in rclpy/timer.py waits for an event that its timer sets.  It remembers a tick that came while nothing
slept, so that a ``spin_once()`` without a limit, which returns when the timer is due, lets the next sleep pass.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.analysis.kept import once
from archlint.analysis.order import always_comes_before
from archlint.analysis.reach import argument, calls_of, node_name
from archlint.analysis.source_code import SourceCode, source_code
from archlint.checks.limitless_calls import is_unanswerable_at_start
from archlint.checks.registry import finding
from archlint.execution.loop_tests import is_only_after_shutdown
from archlint.execution.piling_rates import RATE_SLEEP
from archlint.execution.spins import is_spin_call
from archlint.execution.unfollowed_spins import may_be_spun_later
from archlint.finding import Finding, Related
from archlint.model import EntityKind, Role
from archlint.model.given import Constant

if TYPE_CHECKING:
    from archlint.model import ApiCall, Program
    from archlint.systems.model import System

_ONCE = frozenset({"rclpy.spin_once", "rclpy.executors.Executor.spin_once"})
_TAKE_IN = frozenset({EntityKind.SUBSCRIBER, EntityKind.SERVICE, EntityKind.ACTION_SERVER, EntityKind.TIMER})
"""What else a node may have that brings ``spin_once()`` work."""


def endless_sleeps(system: System) -> Iterator[Finding]:
    """Sleeps of rates that nothing ends, since nobody spins the node while they sleep."""
    code, endless = source_code(system), _endless(system)
    for call, spins in endless:
        if any(_is_never_left(code, other, call) for other, missing in endless if not missing):
            continue
        if not spins:
            yield _finding(
                system, call, "nothing spins the node while this thread sleeps, so its timer never wakes it", []
            )
        else:
            why = "the timer that wakes it runs in spin_once() only, which takes one callback at a time"
            yield _finding(system, call, why, spins)


def _is_never_left(code: SourceCode, first: ApiCall, later: ApiCall) -> bool:
    """Whether a program cannot get to a sleep but through another one, which never ends."""
    return first.context is later.context and first.place != later.place and always_comes_before(code, first, later)


def asleep(system: System) -> frozenset[int]:
    """The identities of the nodes that such a sleep keeps from ever being spun."""
    return frozenset(id(call.creation.node) for call, spins in _endless(system) if call.creation and not spins)


@once
def _endless(system: System) -> list[tuple[ApiCall, Sequence[ApiCall]]]:
    """Each such sleep, and the spins in its loop that miss the rate's timer."""
    endless: list[tuple[ApiCall, Sequence[ApiCall]]] = []
    code = source_code(system)
    for program, call in calls_of(system, (RATE_SLEEP,)):
        if call.creation is None or not call.enclosing_loops or not _is_alone(program, call):
            continue
        loops = (code.loop_at(place) for place in call.enclosing_loops)
        if any(loop is not None and is_only_after_shutdown(loop) for loop in loops):
            continue
        spins = [other for other in program.calls if is_spin_call(other) and _in_one_loop(other, call)]
        if may_be_spun_later(system, program, call.creation.node):
            continue
        if all(_misses_the_timer(spin, call) for spin in spins):
            endless.append((call, spins))
    return endless


def _is_alone(program: Program, call: ApiCall) -> bool:
    """Whether a program that is there in full sleeps on the one thread that could spin the node."""
    whole = program.executable or call.context.role in (Role.MAIN, Role.MODULE)
    return whole and is_unanswerable_at_start(program, call)


def _in_one_loop(spin: ApiCall, sleep: ApiCall) -> bool:
    return not set(spin.enclosing_loops).isdisjoint(sleep.enclosing_loops)


def _misses_the_timer(spin: ApiCall, sleep: ApiCall) -> bool:
    """Whether a spin may return before the timer of the rate has run: the sleep after it never ends then."""
    rate = sleep.creation
    assert rate is not None
    if spin.api not in _ONCE:
        return False
    if any(other.kind in _TAKE_IN and other is not rate and not other.destroyed for other in rate.node.creations):
        return True
    limit = argument(spin, "timeout_sec")
    known = isinstance(limit, Constant) and isinstance(limit.value, (int, float)) and rate.period is not None
    return known and 0 <= limit.value < rate.period  # type: ignore[union-attr]


def _finding(system: System, call: ApiCall, why: str, spins: Sequence[ApiCall]) -> Finding:
    return finding(
        "EXE009",
        call.place,
        f"Rate.sleep() {'blocks for ever' if not spins else 'soon blocks for ever'}: {why}",
        help="do the work in a timer callback and call rclpy.spin(), or spin the node in another thread",
        related=[Related(spin.place, "the node is spun here, in the same thread") for spin in spins],
        node=node_name(system, call.node or call.context.node),
        identity=(call.function, "Rate.sleep"),
    )


__all__ = ["asleep", "endless_sleeps"]

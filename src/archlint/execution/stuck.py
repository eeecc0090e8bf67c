"""Waits that cannot end well where they stand: what is to be said of them says it all about the line.

A rule about limits is silent there: a limit would always expire.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.analysis.reach import creations_of
from archlint.execution import blocking
from archlint.execution.callback_roles import runs_in_executor
from archlint.execution.deadlock import Verdict, judge_spin, judge_wait
from archlint.execution.waits import Wait, waits
from archlint.model import Role

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.systems.model import System


def nested_waits(system: System, distros: Sequence[str]) -> Iterator[tuple[Wait, Verdict]]:
    """The waits of service handlers, each with what becomes of it (SRV003)."""
    for wait in waits(system):
        if wait.call.context.role == Role.SERVICE:
            yield wait, _verdict(wait, distros)


def clients_of_handlers(system: System, distros: Sequence[str]) -> frozenset[tuple[Place, Place]]:
    """The service handlers that SRV003 speaks of, each with the clients that it asks: where both are."""
    return frozenset(
        (wait.call.context.place, creation.place)
        for wait, _ in nested_waits(system, distros)
        for creation in creations_of(wait.call.receiver) or (wait.client,)
    )


def clients_of_stuck_callbacks(system: System, distros: Sequence[str]) -> frozenset[tuple[Place, Place]]:
    """The other callbacks with a wait of which EXE002 and CBG001 speak, each with the clients that it asks."""
    return frozenset(
        (wait.call.context.place, creation.place)
        for wait, _ in stuck_waits(system, distros)
        if not is_spin(wait)
        for creation in creations_of(wait.call.receiver) or (wait.client,)
    )


def functions_that_ask(system: System, distros: Sequence[str]) -> frozenset[tuple[str, str, Place]]:
    """The functions with a wait that SRV003 speaks of, each with the clients that it asks: file, function, client."""
    return frozenset(
        (wait.call.file, wait.call.function, creation.place)
        for wait, _ in nested_waits(system, distros)
        for creation in creations_of(wait.call.receiver) or (wait.client,)
    )


def stuck_waits(system: System, distros: Sequence[str]) -> Iterator[tuple[Wait, Verdict]]:
    """The waits of other callbacks that do not end well, for certain (EXE002, CBG001; spins are EXE001's)."""
    for wait in waits(system):
        if wait.call.context.role == Role.SERVICE or not runs_in_executor(wait.call.context):
            continue
        verdict = _verdict(wait, distros)
        if not verdict.safe and not verdict.unknown:
            yield wait, verdict


def spoken_of(system: System, distros: Sequence[str]) -> frozenset[Place]:
    """The calls of which these rules say that they wait in the wrong place."""
    judged_waits = (*nested_waits(system, distros), *stuck_waits(system, distros))
    return frozenset(wait.call.place for wait, _ in judged_waits)


def nested_spins(system: System, distros: Sequence[str]) -> frozenset[Place]:
    """The spins of service handlers that SRV003 speaks of: the calls, and the loops around them."""
    spins = [wait.call for wait, _ in nested_waits(system, distros) if is_spin(wait)]
    return frozenset(place for call in spins for place in (call.place, *call.loops[-1:]))


def _verdict(wait: Wait, distros: Sequence[str]) -> Verdict:
    if wait.on_global_executor:
        node = wait.client.node
        verdict = judge_spin(wait.call, node, wait.client, wait.program, wait.limited, distros, True)
    else:
        verdict = judge_wait(wait.kind, wait.call, wait.client, wait.program, wait.limited, distros)
    return replace(verdict, goes_round=wait.goes_round, limited=wait.limited)


def is_spin(wait: Wait) -> bool:
    return wait.kind == blocking.SPIN

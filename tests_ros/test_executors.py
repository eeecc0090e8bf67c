"""A part of the executor matrix: what becomes of a wait in a callback, as archlint says it and as the table has it."""

from __future__ import annotations

import itertools

import pytest
from benchmarks.executors import table
from benchmarks.executors.cells import Cell, makes_sense
from benchmarks.executors.running import observe, outcome
from benchmarks.executors.verdicts import agrees, verdicts

from tests_ros.environments import Environment

JOBS = 10
CELLS = sorted(
    cell
    for cell in (
        *(
            Cell(*words)
            for words in itertools.product(
                ("call", "call_limit", "await", "spin"),
                ("service", "timer"),
                ("single", "multi4"),
                ("default", "apart"),
            )
        ),
        Cell("loop", "subscription", "spin", "default"),
        Cell("event", "subscription", "multi4", "reentrant"),
        Cell("spin_here", "timer", "single", "default"),
        Cell("spin_fresh", "timer", "spin", "apart"),
        Cell("result", "timer", "single", "default"),
        Cell("rate_twice", "timer", "spin", "default"),
        Cell("goal", "timer", "multi4", "default"),
        Cell("message", "service", "spin", "default"),
        Cell("call", "execute", "multi4", "default"),
        Cell("call", "parameter", "multi4", "default"),
        Cell("call", "guard", "multi4", "default"),
        Cell("call", "task", "single", "default"),
        Cell("await", "done", "single", "default"),
        Cell("done", "timer", "single", "default"),
        Cell("call", "timer", "multi2", "reentrant", 1.5),
        Cell("await", "timer", "multi2", "reentrant", 1.5),
    )
    if makes_sense(cell)
)
"""Each way to wait, each kind of end, and what was once wrong."""


@pytest.fixture(scope="session")
def seen(environment: Environment) -> dict[Cell, str]:
    """What each cell does; one that does not do what it did is tried once more, on a machine that may be busy."""
    first = {cell: outcome(said, cell) for cell, said in observe(environment, CELLS, JOBS)}
    known = table.read()[environment.distro]
    other = [cell for cell in CELLS if first[cell] not in table.outcomes_of(known[cell])]
    return first | {cell: outcome(said, cell) for cell, said in observe(environment, other, JOBS)}


@pytest.fixture(scope="session")
def said(environment: Environment) -> dict[Cell, str]:
    return verdicts(CELLS, (environment.distro,))[environment.distro]


@pytest.mark.parametrize("cell", CELLS, ids=lambda cell: cell.name)
def test_a_wait_ends_as_archlint_says(cell: Cell, seen: dict[Cell, str], said: dict[Cell, str]):
    assert agrees(said[cell], seen[cell], cell), f"archlint: {said[cell]}; seen: {seen[cell]}"


@pytest.mark.parametrize("cell", CELLS, ids=lambda cell: cell.name)
def test_the_table_has_what_is_seen(cell: Cell, seen: dict[Cell, str], environment: Environment):
    assert seen[cell] in table.outcomes_of(table.read()[environment.distro][cell])

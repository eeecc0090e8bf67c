"""What archlint says of programs whose outcome under rclpy is in the tables: a sample of what ``compare`` goes through.

A message that gets another wording must not be read as another verdict without anybody noticing.
"""

from __future__ import annotations

import hashlib
from collections import Counter
from collections.abc import Callable, Iterable
from typing import TypeVar

import pytest
from benchmarks.claims import table as claims_table
from benchmarks.claims.model import REPORTED
from benchmarks.claims.trying import RULES, all_claims, findings, said
from benchmarks.executors import table
from benchmarks.executors.cells import all_cells
from benchmarks.executors.running import HANGS, NOTHING, STRANDS, WORKS
from benchmarks.executors.verdicts import NO_SLEEP, RACES, STARVES, TIMEOUT, agrees, verdicts

_T = TypeVar("_T")

KNOWN = ("slow_rate-timer-multi2-callback_reentrant", "spin_here-feedback-multi4-reentrant")
"""The cells that still do not agree, as benchmarks/figures/graph.md says."""


def sample(things: Iterable[_T], name: Callable[[_T], str], number: int) -> list[_T]:
    """Some of them, always the same, whatever is added to or taken from the others."""
    return sorted(things, key=lambda thing: hashlib.sha256(name(thing).encode()).digest())[:number]


def test_the_waits_of_the_matrix():
    cells = sample(all_cells(), lambda cell: cell.name, 60)
    observed, words = table.read(), verdicts(cells, table.DISTROS)
    for distro in table.DISTROS:
        differ = {
            cell.name: (words[distro][cell], observed[distro][cell])
            for cell in cells
            if not all(agrees(words[distro][cell], seen, cell) for seen in table.outcomes_of(observed[distro][cell]))
        }
        assert {name: row for name, row in differ.items() if name not in KNOWN} == {}


# One cell for each word that messages are read for.
WORDS = {
    "call-timer-spin-default": HANGS,
    "call_limit-timer-spin-apart": TIMEOUT,
    "loop_limit-timer-spin-default": NOTHING,
    "call-timer-multi4-apart": WORKS,
    "call-timer-multi2-reentrant": STARVES,
    "call-service-multi4-reentrant": STARVES,
    "call-subscription-multi2-reentrant-0.3s": STARVES,
    "call-timers-multi2-apart": STARVES,
    "message_limit-timer-multi2-reentrant": STARVES,
    "rate-timer-spin-default": NO_SLEEP,
    "spin-timer-multi4-apart": STRANDS,
    "spin_here-timer-single-apart": f"raises RuntimeError, before: {WORKS}",
    "spin_here-timer-multi4-apart": f"raises RuntimeError, before: {RACES}",
    "spin_here-timer-multi1-apart": f"raises RuntimeError, before: {HANGS}",
    "spin_here_limit-timer-single-default": f"raises RuntimeError, before: {NOTHING}",
}


def test_each_word_of_the_messages_is_read():
    cells = [cell for cell in all_cells() if cell.name in WORDS]
    said_of = verdicts(cells, ("kilted",))["kilted"]
    assert {cell.name: said_of[cell] for cell in cells} == WORDS


@pytest.mark.parametrize("distro", claims_table.DISTROS)
def test_the_claims_of_the_pages(distro: str):
    claims = sample(all_claims(), lambda claim: claim.name, 40)
    observed = claims_table.read(set(claims))[distro]
    reported = {claim: said(rows) for claim, rows in findings(claims, distro).items()}
    differ = [
        claim.name for claim, word in reported.items() if not RULES[claim.rule].bears_out(claim, word, observed[claim])
    ]
    assert differ == []
    assert Counter(reported.values())[REPORTED] > 5

"""The matrix of what waits become: whole, and read rightly."""

from __future__ import annotations

import itertools

import pytest

from archlint.analysis import blocking
from archlint.analysis.blocking import (
    ANY,
    AWAIT,
    CALL,
    LIMITED_SPIN,
    MATRIX,
    NOBODY,
    ONE,
    OTHER,
    REENTRANT,
    SAME,
    SEVERAL,
    SPIN,
    TIMED_CALL,
    UNCLEAR,
    in_distros,
    look_up,
    outcome_words,
)
from archlint.config.settings import DISTROS


def test_there_is_a_row_for_everything_in_every_distribution():
    forms = {form for form, _, _ in MATRIX}
    cells = itertools.product(forms, (ONE, SEVERAL, NOBODY, ANY), (SAME, OTHER, REENTRANT, UNCLEAR))
    assert all(tuple(MATRIX[cell]) == DISTROS for cell in cells)


@pytest.mark.parametrize(
    ("form", "threads", "relation", "safe", "unknown"),
    [
        (CALL, ONE, OTHER, False, False),
        (CALL, SEVERAL, SAME, False, False),
        (CALL, SEVERAL, REENTRANT, True, False),
        (CALL, SEVERAL, UNCLEAR, False, True),
        (CALL, ANY, SAME, False, False),
        (CALL, ANY, OTHER, False, True),
        (TIMED_CALL, SEVERAL, OTHER, True, False),
        (TIMED_CALL, ONE, OTHER, False, False),
        (AWAIT, ONE, OTHER, True, False),
        (AWAIT, SEVERAL, SAME, False, False),
        (SPIN, ONE, OTHER, False, False),
    ],
)
def test_verdicts(form: str, threads: str, relation: str, safe: bool, unknown: bool):
    verdict = look_up(form, threads, relation, "because")
    assert (verdict.safe, verdict.unknown) == (safe, unknown)


def test_humble_lets_a_nested_spin_of_another_group_in():
    assert look_up(LIMITED_SPIN, ONE, OTHER, "", ["humble"]).safe
    assert not look_up(LIMITED_SPIN, ONE, OTHER, "", ["jazzy"]).safe


def test_a_timeout_that_humble_does_not_know_is_no_deadlock_there():
    verdict = look_up(TIMED_CALL, ONE, SAME, "", ["humble"])
    assert verdict.words == "raises TypeError (call() has no timeout_sec)"


@pytest.mark.parametrize(
    ("distros", "words"),
    [
        (DISTROS, ""),
        (("humble",), "in humble"),
        (("humble", "jazzy"), "up to jazzy"),
        (("kilted", "lyrical", "rolling"), "from kilted on"),
        (("rolling",), "in rolling"),
        (("humble", "kilted"), "in humble and kilted"),
    ],
)
def test_distributions_in_words(distros: tuple[str, ...], words: str):
    assert in_distros(distros) == words


def test_outcomes_in_words():
    assert outcome_words({"humble": blocking.Outcome.HANGS, "jazzy": blocking.Outcome.HANGS}) == "deadlocks"
    mixed = {"humble": blocking.Outcome.HANGS, "jazzy": blocking.Outcome.RAISES_NESTED}
    assert outcome_words(mixed) == "deadlocks in humble and raises 'Executor is already spinning' in jazzy"

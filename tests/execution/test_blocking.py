"""The matrix of what waits become: whole, and read rightly."""

from __future__ import annotations

import itertools

import pytest

from archlint.config.settings import DISTROS
from archlint.execution import blocking
from archlint.execution.blocking import (
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


def test_the_reason_is_the_one_that_is_given_or_that_humble_lacks_the_argument():
    assert look_up(CALL, ONE, SAME, "one thread", ["humble"]).why == "one thread"
    assert look_up(TIMED_CALL, ONE, SAME, "one thread", ["humble"]).why == "humble does not have this argument"
    assert look_up(TIMED_CALL, ONE, SAME, "one thread", ["humble", "jazzy"]).why == "one thread"


@pytest.mark.parametrize(
    ("distros", "before"),
    [
        (["humble"], ""),
        (["lyrical"], ""),
        (["jazzy"], " (deadlocks before rclpy 7.1.9)"),
        (["humble", "kilted"], " (deadlocks in kilted before rclpy 9.1.5)"),
        (["jazzy", "kilted"], " (deadlocks in jazzy before rclpy 7.1.9 and kilted before rclpy 9.1.5)"),
    ],
)
def test_what_earlier_releases_do_with_a_nested_spin(distros: list[str], before: str):
    verdict = look_up(SPIN, ONE, SAME, "", distros)
    assert verdict.words == outcome_words(verdict.outcomes) + before


@pytest.mark.parametrize("relation", [SAME, OTHER, REENTRANT, UNCLEAR])
def test_a_nested_spin_of_the_only_thread_of_a_pool_never_ends_well(relation: blocking.Relation):
    assert look_up(SPIN, blocking.POOL_OF_ONE, relation, "", ["humble"]).words == "deadlocks"
    assert look_up(LIMITED_SPIN, blocking.POOL_OF_ONE, relation, "", ["humble"]).words == "always times out"


def test_an_action_client_may_raise_where_several_threads_spin():
    verdict = look_up(SPIN, SEVERAL, OTHER, "", ["humble", "jazzy"]).with_an_action_client()
    raised = "raises 'Executor is already spinning'"
    either = "sometimes deadlocks or raises RCLError or ValueError"
    assert verdict.words == f"{either} in humble and {raised} in jazzy ({either} in jazzy before rclpy 7.1.9)"
    limited = look_up(LIMITED_SPIN, SEVERAL, OTHER, "why", ["humble"]).with_an_action_client()
    assert (limited.words, limited.why) == ("sometimes times out or raises RCLError or ValueError", "why")
    hanging = look_up(SPIN, ONE, SAME, "", ["jazzy"])
    assert hanging.with_an_action_client() == hanging


def test_a_call_that_loses_its_node_in_old_releases_of_one_distribution():
    verdict = look_up(CALL, ONE, SAME, "why", ["humble", "jazzy"]).stranding_before("humble", "3.3.17")
    assert verdict.words.startswith("deadlocks; in humble before rclpy 3.3.17 it takes the node away")
    assert look_up(CALL, ONE, SAME, "", ["jazzy"]).stranding_before("humble", "3.3.17").words == "deadlocks"


def test_three_outcomes_and_the_last_two_distributions_in_words():
    outcome = blocking.Outcome
    mixed = {"humble": outcome.HANGS, "jazzy": outcome.FINE, "kilted": outcome.TIMES_OUT}
    assert outcome_words(mixed) == "deadlocks in humble, works in jazzy and always times out in kilted"
    assert in_distros(DISTROS[-2:]) == f"from {DISTROS[-2]} on"
    assert in_distros(DISTROS[:3]) == f"up to {DISTROS[2]}"


def test_two_threads_in_one_spin_may_clash_where_the_group_keeps_the_answer_out():
    assert look_up(LIMITED_SPIN, SEVERAL, SAME, "", ["humble"]).words == "times out or raises ValueError"
    assert look_up(LIMITED_SPIN, ONE, SAME, "", ["humble"]).words == "always times out"

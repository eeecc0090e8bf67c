"""A few of the programs that try what the pages of rules say: they do what the table has, and what archlint says."""

from __future__ import annotations

import pytest
from benchmarks.claims import table
from benchmarks.claims.model import Claim
from benchmarks.claims.trying import RULES, all_claims, findings, observe, said

from tests_ros.environments import Environment

CLAIMS = [
    Claim("EXE003", "sleep", "subscription", "spin"),
    Claim("EXE003", "sleep", "subscription", "multi4", "callback_apart"),
    Claim("EXE005", "kept", "subscription.publisher"),
    Claim("EXE005", "itself", "subscription.publisher"),
    Claim("EXE006", "none", "subscription"),
    Claim("EXE006", "one", "timer"),
    Claim("EXE006", "two", "execute"),
    Claim("EXE008", "second_spin", "timer"),
    Claim("EXE008", "thread_executor", "timer"),
    Claim("CBG002", "sleep", "timer", "spin", "two"),
    Claim("CBG002", "await", "timer", "spin", "two"),
    Claim("SRV006", "call", "2 nodes", "multi4", "apart"),
]
"""One of each kind of outcome: how long they take is how long CI takes."""


@pytest.fixture(scope="session")
def seen(environment: Environment) -> dict[Claim, str]:
    """What each program does; one that does not do what it did is tried once more, on a machine that may be busy."""
    known = table.read(set(all_claims()))[environment.distro]
    first = dict(observe(environment, CLAIMS, len(CLAIMS)))
    other = [claim for claim in CLAIMS if first.get(claim) != known[claim]]
    return first | dict(observe(environment, other, len(CLAIMS)))


@pytest.mark.parametrize("claim", CLAIMS, ids=lambda claim: claim.name)
def test_the_table_has_what_is_seen(claim: Claim, seen: dict[Claim, str], environment: Environment):
    assert seen[claim] == table.read({claim})[environment.distro][claim]


def test_archlint_says_what_is_seen(seen: dict[Claim, str], environment: Environment):
    found = findings(CLAIMS, environment.distro)
    wrong = [claim.name for claim in CLAIMS if not RULES[claim.rule].bears_out(claim, said(found[claim]), seen[claim])]
    assert wrong == []

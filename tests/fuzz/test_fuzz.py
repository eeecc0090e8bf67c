"""Made-up workspaces, always the same few: what must be true of any run.

``make fuzz`` looks at as many others as there is time for.
"""

from __future__ import annotations

import pytest
from benchmarks.fuzz.cases import FOLDER, Case, load
from benchmarks.fuzz.properties import PROPERTIES
from benchmarks.fuzz.runs import counted_calls
from benchmarks.fuzz.workspaces import states_for
from hypothesis import HealthCheck, Phase, given, settings

CALLS = 20_000_000
"""Calls of Python functions in all runs over one workspace, up to ten.  A plain run needs a hundredth of that."""
EXAMPLES = {
    "keeps_its_contract": 8,
    "says_the_same_again": 4,
    "follows_an_edit": 4,
    "is_the_same_reformatted": 5,
    "can_be_suppressed": 4,
    "can_be_fixed": 6,
}


@pytest.mark.parametrize("name", PROPERTIES)
def test_of_made_up_workspaces(name: str):
    @settings(
        max_examples=EXAMPLES[name],
        derandomize=True,
        database=None,
        phases=[Phase.generate],
        suppress_health_check=list(HealthCheck),
    )
    @given(states_for(name))
    def holds(states):
        with counted_calls(CALLS):
            PROPERTIES[name](*states)

    holds()


@pytest.mark.parametrize("path", sorted(FOLDER.glob("*.json")), ids=lambda path: path.stem)
def test_what_once_failed(path):
    case = load(path)
    with counted_calls(CALLS):
        PROPERTIES[case.property](*case.states)


def test_a_case_is_read_as_it_was_written(tmp_path):
    case = Case("keeps_its_contract", "ValueError: x", ({"a/b.py": b"\xff\r\n\x0cx = '\xc3\xbc'\n", "c": b""},))
    path = case.save(tmp_path)
    assert load(path) == case
    assert path.name.startswith("keeps_its_contract-")
    assert case.save(tmp_path) == path

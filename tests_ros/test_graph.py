"""Every program of ``fixtures/`` really runs, and what it is then is what archlint read from its source."""

from __future__ import annotations

import pytest

from tests_ros.cases import (
    CANNOT_RUN,
    FORM_CASES,
    FORMS,
    LAUNCHED,
    STARTED_FORMS,
    STARTED_WORKSPACES,
    WORKSPACE_CASES,
    Case,
    needed,
)
from tests_ros.conftest import Runs
from tests_ros.judging import count, problems
from tests_ros.running import Observed, Program, Servers, observe


def of(cases: list[Case]) -> pytest.MarkDecorator:
    """A test for each case; what cannot run is skipped, with the reason."""
    skipped = {name: pytest.mark.skip(reason=reason) for name, reason in CANNOT_RUN.items()}
    return pytest.mark.parametrize(
        "case", [pytest.param(one, id=one.id, marks=skipped.get(one.name, ())) for one in cases]
    )


@of(FORM_CASES)
def test_a_form_is_what_runs(case: Case, runs: Runs):
    judge(case, runs)


@of(STARTED_FORMS)
def test_a_form_that_a_launch_file_starts_is_what_runs(case: Case, runs: Runs):
    """The same names, remappings and parameters, in a launch file for archlint and on command lines for ROS."""
    judge(case, runs)


@of(WORKSPACE_CASES)
def test_a_workspace_is_what_runs(case: Case, runs: Runs):
    judge(case, runs)


@of(STARTED_WORKSPACES)
def test_a_workspace_that_a_launch_file_starts_is_what_runs(case: Case, runs: Runs):
    judge(case, runs)


@of(LAUNCHED)
def test_a_fixture_s_launch_file_is_what_runs(case: Case, runs: Runs):
    judge(case, runs)


def judge(case: Case, runs: Runs) -> None:
    ready, observed = runs.of(case)
    count(case, ready, observed)
    found = problems(case, ready, observed) if observed.nodes else ["nothing ran"]
    if found:
        pytest.fail("\n".join([*found, *(f"{target} said: {text}" for target, text in observed.said.items() if text)]))


def test_an_action_is_remapped_by_its_name_since_rcl_action_9_2_8(servers: Servers):
    environment = servers.environment
    held = Program(str(FORMS / "held_nodes.py"), (), ("--ros-args", "-r", "left/focus:=moved"))
    server = servers.of(environment.interfaces(*needed(FORMS / "held_nodes.py", FORMS)))

    def there(observed: Observed) -> bool:
        return bool(observed.nodes.get("/left_arm", {}).get("action_clients"))

    nodes = observe(server, [held], FORMS, there).nodes
    final = "/moved" if environment.remaps_actions else "/left/focus"
    assert nodes["/left_arm"]["action_clients"] == [[final, "example_interfaces/action/Fibonacci", None]]

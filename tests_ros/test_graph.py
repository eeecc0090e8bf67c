"""Every program of ``fixtures/`` really runs, and what it is then is what archlint read from its source."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests_ros.cases import (
    CANNOT_RUN,
    FORM_CASES,
    FORMS,
    LAUNCHED,
    ONLY_FULL,
    STARTED_FORMS,
    STARTED_WORKSPACES,
    WORKSPACE_CASES,
    Case,
    copy_forms,
    needed,
)
from tests_ros.conftest import Runs
from tests_ros.judging import count, problems
from tests_ros.reading import launched
from tests_ros.running import Observed, Program, Servers, observe


def of(cases: list[Case]) -> pytest.MarkDecorator:
    """A test for each case; what cannot run is skipped, with the reason."""
    return pytest.mark.parametrize("case", [pytest.param(one, id=one.id, marks=marks(one)) for one in cases])


def marks(case: Case) -> list[pytest.MarkDecorator]:
    if case.name in CANNOT_RUN:
        return [pytest.mark.skip(reason=CANNOT_RUN[case.name])]
    return [pytest.mark.full] if case in ONLY_FULL else []


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
    if not observed.nodes or problems(case, ready, observed):
        observed = runs.again(case)
    count(case, ready, observed)
    found = problems(case, ready, observed) if observed.nodes else ["nothing ran"]
    if found:
        pytest.fail("\n".join([*found, *(f"{target} said: {text}" for target, text in observed.said.items() if text)]))


def test_an_action_is_remapped_by_its_name_since_rcl_action_9_2_8(servers: Servers, tmp_path: Path):
    """An older one, as in Humble, does nothing with such a rule; so does the graph for Humble."""
    environment, root = servers.environment, tmp_path / "workspace"
    copy_forms(root)
    remap = '<remap from="left/focus" to="moved"/>'
    (root / "arms.launch.xml").write_text(f'<launch><node pkg="forms" exec="held_nodes.py">{remap}</node></launch>')
    distro = environment.distro if environment.remaps_actions else "humble"
    nodes, [process] = launched(root, "arms.launch.xml", {}, root, distro)
    said = [end["name"] for node in nodes if node["name"] == "/left_arm" for end in node["action_clients"]]

    def clients(observed: Observed) -> list[str]:
        return [end[0] for end in observed.nodes.get("/left_arm", {}).get("action_clients", [])]

    server = servers.of(environment.interfaces(*needed(FORMS / "held_nodes.py", FORMS)))
    program = Program(str(root / "forms" / "held_nodes.py"), (), process.arguments)
    seen = clients(observe(server, [program], root, lambda now: bool(clients(now))))
    assert said == seen == ["/moved" if environment.remaps_actions else "/left/focus"]

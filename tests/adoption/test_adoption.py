"""A team takes archlint up, on two small workspaces; `make adoption` does it with pre-commit and colcon, too."""

from __future__ import annotations

from pathlib import Path

import pytest
from benchmarks.adoption.__main__ import WORKSPACES, Outcome, told
from benchmarks.adoption.programs import Programs, of_this_checkout
from benchmarks.adoption.steps import CODE, STEPS
from benchmarks.adoption.workspace import Workspace

from robot_package import write_robot


@pytest.fixture
def programs(tmp_path: Path) -> Programs:
    (tmp_path / "home").mkdir()
    return of_this_checkout(tmp_path / "programs", tmp_path / "home")


@pytest.mark.parametrize("source", WORKSPACES, ids=lambda source: source.name)
def test_every_step_goes_as_the_documents_say(source: Path, programs: Programs, tmp_path: Path):
    outcomes = {outcome.step: outcome for outcome in told(source, tmp_path / "kept", programs)}
    assert [*outcomes] == [step.__name__ for step in STEPS]
    assert {name for name, outcome in outcomes.items() if outcome.how != "ok"} <= {"hook", "sarif", "colcon"}
    assert all(outcome.how == "skipped" and outcome.said for outcome in outcomes.values() if outcome.how != "ok")
    assert outcomes["pull_request"].said.startswith("1 new finding of ")
    assert outcomes["editor"].said.startswith(f"{CODE} shown at line ")


def test_a_step_that_fails_is_told_and_ends_the_story(programs: Programs, tmp_path: Path):
    """Nothing here is for ROS, so that `archlint init` has nothing to start with."""
    (tmp_path / "notes").mkdir()
    outcomes = [*told(tmp_path / "notes", tmp_path / "kept", programs)]
    assert [(outcome.step, outcome.how) for outcome in outcomes] == [("start", "failed")]
    assert "exit status 2 instead of 0: archlint: error: nothing to check" in outcomes[0].said


def test_a_repository_that_is_one_package_becomes_a_workspace(programs: Programs, tmp_path: Path):
    write_robot(tmp_path / "robot")
    (tmp_path / "robot" / "build").mkdir()
    workspace = Workspace(tmp_path / "robot", tmp_path / "copy", programs)
    workspace.add_package(mistake=False)
    packages = {path.parent.relative_to(workspace.root).as_posix() for path in workspace.root.rglob("package.xml")}
    assert packages == {"src/robot", "src/late_addition"}
    assert workspace.commit("more")[0]
    assert not [*workspace.root.rglob("build")]


def test_an_outcome_is_one_line():
    assert Outcome("hook", "skipped", "no pre-commit").line() == "  skipped  hook           no pre-commit"

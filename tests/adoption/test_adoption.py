"""A team takes archlint up, on two small workspaces; `make adoption` does it with pre-commit and colcon, too."""

from __future__ import annotations

import io
import json
import urllib.request
from dataclasses import replace
from pathlib import Path

import pytest
from benchmarks.adoption.__main__ import WORKSPACES, Outcome, told
from benchmarks.adoption.programs import ROOT, Programs, of_this_checkout
from benchmarks.adoption.steps import CODE, STEPS, Failed, Skipped, Story, sarif
from benchmarks.adoption.workspace import Workspace, checked_out

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


def test_an_address_is_checked_out_at_its_commit(programs: Programs, tmp_path: Path):
    repository = Workspace(ROOT / "fixtures" / "lesson", tmp_path / "lesson", programs).root
    commit = programs.git(repository, "rev-parse", "HEAD").out.strip()
    (repository / "later").write_text("")
    programs.git(repository, "add", "-A")
    programs.git(repository, "commit", "-q", "-m", "later")
    checkout = checked_out(f"{repository.as_uri()}@{commit}", tmp_path / "checkouts", programs)
    assert checkout.name == "lesson" and (checkout / "src").is_dir() and not (checkout / "later").exists()
    with pytest.raises(OSError, match=r"git cannot bring file:///.*nowhere@main"):
        checked_out(f"{(tmp_path / 'nowhere').as_uri()}@main", tmp_path / "checkouts", programs)


def test_the_schema_of_sarif_is_asked_for(programs: Programs, tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.delenv("SARIF_SCHEMA", raising=False)
    (tmp_path / "nothing").mkdir()
    story = Story(
        Workspace(tmp_path / "nothing", tmp_path / "copy", programs), replace(programs, installs=True), tmp_path
    )
    story.sarif = tmp_path / "archlint.sarif"
    story.sarif.write_text(json.dumps({"runs": [{"results": [{}]}]}), "utf-8")

    def answers(schema: object) -> None:
        answer = json.dumps(schema).encode()
        monkeypatch.setattr(urllib.request, "urlopen", lambda address, timeout: io.BytesIO(answer))

    answers({"required": ["runs"]})
    assert sarif(story) == "1 result, valid"
    answers({"required": ["version"]})
    with pytest.raises(Failed, match="'version' is a required property"):
        sarif(story)

    def silence(address: str, timeout: float) -> io.BytesIO:
        raise OSError("no network")

    monkeypatch.setattr(urllib.request, "urlopen", silence)
    with pytest.raises(Skipped, match=r"no answer from https://docs\.oasis-open\.org/.*no network"):
        sarif(story)


def test_an_outcome_is_one_line():
    assert Outcome("hook", "skipped", "no pre-commit").line() == "  skipped  hook           no pre-commit"

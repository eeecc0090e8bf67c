"""Services read paths relative to the repository, wherever in it archlint was started."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import pytest
from reports import NESTED, report

from archlint.report import render
from archlint.report.paths import folder_in_repository


def test_below_a_repository_it_is_the_way_from_its_root(tmp_path: Path) -> None:
    (tmp_path / ".git").mkdir()
    here = tmp_path / "ws" / "src"
    here.mkdir(parents=True)
    assert folder_in_repository(here, {}) == "ws/src"
    assert folder_in_repository(tmp_path, {}) == "."


@pytest.mark.parametrize("name", ["GITHUB_WORKSPACE", "CI_PROJECT_DIR"])
def test_the_service_says_where_its_checkout_is(tmp_path: Path, name: str) -> None:
    here = tmp_path / "robot" / "src"
    (here / ".git").mkdir(parents=True)
    assert folder_in_repository(here, {name: str(tmp_path)}) == "robot/src"
    assert folder_in_repository(here, {name: str(tmp_path / "elsewhere")}) == "."


def test_without_a_repository_paths_stay(tmp_path: Path) -> None:
    assert folder_in_repository(tmp_path, {}) == "."


def test_sarif_gitlab_and_github_say_the_path_in_the_repository() -> None:
    made = replace(report(NESTED), folder="ws/src")
    [result] = json.loads(render("sarif", made))["runs"][0]["results"]
    places = [result["locations"][0], *result["relatedLocations"]]
    assert [place["physicalLocation"]["artifactLocation"]["uri"] for place in places] == [
        "ws/src/pkg/node.py",
        "ws/src/pkg/node.py",
        "ws/src/pkg/main.py",
    ]
    assert json.loads(render("gitlab", made))[0]["location"]["path"] == "ws/src/pkg/node.py"
    assert "file=ws/src/pkg/node.py,line=8" in render("github", made)


def test_a_path_that_leads_upwards_is_made_plain() -> None:
    upwards = replace(NESTED, place=replace(NESTED.place, file="../tools/node.py"), related=())
    made = replace(report(upwards), folder="ws/src")
    assert json.loads(render("gitlab", made))[0]["location"]["path"] == "ws/tools/node.py"


@pytest.mark.parametrize("format", ["text", "concise", "json", "junit"])
def test_what_people_and_scripts_read_stays_relative_to_where_they_stand(format: str) -> None:
    made = replace(report(NESTED), folder="ws/src")
    assert render(format, made) == render(format, report(NESTED))

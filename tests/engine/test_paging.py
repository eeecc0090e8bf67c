"""What the command puts into an HTML page."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

import pytest

from archlint.cli import main

FIXTURES = Path(__file__).parents[2] / "fixtures"


def page(folder: str, tmp_path: Path, *words: str) -> dict[str, Any]:
    file = tmp_path / "g.html"
    assert main(["graph", "--no-cache", "--isolated", str(FIXTURES / folder), *words, "-o", str(file)]) == 0
    [text] = re.findall(r'id="data">(.*?)</script>', file.read_text("utf-8"))
    data: dict[str, Any] = json.loads(text)
    return data


@pytest.fixture(scope="module")
def alternatives(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Any]:
    return page("alternatives", tmp_path_factory.mktemp("page"))


def test_a_page_has_all_nodes_first_and_then_what_launch_files_start(alternatives: dict[str, Any]):
    first, *launched = [system["name"] for system in alternatives["systems"]]
    assert first is None
    assert launched == sorted(launched)
    assert all(name.endswith((".launch.py", ".launch.xml", ".launch.yaml")) for name in launched)


def test_arguments_that_decide_are_systems_of_their_own(alternatives: dict[str, Any]):
    titles = [system["title"] for system in alternatives["systems"]]
    assert len(set(titles)) == len(titles)
    assert any(":=" in title for title in titles)


def test_findings_are_in_the_page_and_at_what_they_are_about(tmp_path: Path):
    data = page("broken_system", tmp_path)
    codes = {finding["code"] for finding in data["findings"]}
    assert {"SRV003", "TOP001"} & codes
    [opened, *_] = data["systems"]
    named = {number for vertex in opened["vertices"] for number in vertex.get("findings", ())}
    assert codes & {data["findings"][number]["code"] for number in named}


def test_a_launch_file_that_was_asked_for_is_the_first_system(tmp_path: Path):
    [launch] = sorted((FIXTURES / "lesson_extended").rglob("*.launch.py"))[:1]
    data = page("lesson_extended", tmp_path, "--launch", str(launch))
    assert data["systems"][0]["name"].endswith(launch.name)
    assert len({system["title"] for system in data["systems"]}) == len(data["systems"])

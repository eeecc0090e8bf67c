"""``action.yml``: valid by GitHub's schema, and without a place where an input could become code."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import pytest
import yaml

from public_schemas import problems

ROOT = Path(__file__).parents[2]
ACTION = yaml.safe_load((ROOT / "action.yml").read_text("utf-8"))
STEPS: list[dict[str, Any]] = ACTION["runs"]["steps"]
SCRIPTS = [step for step in STEPS if "run" in step]


def test_the_action_is_valid_by_the_public_schema(tmp_path: Path):
    assert problems(ROOT / "action.yml", "github-actions") == ""
    wrong = tmp_path / "action.yml"
    wrong.write_text(yaml.safe_dump(ACTION | {"runs": {"using": "composite"}}), "utf-8")
    assert "validation errors" in problems(wrong, "github-actions")


@pytest.mark.parametrize("step", SCRIPTS, ids=lambda step: step["name"])
def test_no_expression_becomes_a_part_of_a_script(step: dict[str, Any]):
    assert "${{" not in step["run"]
    assert step["shell"] == "bash"


@pytest.mark.parametrize("step", SCRIPTS, ids=lambda step: step["name"])
def test_a_script_is_a_file_of_the_action(step: dict[str, Any]):
    [script] = re.findall(r"\$GITHUB_ACTION_PATH/([\w./]+)", step["run"])
    assert (ROOT / script).is_file()


def test_other_actions_are_pinned_to_a_commit_with_its_version():
    used = re.findall(r"uses: (.*)", (ROOT / "action.yml").read_text("utf-8").partition("runs:")[2])
    assert len(used) == len(STEPS) - len(SCRIPTS)
    assert all(re.fullmatch(r"[\w/-]+@[0-9a-f]{40} # v\d+\.\d+\.\d+", one) for one in used)


@pytest.mark.parametrize("name", ACTION["inputs"])
def test_an_input_is_used(name: str):
    assert f"inputs.{name}" in str(STEPS)


def test_an_expression_names_an_input_or_an_output_that_exists():
    text = (ROOT / "action.yml").read_text("utf-8")
    assert set(re.findall(r"inputs\.([\w-]+)", text)) == set(ACTION["inputs"])
    outputs = {
        "install": re.findall(r"([\w-]+)=", (ROOT / "scripts/action/install").read_text("utf-8").rpartition("{\n")[2]),
        "check": ["exit-code", "findings", "errors", "warnings", "infos", "json-file", "sarif-file"],
        "cache": ["cache-hit", "cache-primary-key"],  # of actions/cache/restore
    }
    for step, output in re.findall(r"steps\.(\w+)\.outputs\.([\w-]+)", text):
        assert output in outputs[step]


def test_what_the_check_step_reads_is_what_it_is_given():
    [check] = [step for step in STEPS if step.get("id") == "check"]
    reads = re.findall(r'(?:given|wants)\("(\w+)"', (ROOT / "scripts/action/check.py").read_text("utf-8"))
    assert {f"INPUT_{name}" for name in reads} == {name for name in check["env"] if name.startswith("INPUT_")}

"""The files for CI in the documents and those that ``archlint init`` writes are valid by the public schemas."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
import yaml

from archlint.cli import starter_files
from public_schemas import Schema, problems

ROOT = Path(__file__).parents[1]
WRITTEN = {
    f"{name} of {folder!r}": make(folder, True)
    for name, make in (("workflow", starter_files.github_workflow), ("job", starter_files.gitlab_job))
    for folder in (".", "my ws: $(a)")
}


def examples() -> dict[str, str]:
    """Each block of YAML in a document that is for CI, by the document and its number."""
    found = {}
    for name in ("README.md", "docs/ci.md"):
        blocks = re.findall(r"```yaml\n(.*?)```", (ROOT / name).read_text("utf-8"), re.DOTALL)
        found |= {f"{name} {number}": text for number, text in enumerate(blocks) if "repos:" not in text}
    return found


def schema_of(text: str) -> Schema:
    return "github-workflows" if "jobs:" in text else "gitlab-ci"


def test_the_documents_have_a_workflow_and_a_job():
    assert {schema_of(text) for text in examples().values()} == {"github-workflows", "gitlab-ci"}


@pytest.mark.parametrize("name", {**examples(), **WRITTEN})
def test_a_file_for_ci_is_valid(name: str, tmp_path: Path):
    text = {**examples(), **WRITTEN}[name]
    path = tmp_path / "ci.yml"
    path.write_text(text, "utf-8")
    assert problems(path, schema_of(text)) == ""


@pytest.mark.parametrize("name", [name for name, text in examples().items() if "OWNER/archlint" in text])
def test_a_workflow_gives_the_action_inputs_that_it_has(name: str):
    inputs = yaml.safe_load((ROOT / "action.yml").read_text("utf-8"))["inputs"]
    [job] = yaml.safe_load(examples()[name])["jobs"].values()
    [given] = [step.get("with", {}) for step in job["steps"] if step["uses"].startswith("OWNER/archlint@")]
    assert given and set(given) <= set(inputs)


def test_the_table_of_inputs_is_complete():
    action = yaml.safe_load((ROOT / "action.yml").read_text("utf-8"))
    text = (ROOT / "docs" / "ci.md").read_text("utf-8")
    rows = [re.findall(r"`([a-z-]+)`", line.split("|")[1]) for line in text.splitlines() if line.startswith("| `")]
    assert [name for row in rows for name in row] == [*action["inputs"]]
    said = re.search(r"^Outputs: (.*?)\.", text, re.MULTILINE | re.DOTALL)
    assert said and re.findall(r"`([\w-]+)`", said[1]) == [*action["outputs"]]

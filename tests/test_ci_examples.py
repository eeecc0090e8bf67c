"""The files for CI in the documents and those that ``archlint init`` writes are valid by the public schemas."""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import pytest
import yaml

from archlint.cli import starter_jobs
from public_schemas import Schema, problems
from robot_package import SETUP_CFG, TALKER, manifest, write_files

ROOT = Path(__file__).parents[1]
START = f"PYTHONPATH={ROOT / 'src'} exec {sys.executable} -m archlint"
SETUP = """\
from setuptools import setup
setup(name='robot', entry_points={'console_scripts': [
    'talker = robot.talker:main', 'listener = robot.listener:main']})
"""
WAITING = TALKER.replace("import String\n", "import String\nfrom std_srvs.srv import Trigger\n").replace(
    "        self.create_publisher",
    "        self.create_client(Trigger, 'go').wait_for_service()\n        self.create_publisher",
)
LISTENER = TALKER.replace("Talker", "Listener").replace("'talker'", "'listener'")
LISTENER = LISTENER.replace(
    "create_publisher(String, 'chatter', 10)", "create_subscription(String, 'chatter', print, 10)"
)
WRITTEN = {
    f"{name} of {folder!r}": make(folder, True)
    for name, make in (("workflow", starter_jobs.github_workflow), ("job", starter_jobs.gitlab_job))
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


@pytest.fixture
def checkout(tmp_path: Path) -> Path:
    """A repository of two commits: the second one breaks the topic between two nodes that waited for ever before."""
    folder = tmp_path / "checkout"
    files = {
        "package.xml": manifest(more="<exec_depend>std_srvs</exec_depend>"),
        "robot/__init__.py": "",
        "robot/talker.py": WAITING,
    }
    write_files(folder, files | {"setup.py": SETUP, "setup.cfg": SETUP_CFG, "robot/listener.py": LISTENER})
    programs = tmp_path / "programs"
    write_files(programs, {"pip": "#!/bin/sh\n", "archlint": f'#!/bin/sh\n{START} "$@"\n'})
    for program in programs.iterdir():
        program.chmod(0o755)
    started(folder, "git init -q -b main && git add -A && git commit -qm one")
    write_files(folder, {"robot/listener.py": LISTENER.replace("String", "Int32")})
    started(folder, "git add -A && git commit -qm two")
    return folder


def started(folder: Path, command: str, **variables: str) -> int:
    """The exit status of a command line of a job, which runs where nothing of this machine's settings is known."""
    who = {f"GIT_{role}_{what}": "kim@example.com" for role in ("AUTHOR", "COMMITTER") for what in ("NAME", "EMAIL")}
    path = f"{folder.parent / 'programs'}:{os.defpath}"
    environment = {"PATH": path, "HOME": str(folder.parent)} | who | variables
    return subprocess.run(["sh", "-ec", command], cwd=folder, env=environment, check=False).returncode


def test_the_job_for_gitlab_fails_for_what_a_merge_request_brings_in_and_reports_all(checkout: Path):
    [job] = [yaml.safe_load(text) for text in examples().values() if "CI_MERGE_REQUEST" in text]
    script = "\n".join(job["archlint"]["script"])
    for base, tested in (("", {"TMO001", "TOP001"}), ("HEAD~1", {"TOP001"})):
        assert started(checkout, script, CI_MERGE_REQUEST_DIFF_BASE_SHA=base) == 1
        quality = json.loads((checkout / "archlint.json").read_text("utf-8"))
        assert [issue["check_name"] for issue in quality] == ["TMO001", "TOP001"]
        tests = ElementTree.parse(checkout / "archlint.xml").iter("testcase")
        assert {case.get("name", "").split()[0] for case in tests} == tested


def test_the_stage_for_jenkins_fails_only_where_the_run_does(checkout: Path):
    command = re.findall(r"sh '(\.archlint-ci.*)'", (ROOT / "docs" / "ci.md").read_text("utf-8"))[0]
    write_files(checkout, {".archlint-ci/bin/archlint": (checkout.parent / "programs" / "archlint").read_text("utf-8")})
    (checkout / ".archlint-ci" / "bin" / "archlint").chmod(0o755)
    assert started(checkout, command) == 0
    assert ElementTree.parse(checkout / "archlint.xml").getroot().get("failures") == "1"
    assert (checkout / "archlint.sarif").is_file()
    write_files(checkout, {"archlint.toml": "nonsense"})
    assert started(checkout, command) == 2

"""The step that checks: run as GitHub runs it, in a shell that has nothing but what the step is given."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from robot_package import SETUP_CFG, TALKER, manifest, write_files

ROOT = Path(__file__).parents[2]
LISTENER = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import Int32

class Listener(Node):
    def __init__(self):
        super().__init__('listener')
        self.create_subscription(Int32, 'chatter', print, 10)

def main():
    rclpy.init()
    rclpy.spin(Listener())
"""
SETUP = """\
from setuptools import setup
setup(name='robot', entry_points={'console_scripts': [
    'talker = robot.talker:main', 'listener = robot.listener:main']})
"""
MISMATCH = "/talker publishes '/chatter' as std_msgs/msg/String, but /listener subscribes to it as std_msgs/msg/Int32"


class Job:
    """A job of GitHub's with a checkout, and what its steps tell."""

    def __init__(self, root: Path) -> None:
        self.checkout = root / "checkout"
        self.temporary = root / "temporary"
        self.home = root / "home"
        self.output, self.summary = root / "output", root / "summary.md"
        for folder in (self.checkout, self.temporary, self.home):
            folder.mkdir()
        self.archlint = root / "archlint"
        self.archlint.write_text(f'#!/bin/sh\nPYTHONPATH={ROOT / "src"} exec {sys.executable} -m archlint "$@"\n')
        self.archlint.chmod(0o755)

    def run(self, **inputs: str) -> subprocess.CompletedProcess[str]:
        variables = {
            "PATH": os.defpath,
            "HOME": str(self.home),
            "RUNNER_TEMP": str(self.temporary),
            "ARCHLINT": str(self.archlint),
            "GITHUB_OUTPUT": str(self.output),
            "GITHUB_STEP_SUMMARY": str(self.summary),
            "GITHUB_WORKSPACE": str(self.checkout),
            "GITHUB_SERVER_URL": "https://github.com",
            "GITHUB_REPOSITORY": "kim/robot",
            "GITHUB_SHA": "c0ffee",
        }
        command = [sys.executable, str(ROOT / "scripts" / "action" / "check.py")]
        return subprocess.run(
            command, cwd=self.checkout, env=variables | inputs, capture_output=True, text=True, check=False
        )

    def outputs(self) -> dict[str, str]:
        return dict(line.split("=", 1) for line in self.output.read_text("utf-8").splitlines())

    def git(self, *words: str) -> None:
        command = ["git", "-c", "user.name=Kim", "-c", "user.email=kim@example.com", *words]
        subprocess.run(command, cwd=self.checkout, env={"PATH": os.defpath, "HOME": str(self.home)}, check=True)


@pytest.fixture
def job(tmp_path: Path) -> Job:
    job = Job(tmp_path)
    files = {"package.xml": manifest(), "setup.py": SETUP, "setup.cfg": SETUP_CFG, "robot/__init__.py": ""}
    sources = files | {"robot/talker.py": TALKER, "robot/listener.py": LISTENER}
    write_files(job.checkout, sources)
    return job


def test_findings_are_annotations_outputs_files_and_a_summary(job: Job):
    done = job.run()
    assert done.returncode == 1, done.stderr
    assert done.stdout.startswith("::error file=robot/talker.py,line=9,")
    outputs = job.outputs()
    assert (outputs["exit-code"], outputs["findings"], outputs["errors"], outputs["warnings"]) == ("1", "1", "1", "0")
    assert all(Path(outputs[name]).is_relative_to(job.temporary) for name in ("json-file", "sarif-file"))
    assert '"version": "2.1.0"' in Path(outputs["sarif-file"]).read_text("utf-8")
    text = job.summary.read_text("utf-8")
    assert text.startswith("## archlint: 1 error\n")
    assert "[robot/talker.py:9](https://github.com/kim/robot/blob/c0ffee/robot/talker.py#L9)" in text
    assert "flowchart LR\n" in text.partition("```mermaid\n")[2]
    assert '(["/talker"])' in text and '(["/listener"])' in text


def test_the_checkout_and_the_home_folder_stay_as_they_are(job: Job):
    before = sorted(job.checkout.rglob("*"))
    job.run()
    assert sorted(job.checkout.rglob("*")) == before
    assert [*job.home.iterdir()] == []


def test_nothing_fails_where_nothing_is_wrong(job: Job):
    write_files(job.checkout, {"robot/listener.py": LISTENER.replace("Int32", "String")})
    assert job.run().returncode == 0
    assert (job.outputs()["exit-code"], job.outputs()["findings"]) == ("0", "0")
    assert job.summary.read_text("utf-8") == "## archlint: no findings\n\nIn 3 files with 2 nodes.\n\n"


def test_a_pull_request_reports_what_it_brings_in(job: Job):
    job.git("init", "-q", "-b", "main")
    job.git("add", "-A")
    job.git("commit", "-qm", "a robot")
    job.git("update-ref", "refs/remotes/origin/main", "HEAD")
    assert job.run(INPUT_NEW_ONLY="pull-request").returncode == 1  # a push: everything
    assert job.run(INPUT_NEW_ONLY="pull-request", GITHUB_BASE_REF="main").returncode == 0
    assert "What is new since origin/main, in 3 files with 2 nodes; 1 not new.\n" in job.summary.read_text("utf-8")


def test_a_pull_request_without_findings_shows_what_it_changes(job: Job):
    write_files(job.checkout, {"robot/listener.py": LISTENER.replace("Int32", "String")})
    job.git("init", "-q", "-b", "main")
    job.git("add", "-A")
    job.git("commit", "-qm", "a robot")
    job.git("update-ref", "refs/remotes/origin/main", "HEAD")
    write_files(job.checkout, {"robot/listener.py": LISTENER.replace("Int32", "String").replace("'listener'", "'ear'")})
    job.git("commit", "-qam", "another name")
    assert job.run(INPUT_NEW_ONLY="pull-request", GITHUB_BASE_REF="main").returncode == 0
    text = job.summary.read_text("utf-8")
    assert "<summary>What has changed between the nodes: new in green, gone in red</summary>" in text
    drawn = text.partition("```mermaid\n")[2]
    assert '(["/ear"])' in drawn
    assert "talker" not in drawn, "it is as it was"


def test_a_release_without_diff_shows_the_nodes_of_the_findings(job: Job):
    job.git("init", "-q", "-b", "main")
    job.git("add", "setup.py", "package.xml", "robot/__init__.py")
    job.git("commit", "-qm", "no node yet")
    job.archlint.write_text(job.archlint.read_text().replace("\n", '\n[ "$1" = diff ] && exit 2\n', 1))
    assert job.run(INPUT_NEW_ONLY="HEAD").returncode == 1
    assert "<summary>The nodes where these findings are" in job.summary.read_text("utf-8")


def test_a_checkout_without_the_history_is_told_what_to_do(job: Job):
    job.git("init", "-q", "-b", "main")
    job.git("add", "-A")
    job.git("commit", "-qm", "a robot")
    done = job.run(INPUT_NEW_ONLY="pull-request", GITHUB_BASE_REF="main")
    assert done.returncode == 2
    assert "origin/main" in done.stdout
    assert job.outputs() == {"exit-code": "2"}
    assert "\n::error title=archlint::archlint: error: " in done.stdout
    assert job.summary.read_text("utf-8").startswith("## archlint: the run failed\n\n    archlint: error: ")


def test_inputs_are_words_and_never_code(job: Job):
    touched = job.checkout / "touched"
    paths = f"$(touch {touched})\n`touch {touched}`\n; touch {touched}\n--exit-zero"
    done = job.run(INPUT_PATHS=paths, INPUT_ARGS="--severity error; touch touched", INPUT_BASELINE="$(touch touched)")
    assert done.returncode == 2
    assert not touched.exists()
    assert job.outputs() == {"exit-code": "2"}


def test_paths_options_and_a_folder_to_work_in(job: Job):
    moved = job.checkout / "src" / "my robot"
    moved.mkdir(parents=True)
    for name in ("package.xml", "setup.py", "setup.cfg", "robot"):
        (job.checkout / name).rename(moved / name)
    inputs = {"INPUT_WORKING_DIRECTORY": "src", "INPUT_PATHS": "my robot/robot\nmy robot/setup.py\n"}
    done = job.run(**inputs, INPUT_ARGS="--ignore TOP", INPUT_SARIF_FILE="out.sarif")
    assert done.returncode == 0, done.stderr
    assert job.outputs()["sarif-file"] == str(job.checkout / "src" / "out.sarif")
    assert job.run(**inputs).returncode == 1
    assert "blob/c0ffee/src/my%20robot/robot/talker.py#L9" in job.summary.read_text("utf-8")


@pytest.mark.parametrize(
    ("inputs", "said"),
    [
        ({"INPUT_GRAPH": "maybe"}, "graph is true or false, not 'maybe'"),
        ({"INPUT_ARGS": "--select 'TOP"}, "args cannot be split into words"),
        ({"INPUT_SARIF_FILE": "a\nexit-code=0"}, "sarif-file has a character that cannot be printed"),
        ({"INPUT_SARIF_FILE": "robot"}, "cannot write "),
        ({"INPUT_WORKING_DIRECTORY": "nowhere"}, "working-directory: there is no folder nowhere"),
    ],
)
def test_a_wrong_input_is_an_error_that_names_it(job: Job, inputs: dict[str, str], said: str):
    done = job.run(**inputs)
    assert done.returncode == 2
    assert done.stdout.startswith(f"::error title=archlint::{said}")
    assert job.outputs() == {"exit-code": "2"}


def test_annotations_summary_and_graph_can_be_left_out(job: Job):
    done = job.run(INPUT_ANNOTATIONS="false", INPUT_SUMMARY="false")
    assert "::error" not in done.stdout
    assert MISMATCH in done.stdout
    assert not job.summary.exists()
    job.run(INPUT_GRAPH="false")
    assert "mermaid" not in job.summary.read_text("utf-8")


def test_github_does_nothing_of_what_a_source_says_in_the_log(job: Job):
    listener = job.checkout / "robot" / "listener.py"
    talker = job.checkout / "robot" / "talker.py"
    for file in (talker, listener):
        lines = file.read_text("utf-8").splitlines()
        file.write_text("\n".join(f"{line}  # ##[add-mask]a" if "create_" in line else line for line in lines) + "\n")
    done = job.run(INPUT_ANNOTATIONS="false", INPUT_SUMMARY="false")
    first, *others = done.stdout.splitlines()
    command, _, token = first.rpartition("::")
    assert (command, len(token)) == ("::stop-commands", 32)
    text = others[: others.index(f"::{token}::")]
    assert any("##[add-mask]" in line for line in text)
    assert not any("##[add-mask]" in line for line in others[len(text) :])

"""``archlint init``: the files that it writes pass as they are, and what exists is left."""

from __future__ import annotations

import re
import shlex
import subprocess
from pathlib import Path

import pytest
import yaml

from archlint.cli import main
from archlint.config.settings import load
from robot_package import write_files, write_robot

CONFIGURATION, BASELINE, ATTRIBUTES = "archlint.toml", "archlint-baseline.txt", ".gitattributes"
HOOK, WORKFLOW, GITLAB = ".pre-commit-config.yaml", ".github/workflows/archlint.yml", ".gitlab-ci.yml"
LISTENER = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import {kind}

class Listener(Node):
    def __init__(self):
        super().__init__('listener')
        self.create_subscription({kind}, 'chatter', print, 10)

def main():
    rclpy.init()
    rclpy.spin(Listener())
"""
GOOD, BAD = LISTENER.format(kind="String"), LISTENER.format(kind="Int32")
SETUP = """\
from glob import glob
from setuptools import setup
setup(
    name='robot',
    data_files=[('share/robot/launch', glob('launch/*'))],
    entry_points={'console_scripts': ['talker = robot.talker:main', 'listener = robot.listener:main']},
)
"""


@pytest.fixture(autouse=True)
def here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    (tmp_path / "home").mkdir()
    folder = tmp_path / "workspace"
    folder.mkdir()
    subprocess.run(["git", "init", "-q", folder], check=True)
    monkeypatch.chdir(folder)
    monkeypatch.setenv("HOME", str(tmp_path / "home"))
    monkeypatch.delenv("ROS_DISTRO", raising=False)
    return folder


def write_workspace(root: Path, listener: str = GOOD) -> None:
    launch = "<node pkg='robot' exec='talker'/><node pkg='robot' exec='listener'/>"
    files = {"setup.py": SETUP, "robot/__init__.py": "", "robot/listener.py": listener}
    write_robot(root, launch)
    write_files(root, files)


def written(folder: Path) -> set[str]:
    names = (CONFIGURATION, BASELINE, ATTRIBUTES, HOOK, WORKFLOW, GITLAB)
    return {name for name in names if (folder / name).exists()}


def init(capsys: pytest.CaptureFixture[str], *arguments: str) -> str:
    assert main(["init", *arguments]) == 0
    return capsys.readouterr().out


def test_a_clean_workspace_gets_a_configuration_a_hook_and_a_workflow(here: Path, capsys: pytest.CaptureFixture[str]):
    write_workspace(here)
    assert init(capsys).splitlines() == [f"wrote {CONFIGURATION}", f"wrote {HOOK}", f"wrote {WORKFLOW}"]
    assert written(here) == {CONFIGURATION, HOOK, WORKFLOW}
    assert main(["check", "--quiet"]) == 0


def test_findings_of_today_are_held_back(here: Path, capsys: pytest.CaptureFixture[str]):
    write_workspace(here, BAD)
    assert main(["check", "--quiet", "--format", "concise"]) == 1
    findings = capsys.readouterr().out.splitlines()
    assert len(findings) == 1
    assert "TOP001" in findings[0]
    said = "holds back the finding that is there today; `archlint check --no-baseline` shows it"
    assert f"wrote {BASELINE}: {said}\n" in init(capsys)
    assert main(["check", "--quiet"]) == 0
    assert main(["check", "--quiet", "--no-baseline"]) == 1


def test_baselines_of_two_branches_merge(here: Path, capsys: pytest.CaptureFixture[str]):
    def git(words: str) -> None:
        who = ["-c", "user.name=Kim", "-c", "user.email=kim@example.com"]
        subprocess.run(["git", *who, *words.split()], cwd=here, check=True, capture_output=True)

    write_workspace(here, BAD)
    init(capsys)
    git("checkout -q -b start")
    git("add -A")
    git("commit -q -m start")
    path = here / BASELINE
    for branch in ("theirs", "ours"):
        git(f"checkout -q -B {branch} start")
        path.write_text(f"{path.read_text('utf-8')}TOP002 robot/{branch}.py: chatter\n", "utf-8")
        git(f"commit -q -a -m {branch}")
    git("merge -q theirs")
    lines = path.read_text("utf-8").splitlines()
    assert {f"TOP002 robot/{branch}.py: chatter" for branch in ("ours", "theirs")} <= {*lines}
    assert not any(line.startswith(("<<<", "===", ">>>")) for line in lines)


def test_attributes_that_exist_are_left(here: Path, capsys: pytest.CaptureFixture[str]):
    write_workspace(here, BAD)
    write_files(here, {ATTRIBUTES: "*.stl binary\n"})
    assert f"{ATTRIBUTES} exists, and is left as it is\n" in (said := init(capsys))
    assert f"append this to it\n\n{BASELINE} merge=union\n" in said
    assert (here / ATTRIBUTES).read_text("utf-8") == "*.stl binary\n"


def test_a_finding_that_comes_later_fails(here: Path, capsys: pytest.CaptureFixture[str]):
    write_workspace(here)
    init(capsys)
    write_files(here, {"robot/listener.py": BAD})
    assert main(["check", "--quiet"]) == 1


def test_the_hook_and_the_jobs_start_commands_that_pass(here: Path, capsys: pytest.CaptureFixture[str]):
    write_workspace(here / "my ws", BAD)
    init(capsys, "my ws")
    assert written(here / "my ws") == {CONFIGURATION, BASELINE, ATTRIBUTES}
    [repository] = yaml.safe_load((here / HOOK).read_text("utf-8"))["repos"]
    [hook] = repository["hooks"]
    assert hook["entry"] == "archlint check --quiet 'my ws'"
    assert main(["check", "--quiet", "my ws"]) == 0
    [job] = yaml.safe_load((here / WORKFLOW).read_text("utf-8"))["jobs"].values()
    assert job["steps"][-1]["run"] == "pipx run archlint check --format github 'my ws'"


def test_the_comments_name_what_is_in_the_workspace(here: Path, capsys: pytest.CaptureFixture[str]):
    write_workspace(here)
    init(capsys)
    text = (here / CONFIGURATION).read_text("utf-8")
    assert '#launch = ["launch/it.launch.xml"]\n' in text
    assert '#"/chatter" = "/talker"\n' in text


def test_all_that_is_commented_out_can_be_switched_on(here: Path, capsys: pytest.CaptureFixture[str]):
    write_workspace(here)
    init(capsys)
    path = here / CONFIGURATION
    path.write_text(re.sub(r"^#(?! )", "", path.read_text("utf-8"), flags=re.MULTILINE), "utf-8")
    settings = load(here)
    assert settings.closed_world and settings.distro == "jazzy"
    assert settings.owners == {"/chatter": ("/talker",)}
    assert [contract.kind for contract in settings.contracts] == ["forbid"]


def test_the_distribution_of_the_shell_is_taken(
    here: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
):
    monkeypatch.setenv("ROS_DISTRO", "humble")
    write_workspace(here)
    init(capsys)
    assert load(here).distro == "humble"


def test_what_exists_is_left_and_what_to_add_is_said(here: Path, capsys: pytest.CaptureFixture[str]):
    write_workspace(here, BAD)
    own = {"pyproject.toml": "[tool.archlint]\n", HOOK: "repos: []\n", GITLAB: "stages: [test]\n"}
    write_files(here, own)
    said = init(capsys)
    for name, text in own.items():
        assert f"{name} exists, and is left as it is\n" in said
        assert (here / name).read_text("utf-8") == text
    assert "      - id: archlint\n" in said
    assert "    - archlint check --output gitlab=archlint.json\n" in said
    assert written(here) == {HOOK, GITLAB}


def test_a_second_time_writes_nothing(here: Path, capsys: pytest.CaptureFixture[str]):
    write_workspace(here, BAD)
    init(capsys)
    before = {name: (here / name).read_bytes() for name in written(here)}
    assert "wrote" not in init(capsys)
    assert {name: (here / name).read_bytes() for name in written(here)} == before


def test_a_repository_at_gitlab_gets_a_job_for_gitlab(here: Path, capsys: pytest.CaptureFixture[str]):
    write_workspace(here)
    write_files(here, {".gitmodules": ""})
    subprocess.run(["git", "remote", "add", "origin", "git@gitlab.example.com:robots/robot.git"], check=True)
    init(capsys)
    assert written(here) == {CONFIGURATION, HOOK, GITLAB}
    job = yaml.safe_load((here / GITLAB).read_text("utf-8"))["archlint"]
    assert job["variables"] == {"GIT_SUBMODULE_STRATEGY": "normal"}


def test_a_jenkinsfile_is_left_and_the_stage_to_add_is_said(here: Path, capsys: pytest.CaptureFixture[str]):
    write_workspace(here / "kim's ws")
    write_files(here, {"Jenkinsfile": "pipeline {}\n"})
    said = init(capsys, "kim's ws")
    assert "Jenkinsfile exists, and is left as it is\n" in said
    [stage] = re.findall(r"^        sh '(\.archlint-ci/bin/archlint .*)'$", said, re.MULTILINE)
    words = shlex.split(stage.replace("\\'", "'").replace("\\\\", "\\"))
    assert words == [".archlint-ci/bin/archlint", "check", "--exit-zero", "--output", "junit=archlint.xml", "kim's ws"]
    assert written(here) == {HOOK}
    write_files(here, {"Jenkinsfile": "stage('archlint') {}\n"})
    assert "stages" not in init(capsys, "kim's ws")


def test_a_linked_worktree_has_the_remote_of_its_repository(
    here: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
):
    subprocess.run(["git", "remote", "add", "origin", "git@gitlab.example.com:robots/robot.git"], check=True)
    who = ["-c", "user.name=Kim", "-c", "user.email=kim@example.com"]
    subprocess.run(["git", *who, "commit", "-q", "--allow-empty", "-m", "nothing yet"], check=True)
    linked = here.parent / "linked"
    subprocess.run(["git", "worktree", "add", "-q", linked], check=True)
    monkeypatch.chdir(linked)
    write_workspace(linked)
    init(capsys)
    assert written(linked) == {CONFIGURATION, HOOK, GITLAB}


def test_without_anything_to_check_nothing_is_written(here: Path, capsys: pytest.CaptureFixture[str]):
    assert main(["init"]) == 2
    assert "nothing to check" in capsys.readouterr().err
    assert written(here) == set()

"""Running systems, recorded with the script that archlint prints, and held against their source."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import pytest

from tests_ros.cases import CANNOT_RUN, FIXTURES, FORMS, SCRIPTS, WORKSPACES, needed, programs_below
from tests_ros.cases import script as script_of
from tests_ros.environments import ROOT, Environment
from tests_ros.running import Program, Servers, domain_of_its_own, running

LESSON = FIXTURES / "lesson"
LAUNCH = "src/my_first_package/launch/robot.launch.py"
SOURCES = "src/my_first_package/my_first_package"
CODES = "GRF005,GRF006,GRF007"
TRIES = 3
WHERE_ALL_START = [name for name in WORKSPACES if name != "broken_system"]


@pytest.fixture(scope="module")
def script(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("script") / "record.py"
    archlint("observe", "--print-script", "-o", str(path), folder=ROOT)
    return path


def archlint(*words: str, folder: Path) -> str:
    done = subprocess.run(
        [sys.executable, "-m", "archlint", *words],
        cwd=folder,
        env=os.environ | {"PYTHONPATH": str(ROOT / "src")},
        text=True,
        capture_output=True,
        timeout=120,
        check=False,
    )
    assert done.returncode in (0, 1), done.stderr
    return done.stdout


@dataclass(frozen=True)
class Recorder:
    """Starts programs in a domain of their own, and records what they say of themselves."""

    servers: Servers
    script: Path
    folder: Path

    def __call__(self, started: Sequence[Program], root: Path, *words: str) -> dict[str, Any]:
        environment = self.servers.environment
        prefixes = environment.interfaces(*needed(root, root))
        with running(self.servers.of(prefixes), started, root) as together:
            observed = together.seen(lambda now: now.settled)
            assert observed.settled, observed.said
            there = {name for name, kinds in observed.nodes.items() if not kinds["gone"]}
            return self._recorded(there, environment.variables(prefixes, together.domain, together.folder), *words)

    def _recorded(self, there: set[str], variables: dict[str, str], *words: str) -> dict[str, Any]:
        """The recording in which all nodes are that are there; a busy machine discovers slowly, so a few are tried."""
        python = self.servers.environment.python
        command = [python, self.script, "--seconds", "30", "-o", self.folder / "robot.json", *words]
        record: dict[str, Any] = {}
        for _ in range(TRIES):
            subprocess.run(command, env=variables, timeout=90, check=True)
            record = json.loads((self.folder / "robot.json").read_text("utf-8"))
            if record["settled"] and there <= {node["name"] for node in record["nodes"]}:
                break
        return record

    def told(self, root: Path, *words: str) -> list[str]:
        """What archlint finds when it holds the last recording against the source in ``root``."""
        said = archlint(
            "check",
            "--format=json",
            "--no-cache",
            "--jobs=1",
            "--isolated",
            f"--select={CODES}",
            "--observed",
            str(self.folder / "robot.json"),
            *words,
            folder=root,
        )
        return [f"{one['code']} {one['message']}" for one in json.loads(said)["diagnostics"]]


@pytest.fixture
def record(servers: Servers, script: Path, tmp_path: Path) -> Recorder:
    return Recorder(servers, script, tmp_path)


def started(root: Path) -> dict[str, Program]:
    return {executable: program for executable, (program, _) in programs_below(root).items()}


@pytest.mark.parametrize("name", WHERE_ALL_START)
def test_a_system_that_runs_as_it_is_written_differs_in_nothing(name: str, record: Recorder):
    root = FIXTURES / name
    record(list(started(root).values()), root)
    assert record.told(root, ".") == []


@pytest.mark.parametrize("name", [name for name in SCRIPTS if name not in CANNOT_RUN])
def test_a_form_differs_in_nothing(name: str, record: Recorder, tmp_path: Path):
    """However its source brings about what it has, and whatever of it is left open.  Not every class of a form is a
    node that its main function makes."""
    record([script_of(name, tmp_path)], FORMS)
    assert [one for one in record.told(FORMS, name) if not one.endswith("does not run, and the source has it")] == []


def test_neither_does_what_a_launch_file_starts(record: Recorder):
    recorded = record(list(started(LESSON).values()), LESSON, "--parameters")
    assert record.told(LESSON, "--launch", LAUNCH) == []
    known = {node["name"]: [one["name"] for one in node["parameters"]] for node in recorded["nodes"]}
    assert known.keys() == {"/control_node", "/motor_node", "/sensor_node"}
    assert all("use_sim_time" in names for names in known.values())


def test_a_node_that_is_left_out(record: Recorder):
    there = started(LESSON)
    del there["motor_node"]
    record(list(there.values()), LESSON)
    assert record.told(LESSON, "--launch", LAUNCH) == [
        f"GRF005 /motor_node does not run, and {LAUNCH} starts it",
    ]


def test_a_topic_that_is_remapped_by_hand(record: Recorder):
    there = started(LESSON)
    remapped = ("--ros-args", "-r", "sensor_data:=readings")
    there["sensor_node"] = replace(there["sensor_node"], arguments=remapped)
    record(list(there.values()), LESSON)
    assert record.told(LESSON, "--launch", LAUNCH) == [
        "GRF007 /sensor_node publishes /readings when it runs, and /sensor_data in the source",
    ]


def test_a_node_that_is_started_twice_and_one_in_a_namespace(record: Recorder):
    there = started(LESSON)
    again = replace(there["motor_node"], arguments=("--ros-args", "-r", "__ns:=/left"))
    record([*there.values(), there["sensor_node"], again], LESSON)
    assert sorted(record.told(LESSON, "--launch", LAUNCH)) == [
        f"GRF006 /left/motor_node runs, and {LAUNCH} does not start it",
        "GRF006 2 nodes called /sensor_node run, and the source has one of that name",
    ]


OTHERWISE = {
    "another QoS": (
        "control_node.py",
        "            10)",
        "            QoSProfile(depth=10, reliability=QoSReliabilityPolicy.BEST_EFFORT, deadline=Duration(seconds=2)))",
        "from rclpy.duration import Duration\nfrom rclpy.qos import QoSProfile, QoSReliabilityPolicy\n",
        "GRF007 the subscription /sensor_data of /control_node is best effort and with a deadline of 2 s when it runs, "
        "and reliable and without deadline in the source",
    ),
    "another type": (
        "motor_node.py",
        "            SetMotorSpeed,",
        "            Trigger,",
        "from std_srvs.srv import Trigger\n",
        "GRF007 the service /set_motor of /motor_node has the type std_srvs/srv/Trigger when it runs, and "
        "my_robot_interfaces/srv/SetMotorSpeed in the source",
    ),
}
"""What another build of one file makes: the file, a line of it, what stands there instead, imports, the finding."""


@pytest.mark.parametrize(("file", "line", "instead", "imports", "finding"), OTHERWISE.values(), ids=OTHERWISE)
def test_another_build_of_a_node(
    file: str, line: str, instead: str, imports: str, finding: str, record: Recorder, tmp_path: Path
):
    built = tmp_path / "built"
    shutil.copytree(LESSON, built)
    path = built / SOURCES / file
    text = path.read_text("utf-8")
    assert line in text
    path.write_text(imports + text.replace(line, instead, 1), encoding="utf-8")
    record(list(started(built).values()), built)
    assert record.told(LESSON, "--launch", LAUNCH) == [finding]
    assert record.told(built, "--launch", LAUNCH) == []


def test_where_nothing_runs_the_recorder_says_so(environment: Environment, script: Path, tmp_path: Path):
    with domain_of_its_own() as domain:
        done = subprocess.run(
            [environment.python, script, "--seconds", "3"],
            env=environment.variables([], domain, tmp_path),
            text=True,
            capture_output=True,
            timeout=60,
            check=False,
        )
    assert (done.returncode, done.stdout) == (1, "")
    assert f"no node is running in ROS_DOMAIN_ID {domain}" in done.stderr

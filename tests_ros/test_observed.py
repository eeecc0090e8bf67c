"""Running systems, recorded with the script that archlint prints, and held against their source."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
from collections import Counter
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import Future, ThreadPoolExecutor
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import Any

import pytest

from tests_ros.cases import CANNOT_RUN, FIXTURES, FORMS, SCRIPTS, WORKSPACES, needed, programs_below
from tests_ros.cases import script as script_of
from tests_ros.conftest import AT_ONCE, asked_for
from tests_ros.environments import ROOT, Environment
from tests_ros.running import Program, Servers, domain_of_its_own, running

LESSON = FIXTURES / "lesson"
LAUNCH = "src/my_first_package/launch/robot.launch.py"
SOURCES = "src/my_first_package/my_first_package"
CODES = "GRF005,GRF006,GRF007"
TRIES = 8
WHERE_ALL_START = [name for name in WORKSPACES if name != "broken_system"]
ALWAYS = ("lesson", "lesson_extended", "held_nodes.py", "lifecycle.py", "qos_forms.py", "wrappers.py")
"""Systems and forms that are recorded without ``--full``: of each kind of entity, type and QoS, and of each way to
leave something open."""


@dataclass(frozen=True)
class System:
    """Programs that are started together; ``made`` gives the root of their source and what starts them, and gets a
    folder for files.  ``words`` are for the recorder."""

    name: str
    made: Callable[[Path], tuple[Path, list[Program]]]
    words: tuple[str, ...] = ()


@dataclass(frozen=True)
class Recording:
    """What a system said of itself: the ``file``, what is in it, and the ``root`` of the source that ran."""

    file: Path
    root: Path
    content: dict[str, Any]

    def told(self, root: Path, *words: str) -> list[str]:
        """What archlint finds when it holds the recording against the source in ``root``."""
        options = ("--format=json", "--no-cache", "--jobs=1", "--isolated", f"--select={CODES}")
        said = archlint("check", *options, "--observed", str(self.file), *words, folder=root)
        return [f"{one['code']} {one['message']}" for one in json.loads(said)["diagnostics"]]


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
    """Starts systems, each in a domain of its own, and records what they say of themselves."""

    servers: Servers
    script: Path
    folder: Path

    def __call__(self, system: System) -> Recording:
        folder = self.folder / system.name
        folder.mkdir()
        root, programs = system.made(folder)
        environment = self.servers.environment
        prefixes = environment.interfaces(*needed(root, root))
        with running(self.servers.of(prefixes), programs, root) as together:
            observed = together.seen(lambda now: now.settled)
            assert observed.settled, observed.said
            variables = environment.variables(prefixes, together.domain, together.folder)
            file = folder / "robot.json"
            return Recording(file, root, self._recorded(file, Counter(observed.names), variables, *system.words))

    def _recorded(self, file: Path, there: Counter[str], variables: dict[str, str], *words: str) -> dict[str, Any]:
        """The recording in which all nodes are that are there, namesakes too; a busy machine discovers slowly, so a few
        are tried."""
        command = [self.servers.environment.python, self.script, "--seconds", "30", "-o", file, *words]
        content: dict[str, Any] = {}
        for _ in range(TRIES):
            subprocess.run(command, env=variables, timeout=90, check=True)
            content = json.loads(file.read_text("utf-8"))
            if content["settled"] and there <= Counter({node["name"]: node["count"] for node in content["nodes"]}):
                break
        return content


class Recordings:
    """All systems that are asked for, each recorded once, several at a time."""

    def __init__(self, systems: list[System], recorder: Recorder) -> None:
        self._pool = ThreadPoolExecutor(AT_ONCE)
        self._futures: dict[System, Future[Recording]] = {}
        for system in dict.fromkeys(systems):
            self._futures[system] = self._pool.submit(recorder, system)

    def of(self, system: System) -> Recording:
        return self._futures[system].result()

    def close(self) -> None:
        self._pool.shutdown(cancel_futures=True)


@pytest.fixture(scope="module")
def script(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("script") / "record.py"
    archlint("observe", "--print-script", "-o", str(path), folder=ROOT)
    return path


@pytest.fixture(scope="module")
def recordings(
    request: pytest.FixtureRequest, servers: Servers, script: Path, tmp_path_factory: pytest.TempPathFactory
) -> Iterator[Recordings]:
    recorder = Recorder(servers, script, tmp_path_factory.mktemp("recordings"))
    made = Recordings(asked_for(request.session, "system"), recorder)
    yield made
    made.close()


@pytest.fixture
def recorded(system: System, recordings: Recordings) -> Recording:
    return recordings.of(system)


def started(root: Path) -> dict[str, Program]:
    return {executable: program for executable, (program, _) in programs_below(root).items()}


def as_written(name: str, folder: Path) -> tuple[Path, list[Program]]:
    return FIXTURES / name, list(started(FIXTURES / name).values())


def a_form(name: str, folder: Path) -> tuple[Path, list[Program]]:
    return FORMS, [script_of(name, folder)]


def without_the_motor(folder: Path) -> tuple[Path, list[Program]]:
    return LESSON, [program for name, program in started(LESSON).items() if name != "motor_node"]


def remapped_by_hand(folder: Path) -> tuple[Path, list[Program]]:
    there = started(LESSON)
    remapped = replace(there["sensor_node"], arguments=("--ros-args", "-r", "sensor_data:=readings"))
    return LESSON, list((there | {"sensor_node": remapped}).values())


def started_again(folder: Path) -> tuple[Path, list[Program]]:
    there = started(LESSON)
    again = replace(there["motor_node"], arguments=("--ros-args", "-r", "__ns:=/left"))
    return LESSON, [*there.values(), there["sensor_node"], again]


def built_otherwise(change: str, folder: Path) -> tuple[Path, list[Program]]:
    file, line, instead, imports, _ = OTHERWISE[change]
    built = folder / "built"
    shutil.copytree(LESSON, built)
    path = built / SOURCES / file
    text = path.read_text("utf-8")
    assert line in text
    path.write_text(imports + text.replace(line, instead, 1), encoding="utf-8")
    return built, list(started(built).values())


OTHERWISE = {
    "another QoS": (
        "control_node.py",
        "            10)",
        "            QoSProfile(depth=10, reliability=QoSReliabilityPolicy.BEST_EFFORT, deadline=Duration(seconds=2)))",
        "from rclpy.duration import Duration\nfrom rclpy.qos import QoSProfile, QoSReliabilityPolicy\n",
        "GRF007 the subscription /sensor_data of /control_node is best effort and with a deadline of 2 s when it "
        "runs, but reliable and without deadline in the source",
    ),
    "another type": (
        "motor_node.py",
        "            SetMotorSpeed,",
        "            Trigger,",
        "from std_srvs.srv import Trigger\n",
        "GRF007 the service /set_motor of /motor_node has the type std_srvs/srv/Trigger when it runs, but "
        "my_robot_interfaces/srv/SetMotorSpeed in the source",
    ),
}
"""What another build of one file makes: the file, a line of it, what stands there instead, imports, the finding."""

AS_WRITTEN = {name: System(name, partial(as_written, name), ("--parameters",)) for name in WHERE_ALL_START}
AS_FORMS = {name: System(name, partial(a_form, name)) for name in SCRIPTS if name not in CANNOT_RUN}
BUILT_OTHERWISE = {change: System(change, partial(built_otherwise, change)) for change in OTHERWISE}


def each(systems: Iterable[System]) -> pytest.MarkDecorator:
    """A test for each of them; those that are not in :data:`ALWAYS` are left to ``--full``."""
    return pytest.mark.parametrize(
        "system",
        [pytest.param(one, id=one.name, marks=() if one.name in ALWAYS else pytest.mark.full) for one in systems],
    )


def this(system: System) -> pytest.MarkDecorator:
    return pytest.mark.parametrize("system", [pytest.param(system, id=system.name)])


@each(AS_WRITTEN.values())
def test_a_system_that_runs_as_it_is_written_differs_in_nothing(recorded: Recording):
    assert recorded.told(recorded.root, ".") == []


@each(AS_FORMS.values())
def test_a_form_differs_in_nothing(system: System, recorded: Recording):
    """However its source brings about what it has, and whatever of it is left open.  Not every class of a form is a
    node that its main function makes."""
    told = recorded.told(FORMS, system.name)
    assert [one for one in told if not one.endswith("does not run, and the source has it")] == []


@this(AS_WRITTEN["lesson"])
def test_neither_does_what_a_launch_file_starts(recorded: Recording):
    assert recorded.told(LESSON, "--launch", LAUNCH) == []
    known = {node["name"]: [one["name"] for one in node["parameters"]] for node in recorded.content["nodes"]}
    assert known.keys() == {"/control_node", "/motor_node", "/sensor_node"}
    assert all("use_sim_time" in names for names in known.values())


@this(System("a node is left out", without_the_motor))
def test_a_node_that_is_left_out(recorded: Recording):
    assert recorded.told(LESSON, "--launch", LAUNCH) == [
        f"GRF005 /motor_node does not run, and {LAUNCH} starts it",
    ]


@this(System("a topic is remapped", remapped_by_hand))
def test_a_topic_that_is_remapped_by_hand(recorded: Recording):
    assert recorded.told(LESSON, "--launch", LAUNCH) == [
        "GRF007 /sensor_node publishes /readings when it runs, but /sensor_data in the source",
    ]


@this(System("a node is started twice", started_again))
def test_a_node_that_is_started_twice_and_one_in_a_namespace(recorded: Recording):
    assert sorted(recorded.told(LESSON, "--launch", LAUNCH)) == [
        f"GRF006 /left/motor_node runs, and {LAUNCH} does not start it",
        "GRF006 2 nodes with the name /sensor_node run, but the source has one of that name",
    ]


@pytest.mark.parametrize(
    ("system", "finding"),
    [pytest.param(system, OTHERWISE[change][-1], id=change) for change, system in BUILT_OTHERWISE.items()],
)
def test_another_build_of_a_node(recorded: Recording, finding: str):
    assert recorded.told(LESSON, "--launch", LAUNCH) == [finding]
    assert recorded.told(recorded.root, "--launch", LAUNCH) == []


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

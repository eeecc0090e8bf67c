"""Nothing that the tests start outlives them, whatever it does."""

from __future__ import annotations

import fcntl
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

from tests_ros.environments import ROOT, Environment
from tests_ros.running import Program, Server, marked, observe, sweep

STUBBORN = """
import signal, subprocess, sys, threading
import rclpy
for one in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
    signal.signal(one, signal.SIG_IGN)
subprocess.Popen([sys.executable, "-c", "import time; time.sleep(60)"])
rclpy.init()
node = rclpy.create_node("stubborn")
threading.Event().wait()
"""


def test_a_program_and_what_it_started_are_gone_when_it_has_been_looked_at(environment: Environment, tmp_path: Path):
    script = tmp_path / "stubborn.py"
    script.write_text(STUBBORN)
    before = set(marked())
    server = Server(environment, [], tmp_path / "server")
    running: list[int] = []

    def agrees(observed) -> bool:
        running.extend(set(marked()) - before)
        return "/stubborn" in observed.nodes and (observed.graph is None or "/stubborn" in observed.graph)

    observed = observe(server, [Program(str(script))], tmp_path, agrees)
    assert "/stubborn" in (observed.graph or {})
    assert len(set(running)) >= 4, "the server, the observer, the program and its child"
    left = set(running) & set(marked())
    assert left == {server.pid}
    server.close()
    assert not set(running) & set(marked())


DIES = """
import os, signal, sys, time
from pathlib import Path
from tests_ros.environments import Environment
from tests_ros.running import Server, marked
folder = Path(sys.argv[2])
server = Server(Environment(sys.argv[1]), [], folder / "server")
print(server.pid, server.start("observer", [], folder / "record", 101), flush=True)
os.kill(os.getpid(), signal.SIGKILL)
"""


def test_nothing_outlives_a_test_run_that_is_killed(environment: Environment, tmp_path: Path):
    command = [sys.executable, "-c", DIES, environment.distro, str(tmp_path)]
    paths = os.pathsep.join(map(str, (ROOT, ROOT / "src")))
    done = subprocess.run(
        command, env=os.environ | {"PYTHONPATH": paths}, text=True, capture_output=True, timeout=60, check=False
    )
    assert done.returncode == -signal.SIGKILL, done.stderr
    started = list(map(int, done.stdout.split()))
    assert len(started) == 2
    end = time.monotonic() + 20
    while any(is_running(pid) for pid in started) and time.monotonic() < end:
        time.sleep(0.1)
    assert not any(is_running(pid) for pid in started)


def test_shared_memory_of_the_dead_is_removed_and_of_the_living_is_not(tmp_path: Path):
    dead, alive, new = (tmp_path / f"fastdds_{number}" for number in ("00c0ffee", "00decade", "00facade"))
    for segment in (dead, alive, new):
        for path in (segment, lock_of(segment)):
            path.touch()
            if segment != new:
                os.utime(path, (0, 0))
    with lock_of(alive).open() as held:
        fcntl.flock(held, fcntl.LOCK_EX)
        sweep(tmp_path)
    assert sorted(tmp_path.iterdir()) == sorted([alive, lock_of(alive), new, lock_of(new)])


def lock_of(segment: Path) -> Path:
    return segment.with_name(segment.name + "_el")


def is_running(pid: int) -> bool:
    """Whether a process is there, and is not only waiting to be reaped."""
    try:
        state = Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0]
    except OSError:
        return False
    return state != "Z"

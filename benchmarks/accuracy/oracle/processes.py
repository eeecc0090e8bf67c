"""The processes that runs of the oracle live in: servers that fork one for each, shut off from the network."""

from __future__ import annotations

import os
import queue
import selectors
import shutil
import signal
import subprocess
import sys
from contextlib import suppress
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path

_PROJECT = Path(__file__).resolve().parents[3]
_LOOPBACK = 'ip link set lo up; exec "$@"'

PLAIN = {
    "PATH": "/usr/bin:/bin",
    "LANG": "C.UTF-8",
    "USER": "user",
    "TERM": "dumb",
    "PYTHONHASHSEED": "0",
    "PYTHONDONTWRITEBYTECODE": "1",
    "OPENBLAS_NUM_THREADS": "1",
    "ROS_DISTRO": "jazzy",
    "ROS_VERSION": "2",
    "ROS_PYTHON_VERSION": "3",
}
"""The environment variables that a program under the stand-in sees."""


@dataclass(frozen=True)
class Python:
    """What runs are executed with: an interpreter, its variables, and whether rclpy is the real one there."""

    executable: str = sys.executable
    variables: tuple[tuple[str, str], ...] = tuple(PLAIN.items())
    real: bool = False

    def command(self) -> list[str]:
        server = [self.executable, "-m", "benchmarks.accuracy.oracle.server", *(["--real"] if self.real else [])]
        return [*without_network(), *server] if self.real else server


@cache
def without_network() -> tuple[str, ...]:
    """The words before a command that leave it a loopback of its own and no other network; none where that fails."""
    words = ("unshare", "--map-root-user", "--net", "sh", "-c", _LOOPBACK, "sh")
    if shutil.which("unshare") is None:
        return ()
    return words if subprocess.run([*words, "true"], capture_output=True, check=False).returncode == 0 else ()


@dataclass
class Pool:
    """As many servers as runs go on at once; each is started when it is needed, and again when it had to be killed."""

    python: Python
    _free: queue.SimpleQueue[subprocess.Popen[bytes]] = field(default_factory=queue.SimpleQueue)

    def run(self, folder: Path, limit_s: float) -> str | None:
        """Run the job in a folder; what went wrong with its process, if something did."""
        try:
            server = self._free.get_nowait()
        except queue.Empty:
            server = self._started()
        assert server.stdin is not None and server.stdout is not None
        server.stdin.write(f"{folder}\n".encode())
        server.stdin.flush()
        with selectors.DefaultSelector() as waiting:
            waiting.register(server.stdout, selectors.EVENT_READ)
            answered = bool(waiting.select(limit_s))
        answer = server.stdout.readline().decode().strip() if answered else ""
        if not answer:
            end(server)
            return f"killed after {limit_s:.0f} s" if not answered else "the server ended"
        self._free.put(server)
        if answer == "0":
            return None
        return (folder / "noise").read_text("utf-8", "replace").strip()[-300:] or f"exit {answer}"

    def close(self) -> None:
        """End the servers; none is busy."""
        with suppress(queue.Empty):
            while True:
                end(self._free.get_nowait())

    def _started(self) -> subprocess.Popen[bytes]:
        variables = dict(self.python.variables)
        others = [variables["PYTHONPATH"]] if variables.get("PYTHONPATH") else []
        variables["PYTHONPATH"] = os.pathsep.join([str(_PROJECT), *others])
        return subprocess.Popen(
            self.python.command(),
            env=variables,
            cwd="/",
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            start_new_session=True,
        )


def end(server: subprocess.Popen[bytes]) -> None:
    """Kill a server and the run that it may have."""
    with suppress(ProcessLookupError):
        os.killpg(server.pid, signal.SIGKILL)
    server.wait()
    for stream in (server.stdin, server.stdout):
        if stream is not None:
            stream.close()

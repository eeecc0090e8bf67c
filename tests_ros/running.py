"""Runs programs in a domain of their own, and brings back what they are from inside and from outside."""

from __future__ import annotations

import fcntl
import json
import os
import signal
import subprocess
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field
from pathlib import Path
from typing import IO, Any

from tests_ros.environments import Environment

INSIDE = Path(__file__).parent / "inside"
LIMIT_S = 60
DOMAINS = range(1, 100)
"""Of 0 to 101, which never meet the ports that Linux gives away; 0 is everybody's."""

Kinds = dict[str, list[Any]]
"""What a node has, by ``publishers``, ``services``, ``parameters`` and so on."""


@dataclass(frozen=True)
class Program:
    """One process: ``module:function`` or a script, found in ``folders``, with a command line."""

    target: str
    folders: tuple[Path, ...] = ()
    arguments: tuple[str, ...] = ()
    variables: tuple[tuple[str, str], ...] = ()


@dataclass
class Observed:
    """What was seen of programs that ran together.

    ``nodes``: from inside, with QoS, timers and parameters; ``graph``: from outside, through the middleware; ``lines``:
    executed lines as (file relative to the root, line); ``ended``: what the programs that ended raised, or "".
    """

    nodes: dict[str, Kinds] = field(default_factory=dict)
    graph: dict[str, Kinds] = field(default_factory=dict)
    lines: set[tuple[str, int]] = field(default_factory=set)
    ended: dict[str, str] = field(default_factory=dict)


class Observer:
    """The process that asks the running graphs, one after the other."""

    def __init__(self, environment: Environment, prefixes: list[Path], folder: Path) -> None:
        with (folder / "observer.log").open("w") as log:
            self._process = subprocess.Popen(
                [environment.python, INSIDE / "observer.py"],
                env=environment.variables(prefixes, 0, folder),
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                stderr=log,
                text=True,
                start_new_session=True,
            )

    def join(self, domain: int) -> None:
        self._ask({"domain": domain})

    def graph(self, expected: dict[str, Kinds]) -> dict[str, Kinds]:
        """The domain's nodes, as soon as what is expected can be seen; leaves the domain."""
        answer: dict[str, Kinds] = json.loads(self._ask({"nodes": expected, "limit": 15}))
        return answer

    def _ask(self, question: dict[str, Any]) -> str:
        assert self._process.stdin is not None and self._process.stdout is not None
        self._process.stdin.write(json.dumps(question) + "\n")
        self._process.stdin.flush()
        return self._process.stdout.readline()

    def close(self) -> None:
        kill(self._process)


def observe(
    environment: Environment, prefixes: list[Path], programs: list[Program], root: Path, observer: Observer
) -> Observed:
    """Starts ``programs`` together, looks at them once all have settled, and ends them.

    Raises:
        TimeoutError: One of them has not made a node in time; with what it printed.
    """
    with domain_of_its_own() as domain, tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        processes: list[subprocess.Popen[bytes]] = []
        observer.join(domain)
        observed = Observed()
        try:
            for index, program in enumerate(programs):
                processes.append(start(environment, prefixes, program, root, domain, folder / str(index)))
            for index, program in enumerate(programs):
                collect(observed, program, folder / str(index))
        finally:
            observed.graph = observer.graph(
                {name: kinds for name, kinds in observed.nodes.items() if not kinds["gone"]}
            )
            for process in processes:
                kill(process)
        return observed


def start(
    environment: Environment, prefixes: list[Path], program: Program, root: Path, domain: int, record: Path
) -> subprocess.Popen[bytes]:
    variables = environment.variables(prefixes, domain, record.parent)
    variables["PYTHONPATH"] = os.pathsep.join([*map(str, program.folders), variables["PYTHONPATH"]])
    variables |= dict(program.variables)
    command = [environment.python, INSIDE / "runner.py", record, root, str(LIMIT_S), program.target, *program.arguments]
    with log_of(record).open("wb") as log:
        return subprocess.Popen(
            command,
            env=variables,
            cwd=record.parent,
            stdin=subprocess.DEVNULL,
            stdout=log,
            stderr=log,
            start_new_session=True,
        )


def collect(observed: Observed, program: Program, record: Path) -> None:
    end = time.monotonic() + LIMIT_S / 2
    ended = record.with_name(record.name + ".ended")
    while not record.exists():
        if ended.exists():
            end = min(end, time.monotonic() + 3)
        if time.monotonic() > end:
            said = ended.read_text() if ended.exists() else "still going"
            raise TimeoutError(f"{program.target} made no node: {said}\n{log_of(record).read_text()[-2000:]}")
        time.sleep(0.05)
    written = json.loads(record.read_text())
    observed.nodes |= written["nodes"]
    observed.lines |= {(file, line) for file, line in written["lines"]}
    if ended.exists():
        observed.ended[program.target] = ended.read_text()


def log_of(record: Path) -> Path:
    return record.with_name(record.name + ".log")


def kill(process: subprocess.Popen[Any]) -> None:
    """Ends a process and all that it started."""
    with suppress(ProcessLookupError):
        os.killpg(process.pid, signal.SIGKILL)
    process.wait()
    for stream in (process.stdin, process.stdout):
        if stream is not None:
            stream.close()


@contextmanager
def domain_of_its_own() -> Iterator[int]:
    """A domain id that no other test run on this machine has at the moment."""
    file, domain = _free_domain()
    try:
        yield domain
    finally:
        file.close()


def _free_domain() -> tuple[IO[str], int]:
    start = os.getpid()
    for step in range(len(DOMAINS)):
        domain = DOMAINS[(start + step) % len(DOMAINS)]
        file = (Path(tempfile.gettempdir()) / f"archlint-ros-domain-{domain}.lock").open("w")
        try:
            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            file.close()
            continue
        return file, domain
    raise RuntimeError("all domain ids are taken")

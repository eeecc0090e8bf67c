"""Runs programs in a domain of their own, and brings back what they are from inside and from outside."""

from __future__ import annotations

import fcntl
import json
import os
import signal
import subprocess
import tempfile
import threading
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import ExitStack, contextmanager, suppress
from dataclasses import dataclass, field
from pathlib import Path
from typing import IO, Any

from tests_ros.environments import Environment

INSIDE = Path(__file__).parent / "inside"
PATIENCE_S = 60
"""How long programs may take until they are what is expected of them: much more than they need on a busy machine."""
LIMIT_S = 180
"""After how many seconds a process that was forgotten ends itself."""
QUIET_S = 0.5
"""How long nothing new must come up once everything is as expected."""
LOOK_S = 0.1
DOMAINS = range(1, 100)
"""Of 0 to 101, which never meet the ports that Linux gives away; 0 is everybody's."""
SHARED_MEMORY = Path("/dev/shm")
YOUNG_S = 10
MARK = "ARCHLINT_ROS_TEST"
"""A variable in the environment of every process that is started here."""

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

    ``nodes``: from inside, with QoS, timers and parameters; ``names``: of all nodes that are there still, one of each
    program that has it; ``graph``: from outside, through the middleware, None
    before anybody has looked; ``lines``: executed lines as (file relative to the root, line); ``settled``: whether all
    programs spin, wait or have ended, and nothing new comes up; ``said``: what each program raised or printed.
    """

    nodes: dict[str, Kinds] = field(default_factory=dict)
    names: list[str] = field(default_factory=list)
    graph: dict[str, Kinds] | None = None
    lines: set[tuple[str, int]] = field(default_factory=set)
    settled: bool = False
    said: dict[str, str] = field(default_factory=dict)


class Server:
    """A warm process with the interfaces of some install prefixes, which forks programs and observers."""

    def __init__(self, environment: Environment, prefixes: list[Path], folder: Path) -> None:
        self._variables = environment.variables(prefixes, 0, folder)
        self._lock = threading.Lock()
        folder.mkdir(parents=True)
        self._log = folder / "server.log"
        with self._log.open("w") as log:
            self._process = subprocess.Popen(
                [environment.python, INSIDE / "server.py"],
                env=self._variables | {MARK: str(os.getpid()), "OPENBLAS_NUM_THREADS": "1"},
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                stderr=log,
                text=True,
                start_new_session=True,
            )

    @property
    def pid(self) -> int:
        return self._process.pid

    def start(
        self,
        job: str,
        words: list[Any],
        record: Path,
        domain: int,
        variables: Mapping[str, str] | None = None,
        path: tuple[Path, ...] = (),
    ) -> int:
        """Forks a ``program`` or an ``observer`` that writes to ``record``; its process id."""
        order = {
            "job": job,
            "words": [str(record), *words],
            "folder": str(record.parent),
            "log": str(log_of(record)),
            "limit": LIMIT_S,
            "variables": {"ROS_DOMAIN_ID": str(domain), "ROS_LOG_DIR": str(record.parent), **(variables or {})},
            "path": [str(one) for one in path],
        }
        assert self._process.stdin is not None and self._process.stdout is not None
        with self._lock:
            self._process.stdin.write(json.dumps(order) + "\n")
            self._process.stdin.flush()
            answer = self._process.stdout.readline()
        if not answer:
            raise RuntimeError(f"no process can be started: {self._log.read_text()[-2000:]}")
        return int(answer)

    def close(self) -> None:
        """Ends the server, and with it all that it has started."""
        kill(self._process)


class Servers:
    """The servers of one distribution, each started when it is first asked for; several threads may ask."""

    def __init__(self, environment: Environment, folder: Path) -> None:
        self.environment = environment
        self._folder = folder
        self._lock = threading.Lock()
        self._servers: dict[tuple[Path, ...], Server] = {}

    def of(self, prefixes: list[Path]) -> Server:
        with self._lock:
            key = tuple(prefixes)
            if key not in self._servers:
                self._servers[key] = Server(self.environment, prefixes, self._folder / str(len(self._servers)))
            return self._servers[key]

    def close(self) -> None:
        for server in self._servers.values():
            server.close()
        sweep()


@dataclass(frozen=True)
class Running:
    """Programs that run together in a domain; ``folder`` is for what is written meanwhile."""

    domain: int
    folder: Path
    records: dict[Path, Program]

    def seen(self, agrees: Callable[[Observed], bool], outside: Path | None = None) -> Observed:
        """What can be seen of them once they have settled and ``agrees`` says that all is there, or in the end.

        It is asked again whenever something has changed; what does not agree after :data:`PATIENCE_S` will not.
        ``outside`` is the record of an observer.
        """
        patient_until = time.monotonic() + PATIENCE_S
        texts: list[str] = []
        since, judged = time.monotonic(), False
        observed = Observed()
        while time.monotonic() < patient_until:
            now = [_text(path) for path in (*self.records, *([outside] if outside else []))]
            if now != texts:
                texts, since, judged = now, time.monotonic(), False
                observed = _observed(self.records, texts[: len(self.records)], texts[-1] if outside else None)
            if observed.settled and not judged and time.monotonic() - since > QUIET_S:
                if agrees(observed):
                    break
                judged = True
            time.sleep(LOOK_S)
        return observed


@contextmanager
def running(server: Server, programs: Sequence[Program], root: Path) -> Iterator[Running]:
    """Starts ``programs`` together in a domain of their own, and ends them; ``root`` is what the lines are noted of."""
    with ExitStack() as stack:
        domain = stack.enter_context(domain_of_its_own())
        folder = Path(stack.enter_context(tempfile.TemporaryDirectory(prefix="archlint-ros-")))
        records = {folder / str(number): program for number, program in enumerate(programs)}
        for record, program in records.items():
            words = [str(root), program.target, list(program.arguments)]
            variables = dict(program.variables)
            stack.callback(end, server.start("program", words, record, domain, variables, program.folders))
        yield Running(domain, folder, records)


def observe(server: Server, programs: Sequence[Program], root: Path, agrees: Callable[[Observed], bool]) -> Observed:
    """Starts ``programs`` together, looks at them from outside once they have settled, and ends them.

    ``agrees`` says of what was seen from inside, and then of all, whether everything is there; where it does not, the
    difference is in what is returned.
    """
    with running(server, programs, root) as started:
        observed = started.seen(agrees)
        if not agrees(observed):
            return observed
        # Who comes late gets each participant's last word about its nodes; who is there from the start may miss it when
        # the words follow each other fast (seen with Fast DDS 3.2, on a machine with more to do than it can).
        outside = started.folder / "outside"
        observer = server.start("observer", [], outside, started.domain)
        try:
            return started.seen(agrees, outside)
        finally:
            end(observer)


def _text(path: Path) -> str:
    try:
        return path.read_text("utf-8")
    except FileNotFoundError:
        return ""


def _observed(programs: dict[Path, Program], texts: list[str], outside: str | None) -> Observed:
    observed = Observed(graph=None if outside is None else json.loads(outside or "{}"), settled="" not in texts)
    for (path, program), text in zip(programs.items(), texts, strict=True):
        written = json.loads(text) if text else {"nodes": {}, "lines": [], "settled": False, "ended": None}
        observed.nodes |= written["nodes"]
        observed.names += [name for name, kinds in written["nodes"].items() if not kinds["gone"]]
        observed.lines |= {(file, line) for file, line in written["lines"]}
        observed.settled = observed.settled and written["settled"]
        observed.said[program.target] = written["ended"] or _text(log_of(path))[-1000:]
    return observed


def log_of(record: Path) -> Path:
    return record.with_name(record.name + ".log")


def end(leader: int) -> None:
    """Ends a fork of a server and all that it started, and waits until they are gone."""
    with suppress(ProcessLookupError):
        while True:
            os.killpg(leader, signal.SIGKILL)
            time.sleep(0.01)


def kill(process: subprocess.Popen[Any]) -> None:
    """Ends a process and all that it started."""
    with suppress(ProcessLookupError):
        os.killpg(process.pid, signal.SIGKILL)
    process.wait()
    for stream in (process.stdin, process.stdout):
        if stream is not None:
            stream.close()


def sweep(folder: Path = SHARED_MEMORY) -> None:
    """Removes the shared memory of participants that are gone, as ``fastdds shm clean`` does.

    Whoever meets this machine only gets some, whatever the transports are; what is killed leaves it behind. The lock
    file of one that lives is locked; a young one may be about to be.
    """
    for lock in folder.glob("fast*_el"):
        with suppress(OSError), lock.open() as file:
            if time.time() - lock.stat().st_mtime > YOUNG_S and "_port" not in lock.name:
                fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
                lock.with_name(lock.name.removesuffix("_el")).unlink(missing_ok=True)
                lock.unlink()


def marked() -> list[int]:
    """The processes that run because of this one, by the variable that they were started with."""
    wanted = f"{MARK}={os.getpid()}".encode()
    found = []
    for folder in Path("/proc").glob("[0-9]*"):
        with suppress(OSError):
            if wanted in (folder / "environ").read_bytes().split(b"\0"):
                found.append(int(folder.name))
    return sorted(found)


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

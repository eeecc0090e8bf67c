"""Compiling and linking on other machines: any executor of concurrent.futures, and a real Dask cluster."""

from __future__ import annotations

import importlib.util
import os
import re
import socket
import subprocess
import sys
import threading
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import Future, ThreadPoolExecutor
from contextlib import contextmanager, suppress
from pathlib import Path

import msgspec
import pytest

from archlint import __version__
from archlint.cli import main
from archlint.engine import executors, remote
from archlint.engine.executors import ExecutorPool, PoolError
from archlint.engine.link_part import link_part
from archlint.engine.remote import Done, Row, identity, run_task
from archlint.engine.remote_jobs import rows_of
from archlint.programs import linker
from archlint.syntax import compile as compiler
from archlint.syntax.facts import FACTS_VERSION, Facts, decode, encode
from archlint.syntax.workers import Lost
from robot_package import manifest, write_files

SRC = str(Path(__file__).parents[2] / "src")

needs_dask = pytest.mark.skipif(
    importlib.util.find_spec("distributed") is None, reason="Dask is not installed: pip install 'archlint[dask]'"
)

NODE = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String
from std_srvs.srv import Trigger
from {0}.names import TOPIC


class {1}(Node):
    def __init__(self):
        super().__init__('{0}')
        self.create_publisher(String, TOPIC, 10)
        self.client = self.create_client(Trigger, 'reset')
        self.client.wait_for_service()


def main():
    rclpy.init()
    rclpy.spin({1}())
"""
SETUP = """\
from setuptools import find_packages, setup
setup(name='{0}', packages=find_packages(), entry_points={{'console_scripts': ['{0} = {0}.node:main']}})
"""
NAMES = "arm", "base", "camera"


@pytest.fixture
def workspace(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Three packages that import nothing of each other, so that their programs can be followed apart."""
    for name in NAMES:
        files = {
            "package.xml": manifest(name),
            "setup.py": SETUP.format(name),
            f"{name}/__init__.py": "",
            f"{name}/names.py": f"TOPIC = '{name}/state'\n",
            f"{name}/node.py": NODE.format(name, name.title()),
        }
        write_files(tmp_path / "workspace/src" / name, files)
    monkeypatch.chdir(tmp_path / "workspace")
    monkeypatch.setattr(linker, "WORTH_IT", 0)
    monkeypatch.setattr(executors, "_WORTH_IT", 1)
    monkeypatch.setattr(executors, "_BATCHES", 1)  # each task is a process that starts
    monkeypatch.setattr(compiler, "PARALLEL_BYTES", 0)
    return tmp_path / "workspace"


_POOLS: list[ThreadPoolExecutor] = []


@pytest.fixture(autouse=True)
def no_thread_stays() -> Iterator[None]:
    """While another thread runs, nothing in this process forks."""
    yield
    while _POOLS:
        _POOLS.pop().shutdown()


class Threads:
    """An executor that notes what it was given.  Each task starts a process, as it does on a worker."""

    def __init__(self, count: int = 2) -> None:
        self.threads = ThreadPoolExecutor(count)
        self.jobs: list[str] = []
        _POOLS.append(self.threads)

    def submit(self, function: Callable[..., bytes], /, *arguments: object) -> Future[bytes]:
        self.jobs.append(msgspec.msgpack.decode(arguments[1])["job"].rpartition(".")[2])  # type: ignore[arg-type]
        return self.threads.submit(function, *arguments)


class OneThread(Threads):
    """The same without the processes, whose start is nearly all that a small task takes."""

    def __init__(self) -> None:
        super().__init__(1)

    def submit(self, function: Callable[..., bytes], /, *arguments: object) -> Future[bytes]:
        assert function is run_task
        return super().submit(done_here, *arguments)


def done_here(wanted: str, task: bytes) -> bytes:
    return msgspec.msgpack.encode(Done(wanted, rows_of(msgspec.msgpack.decode(task, type=remote.Task))))


def use(monkeypatch: pytest.MonkeyPatch, executor: object) -> ExecutorPool:
    """Have ``--scheduler`` mean this executor."""
    pool = ExecutorPool(executor, link_part, 2)  # type: ignore[arg-type]

    @contextmanager
    def cluster(address: str) -> Iterator[ExecutorPool]:
        yield pool

    monkeypatch.setattr("archlint.engine.dask_cluster.dask_cluster", cluster)
    return pool


Said = tuple[int, str, str]


def say(capsys: pytest.CaptureFixture[str], *words: str) -> Said:
    capsys.readouterr()
    status = main([*words, "--isolated", "--no-cache"])
    said = capsys.readouterr()
    return status, re.sub(r'"elapsed_s": [0-9.]+', "", said.out), said.err


COMMANDS: list[Sequence[str]] = [("check", "--format", "json"), ("graph", "--format", "json")]


@pytest.mark.parametrize(("command", "threads"), [(COMMANDS[0], Threads), (COMMANDS[1], OneThread)])
def test_an_executor_gives_the_same_bytes(
    workspace: Path,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
    command: Sequence[str],
    threads: type[Threads],
) -> None:
    alone, executor = say(capsys, *command), threads()
    use(monkeypatch, executor)
    assert say(capsys, *command, "--scheduler", "these threads") == alone
    assert {"encoded", "link_part"} == set(executor.jobs)


def test_what_other_machines_have_linked_is_not_followed_again(
    workspace: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    """Nothing of the workspace is on those machines: each gets the facts."""
    use(monkeypatch, OneThread())
    _, _, error = say(capsys, "check", "--verbose", "--scheduler", "these threads")
    [analysed] = [line for line in error.splitlines() if line.startswith("analysed")]
    assert analysed.startswith("analysed 0 programs; reused ")


def test_facts_are_compiled_on_an_executor_too(
    workspace: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    say(capsys, "facts", "-o", "../here")
    use(monkeypatch, OneThread())
    say(capsys, "facts", "-o", "../there", "--scheduler", "these threads")
    here, there = ({p.name: p.read_bytes() for p in (workspace.parent / n).iterdir()} for n in ("here", "there"))
    assert here == there


# ------------------------------------------------------------------------------------------ what goes wrong


class Answers:
    """An executor whose workers all answer the same."""

    def __init__(self, answer: Callable[[], bytes]) -> None:
        self.answer = answer

    def submit(self, function: object, /, *arguments: object) -> Future[bytes]:
        future: Future[bytes] = Future()
        try:
            future.set_result(self.answer())
        except Exception as error:
            future.set_exception(error)
        return future


def raising(error: Exception) -> Callable[[], bytes]:
    def answer() -> bytes:
        raise error

    return answer


@pytest.mark.parametrize(
    "answer",
    [
        raising(RuntimeError("KilledWorker")),
        lambda: b"",
        lambda: b"\x93\x01\x02\x03",
        lambda: msgspec.msgpack.encode(Done(identity(), failed=True)),
        lambda: msgspec.msgpack.encode(Done(identity(), [])),
        lambda: msgspec.msgpack.encode(Done(identity(), [Row("answer", b"+nonsense", 0.0)] * 20)),
        lambda: msgspec.msgpack.encode(Done(identity(), [Row("answer", encode(Facts(FACTS_VERSION)), 0.0)] * 20)),
        lambda: msgspec.msgpack.encode(Done(identity(), [Row("timed out", b"", float("nan"))] * 20)),
    ],
    ids=[
        "a worker died",
        "nothing",
        "nonsense",
        "the task failed",
        "too few answers",
        "answers that are none",
        "facts without a mark",
        "no number of seconds",
    ],
)
def test_what_does_not_come_back_is_done_here(
    workspace: Path,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
    answer: Callable[[], bytes],
) -> None:
    alone = say(capsys, "check")
    use(monkeypatch, Answers(answer))
    status, output, _ = say(capsys, "check", "--scheduler", "nobody")
    assert (status, output) == alone[:2]


def test_that_work_was_lost_is_told(
    workspace: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    use(monkeypatch, Answers(raising(RuntimeError("KilledWorker"))))
    assert "did not come back from the cluster and ran here instead" in say(capsys, "check", "--scheduler", "x")[2]
    assert say(capsys, "check", "--quiet", "--scheduler", "x")[2] == ""


@pytest.mark.parametrize(
    ("answer", "error"),
    [
        (lambda: msgspec.msgpack.encode(Done("archlint 0.0.9-0123, Python 3.9")), "runs another archlint or Python"),
        (raising(ModuleNotFoundError("No module named 'archlint'")), f"a worker has no archlint {__version__}"),
        (raising(AttributeError("run_task")), f"a worker has no archlint {__version__}"),
    ],
)
def test_workers_with_another_archlint_end_the_run(
    workspace: Path,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
    answer: Callable[[], bytes],
    error: str,
) -> None:
    use(monkeypatch, Answers(answer))
    status, output, told = say(capsys, "check", "--scheduler", "others")
    assert (status, output) == (2, "")
    assert error in told
    assert "install archlint" in told


def test_nobody_waits_for_ever_for_a_scheduler_that_is_gone(monkeypatch: pytest.MonkeyPatch) -> None:
    class Silence:
        def submit(self, function: object, /, *arguments: object) -> Future[bytes]:
            return Future()

    monkeypatch.setattr(executors, "PATIENCE", 0.0)
    monkeypatch.setattr(executors, "_LOOK", 0.01)
    pool = ExecutorPool(Silence(), link_part, 1, lambda: "the scheduler does not answer any more")
    with pytest.raises(PoolError, match="does not answer any more"):
        pool.map(compiler.encoded, [b"import rclpy"], 30, lambda number, seconds: None)


def test_nobody_waits_for_ever_for_a_worker_that_says_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    """It is there, and may be busy with the work of others; or it is stuck."""

    class Silence:
        def submit(self, function: object, /, *arguments: object) -> Future[bytes]:
            return Future()

    monkeypatch.setattr(executors, "SILENCE", 0.02)
    monkeypatch.setattr(executors, "_LOOK", 0.01)
    pool = ExecutorPool(Silence(), link_part, 1)
    with pytest.raises(PoolError, match="none has answered"):
        pool.map(compiler.encoded, [b"import rclpy"], 30, lambda number, seconds: None)


def test_sources_of_cpp_are_compiled_there_too(
    workspace: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    source = '#include <rclcpp/rclcpp.hpp>\nint main() { rclcpp::Node node("talker"); }\n'
    write_files(workspace / "src/base", {"src/talker.cpp": source})
    alone, executor = say(capsys, *COMMANDS[1]), OneThread()
    pool = use(monkeypatch, executor)
    assert say(capsys, *COMMANDS[1], "--scheduler", "this thread") == alone
    assert "encoded_cpp" in executor.jobs
    assert pool.lost == 0


def test_a_task_is_refused_by_another_archlint(monkeypatch: pytest.MonkeyPatch) -> None:
    assert msgspec.msgpack.decode(run_task("archlint 9", b""), type=Done) == Done(identity())


def test_a_job_that_there_is_not_fails_and_does_nothing() -> None:
    task = msgspec.msgpack.encode(remote.Task("os.system", 30.0, [b"touch /tmp/never"]))
    assert msgspec.msgpack.decode(run_task(identity(), task), type=Done).failed


def test_a_source_that_kills_the_parser_kills_no_worker(monkeypatch: pytest.MonkeyPatch) -> None:
    """It is worked on in a process of its own, and reported as ever."""
    lost = ExecutorPool(Answers(raising(RuntimeError())), link_part, 1)  # type: ignore[arg-type]
    [answer] = lost.map(compiler.encoded, [b"x = 1\n"], 30, lambda number, seconds: None)
    assert isinstance(answer, Lost)
    [compiled] = compiler.compile_sources([b"x = 1\n"], 1, pool=lost)
    assert decode(compiled.payload) is not None


# --------------------------------------------------------------------------------------------------- Dask


@pytest.mark.skipif(importlib.util.find_spec("distributed") is not None, reason="Dask is installed")
def test_without_dask_the_extra_is_named(workspace: Path, capsys: pytest.CaptureFixture[str]) -> None:
    status, _, error = say(capsys, "check", "--scheduler", "tcp://127.0.0.1:1")
    assert status == 2
    assert "pip install 'archlint[dask]'" in error


@pytest.fixture(scope="module")
def cluster() -> Iterator[str]:
    """The address of a scheduler that has two worker processes with two threads each."""
    code = (
        "import os, sys\n"
        "from distributed import LocalCluster\n"
        "if __name__ == '__main__':\n"
        "    with LocalCluster(n_workers=2, threads_per_worker=2, dashboard_address=None, protocol='tcp://',\n"
        "                      host='127.0.0.1') as cluster:\n"
        "        print(cluster.scheduler_address, flush=True)\n"
        "        sys.stdin.read()\n"
    )
    environment = {**os.environ, "PYTHONPATH": SRC}
    with subprocess.Popen(
        [sys.executable, "-c", code],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        text=True,
        cwd="/",  # nothing of a workspace is there
        env=environment,
    ) as process:
        assert process.stdout is not None
        assert process.stdin is not None
        yield process.stdout.readline().strip()
        process.stdin.close()
        process.wait(30)


def archlint(*words: str, cwd: Path) -> Said:
    """A process of its own, as Dask's client has threads."""
    code = (
        "import sys; from archlint.cli import main; from archlint.engine import executors; "
        "from archlint.programs import linker; from archlint.syntax import compile; "
        "executors._WORTH_IT, linker.WORTH_IT, compile.PARALLEL_BYTES = 1, 0, 1_000; "
        "sys.exit(main(sys.argv[1:]))"
    )
    command = [sys.executable, "-c", code, *words, "--isolated", "--no-cache"]
    environment = {**os.environ, "PYTHONPATH": SRC}
    done = subprocess.run(command, cwd=cwd, env=environment, capture_output=True, text=True, check=False, timeout=120)
    return done.returncode, re.sub(r'"elapsed_s": [0-9.]+', "", done.stdout), done.stderr


@needs_dask
def test_a_real_cluster_gives_the_same_bytes(workspace: Path, cluster: str, capsys: pytest.CaptureFixture[str]) -> None:
    alone = say(capsys, *COMMANDS[0])
    assert archlint(*COMMANDS[0], "--scheduler", cluster, cwd=workspace) == alone


@needs_dask
@pytest.mark.parametrize("address", ["tcp://127.0.0.1:9", "nonsense://x"])
def test_a_scheduler_that_does_not_answer_is_an_error(workspace: Path, address: str) -> None:
    status, output, error = checked_with(address, "dask_cluster.TIMEOUT = 1", workspace)
    assert (status, output) == (2, "")
    assert f"--scheduler: no Dask scheduler answers at {address}" in error
    assert len(error.splitlines()) == 1


class Listener(threading.Thread):
    """Takes connections at :attr:`address`, sends each the same bytes, and says no more."""

    def __init__(self, greeting: bytes) -> None:
        super().__init__(daemon=True)
        self.greeting = greeting
        self.socket = socket.create_server(("127.0.0.1", 0))
        self.address = f"tcp://127.0.0.1:{self.socket.getsockname()[1]}"
        self.connections: list[socket.socket] = []

    def run(self) -> None:
        with suppress(OSError):
            while True:
                self.connections.append(self.socket.accept()[0])
                self.connections[-1].sendall(self.greeting)

    def close(self) -> None:
        """Wakes the thread and waits for its end: while there is one, nothing in this process forks."""
        with suppress(OSError):
            self.socket.shutdown(socket.SHUT_RDWR)
        self.join()
        for end in (self.socket, *self.connections):
            end.close()


@needs_dask
@pytest.mark.parametrize(
    "greeting", [b"", b"HTTP/1.1 400 Bad Request\r\n\r\n", b"\0" * 100_000], ids=["nothing", "a web page", "zeros"]
)
def test_a_scheduler_that_is_none_is_an_error(workspace: Path, greeting: bytes) -> None:
    listener = Listener(greeting)
    listener.start()
    status, output, error = checked_with(listener.address, "dask_cluster.TIMEOUT = 1", workspace)
    listener.close()
    assert (status, output) == (2, "")
    assert f"--scheduler: no Dask scheduler answers at {listener.address}" in error
    assert len(error.splitlines()) == 1


@needs_dask
@pytest.mark.parametrize("end", ["SIGKILL", "SIGSTOP"])
def test_a_scheduler_that_ends_half_way_is_an_error(workspace: Path, end: str) -> None:
    """Killed, or stopped without a word, once it has the first task."""
    code = (
        "import sys; from distributed import LocalCluster; "
        "cluster = LocalCluster(n_workers=1, processes=False, dashboard_address=None, protocol='tcp://', "
        "host='127.0.0.1'); print(cluster.scheduler_address, flush=True); sys.stdin.read()"
    )
    command, environment = [sys.executable, "-c", code], {**os.environ, "PYTHONPATH": SRC}
    with subprocess.Popen(
        command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, env=environment
    ) as cluster:
        assert cluster.stdout is not None
        address = cluster.stdout.readline().strip()
        half_way = (
            "executors.PATIENCE, submit = 0, executors.ExecutorPool._submit\n"
            "def last(*task):\n"
            f"    future = submit(*task); os.kill({cluster.pid}, signal.{end}); dask_cluster.TIMEOUT = 2\n"
            "    return future\n"
            "executors.ExecutorPool._submit = last"
        )
        status, output, error = checked_with(address, half_way, workspace)
        cluster.kill()
    assert (status, output) == (2, "")
    assert error == f"archlint: error: --scheduler: the scheduler at {address} does not answer any more\n"


def checked_with(address: str, before: str, workspace: Path) -> Said:
    """What a check says with a scheduler, in a process that has run something before."""
    code = (
        "import os, signal; from archlint.cli import main; from archlint.engine import dask_cluster, executors\n"
        "from archlint.syntax import compile; compile.PARALLEL_BYTES = 1\n"
        f"{before}\nmain()"
    )
    environment = {**os.environ, "PYTHONPATH": SRC}
    command = [sys.executable, "-c", code, "check", "--isolated", "--no-cache", "--scheduler", address]
    done = subprocess.run(
        command, cwd=workspace, env=environment, capture_output=True, text=True, check=False, timeout=120
    )
    return done.returncode, done.stdout, done.stderr


def test_nothing_of_dask_is_imported_unless_it_is_asked_for(workspace: Path) -> None:
    code = (
        "import sys; from archlint.cli import main; main(['check', '--no-cache']); "
        "sys.exit(bool({'dask', 'distributed'} & set(sys.modules)) or 'archlint.engine.executors' in sys.modules)"
    )
    environment = {**os.environ, "PYTHONPATH": SRC}
    assert subprocess.run([sys.executable, "-c", code], cwd=workspace, env=environment, check=False).returncode == 0

"""The world around a node that is executed: no network, no writes outside a scratch folder, no waiting.

Sleeps, spins and `input()` return at once. A place that waits again and again is told that the user
pressed Ctrl-C, so that `while True: ...` ends. Threads do not run beside the program: their targets are
kept and run afterwards.
"""

from __future__ import annotations

import asyncio
import builtins
import concurrent.futures
import getpass
import io
import json
import logging
import os
import platform
import random
import select
import signal
import socket
import subprocess
import sys
import termios
import threading
import time
import tty
import uuid
from argparse import ArgumentParser
from collections import Counter
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from types import CodeType
from typing import Any

import yaml

from . import unknown
from .finder import UnknownModule
from .record import recorder
from .unknown import Unknown, VaryingInt, is_tainted

_PATIENCE = 10  # how often one place may wait before it is interrupted
_SPINS = 3  # how often one place hears that ROS is still up

patience = 1.0
"""How many times longer than usual each step may take: on a machine that does many other things."""

_waits: Counter[tuple[CodeType, int]] = Counter()
_oks: Counter[tuple[CodeType, int]] = Counter()


class EndlessWait(KeyboardInterrupt):
    """A place in the program would wait forever."""


class TimeUp(BaseException):
    """A step of the run has used up its time."""


def waited(depth: int = 2) -> None:
    """A place waits: let it go on, but not forever."""
    place = _user_place(sys._getframe(depth))
    _waits[place] += 1
    if _waits[place] > _PATIENCE:
        raise EndlessWait(f"waits without end at {place[0].co_filename}:{place[0].co_firstlineno}")


def still_up() -> bool:
    """What `rclpy.ok()` says: a few times yes at each place, then no."""
    place = _user_place(sys._getframe(2))
    _oks[place] += 1
    return _oks[place] <= _SPINS


def _user_place(frame: Any) -> tuple[CodeType, int]:
    start = frame
    while frame is not None and not frame.f_code.co_filename.startswith(recorder.root):
        frame = frame.f_back
    frame = frame or start
    return frame.f_code, frame.f_lasti


_CLOCKS = (
    (signal.ITIMER_PROF, signal.SIGPROF, time.process_time, 1.0),
    (signal.ITIMER_REAL, signal.SIGALRM, time.monotonic, 4.0),
)


@contextmanager
def limited(seconds: float) -> Iterator[None]:
    """Raise TimeUp in the block once it has computed for so long, or waited four times as long; limits nest.

    The time computed decides, so that a busy machine gives the same record as an idle one.
    """

    def expire(number: int, frame: Any) -> None:
        for timer, _, _, _ in _CLOCKS:
            signal.setitimer(timer, 0.5)  # again, should the program swallow it
        raise TimeUp(f"after {seconds} s")

    outer = []
    seconds *= patience
    for timer, number, clock, factor in _CLOCKS:
        before = signal.signal(number, expire)
        left, _ = signal.setitimer(timer, seconds * factor)
        outer.append((timer, number, clock, before, left, clock()))
    try:
        yield
    finally:
        for timer, number, clock, before, left, started in outer:
            signal.setitimer(timer, 0)
            signal.signal(number, before)
            if left:
                signal.setitimer(timer, max(0.05, left - (clock() - started)))


def close(scratch: Path) -> None:
    """Shut the program in: from here on only `scratch` can be written, and nothing outside is reached."""
    _guard(str(scratch.resolve()))
    _do_not_wait()
    _do_not_start_processes()
    _do_not_start_threads()
    _do_not_vary()
    _do_not_require_settings()
    _do_not_require_arguments()


def _guard(scratch: str) -> None:
    writes = os.O_WRONLY | os.O_RDWR | os.O_CREAT | os.O_TRUNC | os.O_APPEND

    def inside(path: Any) -> bool:
        if isinstance(path, int) or path is None:
            return True
        full = os.path.realpath(os.fsdecode(path))
        return full.startswith(scratch) or full.startswith("/dev/")

    changes = {
        "os.mkdir",
        "os.remove",
        "os.rename",
        "os.rmdir",
        "os.link",
        "os.symlink",
        "os.truncate",
        "os.chmod",
        "os.utime",
        "shutil.rmtree",
    }

    def hook(event: str, arguments: tuple[Any, ...]) -> None:
        if event == "open":
            path, _, flags = arguments
            if flags and flags & writes and not inside(path):
                raise PermissionError(f"writing {path!r} is not allowed here")
        elif event in changes:
            if not inside(arguments[0]):
                raise PermissionError(f"{event} of {arguments[0]!r} is not allowed here")
        elif event in (
            "socket.connect",
            "socket.getaddrinfo",
            "socket.gethostbyname",
            "socket.sendto",
            "socket.bind",
        ):
            raise ConnectionRefusedError("there is no network here")
        elif event in (
            "os.exec",
            "os.posix_spawn",
            "os.spawn",
            "os.system",
            "subprocess.Popen",
            "os.kill",
            "os.killpg",
        ):
            raise PermissionError("no processes are started here")

    sys.addaudithook(hook)


def _do_not_wait() -> None:
    def sleep(seconds: object = 0, *_: object, **__: object) -> None:
        waited(2)

    async def async_sleep(delay: float, result: Any = None) -> Any:
        waited(2)
        return result

    def read(prompt: object = "") -> str:
        waited(2)
        return ""

    time.sleep = sleep  # type: ignore[assignment]
    asyncio.sleep = async_sleep  # type: ignore[assignment]
    builtins.input = read  # type: ignore[assignment]
    sys.stdin = _Silence(Path(os.devnull).open("rb", buffering=0))  # noqa: SIM115
    select.select = _returning(([], [], []))  # type: ignore[assignment]
    for module in (termios, tty):
        for name in ("tcgetattr", "tcsetattr", "setraw", "setcbreak", "tcflush", "tcdrain"):
            setattr(module, name, Unknown(name))
    sys.modules["curses"] = _curses()
    for name in (
        "",
        ".ttk",
        ".messagebox",
        ".filedialog",
        ".simpledialog",
        ".scrolledtext",
        ".font",
        ".colorchooser",
    ):
        sys.modules[f"tkinter{name}"] = UnknownModule(f"tkinter{name}")
    _open_unknown_files()
    threading.Event.wait = _returning(True)  # type: ignore[method-assign]
    threading.Condition.wait = _returning(True)  # type: ignore[assignment]
    threading.Thread.join = _returning(None)  # type: ignore[assignment]
    os._exit = lambda code=0: sys.exit(code)  # type: ignore[assignment]


def _open_unknown_files() -> None:
    """A file whose path is unknown is unknown, and so is what JSON and YAML read from it."""
    plain = builtins.open

    def open_(file: Any, *args: Any, **kwargs: Any) -> Any:
        if isinstance(file, Unknown) or is_tainted(file):
            return Unknown("file")
        return plain(file, *args, **kwargs)

    def reader(read: Callable[..., Any]) -> Callable[..., Any]:
        def read_unless_unknown(source: Any, *args: Any, **kwargs: Any) -> Any:
            return Unknown("content") if isinstance(source, Unknown) else read(source, *args, **kwargs)

        return read_unless_unknown

    plain_logger = logging.getLogger
    logging.getLogger = lambda name=None: plain_logger(str(name) if isinstance(name, Unknown) else name)
    builtins.open = open_  # type: ignore[assignment]
    for module, names in (
        (json, ("load", "loads")),
        (yaml, ("load", "safe_load", "full_load", "unsafe_load")),
    ):
        for name in names:
            setattr(module, name, reader(getattr(module, name)))


def _curses() -> Any:
    """A terminal that is not there."""
    module = Unknown("curses")
    module.wrapper = lambda function, *args, **kwargs: function(Unknown("screen"), *args, **kwargs)
    return module


class _Silence(io.TextIOWrapper):
    """A keyboard that nobody presses."""

    def read(self, size: int | None = -1) -> str:
        waited(2)
        return ""

    def readline(self, size: int = -1) -> str:  # type: ignore[override]
        waited(2)
        return ""


def _returning(value: Any) -> Callable[..., Any]:
    def at_once(*_: object, **__: object) -> Any:
        waited(2)
        return value

    return at_once


def _do_not_start_processes() -> None:
    unknown = Unknown("process")
    for name in ("Popen", "run", "call", "check_call", "check_output", "getoutput", "getstatusoutput"):
        setattr(subprocess, name, getattr(unknown, name))
    os.system = lambda command: 0  # type: ignore[assignment]
    os.popen = unknown.popen
    os.kill = lambda *_: None  # type: ignore[assignment]
    os.killpg = lambda *_: None  # type: ignore[assignment]


def _do_not_start_threads() -> None:
    def start(self: threading.Thread) -> None:
        self._started.set()  # type: ignore[attr-defined]
        recorder.tasks.append((self.run, ()))

    def submit(self: Any, function: Callable[..., Any], /, *args: Any, **kwargs: Any) -> Any:
        future: concurrent.futures.Future[Any] = concurrent.futures.Future()
        try:
            future.set_result(function(*args, **kwargs))
        except Exception as error:
            future.set_exception(error)
        return future

    threading.Thread.start = start  # type: ignore[method-assign]
    concurrent.futures.ThreadPoolExecutor.submit = submit  # type: ignore[assignment,method-assign]
    concurrent.futures.ProcessPoolExecutor.submit = submit  # type: ignore[assignment,method-assign]
    try:
        import multiprocessing.process as process

        process.BaseProcess.start = lambda self: recorder.tasks.append((self.run, ()))  # type: ignore[method-assign]
        process.BaseProcess.join = _returning(None)  # type: ignore[method-assign]
    except ImportError:
        pass


def _do_not_vary() -> None:
    """What is another in each run, or on each machine, must not get into a name unnoticed."""
    pid = VaryingInt(os.getpid())
    os.getpid = lambda: pid  # type: ignore[assignment]
    for name in ("uuid1", "uuid4"):
        setattr(uuid, name, lambda *_, **__: Unknown("uuid"))
    socket.gethostname = platform.node = lambda: str(Unknown("host name"))  # type: ignore[assignment]
    getpass.getuser = lambda: str(Unknown("user name"))  # type: ignore[assignment]
    plain = random.randint
    random.randint = lambda low, high: VaryingInt(plain(low, high))  # type: ignore[assignment]


def _do_not_require_settings() -> None:
    """An environment variable that must be set is an unknown text."""
    plain = os._Environ.__getitem__

    def get(self: Any, key: Any) -> Any:
        try:
            return plain(self, key)
        except KeyError:
            if sys._getframe(1).f_code.co_filename.startswith(recorder.root):
                return str(Unknown(f"environment {key}"))
            raise

    os._Environ.__getitem__ = get  # type: ignore[method-assign]


def _do_not_require_arguments() -> None:
    """A command-line argument that must be given is an unknown value."""
    parse = ArgumentParser.parse_known_args

    def lenient(self: ArgumentParser, args: Any = None, namespace: Any = None) -> Any:
        for action in self._actions:
            if action.option_strings:
                if unknown.other_way and isinstance(action.const, bool) and action.nargs == 0:
                    action.default = action.const
                if action.required:
                    action.required = False
                    action.default = Unknown(f"argument {action.dest}")
            elif action.nargs in (None, "+") or isinstance(action.nargs, int):
                action.required = False
                action.default = Unknown(f"argument {action.dest}")
                action.nargs = "?" if action.nargs is None else "*"
        return parse(self, args, namespace)

    ArgumentParser.parse_known_args = lenient  # type: ignore[assignment,method-assign]


__all__ = ["EndlessWait", "TimeUp", "close", "is_tainted", "limited", "still_up", "waited"]

"""Runs of archlint over made-up files: in this process, or in one of its own that may do no harm."""

from __future__ import annotations

import io
import json
import os
import resource
import signal
import sys
import tempfile
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager, redirect_stderr, redirect_stdout
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from archlint.cli import main
from archlint.config.settings import load
from archlint.config.source import ConfigurationError
from archlint.engine.pipeline import NothingToDo, Request, check
from archlint.finding import Finding
from archlint.report.model import Report
from archlint.report.occurrence import Occurrence

Files = Mapping[str, bytes]
"""The bytes of files by their paths."""


@dataclass(frozen=True)
class Ran:
    """What a command printed, and how it ended."""

    status: int
    out: str
    err: str


def command(*words: str) -> Ran:
    """Run a command of archlint in the working directory."""
    out, err = (io.TextIOWrapper(io.BytesIO(), "utf-8", write_through=True, newline="") for _ in range(2))
    with redirect_stdout(out), redirect_stderr(err):
        status = main(list(words))
    return Ran(status, *(stream.buffer.getvalue().decode() for stream in (out, err)))  # type: ignore[attr-defined]


def report_on(folder: Path) -> Report | None:
    """The report on a folder, with each finding by itself among its occurrences; None where there is nothing to do, or
    no telling what."""
    with inside(folder):
        try:
            return check(Request((".",), load(folder), cached=False, jobs=1, occurrences=True))
        except (ConfigurationError, NothingToDo):
            return None


def findings(folder: Path) -> list[Finding]:
    """What the rules find in a folder."""
    report = report_on(folder)
    return [] if report is None else list(report.findings)


def occurrences(folder: Path) -> list[Occurrence]:
    """The same, before findings with one cause are made one."""
    report = report_on(folder)
    return [] if report is None else list(report.occurrences)


@contextmanager
def inside(folder: Path) -> Iterator[Path]:
    """The folder as the working directory."""
    before = Path.cwd()
    os.chdir(folder)
    try:
        yield folder
    finally:
        os.chdir(before)


@contextmanager
def laid_out(files: Files) -> Iterator[Path]:
    """The files in a temporary folder, which is the working directory."""
    with tempfile.TemporaryDirectory(prefix="fuzz") as temporary:
        folder = Path(temporary, "workspace")
        folder.mkdir()
        write(folder, files)
        with inside(folder):
            yield folder


def write(folder: Path, files: Files) -> None:
    """Write files below a folder."""
    for path, content in files.items():
        target = folder / path
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_bytes(content)


class Killed(Exception):
    """A process that had to end: ``str()`` says how."""


def isolated(act: Callable[[], None], seconds: int, most_bytes: int) -> dict[str, Any] | None:
    """Do something in a process of its own, which may take so many seconds of processor time and so much memory.

    Returns what an exception says of itself: its ``kind`` and its ``message``; None where there was none.  Raises
    :class:`Killed` where the process did not come to its end.
    """
    reader, writer = os.pipe()
    child = os.fork()
    if child == 0:
        os.close(reader)
        _limit(seconds, most_bytes)
        said = _said(act)
        with os.fdopen(writer, "w") as stream:
            json.dump(said, stream)
        os._exit(0)
    os.close(writer)
    with os.fdopen(reader) as stream:
        text = stream.read()
    _, status = os.waitpid(child, 0)
    if not text:
        number = os.WTERMSIG(status)
        reason = (
            "takes too long"
            if number == signal.SIGXCPU
            else f"ends with {signal.Signals(number).name}"
            if number
            else "ends"
        )
        raise Killed(f"the process {reason}")
    result: dict[str, Any] | None = json.loads(text)
    return result


def _limit(seconds: int, most_bytes: int) -> None:
    resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds + 5))
    resource.setrlimit(resource.RLIMIT_AS, (most_bytes, most_bytes))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    nowhere = os.open(os.devnull, os.O_RDWR)
    for stream in (0, 1, 2):
        os.dup2(nowhere, stream)


def _said(act: Callable[[], None]) -> dict[str, Any] | None:
    try:
        act()
    except BaseException as error:
        return {"kind": type(error).__name__, "message": str(error)}
    return None


class Endless(Exception):
    """A run that made more calls than it may."""


@contextmanager
def counted_calls(most: int) -> Iterator[None]:
    """Raises :class:`Endless` where more functions of Python are called inside, in any thread: a bound for tests that
    is the same on every machine."""
    import threading

    left = [most]

    def count(frame: object, event: str, argument: object) -> None:
        if event == "call":
            left[0] -= 1

    threading.setprofile(count)
    sys.setprofile(count)
    try:
        yield
    finally:
        sys.setprofile(None)
        threading.setprofile(None)  # type: ignore[arg-type]
    if left[0] < 0:
        raise Endless(f"{most - left[0]} calls")

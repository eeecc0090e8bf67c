"""What another machine does of a run: it gets bytes and gives bytes, and looks at no file of the workspace.

A task runs in a process of its own, so that no source takes the worker down and other tasks in other threads of it have
nothing to do with archlint.
"""

from __future__ import annotations

import hashlib
import os
import subprocess
import sys
from functools import cache
from pathlib import Path
from typing import Annotated, Literal

import msgspec

from archlint import __version__
from archlint.rulebook import pages_folder


class Task(msgspec.Struct, frozen=True):
    """A map of a job, by its name, over some sources."""

    job: str
    deadline: float
    sources: list[bytes]


class Row(msgspec.Struct, frozen=True, array_like=True):
    """The answer for one source, and the seconds of processor time that it took."""

    kind: Literal["answer", "crashed", "timed out"]
    payload: bytes
    seconds: Annotated[float, msgspec.Meta(ge=0, le=1_000_000)]


class Done(msgspec.Struct, frozen=True):
    """The answers to a task, in the order of its sources, and who has given them; none where it ``failed``."""

    identity: str
    rows: list[Row] = []
    failed: bool = False


@cache
def identity() -> str:
    """Which archlint this is, and which Python: others may say something else of the same source."""
    content = hashlib.sha256()
    for folder in (Path(__file__).parents[1], pages_folder()):
        for path in sorted(path for path in folder.rglob("*") if path.suffix in (".py", ".md", ".json")):
            content.update(f"{path.relative_to(folder)}\0".encode() + path.read_bytes() + b"\0")
    return f"archlint {__version__}-{content.hexdigest()[:12]}, Python {sys.version_info[0]}.{sys.version_info[1]}"


def run_task(wanted: str, task: bytes) -> bytes:
    """Run on a worker: what a task comes to, if this is the archlint that is ``wanted``."""
    if identity() != wanted:
        return msgspec.msgpack.encode(Done(identity()))
    home = Path(__file__).parents[2]
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(path for path in sys.path if path)}
    done = subprocess.run(
        [sys.executable, "-m", "archlint.engine.remote_jobs"],
        input=task,
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        cwd=home,  # Python imports from there first
        env=environment,
        check=False,
    )
    return msgspec.msgpack.encode(Done(identity(), failed=True)) if done.returncode else done.stdout


__all__ = ["Done", "Row", "Task", "identity", "run_task"]

"""Records and compares one repository."""

from __future__ import annotations

import json
import multiprocessing
import subprocess
import time
from collections import Counter
from dataclasses import dataclass
from multiprocessing.connection import Connection
from pathlib import Path

from benchmarks.launches import compare
from benchmarks.launches.expected import Checkout
from benchmarks.launches.record import Sandbox, record

MINUTES = 30
"""How long one repository may be compared."""


@dataclass(frozen=True)
class Outcome:
    """What came of one repository: its counts, or why there are none."""

    name: str
    counts: Counter[str]
    failure: str | None = None


def held(root: Path, sandbox: Sandbox, output: Path) -> Outcome:
    """Record a repository, unless that has been done, and compare it."""
    path = output / f"{root.name}.json"
    try:
        if not path.exists():
            path.write_text(json.dumps(record(root, sandbox), indent=1) + "\n", "utf-8")
    except (OSError, subprocess.SubprocessError) as error:
        return Outcome(root.name, Counter(), f"not recorded: {error}")
    return compared(root, output)


def compared(root: Path, output: Path) -> Outcome:
    """Compare in a process of its own, whose memory is free again afterwards."""
    context = multiprocessing.get_context("spawn")
    reading, writing = context.Pipe(duplex=False)
    process = context.Process(target=_compare, args=(root, output, writing))
    start = time.monotonic()
    process.start()
    writing.close()
    try:
        answered = reading.poll(MINUTES * 60)
        counts = reading.recv() if answered else None
    except EOFError:
        counts = None
    if counts is None and time.monotonic() - start >= MINUTES * 60:
        process.kill()
    process.join()
    return Outcome(root.name, counts or Counter(), None if counts is not None else f"no answer ({process.exitcode})")


def _compare(root: Path, output: Path, writing: Connection) -> None:
    rows = json.loads((output / f"{root.name}.json").read_text("utf-8"))
    counts, told = compare.measure(rows, Checkout(root)) if rows else (Counter[str](), [])
    lines = [compare.HEAD, compare.line(root.name.replace("+", "/"), counts), *told]
    (output / f"{root.name}.txt").write_text("\n".join(lines) + "\n", "utf-8")
    writing.send(counts)

"""Whole processes, measured: wall time, CPU time of the process and all its children, peak memory."""

from __future__ import annotations

import os
import statistics
import subprocess
import sys
import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

ARCHLINT = (sys.executable, "-m", "archlint")
CHECK = (*ARCHLINT, "check", ".", "--exit-zero", "--format", "concise")


@dataclass(frozen=True)
class Cost:
    """What a process took: seconds of wall time and of CPU, and the most memory in MB of any process of it."""

    wall: float
    cpu: float
    peak: float


Step = Callable[[], Cost]
"""Prepares what is to be measured (an edit, say), runs it, and says what it took."""


_ENVIRONMENT = {name: value for name, value in os.environ.items() if name != "PYTHONDONTWRITEBYTECODE"}
"""Python keeps what it has compiled, as it does for users: a part of each run would be compiling archlint."""


def run(command: Sequence[str], folder: Path) -> Cost:
    """What one process took; its output is thrown away.  Raises ``RuntimeError`` where it could not do its job."""
    started = time.perf_counter()
    nowhere = subprocess.DEVNULL
    process = subprocess.Popen(command, cwd=folder, stdout=nowhere, stderr=nowhere, env=_ENVIRONMENT)
    _, status, usage = os.wait4(process.pid, 0)
    wall = time.perf_counter() - started
    process.returncode = os.waitstatus_to_exitcode(status)  # it is waited for: Popen need not
    if process.returncode not in (0, 1):  # 1: findings, of flake8 and of the peer too
        raise RuntimeError(f"{' '.join(command)} ended with {process.returncode}")
    scale = 1e6 if sys.platform == "darwin" else 1e3
    return Cost(wall, usage.ru_utime + usage.ru_stime, usage.ru_maxrss / scale)


@dataclass(frozen=True)
class Pair:
    """The costs of two steps that were measured in turn, a round after the other."""

    step: Sequence[Cost]
    other: Sequence[Cost]

    def ratio(self, of: Callable[[Cost], float]) -> float:
        """The median of the ratios inside the rounds: what slows the machine down slows both steps of a round."""
        return statistics.median(of(a) / of(b) for a, b in zip(self.step, self.other, strict=True))


def in_turn(rounds: int, steps: Mapping[str, Step]) -> dict[str, list[Cost]]:
    """The costs of some steps, each round in the same order."""
    costs: dict[str, list[Cost]] = {name: [] for name in steps}
    for _ in range(rounds):
        for name, step in steps.items():
            costs[name].append(step())
    return costs


def pair(costs: Mapping[str, Sequence[Cost]], name: str, other: str) -> Pair:
    return Pair(costs[name], costs[other])

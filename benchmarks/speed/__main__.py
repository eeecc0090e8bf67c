"""How long a run takes, beside a peer, in the same session: ``python -m benchmarks.speed CHECKOUT… [--peer PATH]``.

Whole processes, in turn (archlint cold, archlint warm, the peer, and again), so that a machine whose speed drifts
drifts for all of them.  What counts is the ratio inside a round; seconds are printed for orientation only.
"""

from __future__ import annotations

import argparse
import shutil
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path


def timed(command: list[str], folder: Path) -> float:
    """Seconds of wall time of one process; its output is thrown away, its exit code is not judged."""
    started = time.perf_counter()
    subprocess.run(command, cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False)
    return time.perf_counter() - started


def measure(checkout: Path, rounds: int, peer: str | None) -> dict[str, list[float]]:
    with tempfile.TemporaryDirectory() as cache:
        archlint = [sys.executable, "-m", "archlint", "check", ".", "--exit-zero", "--format", "concise"]
        warm = [*archlint, "--cache-dir", cache]
        timed(warm, checkout)
        commands = {"cold": [*archlint, "--no-cache"], "warm": warm}
        if peer is not None:
            commands["peer"] = [peer, "nodes", "-C", str(checkout), "--format", "json", "--no-cache"]
        return _rounds(commands, checkout, rounds)


def _rounds(commands: dict[str, list[str]], checkout: Path, rounds: int) -> dict[str, list[float]]:
    times: dict[str, list[float]] = {name: [] for name in commands}
    for _ in range(rounds):
        for name, command in commands.items():
            times[name].append(timed(command, checkout))
    return times


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("checkouts", nargs="+", type=Path)
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--peer", default=shutil.which("ros2inspector"))
    arguments = parser.parse_args()
    print("| checkout | cold s | warm s | peer s | cold / peer | warm / cold |")
    print("|---|---|---|---|---|---|")
    for checkout in arguments.checkouts:
        times = measure(checkout.resolve(), arguments.rounds, arguments.peer)
        cold, warm = times["cold"], times["warm"]
        peer = times.get("peer", [])
        against = f"{statistics.median(c / p for c, p in zip(cold, peer, strict=True)):.2f}" if peer else "-"
        ratio = statistics.median(w / c for w, c in zip(warm, cold, strict=True))
        seconds = f"{statistics.median(peer):.2f}" if peer else "-"
        print(
            f"| {checkout.name} | {statistics.median(cold):.2f} | {statistics.median(warm):.2f} | {seconds} "
            f"| {against} | {ratio:.2f} |"
        )


if __name__ == "__main__":
    main()

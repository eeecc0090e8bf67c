"""Every repository of a folder, one after the other, with all rules: ``python -m benchmarks.scale CHECKOUTS -o FILE``.

Each is checked without a cache by one process in its own session.  A *crash* is an exit status that the contract does
not know, a traceback, a report that is no JSON, or a rule that raised (LNT003); a *timeout* is a run that is ended
after the limit.  Rows that the file of ``-o`` holds already are not run again: a run that was broken off goes on.
Without CHECKOUTS the table is made from the rows alone.
"""

from __future__ import annotations

import argparse
import json
import os
import signal
import statistics
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Sequence
from dataclasses import astuple, dataclass
from pathlib import Path

ALL_RULES = (
    "check",
    ".",
    "--isolated",
    "--select",
    "ALL",
    "--no-cache",
    "--jobs",
    "1",
    "--format",
    "json",
    "--exit-zero",
)
SLOWEST = 8
NOTHING = "nothing to check"
"""Of a repository that is all for ROS 1: the contract's exit status 2."""


@dataclass(frozen=True)
class Row:
    """What one repository took: seconds of wall time and of CPU, and the most memory of any of its processes in MB."""

    name: str
    outcome: str
    """``ok``, ``timeout``, or what is wrong."""
    files: int
    nodes: int
    findings: int
    unread: int
    """Files that were given up (LNT002)."""
    wall: float
    cpu: float
    peak: float

    @classmethod
    def of(cls, line: str) -> Row:
        name, outcome, files, nodes, findings, unread, wall, cpu, peak = line.split("\t")
        counts = (int(files), int(nodes), int(findings), int(unread))
        return cls(name, outcome, *counts, float(wall), float(cpu), float(peak))

    def line(self) -> str:
        return "\t".join(f"{value:.2f}" if isinstance(value, float) else str(value) for value in astuple(self))


def check(folder: Path, seconds: float) -> Row:
    """One run over a repository, which is ended with all its workers after so many seconds."""
    with tempfile.TemporaryDirectory() as temporary:
        report, errors = Path(temporary, "report.json"), Path(temporary, "errors")
        command = (sys.executable, "-m", "archlint", *ALL_RULES, "-o", str(report))
        ended = threading.Event()
        started = time.perf_counter()
        with errors.open("wb") as stream:
            process = subprocess.Popen(
                command, cwd=folder, stdout=subprocess.DEVNULL, stderr=stream, start_new_session=True
            )

            def end() -> None:
                ended.set()
                os.killpg(process.pid, signal.SIGKILL)

            timer = threading.Timer(seconds, end)
            timer.start()
            _, status, usage = os.wait4(process.pid, 0)
            timer.cancel()
        process.returncode = os.waitstatus_to_exitcode(status)  # it is waited for: Popen need not
        wall = time.perf_counter() - started
        said = errors.read_text("utf-8", "replace")
        outcome, counts = ("timeout", (0, 0, 0, 0)) if ended.is_set() else _judged(process.returncode, said, report)
    scale = 1e6 if sys.platform == "darwin" else 1e3
    return Row(folder.name, outcome, *counts, wall, usage.ru_utime + usage.ru_stime, usage.ru_maxrss / scale)


def _judged(status: int, said: str, report: Path) -> tuple[str, tuple[int, int, int, int]]:
    """What is wrong with a run that ended by itself, or ``ok``; files, nodes, findings and files given up."""
    if "Traceback" in said:
        return f"traceback: {said.strip().splitlines()[-1][:120]}", (0, 0, 0, 0)
    if status == 2 and "error: nothing to check in" in said:
        return NOTHING, (0, 0, 0, 0)
    if status != 0:
        return f"exit status {status}: {' '.join(said.split())[:120]}", (0, 0, 0, 0)
    try:
        told = json.loads(report.read_text("utf-8"))
    except (OSError, ValueError) as error:
        return f"no report: {error}", (0, 0, 0, 0)
    findings, summary = told["diagnostics"], told["summary"]
    codes = [finding["code"] for finding in findings]
    outcome = f"{codes.count('LNT003')} rules raised" if "LNT003" in codes else "ok"
    return outcome, (summary["files"], summary["nodes"], len(findings), codes.count("LNT002"))


def table(rows: Sequence[Row]) -> str:
    """What the rows come to, and the slowest of them."""
    walls = sorted(row.wall for row in rows)
    wrong = [row for row in rows if row.outcome not in ("ok", NOTHING, "timeout")]
    median, peak, late = (
        statistics.median(walls),
        statistics.median(row.peak for row in rows),
        walls[len(walls) * 9 // 10],
    )
    largest = max(rows, key=lambda row: row.peak)
    lines = [
        "| | |",
        "|---|---|",
        f"| repositories | {len(rows)} |",
        f"| files, nodes, findings | {_sum(rows, 'files')}, {_sum(rows, 'nodes')}, {_sum(rows, 'findings')} |",
        f"| files given up (LNT002) | {_sum(rows, 'unread')} |",
        f"| crashes | {len(wrong)} |",
        f"| timeouts | {sum(row.outcome == 'timeout' for row in rows)} |",
        f"| seconds: median, 9 of 10, most | {median:.1f}, {late:.1f}, {walls[-1]:.1f} |",
        f"| peak memory in MB: median, most | {peak:.0f}, {largest.peak:.0f} ({largest.name}) |",
        "",
        "| slowest | files | s | CPU s | MB |",
        "|---|---|---|---|---|",
    ]
    for row in sorted(rows, key=lambda row: -row.wall)[:SLOWEST]:
        lines.append(f"| {row.name} | {row.files} | {row.wall:.1f} | {row.cpu:.1f} | {row.peak:.0f} |")
    return "\n".join([*lines, *(f"\n{row.name}: {row.outcome}" for row in rows if row.outcome != "ok")])


def _sum(rows: Sequence[Row], column: str) -> str:
    return f"{sum(getattr(row, column) for row in rows):,}"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("checkouts", type=Path, nargs="?", help="a folder of repositories, side by side")
    parser.add_argument("-o", "--output", type=Path, required=True, help="a line for each repository")
    parser.add_argument("--seconds", type=float, default=120, help="after which a run is ended")
    options = parser.parse_args()
    held = options.output.read_text("utf-8").splitlines() if options.output.exists() else []
    rows = [Row.of(line) for line in held]
    known = {row.name for row in rows}
    folders = sorted(options.checkouts.iterdir()) if options.checkouts else []
    for folder in folders:
        if folder.is_dir() and folder.name not in known:
            rows.append(check(folder, options.seconds))
            with options.output.open("a", encoding="utf-8") as stream:
                stream.write(f"{rows[-1].line()}\n")
    if not rows:
        parser.error(f"no repositories in {options.checkouts}")
    print(table(rows))
    sys.exit(1 if any(row.outcome not in ("ok", NOTHING) for row in rows) else 0)


if __name__ == "__main__":
    main()

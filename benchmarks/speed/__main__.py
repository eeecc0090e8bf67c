"""How long runs take, beside other runs and other programs: ``python -m benchmarks.speed COMMAND …``.

Whole processes, in turn, so that a machine whose speed drifts drifts for all of them.  What counts is the ratio inside
a round, of CPU and of wall time; seconds are printed for orientation only.
"""

from __future__ import annotations

import argparse
import importlib.util
import os
import shutil
import statistics
import sys
from collections.abc import Callable, Sequence
from pathlib import Path

from benchmarks.speed.curves import curves
from benchmarks.speed.growth import growth, slowest_files
from benchmarks.speed.hostile import stalling
from benchmarks.speed.processes import Cost
from benchmarks.speed.rows import ROWS, Row, Tools
from benchmarks.speed.rules import shares

_GROWTH_BAR, _PEAK_BAR, _FILE_BAR = 1.15, 1200, 5
_EDIT_AIM = 300


def compare(arguments: argparse.Namespace) -> None:
    """The rows of a command over some checkouts."""
    flake8 = (sys.executable, "-m", "flake8") if importlib.util.find_spec("flake8") else ()
    found = shutil.which("flake8")
    tools = Tools(arguments.rounds, arguments.peer, (found,) if found else flake8)
    print(f"medians of {tools.rounds} paired runs, {os.cpu_count()} processors, load {os.getloadavg()[0]:.1f}\n")
    print("| checkout | row | CPU | wall | bar | aim | CPU s | wall s |\n|---|---|---|---|---|---|---|---|")
    for checkout in arguments.checkouts:
        for row in ROWS[arguments.command](checkout.resolve(), tools):
            print(f"| {checkout.name} | {_cells(row)} |", flush=True)


def _cells(row: Row) -> str:
    ratios = [f"{row.pair.ratio(of):.2f}" for of in (_cpu, _wall)]
    seconds = [f"{_median(row.pair.step, of):.2f} / {_median(row.pair.other, of):.2f}" for of in (_cpu, _wall)]
    return " | ".join([row.name, *ratios, f"≤ {row.bar}", str(row.aim), *seconds])


def _cpu(cost: Cost) -> float:
    return cost.cpu


def _wall(cost: Cost) -> float:
    return cost.wall


def _median(costs: Sequence[Cost], of: Callable[[Cost], float]) -> float:
    return statistics.median(map(of, costs))


def grow(arguments: argparse.Namespace) -> None:
    """Time and memory beside those of the smallest workspace, for each package."""
    sizes = list(growth(arguments.sizes, arguments.rounds))
    first, last = sizes[0], sizes[-1]
    print("| packages | CPU s | wall s | peak MB | CPU / linear | memory / linear |\n|---|---|---|---|---|---|")
    for size in sizes:
        times = size.packages / first.packages
        print(
            f"| {size.packages} | {size.cost.cpu:.2f} | {size.cost.wall:.2f} | {size.cost.peak:.0f} "
            f"| {size.cost.cpu / first.cost.cpu / times:.2f} | {size.cost.peak / first.cost.peak / times:.2f} |"
        )
    if len(sizes) > 1:
        # What starts and ends costs the same whatever the size: it would hide growth in the ratio to the smallest.
        before = sizes[-2]
        slope = (last.cost.cpu - before.cost.cpu) / (last.packages - before.packages)
        early = (before.cost.cpu - first.cost.cpu) / max(1, before.packages - first.packages)
        told = f"{slope / early:.2f}" if early > 0 else "-"
        print(f"\na package more costs, at the end / before: {told} (bar: {_GROWTH_BAR})")
    print(f"peak memory of {last.packages} packages: {last.cost.peak:.0f} MB (bar: {_PEAK_BAR})")


def tell_rules(arguments: argparse.Namespace) -> None:
    """Each rule's seconds for each size, and how much faster than the workspace they grow."""
    sizes = arguments.sizes
    print(f"| | {' | '.join(f'{size} packages, s' for size in sizes)} | growth / linear |")
    print("|---|" + "---|" * (len(sizes) + 1))
    rows = shares(sizes)
    for name in sorted(rows, key=lambda name: -rows[name][-1])[: arguments.shown]:
        seconds = rows[name]
        grown = seconds[-1] / seconds[0] / (sizes[-1] / sizes[0]) if seconds[0] else 0.0
        print(f"| {name} | {' | '.join(f'{second:.3f}' for second in seconds)} | {grown:.2f} |")


def slowest(arguments: argparse.Namespace) -> None:
    """The files that take longest when each is checked alone."""
    print(f"| CPU s (bar: {_FILE_BAR}) | file |\n|---|---|")
    for checkout in arguments.checkouts:
        for seconds, file in slowest_files(checkout.resolve(), arguments.shown):
            print(f"| {seconds:.2f} | {checkout.name}/{file} |")


def stall(arguments: argparse.Namespace) -> None:
    """Source that is made to stall its reader: seconds until it is accepted or refused."""
    print(f"| source | CPU s (bar: {_FILE_BAR}) | half of it / all of it |\n|---|---|---|")
    for name, seconds, share in stalling(arguments.parts):
        print(f"| {name} | {seconds:.2f} | {share:.2f} |")


def draw_curves(arguments: argparse.Namespace) -> None:
    """Time and memory for so many of one thing, and for twice, four and eight times as many."""
    print(
        "| of | n | n: CPU s | 2n | 4n | 8n | growth at the end | n: MB | 8n |\n|---|---|---|---|---|---|---|---|---|"
    )
    for curve in curves(arguments.names):
        seconds = " | ".join(f"{cost.cpu:.2f}" for cost in curve.costs)
        peaks = f"{curve.costs[0].peak:.0f} | {curve.costs[-1].peak:.0f}"
        print(f"| {curve.name} | {curve.first} | {seconds} | {curve.growth:.1f} | {peaks} |", flush=True)


def serve(arguments: argparse.Namespace) -> None:
    """How long an editor waits for the diagnostics after an edit."""
    from benchmarks.speed.server import waits  # with the extra lsp, which the other commands do without

    print(f"{arguments.packages} packages of four Python files, load {os.getloadavg()[0]:.1f}\n")
    print(f"| edit | median, ms (aim: {_EDIT_AIM}) | longest, ms | CPU of the server, ms |\n|---|---|---|---|")
    for row in waits(arguments.packages, arguments.rounds):
        print("| " + " | ".join([row.kind, *(f"{1000 * seconds:.0f}" for seconds in row.medians)]) + " |", flush=True)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    commands = parser.add_subparsers(dest="command", required=True)
    for name, rows in ROWS.items():
        command = commands.add_parser(name, help=rows.__doc__)
        command.add_argument("checkouts", nargs="+", type=Path)
        command.add_argument("--rounds", type=int, default=5)
        command.add_argument("--peer", default=shutil.which("ros2inspector"), help="the program ros2inspector")
        command.set_defaults(run=compare)
    command = commands.add_parser("growth", help=grow.__doc__)
    command.add_argument("--sizes", type=int, nargs="+", default=[10, 100, 300, 1000])
    command.add_argument("--rounds", type=int, default=1)
    command.set_defaults(run=grow)
    command = commands.add_parser("rules", help=tell_rules.__doc__)
    command.add_argument("--sizes", type=int, nargs="+", default=[10, 100, 300, 1000])
    command.add_argument("--shown", type=int, default=20)
    command.set_defaults(run=tell_rules)
    command = commands.add_parser("slowest", help=slowest.__doc__)
    command.add_argument("checkouts", nargs="+", type=Path)
    command.add_argument("--shown", type=int, default=5)
    command.set_defaults(run=slowest)
    command = commands.add_parser("hostile", help=stall.__doc__)
    command.add_argument("--parts", type=int, default=200_000)
    command.set_defaults(run=stall)
    command = commands.add_parser("curves", help=draw_curves.__doc__)
    command.add_argument("names", nargs="*", help="words of the names of axes; all without any")
    command.set_defaults(run=draw_curves)
    command = commands.add_parser("server", help=serve.__doc__)
    command.add_argument("--packages", type=int, default=150)
    command.add_argument("--rounds", type=int, default=7)
    command.set_defaults(run=serve)
    arguments = parser.parse_args()
    arguments.run(arguments)


if __name__ == "__main__":
    main()

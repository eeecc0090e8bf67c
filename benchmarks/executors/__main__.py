"""``python -m benchmarks.executors observe jazzy|kilted`` tries cells; ``… compare`` holds archlint against them."""

from __future__ import annotations

import argparse
import re
import sys
from collections import Counter

from tests_ros.environments import Environment

from benchmarks.executors import table
from benchmarks.executors.cells import Cell, all_cells
from benchmarks.executors.running import observe, outcome
from benchmarks.executors.verdicts import agrees, verdicts

_BATCH = 200


def main() -> None:
    parser = argparse.ArgumentParser(prog="python -m benchmarks.executors", description=__doc__)
    commands = parser.add_subparsers(dest="command", required=True)
    trying = commands.add_parser("observe", help="run cells under a real rclpy and note in observed.tsv what they do")
    trying.add_argument("distro", choices=table.DISTROS)
    trying.add_argument("--runs", type=int, default=1, help="how often, in turn with one end first")
    trying.add_argument("--jobs", type=int, default=8, help="how many programs run at a time")
    comparing = commands.add_parser("compare", help="what archlint says of each program against what was observed")
    comparing.add_argument("--cells", action="store_true", help="name every cell that does not agree")
    for command in (trying, comparing):
        command.add_argument("--only", default="", metavar="REGEX", help="cells whose name matches")
    given = parser.parse_args()
    cells = [cell for cell in all_cells() if re.search(given.only, cell.name)]
    if given.command == "observe":
        try_out(given.distro, cells, given.jobs, given.runs)
    else:
        compare(cells, given.cells)


def try_out(distro: str, cells: list[Cell], jobs: int, runs: int) -> None:
    seen: dict[Cell, list[str]] = {}
    for number, (cell, said) in enumerate(observe(Environment(distro), cells, jobs, runs), 1):
        seen.setdefault(cell, []).append(outcome(said, cell))
        if number % 100 == 0:
            print(f"{number} of {len(cells) * runs} runs", file=sys.stderr)
    observed = table.read()
    table.add(observed[distro], seen)
    table.write(observed)


def compare(cells: list[Cell], names: bool) -> None:
    observed = table.read()
    said: table.Table = {distro: {} for distro in table.DISTROS}
    for start in range(0, len(cells), _BATCH):
        for distro, words in verdicts(cells[start : start + _BATCH], table.DISTROS).items():
            said[distro].update(words)
    for distro, column in observed.items():
        here = [cell for cell in cells if cell in column]
        wrong = [cell for cell in here if not agrees_with(said[distro][cell], column[cell], cell)]
        print(f"{distro}: {len(here)} cells tried, {len(here) - len(wrong)} as archlint says, {len(wrong)} not")
        kinds = Counter((said[distro][cell], column[cell], cell.handler) for cell in wrong)
        for (word, seen, handler), count in sorted(kinds.items()):
            print(f"  {count:4} archlint: {word}; seen: {seen} ({handler})")
        if names:
            print("".join(f"    {cell.name}: {said[distro][cell]}; {column[cell]}\n" for cell in wrong), end="")
    both = [cell for cell in cells if all(cell in column for column in observed.values())]
    seen = {
        cell: tuple(" | ".join(table.outcomes_of(observed[distro][cell])) for distro in table.DISTROS) for cell in both
    }
    differ = [cell for cell in both if len(set(seen[cell])) > 1]
    print(f"{len(differ)} of {len(both)} cells differ between the distributions")
    kinds = Counter(seen[cell] for cell in differ)
    for outcomes, count in sorted(kinds.items()):
        print(
            f"  {count:4} "
            + "; ".join(f"{distro}: {word}" for distro, word in zip(table.DISTROS, outcomes, strict=True))
        )


def agrees_with(said: str, seen: str, cell: Cell) -> bool:
    return all(agrees(said, outcome, cell) for outcome in table.outcomes_of(seen))


if __name__ == "__main__":
    main()

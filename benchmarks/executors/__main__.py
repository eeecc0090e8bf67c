"""``python -m benchmarks.executors observe jazzy|kilted`` tries cells; ``… again`` tries them once more and names those
that do something else; ``… compare`` holds archlint against them."""

from __future__ import annotations

import argparse
import re
import sys
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

from tests_ros.environments import Environment

from benchmarks.executors import table
from benchmarks.executors.again import try_again
from benchmarks.executors.cells import Cell, all_cells
from benchmarks.executors.running import observe, outcome
from benchmarks.executors.verdicts import agrees, verdicts

_BATCH = 200


def main() -> None:
    parser = argparse.ArgumentParser(prog="python -m benchmarks.executors", description=__doc__)
    commands = parser.add_subparsers(dest="command", required=True)
    trying = commands.add_parser("observe", help="run cells under a real rclpy and note in observed.tsv what they do")
    trying.add_argument("--runs", type=int, default=1, help="how often, in turn with one end first")
    repeating = commands.add_parser("again", help="run cells once more, and name those that do something else")
    repeating.add_argument("--record", type=Path, required=True, help="what was run; a second call goes on from it")
    repeating.add_argument("--more", type=int, default=4, help="how often to run one that does something else")
    for command in (trying, repeating):
        command.add_argument("distro", choices=table.DISTROS)
        command.add_argument("--jobs", type=int, default=8, help="how many programs run at a time")
    comparing = commands.add_parser("compare", help="what archlint says of each program against what was observed")
    comparing.add_argument("--cells", action="store_true", help="name every cell that does not agree")
    for command in (trying, repeating, comparing):
        command.add_argument("--only", default="", metavar="REGEX", help="cells whose name matches")
    given = parser.parse_args()
    cells = [cell for cell in all_cells() if re.search(given.only, cell.name)]
    if given.command == "observe":
        try_out(given.distro, cells, given.jobs, given.runs)
    elif given.command == "again":
        hold_against_the_table(given.distro, cells, given.jobs, given.record, given.more)
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


def hold_against_the_table(distro: str, cells: list[Cell], jobs: int, record: Path, more: int) -> None:
    by_name = {cell.name: cell for cell in cells}
    observed = table.read()[distro]
    known = {cell.name: table.outcomes_of(observed[cell]) for cell in cells if cell in observed}

    def run(names: list[str]) -> Iterator[tuple[str, str]]:
        for cell, said in observe(Environment(distro), [by_name[name] for name in names], jobs):
            yield cell.name, outcome(said, cell)

    for line in try_again(known, run, record, more):
        print(line)


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

"""Look for failures for some minutes: ``python -m benchmarks.fuzz --minutes 60``, or ``make fuzz MINUTES=60``.

Each workspace is judged in a process of its own, with a limit to its time and memory.  What fails is made as small as
it gets, written down in ``tests/fuzz/cases`` and printed; equal failures are counted from then on.
"""

from __future__ import annotations

import argparse
import re
import sys
import time
import warnings
from collections import Counter
from functools import partial
from pathlib import Path

from hypothesis import HealthCheck, Phase, given, seed, settings

from benchmarks.fuzz.cases import FOLDER, Case
from benchmarks.fuzz.properties import PROPERTIES, follows_an_edit
from benchmarks.fuzz.runs import Files, Killed, isolated
from benchmarks.fuzz.workspaces import seeds, states_for

SECONDS = 20
"""Processor time of the runs over one workspace; a plain one takes a fifth of a second."""
SHRINKING = 60
"""Seconds in which a failing workspace is made smaller."""
MOST_BYTES = 3_000_000_000
BATCH = 20
"""Workspaces of one property in a row."""

_DETAILS = re.compile(r"'[^']*'|\d+|\"[^\"]*\"")


class Failure(Exception):
    """What broke a property."""


class Search:
    """A search of so many minutes, and what it has come to."""

    def __init__(self, minutes: float, first_seed: int, folder: Path) -> None:
        self.ends = time.monotonic() + 60 * minutes
        self.seed = first_seed
        self.folder = folder
        self.tried: Counter[str] = Counter()
        self.failed: Counter[str] = Counter()
        self.slowest = 0.0

    def run(self) -> None:
        """One property after the other, until the time is over."""
        while time.monotonic() < self.ends:
            for name in PROPERTIES:
                self._batch(name)
            self.seed += 1

    def _batch(self, name: str) -> None:
        failing: list[Case] = []
        patience = [self.ends]

        def tried(states: tuple[Files, ...]) -> None:
            again = next((case for case in failing if case.states == states), None)
            if time.monotonic() > patience[0] and again is None:
                return
            self.tried[name] += 1
            said = self._said(name, states) if again is None else again.said
            kind = f"{name}: {_DETAILS.sub('…', said)[:160]}"
            if not said:
                return
            if kind in self.failed and not failing:
                self.failed[kind] += 1
                return
            patience[0] = patience[0] if failing else time.monotonic() + SHRINKING
            failing.append(Case(name, said, states))
            raise Failure(kind)

        every = (Phase.generate, Phase.shrink)
        quiet = settings(
            max_examples=BATCH, deadline=None, database=None, phases=every, suppress_health_check=list(HealthCheck)
        )
        try:
            seed(self.seed)(quiet(given(states_for(name))(tried)))()
        except Failure as failure:
            self.failed[str(failure)] += 1
            print(f"{failing[-1].save(self.folder)}\n    {failing[-1].said[:600]}", flush=True)

    def _said(self, name: str, states: tuple[Files, ...]) -> str:
        """How the property fails; nothing where it holds."""
        began = time.monotonic()
        try:
            error = isolated(partial(PROPERTIES[name], *states), SECONDS, MOST_BYTES)
        except Killed as killed:
            return str(killed)
        finally:
            self.slowest = max(self.slowest, time.monotonic() - began)
        return "" if error is None else f"{error['kind']}: {error['message']}"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--minutes", type=float, default=60)
    parser.add_argument("--seed", type=int, default=int(time.time()), help="the first seed; that of now without it")
    parser.add_argument("--cases", type=Path, default=FOLDER, help="where failures are written down")
    options = parser.parse_args()
    warnings.simplefilter("ignore")
    print(f"{options.minutes:g} minutes from seed {options.seed}", flush=True)
    for judge in PROPERTIES.values():  # imports all that a run needs, once for all processes
        judge(*[seeds()[0]] * (1 + (judge is follows_an_edit)))
    search = Search(options.minutes, options.seed, options.cases)
    search.run()
    print("| property | workspaces |\n|---|---|")
    for name, number in sorted(search.tried.items()):
        print(f"| {name} | {number} |")
    total, kinds = sum(search.tried.values()), len(search.failed)
    print(f"\n{total} workspaces, the slowest {search.slowest:.1f} s, {kinds} kinds of failures")
    for kind, number in search.failed.most_common():
        print(f"{number} × {kind}")
    sys.exit(1 if search.failed else 0)


if __name__ == "__main__":
    main()

"""Tries programs that were observed before once more, and names those that do something else.

What each run did is appended to a file at once: a call that is ended, on a busy machine or by a limit of time, goes on
where it stopped.
"""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from pathlib import Path

Runs = Callable[[list[str]], Iterable[tuple[str, str]]]
"""Runs the programs of these names, and says what became of each as it comes."""


def try_again(known: Mapping[str, Sequence[str]], run: Runs, record: Path, more: int) -> Iterator[str]:
    """The result, a line each; ``known`` has the outcomes that each program had, and one that has another now is run
    ``more`` times."""
    seen = _read(record)
    left = [name for name in known if name not in seen]
    while left:
        for name, outcome in run(left):
            _add(record, name, outcome)
        seen = _read(record)
        left = [name for name in _different(known, seen) if seen[name].total() <= more]
    other = _different(known, seen)
    tried = [name for name in known if name in seen]
    yield f"{len(tried)} of {len(known)} tried again, {len(tried) - len(other)} did what they did, {len(other)} did not"
    for name in other:
        counts = seen[name]
        words = [f"{outcome} ({count} of {counts.total()})" for outcome, count in sorted(counts.items())]
        yield f"  {name}: {' | '.join(words)}; before: {' | '.join(known[name])}"


def _different(known: Mapping[str, Sequence[str]], seen: Mapping[str, Counter[str]]) -> list[str]:
    return [name for name, outcomes in known.items() if name in seen and not set(seen[name]) <= set(outcomes)]


def _read(record: Path) -> dict[str, Counter[str]]:
    seen: dict[str, Counter[str]] = {}
    if record.exists():
        for line in record.read_text("utf-8").splitlines():
            name, outcome = json.loads(line)
            seen.setdefault(name, Counter())[outcome] += 1
    return seen


def _add(record: Path, name: str, outcome: str) -> None:
    with record.open("a", encoding="utf-8") as file:
        file.write(json.dumps([name, outcome]) + "\n")

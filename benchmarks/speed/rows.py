"""The rows of the table of targets: each makes two kinds of runs in turn and says how they compare."""

from __future__ import annotations

import json
import shutil
import sys
import tempfile
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from functools import partial
from itertools import count
from pathlib import Path

from benchmarks.speed.edits import Topic, append_comment, rename, topics_below
from benchmarks.speed.processes import ARCHLINT, CHECK, Cost, Pair, Step, in_turn, pair, run


@dataclass(frozen=True)
class Tools:
    """What the rows run beside archlint, and how often."""

    rounds: int
    peer: str | None
    flake8: tuple[str, ...]


@dataclass(frozen=True)
class Row:
    """Two kinds of runs that were compared, with the bar and the aim for the ratio."""

    name: str
    pair: Pair
    bar: float
    aim: float


@dataclass(frozen=True)
class _Copy:
    """A copy of a checkout, with a cache of its own beside it."""

    folder: Path
    cache: Path

    @property
    def cold(self) -> Step:
        return partial(run, [*CHECK, "--no-cache"], self.folder)

    @property
    def warm(self) -> Step:
        return partial(run, [*CHECK, "--cache-dir", str(self.cache)], self.folder)

    @property
    def options(self) -> tuple[str, ...]:
        return "--cache-dir", str(self.cache)

    def peer(self, tool: str, *options: str) -> Step:
        return partial(run, [tool, "nodes", "-C", str(self.folder), "--format", "json", *options], self.folder)


@contextmanager
def _copy(checkout: Path) -> Iterator[_Copy]:
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(temporary, "workspace")
        shutil.copytree(checkout, folder, symlinks=True, ignore=shutil.ignore_patterns(".git"))
        yield _Copy(folder, Path(temporary, "cache"))


def one_file_changed(checkout: Path, tools: Tools) -> Iterator[Row]:
    """After a comment, and after another name for a topic, each time in another file: beside a run without a cache, and
    beside the peer with its cache after the same edit."""
    for edit in (append_comment, rename):
        with _copy(checkout) as copy:
            costs = _after_edits(copy, tools, edit)
        what = "comment" if edit is append_comment else "topic renamed"
        yield Row(f"one file changed ({what}) / cold", pair(costs, "edited", "cold"), 0.08, 0.03)
        if "peer" in costs:
            yield Row(f"one file changed ({what}) / peer after it", pair(costs, "edited", "peer"), 1.0, 0.5)


def _after_edits(copy: _Copy, tools: Tools, edit: Callable[[Topic, int], None]) -> dict[str, list[Cost]]:
    topics = topics_below(copy.folder)
    if len(topics) < tools.rounds:
        raise SystemExit(f"{len(topics)} files name a topic: too few for {tools.rounds} rounds")
    numbers = count()

    def edited() -> Cost:
        number = next(numbers)
        edit(topics[number], number)
        return copy.warm()

    steps: dict[str, Step] = {"edited": edited}
    copy.warm()
    if tools.peer is not None:
        steps["peer"] = copy.peer(tools.peer)
        steps["peer"]()
    steps["cold"] = copy.cold
    return in_turn(tools.rounds, steps)


def nothing_changed(checkout: Path, tools: Tools) -> Iterator[Row]:
    """A run that has been made before, beside Python that starts and ends; and ``graph`` beside ``check``."""
    with _copy(checkout) as copy:
        graph: Step = partial(
            run, [*ARCHLINT, "graph", ".", "--format", "json", "--cache-dir", str(copy.cache)], copy.folder
        )
        copy.warm()
        graph()
        python: Step = partial(run, [sys.executable, "-c", "pass"], copy.folder)
        costs = in_turn(tools.rounds, {"warm": copy.warm, "python": python, "graph": graph})
    yield Row("nothing changed / empty Python", pair(costs, "warm", "python"), 4.0, 3.0)
    yield Row("graph warm / check warm", pair(costs, "graph", "warm"), 1.5, 1.1)


def other_commands(checkout: Path, tools: Tools) -> Iterator[Row]:
    """What other commands say again while nothing has changed, beside ``check``."""
    with _copy(checkout) as copy:
        saved, pages = copy.folder.parent / "saved.json", str(copy.folder.parent / "pages")
        copy.warm()
        run([*ARCHLINT, "graph", ".", "--format", "json", "-o", str(saved), *copy.options], copy.folder)
        run([*ARCHLINT, "docs", "-o", pages, *copy.options], copy.folder)
        topics = json.loads(saved.read_text("utf-8"))["topics"]
        shown = max(topics, key=lambda topic: len(topic["publishers"]) + len(topic["subscribers"]))["name"]
        steps = {
            name: partial(run, [*ARCHLINT, *words, *copy.options], copy.folder)
            for name, words in (
                ("trace", ("trace", shown)),
                ("show", ("show", shown)),
                ("impact", ("impact", shown)),
                ("docs --check", ("docs", "--check", "-o", pages)),
                ("diff of a saved graph", ("diff", str(saved), ".")),
            )
        }
        for step in steps.values():
            step()
        costs = in_turn(tools.rounds, {"check": copy.warm, **steps})
    for name in steps:
        yield Row(f"{name} warm / check warm", pair(costs, name, "check"), 1.5, 1.1)


def cold(checkout: Path, tools: Tools) -> Iterator[Row]:
    """A run without a cache, beside flake8 and the peer without theirs, and beside one process."""
    with _copy(checkout) as copy:
        steps: dict[str, Step] = {"cold": copy.cold}
        steps["one"] = partial(run, [*CHECK, "--no-cache", "--jobs", "1"], copy.folder)
        steps["two"] = partial(run, [*CHECK, "--no-cache", "--jobs", "2"], copy.folder)
        if tools.flake8:
            steps["flake8"] = partial(run, [*tools.flake8, "--isolated", "-j1", "."], copy.folder)
        if tools.peer is not None:
            steps["peer"] = copy.peer(tools.peer, "--no-cache")
        costs = in_turn(tools.rounds, steps)
    yield Row("two processes / one, cold", pair(costs, "two", "one"), 0.65, 0.55)
    if "flake8" in costs:
        yield Row("cold / flake8 -j1", pair(costs, "cold", "flake8"), 0.8, 0.4)
    if "peer" in costs:
        yield Row("cold / peer", pair(costs, "cold", "peer"), 2.0, 1.0)


ROWS: dict[str, Callable[[Path, Tools], Iterator[Row]]] = {
    "edit": one_file_changed,
    "unchanged": nothing_changed,
    "cold": cold,
    "others": other_commands,
}
"""The commands that compare runs over a checkout."""

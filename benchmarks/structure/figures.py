"""The figures of the table: what each was before the inside was rebuilt, what it is now, and its bar."""

from __future__ import annotations

import statistics
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from benchmarks.structure import imports
from benchmarks.structure.source import File, complexities, files_of, timed_asserts

ROOT = Path(__file__).parents[2]
SOURCE = ROOT / "src" / imports.PACKAGE
TESTS = ROOT / "tests"
_TESTED = "interpreter"
"""The folder whose tests are measured."""


@dataclass(frozen=True)
class Figure:
    """One number; ``bar`` is the most that it should be, or the least."""

    name: str
    before: float
    now: float
    bar: float
    at_least: bool = False
    unit: str = ""
    where: str = ""
    """What the number belongs to."""

    @property
    def holds(self) -> bool:
        return self.now >= self.bar if self.at_least else self.now <= self.bar

    def row(self) -> str:
        """Its row of the table."""
        before, now, bar = (f"{number:.3g}{self.unit}" for number in (self.before, self.now, self.bar))
        where = f" ({self.where})" if self.where else ""
        sign = "≥" if self.at_least else "≤"
        return f"| {self.name} | {before} | {now}{where} | {sign} {bar} | {'yes' if self.holds else 'no'} |"


HEADER = "| | before | now | bar | holds |\n|---|---|---|---|---|"


def all_figures() -> Iterator[Figure]:
    """Every figure of the table, in its order."""
    circle = imports.largest_circle(imports.module_graph())
    yield Figure("modules in the largest circle of imports", 38, len(circle), 0)
    yield from of_source(files_of(SOURCE))
    yield from of_complexity(complexities(SOURCE))
    yield from of_tests()


def of_source(files: Sequence[File]) -> Iterator[Figure]:
    """What is counted in the files of the source."""
    total = sum(file.lines for file in files)
    by_folder: Counter[str] = Counter()
    for file in files:
        by_folder[file.folder] += file.lines
    [(folder, lines)] = by_folder.most_common(1)
    yield Figure("largest folder, of all lines", 40, 100 * lines / total, 18, unit=" %", where=f"`{folder}/`")
    late = sum(len(file.late_imports) for file in files)
    yield Figure("imports of own modules inside functions, per 1,000 lines", 6.4, 1000 * late / total, 1.5)
    checks = sum(file.instance_checks for file in files)
    yield Figure("`isinstance`, per 1,000 lines", 38.6, 1000 * checks / total, 15)
    longest = max(files, key=lambda file: file.lines)
    yield Figure("lines of a file, median", 137, statistics.median(file.lines for file in files), 90)
    yield Figure("lines of a file, most", 597, longest.lines, 400, where=_shown(longest.path))
    lengths = sorted((length, file.path, name) for file in files for name, _, length in file.functions)
    yield Figure("lines of a function, median", 7, statistics.median(length for length, *_ in lengths), 7)
    yield Figure("lines of a function, 9 of 10", 19, _nine_of_ten([length for length, *_ in lengths]), 19)
    length, path, name = lengths[-1]
    yield Figure("lines of a function, most", 55, length, 55, where=f"{_shown(path)} `{name}`")


def of_complexity(counts: Sequence[int]) -> Iterator[Figure]:
    yield Figure("cyclomatic complexity, 9 of 10", 11, _nine_of_ten(counts), 8)
    yield Figure("cyclomatic complexity, most", 45, counts[-1], 20)


def of_tests() -> Iterator[Figure]:
    lines, tested = (sum(file.lines for file in files_of(folder / _TESTED)) for folder in (TESTS, SOURCE))
    yield Figure(f"lines of tests for a line of `{_TESTED}/`", 0.12, lines / tested, 0.6, at_least=True)
    yield Figure("tests that assert a time", 4, len(timed_asserts(TESTS)), 0)


def _nine_of_ten(counts: Sequence[int]) -> int:
    """What nine of ten numbers, smallest first, do not exceed."""
    return counts[int(0.9 * len(counts))]


def _shown(path: Path) -> str:
    return f"`{path.relative_to(SOURCE).as_posix()}`"

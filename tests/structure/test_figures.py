"""The bars that the source keeps.  Medians are for reading: a test of those would fail for whoever comes last."""

from __future__ import annotations

from pathlib import Path

import pytest
from benchmarks.structure.figures import ROOT, SOURCE, Figure, of_complexity, of_source, of_tests
from benchmarks.structure.source import File, files_of


def file(name: str, lines: int, *functions: tuple[str, int, int]) -> File:
    path = SOURCE / name
    return File(path, name.partition("/")[0], lines, 1, (3,), functions)


FEW = [file("arm/joints.py", 100, ("move", 1, 40)), file("leg/knee.py", 300, ("bend", 1, 10), ("kick", 12, 20))]


def test_the_figures_of_two_files():
    rows = {figure.name: (figure.now, figure.where) for figure in of_source(FEW)}
    assert rows["largest folder, of all lines"] == (75, "`leg/`")
    assert rows["`isinstance`, per 1,000 lines"] == (5, "")
    assert rows["imports of own modules inside functions, per 1,000 lines"] == (5, "")
    assert rows["lines of a file, median"] == (200, "")
    assert rows["lines of a file, most"] == (300, "`leg/knee.py`")
    assert rows["lines of a function, most"] == (40, "`arm/joints.py` `move`")


def test_complexity_of_nine_in_ten():
    assert [figure.now for figure in of_complexity([*[1] * 90, *[9] * 9, 17])] == [9, 17]


@pytest.mark.parametrize(("at_least", "holds"), [(False, [True, True, False]), (True, [False, True, True])])
def test_a_bar_is_the_most_or_the_least(at_least: bool, holds: list[bool]):
    assert [Figure("", 0, now, 5, at_least).holds for now in (4, 5, 6)] == holds


def test_a_row_of_the_table():
    row = Figure("lines of a file, most", 597, 398, 400, where="`arm.py`").row()
    assert row == "| lines of a file, most | 597 | 398 (`arm.py`) | ≤ 400 | yes |"
    assert Figure("largest", 40, 19.46, 18, unit=" %").row() == "| largest | 40 % | 19.5 % | ≤ 18 % | no |"


@pytest.fixture(scope="module")
def figures() -> list[Figure]:
    return [*of_source(files_of(SOURCE)), *of_tests()]


def test_the_source_keeps_its_bars(figures: list[Figure]):
    broken = [figure.row() for figure in figures if not figure.holds and "median" not in figure.name]
    assert broken == [], "python -m benchmarks.structure prints all figures"


def test_the_table_is_in_the_readme(figures: list[Figure]):
    text = Path(ROOT, "benchmarks", "figures", "structure.md").read_text(encoding="utf-8")
    for figure in figures:
        assert f"| {figure.name} | " in text

"""Lines of a text in a later one."""

from __future__ import annotations

import pytest

from archlint.lookup.moved import Moves
from archlint.lookup.texts import Texts
from archlint.place import Place

BEFORE = "one\ntwo\nthree\nfour"


def moves(now: str) -> Moves:
    return Moves(Texts({"it.py": BEFORE}.get), Texts({"it.py": now}.get))


@pytest.mark.parametrize(
    ("now", "lines"),
    [
        (BEFORE, [1, 2, 3, 4]),
        ("one\ntwo\nnew\nnew\nthree\nfour", [1, 2, 5, 6]),
        ("one\nfour", [1, None, None, 2]),
        ("one\ntwo!\nthree\nfour", [1, None, 3, 4]),
        ("", [None, None, None, None]),
    ],
)
def test_both_ways(now: str, lines: list[int | None]):
    it = moves(now)
    places = [it.place_now(Place("it.py", line, 1, line, 2)) for line in (1, 2, 3, 4)]
    assert [None if place is None else place.line for place in places] == lines
    for before, after in enumerate(lines, start=1):
        assert after is None or it.line_before("it.py", after) == before


def test_new_lines_were_nowhere():
    assert [moves("one\ntwo\nnew\nthree\nfour").line_before("it.py", line) for line in (2, 3, 4)] == [2, None, 3]

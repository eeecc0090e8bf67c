"""Where places are after an edit, and which bytes an editor would save."""

from __future__ import annotations

import pytest

from archlint.live.buffers import Shifts, as_saved
from archlint.place import Place

BEFORE = "one\ntwo\nthree\nfour\n"


def place(line: int) -> Place:
    return Place("a.py", line, 2, line, 4)


def test_what_stands_above_an_edit_stays_and_what_stands_below_moves() -> None:
    shifts = Shifts(BEFORE, "one\ntwo\nnew\nnewer\nthree\nfour\n")

    assert [shifts.of(place(line)) for line in (1, 2, 3, 4)] == [place(1), place(2), place(5), place(6)]


def test_what_was_edited_is_nowhere() -> None:
    shifts = Shifts(BEFORE, "one\n2\nthree\nfour\n")

    assert shifts.of(place(2)) is None
    assert shifts.of(Place("a.py", 1, 1, 2, 1)) is None
    assert shifts.of(place(3)) == place(3)


def test_lines_that_repeat_are_not_counted_twice() -> None:
    shifts = Shifts("x\nx\n", "x\nx\nx\n")

    assert shifts.of(Place("a.py", 2, 1, 2, 2)) == Place("a.py", 2, 1, 2, 2)


@pytest.mark.parametrize(
    ("text", "data"),
    [
        ("name = 'ä'\n", b"name = '\xc3\xa4'\n"),
        ("# -*- coding: latin-1 -*-\nname = 'ä'\n", b"# -*- coding: latin-1 -*-\nname = '\xe4'\n"),
        (
            '<?xml version="1.0" encoding="iso-8859-1"?><a>ä</a>',
            b'<?xml version="1.0" encoding="iso-8859-1"?><a>\xe4</a>',
        ),
        ("# coding: nonsense\nä", b"# coding: nonsense\n\xc3\xa4"),
    ],
)
def test_a_text_is_saved_in_the_encoding_that_it_names(text: str, data: bytes) -> None:
    assert as_saved(text) == data

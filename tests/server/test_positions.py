"""Columns count characters; positions count what the client counts."""

from __future__ import annotations

import pytest
from lsprotocol.types import Position, PositionEncodingKind, Range
from pygls.workspace import PositionCodec

from archlint.place import Place
from archlint.server.positions import Positions

TEXT = "name = 'x'\r\nword = 'ä€🤖'  # here\rlast\n"
HERE = TEXT.split("\r\n")[1].index("#") + 1


@pytest.mark.parametrize(
    ("encoding", "column"),
    [
        (PositionEncodingKind.Utf32, HERE - 1),
        (PositionEncodingKind.Utf16, HERE - 1 + 1),
        (PositionEncodingKind.Utf8, HERE - 1 + 1 + 2 + 3),
    ],
)
def test_a_line_with_characters_of_several_units(encoding: PositionEncodingKind, column: int) -> None:
    positions = Positions(TEXT, PositionCodec(encoding).client_num_units)

    assert positions.position(2, HERE) == Position(1, column)
    assert positions.column(Position(1, column)) == (2, HERE)


def test_lines_end_as_the_protocol_says() -> None:
    positions = Positions("a\x0cb\u2028c\rd\r\ne", len)

    assert positions.position(1, 5) == Position(0, 4)
    assert positions.position(3, 1) == Position(2, 0)
    assert positions.end == Position(2, 1)


def test_a_place_that_the_text_does_not_reach_is_its_end() -> None:
    positions = Positions("a\nbc", len)

    assert positions.range(Place("f", 2, 9, 7, 1)) == Range(Position(1, 2), Position(1, 2))

"""Columns stand below each other in a terminal, whatever the script of their texts."""

from __future__ import annotations

import pytest

from archlint import cells


@pytest.mark.parametrize(("text", "width"), [
    ("", 0),
    ("abc", 3),
    ("é", 1),
    ("e\u0301", 1),  # a letter and the accent that combines with it
    ("机器人", 6),
    ("ｘ", 2),  # a full-width letter
])  # fmt: skip
def test_the_width_of_a_text(text: str, width: int):
    assert cells.width(text) == width


def test_columns_are_as_wide_as_their_widest_text():
    assert list(cells.columns([["a", "机器人", "x"], ["long", "b", ""]])) == ["a     机器人  x", "long  b"]


def test_a_column_is_no_wider_than_it_may_be():
    rows = [["a", "x"], ["four", "y"], ["sevenxx", "z"]]
    assert list(cells.columns(rows, 4)) == ["a     x", "four  y", "sevenxx  z"]
    assert list(cells.columns([["sevenxx", "z"]], 4)) == ["sevenxx  z"]


def test_colours_take_no_cells():
    painted = [["\x1b[1ma\x1b[0m", "x"], ["four", "y"]]
    assert list(cells.columns([["a", "x"], ["four", "y"]], painted=painted)) == ["\x1b[1ma\x1b[0m     x", "four  y"]


def test_a_text_that_is_too_wide_is_left_as_it_is():
    assert cells.padded("机器人", 4) == "机器人"
    assert cells.padded("机器人", 8) == "机器人  "

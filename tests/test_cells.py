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


@pytest.mark.parametrize(("text", "cells_", "lines"), [
    ("", 5, [""]),
    ("one two three", 80, ["one two three"]),
    ("one two three", 7, ["one two", "three"]),
    ("one two three", 6, ["one", "two", "three"]),
    ("a /very/long/name b", 5, ["a", "/very/long/name", "b"]),
    ("机器人节点的话题", 6, ["机器人", "节点的", "话题"]),
    ("话题 /odom 的类型", 9, ["话题", "/odom 的", "类型"]),
    ("机器人。好", 6, ["机器", "人。好"]),  # no line begins with a full stop
    ("机器（人）", 6, ["机器", "（人）"]),  # nor ends in an opening bracket
    ("🤖🤖🤖🤖", 4, ["🤖🤖", "🤖🤖"]),
    ("cafe\u0301s cafe\u0301s", 5, ["cafe\u0301s", "cafe\u0301s"]),
])  # fmt: skip
def test_lines_end_between_words_and_between_wide_characters(text: str, cells_: int, lines: list[str]):
    assert cells.wrapped(text, cells_) == lines


def test_the_first_line_may_have_less_room():
    assert cells.wrapped("one two three", 9, 3) == ["one", "two three"]
    assert cells.wrapped("three two", 9, 3) == ["", "three two"]


def test_no_character_is_lost():
    text = "the topic '/机器人/odom' is  published 🤖 twice"
    for room in range(1, 60):
        assert "".join(cells.wrapped(text, room)).replace(" ", "") == text.replace(" ", "")

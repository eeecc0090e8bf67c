"""Strings of the user's, made safe to show."""

from __future__ import annotations

import unicodedata

import pytest
from hypothesis import given
from hypothesis import strategies as st

from archlint.visible import visible, visible_code, visible_text

NASTY = st.text(
    st.one_of(
        st.characters(categories=("Cc", "Cf", "Cs", "Zl", "Zp")),
        st.sampled_from("\ufffe\uffff\U000e0041"),
        st.characters(),
    )
)


@pytest.mark.parametrize(
    "text", ["/robot/cmd_vel", "Größe 5 µm", "ロボット", "🤖", "[bold]markup is no danger[/bold]", ""]
)
def test_ordinary_text_stays_as_it_is(text):
    assert visible(text) == text


@pytest.mark.parametrize(
    ("text", "shown"),
    [
        ("\x1b[31mred", "␛[31mred"),
        ("bell\a", "bell␇"),
        ("one\ntwo\r", "one␊two␍"),
        ("a\tb", "a␉b"),
        ("rubbed\x7fout", "rubbed␡out"),
        ("\x9b31m", "\\x9b31m"),
        ("is_admin\u202e#", "is_admin\\u202e#"),
        ("\u2066x\u2069", "\\u2066x\\u2069"),
        ("caf\udce9.py", "caf\\xe9.py"),
        ("lone \ud800", "lone \\ud800"),
        ("line\u2028end", "line\\u2028end"),
        ("\U000e0041", "\\U000e0041"),
    ],
)
def test_what_would_act_or_hide_is_shown_as_a_sign(text, shown):
    assert visible(text) == shown


@given(NASTY)
def test_nothing_is_left_that_a_terminal_obeys_or_xml_refuses(text):
    shown = visible(text)
    assert len(shown.splitlines()) <= 1
    shown.encode("utf-8")
    assert not [c for c in shown if unicodedata.category(c) in ("Cc", "Cs", "Zl", "Zp")]
    assert not set(shown) & set("\u202a\u202b\u202c\u202d\u202e\u2066\u2067\u2068\u2069\ufffe\uffff")


@given(NASTY)
def test_shown_text_is_shown_as_itself(text):
    assert visible(visible(text)) == visible(text)


def test_tabs_of_a_source_line_run_to_the_next_stop():
    assert visible_code("\tif x:\t# y")[0] == "    if x:   # y"


def test_columns_move_with_what_they_point_at():
    shown, (begin, end, escape, byte) = visible_code("\tname\x1b = '\udce9'\n", 2, 6, 6, 11)
    assert shown[begin - 1 : end - 1] == "name"
    assert shown[escape - 1] == "␛"
    assert shown[byte - 1 :].startswith("\\xe9")


def test_a_column_behind_the_end_stays_behind_it():
    assert visible_code("\tx", 3, 4) == ("    x", (6, 7))


@given(st.text())
def test_columns_keep_their_order(line):
    columns = range(1, len(line.rstrip("\r\n")) + 2)
    shown, moved = visible_code(line, *columns)
    assert list(moved) == sorted(moved)
    assert (moved[0], moved[-1]) == (1, len(shown) + 1)


def test_a_text_keeps_its_lines_and_tabs():
    assert visible_text("a\tb\r\n\x1b[2Jc\rd\n\u202ee\n") == "a\tb\r\n\u241b[2Jc\u240dd\n\\u202ee\n"

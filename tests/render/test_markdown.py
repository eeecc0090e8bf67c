"""Texts of the user's in Markdown: they are shown as they are."""

from __future__ import annotations

import pytest

from archlint.render.markdown import code, link, paragraphs, table, text
from archlint.visible import visible
from render.hostile import NAMES
from render.reading_markdown import READER, html_in, links_in, shown, tables

NASTY = [
    *NAMES,
    "a|b",
    "a\\|b",
    "`|`",
    "``two``",
    " space ",
    "# no heading",
    "__init__ and a_name",
    "![picture](http://x)",
    "@everybody see #12",
    "1. no list",
    "- no list",
    "+ no list",
    "~~gone~~ $x$ *stars*",
    "<!-- comment -->",
    "| --- |",
    "=====",
]


def line(source: str) -> str:
    """What a paragraph shows."""
    opening, inline, closing = READER.parse(source)
    assert (opening.type, closing.type) == ("paragraph_open", "paragraph_close")
    return shown(inline)


@pytest.mark.parametrize("words", NASTY)
def test_a_text_in_a_sentence(words):
    source = f"it is {text(words)}."
    assert line(source) == f"it is {visible(words)}."
    assert html_in(source) == links_in(source) == []


@pytest.mark.parametrize("words", NASTY)
def test_a_name_in_the_type_of_code(words):
    source = f"it is {code(words)}."
    assert line(source) == f"it is {visible(words)}."
    assert html_in(source) == []


@pytest.mark.parametrize("words", NASTY)
def test_a_cell_of_a_table(words):
    rows = [(text(words), "next"), (code(words), "next")]
    [shown_table] = tables("\n".join(table(("What", "More"), rows)))
    assert shown_table[1:] == [[visible(words).strip(), "next"], [visible(words), "next"]]


@pytest.mark.parametrize("words", NASTY)
def test_a_docstring_of_one_line(words):
    source = "\n\n".join(paragraphs(f"A class.\n\n{words}\n\nThe end."))
    assert html_in(source) == links_in(source) == []
    shown_lines = [token.content or shown(token) for token in READER.parse(source) if token.type in ("fence", "inline")]
    assert len(shown_lines) == 3
    assert shown_lines[0] == "A class."
    assert shown_lines[-1] == "The end."


def test_a_docstring_keeps_what_is_laid_out():
    docstring = (
        "Drives.\n\nIt goes on\nand on, in lines that are as long as lines are when they are full,\nto an end.\n\n"
    )
    docstring += "Args:\n    speed: [m/s]\n\n- one\n- two\n\nThe end."
    assert [*paragraphs(docstring)] == [
        "Drives.",
        "It goes on and on, in lines that are as long as lines are when they are full, to an end.",
        "```text\nArgs:\n    speed: [m/s]\n\n- one\n- two\n```",
        "The end.",
    ]


def test_a_short_line_before_a_new_sentence_ends():
    assert line(next(paragraphs("Default port = 1\nDefault topic = x"))) == "Default port = 1\nDefault topic = x"


def test_code_of_a_docstring_cannot_end_its_block():
    source = "\n\n".join(paragraphs("- ```\n<b>no HTML</b>\n````"))
    [block] = READER.parse(source)
    assert block.content == "- ```\n<b>no HTML</b>\n````\n"


def test_an_empty_docstring_is_nothing():
    assert [*paragraphs("\n \n")] == []


def test_a_column_without_a_word_is_left_out():
    assert [*table(("A", "B", "C"), [("1", "", "3"), ("4", "", "")])] == [
        "| A | C |",
        "| --- | --- |",
        "| 1 | 3 |",
        "| 4 |  |",
    ]
    assert [*table(("A",), [])] == []


@pytest.mark.parametrize("path", ["../a b.py", "a(1).py", "größe.py", "a#b.py", "a?b.py", "<b>.py", "\udce9.py"])
def test_a_link_to_any_file(path):
    source = link("here", path, 7)
    [target] = links_in(source)
    assert target.endswith(".py#L7")
    assert target.count("#") == 1
    assert html_in(source) == []

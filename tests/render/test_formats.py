from __future__ import annotations

import pytest

from archlint.render import FORMATS, by_suffix
from archlint.render import render as shown_as
from render.lesson import lesson


@pytest.mark.parametrize("name", FORMATS)
def test_each_format_shows_the_lesson(name: str) -> None:
    shown = shown_as(name, lesson())
    assert isinstance(shown, bytes if FORMATS[name].binary else str)
    assert len(shown) > 100
    if not FORMATS[name].binary:
        assert "/sensor_data" in shown


def test_colour_is_for_text() -> None:
    assert shown_as("text", lesson(), color=True) != shown_as("text", lesson())
    assert shown_as("json", lesson(), color=True) == shown_as("json", lesson())


@pytest.mark.parametrize(
    ("path", "format_"),
    [
        ("graph.svg", "svg"),
        ("a.b/graph.PNG", "png"),
        ("graph.json", "json"),
        ("graph.gv", "dot"),
        ("graph.mmd", "mermaid"),
        ("graph.txt", "text"),
        ("graph.docx", None),
        ("graph", None),
        (".svg/graph", None),
    ],
)
def test_the_suffix_chooses(path: str, format_: str | None) -> None:
    assert by_suffix(path) == format_

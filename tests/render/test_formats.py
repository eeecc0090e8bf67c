from __future__ import annotations

import pytest

from archlint.render import BINARY, FORMATS, by_suffix
from render.lesson import lesson


@pytest.mark.parametrize("name", FORMATS)
def test_each_format_shows_the_lesson(name: str) -> None:
    shown = FORMATS[name](False)(lesson())
    assert isinstance(shown, bytes if name in BINARY else str)
    assert len(shown) > 100
    if name not in BINARY:
        assert "/sensor_data" in shown


def test_colour_is_for_text() -> None:
    assert FORMATS["text"](True)(lesson()) != FORMATS["text"](False)(lesson())
    assert FORMATS["json"](True)(lesson()) == FORMATS["json"](False)(lesson())


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

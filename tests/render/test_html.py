from __future__ import annotations

import base64
import hashlib
import json
import re
from html import unescape
from html.parser import HTMLParser

from archlint.render.html import embedded, render
from render.hostile import hostile
from render.lesson import lesson


class Page(HTMLParser):
    """What a browser would see: elements with their attributes, and the text of scripts and styles."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.elements: list[tuple[str, dict[str, str | None]]] = []
        self.raw: list[tuple[str, dict[str, str | None], str]] = []
        self.feed(text)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.elements.append((tag, dict(attrs)))

    def handle_data(self, data: str) -> None:
        if self.elements and self.elements[-1][0] in ("script", "style"):
            self.raw.append((*self.elements[-1], data))

    def script(self, type_: str | None) -> str:
        [found] = [
            text for tag, attrs, text in self.raw if tag == "script" and attrs.get("type") == type_ and text.strip()
        ]
        return found


def test_the_drawing_and_its_data_speak_of_the_same_vertices() -> None:
    text = render(lesson())
    data = json.loads(Page(text).script("application/json"))
    drawn = set(re.findall(r"<title>((?:node|topic|service)_\w+)</title>", text))
    assert drawn == set(data["vertices"])
    assert data["vertices"]["node_sensor_node"]["name"] == "/sensor_node"
    lines = {unescape(title) for title in re.findall(r"<title>(\w+&#45;&gt;\w+)</title>", text)}
    assert lines == {f"{line['tail']}->{line['head']}" for line in data["lines"]}


def test_the_policy_admits_the_pages_own_script_and_style_and_no_other() -> None:
    page = Page(render(lesson()))
    [policy] = [attrs["content"] for tag, attrs in page.elements if attrs.get("http-equiv")]
    style = next(text for tag, _, text in page.raw if tag == "style")
    for text in (page.script(None), style):
        digest = base64.b64encode(hashlib.sha256(text.encode()).digest()).decode()
        assert f"'sha256-{digest}'" in (policy or "")
    assert (policy or "").startswith("default-src 'none';")
    assert "unsafe" not in (policy or "")


def test_nothing_comes_from_elsewhere() -> None:
    for _, attributes in Page(render(hostile())).elements:
        assert not {"src", "href", "xlink:href", "style"} & set(attributes)
        assert not any(name.startswith("on") for name in attributes)


def test_no_name_becomes_an_element() -> None:
    plain, odd = Page(render(lesson())), Page(render(hostile()))
    assert {tag for tag, _ in odd.elements} <= {tag for tag, _ in plain.elements}
    assert len([tag for tag, _ in odd.elements if tag == "script"]) == 2
    names = [vertex["name"] for vertex in json.loads(odd.script("application/json"))["vertices"].values()]
    assert any(name.endswith("<script>alert(1)</script>") for name in names)


def test_data_cannot_end_their_block() -> None:
    assert embedded({"a": "</script>&"}) == '{"a":"\\u003c/script\\u003e\\u0026"}'

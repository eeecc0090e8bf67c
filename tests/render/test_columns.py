"""The two columns that the HTML page shows where there is no Graphviz."""

from __future__ import annotations

import json
import re
import xml.etree.ElementTree as ElementTree
from itertools import pairwise
from pathlib import Path

import pytest

from archlint.cli import main
from archlint.render import drawing, html
from archlint.render.columns import svg
from archlint.systems.model import System
from render.hostile import hostile
from render.lesson import lesson
from render.pictures import diagram
from systems.builders import node, publisher, subscriber, system

SVG = "{http://www.w3.org/2000/svg}"
FIXTURES = Path(__file__).parents[2] / "fixtures"


@pytest.fixture
def no_graphviz(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setenv("PATH", str(tmp_path))
    monkeypatch.setattr(drawing, "find_spec", lambda name: None)


def drawn(of: System) -> ElementTree.Element:
    return ElementTree.fromstring(svg(diagram(of)))


def groups(tree: ElementTree.Element, kind: str) -> dict[str, ElementTree.Element]:
    return {group[0].text or "": group for group in tree.iter(f"{SVG}g") if group.get("class") == kind}


def labels(tree: ElementTree.Element) -> dict[str, list[str]]:
    return {name: [text.text or "" for text in g.iter(f"{SVG}text")] for name, g in groups(tree, "node").items()}


def test_a_page_without_graphviz_has_its_drawing_all_the_same(no_graphviz: None):
    page = html.render(lesson())
    data = json.loads(re.findall(r'id="data">(.*?)</script>', page)[0])
    tree = ElementTree.fromstring(re.findall(r"<svg.*?</svg>", page, re.DOTALL)[0])
    assert set(groups(tree, "node")) == set(data["vertices"])
    assert set(groups(tree, "edge")) == {f"{line['tail']}->{line['head']}" for line in data["lines"]}
    assert "in columns, for want of Graphviz" in page
    assert all(labels(tree)[name][0] == vertex["name"] for name, vertex in data["vertices"].items())


def test_nodes_stand_left_and_lines_point_where_messages_go():
    tree = drawn(system(node("/talker", publisher("/chatter")), node("/listener", subscriber("/chatter"))))
    left = {labels(tree)[name][0]: float(g[1].get("x", "")) for name, g in groups(tree, "node").items()}
    assert left["/talker"] == left["/listener"] < left["/chatter"]
    names = {name: label[0] for name, label in labels(tree).items()}
    tips = {}
    for title, group in groups(tree, "edge").items():
        tail, head = title.split("->")
        tips[names[tail], names[head]] = float(group.findall(f"{SVG}polygon")[0].get("points", "").split(",")[0])
    assert tips["/talker", "/chatter"] == left["/chatter"]
    assert tips["/chatter", "/listener"] < left["/chatter"]


def test_boxes_do_not_overlap():
    tree = drawn(lesson())
    boxes = [group[1] for group in groups(tree, "node").values()]
    rows: dict[str, list[tuple[float, float]]] = {}
    for box in boxes:
        top = float(box.get("y", ""))
        rows.setdefault(box.get("x", ""), []).append((top, top + float(box.get("height", ""))))
    assert len(rows) == 2
    for column in rows.values():
        column.sort()
        assert all(above[1] < below[0] for above, below in pairwise(column))


def test_no_name_becomes_markup():
    tree = drawn(hostile())
    assert {element.tag for element in tree.iter()} <= {
        f"{SVG}{tag}" for tag in ("svg", "g", "title", "rect", "text", "path", "polygon")
    }
    assert any(label[0].endswith("<script>alert(1)</script>") for label in labels(tree).values())


def test_nothing_to_draw():
    assert labels(drawn(system())) == {}


@pytest.mark.parametrize(("file", "status"), [("g.svg", 2), ("g.html", 0), ("g.mmd", 0), ("g.dot", 0), ("g.json", 0)])
def test_which_formats_need_graphviz(
    no_graphviz: None, file: str, status: int, tmp_path: Path, capsys: pytest.CaptureFixture[str]
):
    words = ["graph", "--no-cache", "--isolated", str(FIXTURES / "lesson"), "-o", str(tmp_path / file)]
    assert main(words) == status
    assert ("install 'archlint[pictures]'" in capsys.readouterr().err) is (status == 2)
    assert (tmp_path / file).exists() is (status == 0)

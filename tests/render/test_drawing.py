"""Pictures, drawn for real: by the Graphviz in pygraphviz' wheel, on a PATH that has no ``dot``."""

from __future__ import annotations

import re
import stat
import subprocess
import sys
import xml.etree.ElementTree as ElementTree
from dataclasses import replace
from pathlib import Path

import pytest

from archlint.render import drawing
from archlint.render.diagram import making
from archlint.render.drawing import CannotDraw
from archlint.render.view import View
from render.hostile import hostile
from render.lesson import lesson
from render.pictures import diagram
from render.pictures import svg as drawn_as_svg
from systems.builders import client, node, publisher, service, subscriber, system

CAPTION = 1
"""What is said below a picture is a shape in it."""
SVG = "{http://www.w3.org/2000/svg}"


@pytest.fixture(autouse=True)
def no_dot(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Path:
    """A PATH of one empty folder."""
    folder = tmp_path / "bin"
    folder.mkdir()
    monkeypatch.setenv("PATH", str(folder))
    return folder


def texts(svg: str) -> list[str]:
    return [element.text or "" for element in ElementTree.fromstring(svg).iter(f"{SVG}text")]


def count(svg: str, class_: str) -> int:
    return len([g for g in ElementTree.fromstring(svg).iter(f"{SVG}g") if g.get("class") == class_])


def test_svg() -> None:
    drawn = drawn_as_svg(lesson())
    assert {"/sensor_node", "/control_node", "/motor_node", "/sensor_data", "/set_motor"} < set(texts(drawn))
    assert (count(drawn, "node"), count(drawn, "edge")) == (6 + CAPTION, 6)


def test_png_and_pdf() -> None:
    assert drawing.png(diagram(lesson())).startswith(b"\x89PNG\r\n\x1a\n")
    assert drawing.pdf(diagram(lesson())).startswith(b"%PDF-")


def test_the_same_system_is_the_same_picture() -> None:
    assert drawn_as_svg(lesson()) == drawn_as_svg(lesson())


def test_svg_does_not_name_its_maker() -> None:
    drawn = drawn_as_svg(lesson())
    assert "<!--" not in drawn
    assert "<!DOCTYPE" not in drawn


def test_no_name_becomes_markup() -> None:
    drawn = drawn_as_svg(hostile())
    tree = ElementTree.fromstring(drawn)
    tags = {element.tag for element in tree.iter()}
    assert tags <= {f"{SVG}{name}" for name in ("svg", "g", "a", "title", "text", "path", "polygon", "ellipse")}
    assert not any("href" in key or key.startswith("on") for element in tree.iter() for key in element.attrib)
    shown = texts(drawn)
    assert any(text.endswith("<script>alert(1)</script>") for text in shown)
    assert any(text.endswith("a\\N\\G\\l") for text in shown)
    assert any("&lt;tag&gt; &#65; &quot;" in text for text in shown)


def test_two_hundred_nodes() -> None:
    nodes = [
        node(
            f"/node_{number}",
            publisher(f"/topic_{number}"),
            subscriber(f"/topic_{(number * 7 + 3) % 200}"),
            service(f"/service_{number}") if number % 4 == 0 else client(f"/service_{number // 4 * 4}"),
            package=f"package_{number // 10}",
        )
        for number in range(200)
    ]
    drawn = drawing.svg(diagram(system(*nodes), View(expand=("*",), every_line=True)))
    assert count(drawn, "node") == 200 + 200 + 50


def test_a_graph_that_is_too_large_is_drawn_by_package(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(making, "EACH_NODE", 3)
    made = system(
        node("/a", publisher("/x"), publisher("/y"), package="p"),
        node("/b", publisher("/z"), package="p"),
        node("/c", subscriber("/x"), subscriber("/y"), service("/s"), package="q"),
    )
    shown = texts(drawn_as_svg(made))
    assert [text for text in shown if "too many to draw each" in text]
    assert {"p", "2 nodes, 1 topic", "q", "1 node, 1 service", "2 topics"} <= set(shown)
    assert "/a" not in shown


def test_a_system_dot_comes_first(no_dot: Path) -> None:
    dot = no_dot / "dot"
    told = no_dot / "told"
    dot.write_text(
        f"#!{sys.executable}\nimport sys\nprint(sys.argv[1:], len(sys.stdin.read()) > 100, file=open('{told}', 'a'))\n"
        "print('{}' if '-Tjson0' in sys.argv else 'drawn')\n"
    )
    dot.chmod(dot.stat().st_mode | stat.S_IXUSR)
    assert drawing.draw(diagram(lesson()), "svg") == b"drawn\n"
    assert told.read_text().splitlines() == ["['-Kdot', '-Tjson0'] True", "['-Knop2', '-Tsvg'] True"]


def test_a_dot_that_fails(no_dot: Path) -> None:
    dot = no_dot / "dot"
    dot.write_text(f"#!{sys.executable}\nimport sys\nsys.exit('Format: \"png\" not recognized')\n")
    dot.chmod(dot.stat().st_mode | stat.S_IXUSR)
    with pytest.raises(CannotDraw, match='Graphviz failed: Format: "png" not recognized'):
        drawing.png(diagram(lesson()))


def test_a_layout_that_does_not_end(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(drawing, "TIME_LIMIT", 0.001)
    with pytest.raises(CannotDraw, match="took more than"):
        drawn_as_svg(lesson())


def test_words_on_lines_that_graphviz_cannot_place(monkeypatch: pytest.MonkeyPatch) -> None:
    tried: list[str] = []

    def layout(source: str, format: str) -> bytes:
        tried.append(source)
        if len(tried) == 1:
            raise CannotDraw("Graphviz failed: fixLabelOrder")
        return b"drawn"

    monkeypatch.setattr(drawing, "layout", layout)
    made = system(node("/a", publisher("/x")), node("/b", subscriber("/x")))
    assert drawing.draw(diagram(made, View(style="nodes")), "png") == b"drawn"
    assert [source.count("xlabel=") for source in tried] == [0, 1]


def test_no_graphviz_at_all(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(drawing, "find_spec", lambda name: None)
    with pytest.raises(CannotDraw, match=r"install 'archlint\[pictures\]' or a system 'dot'; --format html, mermaid, "):
        drawn_as_svg(lesson())


def test_the_folder_that_is_linted_provides_no_module(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "pygraphviz.py").write_text("raise SystemExit('code of the workspace was run')\n")
    (tmp_path / "re.py").write_text("raise SystemExit('code of the workspace was run')\n")
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(sys, "path", ["", *sys.path])
    assert re.search("</svg>", drawn_as_svg(lesson()))


def test_drawing_in_a_process_of_its_own_leaves_this_one_alone() -> None:
    code = "import archlint.render.drawing; sys.exit({'pygraphviz', 'graphviz'} & {*sys.modules} != set())"
    path = [entry for entry in sys.path if entry]
    subprocess.run([sys.executable, "-c", f"import sys; sys.path[:0] = {path!r}; {code}"], check=True)


def test_what_is_said_below_makes_no_room_for_itself_among_the_shapes() -> None:
    def distance(svg: str) -> float:
        left = {element.text: float(element.get("x", 0)) for element in ElementTree.fromstring(svg).iter(f"{SVG}text")}
        return left["/motor_node"] - left["/sensor_node"]

    silent = replace(diagram(lesson()), caption=())
    said = replace(silent, caption=("what is said is far wider than any shape, and stands below all of them " * 3,))
    assert distance(drawing.svg(said)) == pytest.approx(distance(drawing.svg(silent)), abs=0.1)

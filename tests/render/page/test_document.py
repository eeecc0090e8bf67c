"""The page as a file: what is in it, and what it lets a browser do."""

from __future__ import annotations

import base64
import hashlib
import json
import re
from collections import Counter
from html.parser import HTMLParser
from pathlib import Path

import pytest

from archlint.cli import main
from archlint.render import drawing
from archlint.render.html import render
from archlint.render.page import document
from archlint.render.page.document import LIBRARIES, SCRIPTS, embedded, library_text, script_text
from render.hostile import hostile
from render.lesson import lesson

FOLDER = Path(document.__file__).parent
FIXTURES = Path(__file__).parents[3] / "fixtures"


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
        if self.elements and self.elements[-1][0] in ("script", "style") and data.strip():
            self.raw.append((*self.elements[-1], data))

    @property
    def policy(self) -> str:
        [found] = [attributes["content"] for _, attributes in self.elements if attributes.get("http-equiv")]
        return found or ""

    @property
    def data(self) -> str:
        [found] = [text for _, attributes, text in self.raw if attributes.get("type") == "application/json"]
        return found


def test_the_policy_admits_the_pages_own_scripts_and_style_and_nothing_else():
    page = Page(render(lesson()))
    texts = [text for _, attributes, text in page.raw if "type" not in attributes]
    hashes = [f"'sha256-{base64.b64encode(hashlib.sha256(text.encode()).digest()).decode()}'" for text in texts]
    style, libraries, script = hashes
    assert page.policy == (
        f"default-src 'none'; base-uri 'none'; form-action 'none'; script-src {libraries} {script}; style-src {style}"
    )


def test_nothing_comes_from_elsewhere_and_nothing_runs_from_an_attribute():
    for tag, attributes in Page(render(hostile())).elements:
        assert not {"src", "srcset", "href", "xlink:href", "style"} & set(attributes), tag
        assert not any(name.startswith("on") for name in attributes), tag


def test_no_name_becomes_an_element():
    plain, odd = Page(render(lesson())), Page(render(hostile()))
    assert [tag for tag, _ in odd.elements] == [tag for tag, _ in plain.elements]
    vertices = json.loads(odd.data)["systems"][0]["vertices"]
    assert any(vertex["name"].endswith("<script>alert(1)</script>") for vertex in vertices)


def test_a_name_is_shown_as_what_it_is():
    vertices = json.loads(Page(render(hostile())).data)["systems"][0]["vertices"]
    assert not [line for vertex in vertices for line in vertex["label"] if re.search("[\x00-\x1f\u202e\u200b]", line)]


def test_data_cannot_end_their_block():
    assert embedded({"a": "</script>&\u2028"}) == '{"a":"\\u003c/script\\u003e\\u0026\\u2028"}'


def test_the_same_system_is_the_same_page():
    assert render(lesson()) == render(lesson())


def test_each_module_is_in_the_page():
    modules = {path.stem for path in (FOLDER / "assets").glob("*.js")}
    assert modules == set(SCRIPTS)
    assert not re.search(r"^(import|export) ", script_text(), re.MULTILINE)


def test_no_two_modules_give_the_same_name_to_different_things():
    declared = re.findall(r"^(?:async )?(?:function|const|let|class) (\w+)", script_text(), re.MULTILINE)
    assert [name for name, count in Counter(declared).items() if count > 1] == []


def test_modules_import_only_what_comes_before_them():
    for number, name in enumerate(SCRIPTS):
        text = (FOLDER / "assets" / f"{name}.js").read_text("utf-8")
        assert set(re.findall(r'from "\./(\w+)\.js"', text)) <= set(SCRIPTS[:number]), name


def test_modules_are_short():
    lines = {path.name: len(path.read_text("utf-8").splitlines()) for path in (FOLDER / "assets").glob("*.js")}
    assert {name: count for name, count in lines.items() if count > 300} == {}


def test_scripts_never_read_a_text_as_markup_or_as_code():
    for word in ("innerHTML", "outerHTML", "insertAdjacentHTML", "document.write", "eval(", "new Function"):
        assert word not in script_text()


def test_no_script_ends_its_own_element():
    assert "</" not in script_text()
    assert "</script" not in library_text().lower()


def test_the_libraries_are_those_whose_hashes_are_written_down():
    rows = [row.split(" ") for row in (FOLDER / "vendor" / "VERSIONS").read_text("utf-8").splitlines()]
    assert {file for file, _, _ in rows} == {f"{name}.js" for name in LIBRARIES}
    licences = (FOLDER / "vendor" / "LICENSE").read_text("utf-8")
    for file, package, digest in rows:
        assert hashlib.sha256((FOLDER / "vendor" / file).read_bytes()).hexdigest() == digest
        assert package.replace("@", " ").strip().replace(" dagrejs", "@dagrejs") in licences


@pytest.mark.parametrize("file", ["g.html", "g.mmd", "g.dot", "g.json", "g.svg"])
def test_which_formats_need_graphviz(
    file: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
):
    monkeypatch.setenv("PATH", str(tmp_path))
    monkeypatch.setattr(drawing, "find_spec", lambda name: None)
    words = ["graph", "--no-cache", "--isolated", str(FIXTURES / "lesson"), "-o", str(tmp_path / file)]
    needs = file.endswith("svg")
    assert main(words) == (2 if needs else 0)
    assert ("install 'archlint[pictures]'" in capsys.readouterr().err) is needs
    assert (tmp_path / file).exists() is not needs

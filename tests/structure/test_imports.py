"""The imports between the packages, and the picture of them."""

from __future__ import annotations

import re
from html import unescape
from pathlib import Path

import networkx
import pytest
from benchmarks.structure.imports import WORDS, dot, largest_circle, module_graph, package_graph

PICTURE = Path(__file__).parents[2] / "docs" / "imports.svg"
_TITLE = re.compile(r"<title>(\w+)->(\w+)</title>")

MODULES = [
    ("archlint.__main__", "archlint.cli.check"),
    ("archlint.cli.check", "archlint.cli.console"),
    ("archlint.cli.check", "archlint.engine.run"),
    ("archlint.cli.check", "archlint.place"),
    ("archlint.engine.run", "archlint.place"),
    ("archlint.place", "archlint.visible"),
]
CIRCLE = ("archlint.engine.run", "archlint.cli.console")


def graph_of(*imports: tuple[str, str]) -> networkx.DiGraph:
    return networkx.DiGraph([*imports])


@pytest.fixture(scope="module")
def modules() -> networkx.DiGraph:
    return module_graph()


def test_packages_and_the_modules_beside_them():
    packages = package_graph(graph_of(*MODULES))
    assert set(packages.edges) == {("cli", "engine"), ("cli", WORDS), ("engine", WORDS)}


def test_what_other_arrows_imply_is_not_drawn():
    arrows = re.findall(r"(\w+) -> (\w+)", dot(package_graph(graph_of(*MODULES))))
    assert arrows == [("cli", "engine"), ("engine", WORDS)]


def test_a_circle_is_seen_and_drawn():
    assert largest_circle(graph_of(*MODULES)) == []
    circle = graph_of(*MODULES, CIRCLE, ("archlint.cli.console", "archlint.cli.check"))
    assert largest_circle(circle) == ["archlint.cli.check", "archlint.cli.console", "archlint.engine.run"]
    lines = dot(package_graph(circle)).splitlines()
    assert [line.split()[0] for line in lines if "d03030" in line] == ["cli", "engine"]
    assert any(line.strip() == f"cli -> {WORDS};" for line in lines)  # with a circle nothing is left out


def test_no_module_imports_itself_on_any_way(modules: networkx.DiGraph):
    assert largest_circle(modules) == []


def test_the_picture_is_that_of_today(modules: networkx.DiGraph):
    drawn = set(_TITLE.findall(unescape(PICTURE.read_text(encoding="utf-8"))))
    today = networkx.transitive_reduction(package_graph(modules))
    assert drawn == set(today.edges), "draw it again: python -m benchmarks.structure --draw docs/imports.svg"

"""Diagrams and texts of systems that tests make up, and what Graphviz reads in them."""

from __future__ import annotations

import html
import re
from collections.abc import Sequence

import pygraphviz

from archlint.finding import Finding, Severity
from archlint.place import Place
from archlint.render import render
from archlint.render.diagram.making import diagram_of
from archlint.render.diagram.model import Diagram
from archlint.render.view import WHOLE, View
from archlint.systems.model import System


def diagram(of: System, view: View = WHOLE, findings: Sequence[Finding] = ()) -> Diagram:
    return diagram_of(of, view, findings)


def dot(of: System, view: View = WHOLE, findings: Sequence[Finding] = ()) -> str:
    return str(render("dot", of, view=view, findings=findings))


def mermaid(of: System, view: View = WHOLE, findings: Sequence[Finding] = ()) -> str:
    return str(render("mermaid", of, view=view, findings=findings))


def svg(of: System) -> str:
    return str(render("svg", of))


def parsed(of: System, view: View = WHOLE, findings: Sequence[Finding] = ()) -> pygraphviz.AGraph:
    """The graph as Graphviz itself reads it."""
    return pygraphviz.AGraph(string=dot(of, view, findings))


def words(label: str) -> list[str]:
    """The lines of an HTML-like label, as they are shown."""
    rows = [html.unescape(re.sub(r"<[^>]*>", "", row)) for row in label.split("</TR>")]
    return [row for row in rows if row]


def titles(made: Diagram) -> set[str]:
    return {shape.title for shape in made.shapes.values()}


def lines(made: Diagram) -> set[tuple[str, str]]:
    """Tails and heads, by their titles."""
    return {(made.shapes[line.tail].title, made.shapes[line.head].title) for line in made.lines}


def finding(code: str, place: Place, node: str | None = None, severity: Severity = Severity.ERROR) -> Finding:
    return Finding(code, code.lower(), severity, f"what {code} found", place, node=node)

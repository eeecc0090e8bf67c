"""Pictures made by Graphviz: the machine's own ``dot``, or else the build inside pygraphviz' wheel, which comes with
``archlint[pictures]``: 5 MB to load and 108 MB on the disk, which a check has no use for.

Either runs in a process of its own with a time limit, so that neither a crash nor a layout that does not end
takes archlint along.
"""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
from importlib.util import find_spec
from typing import Literal

from archlint.render import dot
from archlint.render.arranging import places
from archlint.render.diagram.model import Diagram
from archlint.render.errors import CannotDraw, NoGraphviz

Picture = Literal["svg", "png", "pdf"]
Layout = Literal["svg", "png", "pdf", "json0"]
"""What Graphviz is asked for: a picture, or where everything stands (``json0``)."""
Engine = Literal["dot", "nop2"]

TIME_LIMIT = 30
"""Seconds that a layout may take."""

SHARP = 200
"""Shapes up to which a PNG has 144 dots an inch, sharp on paper and dense screens; beyond, 96."""

_BUNDLED = """
import sys
format, engine, *path = sys.argv[1:]
sys.path[:] = path
import pygraphviz
graph = pygraphviz.AGraph(string=sys.stdin.buffer.read().decode())
sys.stdout.buffer.write(graph.draw(format=format, prog=engine))
"""
"""Runs isolated: the folder that is linted must not provide any module of it."""


def svg(diagram: Diagram) -> str:
    return tidy_svg(draw(diagram, "svg").decode("utf-8"))


def png(diagram: Diagram) -> bytes:
    return draw(diagram, "png")


def pdf(diagram: Diagram) -> bytes:
    return draw(diagram, "pdf")


def draw(diagram: Diagram, format: Picture) -> bytes:
    """Raises :class:`CannotDraw`."""
    attributes: dict[str, str] = {}
    if format == "png":
        attributes["dpi"] = "144" if len(diagram.shapes) <= SHARP else "96"
    try:
        if dot.is_large(diagram):
            return layout(dot.write(diagram, attributes), format)
        where = places(layout(dot.write(diagram, attributes), "json0"))
        return layout(dot.placed(dot.write(diagram, attributes, apart=True), where), format, "nop2")
    except NoGraphviz:
        raise
    except CannotDraw:  # some versions of Graphviz cannot place the words on certain lines
        if dot.is_large(diagram):
            raise
    return layout(dot.write(diagram, attributes, hurry=True), format)


def layout(source: str, format: Layout, engine: Engine = "dot") -> bytes:
    """What Graphviz makes of ``source``; ``nop2`` takes the places that are said there.  Raises :class:`CannotDraw`."""
    encoded = source.encode("utf-8", "replace")
    try:
        if shutil.which("dot"):
            return _with_system_graphviz(encoded, format, engine)
        if find_spec("pygraphviz"):
            return _with_bundled_graphviz(encoded, format, engine)
    except subprocess.TimeoutExpired as late:
        raise CannotDraw(
            f"Graphviz took more than {TIME_LIMIT} seconds; --format dot, json and mermaid need no layout"
        ) from late
    except subprocess.CalledProcessError as failed:
        said = failed.stderr.decode("utf-8", "replace").strip().splitlines() or [f"exit status {failed.returncode}"]
        raise CannotDraw(f"Graphviz failed: {said[-1]}") from failed
    raise NoGraphviz(
        "no Graphviz: install 'archlint[pictures]' or a system 'dot'; --format html, mermaid, dot, json and text work "
        "without"
    )


def _with_system_graphviz(source: bytes, format: Layout, engine: Engine) -> bytes:
    from graphviz.backend import execute

    command = ["dot", f"-K{engine}", f"-T{format}"]
    done = execute.run_check(command, input=source, capture_output=True, timeout=TIME_LIMIT, quiet=True)
    return bytes(done.stdout)


def _with_bundled_graphviz(source: bytes, format: Layout, engine: Engine) -> bytes:
    command = [sys.executable, "-I", "-c", _BUNDLED, format, engine, *filter(None, sys.path)]
    return subprocess.run(command, input=source, capture_output=True, timeout=TIME_LIMIT, check=True).stdout


def tidy_svg(text: str) -> str:
    """Without what changes from one Graphviz to the next and says nothing: comments and the document type."""
    text = re.sub(r"<!--.*?-->\n?", "", text, flags=re.DOTALL)
    return re.sub(r"<!DOCTYPE[^>]*>\n?", "", text)

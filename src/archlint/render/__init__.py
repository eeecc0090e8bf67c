"""Show: a system in each format of ``archlint graph``.

A format is a pure function from a system to text or bytes; its module is loaded when it is asked for.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from archlint.systems.model import System

    Renderer = Callable[[System], "str | bytes"]
    """Raises :class:`archlint.render.drawing.CannotDraw` where a picture needs a missing Graphviz."""


def _text(color: bool) -> Renderer:
    from functools import partial

    from archlint.render import text

    return partial(text.render, color=color)


def _json(color: bool) -> Renderer:
    from archlint.render import json

    return json.render


def _dot(color: bool) -> Renderer:
    from archlint.render import dot

    return dot.render


def _svg(color: bool) -> Renderer:
    from archlint.render import drawing

    return drawing.svg


def _png(color: bool) -> Renderer:
    from archlint.render import drawing

    return drawing.png


def _pdf(color: bool) -> Renderer:
    from archlint.render import drawing

    return drawing.pdf


def _mermaid(color: bool) -> Renderer:
    from archlint.render import mermaid

    return mermaid.render


def _html(color: bool) -> Renderer:
    from archlint.render import html

    return html.render


FORMATS: dict[str, Callable[[bool], Renderer]] = {
    "text": _text,
    "json": _json,
    "dot": _dot,
    "svg": _svg,
    "png": _png,
    "pdf": _pdf,
    "mermaid": _mermaid,
    "html": _html,
}
"""Format → loader.  A loader is told whether colour is on (only ``text`` cares) and gives the renderer."""

BINARY = frozenset({"png", "pdf"})
"""Formats that are bytes."""

_SUFFIXES = {
    "txt": "text",
    "json": "json",
    "dot": "dot",
    "gv": "dot",
    "svg": "svg",
    "png": "png",
    "pdf": "pdf",
    "mmd": "mermaid",
    "mermaid": "mermaid",
    "html": "html",
    "htm": "html",
}


def by_suffix(path: str) -> str | None:
    """The format that a file name asks for; None for a suffix that is no format's."""
    return _SUFFIXES.get(path.rpartition(".")[2].lower()) if "." in path else None

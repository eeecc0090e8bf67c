"""Show: a system in each format of ``archlint graph``.

A format is a pure function from a system to text or bytes; its module is loaded when it is asked for.
"""

from __future__ import annotations

import importlib
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final, Literal

if TYPE_CHECKING:
    from archlint.systems.model import System

FormatName = Literal["text", "json", "dot", "svg", "png", "pdf", "mermaid", "html"]


@dataclass(frozen=True)
class Format:
    """A function of a module of this package, and the suffixes of file names that ask for it."""

    module: str
    function: str = "render"
    suffixes: tuple[str, ...] = ()
    binary: bool = False
    """Whether it gives bytes."""
    drawn: bool = False
    """Whether Graphviz draws it."""
    colored: bool = False
    """Whether its function takes colours."""
    says_differences: bool = False
    """Whether it says in words how the running system differs."""


FORMATS: Final[Mapping[FormatName, Format]] = {
    "text": Format("text", suffixes=("txt",), colored=True, says_differences=True),
    "json": Format("json", suffixes=("json",)),
    "dot": Format("dot", suffixes=("dot", "gv")),
    "svg": Format("drawing", "svg", ("svg",), drawn=True),
    "png": Format("drawing", "png", ("png",), binary=True, drawn=True),
    "pdf": Format("drawing", "pdf", ("pdf",), binary=True, drawn=True),
    "mermaid": Format("mermaid", suffixes=("mmd", "mermaid")),
    "html": Format("html", suffixes=("html", "htm"), drawn=True),
}
"""A new format is a new row."""

SUFFIXES = {suffix: name for name, format in FORMATS.items() for suffix in format.suffixes}


def render(format: FormatName, system: System, color: bool = False) -> str | bytes:
    """The system in a format of :data:`FORMATS`.

    Raises :class:`archlint.render.drawing.CannotDraw` where a picture needs a missing Graphviz.
    """
    row = FORMATS[format]
    function = getattr(importlib.import_module(f"archlint.render.{row.module}"), row.function)
    drawn: str | bytes = function(system, color=color) if row.colored else function(system)
    return drawn


def by_suffix(path: str) -> FormatName | None:
    """The format that a file name asks for; None for a suffix that is no format's."""
    return SUFFIXES.get(path.rpartition(".")[2].lower()) if "." in path else None

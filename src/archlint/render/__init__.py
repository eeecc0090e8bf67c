"""Show: a system in each format of ``archlint graph``.

A format is a pure function to text or bytes, of a diagram (:mod:`archlint.render.diagram`) or of the system itself; its
module is loaded when it is asked for.
"""

from __future__ import annotations

import importlib
from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Final, Literal

from archlint.records import dataclass
from archlint.render.view import WHOLE, View

if TYPE_CHECKING:
    from archlint.finding import Finding
    from archlint.systems.model import System

FormatName = Literal["text", "json", "dot", "svg", "png", "pdf", "mermaid", "markdown", "d2", "html"]
Source = Literal["diagram", "marked system", "system", "all systems"]
"""What a format is made of; a ``marked system`` comes with the view and the findings, and ``all systems`` are those of
launch files, too, where they are known."""


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
    split: bool = False
    """Whether what is too large for one picture becomes several, each group with its nodes."""
    of: Source = "diagram"

    @property
    def shows_findings(self) -> bool:
        return self.of != "system"


FORMATS: Final[Mapping[FormatName, Format]] = {
    "text": Format("text", suffixes=("txt",), colored=True, says_differences=True, of="marked system"),
    "json": Format("json", suffixes=("json",), of="system"),
    "dot": Format("dot", suffixes=("dot", "gv")),
    "svg": Format("drawing", "svg", ("svg",), drawn=True),
    "png": Format("drawing", "png", ("png",), binary=True, drawn=True),
    "pdf": Format("drawing", "pdf", ("pdf",), binary=True, drawn=True),
    "mermaid": Format("mermaid", suffixes=("mmd", "mermaid")),
    "markdown": Format("mermaid", "markdown", ("md",), split=True),
    "d2": Format("d2", suffixes=("d2",)),
    "html": Format("html", suffixes=("html", "htm"), drawn=True, of="all systems"),
}
"""A new format is a new row."""

SUFFIXES = {suffix: name for name, format in FORMATS.items() for suffix in format.suffixes}


def render(
    format: FormatName, system: System, color: bool = False, view: View = WHOLE, findings: Sequence[Finding] = ()
) -> str | bytes:
    """The system in a format of :data:`FORMATS`, as a view shows it.

    Raises :class:`archlint.render.errors.CannotDraw` where a picture needs a missing Graphviz, and
    :class:`archlint.render.selection.NothingOfThatName`.
    """
    from archlint.render.diagram.making import diagram_of  # what is kept of an earlier run needs none of it
    from archlint.render.partial import part_of

    row = FORMATS[format]
    function = getattr(importlib.import_module(f"archlint.render.{row.module}"), row.function)
    drawn: str | bytes
    match row.of:
        case "diagram":
            drawn = function(diagram_of(system, replace(view, expand=("*",)) if row.split else view, findings))
        case "marked system":
            drawn = function(system, color=color, view=view, findings=findings)
        case "system" | "all systems":
            drawn = function(part_of(system, view) if view.selects else system)
    return drawn


def by_suffix(path: str) -> FormatName | None:
    """The format that a file name asks for; None for a suffix that is no format's."""
    return SUFFIXES.get(path.rpartition(".")[2].lower()) if "." in path else None

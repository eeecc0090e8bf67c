"""Declarations made from the source: what each node offers and uses, in the formats of other tools.

A format is a pure function.  What is not known is left out with a word that says so: a declaration is a promise.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from importlib import import_module
from typing import TYPE_CHECKING, Final, Literal

if TYPE_CHECKING:
    from archlint.render.declarations.interface import Declarations
    from archlint.render.declarations.rendered import Rendered

FormatName = Literal["interface-yaml", "nodl", "json"]

FORMATS: Final[Mapping[FormatName, str]] = {
    "interface-yaml": "interface_yaml",
    "nodl": "nodl",
    "json": "json",
}
"""The module of each format that tells of nodes as their code makes them."""


def render(format: FormatName, declarations: Declarations) -> Rendered:
    """The interfaces of nodes in a format of :data:`FORMATS`."""
    function: Callable[[Declarations], Rendered] = import_module(f"{__name__}.{FORMATS[format]}").render
    return function(declarations)

"""The graph of one system as a page for a browser; :mod:`archlint.render.page` is all about it."""

from __future__ import annotations

from archlint.render.page.document import page_text
from archlint.render.page.model import PageContents, PageSystem
from archlint.systems.model import System


def render(system: System) -> str:
    """Where Graphviz is missing or fails, the page finds places itself when it is opened."""
    return page_text(PageContents([PageSystem(system)]))

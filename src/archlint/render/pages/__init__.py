"""Pages of Markdown: one a class of nodes, one a launch file, and an index of them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from archlint.render.pages.index_page import index_page
from archlint.render.pages.node_page import node_page
from archlint.render.pages.site import INDEX, Site, site_of
from archlint.render.pages.system_page import system_page
from archlint.systems.rates import rates

if TYPE_CHECKING:
    from archlint.systems.model import System
    from archlint.systems.nodes import Node

MARK = "<!-- Written by `archlint docs` from the source: edit that, and run it again. -->"
"""The first line of each page: a file without it is not archlint's."""


def pages(opened: Sequence[System], launched: Sequence[System], to_sources: str) -> dict[str, str]:
    """The pages by their paths from the folder that they are for.

    ``opened`` are the systems of all code, ``launched`` those of launch files; ``to_sources`` is the way from that
    folder to the one that the paths of sources start in.
    """
    site = site_of(opened, launched, to_sources)
    all_rates = {key: rate for system in (*launched, *opened) for key, rate in rates(system).items()}
    bodies = {INDEX: index_page(site)}
    for page, node in site.nodes.items():
        bodies[page] = node_page(node, _system_of(node, site), all_rates, site, page)
    for page, system in site.systems.items():
        bodies[page] = system_page(system, site, page)
    return {page: f"{MARK}\n\n{body}\n" for page, body in sorted(bodies.items())}


def _system_of(node: Node, site: Site) -> System | None:
    return next((system for system in (*site.opened, *site.systems.values()) if node in system.nodes), None)


__all__ = ["MARK", "pages"]

"""Which part of archlint imports which, by grimp's graph of all imports: those for types and inside functions, too."""

from __future__ import annotations

from collections.abc import Iterator

import grimp
import networkx

PACKAGE = "archlint"
WORDS = "words"
"""Stands for the modules directly below the package, which everything may import."""
_ENTRY = f"{PACKAGE}.__main__"


def module_graph() -> networkx.DiGraph:
    """Every module, with an arrow to each that it imports."""
    imports = grimp.build_graph(PACKAGE, exclude_type_checking_imports=False, cache_dir=None)
    graph = networkx.DiGraph()
    graph.add_nodes_from(sorted(imports.modules))
    for module in sorted(imports.modules):
        graph.add_edges_from((module, other) for other in sorted(imports.find_modules_directly_imported_by(module)))
    return graph


def largest_circle(graph: networkx.DiGraph) -> list[str]:
    """The modules of the largest group that all import each other, on whatever way; none where there is no circle."""
    groups = sorted(networkx.strongly_connected_components(graph), key=lambda group: (-len(group), min(group)))
    return sorted(groups[0]) if groups and len(groups[0]) > 1 else []


def package_graph(modules: networkx.DiGraph) -> networkx.DiGraph:
    """The packages directly below archlint, with an arrow to each that one imports from."""
    packages = {module.split(".")[1] for module in modules if module.count(".") > 1}
    parts = {module: _part(module, packages) for module in modules if module not in (PACKAGE, _ENTRY)}
    ends = {(parts[module], parts[other]) for module, other in modules.edges if {module, other} <= parts.keys()}
    graph = networkx.DiGraph()
    graph.add_nodes_from(sorted(set(parts.values())))
    graph.add_edges_from(sorted((part, other) for part, other in ends if part != other))
    return graph


def _part(module: str, packages: set[str]) -> str:
    name = module.split(".")[1]
    return name if name in packages else WORDS


def dot(packages: networkx.DiGraph) -> str:
    """The packages in Graphviz' language, top to bottom.  Where all arrows run downwards, one that others imply is left
    out; where there is a circle, its arrows are red."""
    return "\n".join(_lines(packages)) + "\n"


def _lines(packages: networkx.DiGraph) -> Iterator[str]:
    yield "digraph imports {"
    yield '    graph [rankdir=TB, ranksep=0.35, nodesep=0.3, bgcolor="transparent"];'
    yield '    node [shape=box, style="rounded,filled", fillcolor="#eef2fb", color="#7a8bb5", fontname="Helvetica"];'
    yield '    edge [color="#7a8bb5", arrowsize=0.7];'
    yield from (f"    {part};" for part in packages)
    circles = [group for group in networkx.strongly_connected_components(packages) if len(group) > 1]
    shown = packages if circles else networkx.transitive_reduction(packages)
    for part, other in sorted(shown.edges):
        color = ' [color="#d03030", penwidth=2]' if any({part, other} <= group for group in circles) else ""
        yield f"    {part} -> {other}{color};"
    yield "}"

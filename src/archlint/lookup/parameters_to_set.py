"""The parameters, and the keys of nodes with parameters, that somebody may be about to write."""

from __future__ import annotations

from collections.abc import Iterator

from archlint.lookup.answers import Completion, CompletionKind
from archlint.lookup.index import Index
from archlint.lookup.known_nodes import nodes_in_file, nodes_of_key, nodes_started
from archlint.lookup.texts import Texts
from archlint.lookup.wanted import Wanted


def parameters_wanted(index: Index, texts: Texts, wanted: Wanted) -> Iterator[Completion]:
    """What the node at hand declares: that of the class, of the launch file's element or of the section."""
    if wanted.node:
        nodes = nodes_of_key(index, wanted.node)
    elif wanted.package or wanted.executable:
        nodes = nodes_started(index, wanted.package, wanted.executable)
    elif wanted.replaces.file.endswith(".py"):
        nodes = nodes_in_file(index, texts, wanted.replaces)
    else:
        nodes = []
    for declaration in (declaration for node in nodes for declaration in node.parameters):
        name = declaration.name.text
        if name is not None and declaration.name.resolution == "exact" and name.startswith(wanted.module):
            default = f" = {declaration.default!r}" if declaration.known else ""
            detail = f"{declaration.type or 'type not known'}{default}"
            yield Completion(name.removeprefix(wanted.module), "parameter", detail, wanted.replaces)


def node_keys(index: Index, texts: Texts, wanted: Wanted) -> Iterator[Completion]:
    """The nodes that have parameters, by their full names."""
    kind: CompletionKind = "node"
    for system, rank in index.systems:
        for node in system.nodes:
            if node.name is not None and node.resolution == "exact" and node.parameters and not node.test:
                class_name = node.blueprint.class_name if node.blueprint is not None else ""
                yield Completion(node.name, kind, class_name, wanted.replaces, rank)


__all__ = ["node_keys", "parameters_wanted"]

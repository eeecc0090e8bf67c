"""Whose endpoint is it?  Two figures: the right owner, and nodes that are no nodes.

The oracle knows the node object that each create call ran on. The owner is right when the graph lists the endpoint's
line under that node: an entry of its class, or of its name where it was made without a class of its own
(`create_node`, `Node("x")`). Asked are entities of a node that the repository's own code made: where the oracle had to
hand in a node of its own, nobody knows whose the endpoint is.

A phantom is an entry that counts as a node although no run constructed a node there (no node of its class, none at
its line) and its source does not say that it is one: no class that derives from a Node, and no call that makes one.
"""

from __future__ import annotations

import ast
from collections import defaultdict
from functools import cache
from pathlib import Path
from typing import Any

from .oracle.workspace import is_test

_NODE_CLASSES = ("BasicNavigator", "TurtleBot4Navigator")
"""Node classes of other packages whose name does not end in Node."""

Entry = dict[str, Any]
Site = tuple[str, int, str]


def owned(oracle: Entry, graph: Entry, lists: dict[str, str]) -> list[tuple[Site, Entry, bool]]:
    """Each place and node of the oracle's entities, once, and whether the graph has it so."""
    made = _made(oracle)
    listed = _listed(graph, lists)
    found: dict[tuple[Site, str, str], tuple[Site, Entry, bool]] = {}
    for entity in oracle["entities"]:
        site = (entity["file"], entity["line"], entity["kind"])
        key = (site, entity["class"], entity["node"])
        if is_test(entity["file"]) or entity["phase"] == "forced" or key in found:
            continue
        if (entity["class"], entity["node"]) in made:
            sites = made[entity["class"], entity["node"]]
            right = any(_is_owner(entry, entity, sites) for entry in listed.get(site, ()))
            found[key] = (site, entity, right)
    return [found[key] for key in sorted(found)]


def owners(graph: Entry, site: Site, lists: dict[str, str]) -> list[str]:
    """What the graph lists an endpoint under, in words; in brackets what it says is no node."""
    entries = _listed(graph, lists).get(site, [])
    return sorted({_shown(entry) for entry in entries})


def phantoms(oracle: Entry, graph: Entry, checkout: Path) -> list[str]:
    """The entries that count as nodes and are none, outside of test code."""
    classes = {tuple(place.rsplit(":", 1)) for node in oracle["nodes"] for place in node["classes"]}
    lines = {(node["file"], line) for node in oracle["nodes"] for line in range(node["line"], node["end_line"] + 1)}
    found = []
    for entry in graph["nodes"]:
        if not entry.get("is_node", True) or entry.get("external") or entry.get("test") or entry["file"] is None:
            continue
        if (
            is_test(entry["file"])
            or (entry["file"], entry["class"]) in classes
            or (entry["file"], entry["line"]) in lines
        ):
            continue
        if not _says_node(checkout, entry["file"], entry["line"]):
            found.append(f"{entry['file']}:{entry['line']} {_shown(entry)}")
    return sorted(found)


def _made(oracle: Entry) -> dict[tuple[str, str], list[tuple[str, int]]]:
    """The places where the repository's code makes the nodes of a class and name."""
    found: dict[tuple[str, str], list[tuple[str, int]]] = defaultdict(list)
    for node in oracle["nodes"]:
        found[node["class"], node["node"]].append((node["file"], node["line"]))
    return found


def _listed(graph: Entry, lists: dict[str, str]) -> dict[Site, list[Entry]]:
    found: dict[Site, list[Entry]] = defaultdict(list)
    for entry in graph["nodes"]:
        for kind, name in lists.items():
            for endpoint in entry.get(name, []):
                found[endpoint["file"], endpoint["line"], kind].append(entry)
    return found


def _is_owner(entry: Entry, entity: Entry, sites: list[tuple[str, int]]) -> bool:
    if not entry.get("is_node", True):
        return False
    if entry["name"] is not None and entity["node"] == entry["name"]:
        return True
    partly = entry["name"] is None or "*" in entity["node"] or "*" in entry["name"]
    same_class = (entry["class"] or "").rpartition(".")[2] == entity["class"].rpartition(".")[2]
    return partly and (same_class or (entry["file"], entry["line"]) in sites)


def _shown(entry: Entry) -> str:
    name = f"{entry['class']} {entry['name'] or ''}".strip()
    return name if entry.get("is_node", True) else f"({name})"


# What the source says ----------------------------------------------------------------------------
def _says_node(checkout: Path, file: str, line: int) -> bool:
    """Whether a class that derives from a Node stands at a line, or a call that makes one; True for a file that this
    Python cannot read."""
    tree = _tree(checkout / file)
    for item in ast.walk(tree) if tree is not None else ():
        if isinstance(item, ast.ClassDef) and item.lineno <= line <= item.body[0].lineno:
            return _derives(checkout, item.name, frozenset())
        if isinstance(item, ast.Call) and item.lineno <= line <= (item.end_lineno or line):
            called = _last(item.func)
            if called == "create_node" or _is_node_name(called) or _derives(checkout, called, frozenset()):
                return True
    return tree is None


def _derives(checkout: Path, name: str, seen: frozenset[str]) -> bool:
    bases = _bases(checkout).get(name, [])
    return any(_is_node_name(base) or (base not in seen and _derives(checkout, base, seen | {name})) for base in bases)


def _is_node_name(name: str) -> bool:
    return name.endswith("Node") or name in _NODE_CLASSES


@cache
def _bases(checkout: Path) -> dict[str, list[str]]:
    """The names of the bases of all classes of a checkout, by the class's name."""
    found: dict[str, list[str]] = defaultdict(list)
    for path in sorted(checkout.rglob("*.py")):
        tree = _tree(path)
        for item in ast.walk(tree) if tree is not None else ():
            if isinstance(item, ast.ClassDef):
                found[item.name].extend(_last(base) for base in item.bases)
    return dict(found)


@cache
def _tree(path: Path) -> ast.Module | None:
    try:
        return ast.parse(path.read_bytes())
    except (OSError, SyntaxError, ValueError):
        return None


def _last(value: ast.expr) -> str:
    return value.attr if isinstance(value, ast.Attribute) else value.id if isinstance(value, ast.Name) else ""

"""What is wanted where somebody types in YAML, a launch file or a parameter file, which need not be complete."""

from __future__ import annotations

import re

from archlint.lookup.texts import Texts
from archlint.lookup.wanted import Wanted, WantedKind
from archlint.place import Place

_KEY = re.compile(
    r"""^(?P<indent>\s*(?:-\s+)?)(?P<key>["']?[^\s:#"'][^:#"']*["']?)\s*:(?:\s+(?P<quote>["']?)(?P<value>[^"'#]*))?\Z"""
)
_TYPED_KEY = re.compile(r"^(?P<indent>\s*)(?P<typed>[\w./*-]*)\Z")
_PARAMETERS = "ros__parameters"
_VALUES: dict[tuple[str, str], WantedKind] = {
    ("node", "pkg"): "package",
    ("node", "exec"): "executable",
    ("remap", "from"): "remap source",
    ("remap", "to"): "remap target",
    ("param", "name"): "parameter",
}


def wanted_in_yaml(texts: Texts, file: str, line: int, column: int) -> Wanted | None:
    """What is wanted at a position of a YAML file; None where that is nothing of ROS."""
    row = texts.line(file, line)[: column - 1]
    is_launch = any(re.match(r"launch\s*:", each) for each in texts.lines(file)[:50])
    return _in_launch(texts, file, line, row) if is_launch else _in_parameters(texts, file, line, row)


def _in_launch(texts: Texts, file: str, line: int, row: str) -> Wanted | None:
    typed = _KEY.match(row)
    if typed is None or typed["value"] is None:
        return None
    above = _above(texts, file, line, len(typed["indent"]))
    parent = next((key for _, key, _ in above), "")
    what = _VALUES.get((parent, typed["key"]))
    if what is None:
        return None
    node = next((number for number, key, _ in above if key == "node"), line)
    value, place = typed["value"], Place(file, line, len(row) + 1 - len(typed["value"]), line, len(row) + 1)
    package, executable = _child(texts, file, node, "pkg"), _child(texts, file, node, "exec")
    return Wanted(what, place, value, package=package, executable=executable)


def _above(texts: Texts, file: str, line: int, indent: int) -> list[tuple[int, str, int]]:
    """The keys around a line, innermost first: line, key, and how far it is indented."""
    rows: list[tuple[int, str, int]] = []
    for number in range(line - 1, 0, -1):
        if indent == 0:
            break
        key = _KEY.match(texts.line(file, number).rstrip())
        depth = len(key["indent"]) if key is not None else indent
        if key is not None and depth < indent and key["value"] in (None, ""):
            rows.append((number, key["key"].strip("\"'"), depth))
            indent = depth
    return rows


def _child(texts: Texts, file: str, line: int, name: str) -> str:
    """The value of a key directly below the one of a line."""
    parent = _KEY.match(texts.line(file, line).rstrip())
    depth = len(parent["indent"]) if parent is not None else 0
    for number in range(line + 1, len(texts.lines(file)) + 1):
        key = _KEY.match(texts.line(file, number).rstrip())
        if key is not None and len(key["indent"]) <= depth:
            break
        if key is not None and key["key"] == name:
            return (key["value"] or "").strip("\"' ")
    return ""


def _in_parameters(texts: Texts, file: str, line: int, row: str) -> Wanted | None:
    typed = _TYPED_KEY.match(row)
    if typed is None:
        return None
    keys = [key for _, key, _ in _above(texts, file, line, len(typed["indent"]))]
    place = Place(file, line, len(typed["indent"]) + 1, line, len(row) + 1)
    if _PARAMETERS in keys:
        at = keys.index(_PARAMETERS)
        nested = "".join(f"{key}." for key in reversed(keys[:at]))
        node = "/" + "/".join(key.strip("/") for key in reversed(keys[at + 1 :]))
        return Wanted("parameter", place, typed["typed"], node=node, module=nested)
    return None if keys else Wanted("node key", place, typed["typed"])


__all__ = ["wanted_in_yaml"]

"""What is wanted where somebody types in an XML launch file, which need not be well-formed at that moment."""

from __future__ import annotations

import re

from archlint.lookup.texts import Texts
from archlint.lookup.wanted import Wanted, WantedKind
from archlint.place import Place

_IN_VALUE = re.compile(
    r"""<(\w[\w-]*)((?:\s+[\w:-]+\s*=\s*(?:"[^"]*"|'[^']*'))*)\s+([\w:-]+)\s*=\s*(["'])([^"'<>]*)\Z"""
)
_TAG = re.compile(r"""<(/?)(\w[\w-]*)((?:"[^"]*"|'[^']*'|[^<>"'])*?)(/?)>""")
_COMMENT = re.compile(r"<!--.*?(?:-->|\Z)", re.DOTALL)
_SHARE = re.compile(r"\$\(find-pkg-(?:share|prefix) ([\w-]*)\Z")
_NODES = ("node", "lifecycle_node")
_WANTED: dict[tuple[str, str], WantedKind] = {
    **{(tag, "pkg"): "package" for tag in (*_NODES, "node_container", "composable_node")},
    **{(tag, "exec"): "executable" for tag in (*_NODES, "node_container")},
    ("remap", "from"): "remap source",
    ("remap", "to"): "remap target",
    ("param", "name"): "parameter",
}


def wanted_in_xml(texts: Texts, file: str, line: int, column: int) -> Wanted | None:
    """What is wanted at a position of an XML launch file; None where that is nothing of ROS."""
    lines = texts.lines(file)
    before = "\n".join([*lines[: line - 1], texts.line(file, line)[: column - 1]])
    before = _COMMENT.sub(lambda match: " " * len(match[0]), before)
    typing = _IN_VALUE.search(before[max(before.rfind("<"), 0) :])
    if typing is None:
        return None
    tag, name, typed = typing[1], typing[3], typing[5]
    share = _SHARE.search(typed)
    if share is not None:
        return Wanted("package", _back(file, line, column, share[1]), share[1])
    what = _WANTED.get((tag, name))
    if what is None or "$(" in typed or "\n" in typed:
        return None
    behind = "\n".join([texts.line(file, line)[column - 1 :], *lines[line : line + 10]])
    own = before[before.rfind("<") :] + behind.partition(">")[0]
    around = own if tag in _NODES else _node_around(before[: before.rfind("<")])
    package, executable = _attribute(around, "pkg"), _attribute(around, "exec")
    return Wanted(what, _back(file, line, column, typed), typed, package=package, executable=executable)


def _node_around(before: str) -> str:
    """The start of the node element that is open at the end of a text; empty where there is none."""
    opened: list[re.Match[str]] = []
    for tag in _TAG.finditer(before):
        if tag[1]:
            while opened and opened.pop()[2] != tag[2]:
                pass
        elif not tag[4]:
            opened.append(tag)
    return next((tag[0] for tag in reversed(opened) if tag[2] in _NODES), "")


def _attribute(tag: str, name: str) -> str:
    match = re.search(rf"""\s{name}\s*=\s*["']([\w.-]*)["']""", tag)
    return "" if match is None else match[1]


def _back(file: str, line: int, column: int, typed: str) -> Place:
    return Place(file, line, column - len(typed), line, column)


__all__ = ["wanted_in_xml"]

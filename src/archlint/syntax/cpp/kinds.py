"""What is certain of a value in C++, and how the parser's nodes name it."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import field, replace
from typing import TYPE_CHECKING

from archlint.records import dataclass
from archlint.syntax.cpp.known_names import INTERFACE_KINDS
from archlint.syntax.cpp_uses import Holder

if TYPE_CHECKING:
    from tree_sitter import Node

    from archlint.syntax.facts import Span

_SECTIONS = frozenset({"Request", "Response", "Goal", "Result", "Feedback"})

Member = tuple[str, "Span"]


@dataclass(frozen=True)
class Kind:
    """What is certain of a value: what was asked of a variable of a type, one after the other."""

    path: tuple[str, ...]
    holder: Holder = ""
    members: tuple[Member, ...] = ()
    owner: str = ""
    """The class of another file whose field it is; the path is that of the field then."""
    of: tuple[str, ...] = ()
    """The interface of an endpoint."""

    @property
    def is_interface(self) -> bool:
        return is_interface(self.path)

    def with_member(self, name: str, span: Span) -> Kind:
        return replace(self, members=(*self.members, (name, span)))


def is_interface(path: Sequence[str]) -> bool:
    """Whether a type is a message, or a part of a service or an action."""
    if len(path) < 3 or path[1] not in INTERFACE_KINDS:
        return False
    return len(path) == 3 if path[1] == "msg" else len(path) == 4 and path[3] in _SECTIONS


@dataclass
class ClassOfFile:
    """A class that the file defines."""

    bases: list[tuple[str, ...]] = field(default_factory=list)
    fields: dict[str, Kind | None] = field(default_factory=dict)
    methods: dict[str, list[list[Node] | None]] = field(default_factory=dict)
    """The parameters of each method of a name; None for one that takes any number."""
    is_whole: bool = True
    """Whether all of its members were read."""


def parameters_of(node: Node | None) -> list[Node] | None:
    """The parameters of a function; None where it takes any number, or has defaults."""
    if node is None:
        return None
    rows = [child for child in node.named_children if child.type != "comment"]
    if any(child.type == "variadic_parameter_declaration" or child.type == "variadic_parameter" for child in rows):
        return None
    if any(child.type == "..." for child in node.children):
        return None
    if len(rows) == 1 and rows[0].type == "parameter_declaration" and rows[0].text == b"void":
        return []
    return rows


def plain(nodes: Iterable[Node]) -> list[Node]:
    """Nodes without the comments among them."""
    return [node for node in nodes if node.type != "comment"]


__all__ = ["ClassOfFile", "Kind", "is_interface", "parameters_of", "plain"]

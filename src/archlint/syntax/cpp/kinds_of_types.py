"""The types that a C++ file names, with its aliases in their places."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.syntax.cpp.kinds import Kind
from archlint.syntax.cpp_uses import Holder

if TYPE_CHECKING:
    from tree_sitter import Node

    from archlint.syntax.cpp.names import Names, Part
    from archlint.syntax.cpp.source import SourceText

_SHARED = frozenset({"SharedPtr", "ConstSharedPtr", "Ptr", "ConstPtr"})
_UNIQUE = frozenset({"UniquePtr", "ConstUniquePtr"})
_HOLDERS: dict[tuple[str, str], Holder] = {
    ("std", "shared_ptr"): "shared",
    ("boost", "shared_ptr"): "shared",
    ("std", "unique_ptr"): "unique",
    ("std", "vector"): "list",
    ("std", "deque"): "list",
    ("std", "array"): "list",
}
MOST_INSIDE = 20
_TYPES = frozenset({"qualified_identifier", "type_identifier", "template_type", "dependent_type", "identifier"})


class KindsOfTypes:
    """The types of one file."""

    def __init__(self, source: SourceText, names: Names) -> None:
        self.source, self.names = source, names
        self._aliases: dict[str, Node | None] = {}
        """What each alias stands for; None for one that stands for several things."""
        self._inside = 0

    def note_alias(self, node: Node) -> None:
        """Take note of ``using Twist = geometry_msgs::msg::Twist;`` and the like."""
        if node.type == "alias_declaration":
            self._note_alias(node.child_by_field_name("name"), node.child_by_field_name("type"))
        elif node.type == "type_definition":
            self._note_alias(node.child_by_field_name("declarator"), node.child_by_field_name("type"))
        elif node.type == "using_declaration" and node.named_children:
            name = node.named_children[-1]
            if name.type == "qualified_identifier" and node.children[1].type not in ("namespace", "typename"):
                self._note_alias(name, name)
        elif node.type == "namespace_alias_definition" and len(node.named_children) > 1:
            self._note_alias(node.named_children[0], node.named_children[-1])

    def _note_alias(self, name: Node | None, meant: Node | None) -> None:
        if name is None or meant is None:
            return
        own = self.source.text(name).rpartition("::")[2]
        known = self._aliases.get(own, meant)
        same = known is not None and self.source.text(known) == self.source.text(meant)
        self._aliases[own] = meant if same else None

    def parts(self, node: Node) -> list[Part]:
        """The parts of a name with aliases replaced."""
        parts = [part for part in self.names.parts(node) if part.name]
        for _ in range(MOST_INSIDE):
            meant = self._aliases.get(parts[0].name) if parts else None
            if not parts or parts[0].name not in self._aliases:
                return parts
            if meant is None:
                return []
            before = [part for part in self.names.parts(meant) if part.name]
            if before[:1] == parts[:1]:
                return parts
            parts = [*before, *parts[1:]]
        return []

    def path(self, node: Node) -> tuple[str, ...]:
        """A type as its names, without pointers; empty where it is not known."""
        kind = self.of_type(node)
        return kind.path if kind is not None and not kind.holder else ()

    def of_type(self, node: Node | None) -> Kind | None:
        """The kind of the values of a type."""
        if node is None or self._inside > MOST_INSIDE:
            return None
        self._inside += 1
        try:
            return self._of_type(node)
        finally:
            self._inside -= 1

    def _of_type(self, node: Node) -> Kind | None:
        if node.type in ("primitive_type", "sized_type_specifier"):
            return Kind((self.source.text(node),))
        if node.type == "type_descriptor":
            inner = self.of_type(node.child_by_field_name("type"))
            return inner if node.child_by_field_name("declarator") is None else None
        return self._of_parts(self.parts(node)) if node.type in _TYPES else None

    def _of_parts(self, parts: list[Part]) -> Kind | None:
        if not parts:
            return None
        if len(parts) > 1 and parts[-1].name in _SHARED | _UNIQUE:
            inner = self._of_parts(parts[:-1])
            holder: Holder = "shared" if parts[-1].name in _SHARED else "unique"
            return None if inner is None or inner.holder else replace(inner, holder=holder)
        names = tuple(part.name for part in parts)
        if len(parts) == 2 and (names[0], names[1]) in _HOLDERS and parts[1].arguments:
            inner = self.of_type(parts[1].arguments[0])
            holder = _HOLDERS[names[0], names[1]]
            return None if inner is None or inner.holder else replace(inner, holder=holder)
        if names[0] in ("rclcpp", "rclcpp_action") and len(parts) > 1 and parts[1].arguments:
            of = self.path(parts[1].arguments[0])
            if names == ("rclcpp", "Client", "SharedFuture"):
                return Kind((*of, "Response"), "future")
            return Kind(names, of=of)
        return None if any(part.arguments for part in parts) else Kind(names)


__all__ = ["MOST_INSIDE", "KindsOfTypes"]

"""Names that a C++ file has not: of pointers, units and placeholders; and nodes that are given no name."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import TYPE_CHECKING

from archlint.suggestions import distance
from archlint.syntax.cpp.kinds import is_interface, plain
from archlint.syntax.cpp.known_names import POINTERS
from archlint.syntax.cpp.refusals import Refusals

if TYPE_CHECKING:
    from tree_sitter import Node

_NAMED = ("SharedPtr", "ConstSharedPtr", "UniquePtr", "ConstUniquePtr", "WeakPtr")
_LIKE_A_POINTER = re.compile(r"\w*(?:[Pp]tr|[Pp]ointer)")
_SLIPS = 4
_UNIT = re.compile(r"[\d.']+(h|min|s|ms|us|ns)")
_PLACEHOLDER = re.compile(r"_[1-9]")


class RefusedNames(Refusals):
    """Notes names that nothing declares."""

    def typed(self, node: Node) -> None:
        """The type of a variable, a field or a parameter: ``rclcpp::Publisher<String>::SharePtr``."""
        type_ = node.child_by_field_name("type")
        if type_ is None or type_.type != "qualified_identifier":
            return
        parts = self._kinds.parts(type_)
        if len(parts) < 2 or parts[-1].arguments or parts[-1].name in POINTERS:
            return
        last, before = parts[-1].name, tuple(part.name for part in parts[:-1])
        if _LIKE_A_POINTER.fullmatch(last) is None or not (is_interface(before) or before[0] == "rclcpp"):
            return
        meant = min(_NAMED, key=lambda name: distance(last.lower(), name.lower(), _SLIPS))
        if distance(last.lower(), meant.lower(), _SLIPS) <= _SLIPS:
            self._note("pointer name", type_, "::".join(before), f"{last} {meant}")

    def unit(self, node: Node) -> None:
        """A number with a unit of time, ``500ms``, in a file that has no word for where units are defined."""
        text = self._text(node)
        data = self._source.data
        if _UNIT.fullmatch(text) is None or b"literals" in data or b"using namespace std;" in data:
            return
        if not any(row.kind == "literal" for row in self.found):
            self._note("literal", node, "", text)

    def _placed(self, arguments: Sequence[Node]) -> None:
        """A placeholder among what is bound, in a file that has no word for where they are."""
        if b"placeholders" in self._source.data or any(row.kind == "placeholder" for row in self.found):
            return
        for argument in arguments:
            if argument.type == "identifier" and _PLACEHOLDER.fullmatch(self._text(argument)):
                self._note("placeholder", argument, "", self._text(argument))
                return

    def constructor(self, node: Node, named: Node | None) -> None:
        """A constructor that gives its base, a node, no arguments: it has no constructor without any."""
        owner, name = self._kinds.owner, None if named is None else named.child_by_field_name("declarator")
        own = self._kinds.classes.get(owner)
        if own is None or name is None or not own.is_whole or not self._kinds.node_kind(owner):
            return
        if node.child_by_field_name("type") is not None or self._kinds.names.parts(name)[-1].name != owner:
            return
        lists = [child for child in node.named_children if child.type == "field_initializer_list"]
        given = [row.named_children[0] for child in lists for row in plain(child.named_children) if row.named_children]
        if all(self._text(field) in own.fields for field in given):
            self._note("no node", name, owner)


__all__ = ["RefusedNames"]

"""What is bound, spun and published in C++ and that a compiler refuses."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from archlint.syntax.cpp.kinds import is_interface
from archlint.syntax.cpp.kinds_of_classes import NODES
from archlint.syntax.cpp.refused_endpoints import RefusedEndpoints

if TYPE_CHECKING:
    from tree_sitter import Node

_OF_POINTERS = frozenset({"get", "reset", "swap", "unique", "use_count", "owner_before"})
_ALWAYS_GIVEN = frozenset({"parameter_declaration"})
_OF_NODES = frozenset({"on_configure", "on_activate", "on_deactivate", "on_cleanup", "on_shutdown", "on_error"})


class RefusedObjects(RefusedEndpoints):
    """Notes what is not done with nodes, their methods and their publishers."""

    def _spun(self, name: str, node: Node) -> None:
        """What is spun must be a shared pointer to a node."""
        kind = self._kinds.of(node)
        if node.type == "this":
            self._note("no pointer to node", node, name, "this")
        elif kind is None or kind.members or kind.owner:
            return
        elif kind.holder in ("", "raw") and self._is_node(kind.path):
            self._note("no pointer to node", node, name, self._text(node))
        elif kind.holder == "unique" and self._is_node(kind.path) and node.type == "identifier":
            self._note("unique pointer", node, name, self._text(node))
        elif kind.holder == "shared" and self._node_kind(kind.path) == "lifecycle":
            self._note("lifecycle node", node, name, self._text(node))

    def _bound(self, arguments: Sequence[Node]) -> None:
        """``std::bind`` gives a method of the class around all of its arguments."""
        self._placed(arguments[1:])
        if len(arguments) < 2 or arguments[1].type != "this":
            return
        rows = self._methods(arguments[0])
        if rows is None:
            return
        name = self._text(arguments[0]).rpartition("::")[2]
        if not rows:
            if self._has_no_other_members(name):
                self._note("no method", arguments[0], name, self._kinds.owner)
            return
        given, taken = len(arguments) - 2, rows[0] if len(rows) == 1 else None
        if taken is not None and len(taken) != given and all(row.type in _ALWAYS_GIVEN for row in taken):
            self._note("bound arguments", arguments[0], name, f"{len(taken)} {given}")

    def _has_no_other_members(self, name: str) -> bool:
        """Whether the class around has no member of a name, from no base either."""
        own = self._kinds.classes.get(self._kinds.owner)
        if own is None or name in own.fields or name in _OF_NODES:
            return False
        return all(base in NODES or "enable_shared_from_this" in base for base in own.bases)

    def _published(self, function: Node, arguments: Sequence[Node]) -> None:
        """A message of another type than that of the publisher."""
        if function.type != "field_expression" or len(arguments) != 1:
            return
        name = function.child_by_field_name("field")
        publisher = self._kinds.of(function.child_by_field_name("argument"))
        if (
            name is None
            or self._text(name) != "publish"
            or publisher is None
            or publisher.path != ("rclcpp", "Publisher")
        ):
            return
        message = self._kinds.of(arguments[0])
        if message is None or message.members or message.owner or not is_interface(message.path):
            return
        if is_interface(publisher.of) and message.path != publisher.of and publisher.holder == "shared":
            self._note("published type", arguments[0], "::".join(publisher.of), "::".join(message.path))

    def _through_a_dot(self, function: Node) -> None:
        """A method that is asked of the pointer to an object of rclcpp instead of the object."""
        name = function.child_by_field_name("field") if function.type == "field_expression" else None
        if name is None or not any(child.type == "." for child in function.children):
            return
        argument = function.child_by_field_name("argument")
        kind = self._kinds.of(argument)
        if argument is None or kind is None or kind.members or kind.owner or kind.path[:1] != ("rclcpp",):
            return
        if kind.holder in ("shared", "raw") and self._text(name) not in _OF_POINTERS:
            self._note("dot", function, self._text(argument), self._text(name))


__all__ = ["RefusedObjects"]

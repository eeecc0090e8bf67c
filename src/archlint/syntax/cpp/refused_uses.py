"""What C++ code gives rclcpp, and what it takes of it, that does not compile.

Sources, Humble to Rolling: ``rclcpp/logging.hpp`` (the first argument is a logger, behind which ``_THROTTLE`` takes a
clock and a number of milliseconds; the format goes to ``rcutils_log(const char *)``), ``rclcpp/executors.hpp`` (what is
spun is a shared pointer to a ``rclcpp::Node`` or to its base interface), ``rclcpp/node.hpp`` (a publisher has a QoS, a
subscription a QoS and a callback, the period of a timer is a ``std::chrono::duration``),
``rclcpp/any_subscription_callback.hpp``, ``rclcpp/any_service_callback.hpp``.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.syntax.cpp.declared import declared
from archlint.syntax.cpp.kinds import plain
from archlint.syntax.cpp.refused_endpoints import CREATED, NUMBERS
from archlint.syntax.cpp.refused_objects import RefusedObjects

if TYPE_CHECKING:
    from tree_sitter import Node

_PLAIN = NUMBERS | {"std::string"}
_SPINS = frozenset({("rclcpp", "spin"), ("rclcpp", "spin_some"), ("rclcpp", "spin_until_future_complete")})
_BINDS = frozenset({("std", "bind"), ("boost", "bind")})


class RefusedUses(RefusedObjects):
    """Notes what is refused of calls, assignments and declarations."""

    def call(self, node: Node) -> None:
        """A call of a function, a method or a macro."""
        function, listed = node.child_by_field_name("function"), node.child_by_field_name("arguments")
        if function is None or listed is None or listed.type != "argument_list":
            return
        arguments = plain(listed.named_children)
        if function.type == "identifier" and self._logs(self._text(function), arguments):
            return
        if function.type == "qualified_identifier":
            path = tuple(part.name for part in self._kinds.parts(function))
            if path in _SPINS and arguments:
                self._spun(path[-1], arguments[0])
            elif path in _BINDS:
                self._bound(arguments)
        self._of_node(function, arguments)
        self._published(function, arguments)
        self._through_a_dot(function)

    def assignment(self, node: Node) -> None:
        """An endpoint that is kept in a field for one of another type."""
        left, right = node.child_by_field_name("left"), node.child_by_field_name("right")
        if left is None or right is None or right.type != "call_expression" or node.children[1].type != "=":
            return
        kept, function = self._kinds.of(left), right.child_by_field_name("function")
        called = None if function is None else self._method_of_node(function)
        if kept is None or called is None or kept.members or kept.owner or kept.holder != "shared":
            return
        part = self._kinds.names.parts(called)[-1]
        if part.name not in CREATED or not part.arguments or kept.path[:1] != ("rclcpp",):
            return
        created = self._kinds.path(part.arguments[0])
        both = kept.path == ("rclcpp", CREATED[part.name]) and _is_of_interface(kept.of) and _is_of_interface(created)
        if both and kept.of != created:
            self._note("created type", called, "::".join(kept.of), "::".join(created))

    def declaration(self, node: Node) -> None:
        """A parameter that is taken for its value: ``double rate = get_parameter("rate");``."""
        type_ = node.child_by_field_name("type")
        if type_ is None or self._text(type_) not in _PLAIN:
            return
        for variable in declared(node, self._kinds.names, self._source):
            value = variable.value
            if value is None or value.type != "call_expression" or variable.is_pointer:
                continue
            function, listed = value.child_by_field_name("function"), value.child_by_field_name("arguments")
            called = None if function is None else self._method_of_node(function)
            arguments = [] if listed is None else plain(listed.named_children)
            if called is not None and self._text(called) == "get_parameter" and len(arguments) == 1:
                self._note("parameter", value, variable.name, self._text(type_))


def _is_of_interface(path: tuple[str, ...]) -> bool:
    return len(path) == 3 and path[1] in ("msg", "srv", "action")


__all__ = ["RefusedUses"]

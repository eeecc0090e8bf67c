"""Calls that create endpoints and timers of a node and that a compiler refuses."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import TYPE_CHECKING

from archlint.syntax.cpp.kinds import is_interface, parameters_of, plain
from archlint.syntax.cpp.refused_logs import RefusedLogs

if TYPE_CHECKING:
    from tree_sitter import Node

NUMBERS = frozenset({"int", "double", "float", "bool", "long", "size_t", "unsigned int", "int64_t", "uint64_t"})
CREATED = {
    "create_publisher": "Publisher",
    "create_subscription": "Subscription",
    "create_service": "Service",
    "create_client": "Client",
}
_FEWEST = {"create_publisher": 2, "create_subscription": 3, "create_service": 2}
_PLACEHOLDER = re.compile(r"(?:std::placeholders::|placeholders::)?_(\d)")


class RefusedEndpoints(RefusedLogs):
    """Notes what the methods of a node do not take."""

    def _of_node(self, function: Node, arguments: Sequence[Node]) -> None:
        """What the methods of a node are given."""
        name_node = self._method_of_node(function)
        if name_node is None or any(argument.type == "pack_expansion" for argument in arguments):
            return
        is_template = name_node.type in ("template_function", "template_method")
        parts = self._kinds.names.parts(name_node)
        name, types = parts[-1].name, parts[-1].arguments
        if name in ("create_wall_timer", "create_timer") and arguments and not is_template:
            self._timer(name, arguments)
        elif name in CREATED and is_template and types:
            self._endpoint(name, types[0], name_node, arguments)

    def _method_of_node(self, function: Node) -> Node | None:
        """The name of a method that is called on what is certainly a node, and nobody's own method."""
        if function.type in ("identifier", "template_function"):
            name = function
        elif function.type == "field_expression":
            argument = function.child_by_field_name("argument")
            field = function.child_by_field_name("field")
            if argument is None or field is None:
                return None
            if argument.type != "this":
                kind = self._kinds.of(argument)
                is_node = kind is not None and not kind.members and not kind.owner and len(kind.path) == 2
                return field if is_node and kind is not None and self._is_node(kind.path) else None
            name = field
        else:
            return None
        own = self._kinds.classes.get(self._kinds.owner)
        called = self._kinds.names.parts(name)[-1].name
        if own is None or not own.is_whole or called in own.methods or not self._kinds.node_kind(self._kinds.owner):
            return None
        return None if self._kinds.is_local(called) else name

    def _timer(self, name: str, arguments: Sequence[Node]) -> None:
        period = arguments[0]
        kind = self._kinds.of(period) if period.type == "identifier" else None
        is_number = kind is not None and kind.path[0] in NUMBERS and not kind.members and not kind.owner
        if period.type == "number_literal" and period.text is not None and period.text[-1:].isdigit():
            is_number = True
        if is_number:
            self._note("period", period, name, self._text(period))
        elif len(arguments) == 1:
            self._note("no callback", period, name)
        elif len(arguments) > 1 and (rows := self._lambda(arguments[1])) is not None and len(rows) > 1:
            self._note("callback arguments", arguments[1], name, str(len(rows)))

    def _endpoint(self, name: str, type_: Node, called: Node, arguments: Sequence[Node]) -> None:
        if name == "create_subscription" and len(arguments) >= 2 and self._is_callback(arguments[1]):
            self._note("callback for qos", arguments[1], name)
            return
        if len(arguments) < _FEWEST.get(name, 0):
            self._note("no callback" if name == "create_service" else "no qos", called, name)
            return
        at = {"create_subscription": 2, "create_service": 1}.get(name)
        if at is None or len(arguments) <= at:
            return
        written = self._lambda(arguments[at])
        rows = written or self._method(arguments[at])
        fewest = 1 if name == "create_subscription" else 2
        if written is not None and not fewest <= len(written) <= fewest + 1:
            self._note("callback arguments", arguments[at], name, str(len(written)))
        elif rows:
            self._callback_type(name, self._kinds.path(type_), rows[0])

    def _is_callback(self, node: Node) -> bool:
        if node.type == "lambda_expression":
            return True
        function = node.child_by_field_name("function") if node.type == "call_expression" else None
        return function is not None and self._text(function) in ("std::bind", "boost::bind")

    def _lambda(self, node: Node) -> list[Node] | None:
        """The parameters of a function that is written where it is given."""
        if node.type != "lambda_expression":
            return None
        declarator = node.child_by_field_name("declarator")
        return [] if declarator is None else parameters_of(declarator.child_by_field_name("parameters"))

    def _method(self, node: Node) -> list[Node] | None:
        """The parameters of the method of this object that ``std::bind`` makes a function of."""
        if not self._is_callback(node) or node.type == "lambda_expression":
            return None
        listed = node.child_by_field_name("arguments")
        arguments = [] if listed is None else plain(listed.named_children)
        if len(arguments) < 3 or arguments[1].type != "this" or not _is_first(self._text(arguments[2])):
            return None
        rows = self._methods(arguments[0])
        return rows[0] if rows is not None and len(rows) == 1 else None

    def _methods(self, pointer: Node) -> list[list[Node] | None] | None:
        """The parameters of the methods that ``&Talker::listen`` names, of the class around; None where it is
        another's."""
        name = pointer.child_by_field_name("argument") if pointer.type == "pointer_expression" else None
        if name is None or name.type != "qualified_identifier":
            return None
        parts = [part.name for part in self._kinds.names.parts(name)]
        own = self._kinds.classes.get(self._kinds.owner)
        if own is None or not own.is_whole or parts[-2:-1] != [self._kinds.owner] or len(parts) != 2:
            return None
        return own.methods.get(parts[-1], [])

    def _callback_type(self, name: str, wanted: tuple[str, ...], parameter: Node) -> None:
        """The message of a callback, or the request, is of another type."""
        kind = self._kinds.of_type(parameter.child_by_field_name("type"))
        if kind is None or not is_interface(kind.path):
            return
        wanted = wanted if name == "create_subscription" else (*wanted, "Request")
        if is_interface(wanted) and kind.path != wanted:
            self._note("callback type", parameter, "::".join(wanted), "::".join(kind.path))


def _is_first(text: str) -> bool:
    match = _PLACEHOLDER.fullmatch(text)
    return match is not None and match[1] == "1"


__all__ = ["CREATED", "NUMBERS", "RefusedEndpoints"]

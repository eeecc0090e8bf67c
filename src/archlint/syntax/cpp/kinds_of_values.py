"""The types of variables and values in C++, as far as the file writes them."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.syntax.cpp.declared import declared
from archlint.syntax.cpp.kinds import Kind, is_interface
from archlint.syntax.cpp.kinds_of_classes import NODES, KindsOfClasses
from archlint.syntax.cpp.kinds_of_types import MOST_INSIDE
from archlint.syntax.cpp_uses import ITEM, Holder

if TYPE_CHECKING:
    from tree_sitter import Node

    from archlint.syntax.cpp.declared import Declared
    from archlint.syntax.cpp.names import Names
    from archlint.syntax.cpp.source import SourceText

_MAKERS: dict[tuple[str, str], Holder] = {("std", "make_shared"): "shared", ("std", "make_unique"): "unique"}
_WRAPPED = ("rclcpp_action", "ClientGoalHandle", "WrappedResult")
_OF_ITEMS = frozenset({"at", "front", "back"})


class Kinds(KindsOfClasses):
    """The types of the names of one file, in the scopes around what is being read."""

    def __init__(self, source: SourceText, names: Names) -> None:
        super().__init__(source, names)
        self.scopes: list[dict[str, Kind | None]] = []
        self.owner = ""
        """The class whose method is being read."""

    def declare(self, node: Node, *, unknown: bool = False) -> None:
        """The variables of a declaration, a parameter or a condition."""
        for variable in declared(node, self.names, self.source):
            kind = None if unknown else self._of_declared(variable, node.child_by_field_name("type"))
            for name in (variable.name, *variable.bound):
                if name and self.scopes:
                    self.scopes[-1][name] = None if variable.bound else kind

    def _of_declared(self, variable: Declared, type_: Node | None) -> Kind | None:
        if type_ is None or type_.type != "placeholder_type_specifier":
            return self.of_variable(variable, type_)
        kind = self.of(variable.value)
        return kind if not variable.is_pointer or (kind is not None and kind.holder == "raw") else None

    def declare_item(self, loop: Node) -> None:
        """The variable of a loop over a container."""
        type_, right = loop.child_by_field_name("type"), loop.child_by_field_name("right")
        for variable in declared(loop, self.names, self.source):
            kind = None
            if type_ is not None and type_.type != "placeholder_type_specifier":
                kind = self._of_declared(variable, type_)
            elif right is not None and not variable.is_pointer:
                around = self.of(right)
                kind = None if around is None else around.with_member(ITEM, self.source.span(right))
            for name in (variable.name, *variable.bound):
                if self.scopes:
                    self.scopes[-1][name] = None if variable.bound else kind

    def variable(self, name: str) -> Kind | None:
        """What is known of a name: a variable, or a field of the class whose method this is."""
        for scope in reversed(self.scopes):
            if name in scope:
                return scope[name]
        return self.field(name)

    def is_local(self, name: str) -> bool:
        return any(name in scope for scope in self.scopes)

    def field(self, name: str) -> Kind | None:
        if not self.owner:
            return None
        if self.owner not in self.classes:
            return Kind((name,), owner=self.owner)
        own_class = self.classes[self.owner]
        return None if own_class is None else own_class.fields.get(name)

    def of(self, node: Node | None) -> Kind | None:
        """The kind of a value."""
        if node is None or self._inside > MOST_INSIDE:
            return None
        self._inside += 1
        try:
            return self._of(node)
        finally:
            self._inside -= 1

    def _of(self, node: Node) -> Kind | None:
        match node.type:
            case "identifier":
                return self.variable(self.source.text(node))
            case "parenthesized_expression":
                return self.of(node.named_children[0]) if len(node.named_children) == 1 else None
            case "pointer_expression":
                return self._pointed(node)
            case "field_expression":
                return self._member(node)
            case "subscript_expression":
                around = self.of(node.child_by_field_name("argument"))
                return None if around is None else around.with_member(ITEM, self.source.span(node))
            case "compound_literal_expression":
                return self.of_type(node.child_by_field_name("type"))
            case "new_expression":
                kind = self.of_type(node.child_by_field_name("type"))
                return None if kind is None or kind.holder else replace(kind, holder="raw")
            case "call_expression":
                return self._result(node)
            case "this":
                return Kind((self.owner,), "raw") if self.owner else None
        return None

    def _pointed(self, node: Node) -> Kind | None:
        kind = self.of(node.child_by_field_name("argument"))
        if kind is None or kind.members or kind.owner:
            return None
        if node.children[0].type == "&":
            return None if kind.holder else replace(kind, holder="raw")
        return replace(kind, holder="") if kind.holder in ("shared", "unique", "raw") else None

    def _member(self, node: Node) -> Kind | None:
        argument, name = node.child_by_field_name("argument"), node.child_by_field_name("field")
        if argument is None or name is None or name.type != "field_identifier":
            return None
        if argument.type == "this":
            return self.field(self.source.text(name))
        kind = self.of(argument)
        operator = next((child.type for child in node.children if child.type in (".", "->")), "")
        if kind is None or not operator:
            return None
        if kind.path == _WRAPPED and not kind.members and self.source.text(name) == "result":
            return Kind((*kind.of, "Result"), "shared")
        return kind.with_member(operator + self.source.text(name), self.source.span(name))

    def _result(self, node: Node) -> Kind | None:
        function, arguments = node.child_by_field_name("function"), node.child_by_field_name("arguments")
        if function is None or arguments is None:
            return None
        if function.type == "field_expression":
            name = function.child_by_field_name("field")
            kind = self.of(function.child_by_field_name("argument"))
            method = "" if name is None else self.source.text(name)
            return None if kind is None else self._result_of(kind, method, node)
        if function.type not in ("qualified_identifier", "identifier", "template_function"):
            return None
        parts = self.parts(function)
        path = tuple(part.name for part in parts)
        if path == ("std", "move") and len(arguments.named_children) == 1:
            return self.of(arguments.named_children[0])
        if len(path) == 2 and (path[0], path[1]) in _MAKERS and parts[1].arguments:
            kind = self.of_type(parts[1].arguments[0])
            holder = _MAKERS[path[0], path[1]]
            return None if kind is None or kind.holder else replace(kind, holder=holder)
        is_type = is_interface(path) or (len(path) == 1 and path[0] in self.classes and not self.is_local(path[0]))
        if is_type or path in NODES or path == ("std", "string"):
            return Kind(path)
        if len(path) > 1 and path[:-1] in NODES and path[-1] == "make_shared":
            return Kind(path[:-1], "shared")
        return None

    def _result_of(self, kind: Kind, method: str, node: Node) -> Kind | None:
        """What a method of a container, a pointer, a client or a goal gives."""
        if method in _OF_ITEMS:
            return kind.with_member(ITEM, self.source.span(node))
        if kind.members or kind.owner:
            return None
        if method == "get" and kind.holder in ("shared", "unique", "future"):
            return replace(kind, holder="shared" if kind.holder == "future" else "raw")
        if method == "async_send_request" and kind.path == ("rclcpp", "Client"):
            return Kind((*kind.of, "Response"), "future")
        if method == "get_goal" and kind.path == ("rclcpp_action", "ServerGoalHandle"):
            return Kind((*kind.of, "Goal"), "shared")
        return None


__all__ = ["Kinds"]

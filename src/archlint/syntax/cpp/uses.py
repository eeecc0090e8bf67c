"""What the functions of a C++ file ask of messages, and what they give rclcpp.

Only what a compiler sees in any case counts: nothing behind a condition of the preprocessor, and nothing of a function
that the grammar does not understand in full.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.syntax.cpp.kinds import Kind, is_interface, plain
from archlint.syntax.cpp.kinds_of_values import Kinds
from archlint.syntax.cpp.refused_uses import RefusedUses
from archlint.syntax.cpp_uses import CALLED, MemberUse, RefusedUse, Role, TypedField

if TYPE_CHECKING:
    from tree_sitter import Node

    from archlint.syntax.cpp.names import Names
    from archlint.syntax.cpp.source import SourceText

_SCOPES = frozenset(
    {"compound_statement", "for_statement", "if_statement", "while_statement", "switch_statement", "catch_clause"}
    | {"case_statement", "do_statement"}
)
_DECLARES = frozenset({"declaration", "parameter_declaration", "optional_parameter_declaration"})
_LEAVES = frozenset(
    {"identifier", "field_identifier", "type_identifier", "namespace_identifier", "primitive_type", "comment", "this"}
    | {"number_literal", "string_literal", "string_content", "char_literal", "true", "false", "null", "auto"}
    | {"qualified_identifier", "template_type", "placeholder_type_specifier", "type_qualifier", "access_specifier"}
    | {"preproc_include", "preproc_def", "preproc_function_def", "using_declaration", "alias_declaration"}
)
"""What has nothing inside that asks a message for something."""
_MOST_INSIDE = 150
"""How deep nodes may be nested."""


def uses_of(source: SourceText, names: Names, root: Node) -> tuple[list[MemberUse], list[TypedField], list[RefusedUse]]:
    """What is asked of messages in a file, the fields of its classes that are messages, and what is refused."""
    walk = _Walk(source, names)
    walk.kinds.note(root)
    walk.visit(root, 0)
    fields = [
        TypedField(owner, name, list(kind.path), kind.holder)
        for owner, cls in walk.kinds.classes.items()
        if cls is not None
        for name, kind in cls.fields.items()
        if kind is not None and is_interface(kind.path)
    ]
    return walk.asked, fields, walk.refused.found


class _Walk:
    def __init__(self, source: SourceText, names: Names) -> None:
        self.source = source
        self.kinds = Kinds(source, names)
        self.refused = RefusedUses(source, self.kinds, self._ask)
        self.asked: list[MemberUse] = []
        self._conditions = 0

    def visit(self, node: Node, depth: int) -> None:
        if depth > _MOST_INSIDE:
            return
        kind = node.type
        if kind in ("function_definition", "lambda_expression"):
            self._function(node, depth)
        elif kind in ("class_specifier", "struct_specifier"):
            self._class(node, depth)
        elif kind.startswith("preproc_if") and not _is_guard(node):
            self._conditions += 1
            self._children(node, depth)
            self._conditions -= 1
        elif kind in _SCOPES:
            self.kinds.scopes.append({})
            self._children(node, depth)
            self.kinds.scopes.pop()
        elif kind == "for_range_loop":
            self._loop(node, depth)
        elif kind in _DECLARES:
            self._children(node, depth)
            if self._conditions == 0:
                self.refused.typed(node)
                if kind == "declaration":
                    self.refused.declaration(node)
            self.kinds.declare(node, unknown=self._conditions > 0)
        else:
            if kind == "field_expression":
                self._asks(node)
            elif kind == "user_defined_literal" and self._is_judged():
                self.refused.unit(node)
            elif kind == "field_declaration" and self._conditions == 0:
                self.refused.typed(node)
            elif kind == "call_expression" and self._is_judged():
                self.refused.call(node)
            elif kind == "assignment_expression" and self._is_judged():
                self.refused.assignment(node)
            self._children(node, depth)

    def _children(self, node: Node, depth: int) -> None:
        for child in node.named_children:
            if child.type not in _LEAVES:
                self.visit(child, depth + 1)

    def _is_judged(self) -> bool:
        return self._conditions == 0 and bool(self.kinds.scopes)

    # ------------------------------------------------------------------------------------------------ scopes

    def _class(self, node: Node, depth: int) -> None:
        name = node.child_by_field_name("name")
        outer, scopes = self.kinds.owner, self.kinds.scopes
        self.kinds.owner = "" if name is None else self.source.text(name)
        self.kinds.scopes = []
        self._children(node, depth)
        self.kinds.owner, self.kinds.scopes = outer, scopes

    def _function(self, node: Node, depth: int) -> None:
        body, declarator = node.child_by_field_name("body"), node.child_by_field_name("declarator")
        is_lambda = node.type == "lambda_expression"
        if body is None or (node.has_error and not is_lambda):
            return
        outer, scopes = self.kinds.owner, self.kinds.scopes
        if not is_lambda:
            named = _declarator_of(declarator)
            self.kinds.owner = _class_of(named, self.source) or self.kinds.owner
            self.kinds.scopes = []
            declarator = named
            if self._conditions == 0:
                self.refused.constructor(node, named)
        self.kinds.scopes = [*self.kinds.scopes, {}]
        for capture in plain(node.named_children)[:1] if is_lambda else ():
            for row in capture.named_children:
                if row.type == "lambda_capture_initializer" and row.named_children:
                    self.kinds.scopes[-1][self.source.text(row.named_children[0])] = None
        parameters = None if declarator is None else declarator.child_by_field_name("parameters")
        for parameter in () if parameters is None else parameters.named_children:
            if parameter.type in _DECLARES:
                self.kinds.declare(parameter, unknown=self._conditions > 0)
        for child in node.named_children:
            if child != declarator and (child == body or child.type == "field_initializer_list"):
                self.visit(child, depth + 1)
        self.kinds.owner, self.kinds.scopes = outer, scopes

    def _loop(self, node: Node, depth: int) -> None:
        right, body = node.child_by_field_name("right"), node.child_by_field_name("body")
        self.kinds.scopes.append({})
        if right is not None:
            self.visit(right, depth + 1)
        self.kinds.declare_item(node)
        if body is not None:
            self.visit(body, depth + 1)
        self.kinds.scopes.pop()

    # ---------------------------------------------------------------------------------------------- members

    def _asks(self, node: Node) -> None:
        """Note what is asked of a message, unless more of it is asked behind it."""
        around = node.parent
        if not self._is_judged() or around is None or around.type == "field_expression":
            return
        kind = self.kinds.of(node)
        if kind is None or not kind.members:
            return
        if around.type == "call_expression" and around.child_by_field_name("function") == node:
            name, span = kind.members[-1]
            kind = Kind(kind.path, kind.holder, (*kind.members[:-1], (name + CALLED, span)), kind.owner)
        self._ask(kind)

    def _ask(self, kind: Kind, role: Role = "") -> None:
        if not kind.members or not (kind.owner or kind.is_interface):
            return
        members = list(kind.members)
        if kind.owner:
            self.asked.append(MemberUse([], "", members, kind.owner, kind.path[0], role))
        else:
            self.asked.append(MemberUse(list(kind.path), kind.holder, members, role=role))


def _declarator_of(node: Node | None) -> Node | None:
    """The declarator with the parameters of a function."""
    while node is not None and node.type != "function_declarator":
        node = node.child_by_field_name("declarator") or next(
            (child for child in node.named_children if child.type.endswith("_declarator")), None
        )
    return node


def _class_of(declarator: Node | None, source: SourceText) -> str:
    """The class that a function defined outside of it is a method of."""
    name = None if declarator is None else declarator.child_by_field_name("declarator")
    if name is None or name.type != "qualified_identifier":
        return ""
    scope, inner = name.child_by_field_name("scope"), name.child_by_field_name("name")
    while inner is not None and inner.type == "qualified_identifier":
        scope, inner = inner.child_by_field_name("scope"), inner.child_by_field_name("name")
    if scope is None or scope.type == "template_type":
        return "?"
    return source.text(scope)


def _is_guard(node: Node) -> bool:
    """Whether a condition is the one around a header, which holds when it is read first."""
    name = node.child_by_field_name("name")
    if name is None or node.children[0].type != "#ifndef":
        return False
    defined = next((child for child in node.named_children if child.type == "preproc_def"), None)
    own = None if defined is None else defined.child_by_field_name("name")
    return (
        own is not None and own.text == name.text and node.parent is not None and node.parent.type == "translation_unit"
    )


__all__ = ["uses_of"]

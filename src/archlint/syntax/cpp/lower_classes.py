"""Classes and enums of C++ lowered to :mod:`archlint.syntax.facts`."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from archlint.syntax import facts
from archlint.syntax.cpp import calls
from archlint.syntax.cpp.declared import Declared, declared
from archlint.syntax.cpp.known_names import FIELD, FIELDS, GIVEN, SEQUENCES
from archlint.syntax.cpp.lower_expressions import given
from archlint.syntax.cpp.lower_functions import BASES, FunctionLowering, function_declarator
from archlint.syntax.cpp.names import DEFINED, FunctionScope, Names, Part

if TYPE_CHECKING:
    from tree_sitter import Node

    from archlint.syntax.cpp.source import SourceText
    from archlint.syntax.facts import Argument, Expr, Param, Span, Stmt


class ClassLowering(FunctionLowering):
    """Lowers classes, too."""

    def __init__(self, source: SourceText, names: Names) -> None:
        super().__init__(source, names)
        self._statements |= {
            "class_specifier": self._class,
            "struct_specifier": self._class,
            "enum_specifier": self._enum,
        }

    def _class(self, node: Node, body: list[Stmt]) -> None:
        name, block = node.child_by_field_name("name"), node.child_by_field_name("body")
        if block is None:
            return
        own, span = self.names.parts(node)[-1].name, self.source.span(node)
        outer = (self._template_parameters, self._class_parameters, self.names.class_parameters)
        self._class_parameters, self._template_parameters = self._template_parameters, []
        numbered = enumerate(self._class_parameters)
        self.names.class_parameters = {row.name: calls.of_class(own, at) for at, row in numbered}
        clauses = [child for child in node.named_children if child.type == "base_class_clause"]
        bases = [base for clause in clauses for base in clause.named_children if base.type in _TYPES]
        written = [self.lower(base) for base in bases]
        inner, fields, has_constructor = self._members(block, own)
        inner.append(self._method(FIELDS, [], [*self._arguments_of(bases, own, span), *fields], span))
        inner.append(self._method(BASES, [], self._plain_bases(written, span), span))
        if not has_constructor:
            named = [] if bases or node.type != "struct_specifier" else _names_of(fields)
            inner += self._constructors(own, block, [self.names.parts(base) for base in bases], named, span)
        self._template_parameters, self._class_parameters, self.names.class_parameters = outer
        body.append(facts.Class(own, given(written), inner, [], span, self.source.span(name or node)))

    def _members(self, block: Node, own: str) -> tuple[list[Stmt], list[Stmt], bool]:
        """The statements of a class body, those that set its fields, and whether it declares a constructor."""
        inner: list[Stmt] = []
        fields: list[Stmt] = []
        has_constructor = False
        for member in _members_of(block):
            match member.type:
                case "field_declaration" | "declaration":
                    has_constructor |= self._is_constructor(member, own)
                    self._field_declaration(member, own, inner, fields)
                case "function_definition":
                    has_constructor |= self._is_constructor(member, own)
                    self._function_of(member, own, inner)
                case "template_declaration":
                    outer, self._template_parameters = self._template_parameters, self.template_parameters(member)
                    for child in member.named_children:
                        if child.type == "function_definition":
                            has_constructor |= self._is_constructor(child, own)
                            self._function_of(child, own, inner)
                    self._template_parameters = outer
                case _:
                    self.statement(member, inner)
        return inner, fields, has_constructor

    def _is_constructor(self, node: Node, own: str) -> bool:
        declarator = function_declarator(node)
        name = None if declarator is None else declarator.child_by_field_name("declarator")
        return name is not None and self.source.text(name) == own

    def _field_declaration(self, node: Node, own: str, inner: list[Stmt], fields: list[Stmt]) -> None:
        kind = node.child_by_field_name("type")
        if kind is not None and kind.type in DEFINED:
            self.statement(kind, inner)
        is_static = any(child.type == "storage_class_specifier" and child.text == b"static" for child in node.children)
        with self.names.function(FunctionScope(own)):
            for variable in declared(node, self.names, self.source):
                if variable.is_function:
                    self._note_defaults(variable, own, inner)
                if variable.is_function or not variable.name:
                    continue
                outer, self.before = self.before, []
                span = self.source.span(node)
                parts = [] if kind is None else self.names.written(self.names.parts(kind))
                value = self._object(FIELD, variable, parts, span) or self._initial(variable, kind)
                if is_static and variable.value is None:
                    self.before = outer
                    continue  # its definition stands elsewhere
                target = facts.Name(variable.name, variable.span)
                if is_static:
                    inner.extend((*self.before, facts.Assign([target], value, span)))
                else:
                    of_self = facts.Attribute(facts.Name("self", span), variable.name, variable.span)
                    fields.extend((*self.before, facts.Assign([of_self], value, span)))
                    fields.extend(self._class_of_items(variable, parts))
                self.before = outer

    def _class_of_items(self, variable: Declared, parts: Sequence[Part]) -> list[Stmt]:
        """What the objects in a container are, which other files fill."""
        kind = self.kind_of_items(parts[-1]) if parts and parts[-1].name in SEQUENCES else []
        if not kind or not self.is_class(kind):
            return []
        span = variable.span
        target = facts.Attribute(facts.Name("self", span), calls.of_items(variable.name), span)
        return [facts.Assign([target], self.names.resolve(kind, span), span)]

    def _note_defaults(self, variable: Declared, own: str, inner: list[Stmt]) -> None:
        """The default arguments of a method that is defined elsewhere."""
        name = "__init__" if variable.name == own else variable.name
        call = self.declared_as(name, variable)
        if len(call.args) > _UNSAID:
            inner.append(facts.Expression(call, variable.span))

    def _default_constructor(self, own: str, fields: Sequence[str], span: Span) -> Stmt:
        """What C++ makes for a class without a constructor; ``Limits{1, 2}`` gives its fields values."""
        types, kept = self._of_templates(own, span)
        params = [facts.Param(name, "normal", facts.Literal(None, span)) for name in fields]
        itself = facts.Name("self", span)
        filled: list[Stmt] = []
        for name in fields:
            words = (itself, facts.Literal(name, span), facts.Name(name, span), facts.Name(fields[0], span))
            value = facts.Call(self.names.library(GIVEN, span), given(words), span)
            filled.append(facts.Assign([facts.Attribute(itself, name, span)], value, span))
        body = [*kept, self._calls(own, FIELDS, span), self._calls(own, BASES, span), *filled]
        return self._method("__init__", [*params, *types], body, span)

    def _constructors(
        self, own: str, block: Node, bases: Sequence[list[Part]], fields: Sequence[str], span: Span
    ) -> list[Stmt]:
        """What C++ makes for a class without one: one that may be given the fields, or those of a base, ``using
        Base::Base``."""
        for member in _members_of(block):
            named = [part for child in member.named_children for part in self.names.parts(child)]
            if member.type == "using_declaration" and len(named) > 1 and named[-1].name == named[-2].name:
                base = next((base for base in bases if base[-1].name == named[-1].name), named[:-1])
                return self._inherited(own, self.names.written(base), span)
        return [self._default_constructor(own, fields, span)]

    def _inherited(self, own: str, base: list[Part], span: Span) -> list[Stmt]:
        """Constructors that pass on what they are given."""
        if not self.is_node(base):
            passed_on = facts.Argument(facts.Name("arguments", span), None, "*")
            return [self._passes_on(own, base, [facts.Param("arguments", "star")], [passed_on], span)]
        return [
            self._passes_on(
                own,
                base,
                [facts.Param(word, "normal") for word in words],
                [facts.Argument(facts.Name(word, span), word) for word in words],
                span,
            )
            for words in _OF_NODES
        ]

    def _passes_on(
        self, own: str, base: list[Part], params: Sequence[Param], arguments: Sequence[Argument], span: Span
    ) -> Stmt:
        called = facts.Attribute(self.names.resolve(base, span), "__init__", span)
        call = facts.Call(called, [facts.Argument(facts.Name("self", span)), *arguments], span)
        types, kept = self._of_templates(own, span)
        body = [*kept, self._calls(own, FIELDS, span), facts.Expression(call, span)]
        return self._method("__init__", [*params, *types], body, span)

    def _arguments_of(self, bases: Sequence[Node], own: str, span: Span) -> list[Stmt]:
        """The template arguments of the bases of a class, which its objects keep."""
        itself = facts.Name("self", span)
        kept: list[Stmt] = []
        with self.names.function(FunctionScope(own)):
            for base in bases:
                written = self.names.parts(base)
                last = (self.names.templates.get(written[0].name, written) if len(written) == 1 else written)[-1]
                for at, argument in enumerate(last.arguments):
                    target = facts.Attribute(itself, calls.of_class(last.name, at), span)
                    kept.append(facts.Assign([target], self.lower_type(argument), span))
        return kept

    def _plain_bases(self, bases: list[Expr], span: Span) -> list[Stmt]:
        return [
            facts.Expression(
                facts.Call(facts.Attribute(base, "__init__", span), given([facts.Name("self", span)]), span), span
            )
            for base in bases
            if not isinstance(base, facts.Opaque)
        ]

    def _enum(self, node: Node, body: list[Stmt]) -> None:
        """Numbers by name; those of an enum without ``class`` stand beside it, too."""
        name, block = node.child_by_field_name("name"), node.child_by_field_name("body")
        if block is None:
            return
        span, number = self.source.span(node), 0
        members: list[Stmt] = []
        for child in block.named_children:
            member = child.child_by_field_name("name") if child.type == "enumerator" else None
            if member is None:
                continue
            value = child.child_by_field_name("value")
            lowered = facts.Literal(number, span) if value is None else self.lower(value)
            number = int(lowered.number) + 1 if lowered.number is not None else number + 1
            at = self.source.span(child)
            members.append(facts.Assign([facts.Name(self.source.text(member), at)], lowered, at))
        if name is not None or (node.parent is not None and node.parent.type == "type_definition"):
            own = self.names.parts(node)[-1].name
            body.append(facts.Class(own, [], members, [], span, self.source.span(name or node)))
        if not any(child.type in ("class", "struct") for child in node.children):
            body.extend(members)


_UNSAID = 2
"""The arguments of a declaration that says nothing of defaults."""
MOST_FIELDS = 20
"""Structures with more fields are no rows of a table."""


def _names_of(fields: Sequence[Stmt]) -> list[str]:
    """The fields that a class gives values."""
    names = [
        row.targets[0].attr
        for row in fields
        if isinstance(row, facts.Assign) and isinstance(row.targets[0], facts.Attribute)
    ]
    return names if len(names) <= MOST_FIELDS else []


def _members_of(block: Node) -> list[Node]:
    """The members of a class, those behind conditions of the preprocessor, too."""
    members: list[Node] = []
    for node in block.named_children:
        members.extend(_members_of(node) if node.type in ("preproc_if", "preproc_ifdef", "preproc_else") else [node])
    return members


_OF_NODES = (("node_name",), ("node_name", "rclcpp_options"), ("node_name", "namespace", "rclcpp_options"))
"""What the constructors of a node take; the second argument of two may be a namespace, too."""
_TYPES = frozenset({"type_identifier", "qualified_identifier", "template_type"})

__all__ = ["ClassLowering"]

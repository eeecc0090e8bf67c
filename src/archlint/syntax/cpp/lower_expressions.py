"""Expressions of C++ lowered to :mod:`archlint.syntax.facts`."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

from archlint.syntax import facts
from archlint.syntax.cpp.known_names import TYPE_OF
from archlint.syntax.cpp.literals import CONSTANTS, SECONDS, character_of, number_of, text_of
from archlint.syntax.cpp.names import Names
from archlint.syntax.expressions import BooleanOperator
from archlint.syntax.facts import Argument

if TYPE_CHECKING:
    from tree_sitter import Node

    from archlint.syntax.cpp.source import SourceText
    from archlint.syntax.facts import Expr, Span, Stmt

MAX_DEPTH = 150
"""Deepest nesting of expressions that is kept."""

_BINARY: dict[str, facts.BinaryOperator] = {
    **{"+": "+", "-": "-", "*": "*", "/": "/", "%": "%"},
    **{"<<": "<<", ">>": ">>", "&": "&", "|": "|", "^": "^"},
}
_WRAPPERS = frozenset({"decay_t", "remove_reference_t", "remove_cv_t", "remove_cvref_t", "remove_const_t"})
"""Templates of the standard library that give a type without ``const`` and ``&``."""
_OF_PAIR = {"first": 0, "second": 1}
_COMPARE: dict[str, facts.CompareOperator] = {"==": "==", "!=": "!=", "<": "<", "<=": "<=", ">": ">", ">=": ">="}


class ExpressionLowering:
    """Lowers the expressions of one file."""

    def __init__(self, source: SourceText, names: Names) -> None:
        self.source = source
        self.names = names
        self.before: list[Stmt] = []
        """What has to stand in front of the statement that is being lowered: the functions that lambdas are, and what
        calls write into their arguments."""
        self._depth = 0
        self._kinds: dict[str, Callable[[Node, Span], Expr]] = {
            "string_literal": self._string,
            "raw_string_literal": self._string,
            "concatenated_string": self._concatenated,
            "number_literal": self._number,
            "char_literal": self._character,
            "user_defined_literal": self._with_suffix,
            "true": lambda node, span: facts.Literal(True, span),
            "false": lambda node, span: facts.Literal(False, span),
            "null": lambda node, span: facts.Literal(None, span),
            "nullptr": lambda node, span: facts.Literal(None, span),
            "this": lambda node, span: facts.Name("self", span),
            "identifier": self._identifier,
            "field_identifier": self._identifier,
            "type_identifier": self._identifier,
            "qualified_identifier": self._qualified,
            "template_function": self._qualified,
            "template_type": self._qualified,
            "type_descriptor": self._qualified,
            "dependent_name": self._qualified,
            "field_expression": self._field,
            "subscript_expression": self._subscript,
            "binary_expression": self._binary,
            "unary_expression": self._unary,
            "pointer_expression": self._pointer,
            "parenthesized_expression": self._inner,
            "condition_clause": self._condition,
            "conditional_expression": self._conditional,
            "assignment_expression": self._assignment,
            "cast_expression": self._value_of,
            "initializer_list": self._list,
            "initializer_pair": self._value_of,
            "comma_expression": self._comma,
            "co_await_expression": self._inner,
        }

    def lower(self, node: Node) -> Expr:
        """The value of an expression; what is not understood is opaque."""
        lowering = self._kinds.get(node.type)
        span = self.source.span(node)
        if lowering is None or self._depth >= MAX_DEPTH:
            return facts.Opaque(node.type.replace("_", " "), span)
        self._depth += 1
        try:
            return lowering(node, span)
        finally:
            self._depth -= 1

    def lower_type(self, node: Node) -> Expr:
        """A template argument.  The namespace of an interface may be an alias that a header has."""
        parts = self.names.parts(node) if node.type in ("type_descriptor", "qualified_identifier") else []
        if len(parts) == 2 and self.names.may_be_elsewhere(parts[0].name):
            return facts.Name(f"{parts[0].name}::{parts[1].name}", self.source.span(node))
        inner = self._inner_type(node)
        if inner.type == "decltype" and inner.named_child_count == 1:
            span = self.source.span(inner)
            value = self.lower(inner.named_children[0])
            return facts.Call(self.names.library(TYPE_OF, span), [Argument(value)], span)
        return self.lower(inner)

    def _inner_type(self, node: Node) -> Node:
        """The type in ``std::decay_t<T>`` and the like; any other is itself."""
        inner = node.child_by_field_name("type") if node.type == "type_descriptor" else node
        if inner is None:
            return node
        parts = self.names.parts(inner) if inner.type in ("qualified_identifier", "template_type") else []
        is_wrapped = bool(parts) and parts[-1].name in _WRAPPERS and len(parts[-1].arguments) == 1
        return self._inner_type(parts[-1].arguments[0]) if is_wrapped else inner if inner.type == "decltype" else node

    def lower_all(self, nodes: Sequence[Node]) -> list[Expr]:
        return [self.lower(node) for node in nodes if node.type != "comment"]

    def lower_field(self, node: Node, name: str) -> Expr:
        """A part of a node, by the name that the grammar has for it."""
        part = node.child_by_field_name(name)
        return facts.Opaque(node.type.replace("_", " "), self.source.span(node)) if part is None else self.lower(part)

    # ------------------------------------------------------------------------------------------- literals

    def _string(self, node: Node, span: Span) -> Expr:
        text = text_of(self.source.text(node))
        return facts.Opaque("a text", span) if text is None else facts.Literal(text, span)

    def _concatenated(self, node: Node, span: Span) -> Expr:
        parts = [self.lower(child) for child in node.named_children if child.type != "comment"]
        texts = [part.text for part in parts]
        if None not in texts:
            return facts.Literal("".join(text or "" for text in texts), span)
        fields: list[str | facts.Field] = [part.text or facts.Field(part) for part in parts]
        return facts.FormatString(fields, span)

    def _number(self, node: Node, span: Span) -> Expr:
        number = number_of(self.source.text(node))
        return facts.Opaque("a number", span) if number is None else facts.Literal(number, span)

    def _character(self, node: Node, span: Span) -> Expr:
        character = character_of(self.source.text(node))
        return facts.Opaque("a character", span) if character is None else facts.Literal(character, span)

    def _with_suffix(self, node: Node, span: Span) -> Expr:
        """``500ms`` is a number of seconds, ``"text"s`` a text."""
        value, suffix = node.named_children[0], self.source.text(node.named_children[-1])
        if value.type in ("string_literal", "raw_string_literal"):
            return self.lower(value) if suffix in ("s", "sv") else facts.Opaque("a literal", span)
        number = number_of(self.source.text(value))
        if number is None or suffix not in SECONDS:
            return facts.Opaque("a literal", span)
        return facts.Literal(number * SECONDS[suffix], span)

    # --------------------------------------------------------------------------------------------- names

    def _identifier(self, node: Node, span: Span) -> Expr:
        text = self.source.text(node)
        number = CONSTANTS.get(text)
        return self.names.plain(text, span) if number is None else facts.Literal(number, span)

    def _qualified(self, node: Node, span: Span) -> Expr:
        return self.names.resolve(self.names.parts(node), span)

    def _field(self, node: Node, span: Span) -> Expr:
        field, owner = node.child_by_field_name("field"), node.child_by_field_name("argument")
        looked_up = None if owner is None or field is None or field.text != b"second" else self.looked_up(owner, span)
        if looked_up is not None:
            return looked_up
        value = self.lower_field(node, "argument")
        if field is None:
            return value
        name = self.names.parts(field)[-1].name
        if isinstance(value, facts.Name) and name in _OF_PAIR and self.names.is_pair(value.id):
            return facts.Subscript(value, facts.Literal(_OF_PAIR[name], span), span)
        looked_for = self.names.found_in(value.id) if isinstance(value, facts.Name) and name in _OF_PAIR else None
        if looked_for is not None:
            return facts.Subscript(*looked_for, span) if name == "second" else looked_for[1]
        return facts.Attribute(value, name, span)

    def looked_up(self, node: Node, span: Span) -> Expr | None:
        """``names.find(key)->second`` is what the map has for the key."""
        called, listed = node.child_by_field_name("function"), node.child_by_field_name("arguments")
        if called is None or listed is None or called.type != "field_expression" or listed.named_child_count != 1:
            return None
        field, owner = called.child_by_field_name("field"), called.child_by_field_name("argument")
        if field is None or owner is None or field.text != b"find":
            return None
        return facts.Subscript(self.lower(owner), self.lower(listed.named_children[0]), span)

    # ------------------------------------------------------------------------------------------ operators

    def _subscript(self, node: Node, span: Span) -> Expr:
        value, indices = self.lower_field(node, "argument"), node.child_by_field_name("indices")
        values = [] if indices is None else self.lower_all(indices.named_children)
        return facts.Subscript(value, values[0], span) if len(values) == 1 else facts.Opaque("an item", span)

    def operator(self, node: Node) -> str:
        """The operator of an expression, as it is written."""
        operator = node.child_by_field_name("operator")
        return "" if operator is None else self.source.text(operator)

    def _binary(self, node: Node, span: Span) -> Expr:
        word = self.operator(node)
        left, right = self.lower_field(node, "left"), self.lower_field(node, "right")
        if word in _COMPARE:
            return facts.Compare(left, [_COMPARE[word]], [right], span)
        if word in ("&&", "||", "and", "or"):
            joined: BooleanOperator = "and" if word in ("&&", "and") else "or"
            flat = left.values if isinstance(left, facts.Boolean) and left.op == joined else [left]
            return facts.Boolean(joined, [*flat, right], span)
        if word in _BINARY:
            return facts.Binary(_BINARY[word], left, right, span)
        return facts.Opaque(f"the operator {word}", span)

    def _unary(self, node: Node, span: Span) -> Expr:
        value = self.lower_field(node, "argument")
        match self.operator(node):
            case "!" | "not":
                return facts.Unary("not", value, span)
            case "-":
                return facts.Unary("-", value, span)
            case "+":
                return value
            case "~":
                return facts.Unary("~", value, span)
        return facts.Opaque("an operator", span)

    def _pointer(self, node: Node, span: Span) -> Expr:
        """``*x`` and ``&x`` are what they point to, to those who ask for names."""
        return self.lower_field(node, "argument")

    def _inner(self, node: Node, span: Span) -> Expr:
        inner = [child for child in node.named_children if child.type != "comment"]
        return self.lower(inner[0]) if len(inner) == 1 else facts.Opaque("an expression", span)

    def _condition(self, node: Node, span: Span) -> Expr:
        value = node.child_by_field_name("value")
        if value is None or value.type == "declaration":
            return facts.Opaque("a condition", span)
        return self.lower(value)

    def _conditional(self, node: Node, span: Span) -> Expr:
        test = self.lower_field(node, "condition")
        return facts.Conditional(
            test, self.lower_field(node, "consequence"), self.lower_field(node, "alternative"), span
        )

    def _assignment(self, node: Node, span: Span) -> Expr:
        """An assignment inside an expression."""
        target, value = self.lower_field(node, "left"), self.lower_field(node, "right")
        operator = node.child_by_field_name("operator")
        self.note_assigned(target)
        if operator is not None and self.source.text(operator) != "=":
            return facts.Opaque("an assignment", span)
        return facts.Assigned(target, value, span) if is_target(target) else value

    def note_assigned(self, target: Expr) -> None:
        """A variable is assigned by the function that is being lowered."""
        if isinstance(target, facts.Name) and self.names.scopes:
            self.names.scopes[-1].assigned.add(target.id)
            self.names.forget_found(target.id)

    def _list(self, node: Node, span: Span) -> Expr:
        return facts.Sequence("list", self.lower_all(node.named_children), span)

    def _value_of(self, node: Node, span: Span) -> Expr:
        """``.rate = 10`` of an object that is made field by field."""
        return self.lower_field(node, "value")

    def _comma(self, node: Node, span: Span) -> Expr:
        """``a, b``: both are worked out, and the last is the value."""
        first = self.lower_field(node, "left")
        if not isinstance(first, (facts.Literal, facts.Opaque, facts.Name, facts.Implicit)):
            self.before.append(facts.Expression(first, span))
        return self.lower_field(node, "right")


def is_target(value: Expr) -> bool:
    """Whether something can be assigned to."""
    return isinstance(value, (facts.Name, facts.Implicit, facts.Attribute, facts.Subscript))


def given(values: Sequence[Expr]) -> list[Argument]:
    """Arguments without keywords, those of a parameter pack among them."""
    return [
        Argument(value.value, None, "*") if isinstance(value, facts.Starred) else Argument(value) for value in values
    ]


__all__ = ["ExpressionLowering", "given", "is_target"]

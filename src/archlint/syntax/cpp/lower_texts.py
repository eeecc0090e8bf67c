"""Statements of C++ that change a text in place, lowered to :mod:`archlint.syntax.facts`."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from archlint.syntax import facts
from archlint.syntax.cpp.inner_scopes import original
from archlint.syntax.cpp.lower_declarations import DeclarationLowering
from archlint.syntax.cpp.lower_expressions import given, is_target

if TYPE_CHECKING:
    from tree_sitter import Node

    from archlint.syntax.facts import Span, Stmt

_CHANGES_TEXT = frozenset(
    {"append", "assign", "clear", "erase", "insert", "pop_back", "push_back", "replace", "resize", "str", "swap"}
)
"""Methods that change a ``std::string`` in place, and what a stream is given a new text with."""
_CHANGES_NUMBERS = frozenset({"hex", "oct", "showbase", "showpos", "showpoint", "uppercase", "fixed", "scientific"})
"""What a stream is told to write numbers in another way; ``setw`` and the like stand for themselves."""
_PRINTS = {"sprintf": 1, "std::sprintf": 1, "snprintf": 2, "std::snprintf": 2}
"""Functions that write a text, and where its pattern stands among their arguments."""


class TextLowering(DeclarationLowering):
    """Lowers what changes texts, too."""

    def written_text(self, node: Node, span: Span) -> Stmt | None:
        """``text.append("more")``, and ``snprintf(text, size, "cam_%d", number)``."""
        called, listed = node.child_by_field_name("function"), node.child_by_field_name("arguments")
        if node.type != "call_expression" or called is None or listed is None:
            return None
        nodes = [child for child in listed.named_children if child.type != "comment"]
        name, method = self._method_called(node)
        if method:
            is_added = method in ("append", "push_back") and len(nodes) == 1 and self.names.is_text(name)
            return facts.Augmented(facts.Name(name, span), "+", self.lower(nodes[0]), span) if is_added else None
        copying = self.source.text(called).removeprefix("std::")
        if copying in ("strcpy", "strncpy", "strcat") and len(nodes) > 1:
            target = self.lower(nodes[0])
            self.note_assigned(target)
            if copying == "strcat" and is_target(target):
                return facts.Augmented(target, "+", self.lower(nodes[1]), span)
            return facts.Assign([target], self.lower(nodes[1]), span) if is_target(target) else None
        first = _PRINTS.get(self.source.text(called))
        if first is None or len(nodes) <= first:
            return None
        target, pattern, *values = [self.lower(node) for node in (nodes[0], *nodes[first:])]
        self.note_assigned(target)
        if pattern.text is not None:  # Python knows no size of a number
            pattern = facts.Literal(re.sub(r"(%[-+ #0-9.]*)(?:hh|h|ll|l|z|j|t)([diuoxX])", r"\1\2", pattern.text), span)
        text = facts.Binary("%", pattern, facts.Sequence("tuple", values, span), span)
        return facts.Assign([target], text if values else pattern, span) if is_target(target) else None

    def changed_text(self, node: Node) -> str | None:
        """The variable whose text becomes another one in a way that is not followed: ``text.push_back(c)``, or a stream
        that a fold writes to, ``(stream << ... << values)``."""
        name, method = self._method_called(node)
        if method:
            is_changed = method in _CHANGES_TEXT and (self.names.is_text(name) or self.names.is_stream(name))
            return name if is_changed else None
        is_fold = node.type == "fold_expression" and node.named_children
        name = self.source.text(node.named_children[0]) if is_fold else ""
        return name if self.names.is_stream(name) else None

    def change(self, name: str, node: Node, span: Span, in_loop: bool) -> Stmt:
        """The statement that changes such a variable."""
        listed = node.child_by_field_name("arguments")
        nodes = [] if listed is None else [child for child in listed.named_children if child.type != "comment"]
        method = self._method_called(node)[1]
        value: facts.Expr = facts.Opaque("a text that is changed in place", span)
        if not in_loop and method and self.names.is_text(name):
            called = facts.Attribute(facts.Name(name, span), method, span)
            return facts.Expression(facts.Call(called, given(self.lower_all(nodes)), span), span)
        if not in_loop and method == "str" and len(nodes) == 1:
            value = self.lower(nodes[0])
        return facts.Assign([facts.Name(name, span)], value, span)

    def read_into(self, node: Node, body: list[Stmt]) -> None:
        """``stream >> first >> second``: what stands in them now comes from outside."""
        before = node.child_by_field_name("left")
        if before is not None and before.type == "binary_expression":
            self.read_into(before, body)
        target, span = self.lower_field(node, "right"), self.source.span(node)
        self.note_assigned(target)
        if is_target(target):
            body.append(facts.Assign([target], facts.Opaque("what is read from a stream", span), span))

    def items_written(
        self, loop: Node, item: facts.Expr, container: facts.Expr, inner: list[Stmt], span: Span
    ) -> tuple[list[Stmt], list[Stmt]]:
        """What stands before and behind a loop that changes the items which it goes through:
        ``for (auto & name : names) { name = prefix + name; }``."""
        block, declarator = loop.child_by_field_name("body"), loop.child_by_field_name("declarator")
        is_reference = declarator is not None and declarator.type == "reference_declarator"
        if block is None or not is_reference or not isinstance(item, facts.Name) or not is_target(container):
            return [], []
        written, name = self.source.text(block), re.escape(original(item.id))
        if re.search(rf"(?<![\w.>]){name}(?:\s*\+?=(?!=)|\.(?:append|insert|replace)\()", written) is None:
            return [], []
        self.note_assigned(container)
        if re.search(r"\b(?:continue|break|return|throw)\b", written):
            return [], [facts.Assign([container], facts.Opaque("items that a loop changes", span), span)]
        changed = facts.Name(f"changed_{span[0]}_{span[1]}", span)
        self.names.declare(changed.id)
        added = facts.Call(facts.Attribute(changed, "append", span), given([item]), span)
        inner.append(facts.Expression(added, span))
        return [facts.Assign([changed], facts.Sequence("list", [], span), span)], [
            facts.Assign([container], changed, span)
        ]

    def _method_called(self, node: Node) -> tuple[str, str]:
        """What a method is called of and its name, as they are written; two empty texts for anything else."""
        called = node.child_by_field_name("function") if node.type == "call_expression" else None
        if called is None or called.type != "field_expression":
            return "", ""
        owner, field = called.child_by_field_name("argument"), called.child_by_field_name("field")
        return ("", "") if owner is None or field is None else (self.source.text(owner), self.source.text(field))

    def streamed(self, node: Node, span: Span, body: list[Stmt]) -> bool:
        """``stream << "a" << b``: the text grows."""
        parts: list[Node] = []
        while node.type == "binary_expression" and self.operator(node) == "<<":
            left, right = node.child_by_field_name("left"), node.child_by_field_name("right")
            if left is None or right is None:
                return False
            parts.append(right)
            node = left
        name = self.source.text(node)
        if not parts or not self.names.is_stream(name):
            return False
        if any(self.source.text(part).removeprefix("std::") in _CHANGES_NUMBERS for part in parts):
            unknown = facts.Opaque("a number that a stream writes in another way", span)
            body.append(facts.Augmented(facts.Name(name, span), "+", unknown, span))
            return True
        fields: list[str | facts.Field] = [facts.Field(self.lower(part)) for part in reversed(parts)]
        value = facts.FormatString(
            [field.value.text or field for field in fields if isinstance(field, facts.Field)], span
        )
        body.append(facts.Augmented(facts.Name(name, span), "+", value, span))
        return True


__all__ = ["TextLowering"]

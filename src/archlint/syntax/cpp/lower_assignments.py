"""Assignments of C++ lowered to :mod:`archlint.syntax.facts`: what is assigned is a copy, and a text has places."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import TYPE_CHECKING

from archlint.syntax import facts
from archlint.syntax.cpp.declared import declared
from archlint.syntax.cpp.inner_scopes import original
from archlint.syntax.cpp.known_names import COPY, PARTS
from archlint.syntax.cpp.lower_expressions import is_target
from archlint.syntax.cpp.lower_texts import TextLowering

if TYPE_CHECKING:
    from tree_sitter import Node

    from archlint.syntax.facts import Expr, Span, Stmt

_AUGMENTED: dict[str, facts.BinaryOperator] = {"+=": "+", "-=": "-", "*=": "*", "/=": "/", "%=": "%"}
_CASES = re.compile(r"(?:std::|::)?to(?:upper|lower)\b")
_CHARACTERS = frozenset({"char_literal"})


class AssignmentLowering(TextLowering):
    """Lowers assignments, too."""

    def assign(self, node: Node, span: Span, body: list[Stmt]) -> None:
        tied = self.tied(node.child_by_field_name("left"), span)
        target, value = tied or self.lower_field(node, "left"), self.lower_field(node, "right")
        operator, right = node.child_by_field_name("operator"), node.child_by_field_name("right")
        word = "=" if operator is None else self.source.text(operator)
        self.note_assigned(target)
        if tied is not None:
            value = facts.Call(self.names.library(PARTS, span), [facts.Argument(value)], span)
            body.append(facts.Assign([tied], value, span))
        elif isinstance(target, facts.Conditional):  # ``(is_left ? first : second) = value``
            either = [each for each in (target.body, target.orelse) if is_target(each)]
            body += [facts.Assign([each], facts.Opaque("one of two that is assigned", span), span) for each in either]
        elif not is_target(target):
            body.append(facts.Expression(value, span))
        elif isinstance(target, facts.Subscript) and is_target(target.value) and self._is_character(target, right):
            changed = facts.Opaque("a text of which a character is changed", span)
            body.append(facts.Assign([target.value], changed, span))
        elif word == "=":
            targets: list[Expr] = [target]
            while isinstance(value, facts.Assigned):  # a = b = c
                targets, value = [*targets, value.target], value.value
            body.append(facts.Assign(targets, self._of_its_own(targets, value, span), span))
        elif word in _AUGMENTED:
            body.append(facts.Augmented(target, _AUGMENTED[word], value, span))
        else:
            body.append(facts.Assign([target], facts.Opaque(f"the operator {word}", span), span))

    def _is_character(self, target: facts.Subscript, value: Node | None) -> bool:
        """Whether a character of a text is assigned, as far as the types of the file say."""
        if isinstance(target.value, facts.Name) and self.names.is_text(target.value.id):
            return True
        return value is not None and (value.type in _CHARACTERS or _CASES.match(self.source.text(value)) is not None)

    def _of_its_own(self, targets: Sequence[Expr], value: Expr, span: Span) -> Expr:
        """What is assigned, as a copy where one side is a variable that holds an object and no pointer to one."""
        if not is_target(value) or not any(map(self._is_of_object, (*targets, value))):
            return value
        return facts.Call(self.names.library(COPY, span), [facts.Argument(value)], span)

    def _is_of_object(self, value: Expr) -> bool:
        return isinstance(value, facts.Name) and self.names.is_object(value.id)

    def swapped(self, node: Node, span: Span) -> Stmt | None:
        """``first.swap(second)`` as ``first, second = second, first``; None for any other call."""
        function, listed = node.child_by_field_name("function"), node.child_by_field_name("arguments")
        if function is None or listed is None or function.type != "field_expression" or listed.named_child_count != 1:
            return None
        method = function.child_by_field_name("field")
        if method is None or self.source.text(method) != "swap":
            return None
        both = [self.lower_field(function, "argument"), self.lower(listed.named_children[0])]
        if not all(map(is_target, both)):
            return None
        for each in both:
            self.note_assigned(each)
        swapped = facts.Sequence("tuple", both[::-1], span)
        return facts.Assign([facts.Sequence("tuple", both, span)], swapped, span)

    def own_copies(self, declarator: Node | None, block: Node | None) -> list[Stmt]:
        """The parameters of a function that are objects of its own, where it does something with them: what it
        changes of them, its caller does not see."""
        listed = None if declarator is None else declarator.child_by_field_name("parameters")
        if listed is None or block is None:
            return []
        written = self.source.text(block)
        copies: list[Stmt] = []
        for node in listed.named_children:
            own = node.child_by_field_name("declarator") if node.type == "parameter_declaration" else None
            kind = node.child_by_field_name("type")
            if own is None or kind is None or own.type != "identifier" or b"const" in (node.text or b"").split():
                continue
            for variable in declared(node, self.names, self.source):
                is_used = re.search(rf"(?<![\w.>]){re.escape(original(variable.name))}\s*[.\[]", written)
                if is_used and self.is_object(variable, self.names.parts(kind), kind):
                    name = facts.Name(variable.name, variable.span)
                    value = facts.Call(self.names.library(COPY, name.span), [facts.Argument(name)], name.span)
                    copies.append(facts.Assign([name], value, name.span))
        return copies


__all__ = ["AssignmentLowering"]

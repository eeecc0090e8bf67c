"""What the standard library of C++ does with containers, texts and optional values, lowered to facts."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from archlint.syntax import facts
from archlint.syntax.cpp import calls
from archlint.syntax.cpp.known_names import CHANGING, COPY, ITEM, PUT, SUBSTRING, VALUE_OR
from archlint.syntax.cpp.lower_expressions import given, is_target
from archlint.syntax.cpp.lower_objects import ObjectLowering

if TYPE_CHECKING:
    from tree_sitter import Node

    from archlint.syntax.cpp.names import Part
    from archlint.syntax.facts import Expr, Span

_PUTS = frozenset(
    {"assign", "insert", "emplace", "try_emplace", "insert_or_assign", "push", "push_front", "emplace_front"}
)
"""Methods that put something into a container, other than at its end."""
_PUTS_AT_END = frozenset({"push_back", "emplace_back"})
_OF_TEXTS = {"starts_with": "startswith", "ends_with": "endswith"}
_FINDS = {"find_first_of": "find", "find_last_of": "rfind"}
"""Methods that find one of several characters: of one, they find the text."""


class MethodLowering(ObjectLowering):
    """Lowers calls of such methods."""

    def standard_method(self, value: Expr, name: str, values: Sequence[Expr], span: Span) -> Expr | None:
        """A call of a method that containers, texts or optional values have; None for any other."""
        if name in ("assign", "insert") and (whole := _whole(values[-2:])) is not None:
            values = [*values[:-2], whole]
        if (name in _PUTS and values) or (name in _PUTS_AT_END and len(values) > 1):
            listed = given([value, facts.Literal(name, span), *values])
            return facts.Call(self.names.library(PUT, span), listed, span)
        if name == "substr" and 0 < len(values) < 3:
            return facts.Call(self.names.library(SUBSTRING, span), given([value, *values]), span)
        if name == "value_or" and len(values) == 1:
            return facts.Call(self.names.library(VALUE_OR, span), given([value, *values]), span)
        if name == "has_value" and not values:
            return facts.Compare(value, ["is not"], [facts.Literal(None, span)], span)
        renamed = _OF_TEXTS.get(name, _FINDS.get(name, ""))
        is_one = name not in _FINDS or (len(values) == 1 and len(values[0].text or "") == 1)
        if renamed and is_one and len(values) == 1:
            return facts.Call(facts.Attribute(value, renamed, span), given(values), span)
        return None

    def held_from_now(self, pointer: Expr, arguments: Node, span: Span) -> Expr | None:
        """``pointer.reset(new Node("a"))``: what a smart pointer holds from now on; None for any other ``reset()``."""
        nodes = [argument for argument in arguments.named_children if argument.type != "comment"]
        if len(nodes) != 1 or nodes[0].type != "new_expression" or not is_target(pointer):
            return None
        self.note_assigned(pointer)
        return facts.Assigned(pointer, self.lower(nodes[0]), span)

    def write(self, target: Expr, value: Expr, span: Span) -> None:
        """A call writes into its argument."""
        self.note_assigned(target)
        self.before.append(facts.Assign([target], value, span))

    def algorithm(self, path: str, arguments: Node, span: Span) -> Expr | None:
        """``std::for_each(names.begin(), names.end(), open)`` calls a function with each item; ``std::replace`` and the
        like change what they are given.  None for any other function."""
        nodes = [argument for argument in arguments.named_children if argument.type != "comment"]
        out = next((inner for node in nodes[1:] if (inner := self._inserted_into(node)) is not None), None)
        changed = CHANGING.get(path)
        if changed is not None and len(nodes) > changed:
            target = self.lower(self._begun(nodes[changed]) or nodes[changed])
            if is_target(target):
                self.write(target, facts.Opaque("a text that is changed in place", span), span)
        if path in ("std.swap", "std.exchange") and len(nodes) == 2:
            return self._swapped(path, self.lower(nodes[0]), self.lower(nodes[1]), span)
        container = self._begun(nodes[0]) if nodes else None
        if path.startswith("std.ranges.") and nodes:
            container = nodes[0]
        name = path.removeprefix("std.ranges.").removeprefix("std.")
        if name not in ("for_each", "transform", "copy") or container is None:
            if out is not None:
                self.write(self.lower(out), facts.Opaque("what is inserted into a container", span), span)
            return None
        items, function = self.lower(container), self.lower(nodes[-1])
        item = facts.Name(f"item_{span[0]}_{span[1]}", span)
        self.names.declare(item.id)
        result: Expr = item if name == "copy" else facts.Call(function, given([item]), span)
        if out is not None:
            listed = given([self.lower(out), facts.Literal("insert", span), result])
            result = facts.Call(self.names.library(PUT, span), listed, span)
        self.before.append(facts.For(item, items, [facts.Expression(result, span)], [], False, span))
        return facts.Opaque(path, span)

    def _swapped(self, path: str, first: Expr, second: Expr, span: Span) -> Expr | None:
        """``std::swap(first, second)``, and ``std::exchange(first, second)``, which gives the first back."""
        if not is_target(first) or (path == "std.swap" and not is_target(second)):
            return None
        if path == "std.exchange":
            self.write(first, second, span)
            return facts.Opaque("what a variable held before", span)
        self.note_assigned(second)
        self.write(facts.Sequence("tuple", [first, second], span), facts.Sequence("tuple", [second, first], span), span)
        self.note_assigned(first)
        return facts.Opaque(path, span)

    def standard_algorithm(self, name: str, arguments: Node) -> str:
        """The path of an algorithm that is called by its name alone: the compiler finds it by the iterators that it is
        given.  Empty for any other function."""
        nodes = [argument for argument in arguments.named_children if argument.type != "comment"]
        is_given = bool(nodes) and (self._begun(nodes[0]) is not None or any(map(self._inserted_into, nodes[1:])))
        known = name in ("for_each", "transform", "copy", "copy_if") or f"std.{name}" in CHANGING
        return f"std.{name}" if known and is_given and not self.names.is_variable(name) else ""

    def _inserted_into(self, node: Node) -> Node | None:
        """The container of ``std::back_inserter(names)``."""
        called = node.child_by_field_name("function") if node.type == "call_expression" else None
        listed = node.child_by_field_name("arguments")
        if called is None or listed is None or not listed.named_child_count:
            return None
        is_inserter = self.names.parts(called)[-1].name in ("inserter", "back_inserter", "front_inserter")
        return listed.named_children[0] if is_inserter else None

    def _begun(self, node: Node) -> Node | None:
        """The container of ``names.begin()``."""
        called = node.child_by_field_name("function") if node.type == "call_expression" else None
        field = None if called is None else called.child_by_field_name("field")
        is_begin = field is not None and self.source.text(field) in ("begin", "cbegin")
        return called.child_by_field_name("argument") if called is not None and is_begin else None

    def items_given(self, owner: Node | None, part: Part, nodes: Sequence[Node]) -> list[Expr]:
        """What a method is given: ``rows.push_back({"left", 1})`` makes an object of what ``rows`` holds."""
        name = "" if owner is None else self.source.text(owner)
        nodes = [node for node in nodes if node.type != "comment"]
        if not name or part.name != "push_back" or len(nodes) != 1:
            return self.lower_all(nodes)
        kind, span = self.names.item_kinds.get(name, []), self.source.span(nodes[0])
        if nodes[0].type == "identifier" and kind:  # the container holds objects, and so a copy
            return [facts.Call(self.names.library(COPY, span), given(self.lower_all(nodes)), span)]
        if nodes[0].type != "initializer_list":
            return self.lower_all(nodes)
        if kind:
            return [self._item(kind, nodes[0], span)]
        if not self.names.is_in_method or self.names.is_variable(name):
            return self.lower_all(nodes)
        which = (facts.Name("self", span), facts.Literal(calls.of_items(name.removeprefix("this->")), span))
        listed = [*given(which), *self._given_to_class(nodes[0])]
        return [facts.Call(self.names.library(ITEM, span), listed, span)]

    def note_items(self, name: str, parts: Sequence[Part]) -> None:
        """Take note of what a container holds, where that are objects of a class."""
        kind = self.kind_of_items(parts[-1]) if parts else []
        of_pointers = bool(parts) and any("*" in self.source.text(node) for node in parts[-1].arguments)
        if kind and not of_pointers and self.is_class(kind):
            self.names.item_kinds[name] = kind


def _whole(values: Sequence[Expr]) -> Expr | None:
    """The container of ``names.begin(), names.end()``."""
    match values:
        case [facts.Call(func=facts.Attribute() as begin), facts.Call(func=facts.Attribute() as end)]:
            is_whole = begin.attr in ("begin", "cbegin") and end.attr in ("end", "cend")
            return begin.value if is_whole and _is_same(begin.value, end.value) else None
    return None


def _is_same(first: Expr, second: Expr) -> bool:
    """Whether two expressions are the same variable."""
    match first, second:
        case facts.Name(id=name), facts.Name(id=other):
            return name == other
        case facts.Implicit(name=name), facts.Implicit(name=other):
            return name == other
        case facts.Attribute(attr=name), facts.Attribute(attr=other):
            return name == other and _is_same(first.value, second.value)
    return False


__all__ = ["MethodLowering"]

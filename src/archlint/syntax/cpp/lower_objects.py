"""New objects of C++ lowered to :mod:`archlint.syntax.facts`."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

from archlint.syntax import facts
from archlint.syntax.cpp import calls
from archlint.syntax.cpp.known_names import (
    DURATIONS,
    IN_PYTHON,
    INTERFACE_KINDS,
    MAPS,
    NUMBER,
    PARAMETER_TYPES,
    RATIOS,
    SEQUENCES,
    THREADS,
)
from archlint.syntax.cpp.lower_expressions import given
from archlint.syntax.cpp.lower_macros import MacroLowering
from archlint.syntax.cpp.names import Names, Part
from archlint.syntax.facts import Argument

if TYPE_CHECKING:
    from tree_sitter import Node

    from archlint.syntax.cpp.source import SourceText
    from archlint.syntax.facts import Expr, Span

OF_NUMBERS: dict[str, Callable[[float], float]] = {"BOOL": bool, "DOUBLE": float, "INTEGER": int}
"""What a type makes of a number, by the type of a parameter that it is."""


class ObjectLowering(MacroLowering):
    """Lowers what makes objects, too."""

    def __init__(self, source: SourceText, names: Names) -> None:
        super().__init__(source, names)
        self._kinds |= {"new_expression": self._new, "compound_literal_expression": self._compound}

    def _new(self, node: Node, span: Span) -> Expr:
        kind, arguments = node.child_by_field_name("type"), node.child_by_field_name("arguments")
        return facts.Opaque("a new object", span) if kind is None else self.construct(kind, arguments, span)

    def _compound(self, node: Node, span: Span) -> Expr:
        """``Point{1, 2}``."""
        kind = node.child_by_field_name("type")
        return (
            facts.Opaque("a value", span)
            if kind is None
            else self.construct(kind, node.child_by_field_name("value"), span)
        )

    def construct(self, kind: Node, arguments: Node | None, span: Span) -> Expr:
        """An object of a type; ``arguments`` is a list in brackets or braces, None where there is none."""
        return self.construct_parts(self.names.parts(kind), arguments, span)

    def construct_parts(self, parts: list[Part], arguments: Node | None, span: Span) -> Expr:
        """As :meth:`construct`, of a name in parts."""
        parts = self.names.written(parts)
        if len(parts) == 1:
            parts = self.names.templates.get(parts[0].name, parts)
        path = self.names.path(parts)
        if path:
            return self.constructed(path, parts[-1], arguments, span)
        if parts and parts[-1].name in self.names.enums and arguments is not None and arguments.named_child_count == 1:
            return self.lower(arguments.named_children[0])
        cls = self.names.resolve(parts, span)
        values = [] if arguments is None else self._given_to_class(arguments)
        if isinstance(cls, facts.Name) and "::msg::" in cls.id:
            return facts.Call(cls, [], span)  # how a message is filled matters to nobody here
        types = [self.lower_type(argument) for argument in parts[-1].arguments] if parts else []
        return facts.Call(cls, [*values, *calls.template_arguments(types)], span)

    def _given_to_class(self, arguments: Node) -> list[Argument]:
        """What an object is made of; ``{.low = 1}`` says by name which field it is for."""
        listed: list[Argument] = []
        for node in [child for child in arguments.named_children if child.type != "comment"]:
            designator = node.child_by_field_name("designator") if node.type == "initializer_pair" else None
            name = None if designator is None else self.source.text(designator).lstrip(".")
            [argument] = given([self.lower(node)])
            listed.append(argument if name is None else Argument(argument.value, name))
        return listed

    def items(self, node: Node, kind: list[Part], span: Span) -> Expr:
        """The list ``{{"left", 1}, {"right", 2}}`` of objects of a type; items that are no objects are as they are."""
        nodes = [child for child in node.named_children if child.type != "comment"]
        inner = nodes[0].named_children if len(nodes) == 1 and nodes[0].type == "initializer_list" else []
        if inner and all(child.type == "initializer_list" for child in inner):
            nodes = list(inner)  # std::array has braces of its own
        return facts.Sequence("list", [self._item(kind, child, span) for child in nodes], span)

    def _item(self, kind: list[Part], node: Node, span: Span) -> Expr:
        if node.type == "initializer_list" and bool(kind) and self.is_class(kind):
            return self.construct_parts(kind, node, span)
        item = self.lower(node)
        is_double = len(kind) == 1 and kind[0].name in ("double", "float")
        return item if item.number is None or not is_double else facts.Literal(item.number, span)

    def number(self, written: str, value: Expr, span: Span) -> Expr:
        """A value that is made a number of a type: ``double(3)``, ``static_cast<int>(rate)``."""
        kind = PARAMETER_TYPES.get("".join(written.split()).removeprefix("std::"), "")
        convert = OF_NUMBERS.get(kind)
        if convert is None or (kind == "BOOL" and value.number is None):
            return value
        if value.number is not None:
            return facts.Literal(convert(value.number), span)
        return facts.Call(self.names.library(NUMBER, span), given([value, facts.Literal(kind, span)]), span)

    def is_class(self, parts: list[Part]) -> bool:
        """Whether a type may be a class of the workspace: not one of a library, a message or a pointer."""
        last = parts[-1].name
        if self.names.path(parts) or any(part.name in INTERFACE_KINDS for part in parts):
            return False
        return last in self.names.classes or (last[:1].isupper() and len(last) > 1 and not last.endswith("Ptr"))

    def constructed(
        self, path: str, last: Part, arguments: Node | None, span: Span, values: list[Expr] | None = None
    ) -> Expr:
        """An object of a library's class, or what its function gives."""
        if path in THREADS and arguments is not None:
            return facts.Call(self.names.library(path, span), given([self.bound(arguments, span)]), span)
        if values is None:
            values = [] if arguments is None else self.lower_all(arguments.named_children)
        if path.startswith("std.") and (collection := self._collection(last, arguments, values, span)) is not None:
            return collection
        if path == "std.optional" and len(values) < 2:
            return values[0] if values else facts.Literal(None, span)
        if path in DURATIONS or path == "std.chrono.duration":
            return self.seconds(path, last, values, span)
        mapped = IN_PYTHON.get(path, "")
        function = self.names.library(path, span)
        if mapped in ("rclpy.node.Node", "rclpy.lifecycle.node.LifecycleNode"):
            return facts.Call(function, calls.node_arguments(values, self.source.words, self.names), span)
        if mapped == "message_filters.Subscriber":
            return self.filtered(last, values, span)
        if mapped == "str":
            if len(values) > 1:
                return facts.Opaque("a text", span)
            return values[0] if values and path != "std.to_string" else facts.Call(function, given(values), span)
        if (
            mapped.startswith("tf2_ros.")
            and mapped.endswith("Listener")
            and (len(values) < 2 or isinstance(values[1], facts.Literal))
        ):
            values = values[:1]  # a listener with a node of its own
        if mapped.endswith("Executor") and not mapped.endswith("MultiThreadedExecutor"):
            values = []
        if path == "rclcpp.Parameter":
            return facts.Call(function, calls.parameter(values), span)
        return facts.Call(function, given(values), span)

    def bound(self, arguments: Node, span: Span) -> Expr:
        """A function with what it is to be called with, of ``(&Talker::run, this, 5)``."""
        raise NotImplementedError

    def note_options(self, name: str, kind: Sequence[Part]) -> None:
        """Take note of a variable or parameter that is an ``rclcpp::NodeOptions``."""
        if kind and kind[-1].name == "NodeOptions" and self.names.scopes:
            self.names.scopes[-1].options.add(name)

    def seconds(self, path: str, last: Part, values: Sequence[Expr], span: Span) -> Expr:
        """``std::chrono::milliseconds(5)``, ``std::chrono::duration<double, std::milli>(5)`` as a number of seconds."""
        ratio = self.source.text(last.arguments[1]) if len(last.arguments) > 1 else ""
        unit = DURATIONS.get(path, 1.0) if not ratio else RATIOS.get(ratio.removeprefix("std::"))
        if len(values) != 1 or unit is None:
            return facts.Opaque("a duration", span)
        number = values[0].number
        if number is not None:
            return facts.Literal(number * unit, span)
        return values[0] if unit == 1.0 else facts.Binary("*", values[0], facts.Literal(unit, span), span)

    def _collection(self, last: Part, arguments: Node | None, values: list[Expr], span: Span) -> Expr | None:
        """A container of the standard library; None for anything else."""
        inner = [] if arguments is None else arguments.named_children
        if len(inner) == 1 and arguments is not None and arguments.type != inner[0].type == "initializer_list":
            arguments = inner[0]  # std::vector<double>({1, 2})
        is_listed = arguments is not None and arguments.type == "initializer_list"
        if last.name in SEQUENCES:
            return (
                self.items(arguments, self.kind_of_items(last), span)
                if arguments is not None and is_listed
                else _sequence(values, span)
            )
        if last.name not in MAPS or arguments is None or not is_listed:
            return None
        return self.mapping(arguments, last, span)

    def kind_of_items(self, container: Part) -> list[Part]:
        """The type of what a container holds; of a map, what it has for a key."""
        at = 1 if container.name in MAPS else 0
        return self.names.parts(container.arguments[at]) if len(container.arguments) > at else []

    def mapping(self, node: Node, container: Part, span: Span) -> Expr:
        """``{{"a", 1}, {"b", 2}}`` of a map."""
        pairs = [child.named_children for child in node.named_children if child.type == "initializer_list"]
        if any(len(pair) != 2 for pair in pairs) or len(pairs) != len(
            [c for c in node.named_children if c.type != "comment"]
        ):
            return facts.Opaque("a map", span)
        kind = self.kind_of_items(container)
        values = [self._item(kind, value, span) for _, value in pairs]
        return facts.Mapping([self.lower(key) for key, _ in pairs], values, span)

    def filtered(self, last: Part, values: Sequence[Expr], span: Span) -> Expr:
        """``message_filters::Subscriber<T>(node, "topic", qos)``."""
        if not last.arguments:
            return facts.Opaque("a subscriber without a type", span)
        kind = self.lower_type(last.arguments[0])
        if len(values) < 2:  # it subscribes later
            return facts.Call(self.names.library("message_filters.cpp.Subscriber", span), [Argument(kind)], span)
        words = ("node", "topic", "qos_profile")
        arguments = [Argument(value, word) for word, value in zip(words, values, strict=False)]
        return facts.Call(
            self.names.library("message_filters.Subscriber", span), [*arguments, Argument(kind, "msg_type")], span
        )


def _sequence(values: list[Expr], span: Span) -> Expr | None:
    """``std::vector<int>({1, 2})``; None for what is made in another way, such as of two iterators."""
    if len(values) == 1 and isinstance(values[0], facts.Sequence):
        return values[0]
    return None if values else facts.Sequence("list", [], span)


__all__ = ["ObjectLowering"]

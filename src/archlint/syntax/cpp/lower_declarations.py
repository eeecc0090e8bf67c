"""Declarations of variables and names of types, lowered to :mod:`archlint.syntax.facts`."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import TYPE_CHECKING

from archlint.syntax import facts
from archlint.syntax.cpp import calls
from archlint.syntax.cpp.declared import Declared, declared, is_pointer
from archlint.syntax.cpp.inner_scopes import changed_through, original
from archlint.syntax.cpp.known_names import (
    COPY,
    DECLARED,
    INTERFACE_KINDS,
    MAPS,
    OBJECT,
    PAIRS_MADE_BY,
    PARTS,
    RMW_PROFILES,
    SEQUENCES,
    STREAMS,
)
from archlint.syntax.cpp.lower_calls import CallLowering
from archlint.syntax.cpp.lower_expressions import is_target
from archlint.syntax.cpp.names import DEFINED, Part

if TYPE_CHECKING:
    from tree_sitter import Node

    from archlint.syntax.facts import Expr, Span, Stmt


class DeclarationLowering(CallLowering):
    """Lowers declarations, too."""

    def declaration(self, node: Node, body: list[Stmt]) -> None:
        kind = node.child_by_field_name("type")
        for variable in declared(node, self.names, self.source):
            if (not variable.name and not variable.bound) or variable.span in self.source.joined:
                continue
            if variable.is_function and not (self.names.scopes and kind is not None and self._are_values(variable)):
                if not self.names.scopes and kind is not None and not variable.owner:
                    self._declare(variable, body)
                continue
            if variable.is_extern and variable.value is None and not self.names.scopes:
                self._declare(variable, body)
                continue
            self.names.forget_found(variable.name)
            value = self._initial(variable, kind)
            self._note_found(variable)
            if variable.bound:
                for name in variable.bound:
                    self.names.declare(name)
                value = facts.Call(self.names.library(PARTS, variable.span), [facts.Argument(value)], variable.span)
                target: Expr = facts.Sequence(
                    "tuple", [facts.Name(n, variable.span) for n in variable.bound], variable.span
                )
            elif variable.owner and (variable.owner in self.names.classes or not variable.owner[:1].islower()):
                target = facts.Attribute(facts.Name(variable.owner, variable.span), variable.name, variable.span)
            else:
                self.names.declare(variable.name)
                target = facts.Name(variable.name, variable.span)
            if not (variable.is_extern and variable.value is None):
                targets = [target]
                if variable.owner and isinstance(target, facts.Name):
                    targets.append(facts.Name(f"{variable.owner}::{variable.name}", variable.span))
                body.append(facts.Assign(targets, value, self.source.span(node)))
                body += self._changed_later(node, variable)

    def _changed_later(self, node: Node, variable: Declared) -> list[Stmt]:
        """What a reference to it or a pointer changes is not known any more."""
        changed = changed_through(node, variable, self.source) if self.names.scopes else None
        target = None if changed is None else self.lower(changed)
        if target is None or not is_target(target):
            return []
        span = self.source.span(node)
        return [facts.Assign([target], facts.Opaque("something that a reference changes", span), span)]

    def statement(self, node: Node, body: list[Stmt]) -> None:
        """Add what a statement is lowered to."""
        raise NotImplementedError

    def _declare(self, variable: Declared, body: list[Stmt]) -> None:
        """A function or variable that is defined in another file, or further down."""
        names = [variable.name, *(f"{space}::{variable.name}" for space in self.names.spaces[-1:])]
        targets: list[Expr] = [facts.Name(name, variable.span) for name in names]
        body.append(facts.Assign(targets, self.declared_as(names[-1], variable), variable.span))

    def declared_as(self, name: str, variable: Declared) -> facts.Call:
        """What a declaration says: a name, of a function how many arguments it takes, and the default ones."""
        nodes = [] if variable.parameters is None else variable.parameters.named_children
        params = [node for node in nodes if node.type in ("parameter_declaration", "optional_parameter_declaration")]
        if [self.source.text(node) for node in params] == ["void"]:
            params = []
        defaults = [value for node in params if (value := node.child_by_field_name("default_value")) is not None]
        given = (facts.Literal(name, variable.span), facts.Literal(len(params), variable.span))
        values = [facts.Argument(value) for value in (*given, *self.lower_all(defaults))]
        return facts.Call(self.names.library(DECLARED, variable.span), values, variable.span)

    def tied(self, node: Node | None, span: Span) -> facts.Sequence | None:
        """The targets of ``std::tie(name, depth) = …``."""
        called = None if node is None or node.type != "call_expression" else node.child_by_field_name("function")
        listed = None if node is None else node.child_by_field_name("arguments")
        if called is None or listed is None or self.names.path(self.names.parts(called)) != "std.tie":
            return None
        values = self.lower_all(listed.named_children)
        targets = [value if _is_variable(value) else facts.Name("std::ignore", span) for value in values]
        for target in targets:
            self.note_assigned(target)
        return facts.Sequence("tuple", targets, span)

    def _are_values(self, variable: Declared) -> bool:
        """Whether what reads like the parameters of a function are arguments: ``rclcpp::Rate rate(hz);``, and
        ``ImageTransport transport(shared_from_this());``, which reads like a function that takes a function."""
        nodes = [] if variable.parameters is None else variable.parameters.named_children
        if not nodes or not all(_reads_like_a_value(node) for node in nodes):
            return False
        variable.value = variable.parameters
        return True

    def _initial(self, variable: Declared, kind: Node | None) -> Expr:
        """What a variable holds at first."""
        parts = [] if kind is None else self.names.written(self.names.parts(kind))
        last = parts[-1] if parts else Part("")
        value, span = variable.value, variable.span
        if last.name in STREAMS and self.names.scopes:
            self.names.scopes[-1].streams.add(variable.name)
            return facts.Literal("", span)
        if last.name == "string" and self.names.scopes and not variable.is_array:
            self.names.scopes[-1].texts.add(variable.name)
        if self.names.scopes and self.is_object(variable, parts, kind):
            self.names.scopes[-1].objects.add(variable.name)
        self.note_options(variable.name, parts)
        self.note_items(variable.name, parts)
        if self.names.scopes and self.names.path(parts) == "rclcpp.Parameter":
            self.names.scopes[-1].parameters.add(variable.name)
        if value is None:
            return self.default_of(parts, variable, span)
        if value.type in ("argument_list", "initializer_list", "parameter_list"):
            return self._braced(variable, parts, kind, value, span)
        copied = self._copied(self.lower(value), span)
        if _is_copy(value, variable, self.source.text):
            return facts.Call(self.names.library(COPY, span), [facts.Argument(copied)], span)
        return copied

    def is_object(self, variable: Declared, parts: list[Part], kind: Node | None) -> bool:
        """Whether a variable is an object of a class, as far as its type is written, and no pointer to one."""
        if kind is None or kind.type not in _OF_CLASSES or variable.is_pointer or not parts:
            return False
        parts = self.names.templates.get(parts[0].name, parts) if len(parts) == 1 else parts
        last = parts[-1].name
        return not (last.lower().endswith(("ptr", "pointer", "iterator")) or is_pointer(parts) or last in _NO_OBJECTS)

    def _note_found(self, variable: Declared) -> None:
        """``auto found = names.find(key);``: ``found->second`` is what the map has for the key."""
        node = variable.value
        if node is None or node.type != "call_expression" or not self.names.scopes:
            return
        looked_up = self.looked_up(node, variable.span)
        if isinstance(looked_up, facts.Subscript):
            self.names.scopes[-1].iterators[variable.name] = looked_up.value, looked_up.index

    def _copied(self, value: Expr, span: Span) -> Expr:
        """A value, as a copy where it is a profile of rmw: a variable that holds it may be changed."""
        if isinstance(value, facts.Name) and value.id in RMW_PROFILES:
            return facts.Call(self.names.library("copy.copy", span), [facts.Argument(value)], span)
        return value

    def _braced(self, variable: Declared, parts: list[Part], kind: Node | None, value: Node, span: Span) -> Expr:
        """``T name(…)`` and ``T name{…}``."""
        last = parts[-1] if parts else Part("")
        inner = [child for child in value.named_children if child.type != "comment"]
        if variable.is_array and last.name == "char" and len(inner) == 1 and inner[0].type.endswith("string_literal"):
            return self.lower(inner[0])
        if last.name in MAPS:
            return self.mapping(value, last, span)
        if last.name == "rmw_qos_profile_t":
            return self._profile(inner, span)
        if last.name in SEQUENCES or variable.is_array:
            of_items = parts if variable.is_array else self.kind_of_items(last)
            is_listed = value.type == "initializer_list"
            return self.items(value, of_items, span) if is_listed else facts.Opaque("a list", span)
        if self.names.path(parts) in PAIRS_MADE_BY and inner:
            return facts.Sequence("tuple", self.lower_all(inner), span)
        smart = last.name in ("shared_ptr", "unique_ptr", "optional", "atomic") or last.name.endswith("Ptr")
        plain = kind is None or kind.type in ("primitive_type", "sized_type_specifier", "placeholder_type_specifier")
        if smart or plain or variable.is_pointer or is_pointer(parts):
            return (
                self.lower(inner[0])
                if len(inner) == 1
                else facts.Literal(None, span)
                if smart or variable.is_pointer
                else facts.Opaque("a value", span)
            )
        assert kind is not None
        return self.construct(kind, value, span)

    def _profile(self, nodes: list[Node], span: Span) -> Expr:
        """``rmw_qos_profile_t profile = {history, depth, reliability, durability, …}``, or a copy of another."""
        if len(nodes) < len(_POLICIES):
            return self._copied(self.lower(nodes[0]), span) if len(nodes) == 1 else facts.Opaque("a profile", span)
        history, depth, reliability, durability = self.lower_all(nodes[: len(_POLICIES)])
        profile: Expr = facts.Call(self.names.library("rclcpp.QoS", span), [facts.Argument(depth)], span)
        for name, policy in (("history", history), ("reliability", reliability), ("durability", durability)):
            setter = facts.Attribute(profile, f"with_{name}", span)
            profile = facts.Call(setter, [facts.Argument(policy)], span)
        return profile

    def default_of(self, parts: list[Part], variable: Declared, span: Span) -> Expr:
        """What a variable or field holds that nothing is assigned to."""
        last = parts[-1].name if parts else ""
        if variable.is_pointer or last in ("shared_ptr", "unique_ptr", "weak_ptr", "optional") or is_pointer(parts):
            return facts.Literal(None, span)
        if last in SEQUENCES and not variable.is_array:
            return facts.Sequence("list", [], span)
        if last in MAPS:
            return facts.Mapping([], [], span)
        if last in _DEFAULT_MADE or self.names.path(parts) in _DEFAULT_MADE:
            return self.construct_parts(parts, None, span)
        path = self.names.path(parts)
        if bool(parts) and not path and len(parts[-1].name) > 1 and self._is_own_class(parts):
            return self.construct_parts(parts, None, span)
        value = self._object(OBJECT, variable, parts, span) if self.names.scopes and not path else None
        return value or facts.Opaque("a variable without a value", span)

    def _object(self, maker: str, variable: Declared, parts: list[Part], span: Span) -> Expr | None:
        """A member or variable that is an object of a class, made later or without arguments; None for any other."""
        if len(parts) == 1:
            parts = self.names.templates.get(parts[0].name, parts)
        if not parts or variable.value is not None or variable.is_pointer or variable.is_array:
            return None
        if self.names.path(parts) not in _MADE_WITH_NODE and not self.is_class(parts):
            return None
        types = [self.lower_type(argument) for argument in parts[-1].arguments]
        arguments = [facts.Argument(self.names.resolve(parts, span)), *calls.template_arguments(types)]
        return facts.Call(self.names.library(maker, span), arguments, span)

    def _is_own_class(self, parts: list[Part]) -> bool:
        """Whether a type is a class of this file, or a message: those are made without arguments."""
        return parts[-1].name in self.names.classes or any(part.name == "msg" for part in parts[:-1])

    def alias(self, node: Node, body: list[Stmt]) -> None:
        name, kind = node.child_by_field_name("name"), node.child_by_field_name("type")
        if name is not None and kind is not None:
            self._name_type(self.source.text(name), kind, self.source.span(node), body)

    def typedef(self, node: Node, body: list[Stmt]) -> None:
        name, kind = node.child_by_field_name("declarator"), node.child_by_field_name("type")
        if name is not None and kind is not None and name.type == "type_identifier":
            if kind.type in DEFINED and kind.child_by_field_name("body") is not None:
                self.statement(kind, body)
                if self.names.parts(kind)[-1].name == self.source.text(name):
                    return
            self._name_type(self.source.text(name), kind, self.source.span(node), body)

    def _name_type(self, name: str, kind: Node, span: Span, body: list[Stmt]) -> None:
        """A name for a type: inside the file it stands for it, outside it is a variable that holds it."""
        parts = self.names.written(self.names.parts(kind))
        if not parts or any(part.arguments for part in parts):
            self.names.declare(name)
            if parts and not self.names.path(parts):
                self.names.templates[name] = parts
            body.append(facts.Assign([facts.Name(name, span)], self._class_with_arguments(parts, span), span))
            return
        meant = [part.name for part in parts]
        if not self.names.scopes and _is_of_ros1(meant, self.names.aliases.get(name, [])):
            return
        value = self.names.resolve(parts, span)
        self.names.aliases[name] = meant
        body.append(facts.Assign([facts.Name(name, span)], value, span))

    def _class_with_arguments(self, parts: list[Part], span: Span) -> Expr:
        """What a name for ``Filter<Ekf>`` is to the files that include it: the class, made with these arguments."""
        if self.names.scopes or not self.is_class(parts) or any(part.arguments for part in parts[:-1]):
            return facts.Opaque("a type", span)
        types = calls.template_arguments([self.lower_type(argument) for argument in parts[-1].arguments])
        template = facts.Argument(self.names.resolve(parts, span))
        return facts.Call(self.names.library("functools.partial", span), [template, *types], span)

    def using(self, node: Node, body: list[Stmt]) -> None:
        names = [part.name for child in node.named_children for part in self.names.parts(child)]
        if any(child.type == "namespace" for child in node.children):
            self.names.opened.append(names)
            if len(names) == 2 and names[-1] in INTERFACE_KINDS:  # whoever includes this file sees them, too
                body.append(facts.ImportFrom(".".join(names), 0, [("*", "*")], self.source.span(node)))
        elif len(names) > 1 and names[-2] != names[-1]:  # not the constructors of a base
            self.names.aliases[names[-1]] = names
            span = self.source.span(node)
            parts = [Part(name) for name in names]
            value = self.names.resolve(parts, span)
            if not self.names.scopes and not (isinstance(value, facts.Name) and value.id == names[-1]):
                body.append(facts.Assign([facts.Name(names[-1], span)], value, span))

    def namespace_alias(self, node: Node, body: list[Stmt]) -> None:
        name, *rest = [part for child in node.named_children for part in self.names.parts(child)]
        if not rest:
            return
        self.names.aliases[name.name] = [part.name for part in rest]
        if rest[-1].name in INTERFACE_KINDS and len(rest) == 2:
            module = ".".join(part.name for part in rest)
            body.append(facts.Import(module, f"{name.name}::", self.source.span(node)))


_OF_CLASSES = frozenset({"type_identifier", "qualified_identifier", "template_type"})
_NO_OBJECTS = frozenset({"string", "string_view", "function", "reference_wrapper", "size_t"})


def _is_variable(value: Expr) -> bool:
    """Whether something is a variable or field that a tuple may be taken apart into; ``std::ignore`` is none."""
    return is_target(value) and not (isinstance(value, facts.Attribute) and value.attr == "ignore")


def _reads_like_a_value(node: Node) -> bool:
    """Whether a parameter without a name may be a value: a name alone, or one that is called."""
    if node.type != "parameter_declaration":
        return False
    declarator = node.child_by_field_name("declarator")
    if declarator is None:
        return node.named_child_count == 1
    parameters = declarator.child_by_field_name("parameters")
    return (
        declarator.type == "abstract_function_declarator"
        and declarator.named_child_count == 1
        and parameters is not None
        and all(_reads_like_a_value(inner) for inner in parameters.named_children)
    )


_POLICIES = ("history", "depth", "reliability", "durability")
"""The fields that ``rmw_qos_profile_t`` begins with.  Source: ``rmw/types.h``."""

_MADE_WITH_NODE = frozenset(
    {
        *("rclcpp.QoS", "image_transport.ImageTransport", "camera_info_manager.CameraInfoManager"),
        *("tf2_ros.TransformBroadcaster", "tf2_ros.StaticTransformBroadcaster"),
    }
)
"""Classes of libraries whose objects the list of a constructor makes."""

_DEFAULT_MADE = frozenset(
    {
        *("rclcpp.executors.SingleThreadedExecutor", "rclcpp.executors.MultiThreadedExecutor"),
        *("rclcpp.executors.StaticSingleThreadedExecutor", "rclcpp.SensorDataQoS", "rclcpp.SystemDefaultsQoS"),
        *("rclcpp.ServicesQoS", "rclcpp.NodeOptions"),
        *("message_filters.Subscriber", "image_transport.SubscriberFilter"),
    }
)


def _is_copy(value: Node, variable: Declared, text: Callable[[Node], str]) -> bool:
    """Whether a variable is an object of its own, made as a copy of another, and something is done with it:
    ``auto latched = qos; latched.transient_local();``.  Of a pointer nothing would be asked with a dot."""
    around = value.parent
    if value.type not in ("identifier", "field_expression") or around is None or around.type != "init_declarator":
        return False
    declarator = around.child_by_field_name("declarator")
    if variable.is_pointer or declarator is None or declarator.type != "identifier":
        return False
    block = around
    while block.parent is not None and block.type != "compound_statement":
        block = block.parent
    name = re.escape(original(variable.name))
    asked = r"\.(?!get\b|reset\b|lock\b|use_count\b)\w|\["
    return re.search(rf"(?<![\w.>]){name}(?:{asked})", text(block)) is not None


def _is_of_ros1(meant: list[str], before: list[str]) -> bool:
    """Whether a name stands for an interface as ROS 1 writes it, ``std_msgs::String``, and another branch of the
    preprocessor gives it the same of ROS 2, ``std_msgs::msg::String``."""
    return len(before) == 3 and before[1] in INTERFACE_KINDS and meant == [before[0], before[2]]


__all__ = ["DeclarationLowering"]

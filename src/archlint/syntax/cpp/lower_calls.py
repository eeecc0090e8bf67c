"""Calls, new objects and lambdas of C++ lowered to :mod:`archlint.syntax.facts`."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from archlint.syntax import facts
from archlint.syntax.cpp import calls
from archlint.syntax.cpp.inner_scopes import copied_by
from archlint.syntax.cpp.known_names import (
    DURATIONS,
    ITSELF,
    MAKERS,
    OF_DOUBLES,
    PAIRS,
    PAIRS_MADE_BY,
    PARAMETER_TYPES,
    SAME,
    SEQUENCES,
    THREADS,
)
from archlint.syntax.cpp.lower_expressions import given
from archlint.syntax.cpp.lower_methods import MethodLowering
from archlint.syntax.cpp.lower_objects import OF_NUMBERS
from archlint.syntax.cpp.names import FunctionScope, Names, Part
from archlint.syntax.facts import Argument

if TYPE_CHECKING:
    from tree_sitter import Node

    from archlint.syntax.cpp.source import SourceText
    from archlint.syntax.facts import Expr, Param, Span, Stmt

_ITSELF = frozenset({"c_str", "str", "get", "data", "value", "lock", "get_rmw_qos_profile", "view", "release"})
"""Methods without arguments that give what they are called on, as far as names are concerned."""
_ENDS = {"front": 0, "back": -1}
"""Methods that give the first and the last item of a container."""
_TEXTS = frozenset({"std.string", "std.to_string"})
_LIST_METHODS = {"push_back": "append", "emplace_back": "append"}
_POLICIES = frozenset({"history", "reliability", "durability", "liveliness", "deadline", "lifespan"})
"""Setters of ``rclcpp::QoS`` that have the names of what they set."""
_PARAMETER_VALUES = frozenset(
    {
        *("as_string", "as_bool", "as_int", "as_double", "as_string_array", "as_bool_array", "as_integer_array"),
        *("as_double_array", "as_byte_array", "get_value", "get_parameter_value"),
    }
)
"""Methods of ``rclcpp::Parameter`` that give its value."""


class CallLowering(MethodLowering):
    """Lowers calls, too."""

    def __init__(self, source: SourceText, names: Names) -> None:
        super().__init__(source, names)
        self._kinds |= {
            "call_expression": self._call,
            "lambda_expression": self._lambda,
            "parameter_declaration": self._parameter_like,
        }

    # --------------------------------------------------------------------------------------------- calls

    def _call(self, node: Node, span: Span) -> Expr:
        function, arguments = node.child_by_field_name("function"), node.child_by_field_name("arguments")
        if function is None or arguments is None:
            return facts.Opaque("a call", span)
        meant = self.macro_value(node, span)
        if meant is not None:
            return meant
        if function.type == "field_expression":
            return self._method_call(function, arguments, span)
        if function.type == "primitive_type":  # int(x)
            values = self.lower_all(arguments.named_children)
            is_one = len(values) == 1
            return self.number(self.source.text(function), values[0], span) if is_one else facts.Opaque("a value", span)
        if function.type in ("identifier", "template_function", "qualified_identifier", "dependent_name"):
            return self._function_call(self.names.parts(function), function, arguments, span)
        return facts.Call(self.lower(function), given(self.lower_all(arguments.named_children)), span)

    def _parameter_like(self, node: Node, span: Span) -> Expr:
        """An argument that reads like the parameter of a function: ``name``, ``name(…)``."""
        kind, declarator = node.child_by_field_name("type"), node.child_by_field_name("declarator")
        arguments = None if declarator is None else declarator.child_by_field_name("parameters")
        if kind is None or arguments is None:
            return self._inner(node, span)
        return self._function_call(self.names.parts(kind), kind, arguments, span)

    def _method_call(self, function: Node, arguments: Node, span: Span) -> Expr:
        owner, field = function.child_by_field_name("argument"), function.child_by_field_name("field")
        if owner is None or field is None:
            return facts.Opaque("a call", span)
        value = self.lower(owner)
        part = self.names.parts(field)[-1]
        if part.name == "reset" and (held := self.held_from_now(value, arguments, span)) is not None:
            return held
        if part.name == "append" and arguments.named_child_count == 1 and self._is_text(owner):
            return facts.Binary("+", value, self.lower(arguments.named_children[0]), span)
        return self._on(value, part, arguments, span, self.source.span(function), owner)

    def _is_text(self, node: Node) -> bool:
        """Whether something is a ``std::string`` for certain."""
        called = node.child_by_field_name("function") if node.type == "call_expression" else None
        if called is None:
            return self.names.is_text(self.source.text(node))
        return called.type == "qualified_identifier" and self.names.path(self.names.parts(called)) in _TEXTS

    def _on(
        self, value: Expr, part: Part, arguments: Node, span: Span, function_span: Span, owner: Node | None = None
    ) -> Expr:
        """A method of a value."""
        values, name = self.items_given(owner, part, arguments.named_children), part.name
        if name in calls.NODE_INTERFACES:
            return value
        types = [self.lower_type(argument) for argument in part.arguments]
        created = self._created(value, name, types, calls.unpacked(values), span)
        if created is not None:
            return created
        if not values:
            plain = self._without_arguments(value, name, span)
            if plain is not None:
                return plain
        other = self._parameter_call(value, name, part, values, span) or self.standard_method(value, name, values, span)
        if other is not None:
            return other
        if name == "add_parameter_callback":
            words = ("parameter_name", "callback", "node_name")
            listed = [facts.Argument(given_as, word) for word, given_as in zip(words, values, strict=False)]
            return facts.Call(facts.Attribute(value, name, function_span), listed, span)
        renamed = f"with_{name}" if name in _POLICIES and len(values) == 1 else _LIST_METHODS.get(name, name)
        method = facts.Attribute(value, renamed, function_span)
        if name == "at" and len(values) == 1:
            return facts.Subscript(value, values[0], span)
        if name in _ENDS and not values:
            return facts.Subscript(value, facts.Literal(_ENDS[name], span), span)
        own = calls.template_arguments(types) if isinstance(value, (facts.Name, facts.Implicit)) else []
        return facts.Call(method, [*given(values), *own], span)

    def _created(
        self, node: Expr, name: str, types: Sequence[Expr], values: Sequence[Expr], span: Span
    ) -> facts.Call | None:
        """A create call on a node; None for what is no such call."""
        if name not in calls.GENERIC:
            return calls.method(node, name, types, values, span)
        if len(values) < 2:
            return None
        interface = self.names.interface_called(values[1].text or "", span)
        return calls.method(node, calls.GENERIC[name], [interface], [values[0], *values[2:]], span)

    def _without_arguments(self, value: Expr, name: str, span: Span) -> Expr | None:
        if name in _PARAMETER_VALUES:
            return facts.Attribute(value, "value", span)
        if name == "get" and isinstance(value, facts.Attribute) and value.attr == "value":
            return value  # the value of a parameter has been taken already
        if name in _ITSELF:
            return value
        if name == "size" or name == "length":
            return facts.Call(facts.Name("len", span), given([value]), span)
        if name == "empty":
            return facts.Unary("not", value, span)
        return None

    def _parameter_call(self, value: Expr, name: str, part: Part, values: Sequence[Expr], span: Span) -> Expr | None:
        """Declaring and reading parameters: C++ hands out values, or writes them into variables."""
        if name == "declare_parameter" and values:
            default = self._default(part, values[1:2], span)
            declared = facts.Call(facts.Attribute(value, name, span), given([values[0], *default]), span)
            return facts.Attribute(declared, "value", span)
        if name == "declare_parameters" and len(values) == 2:
            rows = self._pairs_of(values[1], span)
            return facts.Call(facts.Attribute(value, name, span), given([values[0], rows]), span)
        if name in ("get_parameter_or", "param") and len(values) in (2, 3) and part.arguments:
            values = [*values[:-1], *self._default(part, values[-1:], span)]
        if name == "get_parameter_or" and len(values) == 2:
            other = facts.Call(self.names.library("rclcpp.Parameter", span), calls.parameter(values), span)
            read = facts.Call(facts.Attribute(value, name, span), given([values[0], other]), span)
            return facts.Attribute(read, "value", span)
        if name == "getInput" and len(values) == 2:  # of BehaviorTree.CPP
            self.write(values[1], facts.Opaque("a port of a behaviour tree", span), span)
            return facts.Opaque("whether the port has a value", span)
        if name == "get_parameter" and len(values) == 2:
            read = facts.Call(facts.Attribute(value, name, span), given(values[:1]), span)
            is_parameter = isinstance(values[1], facts.Name) and self.names.is_parameter(values[1].id)
            self.write(values[1], read if is_parameter else facts.Attribute(read, "value", span), span)
            return facts.Opaque("whether there is such a parameter", span)
        if name in ("get_parameter_or", "param") and len(values) == 3:
            other = facts.Call(self.names.library("rclcpp.Parameter", span), calls.parameter(values), span)
            read = facts.Call(facts.Attribute(value, "get_parameter_or", span), given([values[0], other]), span)
            self.write(values[1], facts.Attribute(read, "value", span), span)
            return facts.Opaque("whether there is such a parameter", span)
        return None

    def _pairs_of(self, value: Expr, span: Span) -> Expr:
        """The items of a container whose items are pairs, which those of a map are in C++."""
        if isinstance(value, facts.Sequence):
            return value
        return facts.Call(self.names.library(PAIRS, span), given([value]), span)

    def _default(self, part: Part, values: Sequence[Expr], span: Span) -> list[Expr]:
        """The default of a parameter, as its type takes it, or where there is none the type.

        Source: ``rclcpp/node_impl.hpp``, ``declare_parameter<ParameterT>``.
        """
        of_type = "".join(self.source.text(part.arguments[0]).split()).removeprefix("std::") if part.arguments else ""
        kind = PARAMETER_TYPES.get(of_type, "")
        if not values:
            types = self.names.library("rclcpp.Parameter", span)
            return [facts.Attribute(facts.Attribute(types, "Type", span), kind, span)] if kind else []
        if (number := values[0].number) is not None and of_type:
            convert = OF_NUMBERS.get(kind)
            other = facts.Opaque("a number of another type", span)
            return [other if convert is None else facts.Literal(convert(number), span)]
        match values[0]:
            case facts.Call(func=constructor, args=[]) if constructor.last_name in SEQUENCES:
                return [facts.Sequence("list", [], span)]  # std::vector<std::string>()
            case facts.Sequence(kind=display, elements=elements) if of_type in OF_DOUBLES:
                return [facts.Sequence(display, [_as_double(element, span) for element in elements], span)]
            case facts.Sequence(elements=elements) if of_type and not of_type.startswith(("vector<", "array<")):
                # Braces around what one value is made of.
                return self._default(part, elements, span) if len(elements) == 1 else [facts.Opaque("a value", span)]
        return [self.number(of_type, values[0], span)]

    def _function_call(self, parts: list[Part], function: Node, arguments: Node, span: Span) -> Expr:
        parts = self.names.written(parts)
        path, last = self.names.path(parts), parts[-1]
        path = path or (self.standard_algorithm(last.name, arguments) if len(parts) == 1 else "")
        if path:
            return self._library_call(path, last, arguments, span)
        if last.name in ("make_shared", "make_unique") and len(parts) > 1:
            return self.construct_parts(parts[:-1], arguments, span)
        if len(parts) == 1 and not self.names.is_variable(last.name):
            if self.names.is_in_method and _is_of_node(last.name):
                return self._on(facts.Name("self", span), last, arguments, span, self.source.span(function))
            if last.name in calls.NODE_INTERFACES:
                return facts.Name("self", span)
        if last.name in ("FMT_STRING", "FMT_COMPILE") and arguments.named_child_count == 1:
            return self.lower(arguments.named_children[0])
        if last.name == "RCLCPP_COMPONENTS_REGISTER_NODE" and arguments.named_child_count:
            plugin = facts.Literal("".join(self.source.text(arguments.named_children[0]).split()), span)
            return facts.Call(facts.Name(last.name, span), given([plugin]), span)
        types = [self.lower_type(argument) for argument in last.arguments]
        values = self.lower_all(arguments.named_children)
        called = self.names.resolve(parts, self.source.span(function))
        if isinstance(called, facts.Attribute) and len(parts) > 1:  # Base::method(…), on this very object
            if _is_of_node(last.name):
                return self._on(facts.Name("self", span), last, arguments, span, self.source.span(function))
            values = [self._itself(called.value, span), *values]
        texts = self.texts_given(last.name, arguments) if len(parts) == 1 else []
        return facts.Call(called, [*given(values), *calls.template_arguments(types), *texts], span)

    def _itself(self, cls: Expr, span: Span) -> Expr:
        """What ``Class::method(…)`` is called on."""
        if not self.names.is_in_method:
            return cls
        return facts.Call(self.names.library(ITSELF, span), given([facts.Name("self", span), cls]), span)

    def _library_call(self, path: str, last: Part, arguments: Node, span: Span) -> Expr:
        if path in MAKERS:
            return self.construct(last.arguments[0], arguments, span) if last.arguments else facts.Opaque(path, span)
        if path.endswith((".make_shared", ".make_unique")):
            return self.constructed(path.rpartition(".")[0], last, arguments, span)
        if path == "std.bind":
            return self.bound(arguments, span)
        if path in THREADS:
            return self.constructed(path, last, arguments, span)
        loop = self.algorithm(path, arguments, span)
        if loop is not None:
            return loop
        owner = path.rpartition(".")[0]
        if owner in ("rclcpp.Node", "rclcpp_lifecycle.LifecycleNode") and self.names.is_in_method:
            return self._on(facts.Name("self", span), last, arguments, span, span)
        values = self.lower_all(arguments.named_children)
        if path == "static_cast" and last.arguments and len(values) == 1:
            return self.number(self.source.text(last.arguments[0]), values[0], span)
        if path in SAME:
            return values[0] if values else facts.Opaque(path, span)
        if path in DURATIONS or path == "std.chrono.duration":
            return self.seconds(path, last, values, span)
        types = [self.lower_type(argument) for argument in last.arguments]
        if (
            path == "std.get"
            and len(values) == 1
            and last.arguments
            and (at := self.lower(last.arguments[0]).number) is not None
        ):
            return facts.Subscript(values[0], facts.Literal(int(at), span), span)
        if path == "std.apply" and len(values) == 2:
            return facts.Call(values[0], [Argument(values[1], None, "*")], span)
        if path == "std.invoke" and values:
            return facts.Call(values[0], given(values[1:]), span)
        if path in PAIRS_MADE_BY and values:
            return facts.Sequence("tuple", values, span)
        if path in calls.FREE and values:
            values = calls.without_interfaces(values)
            created = self._created(values[0], calls.FREE[path], types, values[1:], span)
            return created or facts.Opaque(path, span)
        if path in ("rclcpp.init", "rclcpp.shutdown"):
            words = [] if path == "rclcpp.shutdown" else calls.command_line(values, span)
            return facts.Call(self.names.library(path, span), words, span)
        if path in ("rclcpp.create_timer", "rclcpp.create_wall_timer"):
            return calls.free_timer(path, values, span)
        if path in ("rclcpp_action.create_server", "rclcpp_action.create_client"):
            return calls.action(self.names.library(path, span), path.endswith("server"), types, values, span)
        if path in ("fmt.format", "std.format") and values:
            return facts.Call(facts.Attribute(values[0], "format", span), self._formatted(values[1:]), span)
        return self.constructed(path, last, arguments, span, values)

    def _formatted(self, values: Sequence[Expr]) -> list[Argument]:
        """What ``fmt::format`` fills in: ``fmt::arg("name", value)`` by its name."""
        listed: list[Argument] = []
        for value in values:
            match value:
                case facts.Call(func=facts.Attribute(facts.Name("fmt"), "arg"), args=[name, only]) if name.value.text:
                    listed.append(Argument(only.value, name.value.text))
                case _:
                    listed.append(Argument(value))
        return listed

    # ------------------------------------------------------------------------------- functions as values

    def bound(self, arguments: Node, span: Span) -> Expr:
        """``std::bind(&Talker::on_timer, this, _1)``: the method of that object.  So ``std::thread`` takes it."""
        nodes = [argument for argument in arguments.named_children if argument.type != "comment"]
        if not nodes:
            return facts.Opaque("std::bind", span)
        pointed = nodes[0].child_by_field_name("argument") if nodes[0].type == "pointer_expression" else None
        function, rest = self.lower(nodes[0]), self.lower_all(nodes[1:])
        if pointed is not None and pointed.type == "qualified_identifier" and rest:
            name = self.names.parts(pointed)[-1].name
            function, rest = facts.Attribute(rest[0], name, self.source.span(nodes[0])), rest[1:]
        extra = [value for value in rest if not _is_placeholder(value)]
        if not extra:
            return function
        partial = self.names.library("functools.partial", span)
        return facts.Call(partial, given([function, *extra]), span)

    # ------------------------------------------------------------------------------------------- lambdas

    def _lambda(self, node: Node, span: Span) -> Expr:
        """A function of its own in front of the statement, and its name."""
        declarator, body = node.child_by_field_name("declarator"), node.child_by_field_name("body")
        name = f"lambda_{span[0]}_{span[1]}"
        owner = self.names.scopes[0].owner if self.names.scopes else None
        outer, self.before = self.before, []
        with self.names.function(FunctionScope(owner, is_lambda=True)) as scope:
            params = [] if declarator is None else self.parameters(declarator)
            copied = copied_by(node, self.names, self.source)
            params += [facts.Param(name, "keyword_only", facts.Name(name, span)) for name in copied]
            scope.declared.update(copied)
            scope.variables.update(copied)
            block = [] if body is None else [*self.own_copies(declarator, body), *self.body(body)]
        self.before = outer
        shared = sorted(scope.assigned - scope.variables - scope.declared)
        for name_of_outer in shared:
            self.note_assigned(facts.Name(name_of_outer, span))
        statements: list[Stmt] = [facts.Global("nonlocal", shared)] if shared else []
        self.before.append(facts.Function(name, params, [*statements, *block], [], None, False, False, span, span))
        self.names.declare(name)
        return facts.Name(name, span)

    def parameters(self, declarator: Node) -> list[Param]:
        """The parameters of a function."""
        raise NotImplementedError

    def body(self, node: Node) -> list[Stmt]:
        """The statements of a function."""
        raise NotImplementedError

    def own_copies(self, declarator: Node | None, block: Node | None) -> list[Stmt]:
        """What makes copies of the parameters that are objects of the function."""
        raise NotImplementedError


_OF_NODE = frozenset(
    {
        *("declare_parameter", "declare_parameters", "get_parameter", "get_parameter_or", "has_parameter"),
        *("set_parameter", "getInput"),
    }
)
"""Other methods of a node, and one of a node of a behaviour tree, whose arguments are changed here."""


def _as_double(element: Expr, span: Span) -> Expr:
    """An item of a ``std::vector<double>``, which takes whole numbers as doubles, too."""
    return element if element.number is None else facts.Literal(element.number, span)


def _is_placeholder(value: Expr) -> bool:
    name = value.last_name or getattr(value, "name", "")
    return name.startswith("_") and name[1:].isdigit()


def _is_of_node(name: str) -> bool:
    """Whether a method is one that a node has."""
    return name in calls.METHODS or name in calls.GENERIC or name in _OF_NODE


__all__ = ["CallLowering"]

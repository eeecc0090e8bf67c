"""What C++ code gives rclcpp, and what it takes of it, that does not compile.

Sources, Humble to Rolling: ``rclcpp/logging.hpp`` (the first argument is a logger, behind which ``_THROTTLE`` takes a
clock and a number of milliseconds; the format goes to ``rcutils_log(const char *)``), ``rclcpp/executors.hpp`` (what is
spun is a shared pointer to a ``rclcpp::Node`` or to its base interface), ``rclcpp/node.hpp`` (a publisher has a QoS, a
subscription a QoS and a callback, the period of a timer is a ``std::chrono::duration``),
``rclcpp/any_subscription_callback.hpp``, ``rclcpp/any_service_callback.hpp``.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

from archlint.syntax.cpp.declared import declared
from archlint.syntax.cpp.kinds_of_values import Kind, Kinds, is_interface, parameters_of, plain
from archlint.syntax.cpp_uses import RefusalOfCpp, RefusedUse, Role

if TYPE_CHECKING:
    from tree_sitter import Node

    from archlint.syntax.cpp.source import SourceText

_LOGS = re.compile(
    r"RCLCPP_(?:DEBUG|INFO|WARN|ERROR|FATAL)(_STREAM)?(_ONCE|_EXPRESSION|_FUNCTION|_SKIPFIRST|_THROTTLE"
    r"|_SKIPFIRST_THROTTLE)?"
)
_TEXTS = ("string_literal", "concatenated_string", "raw_string_literal")
_STRING = ("std", "string")
_STREAMS = (("std", "stringstream"), ("std", "ostringstream"))
_GIVES_TEXT = frozenset({("std", "to_string"), _STRING})
_NUMBERS = frozenset({"int", "double", "float", "bool", "long", "size_t", "unsigned int", "int64_t", "uint64_t"})
_PLAIN = _NUMBERS | {"std::string"}
_SPINS = {("rclcpp", "spin"): 0, ("rclcpp", "spin_some"): 0, ("rclcpp", "spin_until_future_complete"): 0}
_CREATED = {
    "create_publisher": "Publisher",
    "create_subscription": "Subscription",
    "create_service": "Service",
    "create_client": "Client",
}
_FEWEST = {"create_publisher": 2, "create_subscription": 3, "create_service": 2}
_PLACEHOLDER = re.compile(r"(?:std::placeholders::|placeholders::)?_(\d)")


class RefusedUses:
    """Notes what is refused; ``ask`` takes what is given for a format and is a member of a message."""

    def __init__(self, source: SourceText, kinds: Kinds, ask: Callable[[Kind, Role], None]) -> None:
        self.found: list[RefusedUse] = []
        self._source, self._kinds, self._ask = source, kinds, ask

    def _note(self, kind: RefusalOfCpp, node: Node, name: str = "", other: str = "") -> None:
        self.found.append(RefusedUse(kind, self._source.span(node), name, other))

    def _text(self, node: Node) -> str:
        return self._source.text(node)

    # ------------------------------------------------------------------------------------------------- calls

    def call(self, node: Node) -> None:
        """A call of a function, a method or a macro."""
        function, listed = node.child_by_field_name("function"), node.child_by_field_name("arguments")
        if function is None or listed is None or listed.type != "argument_list":
            return
        arguments = plain(listed.named_children)
        if function.type == "identifier":
            macro = _LOGS.fullmatch(self._text(function))
            if macro is not None:
                self._log(node, self._text(function), bool(macro[1]), macro[2] or "", arguments)
                return
        if function.type == "qualified_identifier":
            path = tuple(part.name for part in self._kinds.parts(function))
            if path in _SPINS and arguments:
                self._spun(path[-1], arguments[0])
            elif path in (("std", "bind"), ("boost", "bind")):
                self._bound(arguments)
        self._of_node(function, arguments)
        self._published(function, arguments)
        self._through_a_dot(function)

    # ------------------------------------------------------------------------------------------------ logging

    def _log(self, node: Node, name: str, is_stream: bool, feature: str, arguments: Sequence[Node]) -> None:
        if not arguments or any(argument.type in ("ERROR", "pack_expansion") for argument in arguments):
            return
        first, rest = arguments[0], arguments[1:]
        if first.type in _TEXTS or (is_stream and _begins_with_text(first)):
            self._note("no logger", first, name)
            return
        if feature.endswith("_THROTTLE") and rest:
            clock = rest[0]
            if clock.type in (*_TEXTS, "number_literal", "user_defined_literal"):
                self._note("no clock", clock, name)
                return
            if clock.type == "call_expression" and self._text(clock).replace(" ", "").endswith("get_clock()"):
                self._note("clock pointer", clock, name, self._text(clock))
                return
            rest = rest[2:]
        elif feature in ("_EXPRESSION", "_FUNCTION"):
            rest = rest[1:]
        if is_stream or not rest:
            return
        if self._is_string(rest[0]):
            self._note("format", rest[0], name)
        else:
            kind = self._kinds.of(rest[0]) if rest[0].type == "field_expression" else None
            if kind is not None:
                self._ask(kind, "format")

    def _is_string(self, node: Node) -> bool:
        """Whether a value is a ``std::string`` for certain."""
        if node.type == "parenthesized_expression" and len(node.named_children) == 1:
            return self._is_string(node.named_children[0])
        if node.type == "binary_expression" and any(child.type == "+" for child in node.children):
            sides = (node.child_by_field_name("left"), node.child_by_field_name("right"))
            return any(side is not None and self._is_string(side) for side in sides)
        if node.type == "identifier":
            kind = self._kinds.variable(self._text(node))
            return kind is not None and kind.path == _STRING and not kind.holder and not kind.members
        if node.type == "call_expression":
            function = node.child_by_field_name("function")
            if function is None:
                return False
            if function.type == "field_expression":
                kind = self._kinds.of(function.child_by_field_name("argument"))
                is_stream = kind is not None and kind.path in _STREAMS and not kind.members and not kind.holder
                return is_stream and self._text(node).endswith(".str()")
            if function.type == "qualified_identifier":
                return tuple(part.name for part in self._kinds.parts(function)) in _GIVES_TEXT
        return False

    # ---------------------------------------------------------------------------------------------- spinning

    def _spun(self, name: str, node: Node) -> None:
        """What is spun must be a shared pointer to a node."""
        kind = self._kinds.of(node)
        if node.type == "this":
            self._note("no pointer to node", node, name, "this")
        elif kind is None or kind.members or kind.owner:
            return
        elif kind.holder in ("", "raw") and self._is_node(kind.path):
            self._note("no pointer to node", node, name, self._text(node))
        elif kind.holder == "unique" and self._is_node(kind.path) and node.type == "identifier":
            self._note("unique pointer", node, name, self._text(node))
        elif kind.holder == "shared" and self._node_kind(kind.path) == "lifecycle":
            self._note("lifecycle node", node, name, self._text(node))

    def _is_node(self, path: tuple[str, ...]) -> bool:
        return bool(self._node_kind(path))

    def _node_kind(self, path: tuple[str, ...]) -> str:
        if path == ("rclcpp", "Node"):
            return "node"
        if path == ("rclcpp_lifecycle", "LifecycleNode"):
            return "lifecycle"
        return self._kinds.node_kind(path[-1]) if len(path) == 1 else ""

    # ------------------------------------------------------------------------------------- endpoints, timers

    def _of_node(self, function: Node, arguments: Sequence[Node]) -> None:
        """What the methods of a node are given."""
        name_node = self._method_of_node(function)
        if name_node is None or any(argument.type == "pack_expansion" for argument in arguments):
            return
        is_template = name_node.type in ("template_function", "template_method")
        parts = self._kinds.names.parts(name_node)
        name, types = parts[-1].name, parts[-1].arguments
        if name in ("create_wall_timer", "create_timer") and arguments and not is_template:
            self._timer(name, arguments)
        elif name in _CREATED and is_template and types:
            self._endpoint(name, types[0], name_node, arguments)

    def _method_of_node(self, function: Node) -> Node | None:
        """The name of a method that is called on what is certainly a node, and nobody's own method."""
        if function.type in ("identifier", "template_function"):
            name = function
        elif function.type == "field_expression":
            argument = function.child_by_field_name("argument")
            field = function.child_by_field_name("field")
            if argument is None or field is None:
                return None
            if argument.type != "this":
                kind = self._kinds.of(argument)
                is_node = kind is not None and not kind.members and not kind.owner and len(kind.path) == 2
                return field if is_node and kind is not None and self._is_node(kind.path) else None
            name = field
        else:
            return None
        own = self._kinds.classes.get(self._kinds.owner)
        called = self._kinds.names.parts(name)[-1].name
        if own is None or not own.is_whole or called in own.methods or not self._kinds.node_kind(self._kinds.owner):
            return None
        return None if self._kinds.is_local(called) else name

    def _timer(self, name: str, arguments: Sequence[Node]) -> None:
        period = arguments[0]
        kind = self._kinds.of(period) if period.type == "identifier" else None
        is_number = kind is not None and kind.path[0] in _NUMBERS and not kind.members and not kind.owner
        if period.type == "number_literal" and period.text is not None and period.text[-1:].isdigit():
            is_number = True
        if is_number:
            self._note("period", period, name, self._text(period))
        elif len(arguments) == 1:
            self._note("no callback", period, name)
        elif len(arguments) > 1 and (rows := self._lambda(arguments[1])) is not None and len(rows) > 1:
            self._note("callback arguments", arguments[1], name, str(len(rows)))

    def _endpoint(self, name: str, type_: Node, called: Node, arguments: Sequence[Node]) -> None:
        if name == "create_subscription" and len(arguments) >= 2 and self._is_callback(arguments[1]):
            self._note("callback for qos", arguments[1], name)
            return
        if len(arguments) < _FEWEST.get(name, 0):
            self._note("no callback" if name == "create_service" else "no qos", called, name)
            return
        at = {"create_subscription": 2, "create_service": 1}.get(name)
        if at is None or len(arguments) <= at:
            return
        written = self._lambda(arguments[at])
        rows = written or self._method(arguments[at])
        fewest = 1 if name == "create_subscription" else 2
        if written is not None and not fewest <= len(written) <= fewest + 1:
            self._note("callback arguments", arguments[at], name, str(len(written)))
        elif rows:
            self._callback_type(name, self._kinds.path(type_), rows[0])

    def _is_callback(self, node: Node) -> bool:
        if node.type == "lambda_expression":
            return True
        function = node.child_by_field_name("function") if node.type == "call_expression" else None
        return function is not None and self._text(function) in ("std::bind", "boost::bind")

    def _lambda(self, node: Node) -> list[Node] | None:
        """The parameters of a function that is written where it is given."""
        if node.type != "lambda_expression":
            return None
        declarator = node.child_by_field_name("declarator")
        return [] if declarator is None else parameters_of(declarator.child_by_field_name("parameters"))

    def _method(self, node: Node) -> list[Node] | None:
        """The parameters of the method of this object that ``std::bind`` makes a function of."""
        if not self._is_callback(node) or node.type == "lambda_expression":
            return None
        listed = node.child_by_field_name("arguments")
        arguments = [] if listed is None else plain(listed.named_children)
        if len(arguments) < 3 or arguments[1].type != "this" or not _is_first(self._text(arguments[2])):
            return None
        rows = self._methods(arguments[0])
        return rows[0] if rows is not None and len(rows) == 1 else None

    def _methods(self, pointer: Node) -> list[list[Node] | None] | None:
        """The parameters of the methods that ``&Talker::listen`` names, of the class around; None where it is
        another's."""
        name = pointer.child_by_field_name("argument") if pointer.type == "pointer_expression" else None
        if name is None or name.type != "qualified_identifier":
            return None
        parts = [part.name for part in self._kinds.names.parts(name)]
        own = self._kinds.classes.get(self._kinds.owner)
        if own is None or not own.is_whole or parts[-2:-1] != [self._kinds.owner] or len(parts) != 2:
            return None
        return own.methods.get(parts[-1], [])

    def _callback_type(self, name: str, wanted: tuple[str, ...], parameter: Node) -> None:
        """The message of a callback, or the request, is of another type."""
        kind = self._kinds.of_type(parameter.child_by_field_name("type"))
        if kind is None or not is_interface(kind.path):
            return
        wanted = wanted if name == "create_subscription" else (*wanted, "Request")
        if is_interface(wanted) and kind.path != wanted:
            self._note("callback type", parameter, "::".join(wanted), "::".join(kind.path))

    # ----------------------------------------------------------------------------------------------- binding

    def _bound(self, arguments: Sequence[Node]) -> None:
        """``std::bind`` gives a method of the class around all of its arguments."""
        if len(arguments) < 2 or arguments[1].type != "this":
            return
        rows = self._methods(arguments[0])
        if rows is None:
            return
        name = self._text(arguments[0]).rpartition("::")[2]
        if not rows:
            if self._has_no_other_members(name):
                self._note("no method", arguments[0], name, self._kinds.owner)
            return
        given, taken = len(arguments) - 2, rows[0] if len(rows) == 1 else None
        if taken is not None and len(taken) != given and all(row.type in _ALWAYS_GIVEN for row in taken):
            self._note("bound arguments", arguments[0], name, f"{len(taken)} {given}")

    def _has_no_other_members(self, name: str) -> bool:
        """Whether the class around has no member of a name, from no base either."""
        own = self._kinds.classes.get(self._kinds.owner)
        if own is None or name in own.fields or name in _OF_NODES:
            return False
        return all(base in _KNOWN_BASES or "enable_shared_from_this" in base for base in own.bases)

    # ------------------------------------------------------------------------------- values and declarations

    def _published(self, function: Node, arguments: Sequence[Node]) -> None:
        """A message of another type than that of the publisher."""
        if function.type != "field_expression" or len(arguments) != 1:
            return
        name = function.child_by_field_name("field")
        publisher = self._kinds.of(function.child_by_field_name("argument"))
        if (
            name is None
            or self._text(name) != "publish"
            or publisher is None
            or publisher.path != ("rclcpp", "Publisher")
        ):
            return
        message = self._kinds.of(arguments[0])
        if message is None or message.members or message.owner or not is_interface(message.path):
            return
        if is_interface(publisher.of) and message.path != publisher.of and publisher.holder == "shared":
            self._note("published type", arguments[0], "::".join(publisher.of), "::".join(message.path))

    def _through_a_dot(self, function: Node) -> None:
        """A method that is asked of the pointer to an object of rclcpp instead of the object."""
        name = function.child_by_field_name("field") if function.type == "field_expression" else None
        if name is None or not any(child.type == "." for child in function.children):
            return
        argument = function.child_by_field_name("argument")
        kind = self._kinds.of(argument)
        if argument is None or kind is None or kind.members or kind.owner or kind.path[:1] != ("rclcpp",):
            return
        if kind.holder in ("shared", "raw") and self._text(name) not in _OF_POINTERS:
            self._note("dot", function, self._text(argument), self._text(name))

    def assignment(self, node: Node) -> None:
        """An endpoint that is kept in a field for one of another type."""
        left, right = node.child_by_field_name("left"), node.child_by_field_name("right")
        if left is None or right is None or right.type != "call_expression" or node.children[1].type != "=":
            return
        kept, function = self._kinds.of(left), right.child_by_field_name("function")
        called = None if function is None else self._method_of_node(function)
        if kept is None or called is None or kept.members or kept.owner or kept.holder != "shared":
            return
        part = self._kinds.names.parts(called)[-1]
        if part.name not in _CREATED or not part.arguments or kept.path[:1] != ("rclcpp",):
            return
        made = self._kinds.path(part.arguments[0])
        both = kept.path == ("rclcpp", _CREATED[part.name]) and _is_of_interface(kept.of) and _is_of_interface(made)
        if both and kept.of != made:
            self._note("created type", called, "::".join(kept.of), "::".join(made))

    def declaration(self, node: Node) -> None:
        """A parameter that is taken for its value: ``double rate = get_parameter("rate");``."""
        type_ = node.child_by_field_name("type")
        if type_ is None or self._text(type_) not in _PLAIN:
            return
        for variable in declared(node, self._kinds.names, self._source):
            value = variable.value
            if value is None or value.type != "call_expression" or variable.is_pointer:
                continue
            function, listed = value.child_by_field_name("function"), value.child_by_field_name("arguments")
            called = None if function is None else self._method_of_node(function)
            arguments = [] if listed is None else plain(listed.named_children)
            if called is not None and self._text(called) == "get_parameter" and len(arguments) == 1:
                self._note("parameter", value, variable.name, self._text(type_))


_KNOWN_BASES = frozenset({("rclcpp", "Node"), ("rclcpp_lifecycle", "LifecycleNode")})
_OF_POINTERS = frozenset({"get", "reset", "swap", "unique", "use_count", "owner_before"})
_ALWAYS_GIVEN = frozenset({"parameter_declaration"})
_OF_NODES = frozenset({"on_configure", "on_activate", "on_deactivate", "on_cleanup", "on_shutdown", "on_error"})


def _is_of_interface(path: tuple[str, ...]) -> bool:
    return len(path) == 3 and path[1] in ("msg", "srv", "action")


def _is_first(text: str) -> bool:
    match = _PLACEHOLDER.fullmatch(text)
    return match is not None and match[1] == "1"


def _begins_with_text(node: Node) -> bool:
    """Whether what is put into a stream begins with a text: ``"speed: " << speed``."""
    while node.type == "binary_expression":
        left = node.child_by_field_name("left")
        if left is None:
            return False
        node = left
    return node.type in _TEXTS


__all__ = ["RefusedUses"]

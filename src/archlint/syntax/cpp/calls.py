"""Calls of ROS's C++ libraries, in the words of rclpy.

What differs is the order of the parameters, that types are template arguments, and that C++ hands out the value of a
parameter where Python hands out the parameter.  Source: ``rclcpp/node.hpp``, ``rclcpp/create_*.hpp``,
``rclcpp_action/create_server.hpp`` and ``create_client.hpp``, ``message_filters/subscriber.h``.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import TYPE_CHECKING

from archlint.syntax import facts
from archlint.syntax.facts import Argument

if TYPE_CHECKING:
    from archlint.syntax.cpp.names import Names
    from archlint.syntax.facts import Expr, Span

METHODS = {
    "create_publisher": ("create_publisher", ("msg_type",), ("topic", "qos_profile")),
    "create_subscription": ("create_subscription", ("msg_type",), ("topic", "qos_profile", "callback")),
    "create_service": ("create_service", ("srv_type",), ("srv_name", "callback", "qos_profile", "callback_group")),
    "create_client": ("create_client", ("srv_type",), ("srv_name", "qos_profile", "callback_group")),
    "create_wall_timer": ("create_timer", (), ("timer_period_sec", "callback", "callback_group")),
    "create_timer": ("create_timer", (), ("timer_period_sec", "callback", "callback_group")),
}
"""Methods of a node: rclpy's name, what the template arguments are, what the arguments are."""

WITH_TYPE = frozenset({"create_publisher", "create_subscription", "create_service", "create_client"})

GENERIC = {
    "create_generic_publisher": "create_publisher",
    "create_generic_subscription": "create_subscription",
    "create_generic_client": "create_client",
}
"""Methods that take the name of a type, as a text, behind the name of the topic or service."""

FREE = {
    "rclcpp.create_publisher": "create_publisher",
    "rclcpp.create_subscription": "create_subscription",
    "rclcpp.create_service": "create_service",
    "rclcpp.create_client": "create_client",
    "rclcpp.create_generic_publisher": "create_generic_publisher",
    "rclcpp.create_generic_subscription": "create_generic_subscription",
    "rclcpp.create_generic_client": "create_generic_client",
}
"""Functions that take the node first, and then what its method takes."""

NODE_INTERFACES = (
    *("get_node_base_interface", "get_node_topics_interface", "get_node_parameters_interface"),
    *("get_node_services_interface", "get_node_timers_interface", "get_node_clock_interface"),
    *("get_node_logging_interface", "get_node_waitables_interface", "get_node_graph_interface"),
    *("get_node_time_source_interface", "get_node_options", "shared_from_this"),
)
"""Methods of a node that stand for the node itself, to those who create something on it."""


def command_line(values: Sequence[Expr], span: Span) -> list[Argument]:
    """What ``rclcpp::init(argc, argv)`` is given, in the words of ``rclpy.init()``: no words where ``argc`` is 0, so
    that no rule of a launch file reaches the process."""
    match values:
        case [facts.Name() | facts.Literal() as count, _, *_]:
            none = facts.Compare(count, ["=="], [facts.Literal(0, span)], span)
            words = facts.Conditional(none, facts.Sequence("list", [], span), facts.Literal(None, span), span)
            return [Argument(words, "args")]
        case _:
            return []


def method(node: Expr, name: str, types: Sequence[Expr], arguments: Sequence[Expr], span: Span) -> facts.Call | None:
    """A create call on a node, with rclpy's keywords; None for what is no such call."""
    row = METHODS.get(name)
    if row is None or (name in WITH_TYPE) != bool(types):
        return None
    renamed, of_types, of_arguments = row
    given = [Argument(value, keyword) for keyword, value in zip(of_types, types, strict=False)]
    for keyword, value in zip(of_arguments, arguments, strict=False):
        match value:
            case facts.Sequence(elements=[only]) if keyword == "qos_profile":  # ``{10}`` makes a QoS of it
                value = only
        given.append(Argument(value, keyword))
    return facts.Call(facts.Attribute(node, renamed, span), given, span)


MOST_UNPACKED = 4
"""As many arguments of a call whose parameters are known by their numbers are taken from a pack."""


def unpacked(values: Sequence[Expr]) -> list[Expr]:
    """The arguments of a call whose parameters are known by their numbers, with those of a pack one by one."""
    listed: list[Expr] = []
    for value in values:
        match value:
            case facts.Starred(facts.Name(span=span) as pack):
                listed += [facts.Subscript(pack, facts.Literal(at, span), span) for at in range(MOST_UNPACKED)]
            case _:
                listed.append(value)
    return listed


def template_arguments(types: Sequence[Expr]) -> list[Argument]:
    """Explicit template arguments, for the parameters that :func:`template_parameter` names."""
    return [Argument(value, template_parameter(number)) for number, value in enumerate(types)]


def template_parameter(number: int) -> str:
    """What the parameter of a function template is called that takes a template argument."""
    return f"<{number}>"


def of_class(owner: str, number: int) -> str:
    """The attribute of an object that holds a template argument of its class."""
    return f"<{owner} {number}>"


def of_items(container: str) -> str:
    """The attribute of an object that holds the class of what one of its containers holds."""
    return f"{container}[]"


def action(function: Expr, is_server: bool, types: Sequence[Expr], arguments: Sequence[Expr], span: Span) -> Expr:
    """``rclcpp_action::create_server<T>(node, "name", …)``, also with the interfaces of the node one by one."""
    names = [at for at, value in enumerate(arguments) if not _is_of_node(value)]
    at = 4 if is_server and len(arguments) >= 8 else 4 if not is_server and len(arguments) >= 5 and 4 in names else 1
    if not types or len(arguments) <= at:
        return facts.Opaque("an action without a type", span)
    given = [Argument(arguments[0], "node"), Argument(types[0], "action_type"), Argument(arguments[at], "action_name")]
    if is_server:
        given.append(Argument(facts.Opaque("what a server of C++ does", span), "execute_callback"))
        words = ("goal_callback", "cancel_callback", "handle_accepted_callback")
        given += [Argument(value, word) for word, value in zip(words, arguments[at + 1 :], strict=False)]
    return facts.Call(function, given, span)


def _is_of_node(value: Expr) -> bool:
    return isinstance(value, facts.Name) and value.id == "self"


def node_arguments(arguments: Sequence[Expr], words: str, names: Names) -> list[Argument]:
    """The arguments of ``rclcpp::Node(name, [namespace], [options])``; ``words`` is the text of the file, which says
    what is set in options that come from outside."""
    given = [Argument(value, keyword) for keyword, value in zip(("node_name",), arguments, strict=False)]
    rest = list(arguments[1:3])
    if len(rest) == 2 or (rest and not _are_options(rest[0], names)):
        given.append(Argument(rest.pop(0), "namespace"))
    given += [Argument(value, "rclcpp_options") for value in rest]
    for option in ("allow_undeclared_parameters", "automatically_declare_parameters_from_overrides"):
        if f"{option}(true)" in words:
            given.append(Argument(facts.Literal(True, _span_of(arguments)), option))
    return given


def _span_of(arguments: Sequence[Expr]) -> Span:
    for value in arguments:
        span: Span | None = getattr(value, "span", None)
        if span is not None:
            return span
    return (1, 1, 1, 1)


def _are_options(value: Expr, names: Names) -> bool:
    if isinstance(value, facts.Name) and names.is_options(value.id):
        return True
    words = [part.last_name.lower() for part in _chain(value)]
    return any("option" in word for word in words) or isinstance(value, facts.Opaque)


def _chain(value: facts.Base) -> list[facts.Base]:
    chain: list[facts.Base] = [value]
    while isinstance(chain[-1], (facts.Call, facts.Attribute)):
        last = chain[-1]
        chain.append(last.func if isinstance(last, facts.Call) else last.value)
    return chain


def parameter(values: Sequence[Expr]) -> list[Argument]:
    """``rclcpp::Parameter(name, value)``, of two values or of the arguments of ``get_parameter_or``."""
    arguments = [Argument(value, word) for word, value in zip(("name",), values, strict=False)]
    return [*arguments, Argument(values[-1], "value")] if len(values) > 1 else arguments


def without_interfaces(values: Sequence[Expr]) -> list[Expr]:
    """The arguments of a function that takes a node, where it is given several interfaces of it instead."""
    listed = list(values)
    while len(listed) > 2 and _is_interface(listed[0], listed[1]):
        del listed[0]
    return listed


def _is_interface(first: Expr, other: Expr) -> bool:
    """Whether two arguments are interfaces of one node: what asks a node for them stands for the node itself."""
    if isinstance(first, facts.Name) and isinstance(other, facts.Name) and first.id == other.id:
        return True
    return all(not _INTERFACES.isdisjoint(re.split("[_.]", name.lower())) for name in (_last(first), _last(other)))


def _last(value: Expr) -> str:
    return value.name if isinstance(value, facts.Implicit) else value.last_name


_INTERFACES = frozenset(
    {
        *("base", "graph", "services", "topics", "parameters", "params", "timers", "clock", "logging", "waitables"),
    }
)
"""Words for what the interfaces of a node are called."""


def free_timer(path: str, values: Sequence[Expr], span: Span) -> Expr:
    """``rclcpp::create_timer(node, clock, period, callback)``, and the same without a clock."""
    values = [_seconds_of(value) for value in values]
    if path == "rclcpp.create_timer" and len(values) >= 4:
        created = method(values[0], "create_timer", (), values[-2:] if len(values) == 4 else values[2:4], span)
    elif path == "rclcpp.create_wall_timer" and len(values) >= 4:
        created = method(values[3], "create_timer", (), values[:3], span)
    else:
        created = None
    return created or facts.Opaque(path, span)


def _seconds_of(value: Expr) -> Expr:
    """``rclcpp::Duration::from_seconds(0.1)`` as that number."""
    match value:
        case facts.Call(func=facts.Attribute(facts.Attribute(_, "Duration"), "from_seconds"), args=[only]):
            return only.value
    return value


__all__ = [
    "FREE",
    "GENERIC",
    "METHODS",
    "NODE_INTERFACES",
    "WITH_TYPE",
    "action",
    "command_line",
    "free_timer",
    "method",
    "node_arguments",
    "of_class",
    "of_items",
    "parameter",
    "template_arguments",
    "template_parameter",
    "unpacked",
    "without_interfaces",
]

"""What is said of C++ code that rclcpp or the compiler refuses."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from archlint.python_code.refused_cpp_uses import RefusalOfCpp, RefusedUse

_WORDS: Mapping[RefusalOfCpp, tuple[str, str]] = {
    "format": ("{name}() is given a std::string for its format", 'write {name}(…, "%s", text.c_str())'),
    "no logger": ("{name}() lacks its first argument, a logger", "write {name}(get_logger(), …)"),
    "no clock": (
        "{name}() lacks the clock behind its logger",
        "write {name}(get_logger(), *get_clock(), 1000, …), with a number of milliseconds",
    ),
    "clock pointer": ("{name}() is given a pointer to a clock, and takes the clock", "write *{other}"),
    "no pointer to node": (
        "{name}() is given '{other}', and takes a shared pointer to a node",
        "make the node with std::make_shared<…>(…), and pass that",
    ),
    "unique pointer": (
        "{name}() is given a std::unique_ptr, and takes a shared pointer",
        "make the node with std::make_shared<…>(…)",
    ),
    "lifecycle node": (
        "{name}() takes no shared pointer to a LifecycleNode",
        "write {name}({other}->get_node_base_interface())",
    ),
    "no qos": ("{name}() lacks an argument: it takes a topic and a QoS", "add a QoS, such as 10"),
    "no callback": ("{name}() is given no callback", "add the function to be called"),
    "callback for qos": (
        "{name}() is given its callback where the QoS belongs",
        "write a QoS in front of it, such as 10",
    ),
    "period": ("{name}() is given the number {other} for its period", "give it a duration: 500ms of std::chrono"),
    "parameter": (
        "get_parameter() gives an rclcpp::Parameter, and '{name}' is of the type {other}",
        "write get_parameter(…).{value}()",
    ),
    "no method": ("class '{other}' has no method '{name}'", "name a method of the class"),
    "bound arguments": (
        "std::bind() gives '{name}' {given} besides the object, and it takes {taken}",
        "write a placeholder for each of its parameters: std::placeholders::_1",
    ),
    "callback arguments": ("{name}() is given a callback with {other} parameters", "it takes {wanted}"),
    "callback type": (
        "the callback takes {other}, and is called with {name}",
        "write {name}, or ask for the other type",
    ),
    "published type": ("a publisher of {name} is given {other}", "publish {name}"),
    "created type": (
        "what is made for {other} is kept in a pointer for {name}",
        "write the same type at both places",
    ),
    "value": (
        "{name}() is given the std::string {other} as it is",
        "write {other}.c_str(): what fills in a %s is no std::string",
    ),
    "pointer name": ("{name} has no '{taken}'", "write {given}"),
    "no node": (
        "the constructor of '{name}' gives rclcpp::Node no name",
        'write {name}() : Node("name")',
    ),
    "literal": (
        "nothing says what the unit in '{other}' is",
        "write using namespace std::chrono_literals;",
    ),
    "placeholder": ("nothing says what '{other}' is", "write std::placeholders::{other}"),
    "dot": ("'{other}' is asked of the pointer '{name}' with a '.'", "write {name}->{other}"),
}
_OF_THIS = "write shared_from_this(), outside of the constructor"
_VALUES = {"double": "as_double", "float": "as_double", "bool": "as_bool", "std::string": "as_string"}
_WANTED = {"create_subscription": "one: the message", "create_service": "two: request and response"}


NO_ERROR = frozenset({"value"})
"""What a compiler may take, and make nonsense of."""


def words_for(use: RefusedUse) -> tuple[str, str]:
    """The message and the help."""
    message, help = _WORDS[use.kind]
    taken, _, given = use.other.partition(" ")
    if use.kind == "bound arguments":
        given = "one argument" if given == "1" else f"{given if given != '0' else 'no'} arguments"
    words = {
        "name": use.name,
        "other": use.other,
        "value": _VALUES.get(use.other, "as_int"),
        "wanted": _WANTED.get(use.name, "none"),
        "taken": taken,
        "given": given,
    }
    if use.kind == "no pointer to node" and use.other == "this":
        help = _OF_THIS
    return message.format(**words), help.format(**words)


__all__ = ["NO_ERROR", "words_for"]

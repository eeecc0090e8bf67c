"""Calls of the logging macros of rclcpp that a compiler refuses."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import TYPE_CHECKING

from archlint.syntax.cpp.refused_names import RefusedNames

if TYPE_CHECKING:
    from tree_sitter import Node

_LOGS = re.compile(
    r"RCLCPP_(?:DEBUG|INFO|WARN|ERROR|FATAL)(_STREAM)?(_ONCE|_EXPRESSION|_FUNCTION|_SKIPFIRST|_THROTTLE"
    r"|_SKIPFIRST_THROTTLE)?"
)
_TEXTS = ("string_literal", "concatenated_string", "raw_string_literal")
_STRING = ("std", "string")
_STREAMS = (("std", "stringstream"), ("std", "ostringstream"))
_GIVES_TEXT = frozenset({("std", "to_string"), _STRING})


class RefusedLogs(RefusedNames):
    """Notes what a logger does not take."""

    def _logs(self, name: str, arguments: Sequence[Node]) -> bool:
        """Whether a call is one of a logging macro: then it is judged."""
        macro = _LOGS.fullmatch(name)
        if macro is not None:
            self._log(name, bool(macro[1]), macro[2] or "", arguments)
        return macro is not None

    def _log(self, name: str, is_stream: bool, feature: str, arguments: Sequence[Node]) -> None:
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
        for at, argument in enumerate(rest):
            kind = self._kinds.of(argument) if argument.type == "field_expression" else None
            if self._is_string(argument):
                self._note("value" if at else "format", argument, name, self._text(argument))
            elif kind is not None:
                self._ask(kind, "value" if at else "format")

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


def _begins_with_text(node: Node) -> bool:
    """Whether what is put into a stream begins with a text: ``"speed: " << speed``."""
    while node.type == "binary_expression":
        left = node.child_by_field_name("left")
        if left is None:
            return False
        node = left
    return node.type in _TEXTS


__all__ = ["RefusedLogs"]

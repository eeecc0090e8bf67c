"""Slips of the pen in C++ functions, where no compiler goes on: a ``;`` that is missing, a ``:`` in its place, two
values without a comma.

The grammar stumbles over macros and rare forms, too.  So a place counts only where none of these is near: what is left
in thousands of files of public code is what a compiler refuses.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.syntax.cpp.names import DEFINED

if TYPE_CHECKING:
    from tree_sitter import Node

_MOST = 3
"""With more of such places a file is written in a way that the grammar does not know."""
_LINES = 3
"""As many lines around a place are looked at."""
_MACRO = re.compile(
    rb"\b(?!(?:RCLCPP|RCUTILS)_(?:DEBUG|INFO|WARN|ERROR|FATAL)|NULL\b|M_PI\b)(?:_*[A-Z][A-Z0-9_]+|PRI[a-zA-Z]\w*)\b"
)
"""A name that macros have; those that log are understood."""
_RARE = re.compile(
    rb"\b(?:typename|decltype|operator|template|asm|requires|emit|for_?each|forever|signals|slots|try|catch|delete|new"
    rb"|alignas|alignof|noexcept|static_assert|co_\w+|__\w+|if\s+constexpr|concept|import|export|module|goto|typedef|auto\s*\[)\b"
    rb"|->\s*\*|\.\*|->\s*[A-Za-z_]\w*\s*::|#|@|\\|\$|`|<=>|R\"|\[\[|\?:|&&\s*\]|%:|<:|\bthis\s+auto\b"
)
"""What the grammar reads in another way than a compiler, or not at all."""
_OF_LOG = re.compile(
    rb"^[ \t]*((?:\[[\w.-]+-\d+\][ \t]*)?\[(?:DEBUG|INFO|WARN|ERROR|FATAL)\][ \t]*\[\d{6,}\.\d+\])", re.MULTILINE
)
"""What a node or launch prints: ``[INFO] [1700000000.123] [talker]: …``."""
_MISSING = {";": "';'", ")": "')'", "identifier": "a value"}
_READ_AS_TYPES = frozenset(
    {"parameter_declaration", "parameter_list", "optional_parameter_declaration", "parenthesized_declarator"}
    | {"template_argument_list", "type_descriptor", "lambda_capture_specifier", "cast_expression"}
    | {"qualified_identifier", "concatenated_string", "compound_literal_expression", "for_range_loop", "for_statement"}
    | {"if_statement", "else_clause", "while_statement", "switch_statement"}
)
"""Where an expression may have been read as a type, or a macro stands among texts."""
_HOLDS_STATEMENTS = frozenset({"compound_statement", "case_statement", "field_initializer_list"})
_LIKE_A_CALL = re.compile(rb"[\w:.>-]+\s*\(.*\)", re.DOTALL)
_ENDS = b";{}:,("
"""What stands before a statement, or goes on in the next line."""


def slip_in(root: Node, data: bytes) -> tuple[int, str] | None:
    """The place of the first slip of a file, in bytes, and what is wrong there."""
    logged = _OF_LOG.search(data)
    if logged is not None and _is_code(root, logged.start(1)):
        return logged.start(1), "a line of a log stands in the code"
    places = list(_places(root))
    if not 0 < len(places) <= _MOST or not all(_is_plain(node, data) for node in places):
        return None
    first = min(places, key=lambda node: node.start_byte)
    if first.is_missing:
        start = len(data[: first.start_byte].rstrip())
        return start - 1, f"{_MISSING[first.type]} is missing behind this"
    text = data[first.start_byte : first.end_byte].decode("utf-8", "replace").split("\n")[0].strip()
    before = data[: first.start_byte].rstrip()
    begins = data[len(before) : first.start_byte].count(b"\n") > 0
    where = "here, as a ';' is missing in front of it" if begins and before[-1:] not in _ENDS else "here"
    return first.start_byte, f"'{text}' is not understood {where}"


def _is_code(root: Node, start: int) -> bool:
    """Whether a byte is outside of comments and texts."""
    node = root.descendant_for_byte_range(start, start + 1)
    return node is not None and node.type not in ("comment", "string_content", "raw_string_content")


def _places(root: Node) -> Iterator[Node]:
    """The innermost places that the grammar does not understand."""
    waiting = [root]
    while waiting:
        node = waiting.pop()
        if node.is_missing or node.type == "ERROR":
            yield node
        elif node.has_error:
            waiting.extend(node.children)


def _is_plain(node: Node, data: bytes) -> bool:
    """Whether a place is in a function, and nothing near it is what the grammar does not know."""
    around, statement = node.parent, node
    if around is None or around.type in _READ_AS_TYPES or (node.is_missing and node.type not in _MISSING):
        return False
    while around is not None and around.type not in _HOLDS_STATEMENTS:
        if around.type in ("ERROR", "translation_unit", "field_declaration_list", "declaration_list"):
            return False
        statement, around = around, around.parent
    if around is None or not _is_in_function(around):
        return False
    text = data[statement.start_byte : statement.end_byte]
    rows = data.split(b"\n")
    first, last = node.start_point[0], node.end_point[0]
    if last > first + 1:
        return False
    is_call = node.parent == around and _LIKE_A_CALL.fullmatch(data[node.start_byte : node.end_byte]) is not None
    if is_call and around.type == "compound_statement" and data[node.end_byte :].lstrip()[:1] != b";":
        return False  # a macro that begins a loop, say
    near = b"\n".join(rows[max(0, first - _LINES) : last + _LINES + 1])
    return not any(pattern.search(part) for pattern in (_MACRO, _RARE) for part in (_code(text), _code(near)))


def _is_in_function(block: Node) -> bool:
    """Whether a block is of a function, and not of a class with a macro in its head."""
    node: Node | None = block
    while node is not None and node.type not in ("function_definition", "lambda_expression"):
        node = node.parent
    if node is None or node.type == "lambda_expression":
        return node is not None
    declarator = node.child_by_field_name("declarator")
    kind = node.child_by_field_name("type")
    is_class = kind is not None and kind.type in DEFINED
    while declarator is not None and declarator.type in ("pointer_declarator", "reference_declarator"):
        declarator = declarator.child_by_field_name("declarator") or declarator.named_children[-1]
    return not is_class and declarator is not None and declarator.type == "function_declarator"


_TEXT = re.compile(rb'"(?:[^"\\\n]|\\.)*"|\'(?:[^\'\\\n]|\\.)*\'|//[^\n]*|/\*.*?\*/', re.DOTALL)


def _code(text: bytes) -> bytes:
    """A text without the texts and comments in it."""
    return _TEXT.sub(b'""', text)


__all__ = ["slip_in"]

"""Variables of inner blocks that hide others, and references: each variable of a function gets a name of its own.

The facts know functions and no blocks.  A variable that hides another one of its function is called otherwise until its
block ends, and a reference is called what it refers to.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.syntax.cpp.declared import declared

if TYPE_CHECKING:
    from tree_sitter import Node

    from archlint.syntax.cpp.declared import Declared
    from archlint.syntax.cpp.names import Names
    from archlint.syntax.cpp.source import SourceText

SCOPES = frozenset(
    {"compound_statement", "for_statement", "for_range_loop", "if_statement", "while_statement", "switch_statement"}
    | {"catch_clause"}
)
"""Statements that what they declare ends with."""


_CHANGES = "(?:append|assign|clear|erase|insert|pop_back|push_back|replace|resize)"
"""What changes a text."""


def rename_hidden(block: Node, names: Names, source: SourceText) -> None:
    """Give the variables of an inner block that hide others another name."""
    for declaration in _declarations(block):
        for variable in declared(declaration, names, source):
            for name in (variable.name, *variable.bound):
                if name and names.is_visible(name):
                    start = declaration.start_byte
                    source.rename(_mentions(block, name, start, source), f"{original(name)}'{start}")


def join_references(block: Node, names: Names, source: SourceText) -> None:
    """Call a reference to a variable, ``auto & topic = name;``, what it refers to."""
    for node in block.named_children:
        declarator = node.child_by_field_name("declarator") if node.type == "declaration" else None
        if declarator is None or declarator.type != "init_declarator":
            continue
        reference, value = declarator.child_by_field_name("declarator"), declarator.child_by_field_name("value")
        if reference is None or value is None or reference.type != "reference_declarator" or value.type != "identifier":
            continue
        inner = reference.named_children[-1] if reference.named_children else None
        is_moved = (reference.text or b"").startswith(b"&&")
        is_alone = len(node.children_by_field_name("declarator")) == 1
        if inner is None or inner.type != "identifier" or is_moved or not is_alone:
            continue
        source.joined.add(source.span(inner))
        source.rename(_mentions(block, source.text(inner), declarator.start_byte, source), source.text(value))


def copied_by(node: Node, names: Names, source: SourceText) -> list[str]:
    """The variables of which a lambda has a copy, ``[topic]``: they hold what they held where it was made."""
    captures = node.child_by_field_name("captures")
    named = [] if captures is None else [child for child in captures.named_children if child.type == "identifier"]
    copied = [child for child in named if child.prev_sibling is None or child.prev_sibling.type != "&"]
    return [name for child in copied if names.is_variable(name := source.text(child))]


def changed_through(declaration: Node, variable: Declared, source: SourceText) -> Node | None:
    """What a reference or a pointer to something changes later, other than a variable that it can be called."""
    value, block = variable.value, declaration.parent
    if value is None or block is None:
        return None
    name, around = re.escape(original(variable.name)), value.parent
    if value.type == "pointer_expression" and value.children[0].type == "&":
        value = value.child_by_field_name("argument")
        written = rf"\*\s*{name}\s*\+?=(?!=)|(?<![\w.>]){name}->{_CHANGES}\("
    else:
        declarator = None if around is None else around.child_by_field_name("declarator")
        if declarator is None or declarator.type != "reference_declarator" or value.type == "identifier":
            return None
        written = rf"(?<![\w.>]){name}(?:\s*\+?=(?!=)|\.{_CHANGES}\()"
    rest = source.data[declaration.end_byte : block.end_byte].decode("utf-8", "replace")
    return value if re.search(written, rest) is not None else None


def original(name: str) -> str:
    """What the code calls a variable."""
    return name.partition("'")[0]


def _declarations(block: Node) -> Iterator[Node]:
    """The nodes that declare what ends with a block."""
    match block.type:
        case "compound_statement":
            yield from (child for child in block.named_children if child.type == "declaration")
        case "for_range_loop":
            yield block
        case "catch_clause":
            parameters = block.child_by_field_name("parameters")
            yield from () if parameters is None else parameters.named_children
        case "for_statement":
            first = block.child_by_field_name("initializer")
            yield from (first,) if first is not None and first.type == "declaration" else ()
        case _:
            condition = block.child_by_field_name("condition")
            for child in () if condition is None else condition.named_children:
                rows = child.named_children if child.type == "init_statement" else [child]
                yield from (row for row in rows if row.type == "declaration")


def _mentions(block: Node, name: str, start: int, source: SourceText) -> Iterator[int]:
    """Where a variable is named in a block, from a place on."""
    written = re.escape(original(name)).encode()
    for match in re.compile(rb"(?<![\w.])%s(?!\w)" % written).finditer(source.data, start, block.end_byte):
        node = block.descendant_for_byte_range(match.start(), match.end())
        if node is not None and node.type == "identifier" and source.text(node) == name:
            yield match.start()


__all__ = ["SCOPES", "changed_through", "copied_by", "join_references", "original", "rename_hidden"]

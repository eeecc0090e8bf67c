"""Nodes that are gone at the closing brace: the variable of a block that holds one ends there, and the node with it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.syntax import facts
from archlint.syntax.cpp.declared import Declared, declared

if TYPE_CHECKING:
    from tree_sitter import Node

    from archlint.syntax.cpp.names import Names
    from archlint.syntax.cpp.source import SourceText
    from archlint.syntax.facts import Span, Stmt


def end_of_block(block: Node, names: Names, source: SourceText) -> list[Stmt]:
    """``del`` of the variables that a block in braces declares and makes a node for; what ``new`` makes stays."""
    ending: list[str] = []
    for node in block.named_children if block.type == "compound_statement" else ():
        if node.type == "declaration" and b"Node" in (node.text or b""):
            ending += [each.name for each in declared(node, names, source) if _ends(each)]
    if not ending:
        return []
    row, column, last_row, last_column = source.span(block)
    span: Span = (last_row, max(last_column - 1, column if last_row == row else 0), last_row, last_column)
    targets: list[facts.Expr] = [facts.Name(name, span) for name in ending]
    return [facts.Delete(targets, span)]


def _ends(variable: Declared) -> bool:
    """Whether what a variable holds goes with it."""
    allocated = variable.value is not None and variable.value.type == "new_expression"
    return bool(variable.name) and not (variable.is_pointer or variable.is_function or allocated)


__all__ = ["end_of_block"]

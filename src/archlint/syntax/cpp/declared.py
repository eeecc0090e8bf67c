"""What a declaration of C++ declares: variables, fields, parameters."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from archlint.records import dataclass
from archlint.syntax.cpp.known_names import POINTERS

if TYPE_CHECKING:
    from tree_sitter import Node

    from archlint.syntax.cpp.names import Names, Part
    from archlint.syntax.cpp.source import SourceText
    from archlint.syntax.facts import Span


@dataclass
class Declared:
    """One variable of a declaration."""

    name: str
    span: Span
    value: Node | None = None
    """What it is initialised with."""
    owner: str = ""
    """The class that it is a static member of, where it is defined outside of it."""
    bound: tuple[str, ...] = ()
    """The names of ``auto [a, b]``."""
    is_pointer: bool = False
    is_array: bool = False
    is_function: bool = False
    parameters: Node | None = None
    """Those of a function; ``Rate rate(hz);`` reads like the declaration of one."""
    is_extern: bool = False


_AROUND = frozenset(
    {
        *("pointer_declarator", "reference_declarator", "array_declarator", "parenthesized_declarator"),
        *("function_declarator", "structured_binding_declarator"),
    }
)
"""Declarators that another one, such as a reference, may be around."""
_NAMES = frozenset({"identifier", "field_identifier", "type_identifier"})


def declared(node: Node, names: Names, source: SourceText) -> list[Declared]:
    """The variables that a declaration, a field, a parameter or a loop declares."""
    extern = any(child.type == "storage_class_specifier" and child.text == b"extern" for child in node.children)
    variables = []
    # Of a field, or of a condition: ``if (auto x = f())``.
    value_of_field = node.child_by_field_name("default_value") or node.child_by_field_name("value")
    for declarator in node.children_by_field_name("declarator"):
        variable = _declared(declarator, names, source)
        variable.is_extern = extern
        if value_of_field is not None:
            variable.value = value_of_field
        variables.append(variable)
    return variables


def _declared(node: Node, names: Names, source: SourceText) -> Declared:
    variable = Declared("", source.span(node))
    while True:
        match node.type:
            case "init_declarator":
                variable.value = node.child_by_field_name("value")
            case "function_declarator":
                variable.is_function = True
                variable.parameters = node.child_by_field_name("parameters")
            case "pointer_declarator":
                variable.is_pointer = True
            case "array_declarator":
                variable.is_array = True
            case "structured_binding_declarator":
                variable.bound = tuple(source.text(child) for child in node.named_children)
                return variable
            case "qualified_identifier":
                parts = names.parts(node)
                variable.name = parts[-1].name
                variable.owner = parts[-2].name if len(parts) > 1 else ""
                return variable
            case kind if kind in _NAMES:
                variable.name, variable.span = source.text(node), source.span(node)
                return variable
        inner = node.child_by_field_name("declarator")
        if inner is None:
            inner = next(
                (child for child in node.named_children if child.type in _NAMES or child.type in _AROUND),
                None,
            )
        if inner is None:
            return variable
        node = inner


def is_pointer(parts: Sequence[Part]) -> bool:
    """Whether a type is a pointer to a class: ``Node::SharedPtr``."""
    return bool(parts) and parts[-1].name in POINTERS


__all__ = ["Declared", "declared", "is_pointer"]

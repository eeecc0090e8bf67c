"""Functions whose head a macro writes, ``TEST_CASE("it turns") {…}``: the grammar takes their braces for a block."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from tree_sitter import Node

HOLDERS = frozenset(
    {
        *(
            "translation_unit",
            "namespace_definition",
            "declaration_list",
            "preproc_ifdef",
            "preproc_if",
            "preproc_else",
        ),
        *("template_declaration", "linkage_specification", "class_specifier", "struct_specifier"),
        *("field_declaration_list", "field_declaration"),
    }
)
"""What stands outside of functions and has statements in it."""


def macro_in_front(node: Node) -> Node | None:
    """The name of the macro whose call stands in front of braces outside of functions, with no semicolon between."""
    before = node.prev_named_sibling
    while before is not None and before.type == "comment":
        before = before.prev_named_sibling
    if node.parent is None or node.parent.type not in HOLDERS or before is None or not before.children:
        return None
    call = before.children[0]
    name = call.child_by_field_name("function") if call.type == "call_expression" else None
    return name if name is not None and name.type == "identifier" and before.children[-1].is_missing else None


__all__ = ["HOLDERS", "macro_in_front"]

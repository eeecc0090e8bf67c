"""The classes that a C++ file defines: their bases, their fields and their methods."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.syntax.cpp.declared import declared
from archlint.syntax.cpp.kinds import ClassOfFile, Kind, parameters_of
from archlint.syntax.cpp.kinds_of_types import KindsOfTypes

if TYPE_CHECKING:
    from tree_sitter import Node

    from archlint.syntax.cpp.declared import Declared
    from archlint.syntax.cpp.names import Names
    from archlint.syntax.cpp.source import SourceText

_WITHOUT_CLASSES = frozenset(
    {"compound_statement", "expression_statement", "declaration", "comment", "function_declarator", "preproc_include"}
    | {"preproc_def", "preproc_function_def", "identifier", "type_identifier", "qualified_identifier"}
    | {"base_class_clause", "access_specifier", "field_initializer_list", "primitive_type", "template_type"}
    | {"field_identifier", "lambda_expression"}
)
"""Where no class and no alias of the file is looked for."""
NODES: Mapping[tuple[str, ...], str] = {("rclcpp", "Node"): "node", ("rclcpp_lifecycle", "LifecycleNode"): "lifecycle"}
_HARMLESS = "enable_shared_from_this"


class KindsOfClasses(KindsOfTypes):
    """The classes of one file, too."""

    def __init__(self, source: SourceText, names: Names) -> None:
        super().__init__(source, names)
        self.classes: dict[str, ClassOfFile | None] = {}
        """The classes of the file by name; None where there are several."""

    def note(self, root: Node) -> None:
        """Take note of the aliases and the classes of the file, outside of functions."""
        waiting = [root]
        classes: list[Node] = []
        while waiting:
            node = waiting.pop()
            self.note_alias(node)
            if node.type in ("class_specifier", "struct_specifier"):
                classes.append(node)
            waiting.extend(child for child in node.named_children if child.type not in _WITHOUT_CLASSES)
        for node in classes:
            self._note_class(node)

    def _note_class(self, node: Node) -> None:
        name, body = node.child_by_field_name("name"), node.child_by_field_name("body")
        if name is None or body is None or name.type != "type_identifier":
            return
        own = self.source.text(name)
        if own in self.classes or own in self._aliases:
            self.classes[own] = None
            return
        own_class = self.classes[own] = ClassOfFile(is_whole=not node.has_error)
        for clause in (child for child in node.named_children if child.type == "base_class_clause"):
            kinds = [child for child in clause.named_children if child.type != "access_specifier"]
            own_class.bases += [self.path(child) or ("?",) for child in kinds]
        for member in body.named_children:
            self._note_member(own_class, member)

    def _note_member(self, own_class: ClassOfFile, node: Node) -> None:
        if node.type == "template_declaration" or node.type.startswith("preproc") or node.type == "using_declaration":
            own_class.is_whole &= node.type == "template_declaration" and not node.has_error
            for name in self._names_in(node):
                own_class.methods[name] = [None]
                own_class.fields[name] = None
            return
        if node.type not in ("field_declaration", "function_definition", "declaration"):
            return
        for variable in declared(node, self.names, self.source):
            if variable.is_function:
                rows = parameters_of(variable.parameters)
                own_class.methods.setdefault(variable.name, []).append(rows)
            else:
                own_class.fields[variable.name] = self.of_variable(variable, node.child_by_field_name("type"))

    def _names_in(self, node: Node) -> Iterator[str]:
        waiting = [node]
        while waiting:
            node = waiting.pop()
            if node.type in ("identifier", "field_identifier"):
                yield self.source.text(node)
            waiting.extend(node.named_children)

    def node_kind(self, name: str) -> str:
        """Whether a class of the file is a node and nothing else: ``node``, ``lifecycle``, or empty."""
        own_class = self.classes.get(name)
        if own_class is None:
            return ""
        bases = [base for base in own_class.bases if _HARMLESS not in base]
        return NODES.get(bases[0], "") if len(bases) == 1 else ""

    def of_variable(self, variable: Declared, type_: Node | None) -> Kind | None:
        """The kind of a variable, or of a field."""
        if type_ is None or variable.is_function or variable.is_array:
            return None
        kind = self.of_type(type_)
        if kind is None or not variable.is_pointer:
            return kind
        return None if kind.holder else replace(kind, holder="raw")


__all__ = ["NODES", "KindsOfClasses"]

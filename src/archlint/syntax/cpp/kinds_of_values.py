"""The types of variables and values in C++, as far as the file writes them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING

from archlint.syntax.cpp.declared import declared
from archlint.syntax.cpp.known_names import INTERFACE_KINDS
from archlint.syntax.cpp_uses import ITEM, Holder

if TYPE_CHECKING:
    from tree_sitter import Node

    from archlint.syntax.cpp.declared import Declared
    from archlint.syntax.cpp.names import Names, Part
    from archlint.syntax.cpp.source import SourceText
    from archlint.syntax.facts import Span

_SHARED = frozenset({"SharedPtr", "ConstSharedPtr", "Ptr", "ConstPtr"})
_UNIQUE = frozenset({"UniquePtr", "ConstUniquePtr"})
_HOLDERS: dict[tuple[str, str], Holder] = {
    ("std", "shared_ptr"): "shared",
    ("boost", "shared_ptr"): "shared",
    ("std", "unique_ptr"): "unique",
    ("std", "vector"): "list",
    ("std", "deque"): "list",
    ("std", "array"): "list",
}
_MAKERS: dict[tuple[str, str], Holder] = {("std", "make_shared"): "shared", ("std", "make_unique"): "unique"}
_SECTIONS = frozenset({"Request", "Response", "Goal", "Result", "Feedback"})
_OF_ITEMS = frozenset({"at", "front", "back"})
_MOST_INSIDE = 20
_WITHOUT_CLASSES = frozenset(
    {"compound_statement", "expression_statement", "declaration", "comment", "function_declarator", "preproc_include"}
    | {"preproc_def", "preproc_function_def", "identifier", "type_identifier", "qualified_identifier"}
    | {"base_class_clause", "access_specifier", "field_initializer_list", "primitive_type", "template_type"}
    | {"field_identifier", "lambda_expression"}
)
"""Where no class and no alias of the file is looked for."""

Member = tuple[str, "Span"]


@dataclass(frozen=True)
class Kind:
    """What is certain of a value: what was asked of a variable of a type, one after the other."""

    path: tuple[str, ...]
    holder: Holder = ""
    members: tuple[Member, ...] = ()
    owner: str = ""
    """The class of another file whose field it is; the path is that of the field then."""
    of: tuple[str, ...] = ()
    """The interface of an endpoint."""

    @property
    def is_interface(self) -> bool:
        return is_interface(self.path)

    def with_member(self, name: str, span: Span) -> Kind:
        return replace(self, members=(*self.members, (name, span)))


def is_interface(path: Sequence[str]) -> bool:
    """Whether a type is a message, or a part of a service or an action."""
    if len(path) < 3 or path[1] not in INTERFACE_KINDS:
        return False
    return len(path) == 3 if path[1] == "msg" else len(path) == 4 and path[3] in _SECTIONS


@dataclass
class ClassOfFile:
    """A class that the file defines."""

    bases: list[tuple[str, ...]] = field(default_factory=list)
    fields: dict[str, Kind | None] = field(default_factory=dict)
    methods: dict[str, list[list[Node] | None]] = field(default_factory=dict)
    """The parameters of each method of a name; None for one that takes any number."""
    is_whole: bool = True
    """Whether all of its members were read."""


_TYPES = frozenset({"qualified_identifier", "type_identifier", "template_type", "dependent_type", "identifier"})
_NODES: Mapping[tuple[str, ...], str] = {("rclcpp", "Node"): "node", ("rclcpp_lifecycle", "LifecycleNode"): "lifecycle"}
_HARMLESS = "enable_shared_from_this"


class Kinds:
    """The types of the names of one file, in the scopes around what is being read."""

    def __init__(self, source: SourceText, names: Names) -> None:
        self.source, self.names = source, names
        self.scopes: list[dict[str, Kind | None]] = []
        self.classes: dict[str, ClassOfFile | None] = {}
        """The classes of the file by name; None where there are several."""
        self.owner = ""
        """The class whose method is being read."""
        self._aliases: dict[str, Node | None] = {}
        self._inside = 0

    # ------------------------------------------------------------------------------------------------ names

    def note(self, root: Node) -> None:
        """Take note of the aliases and the classes of the file, outside of functions."""
        waiting = [root]
        classes: list[Node] = []
        while waiting:
            node = waiting.pop()
            if node.type == "alias_declaration":
                self._note_alias(node.child_by_field_name("name"), node.child_by_field_name("type"))
            elif node.type == "type_definition":
                self._note_alias(node.child_by_field_name("declarator"), node.child_by_field_name("type"))
            elif node.type == "using_declaration" and node.named_children:
                name = node.named_children[-1]
                if name.type == "qualified_identifier" and node.children[1].type not in ("namespace", "typename"):
                    self._note_alias(name, name)
            elif node.type == "namespace_alias_definition" and len(node.named_children) > 1:
                self._note_alias(node.named_children[0], node.named_children[-1])
            elif node.type in ("class_specifier", "struct_specifier"):
                classes.append(node)
            waiting.extend(child for child in node.named_children if child.type not in _WITHOUT_CLASSES)
        for node in classes:
            self._note_class(node)

    def _note_alias(self, name: Node | None, meant: Node | None) -> None:
        if name is None or meant is None:
            return
        own = self.source.text(name).rpartition("::")[2]
        known = self._aliases.get(own, meant)
        same = known is not None and self.source.text(known) == self.source.text(meant)
        self._aliases[own] = meant if same else None

    def _note_class(self, node: Node) -> None:
        name, body = node.child_by_field_name("name"), node.child_by_field_name("body")
        if name is None or body is None or name.type != "type_identifier":
            return
        own = self.source.text(name)
        if own in self.classes or own in self._aliases:
            self.classes[own] = None
            return
        found = self.classes[own] = ClassOfFile(is_whole=not node.has_error)
        for clause in (child for child in node.named_children if child.type == "base_class_clause"):
            kinds = [child for child in clause.named_children if child.type != "access_specifier"]
            found.bases += [self.path(child) or ("?",) for child in kinds]
        for member in body.named_children:
            self._note_member(found, member)

    def _note_member(self, found: ClassOfFile, node: Node) -> None:
        if node.type == "template_declaration" or node.type.startswith("preproc") or node.type == "using_declaration":
            found.is_whole &= node.type == "template_declaration" and not node.has_error
            for name in self._names_in(node):
                found.methods[name] = [None]
                found.fields[name] = None
            return
        if node.type not in ("field_declaration", "function_definition", "declaration"):
            return
        for variable in declared(node, self.names, self.source):
            if variable.is_function:
                rows = parameters_of(variable.parameters)
                found.methods.setdefault(variable.name, []).append(rows)
            else:
                found.fields[variable.name] = self._of_variable(variable, node.child_by_field_name("type"))

    def _names_in(self, node: Node) -> Iterator[str]:
        waiting = [node]
        while waiting:
            node = waiting.pop()
            if node.type in ("identifier", "field_identifier"):
                yield self.source.text(node)
            waiting.extend(node.named_children)

    def node_kind(self, name: str) -> str:
        """Whether a class of the file is a node and nothing else: ``node``, ``lifecycle``, or empty."""
        found = self.classes.get(name)
        if found is None:
            return ""
        bases = [base for base in found.bases if _HARMLESS not in base]
        return _NODES.get(bases[0], "") if len(bases) == 1 else ""

    # ------------------------------------------------------------------------------------------------ types

    def parts(self, node: Node) -> list[Part]:
        """The parts of a name with aliases replaced."""
        parts = [part for part in self.names.parts(node) if part.name]
        for _ in range(_MOST_INSIDE):
            meant = self._aliases.get(parts[0].name) if parts else None
            if not parts or parts[0].name not in self._aliases:
                return parts
            if meant is None:
                return []
            before = [part for part in self.names.parts(meant) if part.name]
            if before[:1] == parts[:1]:
                return parts
            parts = [*before, *parts[1:]]
        return []

    def path(self, node: Node) -> tuple[str, ...]:
        """A type as its names, without pointers; empty where it is not known."""
        kind = self.of_type(node)
        return kind.path if kind is not None and not kind.holder else ()

    def of_type(self, node: Node | None) -> Kind | None:
        """The kind of the values of a type."""
        if node is None or self._inside > _MOST_INSIDE:
            return None
        self._inside += 1
        try:
            return self._of_type(node)
        finally:
            self._inside -= 1

    def _of_type(self, node: Node) -> Kind | None:
        if node.type in ("primitive_type", "sized_type_specifier"):
            return Kind((self.source.text(node),))
        if node.type == "type_descriptor":
            inner = self.of_type(node.child_by_field_name("type"))
            return inner if node.child_by_field_name("declarator") is None else None
        if node.type not in (
            "qualified_identifier",
            "type_identifier",
            "template_type",
            "dependent_type",
            "identifier",
        ):
            return None
        return self._of_parts(self.parts(node))

    def _of_parts(self, parts: list[Part]) -> Kind | None:
        if not parts:
            return None
        if len(parts) > 1 and parts[-1].name in _SHARED | _UNIQUE:
            inner = self._of_parts(parts[:-1])
            holder: Holder = "shared" if parts[-1].name in _SHARED else "unique"
            return None if inner is None or inner.holder else replace(inner, holder=holder)
        names = tuple(part.name for part in parts)
        if len(parts) == 2 and (names[0], names[1]) in _HOLDERS and parts[1].arguments:
            inner = self.of_type(parts[1].arguments[0])
            holder = _HOLDERS[names[0], names[1]]
            return None if inner is None or inner.holder else replace(inner, holder=holder)
        if names[:1] == ("rclcpp",) and len(parts) == 2 and parts[1].arguments:
            return Kind(names, of=self.path(parts[1].arguments[0]))
        return None if any(part.arguments for part in parts) else Kind(names)

    # ------------------------------------------------------------------------------------------- variables

    def declare(self, node: Node, *, unknown: bool = False) -> None:
        """The variables of a declaration, a parameter or a condition."""
        for variable in declared(node, self.names, self.source):
            kind = None if unknown else self._of_variable(variable, node.child_by_field_name("type"))
            for name in (variable.name, *variable.bound):
                if name and self.scopes:
                    self.scopes[-1][name] = None if variable.bound else kind

    def _of_variable(self, variable: Declared, type_: Node | None) -> Kind | None:
        if type_ is None or variable.is_function or variable.is_array:
            return None
        if type_.type == "placeholder_type_specifier":
            kind = self.of(variable.value)
            return kind if not variable.is_pointer or (kind is not None and kind.holder == "raw") else None
        kind = self.of_type(type_)
        if kind is None or not variable.is_pointer:
            return kind
        return None if kind.holder else replace(kind, holder="raw")

    def declare_item(self, loop: Node) -> None:
        """The variable of a loop over a container."""
        type_, right = loop.child_by_field_name("type"), loop.child_by_field_name("right")
        for variable in declared(loop, self.names, self.source):
            kind = None
            if type_ is not None and type_.type != "placeholder_type_specifier":
                kind = self._of_variable(variable, type_)
            elif right is not None and not variable.is_pointer:
                around = self.of(right)
                kind = None if around is None else around.with_member(ITEM, self.source.span(right))
            for name in (variable.name, *variable.bound):
                if self.scopes:
                    self.scopes[-1][name] = None if variable.bound else kind

    def variable(self, name: str) -> Kind | None:
        """What is known of a name: a variable, or a field of the class whose method this is."""
        for scope in reversed(self.scopes):
            if name in scope:
                return scope[name]
        return self.field(name)

    def is_local(self, name: str) -> bool:
        return any(name in scope for scope in self.scopes)

    def field(self, name: str) -> Kind | None:
        if not self.owner:
            return None
        if self.owner not in self.classes:
            return Kind((name,), owner=self.owner)
        found = self.classes[self.owner]
        return None if found is None else found.fields.get(name)

    # ---------------------------------------------------------------------------------------------- values

    def of(self, node: Node | None) -> Kind | None:
        """The kind of a value."""
        if node is None or self._inside > _MOST_INSIDE:
            return None
        self._inside += 1
        try:
            return self._of(node)
        finally:
            self._inside -= 1

    def _of(self, node: Node) -> Kind | None:
        match node.type:
            case "identifier":
                return self.variable(self.source.text(node))
            case "parenthesized_expression":
                return self.of(node.named_children[0]) if len(node.named_children) == 1 else None
            case "pointer_expression":
                return self._pointed(node)
            case "field_expression":
                return self._member(node)
            case "subscript_expression":
                around = self.of(node.child_by_field_name("argument"))
                return None if around is None else around.with_member(ITEM, self.source.span(node))
            case "compound_literal_expression":
                return self.of_type(node.child_by_field_name("type"))
            case "new_expression":
                kind = self.of_type(node.child_by_field_name("type"))
                return None if kind is None or kind.holder else replace(kind, holder="raw")
            case "call_expression":
                return self._result(node)
            case "this":
                return Kind((self.owner,), "raw") if self.owner else None
        return None

    def _pointed(self, node: Node) -> Kind | None:
        kind = self.of(node.child_by_field_name("argument"))
        if kind is None or kind.members or kind.owner:
            return None
        if node.children[0].type == "&":
            return None if kind.holder else replace(kind, holder="raw")
        return replace(kind, holder="") if kind.holder in ("shared", "unique", "raw") else None

    def _member(self, node: Node) -> Kind | None:
        argument, name = node.child_by_field_name("argument"), node.child_by_field_name("field")
        if argument is None or name is None or name.type != "field_identifier":
            return None
        if argument.type == "this":
            return self.field(self.source.text(name))
        kind = self.of(argument)
        operator = next((child.type for child in node.children if child.type in (".", "->")), "")
        if kind is None or not operator:
            return None
        return kind.with_member(operator + self.source.text(name), self.source.span(name))

    def _result(self, node: Node) -> Kind | None:
        function, arguments = node.child_by_field_name("function"), node.child_by_field_name("arguments")
        if function is None or arguments is None:
            return None
        if function.type == "field_expression":
            name = function.child_by_field_name("field")
            kind = self.of(function.child_by_field_name("argument"))
            method = "" if name is None else self.source.text(name)
            if kind is not None and method in _OF_ITEMS:
                return kind.with_member(ITEM, self.source.span(node))
            is_pointer = kind is not None and kind.holder in ("shared", "unique") and not kind.members
            return replace(kind, holder="raw") if kind is not None and method == "get" and is_pointer else None
        if function.type not in ("qualified_identifier", "identifier", "template_function"):
            return None
        parts = self.parts(function)
        path = tuple(part.name for part in parts)
        if path == ("std", "move") and len(arguments.named_children) == 1:
            return self.of(arguments.named_children[0])
        if len(path) == 2 and (path[0], path[1]) in _MAKERS and parts[1].arguments:
            kind = self.of_type(parts[1].arguments[0])
            holder = _MAKERS[path[0], path[1]]
            return None if kind is None or kind.holder else replace(kind, holder=holder)
        is_type = is_interface(path) or (len(path) == 1 and path[0] in self.classes and not self.is_local(path[0]))
        if is_type or path in _NODES or path == ("std", "string"):
            return Kind(path)
        if len(path) > 1 and path[:-1] in _NODES and path[-1] == "make_shared":
            return Kind(path[:-1], "shared")
        return None


def parameters_of(node: Node | None) -> list[Node] | None:
    """The parameters of a function; None where it takes any number, or has defaults."""
    if node is None:
        return None
    rows = [child for child in node.named_children if child.type != "comment"]
    if any(child.type == "variadic_parameter_declaration" or child.type == "variadic_parameter" for child in rows):
        return None
    if any(child.type == "..." for child in node.children):
        return None
    if len(rows) == 1 and rows[0].type == "parameter_declaration" and rows[0].text == b"void":
        return []
    return rows


def plain(nodes: Iterable[Node]) -> list[Node]:
    """Nodes without the comments among them."""
    return [node for node in nodes if node.type != "comment"]


__all__ = ["ClassOfFile", "Kind", "Kinds", "is_interface", "parameters_of", "plain"]

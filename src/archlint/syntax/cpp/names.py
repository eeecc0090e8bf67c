"""What the names of a C++ file mean: interfaces, libraries, classes, members, variables."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import field
from typing import TYPE_CHECKING, NamedTuple

from archlint.records import dataclass
from archlint.syntax import facts
from archlint.syntax.cpp.known_names import (
    IN_PYTHON,
    INTERFACE_KINDS,
    LIBRARIES,
    OPENED,
    POINTERS,
    RMW_PROFILES,
    UNLIKE_METHODS,
)

if TYPE_CHECKING:
    from tree_sitter import Node

    from archlint.syntax.cpp.source import SourceText
    from archlint.syntax.facts import Expr, Span


MAX_FOLLOWED = 20
"""Names that are followed for one: those of classes inside of classes, and of aliases of aliases, which may go in a
circle."""


_CONSTANTS = {"std.nullopt": None, "std.string.npos": -1, "std.string_view.npos": -1}
"""Constants of the standard library; what finds nothing in a text gives the last two, and in Python -1."""


class Part(NamedTuple):
    """One part of a qualified name: ``create_client<T>`` of ``rclcpp_action::create_client<T>``."""

    name: str
    arguments: tuple[Node, ...] = ()
    """Its template arguments, each a type or an expression."""


DEFINED = frozenset({"class_specifier", "struct_specifier", "enum_specifier"})
"""What defines a type."""


def unnamed(node: Node) -> str:
    """What a type without a name is called, by its place in the file."""
    return f"unnamed_{node.start_point[0] + 1}_{node.start_point[1] + 1}"


@dataclass
class FunctionScope:
    """The function that is being lowered."""

    owner: str | None
    """The class that it is a method of; None for a free function."""
    variables: set[str] = field(default_factory=set)
    """Its parameters and variables, as far as a block that has not ended declares them."""
    declared: set[str] = field(default_factory=set)
    """All of them."""
    blocks: list[set[str]] = field(default_factory=lambda: [set()])
    """What each of the blocks around declares."""
    assigned: set[str] = field(default_factory=set)
    """What it assigns, other than by declaring it."""
    streams: set[str] = field(default_factory=set)
    """Variables that texts are written into with ``<<``."""
    objects: set[str] = field(default_factory=set)
    """Variables that hold an object of a class, and no pointer to one."""
    texts: set[str] = field(default_factory=set)
    """Variables of the type ``std::string``, which methods can change."""
    parameters: set[str] = field(default_factory=set)
    """Variables of the type ``rclcpp::Parameter``, which parameters are read into with their names."""
    options: set[str] = field(default_factory=set)
    """Variables of the type ``rclcpp::NodeOptions``."""
    pairs: set[str] = field(default_factory=set)
    """Variables of loops that hold pairs, such as the items of a map."""
    iterators: dict[str, tuple[Expr, Expr]] = field(default_factory=dict)
    """Variables that hold what ``names.find(key)`` gives: of which map, and for which key."""
    packs: set[str] = field(default_factory=set)
    """Its parameters that take any number of arguments, ``Names... names``."""
    is_lambda: bool = False


class Names:
    """The names of one file."""

    def __init__(self, source: SourceText) -> None:
        self._source = source
        self.imports: dict[str, tuple[str, str]] = {}
        """What is imported: module and name, by what it is bound as; a name of ``""`` is the module itself."""
        self.spans: dict[str, Span] = {}
        """Where each of these is named first, outside of all conditions of the preprocessor."""
        self.conditions = 0
        """How many of these are around what is being lowered."""
        self.namespaces: set[str] = set()
        self.spaces: list[str] = []
        """The namespaces around what is being lowered, without those that have no name."""
        self.placed: dict[str, set[str]] = {}
        """In which namespaces of the file each name is defined."""
        self.aliases: dict[str, list[str]] = {}
        """What a name of a namespace, or one with ``using a::b``, stands for."""
        self.opened: list[list[str]] = []
        """The namespaces of ``using namespace``."""
        self.classes: set[str] = set()
        self.nested: set[str] = set()
        """Those of them that stand in another one."""
        self.enums: set[str] = set()
        self.class_parameters: dict[str, str] = {}
        """The attributes of an object that hold the template arguments of its class, by what the class calls them."""
        self.templates: dict[str, list[Part]] = {}
        """Names for a class with template arguments: ``using ImuRelay = Relay<Imu>``."""
        self.item_kinds: dict[str, list[Part]] = {}
        """What containers hold, by the names of the variables and fields that they are."""
        self.scopes: list[FunctionScope] = []
        self._followed = 0

    def read_from(self, source: SourceText) -> None:
        """The nodes that come next are of this text."""
        self._source = source

    # ------------------------------------------------------------------------------------------ functions

    @contextmanager
    def function(self, scope: FunctionScope) -> Iterator[FunctionScope]:
        """While the body of a function is lowered."""
        self.scopes.append(scope)
        try:
            yield scope
        finally:
            self.scopes.pop()

    def declare(self, name: str) -> None:
        """A variable is declared here."""
        if self.scopes:
            scope = self.scopes[-1]
            scope.variables.add(name)
            scope.declared.add(name)
            scope.blocks[-1].add(name)

    @contextmanager
    def inner_block(self) -> Iterator[None]:
        """While a block inside of a function is lowered: what it declares ends with it."""
        scope = self.scopes[-1]
        scope.blocks.append(set())
        try:
            yield
        finally:
            ended = scope.blocks.pop()
            scope.variables -= {name for name in ended if not any(name in block for block in scope.blocks)}

    def is_visible(self, name: str) -> bool:
        """Whether a block around, of the same function, declares a name."""
        return bool(self.scopes) and any(name in block for block in self.scopes[-1].blocks)

    def is_variable(self, name: str) -> bool:
        """Whether a name is a variable or parameter of a function around."""
        return any(name in scope.variables for scope in self.scopes)

    def may_be_elsewhere(self, namespace: str) -> bool:
        """Whether another file says what a namespace is."""
        known = (*self.namespaces, *self.aliases, *self.classes, *LIBRARIES, *INTERFACE_KINDS)
        return namespace[:1].islower() and namespace not in known and not self.is_variable(namespace)

    def found_in(self, name: str) -> tuple[Expr, Expr] | None:
        """The map that a variable was looked up in, and the key."""
        return next((scope.iterators[name] for scope in reversed(self.scopes) if name in scope.iterators), None)

    def forget_found(self, name: str) -> None:
        """A variable holds something else from now on: it may be what was found, the map or the key."""
        for scope in self.scopes:
            for iterator, parts in [*scope.iterators.items()]:
                if name == iterator or any(isinstance(part, facts.Name) and part.id == name for part in parts):
                    del scope.iterators[iterator]

    def is_pair(self, name: str) -> bool:
        """Whether a variable holds a pair, as far as a loop says."""
        return any(name in scope.pairs for scope in self.scopes)

    def is_text(self, name: str) -> bool:
        """Whether a variable is a ``std::string``."""
        return any(name in scope.texts for scope in self.scopes)

    def is_object(self, name: str) -> bool:
        """Whether a variable holds an object of a class, and no pointer to one."""
        return any(name in scope.objects for scope in self.scopes)

    def is_parameter(self, name: str) -> bool:
        """Whether a variable is an ``rclcpp::Parameter``."""
        return any(name in scope.parameters for scope in self.scopes)

    def is_options(self, name: str) -> bool:
        """Whether a variable is an ``rclcpp::NodeOptions``."""
        return any(name in scope.options for scope in self.scopes)

    def is_stream(self, name: str) -> bool:
        """Whether a variable is one that texts are written into with ``<<``."""
        return any(name in scope.streams for scope in self.scopes)

    def is_pack(self, name: str) -> bool:
        """Whether a parameter takes any number of arguments."""
        return any(name in scope.packs for scope in self.scopes)

    @property
    def is_in_method(self) -> bool:
        return bool(self.scopes) and self.scopes[0].owner is not None

    def plain(self, name: str, span: Span) -> Expr:
        """What a name without a namespace stands for."""
        if self.is_variable(name):
            return facts.Name(name, span)
        if name in self.class_parameters and self.is_in_method:
            return facts.Attribute(facts.Name("self", span), self.class_parameters[name], span)
        alias = self.aliases.get(name)
        if alias is not None and alias != [name]:
            return self.resolve([Part(part) for part in alias], span)
        name = self.qualified(name)
        opened = self._opened_library([Part(name)]) if name[:1].isupper() else ""
        if opened:
            return self.library(f"{opened}.{name}", span)
        if name.startswith("RMW_QOS_POLICY_"):
            return self._imported(f"rclcpp.{name}", name, span)
        if name in RMW_PROFILES:
            return self._imported(RMW_PROFILES[name], name, span)
        if self.is_in_method and (name not in self.classes or name in self.nested):
            return facts.Implicit(name, span)
        return facts.Name(name, span)

    def qualified(self, name: str) -> str:
        """A name that several namespaces of the file have, with the innermost one around; any other as it is."""
        spaces = self.placed.get(name, ())
        if len(spaces) < 2:
            return name
        return next((f"{space}::{name}" for space in reversed(self.spaces) if space in spaces), name)

    # ------------------------------------------------------------------------------------ qualified names

    def parts(self, node: Node) -> list[Part]:
        """The parts of a name, such as ``a::b<T>::c``."""
        match node.type:
            case "qualified_identifier":
                scope, name = node.child_by_field_name("scope"), node.child_by_field_name("name")
                before = [] if scope is None else self.parts(scope)
                return before if name is None else [*before, *self.parts(name)]
            case "template_type" | "template_function" | "template_method":
                name, arguments = node.child_by_field_name("name"), node.child_by_field_name("arguments")
                given = () if arguments is None else tuple(a for a in arguments.named_children if a.type != "comment")
                *before, last = self.parts(name) if name is not None else [Part("")]
                return [*before, Part(last.name, given)]
            case "dependent_name" | "dependent_type" | "nested_namespace_specifier":
                return [part for child in node.named_children for part in self.parts(child)]
            case "type_descriptor":
                inner = node.child_by_field_name("type")
                return [] if inner is None else self.parts(inner)
            case kind if kind in DEFINED:  # ``struct { std::string name; } settings;``
                own = node.child_by_field_name("name")
                return [Part(unnamed(node))] if own is None else self.parts(own)
        return [Part(self._source.text(node))]

    def written(self, parts: list[Part]) -> list[Part]:
        """The parts of a name with the aliases of the file put in their places."""
        head = self.aliases.get(parts[0].name) if parts and len(parts) > 1 else None
        if head is not None and not self.is_variable(parts[0].name):
            return [*(Part(name) for name in head), *parts[1:]]
        return parts

    def path(self, parts: list[Part]) -> str:
        """A name of a library as ``rclcpp.executors.MultiThreadedExecutor``; empty for one that is of none."""
        parts = self.written(parts)
        if len(parts) > 1 and parts[0].name in LIBRARIES and parts[0].name not in self.namespaces:
            return ".".join(part.name for part in parts)
        opened = self._opened_library(parts)
        if opened:
            return ".".join((opened, *(part.name for part in parts)))
        if len(parts) == 1 and not self.is_variable(parts[0].name):
            alias = self.aliases.get(parts[0].name)
            if alias is not None and alias[0] in LIBRARIES and len(alias) > 1:
                return ".".join(alias)
            if parts[0].name in ("static_cast", "dynamic_cast", "const_cast", "reinterpret_cast"):
                return parts[0].name
        return ""

    def _opened_library(self, parts: list[Part]) -> str:
        """The library that a name is of by ``using namespace``; empty where the file may mean another one."""
        name = parts[0].name if parts else ""
        if not self.opened or self.is_variable(name) or name in self.aliases:
            return ""
        if name in self.classes or name in self.namespaces or (self.is_in_method and name in UNLIKE_METHODS):
            return ""
        return next((lib for lib, names in OPENED.items() if [lib] in self.opened and name in names), "")

    def resolve(self, parts: list[Part], span: Span) -> Expr:
        """What a qualified name stands for."""
        if self._followed >= MAX_FOLLOWED:
            return facts.Opaque("a name", span)
        self._followed += 1
        try:
            return self._resolved(parts, span)
        finally:
            self._followed -= 1

    def _resolved(self, parts: list[Part], span: Span) -> Expr:
        parts = [part for part in self.written(parts) if part.name]
        while len(parts) > 1 and parts[-1].name in POINTERS:
            parts = parts[:-1]
        if not parts:
            return facts.Opaque("a name", span)
        interface = self._interface(parts, span)
        if interface is not None:
            return interface
        if len(parts) == 1:
            return self.plain(parts[0].name, span)
        path = self.path(parts)
        if path in _CONSTANTS:
            return facts.Literal(_CONSTANTS[path], span)
        if path:
            return self.library(path, span)
        *before, owner, last = parts
        if owner.name in self.classes or (owner.name not in self.namespaces and owner.name[:1].isupper()):
            return facts.Attribute(self.resolve([*before, owner], span), last.name, span)
        return facts.Name(f"{owner.name}::{last.name}", span)

    def library(self, path: str, span: Span) -> Expr:
        """A name of a library, in the words of its Python twin where it has one."""
        mapped = IN_PYTHON.get(path)
        if mapped is not None and "." not in mapped:
            return facts.Name(mapped, span)
        if mapped is not None:
            return self._imported(mapped, path.replace(".", "::"), span)
        module, *names = path.split(".")
        self.imports.setdefault(module, (module, ""))
        value: Expr = facts.Name(module, span)
        for name in names:
            value = facts.Attribute(value, name, span)
        return value

    def _imported(self, path: str, bound: str, span: Span) -> Expr:
        module, _, name = path.rpartition(".")
        self.imports.setdefault(bound, (module, name))
        if not self.conditions:
            self.spans.setdefault(bound, span)
        return facts.Name(bound, span)

    def _interface(self, parts: list[Part], span: Span) -> Expr | None:
        """``std_msgs::msg::String`` and what is inside of it."""
        for at, part in enumerate(parts[:-1]):
            if part.name in INTERFACE_KINDS:
                package = parts[at - 1].name if at else self._opened_package(part.name)
                if not package:
                    return None
                value = self._imported(
                    f"{package}.{part.name}.{parts[at + 1].name}", f"{package}::{part.name}::{parts[at + 1].name}", span
                )
                for inner in parts[at + 2 :]:
                    if inner.name not in POINTERS:
                        value = facts.Attribute(value, inner.name, span)
                return value
        return None

    def interface_called(self, name: str, span: Span) -> Expr:
        """The interface that a text such as ``std_msgs/msg/String`` names."""
        package, _, rest = name.partition("/")
        kind, _, last = rest.partition("/")
        if kind not in INTERFACE_KINDS or not package.isidentifier() or not last.isidentifier():
            return facts.Opaque("a type that a text names", span)
        return self._imported(f"{package}.{kind}.{last}", f"{package}::{kind}::{last}", span)

    def _opened_package(self, kind: str) -> str:
        """The one package that ``using namespace`` opens, where ``msg::String`` stands without one, or else the one
        that is called like the only namespace of the file."""
        packages = {opened[-1] for opened in self.opened if len(opened) == 1 and opened[0] not in LIBRARIES}
        packages = packages or {name for name in self.namespaces if name}
        return packages.pop() if len(packages) == 1 else ""


__all__ = ["FunctionScope", "Names", "Part"]

"""Functions, methods and constructors of C++ lowered to :mod:`archlint.syntax.facts`."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, NamedTuple

from archlint.syntax import facts
from archlint.syntax.cpp import calls
from archlint.syntax.cpp.declared import declared
from archlint.syntax.cpp.inner_scopes import join_references
from archlint.syntax.cpp.known_names import FIELDS, IN_PYTHON, MEMBER, TEMPLATE_ARGUMENT
from archlint.syntax.cpp.lower_expressions import given
from archlint.syntax.cpp.lower_statements import StatementLowering
from archlint.syntax.cpp.names import FunctionScope, Names, Part

if TYPE_CHECKING:
    from tree_sitter import Node

    from archlint.syntax.cpp.source import SourceText
    from archlint.syntax.facts import Expr, Param, Span, Stmt

BASES = "__bases__"
"""The method that makes the bases of a class where its constructor says nothing of them."""

_NAME = re.compile(r"[A-Za-z_]\w*")
_SET = re.compile(r"\b(\w+)\s*\.\s*(?:reliable|best_effort|transient_local|durability_volatile|keep_all)\s*\(\s*\)")
"""A variable that a setter of ``rclcpp::QoS`` without arguments is called on."""


class TemplateParameter(NamedTuple):
    """A parameter of a template."""

    name: str
    default: Node | None = None


class FunctionLowering(StatementLowering):
    """Lowers functions, too."""

    def __init__(self, source: SourceText, names: Names) -> None:
        super().__init__(source, names)
        self._statements |= {"function_definition": self._function}
        self._template_parameters: list[TemplateParameter] = []
        """Those of the function, or of the class, that comes next."""
        self._class_parameters: list[TemplateParameter] = []
        """Those of the class around."""
        self._class_of_method: Expr | None = None
        """The class whose method is defined outside of it."""

    def template_parameters(self, node: Node) -> list[TemplateParameter]:
        """What a template is declared with."""
        listed = node.child_by_field_name("parameters")
        rows: list[TemplateParameter] = []
        for child in [] if listed is None else listed.named_children:
            default = child.child_by_field_name("default_type") or child.child_by_field_name("default_value")
            words = [
                part
                for part in child.named_children
                if part.type in ("type_identifier", "identifier") and part != default
            ]
            rows.append(TemplateParameter(self.source.text(words[-1]) if words else f"_{len(rows)}", default))
        return rows

    def _function(self, node: Node, body: list[Stmt]) -> None:
        """A function, or a method that is defined outside of its class."""
        declarator = function_declarator(node)
        name = None if declarator is None else declarator.child_by_field_name("declarator")
        if name is None:
            return
        parts = self.names.parts(name)
        owner = parts[-2].name if len(parts) > 1 else ""
        if owner and self.is_class_called(owner):
            outer, self.names.class_parameters = self.names.class_parameters, self._of_owner(parts[-2])
            self._class_parameters = [row for row in self._template_parameters if self._is_of_class(row)]
            self._template_parameters = [row for row in self._template_parameters if not self._is_of_class(row)]
            spaces = [part.name for part in parts[:-2]]
            self.names.spaces += spaces
            span = self.source.span(node)
            self._class_of_method = cls = self._owner(parts, span)
            function = self._defined(node, owner, parts[-1], f"{owner}::{parts[-1].name}")
            self._class_of_method = None
            del self.names.spaces[len(self.names.spaces) - len(spaces) :]
            self.names.class_parameters, self._class_parameters = outer, []
            if function is None:
                return
            attribute = "__init__" if parts[-1].name == owner else parts[-1].name
            target = facts.Attribute(cls, attribute, span)
            body.extend((function, facts.Assign([target], facts.Name(function.name, span), span)))
        else:
            function = self._defined(node, None, parts[-1], parts[-1].name)
            if function is None:
                return
            body.append(function)
            if owner:
                name_in_space = facts.Name(f"{owner}::{function.name}", function.span)
                body.append(facts.Assign([name_in_space], facts.Name(function.name, function.span), function.span))

    def _owner(self, parts: list[Part], span: Span) -> Expr:
        """The class of ``Outer::Inner::method``, which another class of a header may hold."""
        owner, outer = parts[-2].name, parts[-3].name if len(parts) > 2 else ""
        is_of_file = owner in self.names.classes and owner not in self.names.nested
        if is_of_file or not outer or outer in self.names.namespaces or not self.is_class_called(outer):
            return facts.Name(self.names.qualified(owner), span)
        return facts.Attribute(facts.Name(self.names.qualified(outer), span), owner, span)

    def is_class_called(self, name: str) -> bool:
        """Whether ``name::`` in front of a definition is a class.  A namespace may be opened in a header alone; classes
        whose names are written as those of namespaces mostly are, or which are called like the namespace around them,
        have a constructor or a destructor here, too."""
        if name in self.names.classes:
            return True
        own = re.compile(rf"\b{re.escape(name)}::~?{re.escape(name)} ?\(")
        if own.search(self.source.words) is not None:
            return True
        return name not in self.names.namespaces and not name[:1].islower()

    def _of_owner(self, owner: Part) -> dict[str, str]:
        """What ``Channel<T>::open()`` calls the template arguments of its class."""
        words = [self.source.text(argument) for argument in owner.arguments]
        return {word: calls.of_class(owner.name, at) for at, word in enumerate(words) if word.isidentifier()}

    def _is_of_class(self, row: TemplateParameter) -> bool:
        return row.name in self.names.class_parameters

    def _function_of(self, node: Node, own: str, inner: list[Stmt]) -> None:
        """A method that is defined inside its class."""
        declarator = function_declarator(node)
        name = None if declarator is None else declarator.child_by_field_name("declarator")
        if name is None:
            return
        part = self.names.parts(name)[-1]
        function = self._defined(node, own, part, "__init__" if part.name == own else part.name)
        if function is not None:
            inner.append(function)

    def _defined(self, node: Node, owner: str | None, part: Part, name: str) -> facts.Function | None:
        """A function with its body; None for one that is deleted, for destructors and operators, and for constructors
        that copy or move as the compiler has it: they make no node."""
        declarator, block = function_declarator(node), node.child_by_field_name("body")
        is_default = any(child.type == "default_method_clause" for child in node.named_children)
        if declarator is None or part.name.startswith(("~", "operator")) or (block is None and not is_default):
            return None
        if block is not None and block.type == "try_statement":
            block = block.child_by_field_name("body")
        span = self.source.span(node)
        name_node = declarator.child_by_field_name("declarator") or node
        with self.names.function(FunctionScope(owner)) as scope:
            scope.variables.update(row.name for row in self._template_parameters)
            params = self.parameters(declarator)
            if block is None and params:
                return None
            is_constructor = owner is not None and part.name == owner
            types, named = self._of_templates(owner if is_constructor else None, span)
            body = self._initialised(node, owner, span) if is_constructor else []
            if block is not None:
                join_references(block, self.names, self.source)
                body += [*self.own_copies(declarator, block), *self.block(block.named_children)]
            of_file = sorted(scope.assigned - scope.variables - scope.declared)
            if of_file:
                body.insert(0, facts.Global("global", of_file))
        first = [facts.Param("self", "normal")] if owner is not None else []
        return facts.Function(
            name, [*first, *params, *types], [*named, *body], [], None, False, False, span, self.source.span(name_node)
        )

    def _of_templates(self, constructed: str | None, span: Span) -> tuple[list[Param], list[Stmt]]:
        """The parameters that template arguments are passed to, and what begins the function: those of a function are
        its variables; those of a class, whose constructor this is, its objects keep."""
        unknown = facts.Opaque("a template argument", span)
        params: list[Param] = []
        named: list[Stmt] = []
        if constructed is not None:
            names = (row.name for row in self._template_parameters)  # nobody can write down those of a constructor
            named += [facts.Assign([facts.Name(name, span)], unknown, span) for name in names]
            for at, row in enumerate(self._class_parameters):
                params.append(facts.Param(calls.template_parameter(at), "keyword_only", facts.Literal(None, span)))
                named.append(self._kept(constructed, at, row, span))
            return params, named
        for at, row in enumerate(self._template_parameters):
            given_as = calls.template_parameter(at)
            default = unknown if row.default is None else self.lower_type(row.default)
            params.append(facts.Param(given_as, "keyword_only", default))
            named.append(facts.Assign([facts.Name(row.name, span)], facts.Name(given_as, span), span))
        return params, named

    def _kept(self, owner: str, at: int, row: TemplateParameter, span: Span) -> Stmt:
        """An object keeps a template argument: the given one, what a derived class says of its base, or the default."""
        itself, kept = facts.Name("self", span), calls.of_class(owner, at)
        default = facts.Opaque("a template argument", span) if row.default is None else self.lower_type(row.default)
        values = (itself, facts.Literal(kept, span), facts.Name(calls.template_parameter(at), span), default)
        value = facts.Call(self.names.library(TEMPLATE_ARGUMENT, span), given(values), span)
        return facts.Assign([facts.Attribute(itself, kept, span)], value, span)

    def parameters(self, declarator: Node) -> list[Param]:
        listed = declarator.child_by_field_name("parameters")
        params: list[Param] = []
        named = declarator.child_by_field_name("declarator")
        is_main = named is not None and self.source.text(named) == "main"
        for node in [] if listed is None else listed.named_children:
            if node.type == "variadic_parameter_declaration":
                params += self._pack(node)
            if node.type not in ("parameter_declaration", "optional_parameter_declaration"):
                continue
            variables = declared(node, self.names, self.source)
            kind = node.child_by_field_name("type")
            if not variables and kind is not None and self.source.text(kind) == "void":
                continue
            name = variables[0].name if variables and variables[0].name else f"_unnamed{len(params)}"
            value = node.child_by_field_name("default_value")
            default = None if value is None else self.lower(value)
            if is_main:
                default = facts.Opaque("the command line", self.source.span(node))
            self.names.declare(name)
            self.note_options(name, [] if kind is None else self.names.parts(kind))
            annotation = None if kind is None else self.names.resolve(self.names.parts(kind), self.source.span(kind))
            kind_of_type = annotation if _is_type(annotation) else None
            params.append(facts.Param(name, "normal", default, kind_of_type, _is_reference(node)))
        return params

    def _pack(self, node: Node) -> list[Param]:
        """``Names... names`` takes all arguments that are left."""
        words = _NAME.findall(self.source.text(node).rpartition("...")[2])
        for name in words:
            self.names.declare(name)
            self.names.scopes[-1].packs.add(name)
        return [facts.Param(name, "star") for name in words]

    def _initialised(self, node: Node, owner: str | None, span: Span) -> list[Stmt]:
        """What a constructor does before its body: the fields, the bases, the members of its list."""
        assert owner is not None
        body: list[Stmt] = []
        clauses = [child for child in node.named_children if child.type == "field_initializer_list"]
        names_bases = False
        for row in [row for clause in clauses for row in clause.named_children if row.type == "field_initializer"]:
            named = [child for child in row.named_children if child.type != "comment"]
            if not named:
                continue
            outer, self.before = self.before, []
            statement = self._initialiser(named[0], named[1] if len(named) > 1 else None, owner)
            body.extend((*self.before, statement))
            self.before = outer
            if isinstance(statement, facts.Expression):
                names_bases = True
                if _calls_own(statement, owner):
                    return body  # another constructor of the class does all of it
        bases = [] if names_bases else [self._calls(owner, BASES, span)]
        return [self._calls(owner, FIELDS, span), *bases, *body]

    def _initialiser(self, name: Node, arguments: Node | None, owner: str) -> Stmt:
        parts, span = self.names.written(self.names.parts(name)), self.source.span(name.parent or name)
        last = parts[-1]
        is_field = (
            name.type == "field_identifier" and not last.name[:1].isupper() and last.name not in self.names.classes
        )
        itself = facts.Name("self", span)
        if len(parts) > 1 and last.name == parts[-2].name and last.name not in self.names.namespaces:
            parts = parts[:-1]  # Base::Base() names the class twice
        if not is_field or len(parts) > 1 or last.name in self.names.aliases:
            values = [] if arguments is None else self.lower_all(arguments.named_children)
            base = self.names.resolve(parts, span)
            listed = (
                calls.node_arguments(values, self.source.words, self.names) if self.is_node(parts) else given(values)
            )
            called = facts.Attribute(base, "__init__", span)
            return facts.Expression(facts.Call(called, [facts.Argument(itself), *listed], span), span)
        target = facts.Attribute(itself, last.name, span)
        return facts.Assign([target], self._member_value(name, arguments, span), span)

    def is_node(self, parts: list[Part]) -> bool:
        """Whether a base is a node of rclcpp, which may be named without its namespace: a class of that name in another
        one takes what its own constructors take."""
        path, name = self.names.path(parts), parts[-1].name
        is_bare = not path and len(parts) == 1 and name not in self.names.classes
        return IN_PYTHON.get(path, "").endswith("Node") or (is_bare and name in ("Node", "LifecycleNode"))

    def _member_value(self, name: Node, arguments: Node | None, span: Span) -> Expr:
        """What ``member(…)`` of a constructor's list sets.  Where the type of the member is not known here, its class
        says whether that makes an object, such as a helper that is given its node."""
        nodes = [] if arguments is None else [child for child in arguments.named_children if child.type != "comment"]
        kind = self._type_of_member(name)
        is_given_itself = len(nodes) == 1 and self.source.text(nodes[0]) in ("this", "*this")
        if kind is not None and (is_given_itself or len(nodes) > 1 or (nodes and self._is_of_no_library(kind))):
            return self.construct(kind, arguments, span)
        if len(nodes) == 1 and nodes[0].type == "number_literal" and self._is_profile(name):
            return facts.Call(self.names.library("rclcpp.QoS", span), given(self.lower_all(nodes)), span)
        if len(nodes) == 1 and nodes[0].type not in _MAY_MAKE:
            return self.lower(nodes[0])
        which = (facts.Name("self", span), facts.Literal(self.source.text(name), span))
        return facts.Call(self.names.library(MEMBER, span), given([*which, *self.lower_all(nodes)]), span)

    def _is_of_no_library(self, kind: Node) -> bool:
        """Whether a type with a namespace is none of those that are known: no text, no number and no duration, which
        are what they are made of."""
        parts = self.names.written(self.names.parts(kind))
        return len(parts) > 1 and not self.names.path(parts) and not parts[0].name.startswith("std")

    def _is_profile(self, name: Node) -> bool:
        """Whether a member is an ``rclcpp::QoS``: its class says so or, where that is elsewhere, its constructor calls
        a setter that only a QoS has."""
        kind = self._type_of_member(name)
        if kind is not None:
            return self.names.path(self.names.parts(kind)) == "rclcpp.QoS"
        around: Node | None = name
        while around is not None and around.type != "function_definition":
            around = around.parent
        body = None if around is None else around.child_by_field_name("body")
        return body is not None and self.source.text(name) in _SET.findall(self.source.text(body))

    def _type_of_member(self, name: Node) -> Node | None:
        """The type of a member that is an object, no pointer, where its class is around; None where it is elsewhere."""
        around: Node | None = name
        while around is not None and around.type not in ("class_specifier", "struct_specifier"):
            around = around.parent
        block = None if around is None else around.child_by_field_name("body")
        for member in [] if block is None else block.named_children:
            declarator = member.child_by_field_name("declarator") if member.type == "field_declaration" else None
            if declarator is not None and declarator.type == "field_identifier" and declarator.text == name.text:
                return member.child_by_field_name("type")
        return None

    def _method(self, name: str, params: list[Param], body: list[Stmt], span: Span) -> facts.Function:
        of_self = facts.Param("self", "normal")
        return facts.Function(name, [of_self, *params], body, [], None, False, False, span, span)

    def _calls(self, own: str, method: str, span: Span) -> Stmt:
        """A call of what a class does for each of its objects."""
        cls = self._class_of_method or facts.Name(self.names.qualified(own), span)
        call = facts.Call(facts.Attribute(cls, method, span), given([facts.Name("self", span)]), span)
        return facts.Expression(call, span)


_MAY_MAKE = frozenset({"this", "pointer_expression", "identifier", "field_expression"})
"""What a member that is an object may be made with, or else be a copy of."""


def _is_reference(node: Node) -> bool:
    """Whether a parameter is written to for the caller: ``T & name``, ``T * name`` without ``const``."""
    declarator = node.child_by_field_name("declarator")
    is_constant = any(child.type == "type_qualifier" and child.text == b"const" for child in node.children)
    if declarator is None or is_constant:
        return False
    text = declarator.text or b""
    return declarator.type in ("reference_declarator", "pointer_declarator") and not text.startswith(b"&&")


def function_declarator(node: Node) -> Node | None:
    """The part of a definition that has the name and the parameters of a function."""
    inner = node.child_by_field_name("declarator")
    while inner is not None and inner.type in ("pointer_declarator", "reference_declarator"):
        inner = inner.child_by_field_name("declarator") or next(
            (child for child in inner.named_children if child.type.endswith("declarator")), None
        )
    return inner if inner is not None and inner.type == "function_declarator" else None


def _calls_own(statement: facts.Expression, owner: str) -> bool:
    call = statement.value
    return isinstance(call, facts.Call) and call.func.dotted == f"{owner}.__init__"


def _is_type(annotation: Expr | None) -> bool:
    return isinstance(annotation, (facts.Name, facts.Attribute))


__all__ = ["BASES", "FunctionLowering", "TemplateParameter", "function_declarator"]

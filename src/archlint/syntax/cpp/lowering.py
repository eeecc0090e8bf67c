"""A C++ file lowered to facts.

What a class is in C++ it is in Python's words: a constructor is ``__init__``, which calls the ``__fields__`` of its own
class first; a method that is defined outside of its class is set on it; what stands in a namespace stands in the file.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.syntax import facts
from archlint.syntax.cpp.comments import find_suppressions
from archlint.syntax.cpp.damage import problems_of
from archlint.syntax.cpp.declared import declared
from archlint.syntax.cpp.literals import number_of, text_of
from archlint.syntax.cpp.lower_classes import ClassLowering
from archlint.syntax.cpp.macro_heads import HOLDERS, macro_in_front
from archlint.syntax.cpp.names import DEFINED, FunctionScope, Names, unnamed
from archlint.syntax.cpp.parser import parse
from archlint.syntax.cpp.source import SourceText
from archlint.syntax.cpp.uses import uses_of
from archlint.syntax.facts import FACTS_VERSION, Facts
from archlint.syntax.parts import names_in

if TYPE_CHECKING:
    from tree_sitter import Node

    from archlint.syntax.facts import Expr, Span, Stmt


def lower(data: bytes) -> Facts:
    """The facts of a C++ file, as far as the grammar understands it."""
    source = SourceText(data)
    lowering = Lowering(source, Names(source))
    tree = parse(data)
    lowering.note_classes(tree.root_node)
    body = lowering.block(tree.root_node.named_children)
    every: list[Stmt] = [*lowering.imports(), *body, *_started(body)]
    source.as_written()
    asked, fields, refused = uses_of(source, lowering.names, tree.root_node)
    return Facts(
        FACTS_VERSION,
        body=every,
        suppressions=find_suppressions(source, tree.root_node),
        problems=problems_of(source, tree.root_node, every),
        names=sorted(names_in(every)),
        member_uses=asked,
        typed_fields=fields,
        refused_uses=refused,
    )


def _started(body: list[Stmt]) -> list[Stmt]:
    """What calls ``main``, in Python's words."""
    span = next((row.name_span for row in body if isinstance(row, facts.Function) and row.name == "main"), None)
    if span is None:
        return []
    test = facts.Compare(facts.Name("__name__", span), ["=="], [facts.Literal("__main__", span)], span)
    call = facts.Expression(facts.Call(facts.Name("main", span), [], span), span)
    return [facts.If(test, [call], [], span)]


class Lowering(ClassLowering):
    """Lowers definitions, too."""

    def __init__(self, source: SourceText, names: Names) -> None:
        super().__init__(source, names)
        self._statements |= {
            "compound_statement": self._braces,
            "preproc_include": self._include,
            "preproc_def": self._define,
            "preproc_function_def": self.define_macro,
            "namespace_definition": self._namespace,
            "linkage_specification": self._linkage,
            "template_declaration": self._template,
        }

    def imports(self) -> list[Stmt]:
        """The imports of what the file names of interfaces and libraries."""
        rows: list[Stmt] = []
        for bound, (module, name) in sorted(self.names.imports.items()):
            span = self.names.spans.get(bound, (1, 1, 1, 1))
            rows.append(
                facts.ImportFrom(module, 0, [(name, bound)], span) if name else facts.Import(module, None, span)
            )
        return rows

    def note_classes(self, root: Node) -> None:
        """Take note of the namespaces and classes of the file, wherever they are."""
        waiting = [(root, "")]
        while waiting:
            node, space = waiting.pop()
            name = node.child_by_field_name("name")
            if name is not None and node.type in DEFINED:
                own = self.source.text(name).partition("<")[0]
                self.names.classes.add(own)
                if node.type == "enum_specifier":
                    self.names.enums.add(own)
                if _is_member(node.parent or node):
                    self.names.nested.add(own)
                if node.child_by_field_name("body") is not None:
                    self.names.placed.setdefault(own, set()).add(space)
            elif name is None and node.type in DEFINED:
                self.names.classes.add(unnamed(node))
                self.names.nested.add(unnamed(node))
            elif name is not None and node.type == "namespace_definition":
                spaces = self.source.text(name).split("::")
                self.names.namespaces.update(spaces)
                space = spaces[-1]
            elif node.type in ("preproc_function_def", "preproc_def"):
                self.note_macro(node)
            elif space and node.type in ("function_definition", "declaration") and not _is_member(node):
                for variable in declared(node, self.names, self.source):
                    self.names.placed.setdefault(variable.name, set()).add(space)
            if node.type in HOLDERS:
                waiting.extend((child, space) for child in node.named_children)

    # -------------------------------------------------------------------------------- preprocessor, spaces

    def _include(self, node: Node, body: list[Stmt]) -> None:
        path = node.child_by_field_name("path")
        name = "" if path is None else self.source.text(path)[1:-1]
        if "/" in name or name.endswith((".h", ".hpp", ".hxx", ".hh")):
            body.append(facts.ImportFrom(name, 0, [("*", "*")], self.source.span(node)))

    def _define(self, node: Node, body: list[Stmt]) -> None:
        """``#define TOPIC "name"``."""
        name, value = node.child_by_field_name("name"), node.child_by_field_name("value")
        if name is None or value is None:
            return
        written = self.source.text(value).strip()
        span = self.source.span(node)
        literal = _literal(written, span) or _joined(written, span)
        if literal is not None:
            body.append(facts.Assign([facts.Name(self.source.text(name), span)], literal, span))

    def _namespace(self, node: Node, body: list[Stmt]) -> None:
        name, block = node.child_by_field_name("name"), node.child_by_field_name("body")
        spaces = [] if name is None else self.source.text(name).split("::")
        self.names.spaces += spaces
        for child in [] if block is None else block.named_children:
            statements = self.block([child])
            is_space = child.type == "namespace_definition" or not spaces
            body.extend(statements if is_space else self._in_space(spaces[-1], statements))
        del self.names.spaces[len(self.names.spaces) - len(spaces) :]

    def _in_space(self, space: str, statements: Sequence[Stmt]) -> Iterator[Stmt]:
        """What a namespace holds has a name with it, too."""
        for row in statements:
            yield row
            match row:
                case facts.Class(name=name) | facts.Function(name=name) | facts.Assign(targets=[facts.Name(name)]):
                    if "::" not in name:
                        target = facts.Name(f"{space}::{name}", row.span)
                        yield facts.Assign([target], facts.Name(name, row.span), row.span)

    def _braces(self, node: Node, body: list[Stmt]) -> None:
        """Outside of functions, braces are the body of one whose head a macro writes, ``TEST_CASE("name") {…}``:
        nothing of it runs with the file."""
        head = macro_in_front(node)
        if head is None:
            self._inner_statements(node, body)
            return
        with self.names.function(FunctionScope(None)) as scope:
            inner = self.block(node.named_children)
            of_file = sorted(scope.assigned - scope.variables - scope.declared)
        span, name = self.source.span(node), self.source.text(head)
        inner = [facts.Global("global", of_file), *inner] if of_file else inner
        body.append(facts.Function(name, [], inner, [], None, False, False, span, self.source.span(head)))

    def _linkage(self, node: Node, body: list[Stmt]) -> None:
        block = node.child_by_field_name("body")
        if block is not None:
            body.extend(self.block(block.named_children if block.type == "declaration_list" else [block]))

    def _template(self, node: Node, body: list[Stmt]) -> None:
        parameters = node.child_by_field_name("parameters")
        outer = self._template_parameters
        self._template_parameters = self.template_parameters(node)
        body.extend(self.block(child for child in node.named_children if child != parameters))
        self._template_parameters = outer


def _is_member(node: Node) -> bool:
    """Whether something is declared inside a class."""
    return node.parent is not None and node.parent.type == "field_declaration_list"


def _literal(written: str, span: Span) -> Expr | None:
    if written.startswith(('"', 'R"')):
        text = text_of(written)
        return None if text is None else facts.Literal(text, span)
    number = number_of(written)
    return None if number is None else facts.Literal(number, span)


_WORDS = re.compile(r'"[^"\\\n]*"|[A-Za-z_]\w*')


def _joined(written: str, span: Span) -> Expr | None:
    """``PREFIX "/name"``: texts and other macros side by side; ``(5)`` in brackets."""
    if written.startswith("(") and written.endswith(")"):
        return _literal(written[1:-1].strip(), span)
    parts = _WORDS.findall(written)
    if len(parts) < 2 or not any(part.startswith('"') for part in parts) or _WORDS.sub("", written).strip():
        return None
    fields = [text_of(part) if part.startswith('"') else facts.Field(facts.Name(part, span)) for part in parts]
    return facts.FormatString([field for field in fields if field is not None], span)


__all__ = ["lower"]

"""Uses of macros that take arguments, lowered to :mod:`archlint.syntax.facts`.

In the file that defines it a macro is its text with the arguments in it.  Other files see a function, as far as the
text is one expression that takes its arguments whole.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING

from archlint.syntax import facts
from archlint.syntax.cpp.known_names import CALLER
from archlint.syntax.cpp.lower_packs import PackLowering
from archlint.syntax.cpp.macros import Macro, expanded, macro
from archlint.syntax.cpp.names import FunctionScope, Names
from archlint.syntax.cpp.parser import parse
from archlint.syntax.cpp.source import FixedText, SourceText

if TYPE_CHECKING:
    from tree_sitter import Node

    from archlint.syntax.facts import Argument, Expr, Span, Stmt

MOST_EXPANDED = 300
"""Uses of macros in one file that are followed."""
MOST_INSIDE = 5
"""Macros inside of macros that are followed."""
_WORTH = ("create_", "_parameter", '"', "#")
"""What the text of a macro has that other files may need to know."""


class MacroLowering(PackLowering):
    """Lowers macros, too."""

    def __init__(self, source: SourceText, names: Names) -> None:
        super().__init__(source, names)
        self._macros: dict[str, Macro] = {}
        self._texts: dict[str, str] = {}
        """The macros without arguments that are texts."""
        self._macro_names: set[str] = set()
        self._expanding: list[str] = []
        self._expanded_so_far = 0

    def note_macro(self, node: Node) -> None:
        """Take note of a macro that the file defines; one that is defined in two ways is none."""
        name, parameters = node.child_by_field_name("name"), node.child_by_field_name("parameters")
        value = node.child_by_field_name("value")
        if name is None or value is None:
            return
        own, written = self.source.text(name), self.source.text(value).strip()
        if own in self._macro_names:
            self._macros.pop(own, None)
            self._texts.pop(own, None)
            return
        self._macro_names.add(own)
        row = None if parameters is None else macro(self.source.text(parameters), written)
        if row is not None:
            self._macros[own] = row
        elif parameters is None and written.startswith('"'):
            self._texts[own] = written

    def macro_value(self, node: Node, span: Span) -> Expr | None:
        """What the use of a macro is as a value; None for a call, or one that is more than an expression."""
        with self._inside(node, span) as nodes:
            if len(nodes) != 1 or nodes[0].type != "expression_statement" or not nodes[0].named_child_count:
                return None
            return self.lower(nodes[0].named_children[0])

    def macro_statements(self, node: Node, span: Span) -> list[Stmt] | None:
        """The statements that a macro stands for; None for a call."""
        with self._inside(node, span) as nodes:
            return self.statements_of(nodes) if nodes else None

    def statements_of(self, nodes: list[Node]) -> list[Stmt]:
        """What statements are lowered to."""
        raise NotImplementedError

    @contextmanager
    def _inside(self, node: Node, span: Span) -> Iterator[list[Node]]:
        """The statements of the text of a macro while they are lowered; none for anything else."""
        text = self._text_for(node)
        nodes = [] if text is None else _statements_of_text(text)
        if not nodes:
            yield []
            return
        self._expanding.append(self.source.text(node.child_by_field_name("function") or node))
        try:
            with self._reading(FixedText(span)):
                yield nodes
        finally:
            self._expanding.pop()

    @contextmanager
    def _reading(self, source: FixedText) -> Iterator[None]:
        """Read another text in place of the file."""
        outer, self.source = self.source, source
        self.names.read_from(source)
        try:
            yield
        finally:
            self.source = outer
            self.names.read_from(outer)

    def _text_for(self, node: Node) -> str | None:
        called, listed = node.child_by_field_name("function"), node.child_by_field_name("arguments")
        if not self._macros or called is None or listed is None or called.type != "identifier":
            return None
        name = self.source.text(called)
        row = self._macros.get(name)
        if row is None or name in self._expanding or len(self._expanding) >= MOST_INSIDE:
            return None
        if self._expanded_so_far >= MOST_EXPANDED:
            return None
        self._expanded_so_far += 1
        nodes = [child for child in listed.named_children if child.type != "comment"]
        return expanded(row, [self.source.text(child) for child in nodes], self._texts)

    # ---------------------------------------------------------------------------------- for other files

    def define_macro(self, node: Node, body: list[Stmt]) -> None:
        """A macro as the function that other files use."""
        name = node.child_by_field_name("name")
        row = None if name is None else self._macros.get(self.source.text(name))
        if name is None or row is None or "##" in row.text or not any(word in row.text for word in _WORTH):
            return
        text = _as_words(row.text, {word: f"_text_{at}" for at, word in enumerate(row.parameters)})
        rows = _statements_of_text(text)
        if len(rows) != 1 or rows[0].type != "expression_statement":
            return
        body.append(self._as_function(self.source.text(name), row, rows[0], self.source.span(node)))

    def _as_function(self, name: str, row: Macro, statement: Node, span: Span) -> facts.Function:
        before, self.before = self.before, []
        try:
            with self._reading(FixedText(span)), self.names.function(FunctionScope(name)) as scope:
                texts = [f"_text_{at}" for at in range(len(row.parameters))]
                scope.variables.update((*row.parameters, *texts))
                value = statement.named_children[0]
                inner = self.statements_of([statement]) if value.type == "assignment_expression" else []
                returned = [] if inner else [facts.Return(self.lower(value), span)]
            inner = [*self.before, *inner, *returned]
        finally:
            self.before = before
        caller = facts.Call(self.names.library(CALLER, span), [], span)
        first: list[Stmt] = [facts.Assign([facts.Name("self", span)], caller, span)]
        none = facts.Literal(None, span)
        params = [facts.Param(word, "normal", by_reference=True) for word in row.parameters]
        written = (statement.text or b"").decode("utf-8", "replace")
        for at, word in enumerate(texts):
            if word not in written:
                continue
            params.append(facts.Param(text_argument(at), "keyword_only", none))
            first.append(facts.Assign([facts.Name(word, span)], facts.Name(text_argument(at), span), span))
        return facts.Function(name, params, [*first, *inner], [], None, False, False, span, span)

    def texts_given(self, name: str, arguments: Node) -> list[Argument]:
        """What the arguments of a macro of another file are as texts."""
        if not name.isupper() or name.startswith(("RCLCPP_", "RCUTILS_")):
            return []
        nodes = [child for child in arguments.named_children if child.type != "comment"]
        return [
            facts.Argument(facts.Literal(self.source.text(node), self.source.span(node)), text_argument(at))
            for at, node in enumerate(nodes)
            if node.type in ("identifier", "qualified_identifier", "number_literal")
        ]


def _statements_of_text(text: str) -> list[Node]:
    """The statements of a text, without those that are but a semicolon; none where it cannot be read."""
    root = parse(f"void _() {{ {text}; }}".encode()).root_node
    block = None if root.has_error else root.named_children[0].child_by_field_name("body")
    nodes = [] if block is None else block.named_children
    return [node for node in nodes if node.type != "comment" and node.child_count > 1]


def _as_words(text: str, words: dict[str, str]) -> str:
    """The text of a macro with a name of its own for each ``#parameter``."""
    text = re.sub(r"#\s*([A-Za-z_]\w*)", lambda match: f" {words.get(match[1], match[0])} ", text)
    return re.sub(r'(?<=")\s+(?=_text_\d)|(?<=_text_\d)\s+(?=")', " + ", text)  # texts side by side


def text_argument(at: int) -> str:
    """The parameter of a macro that takes the text of an argument."""
    return f"#{at}"


__all__ = ["MacroLowering"]

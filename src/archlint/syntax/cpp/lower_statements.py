"""Statements of C++ lowered to :mod:`archlint.syntax.facts`."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING

from archlint.syntax import facts
from archlint.syntax.cpp.declared import declared
from archlint.syntax.cpp.ends_of_blocks import end_of_block
from archlint.syntax.cpp.inner_scopes import SCOPES, join_references, original, rename_hidden
from archlint.syntax.cpp.known_names import SETTLED
from archlint.syntax.cpp.lower_assignments import AssignmentLowering
from archlint.syntax.cpp.lower_expressions import is_target
from archlint.syntax.facts import Param
from archlint.syntax.statements import JumpKind

if TYPE_CHECKING:
    from tree_sitter import Node

    from archlint.syntax.cpp.names import Names
    from archlint.syntax.cpp.source import SourceText
    from archlint.syntax.facts import Expr, Span, Stmt

MAX_NESTING = 100
"""Deepest nesting of statements that is kept."""

StatementKind = Callable[["Node", "list[Stmt]"], None]


class StatementLowering(AssignmentLowering):
    """Lowers statements, too."""

    def __init__(self, source: SourceText, names: Names) -> None:
        super().__init__(source, names)
        self._nesting = 0
        self._changed: set[str] | None = None
        """The texts that are changed in place, in the loop around; None outside of any."""
        self._statements: dict[str, StatementKind] = {
            "compound_statement": self._inner_statements,
            "ERROR": self._inner_statements,
            "expression_statement": self._expression,
            "declaration": self.declaration,
            "return_statement": self._return,
            "co_return_statement": self._return,
            "throw_statement": self._throw,
            "if_statement": self._if,
            "while_statement": self._while,
            "do_statement": self._do,
            "for_statement": self._for,
            "for_range_loop": self._for_range,
            "switch_statement": self._switch,
            "try_statement": self._try,
            "break_statement": lambda node, body: self._jump("break", node, body),
            "continue_statement": lambda node, body: self._jump("continue", node, body),
            "labeled_statement": self._labelled,
            "else_clause": self._inner_statements,
            "attributed_statement": self._inner_statements,
            "preproc_if": self._preprocessed,
            "preproc_ifdef": self._preprocessed,
            "alias_declaration": self.alias,
            "type_definition": self.typedef,
            "using_declaration": self.using,
            "namespace_alias_definition": self.namespace_alias,
        }

    def block(self, nodes: Iterable[Node]) -> list[Stmt]:
        """The statements of some nodes."""
        body: list[Stmt] = []
        if self._nesting >= MAX_NESTING:
            return body
        self._nesting += 1
        for node in nodes:
            self.statement(node, body)
        self._nesting -= 1
        return body

    def statement(self, node: Node, body: list[Stmt]) -> None:
        """Add what a statement is lowered to; what is not understood is left out."""
        lowering = self._statements.get(node.type)
        if lowering is None:
            return
        outer, self.before = self.before, []
        added: list[Stmt] = []
        if node.type in SCOPES and self.names.scopes:
            rename_hidden(node, self.names, self.source)
            join_references(node, self.names, self.source)
            with self.names.inner_block():
                lowering(node, added)
        else:
            lowering(node, added)
        body.extend((*self.before, *added))
        self.before = outer

    def body(self, node: Node) -> list[Stmt]:
        join_references(node, self.names, self.source)
        return self.block(node.named_children)

    def statements_of(self, nodes: list[Node]) -> list[Stmt]:
        return self.block(nodes)

    def _block_of(self, node: Node | None) -> list[Stmt]:
        return [] if node is None else self.block([node])

    def _inner_statements(self, node: Node, body: list[Stmt]) -> None:
        """What stands in braces, behind ``else`` or behind ``[[likely]]``."""
        body.extend((*self.block(node.named_children), *end_of_block(node, self.names, self.source)))

    def _labelled(self, node: Node, body: list[Stmt]) -> None:
        body.extend(self.block(node.named_children[1:]))

    # --------------------------------------------------------------------------------- simple statements

    def _expression(self, node: Node, body: list[Stmt]) -> None:
        inner = [child for child in node.named_children if child.type != "comment"]
        if not inner:
            return
        value, span = inner[0], self.source.span(node)
        match value.type:
            case "assignment_expression":
                self.assign(value, span, body)
            case "update_expression":
                target = self.lower_field(value, "argument")
                self.note_assigned(target)
                op: facts.BinaryOperator = "-" if b"--" in (value.text or b"") else "+"
                if is_target(target):
                    body.append(facts.Augmented(target, op, facts.Literal(1, span), span))
            case "delete_expression":
                return
            case "call_expression" if (swapped := self.swapped(value, span)) is not None:
                body.append(swapped)
            case "call_expression" if (rows := self.macro_statements(value, span)) is not None:
                body.extend(rows)
            case _ if (written := self.written_text(value, span)) is not None:
                body.append(written)
            case "binary_expression" if self.operator(value) == ">>":
                self.read_into(value, body)
            case _ if (changed := self.changed_text(value)) is not None:
                if self._changed is not None:
                    self._changed.add(changed)
                body.append(self.change(changed, value, span, in_loop=self._changed is not None))
            case _ if not self._is_logging(value) and not self.streamed(value, span, body):
                lowered = self.lower(value)
                if not isinstance(lowered, (facts.Literal, facts.Opaque, facts.Name, facts.Implicit)):
                    body.append(facts.Expression(lowered, span))

    def _is_logging(self, node: Node) -> bool:
        """Whether a call does nothing but log."""
        function = node.child_by_field_name("function") if node.type == "call_expression" else None
        return (
            function is not None
            and self.source.text(function).startswith(("RCLCPP_", "RCUTILS_", "ROS_"))
            and (self.source.text(function) != "RCLCPP_COMPONENTS_REGISTER_NODE")
        )

    def _return(self, node: Node, body: list[Stmt]) -> None:
        values = [child for child in node.named_children if child.type != "comment"]
        body.append(facts.Return(self.lower(values[0]) if values else None, self.source.span(node)))

    def _throw(self, node: Node, body: list[Stmt]) -> None:
        span = self.source.span(node)
        body.append(facts.Raise(facts.Opaque("an exception", span), span))

    def _jump(self, kind: JumpKind, node: Node, body: list[Stmt]) -> None:
        body.append(facts.Jump(kind, self.source.span(node)))

    # ------------------------------------------------------------------------------ compound statements

    def _if(self, node: Node, body: list[Stmt]) -> None:
        condition = node.child_by_field_name("condition")
        first = None if condition is None else condition.child_by_field_name("initializer")
        if first is not None:
            body.extend(self.block(first.named_children if first.type == "init_statement" else [first]))
        test = (
            facts.Opaque("a condition", self.source.span(node)) if condition is None else self._tested(condition, body)
        )
        then = self._block_of(node.child_by_field_name("consequence"))
        otherwise = self._block_of(node.child_by_field_name("alternative"))
        body.append(facts.If(test, then, otherwise, self.source.span(node)))

    def _tested(self, condition: Node, body: list[Stmt]) -> Expr:
        """The condition of an ``if`` or a loop, which may declare a variable."""
        value = condition.child_by_field_name("value")
        if value is not None and value.type == "declaration":
            self.declaration(value, body)
            variable = declared(value, self.names, self.source)
            if variable and variable[0].name:
                return facts.Name(variable[0].name, self.source.span(value))
        return self.lower(condition)

    def _while(self, node: Node, body: list[Stmt]) -> None:
        condition = node.child_by_field_name("condition")
        span = self.source.span(node)
        test = facts.Opaque("a condition", span) if condition is None else self._tested(condition, body)
        outer, self._changed = self._changed, set()
        body.append(facts.While(test, self._block_of(node.child_by_field_name("body")), [], span))
        # How often the loop changes a text follows from the text: where that is not followed, it is not known after it.
        for name in sorted(self._changed):
            text = facts.Name(name, span)
            settled = facts.Call(self.names.library(SETTLED, span), [facts.Argument(text)], span)
            body.append(facts.Assign([text], settled, span))
        self._changed = outer

    def _do(self, node: Node, body: list[Stmt]) -> None:
        span = self.source.span(node)
        outer, self._changed = self._changed, set()
        inner = self._block_of(node.child_by_field_name("body"))
        self._changed = outer
        test = self.lower_field(node, "condition")
        leave = facts.If(facts.Unary("not", test, span), [facts.Jump("break", span)], [], span)
        body.append(facts.While(facts.Literal(True, span), [*inner, leave], [], span))

    def _for(self, node: Node, body: list[Stmt]) -> None:
        span = self.source.span(node)
        first, test = node.child_by_field_name("initializer"), node.child_by_field_name("condition")
        update, inner = node.child_by_field_name("update"), node.child_by_field_name("body")
        iterated = self._iterated(first, test)
        if iterated is not None:
            self._loop_over(*iterated, inner, span, body)
            return
        counted = self._counted(first, test, update)
        if counted is not None:
            variable, start, end = counted
            self.names.declare(variable)
            numbers = facts.Call(facts.Name("range", span), [facts.Argument(start), facts.Argument(end)], span)
            body.append(facts.For(facts.Name(variable, span), numbers, self._block_of(inner), [], False, span))
            return
        if first is not None:
            body.extend(self.block([first]))
        condition: Expr = facts.Literal(True, span) if test is None else self.lower(test)
        block = self._block_of(inner)
        if update is not None:
            target = self.lower_field(update, "argument" if update.type == "update_expression" else "left")
            if is_target(target):
                block.append(facts.Assign([target], facts.Opaque("what a loop counts", span), span))
        body.append(facts.While(condition, block, [], span))

    def _loop_over(self, name: str, container: Node, inner: Node | None, span: Span, body: list[Stmt]) -> None:
        """A loop with an iterator, which is taken for what it points to."""
        self.names.declare(name)
        iterable = self.lower(container)
        if self._is_pair(name, inner):
            iterable = self._pairs_of(iterable, span)
        body.append(facts.For(facts.Name(name, span), iterable, self._block_of(inner), [], False, span))

    def _iterated(self, first: Node | None, test: Node | None) -> tuple[str, Node] | None:
        """The iterator and the container of ``for (auto it = names.begin(); it != names.end(); ++it)``."""
        if first is None or test is None or first.type != "declaration":
            return None
        variables = declared(first, self.names, self.source)
        value = variables[0].value if len(variables) == 1 else None
        begin = None if value is None else value.child_by_field_name("function")
        container = None if begin is None else begin.child_by_field_name("argument")
        if begin is None or container is None:
            return None
        name, owner = original(variables[0].name), self.source.text(container)
        ends = {f"{name}!={owner}{dot}{end}()" for dot in (".", "->") for end in ("end", "cend")}
        is_begin = self.source.text(begin).endswith(("begin", "cbegin"))
        return (variables[0].name, container) if is_begin and "".join(self.source.text(test).split()) in ends else None

    def _counted(self, first: Node | None, test: Node | None, update: Node | None) -> tuple[str, Expr, Expr] | None:
        """The variable and the bounds of ``for (int i = a; i < b; ++i)``."""
        if first is None or test is None or update is None or first.type != "declaration":
            return None
        variables = declared(first, self.names, self.source)
        operator, left = test.child_by_field_name("operator"), test.child_by_field_name("left")
        if len(variables) != 1 or test.type != "binary_expression" or update.type != "update_expression":
            return None
        name, value = variables[0].name, variables[0].value
        if operator is None or left is None or value is None or self.source.text(left) != name:
            return None
        word = self.source.text(operator)
        if word not in ("<", "<=", "!=") or "++" not in self.source.text(update):
            return None
        end = self.lower_field(test, "right")
        if word == "<=":
            end = facts.Binary("+", end, facts.Literal(1, self.source.span(test)), self.source.span(test))
        inner = value.named_children if value.type == "initializer_list" else [value]
        start = self.lower(inner[0]) if inner else facts.Literal(0, self.source.span(value))
        return name, start, end

    def _for_range(self, node: Node, body: list[Stmt]) -> None:
        span = self.source.span(node)
        iterable = self.lower_field(node, "right")
        target: Expr = facts.Opaque("a variable", span)
        for variable in declared(node, self.names, self.source):
            if variable.bound:
                for name in variable.bound:
                    self.names.declare(name)
                target = facts.Sequence("tuple", [facts.Name(name, span) for name in variable.bound], span)
                iterable = self._pairs_of(iterable, span)
            else:
                self.names.declare(variable.name)
                target = facts.Name(variable.name, span)
                if self._is_pair(variable.name, node.child_by_field_name("body")):
                    iterable = self._pairs_of(iterable, span)
        inner = self._block_of(node.child_by_field_name("body"))
        before, after = self.items_written(node, target, iterable, inner, span)
        body += [*before, facts.For(target, iterable, inner, [], False, span), *after]

    def _is_pair(self, name: str, body: Node | None) -> bool:
        """Whether a loop takes the two parts of what its variable holds."""
        written = "" if body is None else self.source.text(body)
        is_pair = re.search(rf"\b{re.escape(original(name))}(?:\.|->)(?:first|second)\b", written) is not None
        if is_pair and self.names.scopes:
            self.names.scopes[-1].pairs.add(name)
        return is_pair

    def _switch(self, node: Node, body: list[Stmt]) -> None:
        """Cases that end are arms of an ``if``; where one falls through to the next, each may run."""
        span = self.source.span(node)
        subject = self.lower_field(node, "condition")
        block = node.child_by_field_name("body")
        cases = [] if block is None else [child for child in block.named_children if child.type == "case_statement"]
        tests: list[Expr] = []
        arms: list[tuple[Expr | None, list[Stmt]]] = []
        for case in cases:
            value = case.child_by_field_name("value")
            if value is not None:
                tests.append(facts.Compare(subject, ["=="], [self.lower(value)], self.source.span(value)))
            inner = [child for child in case.named_children if child != value]
            if not inner and value is not None:
                continue  # it shares what the next one does
            statements = [s for s in self.block(inner) if not (isinstance(s, facts.Jump) and s.kind == "break")]
            test = None if value is None else tests[0] if len(tests) == 1 else facts.Boolean("or", tests, span)
            arms.append((test, statements))
            tests = []
        otherwise = next((statements for test, statements in arms if test is None), [])
        for test, statements in reversed(arms):
            if test is not None:
                otherwise = [facts.If(test, statements, otherwise, span)]
        body.extend(otherwise)

    def _try(self, node: Node, body: list[Stmt]) -> None:
        span = self.source.span(node)
        handlers = [
            facts.Handler(None, None, self._block_of(child.child_by_field_name("body")), self.source.span(child))
            for child in node.named_children
            if child.type == "catch_clause"
        ]
        attempted = self._block_of(node.child_by_field_name("body"))
        body.append(facts.Try(attempted, handlers, [], [], span))

    def _preprocessed(self, node: Node, body: list[Stmt]) -> None:
        """``#if``: what the build defines is not known; the guard of a header is no condition."""
        span = self.source.span(node)
        alternative = node.child_by_field_name("alternative")
        parts = (node.child_by_field_name("name"), node.child_by_field_name("condition"), alternative)
        is_guard = self._is_guard(node)
        self.names.conditions += not is_guard
        inner = self.block(child for child in node.named_children if child not in parts)
        if is_guard:
            body.extend(inner)
            return
        otherwise: list[Stmt] = []
        if alternative is not None and alternative.type == "preproc_else":
            otherwise = self.block(alternative.named_children)
        elif alternative is not None:
            self._preprocessed(alternative, otherwise)
        self.names.conditions -= 1
        if inner or otherwise:
            body.append(facts.If(facts.Opaque("a condition of the preprocessor", span), inner, otherwise, span))

    def _is_guard(self, node: Node) -> bool:
        name = node.child_by_field_name("name")
        if (
            node.type != "preproc_ifdef"
            or name is None
            or node.parent is None
            or node.parent.type != "translation_unit"
        ):
            return False
        defined = [child for child in node.named_children if child.type == "preproc_def"]
        given = defined[0].child_by_field_name("name") if defined else None
        return given is not None and self.source.text(given) == self.source.text(name)


__all__ = ["Param", "StatementLowering"]

"""Statements of a libcst tree lowered to :mod:`archlint.syntax.facts`."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import libcst as cst

from archlint.syntax import facts
from archlint.syntax.facts import FileProblem, Span, Stmt
from archlint.syntax.python.docstrings import docstring_of
from archlint.syntax.python.lower_expressions import ExpressionLowering
from archlint.syntax.python.lower_patterns import PatternLowering
from archlint.syntax.python.operators import BINARY
from archlint.syntax.python.positions import SpanFinder
from archlint.syntax.statements import JumpKind

MAX_NESTING = 100
"""Deepest nesting of statements, and longest chain of ``elif``, that is kept."""

StatementLowering = Callable[[Any, "list[Stmt]"], None]


class Lowering(ExpressionLowering):
    """Lowers the statements of one module."""

    def __init__(self, spans: SpanFinder) -> None:
        super().__init__(spans)
        self.problems: list[FileProblem] = []
        self._nesting = 0
        self._patterns = PatternLowering(self)
        self._statements: dict[type[cst.CSTNode], StatementLowering] = {
            cst.AnnAssign: self._annotated,
            cst.Assert: self._assert,
            cst.Assign: self._assign,
            cst.AugAssign: self._augmented,
            cst.Break: self._jump,
            cst.ClassDef: self._class,
            cst.Continue: self._jump,
            cst.Del: self._delete,
            cst.Expr: self._expression,
            cst.For: self._for,
            cst.FunctionDef: self._function,
            cst.Global: self._global,
            cst.If: self._if,
            cst.Import: self._import,
            cst.ImportFrom: self._import_from,
            cst.Match: self._match,
            cst.Nonlocal: self._global,
            cst.Pass: self._jump,
            cst.Raise: self._raise,
            cst.Return: self._return,
            cst.SimpleStatementLine: self._line,
            cst.Try: self._try,
            cst.TryStar: self._try,
            cst.TypeAlias: self._type_alias,
            cst.While: self._while,
            cst.With: self._with,
        }
        # `lazy import`: older releases of libcst do not know it.
        for name, lowering in (("LazyImport", self._import), ("LazyImportFrom", self._import_from)):
            if hasattr(cst, name):
                self._statements[getattr(cst, name)] = lowering

    def block(self, nodes: Sequence[cst.CSTNode]) -> list[Stmt]:
        """The statements of a module or a suite."""
        body: list[Stmt] = []
        if nodes and self._nesting >= MAX_NESTING:
            if not self.problems:
                line, column = self.span(nodes[0])[:2]
                self.problems.append(FileProblem(line, column, "nested too deeply to analyse from here on"))
            return body
        self._nesting += 1
        statements = self._statements
        for node in nodes:
            statements[node.__class__](node, body)
        self._nesting -= 1
        return body

    def suite(self, node: cst.BaseSuite | None) -> list[Stmt]:
        """The statements behind a colon."""
        return [] if node is None else self.block(node.body)

    def _clause(self, node: cst.Else | cst.Finally | None) -> list[Stmt]:
        return [] if node is None else self.suite(node.body)

    # -------------------------------------------------------------------------------- simple statements

    def _line(self, node: cst.SimpleStatementLine, body: list[Stmt]) -> None:
        statements = self._statements
        for small in node.body:
            statements[small.__class__](small, body)

    def _expression(self, node: cst.Expr, body: list[Stmt]) -> None:
        value = self.lower(node.value)
        if not isinstance(value, (facts.Literal, facts.Opaque)):  # a docstring, or `...`
            body.append(facts.Expression(value, self.span(node)))

    def _assign(self, node: cst.Assign, body: list[Stmt]) -> None:
        targets = [self.lower(target.target) for target in node.targets]
        body.append(facts.Assign(targets, self.lower(node.value), self.span(node)))

    def _type_alias(self, node: cst.TypeAlias, body: list[Stmt]) -> None:
        body.append(facts.Assign([self.lower(node.name)], self.lower(node.value), self.span(node)))

    def _annotated(self, node: cst.AnnAssign, body: list[Stmt]) -> None:
        target = self.lower(node.target)
        annotation = self.lower(node.annotation.annotation)
        body.append(facts.Annotated(target, annotation, self.optional(node.value), self.span(node)))

    def _augmented(self, node: cst.AugAssign, body: list[Stmt]) -> None:
        target = self.lower(node.target)
        op = BINARY[node.operator.__class__]
        body.append(facts.Augmented(target, op, self.lower(node.value), self.span(node)))

    def _return(self, node: cst.Return, body: list[Stmt]) -> None:
        body.append(facts.Return(self.optional(node.value), self.span(node)))

    def _raise(self, node: cst.Raise, body: list[Stmt]) -> None:
        body.append(facts.Raise(self.optional(node.exc), self.span(node)))

    def _assert(self, node: cst.Assert, body: list[Stmt]) -> None:
        body.append(facts.Assert(self.lower(node.test), self.span(node)))

    def _delete(self, node: cst.Del, body: list[Stmt]) -> None:
        target = self.lower(node.target)
        targets: list[facts.Expr] = target.elements if isinstance(target, facts.Sequence) else [target]
        body.append(facts.Delete(targets, self.span(node)))

    def _jump(self, node: cst.Break | cst.Continue | cst.Pass, body: list[Stmt]) -> None:
        body.append(facts.Jump(_JUMPS[node.__class__], self.span(node)))

    def _global(self, node: cst.Global | cst.Nonlocal, body: list[Stmt]) -> None:
        names = [self.identifier(item.name.value) for item in node.names]
        body.append(facts.Global("global" if isinstance(node, cst.Global) else "nonlocal", names))

    def _import(self, node: cst.Import, body: list[Stmt]) -> None:
        for name in node.names:
            alias = None if name.asname is None else self._bound_name(name.asname)
            body.append(facts.Import(_dotted(name.name), alias, self.span(node)))

    def _import_from(self, node: cst.ImportFrom, body: list[Stmt]) -> None:
        if isinstance(node.names, cst.ImportStar):
            names = [("*", "*")]
        else:
            names = [self._imported(alias) for alias in node.names]
        module = "" if node.module is None else _dotted(node.module)
        body.append(facts.ImportFrom(module, len(node.relative), names, self.span(node)))

    def _imported(self, alias: cst.ImportAlias) -> tuple[str, str]:
        name = _dotted(alias.name)
        return name, self.identifier(name) if alias.asname is None else self._bound_name(alias.asname)

    def _bound_name(self, node: cst.AsName) -> str:
        assert isinstance(node.name, cst.Name)
        return self.identifier(node.name.value)

    # ------------------------------------------------------------------------------ compound statements

    def _if(self, node: cst.If, body: list[Stmt]) -> None:
        test = self.lower(node.test)
        then = self.suite(node.body)
        if isinstance(node.orelse, cst.If):
            orelse = self.block([node.orelse])
        else:
            orelse = self._clause(node.orelse)
        body.append(facts.If(test, then, orelse, self.span(node)))

    def _for(self, node: cst.For, body: list[Stmt]) -> None:
        body.append(
            facts.For(
                self.lower(node.target),
                self.lower(node.iter),
                self.suite(node.body),
                self._clause(node.orelse),
                node.asynchronous is not None,
                self.span(node),
            )
        )

    def _while(self, node: cst.While, body: list[Stmt]) -> None:
        test = self.lower(node.test)
        body.append(facts.While(test, self.suite(node.body), self._clause(node.orelse), self.span(node)))

    def _with(self, node: cst.With, body: list[Stmt]) -> None:
        items = [
            facts.WithItem(self.lower(item.item), None if item.asname is None else self.lower(item.asname.name))
            for item in node.items
        ]
        is_async = node.asynchronous is not None
        body.append(facts.With(items, self.suite(node.body), is_async, self.span(node)))

    def _try(self, node: cst.Try | cst.TryStar, body: list[Stmt]) -> None:
        attempted = self.suite(node.body)
        handlers = [self._handler(handler) for handler in node.handlers]
        orelse, final = self._clause(node.orelse), self._clause(node.finalbody)
        body.append(facts.Try(attempted, handlers, orelse, final, self.span(node)))

    def _handler(self, node: cst.ExceptHandler | cst.ExceptStarHandler) -> facts.Handler:
        name = None if node.name is None else self._bound_name(node.name)
        return facts.Handler(self.optional(node.type), name, self.suite(node.body), self.span(node))

    def _match(self, node: cst.Match, body: list[Stmt]) -> None:
        subject = self.lower(node.subject)
        cases = [
            facts.Case(self._patterns.lower(case.pattern), self.optional(case.guard), self.suite(case.body))
            for case in node.cases
        ]
        body.append(facts.Match(subject, cases, self.span(node)))

    # ------------------------------------------------------------------------------------- definitions

    def _function(self, node: cst.FunctionDef, body: list[Stmt]) -> None:
        decorators = [self.lower(decorator.decorator) for decorator in node.decorators]
        params = self.parameters(node.params)
        returns = None if node.returns is None else self.lower(node.returns.annotation)
        outer, self.saw_yield = self.saw_yield, False
        inner = self.suite(node.body)
        is_generator, self.saw_yield = self.saw_yield, outer
        body.append(
            facts.Function(
                self.identifier(node.name.value),
                params,
                inner,
                decorators,
                returns,
                node.asynchronous is not None,
                is_generator,
                self._definition_span(node),
                self.span(node.name),
                docstring_of(node.body, self.lower),
            )
        )

    def _class(self, node: cst.ClassDef, body: list[Stmt]) -> None:
        name = self.identifier(node.name.value)
        decorators = [self.lower(decorator.decorator) for decorator in node.decorators]
        bases = self.arguments([*node.bases, *node.keywords])
        outer, self.private_prefix = self.private_prefix, _private_prefix(node.name.value)
        inner = self.suite(node.body)
        self.private_prefix = outer
        span, name_span = self._definition_span(node), self.span(node.name)
        docstring = docstring_of(node.body, self.lower)
        body.append(facts.Class(name, bases, inner, decorators, span, name_span, docstring))

    def _definition_span(self, node: cst.FunctionDef | cst.ClassDef) -> Span:
        """From the first decorator on."""
        return self.spans.between(node.decorators[0], node) if node.decorators else self.span(node)


_JUMPS: dict[type[cst.CSTNode], JumpKind] = {cst.Break: "break", cst.Continue: "continue", cst.Pass: "pass"}


def _private_prefix(class_name: str) -> str:
    """What Python puts before the private names of a class; nothing for a class named ``_``."""
    stripped = class_name.lstrip("_")
    return f"_{stripped}" if stripped else ""


def _dotted(node: cst.BaseExpression) -> str:
    names = []
    while isinstance(node, cst.Attribute):
        names.append(node.attr.value)
        node = node.value
    assert isinstance(node, cst.Name)
    return ".".join([node.value, *reversed(names)])

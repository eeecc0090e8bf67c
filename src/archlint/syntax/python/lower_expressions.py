"""Expressions of a libcst tree lowered to :mod:`archlint.syntax.facts`."""

from __future__ import annotations

import unicodedata
from collections.abc import Callable, Sequence
from typing import Any

import libcst as cst

from archlint.syntax import facts
from archlint.syntax.expressions import ComprehensionKind, DisplayKind, ParamKind
from archlint.syntax.facts import Expr
from archlint.syntax.python.lower_texts import TextLowering
from archlint.syntax.python.operators import BINARY, BOOLEAN, COMPARE, LARGEST_INTEGER, UNARY, folded
from archlint.syntax.python.positions import SpanFinder

MAX_DEPTH = 100
"""Deepest nesting of expressions that is kept.  Readers of the facts recurse, on an ordinary stack."""

_CONSTANTS: dict[str, bool | None] = {"None": None, "True": True, "False": False}
Lowering = Callable[[Any], Expr]


class ExpressionLowering:
    """Lowers expressions.  One object serves one module; it knows the class whose body it is in."""

    def __init__(self, spans: SpanFinder) -> None:
        self.span = spans.of
        self.spans = spans
        self.private_prefix = ""
        self.saw_yield = False
        self._depth = 0
        texts = TextLowering(self.lower, self.span)
        self._lowerings: dict[type[cst.CSTNode], Lowering] = {
            cst.Name: self._name,
            cst.Attribute: self._attribute,
            cst.Call: self._call,
            cst.SimpleString: texts.plain,
            cst.ConcatenatedString: texts.joined,
            cst.FormattedString: texts.joined,
            cst.Integer: self._integer,
            cst.Float: self._float,
            cst.Subscript: self._subscript,
            cst.BinaryOperation: self._binary,
            cst.UnaryOperation: self._unary,
            cst.BooleanOperation: self._boolean,
            cst.Comparison: self._comparison,
            cst.IfExp: self._conditional,
            cst.Tuple: self._tuple,
            cst.List: self._list,
            cst.Set: self._set,
            cst.Dict: self._dict,
            cst.StarredElement: self._starred,
            cst.GeneratorExp: self._generator_expression,
            cst.ListComp: self._list_comprehension,
            cst.SetComp: self._set_comprehension,
            cst.DictComp: self._dict_comprehension,
            cst.Lambda: self._lambda,
            cst.NamedExpr: self._walrus,
            cst.Await: self._await,
            cst.Yield: self._yield,
        }

    def lower(self, node: cst.CSTNode) -> Expr:
        """Any expression; what has no counterpart in the facts becomes :class:`~model.Opaque`."""
        lowering = self._lowerings.get(node.__class__)
        if lowering is None:
            return facts.Opaque(_WORDS.get(node.__class__.__name__, "expression"), self.span(node))
        if self._depth >= MAX_DEPTH:
            return facts.Opaque("expression nested too deeply", self.span(node))
        self._depth += 1
        lowered = lowering(node)
        self._depth -= 1
        return lowered

    def optional(self, node: cst.CSTNode | None) -> Expr | None:
        """The expression, or None where there is none."""
        return None if node is None else self.lower(node)

    def identifier(self, name: str) -> str:
        """A name as Python stores it: normalised, and mangled when it is private to a class."""
        if not name.isascii():
            name = unicodedata.normalize("NFKC", name)
        if self.private_prefix and name.startswith("__") and not name.endswith("__"):
            return self.private_prefix + name
        return name

    # ---------------------------------------------------------------------------------------- atoms

    def _name(self, node: cst.Name) -> Expr:
        value = node.value
        if value in _CONSTANTS:
            return facts.Literal(_CONSTANTS[value], self.span(node))
        return facts.Name(self.identifier(value), self.span(node))

    def _integer(self, node: cst.Integer) -> Expr:
        try:
            value = int(node.value, 0)
        except ValueError:  # Python refuses to convert thousands of digits
            return facts.Opaque("huge integer", self.span(node))
        if value > LARGEST_INTEGER:
            return facts.Opaque("huge integer", self.span(node))
        return facts.Literal(value, self.span(node))

    def _float(self, node: cst.Float) -> Expr:
        return facts.Literal(float(node.value), self.span(node))

    # ------------------------------------------------------------------------ names, calls, subscripts

    def _attribute(self, node: cst.Attribute) -> Expr:
        return facts.Attribute(self.lower(node.value), self.identifier(node.attr.value), self.span(node))

    def _call(self, node: cst.Call) -> Expr:
        return facts.Call(self.lower(node.func), self.arguments(node.args), self.span(node))

    def arguments(self, args: Sequence[cst.Arg]) -> list[facts.Argument]:
        """The arguments of a call or the bases and keywords of a class."""
        lower = self.lower
        return [
            facts.Argument(
                lower(arg.value),
                None if arg.keyword is None else self.identifier(arg.keyword.value),
                arg.star,
            )
            for arg in args
        ]

    def _subscript(self, node: cst.Subscript) -> Expr:
        elements = node.slice
        if len(elements) == 1 and not isinstance(elements[0].comma, cst.Comma):
            index = self._slice(elements[0].slice)
        else:
            index = facts.Sequence(
                "tuple",
                [self._slice(element.slice) for element in elements],
                self.spans.between(elements[0], elements[-1]),
            )
        return facts.Subscript(self.lower(node.value), index, self.span(node))

    def _slice(self, node: cst.BaseSlice) -> Expr:
        if isinstance(node, cst.Slice):
            return facts.Slice(self.optional(node.lower), self.optional(node.upper), self.optional(node.step))
        assert isinstance(node, cst.Index)
        value = self.lower(node.value)
        return facts.Starred(value) if node.star else value

    # -------------------------------------------------------------------------------------- operators

    def _binary(self, node: cst.BinaryOperation) -> Expr:
        # A long sum leans to the left: walk down it instead of recursing.
        chain = [node]
        while isinstance(chain[-1].left, cst.BinaryOperation):
            chain.append(chain[-1].left)
        if self._depth + len(chain) > MAX_DEPTH:
            return facts.Opaque("expression nested too deeply", self.span(node))
        self._depth += len(chain)
        result = self.lower(chain[-1].left)
        for link in reversed(chain):
            right = self.lower(link.right)
            result = facts.Binary(BINARY[link.operator.__class__], result, right, self.span(link))
        self._depth -= len(chain)
        return result

    def _unary(self, node: cst.UnaryOperation) -> Expr:
        op = UNARY[node.operator.__class__]
        operand = self.lower(node.expression)
        if isinstance(operand, facts.Literal):
            value = operand.value
            if op == "not":
                return facts.Literal(not value, self.span(node))
            number = None if isinstance(value, (bool, str)) or value is None else folded(op, value)
            if number is not None:
                return facts.Literal(number, self.span(node))
        return facts.Unary(op, operand, self.span(node))

    def _boolean(self, node: cst.BooleanOperation) -> Expr:
        kind = node.operator.__class__
        operands: list[cst.BaseExpression] = []
        pending: list[cst.BaseExpression] = [node]
        while pending:
            operand = pending.pop()
            if isinstance(operand, cst.BooleanOperation) and operand.operator.__class__ is kind:
                pending.append(operand.right)
                pending.append(operand.left)
            else:
                operands.append(operand)
        return facts.Boolean(
            BOOLEAN[node.operator.__class__], [self.lower(operand) for operand in operands], self.span(node)
        )

    def _comparison(self, node: cst.Comparison) -> Expr:
        return facts.Compare(
            self.lower(node.left),
            [COMPARE[target.operator.__class__] for target in node.comparisons],
            [self.lower(target.comparator) for target in node.comparisons],
            self.span(node),
        )

    def _conditional(self, node: cst.IfExp) -> Expr:
        return facts.Conditional(self.lower(node.test), self.lower(node.body), self.lower(node.orelse), self.span(node))

    # --------------------------------------------------------------------------------------- displays

    def _tuple(self, node: cst.Tuple) -> Expr:
        return self._sequence("tuple", node)

    def _list(self, node: cst.List) -> Expr:
        return self._sequence("list", node)

    def _set(self, node: cst.Set) -> Expr:
        return self._sequence("set", node)

    def _sequence(self, kind: DisplayKind, node: cst.Tuple | cst.List | cst.Set) -> Expr:
        elements = [
            self._starred(element) if isinstance(element, cst.StarredElement) else self.lower(element.value)
            for element in node.elements
        ]
        return facts.Sequence(kind, elements, self.span(node))

    def _starred(self, node: cst.StarredElement) -> Expr:
        return facts.Starred(self.lower(node.value))

    def _dict(self, node: cst.Dict) -> Expr:
        keys: list[Expr | None] = []
        values: list[Expr] = []
        for element in node.elements:
            keys.append(self.lower(element.key) if isinstance(element, cst.DictElement) else None)
            values.append(self.lower(element.value))
        return facts.Mapping(keys, values, self.span(node))

    # --------------------------------------------------------------------------------- comprehensions

    def _generator_expression(self, node: cst.GeneratorExp) -> Expr:
        return self._comprehension("generator", node, node.elt)

    def _list_comprehension(self, node: cst.ListComp) -> Expr:
        return self._comprehension("list", node, node.elt)

    def _set_comprehension(self, node: cst.SetComp) -> Expr:
        return self._comprehension("set", node, node.elt)

    def _dict_comprehension(self, node: cst.DictComp) -> Expr:
        return self._comprehension("dict", node, node.key, node.value)

    def _comprehension(
        self,
        kind: ComprehensionKind,
        node: cst.BaseComp,
        element: cst.BaseExpression,
        value: cst.BaseExpression | None = None,
    ) -> Expr:
        generators = []
        clause: cst.CompFor | None = node.for_in
        while clause is not None:
            generators.append(
                facts.Generator(
                    self.lower(clause.target),
                    self.lower(clause.iter),
                    [self.lower(condition.test) for condition in clause.ifs],
                )
            )
            clause = clause.inner_for_in
        return facts.Comprehension(kind, self.lower(element), self.optional(value), generators, self.span(node))

    # -------------------------------------------------------------------------- functions and the rest

    def _lambda(self, node: cst.Lambda) -> Expr:
        params = self.parameters(node.params)
        outer, self.saw_yield = self.saw_yield, False
        body = self.lower(node.body)
        self.saw_yield = outer
        return facts.Lambda(params, body, self.span(node))

    def parameters(self, node: cst.Parameters) -> list[facts.Param]:
        """Parameters in the order in which they are written."""
        params = [self._parameter(param, "positional_only") for param in node.posonly_params]
        params += [self._parameter(param, "normal") for param in node.params]
        if isinstance(node.star_arg, cst.Param):
            params.append(self._parameter(node.star_arg, "star"))
        params += [self._parameter(param, "keyword_only") for param in node.kwonly_params]
        if node.star_kwarg is not None:
            params.append(self._parameter(node.star_kwarg, "double_star"))
        return params

    def _parameter(self, node: cst.Param, kind: ParamKind) -> facts.Param:
        annotation = None if node.annotation is None else self.lower(node.annotation.annotation)
        return facts.Param(self.identifier(node.name.value), kind, self.optional(node.default), annotation)

    def _walrus(self, node: cst.NamedExpr) -> Expr:
        return facts.Assigned(self.lower(node.target), self.lower(node.value), self.span(node))

    def _await(self, node: cst.Await) -> Expr:
        return facts.Await(self.lower(node.expression), self.span(node))

    def _yield(self, node: cst.Yield) -> Expr:
        self.saw_yield = True
        if isinstance(node.value, cst.From):
            return facts.Yield(self.lower(node.value.item), True, self.span(node))
        return facts.Yield(self.optional(node.value), False, self.span(node))


_WORDS = {"Ellipsis": "ellipsis", "Imaginary": "complex number", "TemplatedString": "template string"}

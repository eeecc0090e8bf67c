"""The most that an expression may come to, as the function around it shows: ``min(x, 5)``, ``if abs(x) < 5:``."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from archlint.syntax import facts
from archlint.syntax.control_flow import graph_of
from archlint.syntax.flow_blocks import Block, reach
from archlint.syntax.parts import names_in
from archlint.syntax.walk import parts_of, statements_of

_Range = tuple[float, float]
_Test = tuple[facts.Expr, bool]
"""A condition, and whether it holds."""

_BELOW = frozenset({"<", "<="})
_ABOVE = frozenset({">", ">="})
_STEPS = 8
"""How many variables may be made of one another."""


def most(expression: facts.Expr, body: Sequence[facts.Stmt], params: Sequence[facts.Param]) -> float | None:
    """The most that a number may be which the last statements of a function use; None where nothing limits it.

    Only what the function itself shows counts: literals, its variables, the conditions around their assignments.
    """
    span: facts.Span | None = getattr(expression, "span", None)
    numbers = _Numbers(body, frozenset(param.name for param in params))
    tests = [] if span is None else numbers.tests_at(numbers.graph.evaluating(span))
    limits = numbers.range_of(expression, tests, _STEPS)
    return None if limits is None or math.isinf(limits[1]) else limits[1]


class _Numbers:
    def __init__(self, body: Sequence[facts.Stmt], params: frozenset[str]) -> None:
        self._body = body
        self._params = params
        self.graph = graph_of(body)

    def tests_at(self, blocks: Sequence[Block]) -> list[_Test]:
        """The conditions that still stand as they have come out where some blocks run: nothing on the way has set
        anew what they ask for."""
        outcomes = ((edge.test, edge.holds) for edge in self.graph.outcomes(blocks))
        return [(test, holds) for test, holds in outcomes if test is not None and self._stands(test, blocks)]

    def _stands(self, test: facts.Expr, blocks: Sequence[Block]) -> bool:
        asks = [block for block in self.graph.blocks if any(edge.test is test for edge in block.edges)]
        after = reach([edge.target for block in asks for edge in block.edges], avoiding=asks)
        between = after & self.graph.before(blocks, avoiding=asks)
        changed = {name for block in between for name in _names_changed(block.statement)}
        return changed.isdisjoint(names_in(test))

    def range_of(self, e: facts.Expr, tests: Sequence[_Test], steps: int) -> _Range | None:
        """The least and the most, infinite where one is open; None where it need not be a number at all."""
        tested = _tested(e, tests)
        own = self._own_range(e, tests, steps)
        if own is None:
            return tested
        return own if tested is None else (max(own[0], tested[0]), min(own[1], tested[1]))

    def _own_range(self, e: facts.Expr, tests: Sequence[_Test], steps: int) -> _Range | None:
        match e:
            case facts.Literal():
                number = e.number
                return None if number is None else (number, number)
            case facts.Name():
                return self._of_variable(e.id, steps) if steps and e.id not in self._params else None
            case facts.Unary(op="+"):
                return self.range_of(e.operand, tests, steps)
            case facts.Unary(op="-"):
                negated = self.range_of(e.operand, tests, steps)
                return None if negated is None else (-negated[1], -negated[0])
            case facts.Binary():
                left, right = self.range_of(e.left, tests, steps), self.range_of(e.right, tests, steps)
                return None if left is None or right is None else _combined(e.op, left, right)
            case facts.Conditional():
                arms = [self.range_of(e.body, (*tests, (e.test, True)), steps)]
                arms.append(self.range_of(e.orelse, (*tests, (e.test, False)), steps))
                return _any_of(arms)
            case facts.Call():
                return self._of_call(e, tests, steps)
        return None

    def _of_call(self, e: facts.Call, tests: Sequence[_Test], steps: int) -> _Range | None:
        function = e.func.variable
        if any(arg.keyword or arg.star for arg in e.args) or not e.args:
            return None
        given = [self.range_of(arg.value, tests, steps) for arg in e.args]
        known = [interval for interval in given if interval is not None]
        if function == "min" and known and len(given) > 1:
            low = min(interval[0] for interval in known) if len(known) == len(given) else -math.inf
            return low, min(interval[1] for interval in known)
        if function == "abs" and len(given) == 1 and not known:
            return 0.0, math.inf
        if len(known) < len(given):
            return None
        if function == "max" and len(given) > 1:
            return max(interval[0] for interval in known), max(interval[1] for interval in known)
        if function == "abs" and len(given) == 1:
            return 0.0, max(abs(known[0][0]), abs(known[0][1]))
        return known[0] if function == "float" and len(given) == 1 else None

    def _of_variable(self, name: str, steps: int) -> _Range | None:
        """Of all assignments to a variable together; each holds under the conditions around it."""
        assigned = [
            (value, self.graph.of(statement))
            for statement in statements_of(self._body)
            for value in _values_of(name, statement)
        ]
        walrus = parts_of(list(self._body), facts.Assigned)
        if any(value is None for value, _ in assigned) or any(name in names_in(w.target) for w in walrus):
            return None
        ranges = [
            self.range_of(value, self.tests_at(blocks), steps - 1)
            for value, blocks in assigned
            if value is not None and blocks
        ]
        return _any_of(ranges) if ranges else None


def _values_of(name: str, statement: facts.Stmt) -> Iterator[facts.Expr | None]:
    """What a statement itself assigns to a variable; None for what is not a plain assignment."""
    match statement:
        case facts.Assign():
            for target in statement.targets:
                if target.variable == name:
                    yield statement.value
                elif name in names_in(target):
                    yield None
        case facts.Annotated(value=value):
            if value is not None and statement.target.variable == name:
                yield value
        case _:
            if name in _names_bound(statement):
                yield None


def _names_changed(statement: facts.Stmt | None) -> frozenset[str]:
    """The variables that an assignment changes, be it an attribute of their object."""
    match statement:
        case facts.Assign(targets=targets):
            return frozenset(name for target in targets for name in names_in(target.root))
        case facts.Augmented(target=target) | facts.Annotated(target=target) | facts.For(target=target):
            return names_in(target.root)
    return frozenset()


def _names_bound(statement: facts.Stmt) -> frozenset[str]:
    """The names that the head of a statement binds."""
    match statement:
        case facts.Augmented(target=target) | facts.For(target=target):
            return names_in(target)
        case facts.With(items=items):
            return frozenset(name for item in items if item.target is not None for name in names_in(item.target))
        case facts.Global(names=names):
            return frozenset(names)
        case facts.Try(handlers=handlers):
            return frozenset(handler.name for handler in handlers if handler.name)
    return frozenset()


def _combined(op: facts.BinaryOperator, left: _Range, right: _Range) -> _Range | None:
    if op == "+":
        return left[0] + right[0], left[1] + right[1]
    if op == "-":
        return left[0] - right[1], left[1] - right[0]
    if op == "/":
        if right[0] <= 0.0 <= right[1]:
            return None
        right = (1.0 / right[1], 1.0 / right[0])
    elif op != "*":
        return None
    ends = [_product(bound, other) for bound in left for other in right]
    return min(ends), max(ends)


def _product(factor: float, other: float) -> float:
    return 0.0 if 0.0 in (factor, other) else factor * other


def _any_of(ranges: Sequence[_Range | None]) -> _Range | None:
    known = [interval for interval in ranges if interval is not None]
    if len(known) < len(ranges):
        return None
    return min(interval[0] for interval in known), max(interval[1] for interval in known)


def _tested(e: facts.Expr, tests: Sequence[_Test]) -> _Range | None:
    """What conditions that hold say of an expression: it is compared with a literal."""
    low, high, compared = -math.inf, math.inf, False
    for test, holds in tests:
        for left, op, right in _comparisons(test, holds):
            for side, other, below, above in ((left, right, _BELOW, _ABOVE), (right, left, _ABOVE, _BELOW)):
                limit = other.number
                if limit is None or not written_alike(side, e):
                    continue
                compared = compared or op in below or op in above
                low = max(low, limit) if op in above else low
                high = min(high, limit) if op in below else high
    return (low, high) if compared else None


_OPPOSITE = {"<": ">=", "<=": ">", ">": "<=", ">=": "<"}


def _comparisons(test: facts.Expr, holds: bool) -> Iterator[tuple[facts.Expr, str, facts.Expr]]:
    """The comparisons that are true where a condition comes out so."""
    match test:
        case facts.Unary(op="not"):
            yield from _comparisons(test.operand, not holds)
        case facts.Boolean() if (test.op == "and") == holds:
            for value in test.values:
                yield from _comparisons(value, holds)
        case facts.Compare() if holds or len(test.ops) == 1:
            ends = [test.left, *test.comparators]
            for left, op, right in zip(ends, test.ops, ends[1:], strict=False):
                if op in _OPPOSITE:
                    yield left, op if holds else _OPPOSITE[op], right


def written_alike(fact: object, other: object) -> bool:
    """Whether two facts are written alike, wherever they stand."""
    if isinstance(fact, (list, tuple)) and isinstance(other, (list, tuple)):
        return len(fact) == len(other) and all(written_alike(a, b) for a, b in zip(fact, other, strict=True))
    if isinstance(fact, facts.Base):
        return type(fact) is type(other) and all(
            written_alike(getattr(fact, name), getattr(other, name))
            for name in fact.__struct_fields__
            if name != "span"
        )
    return type(fact) is type(other) and fact == other

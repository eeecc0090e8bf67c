"""How long loops of a callback take at least: those whose number of iterations the file says.

The times are what CPython needs on a fast machine; a robot's computer takes several times as long.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.execution.called_here import called_here
from archlint.python_code.class_chains import targets_of
from archlint.records import dataclass
from archlint.syntax import facts
from archlint.syntax.parts import everything_in, names_in, parts_of
from archlint.syntax.walk import called_name

if TYPE_CHECKING:
    from archlint.syntax.facts import Span

_ITERATION = 10e-9
_OPERATION = 10e-9
_CALL = 30e-9
"""Seconds that an iteration, an operation and a call take at least."""
_DEPTH = 5
"""How many calls lead from a callback to a loop."""
_TAKES_ALL = frozenset({"all", "any", "list", "max", "min", "set", "sorted", "sum", "tuple"})
_PIXELS = 640 * 480
"""Pixels of a small image."""
_COARSE = 16
"""An image that is looked at in steps, of which only each 16th pixel or fewer are."""


@dataclass(frozen=True)
class Work:
    """A loop that always runs as often: how many ``seconds`` it takes at least, and how many ``iterations``.  One over
    the ``pixels`` of an image has as many as a small image has."""

    span: Span
    seconds: float
    iterations: int
    function: str
    pixels: bool = False


def work_of(function: facts.Function, file: facts.Facts) -> Iterator[Work]:
    """The loops that a function gets to whenever it runs to its end, also in methods and functions of the same file."""
    yield from _Walk(file).of_function(function, _DEPTH, frozenset())


@dataclass
class _Walk:
    """The way through the functions of one file."""

    file: facts.Facts

    def of_function(self, function: facts.Function, depth: int, seen: frozenset[int]) -> Iterator[Work]:
        if id(function) in seen or depth == 0 or _is_generator(function):
            return
        seen |= {id(function)}
        for statement in _always(function.body):
            work = self._of_statement(statement, function)
            if work is not None:
                yield work
            if not isinstance(statement, (facts.For, facts.While)):
                for called in self._called(statement, function):
                    yield from self.of_function(called, depth - 1, seen)

    def _called(self, statement: facts.Stmt, caller: facts.Function) -> Iterator[facts.Function]:
        """What a statement calls in the same file."""
        for call in _unconditional(statement):
            called = called_here(call, caller, self.file)
            if called is not None:
                yield called

    def _of_statement(self, statement: facts.Stmt, function: facts.Function) -> Work | None:
        match statement:
            case facts.For() | facts.While():
                if _is_over_pixels(statement, function):
                    return Work(statement.span, _PIXELS * _ITERATION, _PIXELS, function.name, pixels=True)
                iterations, seconds = self._of_loop(statement)
                return Work(statement.span, seconds, iterations, function.name) if seconds else None
        worth = [row for part in parts_of(statement) for row in self._of_expression(part)]
        if not worth or statement.statements:
            return None
        iterations, seconds, span = max(worth, key=lambda row: row[1])
        return Work(span, seconds, iterations, function.name)

    # ------------------------------------------------------------------------------------------------ how long

    def _of_loop(self, loop: facts.For | facts.While) -> tuple[int, float]:
        """The iterations of a loop with the loops inside it, and the seconds; 0 for what is not known."""
        times = self._times(loop)
        if not times or _is_left(loop):
            return 0, 0.0
        inner = [self._of_loop(inside) for inside in _always(loop.body) if isinstance(inside, (facts.For, facts.While))]
        each = _ITERATION + sum(map(_cost, _always(loop.body))) + sum(seconds for _, seconds in inner)
        return times * max((count for count, _ in inner if count), default=1), times * each

    def _times(self, loop: facts.For | facts.While) -> int:
        if isinstance(loop, facts.For):
            return self._items(loop.iterable)
        match loop.test:
            case facts.Compare(left=facts.Name(id=counter), ops=["<" | "<="], comparators=[bound]):
                return self._number(bound) or 0 if _counts_up(loop, counter) else 0
        return 0

    def _items(self, iterable: facts.Expr) -> int:
        match iterable:
            case facts.Call(func=facts.Name(id="range"), args=args):
                bounds = [self._number(argument.value) for argument in args if not argument.star]
                known = [bound for bound in bounds if bound is not None]
                if len(known) == len(args) and 1 <= len(known) <= len(("start", "stop", "step")) and 0 not in known[2:]:
                    return len(range(*known))
        return 0

    def _of_expression(self, part: facts.Base) -> Iterator[tuple[int, float, Span]]:
        """``sum(range(10 ** 8))``, ``[x * x for x in range(10 ** 7)]``."""
        match part:
            case facts.Comprehension(generators=generators, element=element) if part.kind != "generator":
                yield from self._of_generators(generators, element, part.span)
            case facts.Call(args=[facts.Argument(value=given, keyword=None)]) if called_name(part) in _TAKES_ALL:
                match given:
                    case facts.Comprehension(generators=generators, element=element):
                        if called_name(part) not in ("all", "any"):
                            yield from self._of_generators(generators, element, part.span)
                    case facts.Call():
                        times = self._items(given)
                        if times and called_name(part) not in ("all", "any", "max", "min"):
                            yield times, times * _OPERATION, part.span

    def _of_generators(
        self, generators: Sequence[facts.Generator], element: facts.Expr, span: Span
    ) -> Iterator[tuple[int, float, Span]]:
        times = 1
        for generator in generators:
            times *= 0 if generator.conditions and len(generators) > 1 else self._items(generator.iterable)
        if times:
            conditional = any(generator.conditions for generator in generators)
            yield times, times * (_ITERATION + (0 if conditional else _cost(element))), span

    def _number(self, e: facts.Expr) -> int | None:
        """The whole number that an expression always is: a literal, a product or a power of such, or a name that the
        file sets once."""
        match e:
            case facts.Literal(value=int(number)) if not e.is_true:
                return number
            case facts.Literal(value=float(number)) if number.is_integer():
                return int(number)
            case facts.Call(func=facts.Name(id="int"), args=[facts.Argument(value=inner)]):
                return self._number(inner)
            case facts.Binary(op="*" | "**" | "+" | "-" as op, left=left, right=right):
                return _calculated(op, self._number(left), self._number(right))
            case facts.Name() | facts.Attribute():
                return self._constant(e.last_name)
        return None

    def _constant(self, name: str) -> int | None:
        """The value of a variable or an attribute, where all that has its name is set once, to a number."""
        values = [
            part.value
            for part in everything_in(self.file.body)
            if isinstance(part, (facts.Assign, facts.Annotated)) and any(t.last_name == name for t in part.assigned)
        ]
        targets = [target for target in targets_of(self.file.body) if target.last_name == name]
        others = [part for part in everything_in(self.file.body, facts.Augmented) if part.target.last_name == name]
        params = any(param.name == name for param in everything_in(self.file.body, facts.Param))
        if len(values) != 1 or len(targets) != 1 or others or params:
            return None
        match values[0]:
            case facts.Literal() | facts.Binary(left=facts.Literal(), right=facts.Literal()):
                return self._number(values[0])
        return None


_LARGEST = 10**15
"""What is larger is not calculated."""


def _calculated(op: str, left: int | None, right: int | None) -> int | None:
    if left is None or right is None or max(abs(left), abs(right)) > _LARGEST:
        return None
    match op:
        case "*":
            return left * right
        case "+":
            return left + right
        case "-":
            return left - right
    return left**right if 0 <= right <= 15 and abs(left) <= 100 else None


# --------------------------------------------------------------------------------------------------- what always runs


def _always(body: Sequence[facts.Stmt]) -> Iterator[facts.Stmt]:
    """The statements that run whenever a block runs to its end: not those under a condition."""
    for statement in body:
        match statement:
            case facts.With(body=inner) | facts.Try(body=inner):
                yield from _always(inner)
            case facts.Function() | facts.Class():
                pass
            case _:
                yield statement


def _unconditional(statement: facts.Stmt) -> Iterator[facts.Call]:
    """The calls of a statement that it always makes."""
    match statement:
        case facts.If(test=test):
            yield from parts_of(test, facts.Call)
        case facts.Match():
            pass
        case _:
            yield from parts_of(statement, facts.Call)


def _is_generator(function: facts.Function) -> bool:
    return function.is_async or any(True for _ in parts_of(function.body, facts.Yield))


def _is_left(loop: facts.For | facts.While) -> bool:
    """Whether something in a loop may end it early, or skip what follows in it."""
    ends = (facts.Return, facts.Raise, facts.Await)
    jumps = (part for part in parts_of(loop.body, facts.Jump) if part.kind != "pass")
    return any(True for _ in jumps) or any(isinstance(part, ends) for part in parts_of(loop.body))


def _counts_up(loop: facts.While, counter: str) -> bool:
    """Whether each iteration adds one to a variable, and nothing else sets it."""
    targets = [part for part in parts_of(loop.body) if any(t.variable == counter for t in part.assigned)]
    match targets:
        case [facts.Augmented(op="+", value=facts.Literal(value=1)) as step]:
            return any(statement is step for statement in loop.body)
    return False


def _cost(part: facts.Base) -> float:
    """The seconds that an expression, or a statement without a block, takes at least."""
    match part:
        case facts.For() | facts.While():
            return 0.0
        case facts.If(test=test):
            return _cost(test)
        case facts.Match():
            return 0.0
    calls = sum(1 for _ in parts_of(part, facts.Call))
    kinds = (facts.Binary, facts.Augmented, facts.Compare, facts.Subscript)
    return calls * _CALL + sum(isinstance(inner, kinds) for inner in parts_of(part)) * _OPERATION


# ------------------------------------------------------------------------------------------------------------ pixels


def _is_over_pixels(loop: facts.For | facts.While, function: facts.Function) -> bool:
    """Whether two nested loops go over all rows and columns of an image, and do something with each pixel."""
    if not isinstance(loop, facts.For) or _is_left(loop):
        return False
    sides = _sides(function)
    outer = _side(loop.iterable, sides)
    inner = [(inside, _side(inside.iterable, sides)) for inside in _always(loop.body) if isinstance(inside, facts.For)]
    for inside, (side, step) in inner:
        pair = {outer[0], side}
        if pair == {"height", "width"} and outer[1] * step < _COARSE:
            used = names_in(inside.body)
            return {loop.target.variable, inside.target.variable} <= used - {""}
    return False


def _side(iterable: facts.Expr, sides: dict[str, str]) -> tuple[str, int]:
    """Which side of an image a ``range()`` goes along, and in which steps."""
    match iterable:
        case facts.Call(func=facts.Name(id="range"), args=args) if args and not any(given.star for given in args):
            step = args[2].value.number if len(args) > len(("start", "stop")) else 1
            end = args[min(1, len(args) - 1)].value
            return _side_named(end, sides), int(step or _COARSE)
    return "", 1


def _side_named(e: facts.Expr, sides: dict[str, str]) -> str:
    match e:
        case facts.Name(id=name):
            return sides.get(name, "")
        case facts.Subscript(value=facts.Attribute(attr="shape"), index=facts.Literal(value=axis)):
            return {0: "height", 1: "width"}.get(axis, "") if isinstance(axis, int) else ""
        case facts.Attribute(attr="height" | "width" as side):
            return side
    return ""


def _sides(function: facts.Function) -> dict[str, str]:
    """The variables of a function that hold a side of an image: ``h, w = image.shape[:2]``."""
    sides: dict[str, str] = {}
    for assign in everything_in(function.body, facts.Assign):
        match assign:
            case facts.Assign(targets=[facts.Sequence(elements=[rows, columns, *_])], value=value):
                whole = value.value if isinstance(value, facts.Subscript) else value
                if whole.attribute == "shape":
                    sides |= {rows.variable: "height", columns.variable: "width"}
            case facts.Assign(targets=[facts.Name(id=name)], value=value):
                sides |= {name: side} if (side := _side_named(value, {})) else {}
    return sides


__all__ = ["Work", "work_of"]

"""What objects of rclpy the code of one file certainly has: times, durations, parameters, handles of goals.

It goes by what each variable and attribute is assigned, so that it needs nothing to be reached.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from itertools import pairwise

from archlint.python_code.class_chains import targets_of
from archlint.string_enum import StringEnum
from archlint.syntax import facts
from archlint.syntax.parts import Itself, everything_in, once_for, parts_of
from archlint.syntax.walk import given_to, is_none


class Kind(StringEnum):
    """What an expression is, in words."""

    TIME = "an rclpy Time"
    DURATION = "an rclpy Duration"
    STAMP = "a stamp message"
    NUMBER = "a number"
    PARAMETER = "a Parameter"
    VALUE = "a ParameterValue"
    GOAL = "the handle of a goal"


class Objects:
    """What one file calls the classes, and what it stores in attributes."""

    def __init__(self, file_facts: facts.Facts) -> None:
        self.classes: dict[str, Kind] = {}
        self.modules: set[str] = set()
        for part in everything_in(file_facts.body):
            match part:
                case facts.ImportFrom(module="rclpy.time" | "rclpy.duration" | "rclpy.clock", names=names):
                    of = {"Time": Kind.TIME, "Duration": Kind.DURATION}
                    self.classes |= {bound: of[name] for name, bound in names if name in of}
                case facts.Import(module="rclpy" | "rclpy.time" | "rclpy.duration", alias=None):
                    self.classes |= {"rclpy.time.Time": Kind.TIME, "rclpy.duration.Duration": Kind.DURATION}
                case facts.Import(module="time", alias=alias):
                    self.modules.add(alias or "time")
        self.tried = {
            Itself(part)
            for attempt in everything_in(file_facts.body, facts.Try)
            if not all(handler.caught.isdisjoint({"TypeError", "Exception"}) for handler in attempt.handlers)
            for part in everything_in(attempt.body)
        }
        self._values: dict[str, list[tuple[facts.Expr, facts.Function]]] = {}
        for function in everything_in(file_facts.body, facts.Function):
            for part in parts_of(function.body):
                match part:
                    case facts.Assign(targets=[facts.Attribute(attr=name)], value=value):
                        self._values.setdefault(name, []).append((value, function))
        stored = Counter(target.attribute for target in targets_of(file_facts.body))
        changed = {part.target.attribute for part in everything_in(file_facts.body, facts.Augmented)}
        self._values = {
            name: values for name, values in self._values.items() if stored[name] == len(values) and name not in changed
        }
        self.executes = _execute_callbacks(file_facts)
        self._kinds: dict[str, Kind | None] = {}
        self._scopes: dict[Itself[facts.Function], Variables] = {}

    def scope(self, function: facts.Function) -> Variables:
        """The variables of a function, worked out once."""
        key = Itself(function)
        if key not in self._scopes:
            self._scopes[key] = Variables(self, function)
        return self._scopes[key]

    def attribute(self, name: str) -> Kind | None:
        """What an attribute of that name holds, where all that the file stores in one is of that kind, or None."""
        if name not in self._kinds:
            self._kinds[name] = None  # while it is worked out: what leads back to itself is nothing certain
            values = [(value, function) for value, function in self._values.get(name, []) if not is_none(value)]
            self._kinds[name] = _only({self.scope(function).kind(value) for value, function in values})
        return self._kinds[name]

    def may_be_none(self, e: facts.Expr) -> bool:
        """Whether an expression is an attribute that the file sets to None, too, until it is there."""
        return any(is_none(value) for value, _ in self._values.get(e.attribute, []))


def _execute_callbacks(file_facts: facts.Facts) -> frozenset[str]:
    """The names of the functions that action servers of a file execute goals with, where nothing else mentions them."""
    mentions = Counter(name for part in everything_in(file_facts.body) if (name := part.last_name))
    given = Counter(
        callback.last_name
        for call in everything_in(file_facts.body, facts.Call)
        if call.func.last_name == "ActionServer" and not any(argument.star for argument in call.args)
        if (callback := given_to(call, "execute_callback", 3)) is not None
    )
    defined = Counter(function.name for function in everything_in(file_facts.body, facts.Function))
    return frozenset(name for name in given if mentions[name] == given[name] and defined[name] == 1)


def _first_argument(function: facts.Function) -> str:
    """The parameter that the first argument of a call fills, of a method called on its object."""
    names = [param.name for param in function.params if param.name != "self"]
    return names[0] if names and not function.decorators else ""


def _only(kinds: set[Kind | None]) -> Kind | None:
    return kinds.pop() if len(kinds) == 1 else None


class Variables:
    """The variables of one function."""

    def __init__(self, code: Objects, function: facts.Function) -> None:
        self._code = code
        self._values: dict[str, list[facts.Expr]] = {}
        self._kinds: dict[str, Kind | None] = {}
        self._goal = _first_argument(function) if function.name in code.executes else ""
        targets = Counter(target.variable for target in targets_of(function.body))
        if self._goal in targets:
            self._goal = ""
        changed = {part.target.variable for part in everything_in(function.body, facts.Augmented)}
        changed |= {param.name for param in everything_in(function, facts.Param)}
        changed |= {name for part in everything_in(function.body, facts.Global) for name in part.names}
        for part in parts_of(function.body):
            match part:
                case facts.Assign(targets=[facts.Name(id=name)], value=value):
                    self._values.setdefault(name, []).append(value)
        self._values = {
            name: values
            for name, values in self._values.items()
            if targets[name] == len(values) and name not in changed
        }
        self._straight = {Itself(name): value for name, value in _read_straight_after(function.body)}
        self._kinds_straight: dict[Itself[facts.Expr], Kind | None] = {}

    def _kind_straight(self, value: Itself[facts.Expr]) -> Kind | None:
        """What is assigned just before: worked out once, however often the next line reads it."""
        if value not in self._kinds_straight:
            self._kinds_straight[value] = self.kind(value.fact)
        return self._kinds_straight[value]

    def kind(self, e: facts.Expr) -> Kind | None:
        """What an expression certainly is."""
        match e:
            case facts.Literal():
                return None if e.number is None else Kind.NUMBER
            case facts.Name() if Itself(e) in self._straight:
                return self._kind_straight(Itself(self._straight[Itself(e)]))
            case facts.Name(id=name):
                return Kind.GOAL if name == self._goal and name else self._variable(name)
            case facts.Call():
                return self._called(e)
            case facts.Attribute(value=facts.Attribute(attr="header"), attr="stamp"):
                return Kind.STAMP
            case facts.Attribute(attr="nanoseconds", value=inner):
                return Kind.NUMBER if self.kind(inner) in (Kind.TIME, Kind.DURATION) else None
            case facts.Attribute(value=facts.Name(id="self"), attr=name):
                return self._code.attribute(name)  # of another object, other files may store what they like
            case facts.Binary(op=op, left=left, right=right):
                return _result(op, self.kind(left), self.kind(right))
        return None

    def _variable(self, name: str) -> Kind | None:
        if name not in self._kinds:
            self._kinds[name] = None  # as with attributes
            self._kinds[name] = _only({self.kind(value) for value in self._values.get(name, [])})
        return self._kinds[name]

    def _called(self, call: facts.Call) -> Kind | None:
        match call.func:
            case facts.Attribute(value=facts.Call(func=facts.Attribute(attr="get_clock")), attr="now"):
                return Kind.TIME
            case facts.Attribute(value=facts.Name(id=module), attr="time" | "monotonic" | "perf_counter"):
                return Kind.NUMBER if module in self._code.modules else None
            case facts.Attribute(value=owner, attr="get_parameter" | "declare_parameter") if _is_node(owner):
                return Kind.PARAMETER
            case facts.Attribute(value=owner, attr="get_parameter_value"):
                return Kind.VALUE if self.kind(owner) == Kind.PARAMETER else None
            case facts.Attribute(value=owner, attr="from_msg"):
                return self._code.classes.get(owner.dotted)
            case facts.Attribute(value=owner, attr="to_msg"):
                return Kind.STAMP if self.kind(owner) == Kind.TIME else None
        return self._code.classes.get(call.func.dotted)


def _read_straight_after(body: Sequence[facts.Stmt]) -> Iterator[tuple[facts.Name, facts.Expr]]:
    """The variables that a statement reads right behind the one that assigns them, each with what it has there,
    whatever else it is assigned elsewhere."""
    for before, after in pairwise(body):
        match before, after:
            case facts.Assign(targets=[facts.Name(id=name)], value=value), facts.Assign() | facts.Expression():
                parts = [*parts_of(after.value)]
                if not any(isinstance(part, (facts.Lambda, facts.Comprehension)) for part in parts):
                    yield from ((part, value) for part in parts if isinstance(part, facts.Name) and part.id == name)
    for statement in body:
        for block in () if isinstance(statement, (facts.Function, facts.Class)) else statement.blocks:
            yield from _read_straight_after(block)


def _is_node(e: facts.Expr) -> bool:
    """Whether an expression is called like a node: ``self``, ``node``, ``self._node``."""
    return e.last_name == "self" or e.last_name.lower().endswith("node")


def _result(op: str, left: Kind | None, right: Kind | None) -> Kind | None:
    match op, left, right:
        case "-", Kind.TIME, Kind.TIME:
            return Kind.DURATION
        case "+" | "-", Kind.TIME, Kind.DURATION:
            return Kind.TIME
        case "+" | "-" | "*" | "/" | "//", Kind.NUMBER, Kind.NUMBER:
            return Kind.NUMBER
    return None


@once_for
def objects_of(file_facts: facts.Facts) -> Objects:
    """What is known of a file's objects, worked out once."""
    return Objects(file_facts)


__all__ = ["Kind", "Objects", "Variables", "objects_of"]

"""When the methods of a class run, by its text: what its constructor leads to, and what rclpy calls back."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import field

from archlint.python_code.class_chains import methods_of
from archlint.records import dataclass
from archlint.string_enum import StringEnum
from archlint.syntax import facts
from archlint.syntax.control_flow import loop_of
from archlint.syntax.parts import Itself, everything_in, once_for, parts_of

INIT = "__init__"


class Called(StringEnum):
    """What makes rclpy call a method."""

    TIMER = "timer"
    MESSAGE = "message"
    REQUEST = "request"
    PARAMETERS = "parameters"
    ANSWER = "answer"


_REGISTERS = {
    "create_timer": Called.TIMER,
    "create_subscription": Called.MESSAGE,
    "registerCallback": Called.MESSAGE,
    "create_service": Called.REQUEST,
    "ActionServer": Called.REQUEST,
    "add_on_set_parameters_callback": Called.PARAMETERS,
    "add_done_callback": Called.ANSWER,
}


@dataclass
class MethodsAtWork:
    """The methods of a class by their names, what each of them leads to, and who is called back: ``registered`` has
    the method that registers, the one registered and for what."""

    methods: Mapping[str, facts.Function]
    leads_to: dict[str, set[str]] = field(default_factory=dict)
    registered: list[tuple[str, str, Called]] = field(default_factory=list)

    def after(self, names: Collection[str]) -> set[str]:
        """Some methods and all that they lead to, but for what they only register."""
        return _closure(names, self.leads_to)

    def leading_to(self, names: Collection[str]) -> set[str]:
        """Some methods and all that lead to them."""
        sources: dict[str, set[str]] = {}
        for method, others in self.leads_to.items():
            for other in others:
                sources.setdefault(other, set()).add(method)
        return _closure(names, sources)

    def called_for(self, name: str) -> set[Called]:
        """What a method is registered for."""
        return {called for _, registered, called in self.registered if registered == name}


def never_returns(work: MethodsAtWork) -> bool:
    """Whether the constructor, or a method that it calls in any case, has a loop that ends with ROS alone: until then
    rclpy calls nothing back, unless the loop spins."""
    constructor = work.methods[INIT]
    calls = (statement.value for statement in constructor.body if isinstance(statement, facts.Expression))
    called = (of_self(call.func) for call in calls if isinstance(call, facts.Call))
    functions = [constructor, *(work.methods[name] for name in called if name is not None and name in work.methods)]
    loops = (statement for function in functions for statement in function.body if isinstance(statement, facts.While))
    return any(_is_endless(loop) for loop in loops)


def _is_endless(loop: facts.While) -> bool:
    """``while rclpy.ok()`` or ``while True``, with no other way out."""
    runs_on = loop.test.truth is True or (isinstance(loop.test, facts.Call) and loop.test.func.last_name == "ok")
    return runs_on and not loop_of(loop).is_left_by_jump


def _closure(names: Collection[str], edges: Mapping[str, set[str]]) -> set[str]:
    reached, waiting = set(names), [*names]
    while waiting:
        new = edges.get(waiting.pop(), set()) - reached
        reached |= new
        waiting += new
    return reached


@once_for
def methods_at_work(code: facts.Class) -> MethodsAtWork:
    """The same of one class.  What the body of the class names outside of its methods counts as led to by the
    constructor."""
    work = MethodsAtWork({function.name: function for function in methods_of(code)})
    for function in methods_of(code):
        leads = work.leads_to.setdefault(function.name, set())
        registered = set[Itself[facts.Base]]()
        for part, name, called in _registrations(function):
            if name in work.methods:
                registered.add(Itself(part))
                work.registered.append((function.name, name, called))
        for part in everything_in(function.body, facts.Attribute):
            if of_self(part) in work.methods and Itself[facts.Base](part) not in registered:
                leads.add(part.attr)
    outside = (part.id for part in parts_of(code.body, facts.Name))
    work.leads_to.setdefault(INIT, set()).update(name for name in outside if name in work.methods)
    return work


def _registrations(function: facts.Function) -> Iterator[tuple[facts.Attribute, str, Called]]:
    for call in everything_in(function.body, facts.Call):
        called = _REGISTERS.get(call.func.last_name)
        for argument in () if called is None else call.args:
            for part in _callbacks_in(argument.value):
                name = of_self(part)
                if name is not None and called is not None:
                    yield part, name, called


def _callbacks_in(value: facts.Expr) -> Sequence[facts.Attribute]:
    match value:
        case facts.Attribute():
            return [value]
        case facts.Lambda(body=body):
            return [*everything_in([body], facts.Attribute)]
        case facts.Call(args=[first, *_]) if value.func.last_name == "partial":
            return _callbacks_in(first.value)
    return []


def of_self(part: facts.Base) -> str | None:
    """The name of an attribute of ``self``."""
    match part:
        case facts.Attribute(value=facts.Name(id="self"), attr=name):
            return name
    return None


__all__ = ["INIT", "Called", "MethodsAtWork", "methods_at_work", "never_returns", "of_self"]

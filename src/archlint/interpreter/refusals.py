"""What Python refuses with a TypeError: a call whose arguments do not fit, a loop over a number, a module as a base.

What stands behind it on the same path never runs.  Only callbacks are cut short there: a program whose start fails is
noticed by whoever starts it, and what its nodes would create still says what they are meant to be.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

from archlint.finding import Place
from archlint.interpreter import caught
from archlint.interpreter.machine import Phase, Refused
from archlint.interpreter.values import (
    ApiMethod,
    BoundMethod,
    ClassValue,
    FunctionValue,
    Instance,
    ModuleValue,
    Unknown,
    Value,
    alternatives,
)
from archlint.syntax import facts
from archlint.syntax.parts import everything_in, names_in, once_for

if TYPE_CHECKING:
    from archlint.interpreter.call_site import CallSite
    from archlint.interpreter.machine import Machine

_TRANSPARENT = frozenset({"staticmethod", "classmethod"})
"""Decorators that leave a function's parameters as they are."""


def check_call(machine: Machine, function: Value, site: CallSite, expression: facts.Call) -> Value | None:
    """Raise Refused where a call of a function or class of the workspace, or of a node's method, cannot bind its
    arguments, if the statement always comes to that call; note the place of the call in any case.

    While a program starts, what it calls is followed in spite of that (None); but no object is made of a class.
    """
    if not is_certain(machine):
        return None
    if isinstance(function, Unknown) and _is_missing(machine, function, expression):
        machine.note_refused(machine.place(expression.span))
    if site.open or not _refuses(machine, function, len(site.args), site.keywords):
        return None
    machine.note_refused(machine.place(expression.span))
    if machine.phase is Phase.LATER:
        if isinstance(function, ApiMethod):
            machine.library.note_refusal(function, site)
        raise Refused
    match function:
        case ClassValue(qualified=name):
            return Unknown(f"'{name}' does not take these arguments")
    return None


def _is_missing(machine: Machine, function: Value, expression: facts.Call) -> bool:
    """Whether a method is asked for that ``self`` has not: of an object that the program makes, of classes that are
    all here, in whose files nothing sets an attribute of that name."""
    match function, expression.func, machine.activation.self_value:
        case (
            Unknown(missing=str()),
            facts.Attribute(value=facts.Name() as owner, attr=name),
            Instance(cls=ClassValue() as cls, place=Place()) as target,
        ) if machine.evaluate(owner) is target:
            modules = {base.scope.module.path: base.scope.module for base in cls.classes}
            return not any(_may_set(module.facts, name) for module in modules.values())
    return False


def _may_set(code: facts.Facts, name: str) -> bool:
    """Whether code may set an attribute of this name, on whatever object."""
    if not names_in(code.body).isdisjoint({"setattr", "__dict__", "__setattr__", "__getattribute__"}):
        return True
    stores = (part.targets for part in everything_in(code.body) if isinstance(part, facts.Assign))
    return any(target.attribute == name for targets in stores for target in targets)


def is_module(machine: Machine, base: Value) -> bool:
    """Whether a class is to inherit from a module: ``import rclpy.node as Node``, then ``class Robot(Node)``."""
    return all(
        isinstance(option, ModuleValue) or (bool(option.dotted) and machine.library.is_module(option.dotted))
        for option in alternatives(base)
    )


def refuses_to_iterate(machine: Machine, iterable: Value) -> bool:
    """Whether a ``for`` over a value fails: ``for i in len(items)``."""
    match iterable.constant:
        case int() | float() if not iterable.via:
            return machine.phase is Phase.LATER
    return False


def is_certain(machine: Machine) -> bool:
    """Whether the statement that runs always comes to the expression that is evaluated."""
    activation = machine.activations[-1]
    return activation.scope.kind != "comprehension" and activation.settled == len(machine.branch_arms)


def note_error(machine: Machine, error: type[Exception]) -> None:
    """What is evaluated raises an exception of Python's own: go on at the handler that is there for it, if one around
    it in the same function is, and if it is certain that it comes to this."""
    if not is_certain(machine):
        return
    names = [cls.__name__ for cls in error.__mro__]
    for attempt, arms in reversed(machine.activation.catching):
        handler = caught.handler_of(attempt.handlers, names)
        if handler is not None and arms == len(machine.branch_arms):
            raise caught.Raised(handler)
        if handler is not None or attempt.final or not all(map(caught.is_of_python, attempt.handlers)):
            return


def _refuses(machine: Machine, function: Value, given: int, keywords: Mapping[str, Value]) -> bool:
    match function:
        case ApiMethod():
            return machine.library.refuses(function, given, keywords)
        case BoundMethod(function=FunctionValue() as method):
            return _refused_by(method, given + 1, keywords)
        case FunctionValue():
            return _refused_by(function, given, keywords)
        case ClassValue():
            init, _ = function.lookup(machine, "__init__")
            return (
                isinstance(init, FunctionValue)
                and _refused_by(init, given + 1, keywords)
                and _is_made_plainly(machine, function)
            )
    return False


def _is_made_plainly(machine: Machine, cls: ClassValue) -> bool:
    """Whether ``__init__`` gets just what a class is called with: no decorator, no metaclass, no ``__new__`` and no
    base that is not known can come in between."""
    return (
        cls.lookup(machine, "__new__")[0] is None
        and machine.library.is_made_plainly(cls)
        and not any(
            base.ir.decorators or any(argument.keyword or argument.star for argument in base.ir.bases)
            for base in cls.classes
        )
    )


def _refused_by(function: FunctionValue, given: int, keywords: Mapping[str, Value]) -> bool:
    ir = function.ir
    if isinstance(ir, facts.Function) and (
        len(ir.decorators) != len(function.decorators) or not function.decorators <= _TRANSPARENT
    ):
        return False
    positional, required = _taken_by_position(ir)
    if not keywords and required <= given <= positional:
        return False  # as in most calls
    return not _binds(ir.params, given, keywords)


@once_for
def _taken_by_position(ir: facts.Function | facts.Lambda) -> tuple[int, int]:
    """How many arguments a function takes by position, and how many of them it needs where no names are given: more
    than it takes where it needs others by name."""
    positional = [param for param in ir.params if param.kind in ("positional_only", "normal")]
    by_name = any(param.kind == "keyword_only" and param.default is None for param in ir.params)
    required = [number for number, param in enumerate(positional, start=1) if param.default is None]
    return len(positional), len(positional) + 1 if by_name else max(required, default=0)


def _binds(params: Sequence[facts.Param], given: int, keywords: Mapping[str, Value]) -> bool:
    kinds = {param.kind for param in params}
    positional = [param for param in params if param.kind in ("positional_only", "normal")]
    if given > len(positional) and "star" not in kinds:
        return False
    left = [*positional[given:], *(param for param in params if param.kind == "keyword_only")]
    by_name = {param.name for param in left if param.kind != "positional_only"}
    taken = {param.name for param in positional[:given] if param.kind == "normal"}
    named = keywords.keys()
    if taken & named or ("double_star" not in kinds and not named <= by_name):
        return False
    return all(param.default is not None or (param.name in by_name and param.name in named) for param in left)

"""How classes get to know of each other: subclasses, ``__init_subclass__``, and decorators that register a class."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.interpreter import containers
from archlint.interpreter.call_site import CallSite
from archlint.interpreter.classes import SUBCLASSES, called
from archlint.interpreter.values import BoundMethod, ClassValue, FunctionValue, Partial, PythonValue, Value
from archlint.syntax import facts

if TYPE_CHECKING:
    from archlint.interpreter.machine import Machine


def decorators_of(machine: Machine, s: facts.Class) -> list[Value]:
    """The decorators of a class that are code of the workspace; those from elsewhere are known by name alone."""
    decorators: list[Value] = []
    for decorator in s.decorators:
        function = called(decorator)
        value = machine.evaluate(function)
        if isinstance(value, _OURS):
            decorators.append(value if function is decorator else machine.evaluate(decorator))
    return decorators


_OURS = (FunctionValue, BoundMethod, Partial)


def announce(machine: Machine, s: facts.Class, cls: ClassValue, decorators: list[Value]) -> Value:
    """What a class statement does beside making the class; what its name stands for then.

    A decorator that gives something else than a class, such as a function that keeps one object of it, leaves the
    class in sight: what is called makes an object of it.
    """
    for base in cls.bases:
        if isinstance(base, ClassValue):
            before = machine.store.get(base.key, SUBCLASSES) or ()
            machine.store.set(base.key, SUBCLASSES, (*(other for other in before if other.ir is not cls.ir), cls))
    if cls.bases and isinstance(cls.mro[1], ClassValue):
        hook, _ = cls.lookup(machine, "__init_subclass__", after=cls)
        if isinstance(hook, FunctionValue):
            machine.call(BoundMethod(hook, cls), CallSite(keywords=_keywords(machine, s)))
    value = cls
    for decorator in reversed(decorators):
        if isinstance(decorator, _OURS):
            result = machine.call(decorator, CallSite([value]))
            value = result if isinstance(result, ClassValue) else value
    return value


def _keywords(machine: Machine, s: facts.Class) -> dict[str, Value]:
    """``class Camera(Plugin, kind="camera")``: what ``__init_subclass__`` gets."""
    return {
        argument.keyword: machine.evaluate(argument.value)
        for argument in s.bases
        if argument.keyword is not None and argument.keyword != "metaclass"
    }


def subclasses(machine: Machine, cls: ClassValue) -> Value:
    """``cls.__subclasses__``: those of the modules that the program imports.

    Where it imports none of them in a way that is seen, it is taken to load them all.
    """

    def listed(*_: Value, **__: Value) -> Value:
        machine.index.import_all()
        every = machine.store.get(cls.key, SUBCLASSES) or ()
        imported = machine.index.imported_by(machine.activations[0].module) if machine.activations else frozenset()
        seen = [known for known in every if known.scope.module.path in imported]
        return containers.new_list(machine, seen or every)

    return PythonValue("__subclasses__", listed)


__all__ = ["announce", "decorators_of", "subclasses"]

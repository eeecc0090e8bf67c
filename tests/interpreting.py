"""Runs a piece of Python in the interpreter alone, and says what is known of its variables.

This is the one place that knows how a run is set up; tests of the interpreter go through it.
"""

from __future__ import annotations

import sys
import textwrap
import types
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from archlint import model
from archlint.finding import Place
from archlint.interpreter.activation import Activation
from archlint.interpreter.heap import Store
from archlint.interpreter.interpreter import Interpreter
from archlint.interpreter.library import Library
from archlint.interpreter.modules import Module, ModuleIndex
from archlint.interpreter.values import DictValue, Known, ListValue, OneOf, Unknown, Value
from archlint.launch.library import LaunchLibrary
from archlint.libraries.run import Run
from archlint.syntax.facts import Expression, Facts
from archlint.syntax.python.deep_stack import call_with_deep_stack
from archlint.syntax.python.lowering import lower
from archlint.workspace.model import SourceFile

OUTSIDE = "import outside\n"
"""What a name such as ``outside.value()`` needs: a package that is not here, so that nothing is known of it."""
WITH_LIBRARIES = True
"""Where Python's own library, rclpy and launch are known, as in a program's run; the interpreter alone knows none."""
COLLECTIONS = {"list": list, "tuple": tuple, "set": set, "generator": list}


class NotConstant(Exception):
    """A value of which more is unknown than not."""


@dataclass
class Interpreted:
    """A module after its body has run."""

    run: Interpreter
    module: Module

    def value(self, name: str) -> Value:
        """What the interpreter knows of a variable of the module."""
        assert self.module.scope is not None
        found = self.run.store.get(self.module.scope.key, name)
        assert isinstance(found, Value), f"'{name}' has no value"
        return found

    def names(self) -> list[str]:
        """The variables that the module has, in the order in which they came to be."""
        assert self.module.scope is not None
        return [
            slot
            for (key, slot), value in self.run.store.layers[0].items()
            if key == self.module.scope.key and isinstance(slot, str) and isinstance(value, Value)
        ]

    def constant(self, name: str) -> Any:
        """The value of a variable as Python has it; raises NotConstant where it is not known."""
        return self.as_python(self.value(name))

    def options(self, name: str) -> set[Any]:
        """What a variable may be; ``...`` stands for what is not known."""
        value = self.value(name)
        return {self._option(each) for each in (value.values if isinstance(value, OneOf) else (value,))}

    def _option(self, value: Value) -> Any:
        try:
            return self.as_python(value)
        except NotConstant:
            return ...

    def evaluate(self, expression: str, **variables: Value) -> Value:
        """What an expression is at the end of the module, with these variables beside its own."""
        module, run = self.module, self.run
        assert module.scope is not None
        for name, value in variables.items():
            run.store.set(module.scope.key, name, value)
        [statement] = _facts(f"({expression})").body
        assert isinstance(statement, Expression)
        run.activations.append(Activation(module.name, module, module.scope, [statement], run.store.depth))
        try:
            return run.evaluate(statement.value)
        finally:
            run.activations.pop()

    def is_known(self, name: str) -> bool:
        try:
            self.constant(name)
        except NotConstant:
            return False
        return True

    def reason(self, name: str) -> str:
        """Why nothing is known of a variable."""
        value = self.value(name)
        assert isinstance(value, Unknown), value
        return value.reason

    def as_python(self, value: Value) -> Any:
        if isinstance(value, Known):
            return value.value
        if isinstance(value, ListValue):
            items = value.items(self.run)
            if not items.open:
                return COLLECTIONS[value.kind](self.as_python(item) for item in items.values)
        if isinstance(value, DictValue):
            entries = value.entries(self.run)
            if not entries.open:
                return {self.as_python(key): self.as_python(item) for key, item in entries.entries.values()}
        raise NotConstant(value)


def interpret(source: str, with_libraries: bool = False, /, **others: str) -> Interpreted:
    """Run a module in the interpreter alone; ``others`` are modules beside it, by name (``__`` stands for a dot)."""
    return _interpreted({"it": source, **others}, _with_libraries if with_libraries else _alone)


def interpret_in(run: Callable[[ModuleIndex], Interpreter], source: str) -> Interpreted:
    """Run a module in an interpreter of one's own."""
    return _interpreted({"it": source}, run)


def _interpreted(texts: dict[str, str], make_run: Callable[[ModuleIndex], Interpreter]) -> Interpreted:
    files = {name: _file(name.replace("__", ".")) for name in texts}
    compiled = {files[name].path: _facts(text) for name, text in texts.items()}
    index = ModuleIndex(files.values(), lambda file: compiled[file.path])
    run = make_run(index)
    module = index.module(files["it"])
    assert module is not None
    call_with_deep_stack(lambda: run.import_module(module))
    faults = run.faults.by_place()
    assert not faults, faults
    return Interpreted(run, module)


def _alone(index: ModuleIndex) -> Interpreter:
    machine = Interpreter(index, Store())
    machine.library = Library()
    return machine


def _with_libraries(index: ModuleIndex) -> Interpreter:
    program = model.Program("it", "robot", "robot/it.py")
    main = model.Callback("main", "it", Place("robot/it.py", 1, 1, 1, 1), None)
    return Run(LaunchLibrary, index, Store(), program, main)


def evaluate(expression: str, **variables: Value) -> Value:
    """What an expression is where some variables have these values."""
    interpreted = interpret("pass")
    return interpreted.evaluate(expression, **variables)


def _file(name: str) -> SourceFile:
    path = name.replace(".", "/")
    return SourceFile(f"/robot/{path}.py", f"robot/{path}.py", "python", "robot", name)


def _facts(source: str) -> Facts:
    return lower(textwrap.dedent(source))


def in_python(source: str, **given: Any) -> dict[str, Any]:
    """The variables that Python itself has after a piece of code."""
    module = types.ModuleType("it")
    vars(module).update(given)
    before = set(vars(module))
    sys.modules["it"] = module  # dataclasses look there
    try:
        exec(compile(textwrap.dedent(source), "it.py", "exec"), vars(module))
    finally:
        del sys.modules["it"]
    return {name: value for name, value in vars(module).items() if name not in before and not name.startswith("__")}


def assert_like_python(source: str, with_libraries: bool = False, /, *, unknown: tuple[str, ...] = ()) -> None:
    """The interpreter knows each plain variable of a piece of code, and knows it as Python does.

    Of the variables in ``unknown`` it may know nothing, and never something else.
    """
    interpreted = interpret(source, with_libraries)
    for name, expected in in_python(source).items():
        if not _is_plain(expected):
            continue
        if name in unknown:
            assert not interpreted.is_known(name), f"{name} is known by now: take it off the list"
            continue
        found = interpreted.constant(name)
        assert (found, _types(found)) == (expected, _types(expected)), f"{name}: {found!r}, and in Python {expected!r}"


def _is_plain(value: Any) -> bool:
    if isinstance(value, (list, tuple, set)):
        return type(value) in (list, tuple, set) and all(map(_is_plain, value))
    if isinstance(value, dict):
        return type(value) is dict and all(map(_is_plain, (*value, *value.values())))
    return type(value) in (str, int, float, bool, type(None))


def _types(value: Any) -> Any:
    if isinstance(value, (list, tuple)):
        return (type(value), *map(_types, value))
    if isinstance(value, dict):
        return {key: _types(item) for key, item in value.items()}
    return type(value)

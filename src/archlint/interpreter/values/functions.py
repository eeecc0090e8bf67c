"""What can be called: functions of the workspace, methods of libraries, and functions of Python's own."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from archlint.interpreter.values.base import ClassValue, State, Value
from archlint.records import dataclass

if TYPE_CHECKING:
    from archlint.interpreter.modules import Scope
    from archlint.syntax import facts


@dataclass(frozen=True, slots=True)
class Builtin(Value):
    """A function or type of Python's own; ``self_value`` for methods of constants and containers."""

    name: str
    self_value: Value | None = None

    @property
    def is_object(self) -> bool:
        return True

    @property
    def inner(self) -> tuple[Value, ...]:
        return () if self.self_value is None else (self.self_value,)


@dataclass(frozen=True, slots=True, eq=False)
class FunctionValue(Value):
    """A function or lambda of the workspace."""

    ir: facts.Function | facts.Lambda
    scope: Scope
    """The scope it closes over."""
    qualified: str
    defaults: tuple[tuple[str, Value], ...] = ()
    owner: ClassValue | None = None
    """The class whose body defines it; what ``super()`` starts from."""
    decorators: frozenset[str] = frozenset()

    @property
    def has_identity(self) -> bool:
        return True

    @property
    def is_callable(self) -> bool:
        return True


@dataclass(frozen=True, slots=True)
class BoundMethod(Value):
    """A function with the object or class that it is called on."""

    function: Value
    self_value: Value

    @property
    def has_identity(self) -> bool:
        return True

    @property
    def is_callable(self) -> bool:
        return True

    @property
    def callee(self) -> Value:
        return self.function.callee

    @property
    def inner(self) -> tuple[Value, ...]:
        return (self.function, self.self_value)


@dataclass(frozen=True, slots=True)
class Partial(Value):
    """``functools.partial``."""

    function: Value
    args: tuple[Value, ...]
    keywords: tuple[tuple[str, Value], ...]

    @property
    def is_object(self) -> bool:
        return True

    @property
    def is_callable(self) -> bool:
        return True

    @property
    def callee(self) -> Value:
        return self.function.callee

    @property
    def inner(self) -> tuple[Value, ...]:
        return (self.function, *self.args, *(value for _, value in self.keywords))


@dataclass(frozen=True, slots=True)
class Declared(Value):
    """A function or variable of C++ that is declared, and defined in another file or further down."""

    owner: int
    """The key of the file that declares it first."""
    name: str


@dataclass(frozen=True, slots=True)
class Member(Value):
    """A member of C++ that is an object of a class: whoever reads it before it is made with arguments finds one that
    was made without any."""

    cls: Value
    keywords: tuple[tuple[str, Value], ...] = ()
    """The template arguments of the class."""

    @property
    def is_object(self) -> bool:
        return True


@dataclass(frozen=True, slots=True)
class ApiMethod(Value):
    """A method of an rclpy class, bound to a value: ``path`` is canonical (``rclpy.node.Node.create_timer``)."""

    path: str
    self_value: Value

    @property
    def is_object(self) -> bool:
        return True

    @property
    def inner(self) -> tuple[Value, ...]:
        return (self.self_value,)

    def truth(self, state: State) -> bool | None:
        return None  # what a library's object has may be a property: goal_handle.is_cancel_requested


@dataclass(frozen=True, slots=True, eq=False)
class PythonValue(Value):
    """A function of the run itself: called with the call's values, it returns a value."""

    name: str
    function: Callable[..., Value]

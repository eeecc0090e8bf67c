"""What an ``except`` is there for, as far as its text says."""

from __future__ import annotations

import builtins
import re
from collections.abc import Sequence

from archlint.syntax import facts

_IMPORT_ERRORS = {"ImportError", "ModuleNotFoundError"}
_OTHER_ERROR = re.compile(r"(?!Attribute)\w+(Error|Exception|Warning|Interrupt|Timeout)$")
"""A class whose name says what else went wrong."""
_REFUSALS = frozenset({"AttributeError", "TypeError"})
_BUILTIN = frozenset(
    name for name, cls in vars(builtins).items() if isinstance(cls, type) and issubclass(cls, BaseException)
)
_FOR_ALL = frozenset({"Exception", "BaseException"})
_LOGS = frozenset({"debug", "info", "warn", "warning", "error", "fatal", "critical", "exception"}) | {
    "print",
    "print_exc",
}
"""What is called to say that something went wrong: methods of loggers, and functions."""


class Raised(Exception):
    """Leads to the handler of a ``try`` around what runs: it raises an exception for certain."""

    def __init__(self, handler: facts.Handler) -> None:
        super().__init__()
        self.handler = handler


def is_import_error(expression: facts.Expr | None) -> bool:
    """Whether a handler is for imports that fail, and for nothing else."""
    classes = [] if expression is None else expression.unpacked
    return bool(classes) and all(cls.variable in _IMPORT_ERRORS for cls in classes)


def may_expect_missing_attribute(handler: facts.Handler) -> bool:
    """Whether a handler may be there for an attribute that is missing: not one for all errors that does no more than
    say so."""
    return _names_attribute_error(handler.type) and not (_is_for_all(handler.type) and _only_logs(handler))


def names_missing_attribute(handler: facts.Handler) -> bool:
    """Whether a handler says that it is there for an attribute that is missing."""
    return "AttributeError" in handler.caught


def expects_refusal(handler: facts.Handler) -> bool:
    """Whether a handler is there for a call that Python rejects: it names ``TypeError`` or ``AttributeError``."""
    return not handler.caught.isdisjoint(_REFUSALS)


def handler_of(handlers: Sequence[facts.Handler], names: Sequence[str]) -> facts.Handler | None:
    """The handler for an exception of Python's own, whose class and bases have these names; None where there is none,
    or one in front of it that is for other classes: nobody knows what it catches."""
    for handler in handlers:
        if not is_of_python(handler):
            return None
        if handler.type is None or not handler.caught.isdisjoint(names):
            return handler
    return None


def is_of_python(handler: facts.Handler) -> bool:
    """Whether a handler is for exceptions of Python's own only."""
    return handler.caught <= _BUILTIN


def only_goes_on(handler: facts.Handler) -> bool:
    """Whether a handler in a loop does no more than say that something went wrong, and go on to the next round."""
    return all(
        (isinstance(statement, facts.Jump) and statement.kind != "break") or _is_logging_call(statement, handler.name)
        for statement in handler.body
    )


def _names_attribute_error(expression: facts.Expr | None) -> bool:
    if isinstance(expression, facts.Sequence):
        return any(_names_attribute_error(element) for element in expression.elements)
    return _is_for_all(expression) or _OTHER_ERROR.match(_last_name(expression)) is None


def _is_for_all(expression: facts.Expr | None) -> bool:
    return expression is None or expression.last_name in _FOR_ALL


def _last_name(expression: facts.Expr | None) -> str:
    return "" if expression is None else expression.last_name


def _only_logs(handler: facts.Handler) -> bool:
    """Whether a handler says something or raises, and does nothing else but leave."""
    speaks = [isinstance(part, facts.Raise) or _is_logging_call(part, handler.name) for part in handler.body]
    return any(speaks) and all(said or _returns_nothing(part) for said, part in zip(speaks, handler.body, strict=True))


def _is_logging_call(statement: facts.Stmt, error: str | None) -> bool:
    """Whether a statement logs or prints words or the error: ``print(scan.ranges)`` may be another way to the data."""
    match statement:
        case facts.Expression(value=facts.Call(func=function, args=args)) if function.last_name in _LOGS:
            given = [argument.value for argument in args]
            return not given or any(_is_text(value) or (error and value.variable == error) for value in given)
    return False


def _is_text(value: facts.Expr) -> bool:
    match value:
        case facts.Call(func=function):
            return function.last_name in ("str", "repr", "format", "format_exc")
        case facts.FormatString():
            return True
        case facts.Binary(left=left):
            return _is_text(left)
    return value.text is not None


def _returns_nothing(statement: facts.Stmt) -> bool:
    match statement:
        case facts.Return(value=None | facts.Literal(value=None)):
            return True
    return False

"""``__all__`` of a module."""

from __future__ import annotations

from archlint.syntax.facts import (
    Annotated,
    Assign,
    Attribute,
    Augmented,
    Base,
    Binary,
    Call,
    Expr,
    Expression,
    Sequence,
    Span,
    Stmt,
)


def find_exports(body: list[Stmt]) -> list[str] | None:
    """The names in ``__all__`` where nothing but literals goes into it, else None."""
    exports: list[str] | None = None
    for statement in body:
        change = _change(statement)
        if change is None:
            continue
        replaces, value = change
        names = _names(value)
        if names is None:
            return None
        exports = names if replaces or exports is None else exports + names
    return exports


def _change(statement: Stmt) -> tuple[bool, Expr | None] | None:
    """Whether a statement replaces (or extends) ``__all__``, and with what."""
    match statement:
        case Assign(targets, value) if any(map(_is_all, targets)):
            return True, value
        case Annotated(target, value=Base() as value) if _is_all(target):
            return True, value
        case Augmented(target, op, value) if _is_all(target):
            return False, value if op == "+" else None
        case Expression(Call(Attribute(owner, method), args, span)) if _is_all(owner):
            return False, _added(method, [argument.value for argument in args], span)
    return None


def _added(method: str, given: list[Expr], span: Span) -> Expr | None:
    """What a method of the list adds to it; None where that is not known."""
    match method, given:
        case "extend", [value]:
            return value
        case "append", [value]:
            return Sequence("list", [value], span)
    return None


def _is_all(target: Expr) -> bool:
    return target.variable == "__all__"


def _names(value: Expr | None) -> list[str] | None:
    match value:
        case Binary("+", left, right):
            first, second = _names(left), _names(right)
            return None if first is None or second is None else first + second
        case Sequence(elements=elements):
            names = [element.text for element in elements if element.text is not None]
            return names if len(names) == len(elements) else None
    return None

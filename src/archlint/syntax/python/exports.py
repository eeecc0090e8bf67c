"""``__all__`` of a module."""

from __future__ import annotations

from archlint.syntax.facts import (
    Annotated,
    Assign,
    Attribute,
    Augmented,
    Binary,
    Call,
    Expr,
    Expression,
    Literal,
    Name,
    Sequence,
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
    if isinstance(statement, Assign) and any(map(_is_all, statement.targets)):
        return True, statement.value
    if isinstance(statement, Annotated) and statement.value is not None and _is_all(statement.target):
        return True, statement.value
    if isinstance(statement, Augmented) and _is_all(statement.target):
        return False, statement.value if statement.op == "+" else None
    if isinstance(statement, Expression) and isinstance(statement.value, Call):
        return _method_call(statement.value)
    return None


def _method_call(call: Call) -> tuple[bool, Expr | None] | None:
    method = call.func
    if not isinstance(method, Attribute) or not _is_all(method.value):
        return None
    if len(call.args) == 1 and method.attr in ("extend", "append"):
        value = call.args[0].value
        return False, value if method.attr == "extend" else Sequence("list", [value], call.span)
    return False, None


def _is_all(target: Expr) -> bool:
    return isinstance(target, Name) and target.id == "__all__"


def _names(value: Expr | None) -> list[str] | None:
    if isinstance(value, Binary) and value.op == "+":
        left, right = _names(value.left), _names(value.right)
        return None if left is None or right is None else left + right
    if not isinstance(value, Sequence):
        return None
    names = []
    for element in value.elements:
        if not isinstance(element, Literal) or not isinstance(element.value, str):
            return None
        names.append(element.value)
    return names

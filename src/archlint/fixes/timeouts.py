"""TMO001 to TMO003: give a wait a limit."""

from __future__ import annotations

import ast
from typing import TYPE_CHECKING

from archlint.finding import Edit, Fix

if TYPE_CHECKING:
    from archlint.finding import Finding
    from archlint.fixes.source import Source

SECONDS = "5.0"
_LIMITS = {"wait_for_service": "timeout_sec", "wait_for_server": "timeout_sec", "wait_for_message": "time_to_wait"}


def limit_wait(finding: Finding, source: Source) -> Fix | None:
    """``wait_for_service(timeout_sec=5.0)`` and the like."""
    call = _call(finding, source)
    if call is None or _name(call) not in _LIMITS:
        return None
    keyword = _LIMITS[_name(call)]
    return _limited(source, call, keyword, None if keyword == "time_to_wait" else 0)


def limit_call(finding: Finding, source: Source, distros: tuple[str, ...]) -> Fix | None:
    """``call(request, timeout_sec=5.0)``, which Humble does not have."""
    call = _call(finding, source)
    if call is None or _name(call) != "call" or "humble" in distros:
        return None
    return _limited(source, call, "timeout_sec", 1)


def limit_spin(finding: Finding, source: Source) -> Fix | None:
    """``spin_until_future_complete(…, timeout_sec=5.0)``, of rclpy or of an executor."""
    call = _call(finding, source)
    if call is None or _name(call) != "spin_until_future_complete":
        return None
    return _limited(source, call, "timeout_sec", 3 if _of_rclpy(call) else 1)


def _of_rclpy(call: ast.Call) -> bool:
    function = call.func
    return isinstance(function, ast.Name) or (
        isinstance(function, ast.Attribute) and isinstance(function.value, ast.Name) and function.value.id == "rclpy"
    )


def _call(finding: Finding, source: Source) -> ast.Call | None:
    found = source.node_at(finding.place, ast.Call)
    return found if isinstance(found, ast.Call) else None


def _name(call: ast.Call) -> str:
    function = call.func
    return function.attr if isinstance(function, ast.Attribute) else getattr(function, "id", "")


def _limited(source: Source, call: ast.Call, keyword: str, position: int | None) -> Fix | None:
    """Set the limit: where None or a negative number stands for it now, in place of that; else as a keyword."""
    if any(isinstance(one, ast.Starred) for one in call.args) or any(one.arg is None for one in call.keywords):
        return None
    given = next((one.value for one in call.keywords if one.arg == keyword), None)
    if given is None and position is not None and position < len(call.args):
        given = call.args[position]
    if given is not None:
        if not _endless(given):
            return None
        start, end = source.span(given)
        return _fix(source, start, end, SECONDS, keyword)
    # From the function on: what stands before the bracket may hold brackets of its own.
    start, end = source.span(call.func)[1], source.span(call)[1]
    tokens = source.tokens(start, end)
    if len(tokens) < 2 or tokens[-1][0] != ")":
        return None
    *_, before, _ = tokens
    if before[0] == ",":
        before = tokens[-3]
    separator = "" if len(tokens) == 2 else ", "
    return _fix(source, before[2], before[2], f"{separator}{keyword}={SECONDS}", keyword)


def _endless(value: ast.expr) -> bool:
    if isinstance(value, ast.UnaryOp) and isinstance(value.op, ast.USub):
        return isinstance(value.operand, ast.Constant)
    return isinstance(value, ast.Constant) and value.value is None


def _fix(source: Source, start: int, end: int, text: str, keyword: str) -> Fix:
    return Fix("safe", (Edit(source.place(start, end), text),), f"set {keyword} to {SECONDS} s")

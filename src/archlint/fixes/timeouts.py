"""TMO001 to TMO003: give a wait a limit."""

from __future__ import annotations

import ast
import re
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.finding import Edit, Fix
from archlint.fixes import scopes

if TYPE_CHECKING:
    from archlint.finding import Finding
    from archlint.fixes.source import Source

SECONDS = "5.0"
_NAME = re.compile(r"[\w/~]+\Z")
_LIMITS = {"wait_for_service": "timeout_sec", "wait_for_server": "timeout_sec", "wait_for_message": "time_to_wait"}


def limit_wait(finding: Finding, source: Source) -> Fix | None:
    """``wait_for_service(timeout_sec=5.0)`` and the like."""
    call = _call(finding, source)
    if call is None or _name(call) not in _LIMITS:
        return None
    keyword = _LIMITS[_name(call)]
    limited = _limited(source, call, keyword, None if keyword == "time_to_wait" else 0)
    if limited is None or keyword == "time_to_wait":
        return limited
    edits = _with_a_look_at_the_answer(source, call, finding)
    return replace(limited, edits=tuple(sorted((*limited.edits, *edits), key=lambda edit: edit.place)))


def _with_a_look_at_the_answer(source: Source, call: ast.Call, finding: Finding) -> list[Edit]:
    """What keeps a limited wait from being an answer that nobody reads (TMO005) or a loop that nothing ends (TMO004).

    A statement of its own gets an ``if not`` and a warning of the node, where there is a node at hand; ``while not``
    of it asks ``rclpy.ok()`` too.
    """
    parent = source.parents.get(call)
    if isinstance(parent, ast.Expr):
        return _warn(source, parent, call, finding)
    loop = None if parent is None else source.parents.get(parent)
    if isinstance(parent, ast.UnaryOp) and isinstance(loop, ast.While) and loop.test is parent:
        at = source.span(parent)[0]
        return [Edit(source.place(at, at), "rclpy.ok() and ")] if scopes.is_imported(source, "rclpy") else []
    return []


def _warn(source: Source, statement: ast.Expr, call: ast.Call, finding: Finding) -> list[Edit]:
    node = _node_at_hand(source, call, statement)
    line, (start, end) = source.line(statement.lineno), source.span(statement)
    indent = line[: len(line) - len(line.lstrip())]
    after = source.starts[statement.end_lineno or statement.lineno - 1] if _ends_line(source, end) else None
    if node is None or after is None or line[: start - source.starts[statement.lineno - 1]].strip():
        return []
    what = "action server" if _name(call) == "wait_for_server" else "service"
    name = finding.identity[1] if len(finding.identity) > 1 else ""
    words = f"the {what} {name} is not there" if _NAME.match(name) else f"the {what} is not there"
    step = "\t" if indent.startswith("\t") else "    "
    return [
        Edit(source.place(start, start), "if not "),
        Edit(source.place(end, end), ":"),
        Edit(source.place(after, after), f"{indent}{step}{node}.get_logger().warning('{words}'){source.newline}"),
    ]


def _ends_line(source: Source, end: int) -> bool:
    """Whether nothing but a comment, and the end of the line, follows."""
    return re.match(r"[ \t]*(#[^\r\n]*)?(\r\n|\r|\n)", source.text[end:]) is not None


def _node_at_hand(source: Source, call: ast.Call, statement: ast.stmt) -> str | None:
    """The node whose logger can say it: ``self`` of a node's method, or who made the client in this function."""
    function = scopes.enclosing_function(source, statement)
    arguments = [] if function is None else function.args.args
    me = ast.Name("self", ast.Load())
    if arguments and arguments[0].arg == "self" and scopes.is_node(source, me, statement):
        return "self"
    client = call.func.value if isinstance(call.func, ast.Attribute) else None
    return scopes.maker_in_function(source, client, statement) if isinstance(client, ast.Name) else None


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
    limited = _limited(source, call, "timeout_sec", 3 if _of_rclpy(call) else 1)
    if limited is not None and _of_a_result(source, call):
        return replace(limited, safety="unsafe")  # a goal may well take longer
    return limited


def _of_a_result(source: Source, call: ast.Call) -> bool:
    """Whether the future is that of an action's result, as far as the function around shows."""
    given = [*call.args, *(one.value for one in call.keywords)]
    names = {ast.unparse(one) for one in given if isinstance(one, (ast.Name, ast.Attribute))}
    asked = [one for one in given if isinstance(one, ast.Call)]
    function = scopes.enclosing_function(source, call)
    for one in ast.walk(function) if function is not None else ():
        if isinstance(one, ast.Assign) and names.intersection(ast.unparse(target) for target in one.targets):
            asked.extend(inner for inner in ast.walk(one.value) if isinstance(inner, ast.Call))
    return any(_name(one) == "get_result_async" for one in asked)


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

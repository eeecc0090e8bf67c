"""TMO001 to TMO003: give a wait a limit, and have somebody look at what came of it.

What was waited for may come later than the limit, so that none of these is safe.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Sequence
from dataclasses import dataclass, replace
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
    """``wait_for_service(timeout_sec=5.0)`` and the like, with something that reads the answer."""
    call = _call(finding, source)
    if call is None or _name(call) not in _LIMITS:
        return None
    keyword = _LIMITS[_name(call)]
    limited = _limited(source, call, keyword, None if keyword == "time_to_wait" else 0)
    if limited is None:
        return None
    answered = _look_at_message(source, call) if keyword == "time_to_wait" else _look_at_wait(source, call, finding)
    return None if answered is None else _with(limited, answered)


def _with(fix: Fix, edits: Sequence[Edit]) -> Fix:
    return replace(fix, edits=tuple(sorted((*fix.edits, *edits), key=lambda edit: edit.place)))


def _look_at_wait(source: Source, call: ast.Call, finding: Finding) -> list[Edit] | None:
    """What keeps a limited wait from being an answer that nobody reads (TMO005) or a loop that nothing ends (TMO004);
    None where that cannot be had.

    A statement of its own becomes a loop that waits on, says so, and ends with ROS: what follows may rely on the
    server, as before.  ``while not`` of it asks ``rclpy.ok()`` too.
    """
    parent = source.parents.get(call)
    if isinstance(parent, ast.Expr):
        return _say_and_go_on(source, parent, call, finding)
    loop = None if parent is None else source.parents.get(parent)
    if isinstance(parent, ast.UnaryOp) and isinstance(loop, ast.While) and loop.test is parent:
        at = source.span(parent)[0]
        return [Edit(source.place(at, at), "rclpy.ok() and ")] if scopes.is_imported(source, "rclpy") else None
    if isinstance(parent, (ast.Assign, ast.AnnAssign)):
        targets = parent.targets if isinstance(parent, ast.Assign) else [parent.target]
        return [] if all(_is_read(source, target, parent) for target in targets) else None
    return []


def _is_read(source: Source, target: ast.expr, statement: ast.stmt) -> bool:
    """Whether something reads a variable; an attribute of an object may be read by anybody."""
    if not isinstance(target, ast.Name):
        return True
    around = scopes.enclosing_function(source, statement) or source.tree
    return around is not None and any(
        isinstance(one, ast.Name) and one.id == target.id and isinstance(one.ctx, ast.Load) for one in ast.walk(around)
    )


def _say_and_go_on(source: Source, statement: ast.Expr, call: ast.Call, finding: Finding) -> list[Edit] | None:
    node = _node_at_hand(source, call, statement)
    lines = _own_lines(source, statement)
    if node is None or lines is None or not scopes.is_imported(source, "rclpy"):
        return None
    (start, end), indent = source.span(statement), lines.indent
    what = "action server" if _name(call) == "wait_for_server" else "service"
    name = finding.identity[1] if len(finding.identity) > 1 else ""
    words = f"waiting for the {what} {name}" if _NAME.match(name) else f"waiting for the {what}"
    return [
        Edit(source.place(start, start), "while rclpy.ok() and not "),
        Edit(source.place(end, end), ":"),
        _line_after(source, lines, f"{indent}{lines.step}{node}.get_logger().warning('{words}')"),
    ]


@dataclass(frozen=True)
class _Lines:
    """Where a statement stands that has its lines for itself."""

    indent: str
    step: str
    after: int
    """Offset of the line that follows."""


def _own_lines(source: Source, statement: ast.stmt) -> _Lines | None:
    line, (start, end) = source.line(statement.lineno), source.span(statement)
    indent = line[: len(line) - len(line.lstrip())]
    if not _ends_line(source, end) or line[: start - source.starts[statement.lineno - 1]].strip():
        return None
    step = "\t" if indent.startswith("\t") else "    "
    return _Lines(indent, step, source.starts[statement.end_lineno or statement.lineno])


def _line_after(source: Source, lines: _Lines, *texts: str) -> Edit:
    return Edit(source.place(lines.after, lines.after), "".join(f"{text}{source.newline}" for text in texts))


def _raise_unless(source: Source, statement: ast.stmt, answered: str, words: str) -> list[Edit] | None:
    """``if not …: raise TimeoutError(…)`` behind a statement."""
    lines = _own_lines(source, statement)
    if lines is None:
        return None
    raised = f"raise TimeoutError('{words} within {SECONDS} s')"
    return [_line_after(source, lines, f"{lines.indent}if {answered}:", f"{lines.indent}{lines.step}{raised}")]


def _look_at_message(source: Source, call: ast.Call) -> list[Edit] | None:
    """``received, message = wait_for_message(…)``: where nothing asks whether it was received, that raises."""
    statement = source.parents.get(call)
    if not isinstance(statement, ast.Assign) or len(statement.targets) != 1:
        return None
    names = statement.targets[0].elts if isinstance(statement.targets[0], ast.Tuple) else []
    if len(names) != 2 or not all(isinstance(name, ast.Name) for name in names):
        return None
    received, message = (ast.unparse(name) for name in names)
    if received != "_" and _is_read(source, names[0], statement):
        return []
    return _raise_unless(source, statement, f"{message} is None", "no message came")


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
    """``call(request, timeout_sec=5.0)``, which Humble does not have, and which gives None in Jazzy."""
    call = _call(finding, source)
    if call is None or _name(call) != "call" or "humble" in distros:
        return None
    limited = _limited(source, call, "timeout_sec", 1)
    statement = source.parents.get(call)
    if limited is None or "jazzy" not in distros or isinstance(statement, ast.Expr):
        return limited
    if not isinstance(statement, ast.Assign) or len(statement.targets) != 1:
        return None
    answer = statement.targets[0]
    if not isinstance(answer, (ast.Name, ast.Attribute)):
        return None
    edits = _raise_unless(source, statement, f"{ast.unparse(answer)} is None", "no answer came")
    return None if edits is None else _with(limited, edits)


def limit_spin(finding: Finding, source: Source) -> Fix | None:
    """``spin_until_future_complete(…, timeout_sec=5.0)``, of rclpy or of an executor, and a look at the future."""
    call = _call(finding, source)
    if call is None or _name(call) != "spin_until_future_complete" or _of_a_result(source, call):
        return None  # a goal may well take longer
    position = 1 if _of_rclpy(call) else 0
    limited = _limited(source, call, "timeout_sec", position + 2 if position else 1)
    named = next((one.value for one in call.keywords if one.arg == "future"), None)
    future = named if named is not None else call.args[position] if position < len(call.args) else None
    if limited is None or not isinstance(future, (ast.Name, ast.Attribute)) or _asks(source, call, future):
        return limited
    statement = source.parents.get(call)
    if not isinstance(statement, ast.Expr):
        return None
    edits = _raise_unless(source, statement, f"not {ast.unparse(future)}.done()", "no answer came")
    return None if edits is None else _with(limited, edits)


def _asks(source: Source, call: ast.Call, future: ast.expr) -> bool:
    """Whether the function around asks a future whether it is done, or whether its result is there."""
    around = scopes.enclosing_function(source, call) or source.tree
    return around is not None and any(
        one.attr == "done" or (one.attr == "result" and _is_asked(source, one))
        for one in ast.walk(around)
        if isinstance(one, ast.Attribute) and ast.unparse(one.value) == ast.unparse(future)
    )


def _is_asked(source: Source, method: ast.Attribute) -> bool:
    """``if future.result() is not None``."""
    asked = source.parents.get(source.parents.get(method, method))
    return isinstance(asked, (ast.Compare, ast.UnaryOp, ast.BoolOp, ast.If, ast.While, ast.IfExp))


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
    return Fix("unsafe", (Edit(source.place(start, end), text),), f"set {keyword} to {SECONDS} s")

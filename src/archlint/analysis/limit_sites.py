"""Where a wait can be given a limit, and where the code can look at what came of it.

What was waited for may come later than the limit: a limit that nobody looks at only hides the wait.
"""

from __future__ import annotations

import re
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.analysis.surrounding_code import is_imported, maker_in_function, node_class_around, tree_of
from archlint.edit_sites import AnswerCheck, LimitlessCall, LogLoop, Sites
from archlint.place import Place
from archlint.syntax import facts
from archlint.syntax.parts import everything_in
from archlint.syntax.tree import Tree
from archlint.syntax.walk import called_name, calls_in, given_to

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex

_NAME = re.compile(r"[\w/~]+\Z")
_LIMITS = {"wait_for_service": "timeout_sec", "wait_for_server": "timeout_sec", "wait_for_message": "time_to_wait"}
_NO_MESSAGE, _NO_ANSWER = "no message came", "no answer came"
_IS_NONE, _IS_NOT_DONE = "{} is None", "not {}.done()"


def sites_of_wait(workspace: WorkspaceIndex | None, place: Place, awaited: str) -> Sites | None:
    """For ``wait_for_service(timeout_sec=5.0)`` and the like, with something that reads the answer."""
    tree, call = _call_at(workspace, place)
    if workspace is None or tree is None or call is None or called_name(call) not in _LIMITS:
        return None
    keyword = _LIMITS[called_name(call)]
    of_message = keyword == "time_to_wait"
    limit = _limit(place, call, keyword, None if of_message else 0)
    if limit is None:
        return None
    if of_message:
        looked_at = _look_at_message(tree, limit, call)
    else:
        looked_at = _look_at_wait(workspace, tree, limit, call, awaited)
    return None if looked_at is None else Sites(limits=(looked_at,))


def _look_at_wait(
    workspace: WorkspaceIndex, tree: Tree, limit: LimitlessCall, call: facts.Call, awaited: str
) -> LimitlessCall | None:
    """What keeps a limited wait from being an answer that nobody reads (TMO005) or a loop that nothing ends (TMO004);
    None where that cannot be had.

    A statement of its own becomes a loop that waits on, says so, and ends with ROS: what follows may rely on the
    server, as before.  ``while not`` of it asks ``rclpy.ok()`` too.
    """
    file = limit.arguments.file
    parent = tree.parent(call)
    match parent:
        case facts.Expression():
            loop = _log_loop(workspace, tree, file, parent, call, awaited)
            return None if loop is None else replace(limit, loop=loop)
        case facts.Unary():
            match tree.parent(parent):
                case facts.While(test=test) if test is parent:
                    negated = Place.of(file, parent.span)
                    return replace(limit, negated=negated) if is_imported(tree, "rclpy") else None
        case facts.Assign(targets=targets):
            return limit if all(_is_read(tree, target, parent) for target in targets) else None
        case facts.Annotated(target=target):
            return limit if _is_read(tree, target, parent) else None
    return limit


def _is_read(tree: Tree, target: facts.Expr, statement: facts.Stmt) -> bool:
    """Whether something reads a variable; an attribute of an object may be read by anybody."""
    match target:
        case facts.Name(id=name):
            return tree.reads(name, tree.function_around(statement))
    return True


def _log_loop(
    workspace: WorkspaceIndex, tree: Tree, file: str, statement: facts.Expression, call: facts.Call, awaited: str
) -> LogLoop | None:
    node = _node_at_hand(workspace, tree, file, call, statement)
    if node is None or not is_imported(tree, "rclpy"):
        return None
    what = "action server" if called_name(call) == "wait_for_server" else "service"
    return LogLoop(Place.of(file, statement.span), node, f"{what} {awaited}" if _NAME.match(awaited) else what)


def _node_at_hand(
    workspace: WorkspaceIndex, tree: Tree, file: str, call: facts.Call, statement: facts.Expression
) -> str | None:
    """The node whose logger can say it: ``self`` of a node's method, or who made the client in this function."""
    function = tree.function_around(statement)
    normal = [] if function is None else [param.name for param in function.params if param.kind == "normal"]
    if normal[:1] == ["self"] and node_class_around(workspace, file, tree, statement) is not None:
        return "self"
    match call.func:
        case facts.Attribute(value=facts.Name(id=client)):
            return maker_in_function(tree, client, statement)
    return None


def _look_at_message(tree: Tree, limit: LimitlessCall, call: facts.Call) -> LimitlessCall | None:
    """``received, message = wait_for_message(…)``: where nothing asks whether it was received, that raises."""
    match tree.parent(call):
        case (
            facts.Assign(
                targets=[facts.Sequence(kind="tuple", elements=[facts.Name() as received, facts.Name() as message])]
            ) as statement
        ):
            if received.id != "_" and _is_read(tree, received, statement):
                return limit
            return replace(limit, check=_check(limit, statement, message, _IS_NONE, _NO_MESSAGE))
    return None


def _check(
    limit: LimitlessCall, statement: facts.Assign | facts.Expression, answer: facts.Name | facts.Attribute, test: str,
    words: str,
) -> AnswerCheck:  # fmt: skip
    file = limit.arguments.file
    return AnswerCheck(Place.of(file, statement.span), Place.of(file, answer.span), test, words)


def sites_of_call(workspace: WorkspaceIndex | None, place: Place, distros: tuple[str, ...]) -> Sites | None:
    """For ``call(request, timeout_sec=5.0)``, which Humble does not have, and which gives None in Jazzy."""
    tree, call = _call_at(workspace, place)
    if tree is None or call is None or called_name(call) != "call" or "humble" in distros:
        return None
    limit = _limit(place, call, "timeout_sec", 1)
    if limit is None:
        return None
    match tree.parent(call):
        case _ if "jazzy" not in distros:
            return Sites(limits=(limit,))
        case facts.Expression():
            return Sites(limits=(limit,))
        case facts.Assign(targets=[facts.Name() | facts.Attribute() as answer]) as statement:
            return Sites(limits=(replace(limit, check=_check(limit, statement, answer, _IS_NONE, _NO_ANSWER)),))
    return None


def sites_of_spin(workspace: WorkspaceIndex | None, place: Place) -> Sites | None:
    """For ``spin_until_future_complete(…, timeout_sec=5.0)``, of rclpy or of an executor, and a look at the future."""
    tree, call = _call_at(workspace, place)
    if tree is None or call is None or called_name(call) != "spin_until_future_complete":
        return None
    if _of_a_result(tree, call):
        return None  # a goal may well take longer
    position = 1 if _is_of_rclpy(call) else 0
    limit = _limit(place, call, "timeout_sec", position + 2 if position else 1)
    if limit is None:
        return None
    future = given_to(call, "future", position)
    match future:
        case facts.Name() | facts.Attribute():
            if _asks(tree, call, future):
                return Sites(limits=(limit,))
        case _:
            return Sites(limits=(limit,))
    match tree.parent(call):
        case facts.Expression() as statement:
            return Sites(limits=(replace(limit, check=_check(limit, statement, future, _IS_NOT_DONE, _NO_ANSWER)),))
    return None


def spins_for_a_result(workspace: WorkspaceIndex | None, place: Place) -> bool:
    """Whether the future that a call at a place spins for is that of an action's result."""
    tree, call = _call_at(workspace, place)
    return tree is not None and call is not None and _of_a_result(tree, call)


def _asks(tree: Tree, call: facts.Call, future: facts.Expr) -> bool:
    """Whether the function around asks a future whether it is done, or whether its result is there."""
    function = tree.function_around(call)
    return any(
        (attribute.attr == "done" or (attribute.attr == "result" and _is_asked(tree, attribute)))
        and same_code(attribute.value, future)
        and (function is None or any(outer is function for outer in tree.around(attribute)))
        for attribute in tree.of_kind(facts.Attribute)
    )


def _is_asked(tree: Tree, method: facts.Attribute) -> bool:
    """``if future.result() is not None``."""
    called = tree.parent(method)
    match None if called is None else tree.parent(called):
        case facts.Compare() | facts.Unary() | facts.Boolean() | facts.If() | facts.While() | facts.Conditional():
            return True
    return False


def same_code(expression: facts.Expr, other: facts.Expr) -> bool:
    """Whether two expressions are written alike, wherever they stand."""
    return _without_places(expression) == _without_places(other)


def _without_places(value: object) -> object:
    match value:
        case facts.Base():
            fields = (name for name in value.__struct_fields__ if name != "span")
            return (type(value).__name__, *(_without_places(getattr(value, name)) for name in fields))
        case list():
            return [_without_places(item) for item in value]
    return value


def _of_a_result(tree: Tree, call: facts.Call) -> bool:
    """Whether the future is that of an action's result, as far as the function around shows."""
    named: list[facts.Expr] = []
    asked: list[facts.Call] = []
    for given in call.args:
        match given.value:
            case facts.Name() | facts.Attribute() as name:
                named.append(name)
            case facts.Call() as inner:
                asked.append(inner)
    function = tree.function_around(call)
    for part in everything_in(function) if function is not None and named else ():
        match part:
            case facts.Assign(targets=targets, value=value):
                if any(same_code(target, name) for target in targets for name in named):
                    asked.extend(calls_in(value))
    return any(called_name(asked_call) in _ASKS_FOR_A_RESULT for asked_call in asked)


_ASKS_FOR_A_RESULT = frozenset({"get_result_async", "_get_result_async"})
"""Of a goal handle, and of an action client."""


def _is_of_rclpy(call: facts.Call) -> bool:
    match call.func:
        case facts.Name() | facts.Attribute(value=facts.Name(id="rclpy")):
            return True
    return False


# ----------------------------------------------------------------------------------------------- the limit itself


def _call_at(workspace: WorkspaceIndex | None, place: Place) -> tuple[Tree | None, facts.Call | None]:
    tree = None if workspace is None else tree_of(workspace, place.file)
    span = (place.line, place.column, place.end_line, place.end_column)
    return tree, None if tree is None else tree.calls.get(span)


def _limit(place: Place, call: facts.Call, keyword: str, position: int | None) -> LimitlessCall | None:
    """Where the limit is set: where None or a negative number stands for it now, in place of that; else as a
    keyword."""
    if any(arg.star for arg in call.args):
        return None
    # From the function's name on: what stands before the bracket may hold brackets of its own.
    match call.func:
        case facts.Name(span=(*_, line, column)) | facts.Attribute(span=(*_, line, column)):
            arguments = Place(place.file, line, column, place.end_line, place.end_column)
        case _:
            return None
    match given_to(call, keyword, position):
        case None:
            return LimitlessCall(keyword, arguments)
        case facts.Literal(value=value, span=span) if _is_no_limit(value):
            return LimitlessCall(keyword, arguments, Place.of(place.file, span))
    return None


def _is_no_limit(value: facts.Constant) -> bool:
    match value:
        case None:
            return True
        case int() | float():
            return value < 0
    return False

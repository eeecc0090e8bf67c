"""What the subscribers of a topic make of each message, and whose it says it is: then several may send some."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.analysis.source_code import SourceCode, source_code
from archlint.connections.arbitration import publishes_of
from archlint.connections.happenings import values_published
from archlint.connections.sharing import COMMANDS, SENDERS
from archlint.syntax import facts
from archlint.syntax.control_flow import graph_of
from archlint.syntax.walk import called_name, calls_in, statements_of

if TYPE_CHECKING:
    from archlint.model import ApiCall, Callback
    from archlint.systems.model import System
    from archlint.systems.nodes import Connection, Endpoint

_BOOL = "std_msgs/msg/Bool"
_IN_JSON = frozenset(SENDERS) | {"robot"}
"""Keys that say whose a text in JSON is."""


def ask_with_true(system: System, connection: Connection) -> bool:
    """Whether the callback of each subscriber does nothing for ``false``: ``if not message.data: return``.  Then
    ``true`` asks for something, whoever sends it, and no message takes back another."""
    callbacks = [callback for end in connection.users for callback in end.creation.callbacks.values()]
    known = bool(callbacks) and all(end.creation.callbacks for end in connection.users)
    return known and connection.types == [_BOOL] and all(_ignores_false(system, callback) for callback in callbacks)


def _ignores_false(system: System, callback: Callback) -> bool:
    function, bound = source_code(system).definition(callback), callback.bound_arguments
    if function is None or len(function.params) <= bound:
        return False
    flag = f"{function.params[bound].name}.data"
    graph = graph_of(function.body)
    acts = [statement for statement in statements_of(function.body) if not _is_idle(statement)]
    return bool(acts) and all(
        any(edge.test is not None and _is_true(edge.test, edge.holds, flag) for edge in graph.outcomes(graph.of(act)))
        for act in acts
    )


def _is_idle(statement: facts.Stmt) -> bool:
    """Whether a statement only decides what runs, ends the callback, or logs."""
    match statement:
        case facts.If() | facts.Return(value=None):
            return True
        case facts.Expression(value=facts.Call(func=facts.Attribute(value=facts.Call() as owner))):
            return called_name(owner) == "get_logger"
    return False


def _is_true(test: facts.Expr, holds: bool, flag: str) -> bool:
    """Whether a condition that has come out so shows that a flag is true."""
    match test:
        case facts.Unary(op="not", operand=operand):
            return not holds and operand.dotted == flag
    return holds and any(part.dotted == flag for part in test.conjuncts)


def say_whose(system: System, owners: Sequence[Endpoint]) -> bool:
    """Whether all that several nodes publish on a topic says whose it is: a field is given the sender's own name or
    number, or a text is JSON with such a key.  Of commands that is never so."""
    if any(end.type in COMMANDS for end in owners):
        return False
    code = source_code(system)
    calls = [publishes_of(system, end) for end in owners]
    return all(some and all(_says_whose(code, call) for call in some) for some in calls)


def _says_whose(code: SourceCode, call: ApiCall) -> bool:
    return any(map(_is_own_name, values_published(code, call))) or _writes_whose(code.body(call))


def _is_own_name(value: facts.Expr) -> bool:
    """Whether a value is an attribute of the node, or a constant, that names the node: ``self.ID``, also in a text."""
    match value:
        case facts.FormatString(parts=parts):
            return any(_is_own_name(part.value) for part in parts if not isinstance(part, str))
        case facts.Call(args=[only]) if called_name(value) in ("int", "str"):
            return _is_own_name(only.value)
    own = value.dotted.removeprefix("self.")
    return "." not in own and own.lower() in SENDERS and (own != value.dotted or own.isupper())


def _writes_whose(body: Sequence[facts.Stmt]) -> bool:
    """Whether a function makes JSON of nothing but dicts with such a key."""
    given = [call.args[0].value for call in calls_in(list(body)) if called_name(call) == "dumps" and call.args]
    return bool(given) and all(any(_has_sender(value) for value in _values(body, value)) for value in given)


def _values(body: Sequence[facts.Stmt], value: facts.Expr) -> Iterator[facts.Expr]:
    """An expression, and what its variable is assigned."""
    yield value
    for assignment in statements_of(body, facts.Assign) if value.variable else ():
        if any(target.variable == value.variable for target in assignment.targets):
            yield assignment.value


def _has_sender(value: facts.Expr) -> bool:
    match value:
        case facts.Mapping(keys=keys):
            return any(key is not None and key.text in _IN_JSON for key in keys)
    return False


__all__ = ["ask_with_true", "say_whose"]

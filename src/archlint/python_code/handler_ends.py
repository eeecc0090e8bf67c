"""The ends of callbacks that owe an answer: service handlers that give no response, parameter callbacks no result."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import TYPE_CHECKING, Literal

from archlint.analysis.source_code import SourceCode, source_code
from archlint.finding import Place
from archlint.model import Role
from archlint.python_code.annotations import interface_of
from archlint.python_code.assumptions import MOST, Known, after, asked, chained, proven, variables, within
from archlint.python_code.class_chains import targets_of
from archlint.python_code.given_arguments import given_arguments
from archlint.python_code.never_empty import is_never_empty
from archlint.python_code.other_responses import other_response
from archlint.python_code.raising_helpers import NeverReturns, never_returns
from archlint.records import dataclass
from archlint.syntax import facts
from archlint.syntax.control_flow import graph_of
from archlint.syntax.flow_graph import Ends
from archlint.syntax.walk import parts_of, statements_of

if TYPE_CHECKING:
    from archlint.model import Callback
    from archlint.systems.model import System


@dataclass(frozen=True)
class HandlerEnd:
    """An end of a callback that leaves its caller without what it waits for."""

    callback: Callback
    place: Place
    how: Literal["return", "end", "lambda"]
    """A ``return``, the end of the function, or the value of a lambda."""
    gives: str = ""
    """What is returned instead, in words."""
    serves: str = ""
    """The service whose response it should be, where it is that of another one."""


_Test = Callable[[facts.Expr, bool], bool]
_ANSWERS = {Role.SERVICE: ("its request", "Response"), Role.EXECUTE: ("its goal", "Result")}
"""What a handler is given, and what the class of its answer is called."""


def handlers_of(system: System, role: Role) -> Iterator[tuple[Callback, facts.Function]]:
    """The functions that are given as callbacks of a role and whose code is all there is to see."""
    code = source_code(system)
    for callback in _callbacks(system, role):
        function = code.definition(callback)
        if function is not None and not function.decorators and not function.is_generator:
            yield callback, function


def _callbacks(system: System, role: Role) -> Iterator[Callback]:
    return (
        callback for callback in system.callbacks if callback.role == role and not system.roles.is_test(callback.file)
    )


def is_stub(body: Sequence[facts.Stmt]) -> bool:
    """``pass``, ``...`` or a docstring: something that is still to be written, or overridden."""
    return all(_says_nothing(statement) for statement in body)


def _says_nothing(statement: facts.Stmt) -> bool:
    match statement:
        case facts.Jump(kind="pass") | facts.Expression(value=facts.Literal() | facts.Opaque()):
            return True
    return False


def ends_without_response(system: System) -> Iterator[HandlerEnd]:
    """The ends of service handlers that give no response."""
    return _ends_without_answer(system, Role.SERVICE)


def ends_without_result(system: System) -> Iterator[HandlerEnd]:
    """The ends of the callbacks that may refuse new values of parameters, and that do not say whether they do."""
    code = source_code(system)
    for end in _ends_without_answer(system, Role.PARAMETER):
        call = None if end.callback.registered is None else code.call_at(end.callback.registered)
        if call is None or call.func.last_name != "add_on_set_parameters_callback":
            continue
        if end.how != "end" or not _ends_with_the_first(code.definition(end.callback)):
            yield end


def _ends_with_the_first(function: facts.Function | None) -> bool:
    """Whether a function ends with a loop over what it is given that returns in its first round: rclpy never gives it
    an empty list."""
    match function:
        case facts.Function(params=[*_, param], body=[*_, facts.For(iterable=over, body=body)]):
            jumps = any(jump.kind != "pass" for jump in statements_of(body, facts.Jump))
            return over.variable == param.name and not jumps and _returns_at_the_end(body)
    return False


def _ends_with_a_sure_round(system: System, callback: Callback, function: facts.Function) -> bool:
    """Whether a function ends with a loop over what is never empty, and returns in its first round."""
    code = source_code(system).facts_at(callback.file)
    match function.body:
        case [*_, facts.For(iterable=over, body=body, orelse=[])] if code is not None:
            jumps = any(jump.kind != "pass" for jump in statements_of(body, facts.Jump))
            return not jumps and _returns_at_the_end(body) and is_never_empty(over, code)
    return False


def _returns_at_the_end(body: Sequence[facts.Stmt]) -> bool:
    """Whether what stands last in a block returns, in each of its branches."""
    match body:
        case [*_, facts.Return() | facts.Raise()]:
            return True
        case [*_, facts.If(body=then, orelse=other)]:
            return _returns_at_the_end(then) and _returns_at_the_end(other)
    return False


def _ends_without_answer(system: System, role: Role) -> Iterator[HandlerEnd]:
    code = source_code(system)
    for callback, function in handlers_of(system, role):
        if not is_stub(function.body):
            yield from ends_of(system, callback, function)
    for callback in _callbacks(system, role):
        written = code.function(callback)
        gives = _no_answer(written.body) if isinstance(written, facts.Lambda) else None
        if gives is not None:
            yield HandlerEnd(callback, callback.place, "lambda", gives)


def ends_of(
    system: System, callback: Callback, function: facts.Function, nobody_waits: _Test = lambda test, truth: False
) -> Iterator[HandlerEnd]:
    """The ends of a callback that give no answer, but for those behind a test that says that nobody waits for one."""
    raises = never_returns(system.workspace, callback.file, function)
    ends = _ends_as_created(source_code(system), callback, function, raises, nobody_waits)
    for end in {id(end): end for end, states in ends.returns if states - {None}}.values():
        gives = _no_answer(end.value) or _request_or_class(system, callback, function, end.value)
        place = Place.of(callback.file, end.span)
        if gives is not None:
            yield HandlerEnd(callback, place, "return", gives)
        elif other := other_response(system, callback, end.value):
            yield HandlerEnd(callback, place, "return", f"a response of {other[0]}", serves=other[1])
    if ends.falls - {None} and not _ends_with_a_sure_round(system, callback, function):
        yield HandlerEnd(callback, callback.place, "end")


def _request_or_class(
    system: System, callback: Callback, function: facts.Function, value: facts.Expr | None
) -> str | None:
    """The request or the goal that a handler was given, or a class of answers, where it returns one of these."""
    code = source_code(system).facts_at(callback.file)
    if callback.role not in _ANSWERS or value is None or code is None:
        return None
    given, answer = _ANSWERS[callback.role]
    request = next((param.name for param in function.params if param.name != "self"), "")
    if value.variable and value.variable == request:
        bound = {target.variable for target in targets_of(function.body)}
        return None if request in bound else given
    interface, section = interface_of(code, value.dotted) if value.attribute == answer else (None, "")
    return f"the class {interface.rpartition('/')[2]}.{answer} itself" if interface and section else None


def _ends_as_created(
    code: SourceCode, callback: Callback, function: facts.Function, raises: NeverReturns, nobody_waits: _Test
) -> Ends[Known | None]:
    """The ends of a handler that is there at all: what was asked before its service was created still holds, where it
    asks for a name of the module that the handler does not set, and rclpy calls it with all arguments.  Behind a
    helper that always raises, the state is None."""
    conditions = code.proven(callback.creation) if callback.creation is not None else ()
    own = {param.name for param in function.params} | {
        part.id
        for statement in statements_of(function.body, facts.Assign)
        for target in statement.targets
        for part in parts_of(target, facts.Name)
    }
    outer = asked(conditions) - own
    # What is asked twice has been answered the first time: ``if request.on:`` and ``elif not request.on:``.
    most = (names for names in (variables(function.body), chained(function.body)) if len(names) <= MOST)
    followed = outer | next(most, frozenset[str]())

    def step(known: Known | None, fact: facts.Base) -> Known | None:
        return None if known is None or raises(fact) else after(known, fact, followed)

    given = given_arguments(callback, function)

    def branch(known: Known | None, test: facts.Expr, truth: bool) -> Known | None:
        if known is None or nobody_waits(test, truth) or (given is not None and given.rules_out(test, truth)):
            return None
        return within(known, test, truth, followed)

    start: Known | None = proven(conditions, outer)
    return graph_of(function.body).ends(start, step, branch)


def _no_answer(value: facts.Expr | None) -> str | None:
    """What a ``return`` gives that can be no answer, in words; None where it may be one."""
    match value:
        case None:
            return "nothing"
        case facts.Literal(value=constant):
            return repr(constant)
        case facts.FormatString():
            return "a string"
        case facts.Sequence(kind=kind):
            return f"a {kind}"
        case facts.Mapping():
            return "a dict"
        case facts.Compare() | facts.Unary(op="not"):
            return "a bool"
    return None


__all__ = ["HandlerEnd", "ends_of", "ends_without_response", "ends_without_result", "handlers_of", "is_stub"]

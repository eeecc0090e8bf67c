"""SRV007: service handlers with a path that gives no response."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.assumptions import Known, asked, proven, within
from archlint.analysis.reach import endpoint_words, node_name, one_for_each_place
from archlint.analysis.source_code import SourceCode, source_code
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.finding import Finding, Place, Related
from archlint.model import Role
from archlint.syntax import facts
from archlint.syntax.control_flow import Ends, ends_of
from archlint.syntax.walk import parts_of, statements_of

if TYPE_CHECKING:
    from archlint.model import Callback
    from archlint.systems.model import System


def handlers_of(system: System, role: Role) -> Iterator[tuple[Callback, facts.Function]]:
    """The functions that are given as callbacks of a role and whose code is all there is to see."""
    code = source_code(system)
    for program in system.programs:
        for callback in program.callbacks:
            if callback.role != role or system.roles.is_test(callback.file):
                continue
            function = code.function(callback)
            if isinstance(function, facts.Function) and not function.decorators and not function.is_generator:
                yield callback, function


# --------------------------------------------------------------------------------------------------- SRV007


@rule("SRV007", scope=Scope.CODE)
def missing_response(system: System, options: Options) -> Iterator[Finding]:
    """Ends of service handlers that give no response."""
    yield from one_for_each_place(
        (
            *(
                one
                for callback, function in handlers_of(system, Role.SERVICE)
                for one in _missing(system, callback, function)
            ),
            *_missing_of_lambdas(system),
        )
    )


def _missing_of_lambdas(system: System) -> Iterator[Finding]:
    code = source_code(system)
    for program in system.programs:
        for callback in program.callbacks:
            function = code.function(callback) if callback.role == Role.SERVICE else None
            if isinstance(function, facts.Lambda):
                what = _no_response(function.body)
                if what is not None and not system.roles.is_test(callback.file):
                    yield _missing_at(
                        system, callback, callback.place, f"returns {what}, which is not a response", "lambda"
                    )


def _missing(system: System, callback: Callback, function: facts.Function) -> Iterator[Finding]:
    if only_a_stub(function.body):
        return
    ends = _ends_as_created(source_code(system), callback, function)
    for end in {id(one): one for one, states in ends.returns if states}.values():
        what = _no_response(end.value)
        if what is not None:
            place = Place.of(callback.file, end.span)
            yield _missing_at(system, callback, place, f"returns {what} here, which is not a response", "return")
    if ends.falls:
        yield _missing_at(system, callback, callback.place, "can reach its end without a response", "end")


def _ends_as_created(code: SourceCode, callback: Callback, function: facts.Function) -> Ends[Known]:
    """The ends of a handler that is there at all: what was asked before its service was created still holds, where it
    asks for a name of the module that the handler does not set."""
    conditions = code.proven(callback.creation) if callback.creation is not None else ()
    own = {param.name for param in function.params} | {
        part.id
        for one in statements_of(function.body)
        if isinstance(one, facts.Assign)
        for target in one.targets
        for part in parts_of(target)
        if isinstance(part, facts.Name)
    }
    followed = asked(conditions) - own
    return ends_of(
        function.body,
        proven(conditions, followed),
        lambda known, fact: known,
        lambda known, test, truth: within(known, test, truth, followed),
    )


def _missing_at(system: System, callback: Callback, place: Place, what: str, end: str) -> Finding:
    return finding(
        "SRV007",
        place,
        f"the handler of {endpoint_words(callback.creation)} {what}: rclpy raises a TypeError, and the caller "
        "never gets a response",
        help="return the response on every path, also where something went wrong",
        related=related_handler(callback, place),
        node=node_name(system, callback.node),
        identity=(callback.name, end),
    )


def _no_response(value: facts.Expr | None) -> str | None:
    """What a ``return`` gives that can be no response, in words; None where it may be one."""
    if value is None:
        return "nothing"
    if isinstance(value, facts.Literal):
        return repr(value.value)
    if isinstance(value, facts.FormatString):
        return "a string"
    if isinstance(value, facts.Sequence):
        return f"a {value.kind}"
    if isinstance(value, facts.Mapping):
        return "a dict"
    if isinstance(value, facts.Compare) or (isinstance(value, facts.Unary) and value.op == "not"):
        return "a bool"
    return None


def only_a_stub(body: list[facts.Stmt]) -> bool:
    """``pass``, ``...`` or a docstring: something that is still to be written, or overridden."""
    return all(
        (isinstance(s, facts.Jump) and s.kind == "pass")
        or (isinstance(s, facts.Expression) and isinstance(s.value, (facts.Literal, facts.Opaque)))
        for s in body
    )


def related_handler(callback: Callback, place: Place) -> list[Related]:
    found = [] if place == callback.place else [Related(callback.place, f"{callback.name} is the handler")]
    if callback.registered is not None:
        found.append(Related(callback.registered, "it is registered here"))
    return found

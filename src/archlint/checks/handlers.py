"""SRV007, API004: service handlers that give no response, and parameter callbacks that give no result."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.analysis.reach import endpoint_words, node_name, one_for_each_place
from archlint.checks.folding import folds, with_others
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.finding import Finding, Related
from archlint.python_code.handler_ends import HandlerEnd, ends_without_response, ends_without_result

if TYPE_CHECKING:
    from archlint.systems.model import System


@rule("SRV007", scope=Scope.CODE, by_program=True)
def missing_response(system: System, options: Options) -> Iterator[Finding]:
    """Ends of service handlers that give no response."""
    yield from one_for_each_place(_missing(system, end) for end in ends_without_response(system))


def _missing(system: System, end: HandlerEnd) -> Finding:
    needed = f"one of {end.serves}" if end.serves else "a response"
    what = "can reach its end without a response" if end.how == "end" else f"{_returns(end)}, which is not {needed}"
    handler = f"the handler of {endpoint_words(end.callback.creation)}"
    return finding(
        "SRV007",
        end.place,
        f"{handler} {what}: rclpy raises a TypeError, and the caller never gets a response",
        help="return the response that the handler is given"
        if end.serves
        else "return the response on every path, also when something goes wrong",
        related=related_handler(end),
        node=node_name(system, end.callback.node),
        identity=(end.callback.name, end.how),
        group=(end.callback.place.file, str(end.callback.place.line), end.callback.name, end.serves),
    )


@folds("SRV007")
def _of_one_handler(findings: Sequence[Finding]) -> Finding:
    """One finding for all ends of a handler: they lack the same response."""
    return with_others(findings, "another end of it does", "more ends of it do", "the same", "this end, too")


def _returns(end: HandlerEnd) -> str:
    return f"returns {end.gives}{' here' if end.how == 'return' else ''}"


@rule("API004", scope=Scope.CODE)
def parameter_callback_result(system: System, options: Options) -> Iterator[Finding]:
    """Ends of parameter callbacks that do not say whether the new values are right."""
    yield from one_for_each_place(_no_result(system, end) for end in ends_without_result(system))


def _no_result(system: System, end: HandlerEnd) -> Finding:
    what = "can reach its end without a result" if end.how == "end" else _returns(end)
    return finding(
        "API004",
        end.place,
        f"the parameter callback {what}: rclpy takes only a SetParametersResult, so no parameter changes",
        help="return SetParametersResult(successful=True)",
        related=related_handler(end, "is the callback"),
        node=node_name(system, end.callback.node),
        identity=(end.callback.name, end.how),
    )


def related_handler(end: HandlerEnd, role: str = "is the handler") -> list[Related]:
    """The callback that has an end, and where it is registered."""
    callback = end.callback
    rows = [] if end.place == callback.place else [Related(callback.place, f"{callback.name} {role}")]
    if callback.registered is not None:
        rows.append(Related(callback.registered, "it is registered here"))
    return rows

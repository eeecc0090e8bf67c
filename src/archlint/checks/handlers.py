"""SRV007: service handlers with a path that gives no response."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.handler_ends import HandlerEnd, ends_without_response
from archlint.analysis.reach import endpoint_words, node_name, one_for_each_place
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.finding import Finding, Related

if TYPE_CHECKING:
    from archlint.systems.model import System


@rule("SRV007", scope=Scope.CODE)
def missing_response(system: System, options: Options) -> Iterator[Finding]:
    """Ends of service handlers that give no response."""
    yield from one_for_each_place(_missing(system, end) for end in ends_without_response(system))


def _missing(system: System, end: HandlerEnd) -> Finding:
    callback = end.callback
    what = {
        "return": f"returns {end.gives} here, which is not a response",
        "lambda": f"returns {end.gives}, which is not a response",
        "end": "can reach its end without a response",
    }[end.how]
    return finding(
        "SRV007",
        end.place,
        f"the handler of {endpoint_words(callback.creation)} {what}: rclpy raises a TypeError, and the caller "
        "never gets a response",
        help="return the response on every path, also when something goes wrong",
        related=related_handler(end),
        node=node_name(system, callback.node),
        identity=(callback.name, end.how),
    )


def related_handler(end: HandlerEnd) -> list[Related]:
    """The handler of an end, and where it is registered."""
    callback = end.callback
    rows = [] if end.place == callback.place else [Related(callback.place, f"{callback.name} is the handler")]
    if callback.registered is not None:
        rows.append(Related(callback.registered, "it is registered here"))
    return rows

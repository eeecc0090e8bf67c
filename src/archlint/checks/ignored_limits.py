"""TMO005: limits whose outcome nobody reads."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.left_over import is_never_made
from archlint.analysis.reach import (
    calls_of,
    creations_of,
    has_limit,
    node_name,
    one_for_each_place,
)
from archlint.analysis.source_code import source_code
from archlint.analysis.unused_results import is_thrown_away
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.checks.wait_words import (
    READY,
    WAIT_FOR_SERVER,
    WAIT_FOR_SERVICE,
    kind_of,
    name_of,
    related_path,
    server_words,
)
from archlint.finding import Finding, Place

if TYPE_CHECKING:
    from archlint.model import ApiCall
    from archlint.systems.model import System


@rule("TMO005", scope=Scope.CODE, by_program=True, in_use=True)
def ignored_wait_result(system: System, options: Options) -> Iterator[Finding]:
    """Waits with a timeout whose result is ignored, and that nothing checks later."""
    asked = _clients_asked_for(system)
    yield from one_for_each_place(
        _ignored(system, call)
        for _, call in calls_of(system, (WAIT_FOR_SERVICE, WAIT_FOR_SERVER))
        if is_thrown_away(source_code(system), call)
        and not is_never_made(system.workspace, call)
        and has_limit(call, "timeout_sec")
        and asked.isdisjoint(creation.place for creation in creations_of(call.receiver))
    )


def _clients_asked_for(system: System) -> set[Place]:
    """Where the clients are created that somebody asks whether their server is there."""
    places: set[Place] = set()
    for _, call in calls_of(system, (*READY, WAIT_FOR_SERVICE, WAIT_FOR_SERVER)):
        if not is_thrown_away(source_code(system), call):
            places.update(creation.place for creation in creations_of(call.receiver))
    return places


def _ignored(system: System, call: ApiCall) -> Finding:
    function = call.api.rpartition(".")[2]
    return finding(
        "TMO005",
        call.place,
        f"the result of {function}() for {server_words(system, call.creation, kind_of(call))} is ignored: after the "
        "timeout the code continues as if it were available",
        help=f"check the result, and handle the case that the server is not available: if not ….{function}(…):",
        related=related_path(call, call.creation),
        node=node_name(system, call.node or call.context.node),
        identity=(call.function, name_of(call.creation), function),
    )

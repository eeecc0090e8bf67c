"""TMO005: limits whose outcome nobody reads, and waits for another server than the one that is asked."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.analysis.reach import (
    calls_of,
    creations_of,
    endpoint_words,
    has_limit,
    node_name,
    one_for_each_place,
)
from archlint.analysis.source_code import source_code
from archlint.analysis.unused_results import is_thrown_away
from archlint.checks.folding import folds, of_one_function
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
from archlint.connections.own_servers import is_served_by_its_node
from archlint.execution.other_clients import MistakenWait, mistaken_waits, words_for_client
from archlint.finding import Finding, Place, Related

if TYPE_CHECKING:
    from archlint.model import ApiCall
    from archlint.systems.model import System


@rule("TMO005", scope=Scope.CODE, in_use=True)
def ignored_wait_result(system: System, options: Options) -> Iterator[Finding]:
    """Waits with a timeout whose result is ignored, and that nothing checks later; waits for the wrong server."""
    asked = _clients_asked_for(system)
    mistaken = mistaken_waits(system)
    yield from (_mistaken(system, row) for row in mistaken)
    told = {row.wait.place for row in mistaken}
    yield from one_for_each_place(
        _ignored(system, call)
        for _, call in calls_of(system, (WAIT_FOR_SERVICE, WAIT_FOR_SERVER))
        if call.place not in told
        and is_thrown_away(source_code(system), call)
        and has_limit(call, "timeout_sec")
        and asked.isdisjoint(creation.place for creation in creations_of(call.receiver))
        and not _is_served_by_itself(call)
    )


def _is_served_by_itself(call: ApiCall) -> bool:
    """Whether the node of each client that is waited for has made the server itself, and before the client."""
    clients = creations_of(call.receiver)
    return bool(clients) and all(map(is_served_by_its_node, clients))


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
        group=(call.file, call.function),
    )


def _mistaken(system: System, mistaken: MistakenWait) -> Finding:
    wait, then, before = mistaken.wait, mistaken.then, mistaken.before
    asked, meant = endpoint_words(mistaken.waited_for), endpoint_words(mistaken.meant)
    if then is not None:
        message = f"this waits for {asked}, and the request goes to {meant}, for which nothing waits"
        related = Related(then.place, "the request is sent here")
    else:
        message = f"this waits for {asked} once more, and nothing waits for {meant}"
        related = Related(before.place if before is not None else wait.place, "here it waits for it first")
    return finding(
        "TMO005",
        wait.place,
        message,
        help=f"wait with the other client: {words_for_client(system, mistaken)}.{wait.api.rpartition('.')[2]}(…)",
        related=[related, Related(mistaken.meant.place, "the other client is created here")],
        node=node_name(system, wait.node or wait.context.node),
        identity=(wait.function, name_of(mistaken.waited_for), name_of(mistaken.meant)),
        group=(wait.file, wait.function, name_of(mistaken.meant)),
    )


@folds("TMO005")
def _of_one_function(findings: Sequence[Finding]) -> Finding:
    """One finding for all waits of a function."""
    return of_one_function(findings, "wait", "the result of this wait is ignored, too")

"""EXE011: what is thrown away, or asked, before it can work."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.analysis.idle_filters import idle_filters
from archlint.analysis.reach import node_name, one_for_each_place
from archlint.checks.folding import folds, with_others
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.checks.wait_words import related_path
from archlint.execution.callback_roles import callback_words, runs_in_executor
from archlint.execution.early_lookups import EarlyLookup, early_lookups
from archlint.finding import Finding, Related

if TYPE_CHECKING:
    from archlint.model import ApiCall
    from archlint.systems.model import System


@rule("EXE011", scope=Scope.CODE)
def discarded_entity(system: System, options: Options) -> Iterator[Finding]:
    """Transform buffers that are new when they are asked, and synchronizers that nobody listens to."""
    yield from one_for_each_place(
        (
            *(_too_new(system, lookup) for lookup in early_lookups(system)),
            *(_idle(system, call) for _, call in idle_filters(system)),
        )
    )


def _too_new(system: System, lookup: EarlyLookup) -> Finding:
    call = lookup.call
    function = call.api.rpartition(".")[2]
    again = runs_in_executor(call.context)
    whose = f": {callback_words(call.context)} makes a new one each time" if again else ""
    outcome = "raises a LookupException" if function == "lookup_transform" else "is False"
    return finding(
        "EXE011",
        call.place,
        f"{function}() {outcome}: this buffer has just been created, and no transform has arrived yet{whose}",
        help="create the Buffer and its TransformListener once, in the constructor"
        if again
        else "look it up later, in a callback: transforms arrive only while the node is spun",
        related=[Related(lookup.buffer, "the buffer is created here"), *related_path(call, None)],
        node=node_name(system, call.context.node),
        identity=(call.function, function),
        group=(call.place.file, call.function, "buffer"),
    )


def _idle(system: System, call: ApiCall) -> Finding:
    kind = call.api.rpartition(".")[2]
    return finding(
        "EXE011",
        call.place,
        f"this {kind} is never used again: no callback is registered with it, so its messages go nowhere",
        help="register a callback with it: ….registerCallback(…)",
        node=node_name(system, call.context.node),
        identity=(call.function, kind),
        group=(call.place.file, call.function, "filter", str(call.place.line)),
    )


@folds("EXE011")
def of_one_function(findings: Sequence[Finding]) -> Finding:
    """The first lookup of a function for all."""
    return with_others(findings, "another line of this function does", "more lines of this function do", "the same")

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
from archlint.python_code.overwritten_ends import OverwrittenEnd, overwritten_ends

if TYPE_CHECKING:
    from archlint.model import ApiCall
    from archlint.systems.model import System


@rule("EXE011", scope=Scope.CODE)
def discarded_entity(system: System, options: Options) -> Iterator[Finding]:
    """Transform buffers that are new when they are asked, synchronizers that nobody listens to, and publishers and
    clients that another one replaces."""
    yield from one_for_each_place(
        (
            *(_too_new(system, lookup) for lookup in early_lookups(system)),
            *(_idle(system, call) for _, call in idle_filters(system)),
            *(_replaced(end) for end in (() if system.workspace is None else overwritten_ends(system.workspace))),
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


def _replaced(end: OverwrittenEnd) -> Finding:
    return finding(
        "EXE011",
        end.place,
        f"nothing can use this {end.kind} of '{end.name}': {end.target} gets another one before anything has used it",
        help="give one of the two another name",
        related=[Related(end.again, "this one takes its place")],
        identity=(end.target, end.name),
        group=(end.place.file, "replaced", end.target),
    )


@folds("EXE011")
def of_one_function(findings: Sequence[Finding]) -> Finding:
    """The first lookup of a function for all."""
    return with_others(findings, "another line of this function does", "more lines of this function do", "the same")

"""Findings about a call that a callback comes to."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING

from archlint.analysis.kept import once
from archlint.analysis.reach import judged_calls, node_name
from archlint.checks.registry import finding
from archlint.execution.callback_roles import related_to, runs_in_executor
from archlint.finding import Related

if TYPE_CHECKING:
    from archlint.finding import Finding, Place
    from archlint.model import ApiCall, Creation, Program
    from archlint.systems.model import System


def finding_in_callback(
    code: str,
    system: System,
    program: Program,
    call: ApiCall,
    message: str,
    *,
    help: str,
    identity: Sequence[str],
    client: Creation | None = None,
    further: Iterable[Related] = (),
    group: Sequence[str] = (),
    in_own_file: bool = False,
    deep: float = math.inf,
) -> Finding:
    """A finding of the node of the callback that comes to a call, at the line that :func:`told_at` chooses.  Related is
    the way there from the callback, with the client that the call waits for, and then ``further``; ``identity`` is what
    sets it apart from others of this callback."""
    callback = call.context
    place, _ = told_at(system, call, in_own_file, deep)
    there = [] if place == call.place else [Related(call.place, "it waits here")]
    return finding(
        code,
        place,
        message,
        help=help,
        related=(*related_to(call, program, client), *there, *further),
        node=node_name(system, callback.node),
        identity=(callback.name, *identity),
        group=group,
    )


def told_at(system: System, call: ApiCall, in_own_file: bool = False, deep: float = math.inf) -> tuple[Place, str]:
    """Where a call of a callback is told, with the function around it: at its own line; where that is in a helper of
    another package, or in another file (``in_own_file``), at the last line of the callback's own that leads there, and
    in a helper of ``deep`` calls, at the first.  A helper to which callbacks of several packages come is told once."""
    workspace = system.workspace
    if len(call.chain) >= deep:
        return call.chain[0].place, call.chain[0].caller
    if workspace is None or (not in_own_file and len(_packages_that_come_to(system).get(call.place, ())) > 1):
        return call.place, call.function
    home_of = (lambda file: file) if in_own_file else workspace.package_of
    own = home_of(call.context.place.file)
    if own is not None and home_of(call.file) not in (own, None):
        for frame in reversed(call.chain):
            if home_of(frame.place.file) == own:
                return frame.place, frame.caller
    return call.place, call.function


@once
def _packages_that_come_to(system: System) -> Mapping[Place, set[str | None]]:
    """The packages of the callbacks that come to each call."""
    workspace = system.workspace
    packages: dict[Place, set[str | None]] = {}
    for _, call in [] if workspace is None else judged_calls(system):
        if workspace is not None and runs_in_executor(call.context):
            packages.setdefault(call.place, set()).add(workspace.package_of(call.context.place.file))
    return packages


__all__ = ["finding_in_callback", "told_at"]

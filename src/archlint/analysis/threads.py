"""Threads that a program makes for itself."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.finding import Place
from archlint.syntax import facts
from archlint.syntax.parts import everything_in

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex


def is_daemon(workspace: WorkspaceIndex, made: Place) -> bool:
    """Whether the thread that is made at a place is a daemon: ``daemon=True``, or ``thread.daemon = True``."""
    found = workspace.facts_at(made.file)
    body = [] if found is None else found.body
    thread = next((one for one in everything_in(body, facts.Call) if Place.of(made.file, one.span) == made), None)
    if thread is None:
        return False
    if any(given.keyword == "daemon" and given.value.is_true for given in thread.args):
        return True
    assigned = list(everything_in(body, facts.Assign))
    names = {target.dotted for one in assigned if one.value is thread for target in one.targets} - {""}
    made_daemons = {target.dotted for one in assigned if one.value.is_true for target in one.targets}
    return not made_daemons.isdisjoint(f"{name}.daemon" for name in names)


__all__ = ["is_daemon"]

"""Threads that a program makes for itself."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.finding import Place
from archlint.syntax import facts
from archlint.syntax.parts import everything_in

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex


def is_daemon(workspace: WorkspaceIndex, place: Place) -> bool:
    """Whether the thread that is made at a place is a daemon: ``daemon=True``, or ``thread.daemon = True``."""
    file_facts = workspace.facts_at(place.file)
    body = [] if file_facts is None else file_facts.body
    thread = next((call for call in everything_in(body, facts.Call) if Place.of(place.file, call.span) == place), None)
    if thread is None:
        return False
    if any(given.keyword == "daemon" and given.value.is_true for given in thread.args):
        return True
    assigned = list(everything_in(body, facts.Assign))
    names = {
        target.dotted for assignment in assigned if assignment.value is thread for target in assignment.targets
    } - {""}
    made_daemons = {
        target.dotted for assignment in assigned if assignment.value.is_true for target in assignment.targets
    }
    return not made_daemons.isdisjoint(f"{name}.daemon" for name in names)


__all__ = ["is_daemon"]

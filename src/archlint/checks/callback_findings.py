"""Findings about a call that a callback comes to."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING

from archlint.analysis.callback_roles import related_to
from archlint.analysis.reach import node_name
from archlint.checks.registry import finding

if TYPE_CHECKING:
    from archlint.finding import Finding, Related
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
) -> Finding:
    """A finding at a call, of the node of the callback that comes to it.  Related is the way there from the callback,
    with the client that the call waits for, and then ``further``; ``identity`` is what sets it apart from others of
    this callback."""
    callback = call.context
    return finding(
        code,
        call.place,
        message,
        help=help,
        related=(*related_to(call, program, client), *further),
        node=node_name(system, callback.node),
        identity=(callback.name, *identity),
        group=group,
    )

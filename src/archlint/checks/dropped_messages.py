"""MSG001: messages without a header that a synchronizer is to bring together by their time."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.checks.registry import finding
from archlint.checks.uncalled import unless_uncalled
from archlint.finding import Related

if TYPE_CHECKING:
    from archlint.finding import Finding
    from archlint.model import Callback
    from archlint.systems.model import System


def dropped_message_findings(system: System) -> Iterator[Finding]:
    """One finding for each callback that such a synchronizer never calls."""
    for callback in system.callbacks:
        if callback.dropped and not system.roles.is_test(callback.file):
            yield from unless_uncalled(system, _finding(callback))


def _finding(callback: Callback) -> Finding:
    place = callback.place if callback.registered is None else callback.registered
    return finding(
        "MSG001",
        place,
        f"{callback.dropped} has no field 'header': the synchronizer drops every such message, and never calls "
        f"{callback.name}",
        help="give the synchronizer allow_headerless=True, or send a message with a header",
        related=[Related(callback.place, f"{callback.name} is defined here")],
        node=None if callback.node is None else callback.node.name.text,
        identity=(callback.dropped, callback.name, "header"),
    )


__all__ = ["dropped_message_findings"]

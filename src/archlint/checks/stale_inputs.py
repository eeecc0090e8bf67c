"""TOP007: commands that go on when nobody says any more where to go."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.reach import node_name, one_for_each_place
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.connections.unaged_inputs import UnagedInput, unaged_inputs
from archlint.execution.callback_roles import callback_words
from archlint.finding import Finding, Related

if TYPE_CHECKING:
    from archlint.model import Creation
    from archlint.systems.model import System


@rule("TOP007", scope=Scope.CODE, taste=True)
def stale_input(system: System, options: Options) -> Iterator[Finding]:
    """Commands that a timer publishes from a stored message, whatever its age."""
    yield from one_for_each_place(_stale(system, row) for row in unaged_inputs(system))


def _stale(system: System, row: UnagedInput) -> Finding:
    call, callback, attribute = row.call, row.call.context, f"self.{row.attribute}"
    return finding(
        "TOP007",
        call.place,
        f"{callback_words(callback)} publishes to {_topic(row.command)} what follows from {attribute}, "
        f"whose age nothing checks: if {_topic(row.subscription)} stops, the last command goes on for ever",
        help=f"store the time with {attribute}, and publish a stop when it is too old",
        related=[
            Related(row.stored, f"{attribute} is stored here"),
            Related(row.subscription.place, "this is the subscription"),
        ],
        node=node_name(system, callback.node),
        identity=(callback.name, row.attribute),
    )


def _topic(end: Creation) -> str:
    return "a topic" if end.name.text is None else f"'{end.name.text}'"


__all__ = ["stale_input"]

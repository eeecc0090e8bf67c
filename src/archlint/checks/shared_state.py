"""EXE013: state that callbacks change at the same time, without a lock."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.reach import node_name, one_for_each_place
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.execution.callback_roles import callback_words
from archlint.execution.unguarded_changes import Race, races
from archlint.finding import Finding, Related

if TYPE_CHECKING:
    from archlint.systems.model import System


@rule("EXE013", scope=Scope.CODE)
def unguarded_shared_state(system: System, options: Options) -> Iterator[Finding]:
    """Attributes that are read and changed in one callback while another thread may change them, too."""
    yield from one_for_each_place(_race(system, race) for race in races(system))


def _race(system: System, race: Race) -> Finding:
    first, second = race.first, race.second
    alone = first.callback.place == second.callback.place
    other = "another run of it" if alone else second.callback.name
    return finding(
        "EXE013",
        first.place,
        f"{callback_words(first.callback)} reads self.{first.attribute} and changes it, and {other} may change it in "
        "between on another thread: one of the two changes is lost",
        help="change it inside `with self.lock:` in both, or put both callbacks into one exclusive group",
        related=[
            Related(first.callback.place, f"{first.callback.name} is a callback"),
            *([] if alone else [Related(second.place, f"{second.callback.name} changes it here")]),
        ],
        node=node_name(system, first.callback.node),
        identity=(first.callback.name, first.attribute),
    )


__all__ = ["unguarded_shared_state"]

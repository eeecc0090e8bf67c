"""EXE009: waits that nothing can end."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.attribute_loops import AttributeLoop, attribute_loops
from archlint.analysis.callback_roles import callback_words
from archlint.analysis.reach import node_name, one_for_each_place
from archlint.checks.limitless_calls import unanswerable_calls
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.finding import Finding, Related

if TYPE_CHECKING:
    from archlint.systems.model import System


@rule("EXE009", scope=Scope.CODE, in_use=True)
def unanswerable_wait(system: System, options: Options) -> Iterator[Finding]:
    """Calls that nobody can answer while they wait, and loops that wait for what they keep from happening."""
    yield from one_for_each_place(unanswerable_calls(system, options))
    for loop in attribute_loops(system):
        yield _endless(system, loop)


def _endless(system: System, loop: AttributeLoop) -> Finding:
    callback, setter = loop.callback, loop.setter
    return finding(
        "EXE009",
        loop.place,
        f"once {callback_words(callback)} is in this loop, it never ends: only {setter.name} changes "
        f"self.{loop.attribute}, and it cannot run meanwhile, since {loop.why}",
        help=f"return instead, and go on in {setter.name}",
        related=[Related(setter.place, f"{setter.name} changes self.{loop.attribute}")],
        node=node_name(system, callback.node),
        identity=(callback.name, loop.attribute),
    )

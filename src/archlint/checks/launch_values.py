"""LCH008: what stops a launch: an undefined name, a condition that launch cannot ask."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.finding import Finding

if TYPE_CHECKING:
    from archlint.systems.model import System


@rule("LCH008", scope=Scope.SYSTEM)
def launch_description(system: System, options: Options) -> Iterator[Finding]:
    """Names that nothing defines, and a ``condition=`` that has no ``evaluate`` for launch to call."""
    for place, name in sorted(system.launched.undefined.items() if system.launched is not None else ()):
        yield finding(
            "LCH008",
            place,
            f"'{name}' is not defined: this launch file stops with a NameError before it starts anything",
            help=f"define or import '{name}' above, or put it in quotes if it is meant as text",
            identity=(place.file, name),
        )
    for mistake in system.launched.mistakes if system.launched is not None else ():
        wrap = "launch.Condition(predicate=…)" if mistake.callable else "IfCondition(…)"
        yield finding(
            "LCH008",
            mistake.place,
            f"condition= of this {mistake.action} is {mistake.what}, which is no Condition",
            help=f"launch stops with an AttributeError when it comes to this action: write condition={wrap}",
            identity=(mistake.action, mistake.what),
        )

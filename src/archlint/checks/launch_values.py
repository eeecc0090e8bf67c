"""LCH008: what an action of a launch file is given and cannot use."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.checks.registry import Options, finding, rule
from archlint.finding import Finding

if TYPE_CHECKING:
    from archlint.system.model import System


@rule("LCH008")
def launch_description(system: System, options: Options) -> Iterator[Finding]:
    """A ``condition=`` that has no ``evaluate`` for launch to call."""
    for mistake in system.launched.mistakes if system.launched is not None else ():
        wrap = "launch.Condition(predicate=…)" if mistake.callable else "IfCondition(…)"
        yield finding(
            "LCH008",
            mistake.place,
            f"condition= of this {mistake.action} is {mistake.what}, which is no Condition",
            help=f"launch stops with an AttributeError when it comes to this action: write condition={wrap}",
            identity=(mistake.action, mistake.what),
        )

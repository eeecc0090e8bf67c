"""Rules of our team, beside those of archlint."""

from __future__ import annotations

from collections.abc import Iterator

from archlint.api import Finding, Options, Scope, System, finding, rule


@rule("XRT001", scope=Scope.CODE, max_rate=100)
def fast_timer(system: System, options: Options) -> Iterator[Finding]:
    """Timers that run more often than ``max-rate`` times a second."""
    most = options.number("max-rate")
    for node in system.nodes:
        for timer in node.timers:
            if timer.period is not None and 0 < timer.period * most < 1:
                message = f"this timer runs {1 / timer.period:g} times a second; our computer can do {most:g}"
                yield finding("XRT001", timer.place, message, help="use a longer period", node=node.name)

"""Which rules judge each launched system, and one finding for what several systems show."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace

from archlint.finding import Finding

OF_SYSTEMS = (
    "ACT001",
    "ACT002",
    "ARC",
    "GRF",
    "LCH",
    "NME002",
    "NME004",
    "OWN",
    "PRM002",
    "PRM004",
    "PRM005",
    "QOS",
    "SRV001",
    "SRV002",
    "SRV004",
    "SRV006",
    "TOP001",
    "TOP002",
    "TOP003",
    "TOP004",
)
"""Rules whose answer depends on what runs together and under which names and parameters, by code or prefix.  The
others judge code, and one system is enough for them."""

_OF_CODE = ("LCH002", "NME002", "SRV004")
"""Of these a place is told once, whatever name or period a launch file gives it."""


_OF_LAUNCH_FILE = ("LCH001", "LCH003", "LCH004", "LCH005")
"""What these find stands in the launch file, whichever arguments it is given."""

OF_RUNNING = ("GRF005", "GRF006", "GRF007")
"""What these find was observed, under the arguments that it was started with."""


def depends_on_arguments(code: str) -> bool:
    """Whether a rule may answer differently for the systems that one launch file makes."""
    return depends_on_system(code) and code not in (*_OF_LAUNCH_FILE, *OF_RUNNING)


def depends_on_system(code: str) -> bool:
    """Whether a rule is to be run for each launch file."""
    return code.startswith(OF_SYSTEMS)


def merged(findings: Iterable[Finding]) -> Iterator[Finding]:
    """The findings without repetitions; those of the open system come first and stay."""
    seen: dict[tuple[object, ...], tuple[str | None, str | None]] = {}
    for finding in sorted(findings, key=lambda one: (one.system is not None, one.condition is not None)):
        keys = _keys(finding)
        own = finding.system, finding.condition
        # Two findings of one system differ for a reason: only what another system has said is a repetition, or the
        # same one under any arguments.
        said = {seen.get(key, own) for key in keys}
        if all(system == finding.system and (condition or not finding.condition) for system, condition in said):
            yield _with_condition(finding)
        for key in keys:
            seen.setdefault(key, own)


def _with_condition(finding: Finding) -> Finding:
    """The finding with the arguments under which it holds in its message."""
    if finding.condition is None:
        return finding
    return replace(finding, message=f"{finding.message} (with {finding.condition})")


def _keys(finding: Finding) -> set[tuple[object, ...]]:
    keys: set[tuple[object, ...]] = {(finding.code, finding.place, finding.message)}
    places = tuple(related.place for related in finding.related)
    if not depends_on_system(finding.code) or finding.code in _OF_CODE:
        keys.add((finding.code, finding.place))
    elif places:
        keys.add((finding.code, finding.place, places))
    return keys

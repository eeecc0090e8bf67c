"""Which rules may report something in a file of C++.

The graph of a C++ node is read as that of a Python one, and so is what depends on it: names, types, QoS, parameters,
owners.  What a rule says of how rclpy waits, spins or checks its arguments is no fact of rclcpp.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING

from archlint.checks.refused_by_rclcpp import OF_RCLCPP
from archlint.workspace.kinds import is_cpp

if TYPE_CHECKING:
    from archlint.finding import Finding

_FAMILIES = ("OWN", "QOS", "LCH", "PRM", "NME", "GRF", "ARC", "LNT")
_CODES = frozenset({"API007", "TOP001", "TOP002", "TOP003", "TOP004", "SRV001", "SRV002", "ACT001", "PKG001", "MSG002"})


def for_their_languages(findings: Iterable[Finding]) -> Iterator[Finding]:
    """The findings without those whose rule knows nothing of the language that they are in."""
    for finding in findings:
        if not is_cpp(finding.place.file) or _is_about_cpp(finding):
            yield finding


def _is_about_cpp(finding: Finding) -> bool:
    of_rclcpp = finding.identity[:1] == (OF_RCLCPP,)
    return of_rclcpp or finding.code.startswith(_FAMILIES) or finding.code in _CODES


__all__ = ["for_their_languages"]

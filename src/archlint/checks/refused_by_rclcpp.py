"""API001 and API002 in C++: what rclcpp does not have, so that the code does not compile."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.pinned import is_from_before_galactic, is_from_before_humble
from archlint.checks.registry import finding
from archlint.finding import Finding, Place
from archlint.python_code.refused_by_rclcpp import declared_by_name_alone, moved_names, numbers_as_durations

if TYPE_CHECKING:
    from archlint.systems.model import System

OF_RCLCPP = "rclcpp"
"""What the identity and the group of a finding about the headers of rclcpp begin with: code that was written for an
older release is one finding, in however many files it is."""


def moved_name_findings(system: System) -> Iterator[Finding]:
    """Names in namespaces that rclcpp has had no more since Galactic."""
    workspace = system.workspace
    if workspace is None or is_from_before_galactic(workspace):
        return
    for moved in moved_names(workspace):
        yield finding(
            "API002",
            moved.place,
            f"rclcpp has no '{moved.name}' since Galactic: this does not compile",
            help=f"write {moved.wanted}",
            identity=(OF_RCLCPP, moved.name),
            group=(OF_RCLCPP, moved.name),
        )


def refused_by_rclcpp_findings(system: System) -> Iterator[Finding]:
    """Calls that rclcpp has had no more since Humble."""
    workspace = system.workspace
    if workspace is None or is_from_before_humble(workspace):
        return
    for place in numbers_as_durations(workspace):
        yield _refused(
            place,
            "rclcpp::Duration() is given one number",
            "say what it counts: rclcpp::Duration::from_seconds(…), or std::chrono::nanoseconds(…) inside",
        )
    declared = {row.place for node in system.nodes for blueprint in node.blueprints for row in blueprint.parameters}
    for place in declared_by_name_alone(workspace, declared):
        yield _refused(
            place,
            "declare_parameter() is given neither a value nor a type",
            "give it a default, or the type: declare_parameter<…>(name)",
        )


def _refused(place: Place, what: str, help: str) -> Finding:
    return finding(
        "API001",
        place,
        f"{what}, which rclcpp takes no more since Humble: this does not compile",
        help=help,
        identity=(OF_RCLCPP, what),
        group=(OF_RCLCPP, what),
    )


__all__ = ["OF_RCLCPP", "moved_name_findings", "refused_by_rclcpp_findings"]

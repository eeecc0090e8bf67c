"""PRM003: parameters that are declared with a type alone, and that no launch file gives a value."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.checks.registry import finding
from archlint.finding import Finding, Related

if TYPE_CHECKING:
    from archlint.launch_files.unset_parameters import Unset

UNSET = "never set"
"""What the findings of this kind have in common."""


def unset_parameter(row: Unset) -> Finding:
    """The finding for one parameter."""
    assert row.node.blueprint is not None
    declared = [] if row.place == row.declared else [Related(row.declared, "it is declared here, without a value")]
    class_name = row.node.blueprint.class_name
    stops = "read, and has no value" if declared else "declared without a value"
    return finding(
        "PRM003",
        row.place,
        f"parameter '{row.name}' is {stops}, and no launch file that starts {class_name} gives it one: the node stops "
        "here",
        help="give it a value in the launch file or its parameter file, or a default where it is declared",
        related=[*declared, Related(row.launched, "the node is started here")],
        node=row.node.name,
        identity=(class_name, row.name),
        group=(row.place.file, class_name, UNSET),
    )


__all__ = ["UNSET", "unset_parameter"]

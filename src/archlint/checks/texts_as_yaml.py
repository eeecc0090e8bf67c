"""What LCH008 says of descriptions of robots that launch_ros reads as YAML."""

from __future__ import annotations

import posixpath
from typing import TYPE_CHECKING

from archlint.checks.registry import finding
from archlint.finding import Finding, Related

if TYPE_CHECKING:
    from archlint.launch_files.texts_as_yaml import TextAsYaml


def text_as_yaml(row: TextAsYaml) -> Finding:
    """The finding for one parameter."""
    name = posixpath.basename(row.comment.file)
    return finding(
        "LCH008",
        row.place,
        f"launch_ros reads the value of '{row.parameter}' as YAML, and stops at the '{row.mark}' in a comment of "
        f"{name}",
        help="write ParameterValue(Command(…), value_type=str), which takes the text as it is",
        related=[Related(row.comment, f"the comment with '{row.mark}' is here")],
        identity=(row.place.file, row.parameter, "yaml"),
        group=(row.place.file, row.parameter, "yaml"),
    )


__all__ = ["text_as_yaml"]

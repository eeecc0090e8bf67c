"""What LCH008 says of commands that make descriptions of robots, and of texts that launch_ros reads as YAML."""

from __future__ import annotations

import posixpath
from typing import TYPE_CHECKING

from archlint.checks.registry import finding
from archlint.finding import Finding, Place, Related

if TYPE_CHECKING:
    from archlint.launch_files.misused_commands import MisusedCommand
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


def misused_command(row: MisusedCommand) -> Finding:
    """The finding for one command."""
    if not row.word:
        return finding(
            "LCH008",
            row.place,
            "launch_ros takes a Command in parameters= for the path of a parameter file: the node gets no description",
            help="write parameters=[{'robot_description': ParameterValue(Command(…), value_type=str)}]",
            identity=(row.place.file, "command as file", str(row.place.line)),
            group=(row.place.file, "command as file"),
        )
    if row.is_argument:
        message = f"Command joins its parts as they are: '{row.word}' becomes the end of the word in front of it"
        help = f"write a blank in front of it: ' {row.word}'"
    else:
        message = f"Command joins its parts as they are: '{row.word}' and what is behind it become one word, no program"
        help = f"write a blank between them: Command(['{row.word} ', …])"
    return finding(
        "LCH008",
        row.place,
        message,
        help=help,
        identity=(row.place.file, "joined", str(row.place.line), row.word),
        group=(row.place.file, "joined"),
    )


def description_in_itself(place: Place, name: str) -> Finding:
    """The finding for one description that is nested in a dict of the same key."""
    return finding(
        "LCH008",
        place,
        f"the value of '{name}' is a dict with the key '{name}': this sets '{name}.{name}', which no node reads",
        help=f"write the dict itself into parameters=[…], without a '{name}' around it",
        identity=(place.file, "nested", str(place.line)),
        group=(place.file, "nested"),
    )


__all__ = ["description_in_itself", "misused_command", "text_as_yaml"]

"""Descriptions of robots in which xacro stops at a substitution, where a launch file names them."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.place import Place
from archlint.records import dataclass
from archlint.suggestions import nearest
from archlint.syntax.xacro_commands import COMMANDS, unknown_commands

if TYPE_CHECKING:
    from archlint.syntax.xacro_commands import UnknownCommand
    from archlint.systems.model import System

KNOWN_TO_XACRO = ", ".join(COMMANDS)
_OF_LAUNCH = {"find-pkg-share": "find", "var": "arg"}


@dataclass(frozen=True)
class UnknownToXacro:
    """A substitution that xacro refuses, as it is ``written``, and the one that is ``meant``, if that can be told."""

    place: Place
    written: str
    meant: str


def unknown_to_xacro(system: System) -> Iterator[UnknownToXacro]:
    """Every such substitution; not one that a launch file in Python has, too: its code may replace that itself."""
    launched, workspace = system.launched, system.workspace
    if launched is None or workspace is None or launched.ros1:
        return
    named = {row.source for row in launched.references if row.source is not None and not row.dormant}
    files = sorted(file for file in named if file.endswith(".xacro"))
    code = [file for file in launched.sources if file.endswith(".py")] if files else []
    texts = [workspace.tree.text(file) or "" for file in code]
    for file in files:
        for command in unknown_commands(workspace.tree.text(file) or ""):
            if not any(command.written in text for text in texts):
                meant = _meant(command, command.command in workspace.packages)
                yield UnknownToXacro(Place(file, *command.span), command.written, meant)


def _meant(command: UnknownCommand, is_package: bool) -> str:
    if command.alone:
        return f"$(find {command.command})" if is_package else ""
    name = _OF_LAUNCH.get(command.command) or nearest(command.command, COMMANDS)
    return "" if name is None else f"$({name} …)"


__all__ = ["KNOWN_TO_XACRO", "UnknownToXacro", "unknown_to_xacro"]

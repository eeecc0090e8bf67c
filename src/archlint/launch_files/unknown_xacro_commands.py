"""Descriptions of robots in which xacro stops at a substitution, where a launch file names them."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.place import Place
from archlint.records import dataclass
from archlint.suggestions import nearest
from archlint.syntax.description_files import files_named
from archlint.syntax.xacro_commands import COMMANDS, Unclosed, macros_called, stops_of_xacro

if TYPE_CHECKING:
    from archlint.syntax.xacro_commands import UnknownCommand
    from archlint.systems.model import System, WorkspaceIndex

KNOWN_TO_XACRO = ", ".join(COMMANDS)
_MOST = 200
"""How many descriptions one launch may come to."""
_OF_LAUNCH = {"find-pkg-share": "find", "var": "arg"}


@dataclass(frozen=True)
class UnknownToXacro:
    """A substitution that xacro refuses, as it is ``written``, and the one that is ``meant``, if that can be told;
    ``perhaps`` where it stands in a condition or a macro, or in a file that a condition includes."""

    place: Place
    written: str
    meant: str
    perhaps: bool
    closing: str = ""
    """The bracket that it lacks, where that is what is wrong."""


def unknown_to_xacro(system: System) -> Iterator[UnknownToXacro]:
    """Every such substitution; not one that a launch file in Python has, too: its code may replace that itself."""
    launched, workspace = system.launched, system.workspace
    if launched is None or workspace is None or launched.ros1:
        return
    named = {row.source for row in launched.references if row.source is not None and not row.dormant}
    certain = sorted(file for file in named if file.endswith(".xacro"))
    files = [*certain, *_included_perhaps(workspace, certain)]
    code = [file for file in launched.sources if file.endswith(".py")] if files else []
    texts = [workspace.tree.text(file) or "" for file in code]
    called = {name for file in files for name in macros_called(workspace.tree.text(file) or "")}
    for file in files:
        for row in stops_of_xacro(workspace.tree.text(file) or "", called):
            if not any(row.written in text for text in texts):
                closing = row.closing if isinstance(row, Unclosed) else ""
                meant = "" if isinstance(row, Unclosed) else _meant(row, row.command in workspace.packages)
                perhaps = row.perhaps or file not in named
                yield UnknownToXacro(Place(file, *row.span), row.written, meant, perhaps, closing)


def _included_perhaps(workspace: WorkspaceIndex, certain: Sequence[str]) -> list[str]:
    """The descriptions of the workspace that others include where a condition holds, and what those include."""
    reached: dict[str, None] = {}
    waiting = [*certain]
    while waiting and len(reached) < _MOST:
        file = waiting.pop()
        for named in files_named(workspace.tree.text(file) or ""):
            package = workspace.packages.get(named.package or "")
            folder = posixpath.dirname(file) if package is None else package.relative
            path = posixpath.normpath(posixpath.join(folder, named.path.lstrip("/")))
            is_known = named.included and (named.package is None or package is not None)
            if is_known and path not in certain and path not in reached and workspace.tree.is_file(path):
                reached[path] = None
                waiting.append(path)
    return sorted(reached)


def _meant(command: UnknownCommand, is_package: bool) -> str:
    if command.alone:
        return f"$(find {command.command})" if is_package else ""
    name = _OF_LAUNCH.get(command.command) or nearest(command.command, COMMANDS)
    return "" if name is None else f"$({name} …)"


__all__ = ["KNOWN_TO_XACRO", "UnknownToXacro", "unknown_to_xacro"]

"""Files that a launch names by their paths in the share folder of a package, whatever they are for."""

from __future__ import annotations

import re
from collections.abc import Iterable
from typing import TYPE_CHECKING

from archlint.interpreter.values import Known, Value
from archlint.launch.described_files import note_described
from archlint.launch.kinds import FileKind
from archlint.launch.objects import known_text

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.launch.run import LaunchRun

_SHARED = re.compile(r"\$\(find-pkg-share [\w.-]+\)/?[^\s'\"\0]*\.\w+(?=$|[\s'\"])")
"""A file, by its path; where a name ends that is not known in full, nothing is."""
_HOLE = "\0"
_FILE_URL = "file://"
_PACKAGE_URL = re.compile(r"package://([\w.-]+)(/.*)")


_WRITTEN = frozenset(
    {"dump", "export", "log", "logs", "out", "output", "record", "result", "results", "save", "saved"}
) | {
    *("storage", "store", "write"),
}


def is_written(parameter: str | None) -> bool:
    """Whether a parameter, by a word of its name, is for a file that the node makes, or its name is not known."""
    return parameter is None or not _WRITTEN.isdisjoint(re.split(r"[\W_]+", parameter.lower()))


def note_paths(
    run: LaunchRun, values: Iterable[Value], place: Place, name: str | None = None, kind: FileKind = FileKind.OTHER
) -> None:
    """Note the values that are paths of files, but for those of RViz, which are noted as such."""
    for value in values:
        text = known_text(value) or ""
        if _SHARED.fullmatch(text) and not text.endswith(".rviz"):
            note_described(run, run.reference(kind, value, place, name))


def note_value(run: LaunchRun, name: str | None, text: str, place: Place, given: Place | None = None) -> None:
    """Note the path of a file that a parameter is set to, by itself or as ``file://…`` or ``package://robot/…``."""
    in_package = _PACKAGE_URL.fullmatch(text)
    path = f"$(find-pkg-share {in_package[1]}){in_package[2]}" if in_package else text.removeprefix(_FILE_URL)
    note_paths(run, [Known(path, origin=given)], place, name)


def note_argument(run: LaunchRun, name: str, value: Value, place: Place) -> None:
    """Note the path that a launch argument or configuration gets, if it is for a file that is read."""
    if not is_written(name) and _SHARED.fullmatch(known_text(value) or ""):
        run.reference(FileKind.ARGUMENT, value, place, name)


def note_paths_in_command(run: LaunchRun, parts: Iterable[Value], place: Place) -> None:
    """Note the paths of files in a command line that several texts make."""
    line = "".join(known_text(part) or _HOLE for part in parts)
    note_paths(run, (Known(path[0]) for path in _SHARED.finditer(line)), place)


__all__ = ["is_written", "note_argument", "note_paths", "note_paths_in_command", "note_value"]

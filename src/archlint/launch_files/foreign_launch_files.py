"""Includes that read a launch file in another language than it is written in.

``PythonLaunchDescriptionSource`` runs any file as Python, and those of XML and YAML parse any as theirs: only
``AnyLaunchDescriptionSource`` asks what a file is.
"""

from __future__ import annotations

import posixpath
from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.place import Place
from archlint.records import dataclass

if TYPE_CHECKING:
    from archlint.launch.named_files import FileReference
    from archlint.systems.model import System, WorkspaceIndex

_READS = {
    "PythonLaunchDescriptionSource": "Python",
    "XMLLaunchDescriptionSource": "XML",
    "YAMLLaunchDescriptionSource": "YAML",
}
_LANGUAGES = {".py": "Python", ".xml": "XML", ".launch": "XML", ".yaml": "YAML", ".yml": "YAML"}


@dataclass(frozen=True)
class ForeignLaunchFile:
    """A ``file`` of one ``language`` that a ``source`` reads as if it were of another."""

    place: Place
    file: str
    language: str
    source: str
    reads: str


def foreign_launch_files(system: System) -> Iterator[ForeignLaunchFile]:
    """Each such include that this launch visits."""
    launched, workspace = system.launched, system.workspace
    if launched is None or workspace is None:
        return
    for included in launched.included:
        reads = _READS.get(included.source_class)
        language = _language_of(workspace, included.reference)
        if reads is not None and language is not None and language != reads and not included.dormant:
            file = posixpath.basename(included.reference.written or "")
            yield ForeignLaunchFile(included.place, file, language, included.source_class, reads)


def _language_of(workspace: WorkspaceIndex, reference: FileReference) -> str | None:
    """What a launch file is written in, by its name; one that is here must begin like it."""
    language = _LANGUAGES.get(posixpath.splitext(reference.written or "")[1])
    if reference.source is None or language != "XML":
        return language
    return language if (workspace.tree.text(reference.source) or "").lstrip("\ufeff \t\r\n").startswith("<") else None


__all__ = ["ForeignLaunchFile", "foreign_launch_files"]

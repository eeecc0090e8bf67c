"""The files that a description of a robot names which a launch file has read: what it includes, and meshes."""

from __future__ import annotations

import posixpath
from typing import TYPE_CHECKING

from archlint.finding import Place
from archlint.interpreter.values import Known
from archlint.launch.kinds import FileKind
from archlint.syntax.description_files import files_named

if TYPE_CHECKING:
    from archlint.launch.named_files import FileReference
    from archlint.launch.run import LaunchRun

_ENDINGS = (".urdf", ".xacro")
_MOST = 200
"""How many descriptions one launch may come to."""


def note_described(run: LaunchRun, description: FileReference) -> None:
    """Note the files that a description of the workspace names, and those of the descriptions that it includes."""
    waiting = [description]
    seen: set[str] = set()
    while waiting and len(seen) < _MOST:
        reference = waiting.pop()
        source, written = reference.source, reference.written
        if source is None or written is None or source in seen or not written.endswith(_ENDINGS):
            continue
        seen.add(source)
        for named in files_named(run.paths.text(reference) or ""):
            if named.perhaps:
                continue
            folder = posixpath.dirname(written) if named.package is None else f"$(find-pkg-share {named.package})"
            path = posixpath.join(folder, named.path.lstrip("/"))
            kind = FileKind.READ if named.included else FileKind.OTHER
            inner = run.reference(kind, Known(path), Place(source, *named.span))
            if named.included:
                waiting.append(inner)


__all__ = ["note_described"]

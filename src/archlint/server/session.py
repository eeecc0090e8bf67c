"""One workspace of an editor: its configuration, and what its last analysis found."""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.live.workspace import Asked, LiveWorkspace
from archlint.server.configuration import Configuration
from archlint.workspace.around import is_below, package_around, workspace_around
from archlint.workspace.kinds import kind_of

if TYPE_CHECKING:
    from archlint.live.buffers import Buffers
    from archlint.live.snapshot import Snapshot
    from archlint.monitor import Monitor

_CODE = ("python", "cpp", "launch_python", "launch_xml", "launch_yaml", "parameters")
"""Kinds of files whose text decides nothing about which files and packages there are."""


class Session:
    """The workspace at ``root``.  Used by one thread at a time; ``snapshot`` may be read by any."""

    def __init__(self, root: str, paths: Sequence[str]) -> None:
        self.root = root
        self.configuration = Configuration()
        self.snapshot: Snapshot | None = None
        """What the last analysis found."""
        self._paths = tuple(paths)
        self._live = LiveWorkspace(root)
        self._buffers: Buffers = {}
        self._changes = 1
        """How often something has been said to have changed on the disk: this may come in the midst of an analysis."""
        self._changes_seen = 0
        """How many of these the last analysis that came to its end knew of when it began."""

    def look_again(self) -> None:
        """Files may have come or gone, or changed on the disk."""
        self._changes += 1

    def analyse(self, buffers: Buffers, monitor: Monitor) -> Iterator[Snapshot]:
        """What is found now: a first answer where there can be one soon, and the whole one.  ``monitor`` may raise what
        is no ``Exception`` to end the analysis."""
        changes = self._changes
        if changes != self._changes_seen or self._decides(buffers):
            self.configuration = self.configuration.again(self.root, buffers)
            self._live.look_again()
        asked = Asked(self._paths, self.configuration.settings, self.configuration.baseline)
        first = self._live.first_answer(asked, buffers, monitor)
        if first is not None:
            self.snapshot = first
            yield first
        whole = self._live.analyse(asked, buffers, monitor)
        self._buffers, self._changes_seen, self.snapshot = buffers, changes, whole
        yield whole

    def close(self) -> None:
        self._live.close()

    def _decides(self, buffers: Buffers) -> bool:
        """Whether a text has changed that says more than code does: the configuration, a manifest, a build file."""
        changed = {path for path in buffers.keys() | self._buffers.keys() if self._differs(path, buffers)}
        return any(_kind(path) not in _CODE or self.configuration.is_read_from(path) for path in changed)

    def _differs(self, path: str, buffers: Buffers) -> bool:
        before, now = self._buffers.get(path), buffers.get(path)
        return before is None or now is None or before.data != now.data


def _kind(path: str) -> str | None:
    folder, name = os.path.split(path)
    return kind_of(name, os.path.basename(folder))


def place_of(path: str, folders: Sequence[str]) -> tuple[str, tuple[str, ...]]:
    """The workspace that a file lies in, and what of it is asked for.  ``folders`` are those that are open in the
    editor: of a workspace around them they are what is asked for, and the rest is read as its surroundings."""
    inside = max((folder for folder in folders if is_below(path, folder)), key=len, default=None)
    root = workspace_around(path)
    if root is None:
        root = inside or package_around(path)
    if root is None:
        return os.path.dirname(path), (path,)
    if os.path.dirname(root) in folders and os.path.basename(root) == "src":
        root = os.path.dirname(root)  # who opens a workspace means all of it, as who checks it there does
    asked = tuple(folder for folder in folders if is_below(folder, root) and folder != root)
    return root, asked if inside is not None and inside in asked else (root,)


__all__ = ["Session", "place_of"]

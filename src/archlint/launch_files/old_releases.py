"""Launch files that are called after a release whose ``Node`` took ``node_name`` and the like."""

from __future__ import annotations

import posixpath
import re
from typing import TYPE_CHECKING

from archlint.ros.distros import DISTROS
from archlint.suggestions import distance

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex

_OLD_RELEASES = ("dashing", "eloquent", "foxy")
_LATER_RELEASES = ("galactic", "iron", *DISTROS)
_LONG = 7
"""Letters of a name that is still itself with one of them wrong."""


def is_for_an_old_release(file: str) -> bool:
    """Whether a file is called after one of them, be it with a slip."""
    return any(map(_is_old_release, re.findall("[a-z]+", posixpath.basename(file))))


def has_successor(workspace: WorkspaceIndex | None, file: str) -> bool:
    """Whether the file for the releases since then lies beside one for an old one: ``start.py`` beside
    ``dashing_start.py``, or ``start_galactic.py`` beside ``start_dashing.py``."""
    folder, name = posixpath.split(file)
    words = [match for match in re.finditer("[a-z]+", name) if _is_old_release(match[0])]
    newer = [f"{name[: match.start()].rstrip('_-.')}{name[match.end() :]}".lstrip("_-.") for match in words]
    newer += [f"{name[: match.start()]}{later}{name[match.end() :]}" for match in words for later in _LATER_RELEASES]
    return workspace is not None and any(workspace.tree.is_file(posixpath.join(folder, other)) for other in newer)


def _is_old_release(word: str) -> bool:
    return any(distance(word, name, 1) <= int(len(name) >= _LONG) for name in _OLD_RELEASES)


__all__ = ["has_successor", "is_for_an_old_release"]

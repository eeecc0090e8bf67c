"""What is different on the disk once something that a run depends on has changed."""

from __future__ import annotations

from collections.abc import Hashable, Iterable
from typing import TYPE_CHECKING

from archlint.engine.keeper import Above
from archlint.workspace.discovery import PathNotFound, find

if TYPE_CHECKING:
    from archlint.config.settings import Settings


def state_of(paths: Iterable[str], settings: Settings, others: Iterable[str]) -> Hashable:
    """The files of some paths and of the workspace around them, and those of the configuration, with their stamps;
    ``others`` are files beside them."""
    asked = list(paths)
    above = Above(asked, settings, others)
    exclude = [pattern for glob in settings.exclude for pattern in glob.patterns()]
    try:
        workspace = find(asked, exclude=exclude)
    except PathNotFound as error:
        return above.kinds, error.path
    files = tuple((file.relative, file.stamp) for file in workspace.files)
    return above.kinds, tuple(above.rows().items()), files, workspace.problems


__all__ = ["state_of"]

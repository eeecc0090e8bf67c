"""An action that a node offers beside a service, for the same part of the robot."""

from __future__ import annotations

import posixpath
from typing import TYPE_CHECKING

from archlint.model import EntityKind

if TYPE_CHECKING:
    from archlint.model import Creation


def action_beside(service: Creation, creations: list[Creation]) -> Creation | None:
    """The action in a service's own folder of names, ``gripper/command`` beside ``gripper/set``, of a node that makes
    ``creations``.  A folder that holds several services and all other names of the node says nothing: it is the
    robot's."""
    folder = _folder(service)
    if not folder.strip("/~"):
        return None
    several = any(creation.kind == EntityKind.SERVICE and creation is not service for creation in creations)
    if several and all(_folder(creation).startswith(folder) for creation in creations if creation.name.text):
        return None
    servers = (creation for creation in creations if creation.kind == EntityKind.ACTION_SERVER)
    return next((server for server in servers if _folder(server) == folder), None)


def _folder(creation: Creation) -> str:
    return posixpath.dirname(creation.name.text or "")


__all__ = ["action_beside"]

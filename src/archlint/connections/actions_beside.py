"""An action that a node offers beside a service, for the same part of the robot."""

from __future__ import annotations

import posixpath
import re
from typing import TYPE_CHECKING

from archlint.model import EntityKind

if TYPE_CHECKING:
    from archlint.model import Creation


def action_beside(service: Creation, creations: list[Creation]) -> Creation | None:
    """The action in a service's own folder of names, ``gripper/command`` beside ``gripper/set``, of a node that makes
    ``creations``.  A folder that holds several services and all other names of the node says nothing: it is the
    robot's; and an action whose own name speaks of something else is for that."""
    folder = _folder(service)
    if not folder.strip("/~"):
        return None
    several = any(creation.kind == EntityKind.SERVICE and creation is not service for creation in creations)
    if several and all(_folder(creation).startswith(folder) for creation in creations if creation.name.text):
        return None
    servers = (creation for creation in creations if creation.kind == EntityKind.ACTION_SERVER)
    return next((server for server in servers if _folder(server) == folder and not _differ(service, server)), None)


_OF_ANY_TASK = frozenset(
    {"action", "command", "control", "do", "execute", "get", "go", "goal", "motion", "move", "request", "run"}
    | {"server", "service", "set", "srv", "start", "state", "to", "trigger"}
)
"""Words of names that say nothing of what is to be done."""


def _differ(service: Creation, action: Creation) -> bool:
    """Whether the names of two in one folder speak of different things: ``arm/press_button`` and ``arm/pick``."""
    asked, offered = _task(service), _task(action)
    return bool(asked and offered) and asked.isdisjoint(offered)


def _task(creation: Creation) -> frozenset[str]:
    words = re.split(r"[^a-z]+", posixpath.basename(creation.name.text or "").lower())
    return frozenset(word for word in words if word) - _OF_ANY_TASK


def _folder(creation: Creation) -> str:
    return posixpath.dirname(creation.name.text or "")


__all__ = ["action_beside"]

"""Defects that show in a closed world only.  Which systems are closed and whole is asked of archlint itself."""

from __future__ import annotations

import os
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

from archlint.checks.unmatched import whole
from archlint.config.settings import Settings
from archlint.engine import pipeline
from archlint.model import (
    EntityKind,
)

from .defect import Defect
from .python_source import Edit, Lines

if TYPE_CHECKING:
    from archlint.systems.model import System
    from archlint.systems.nodes import Connection, Endpoint

RULES = {"topic": ("TOP002", "TOP003", "TOP004"), "service": ("SRV001",), "action": ("ACT001",)}


def closed_systems(root: Path, cache: Path) -> Iterator[System]:
    """The systems of a checkout's launch files that are closed, with every node's source at hand."""
    os.chdir(root)
    request = pipeline.Request((".",), Settings(closed_world=True, cache_dir=str(cache)))
    try:
        workspace = pipeline._found(request)
        facts = pipeline._compiled(request, workspace, pipeline._store(request))
        systems = pipeline._systems(request, workspace, facts)
    except pipeline.NothingToDo:
        return
    for system in systems:
        if system.launched is not None and len(system.nodes) > 1 and whole(system):
            yield system


def renamed_ends(system: System, data_of: dict[str, bytes]) -> Iterator[tuple[str, Defect]]:
    """For each name with one end on each side: one of them gets a name that nobody else has."""
    every = (*system.topics.values(), *system.services.values(), *system.actions.values())
    for connection in every:
        if len(connection.providers) != 1 or len(connection.users) != 1:
            continue
        for end in (*connection.providers, *connection.users):
            edit = _renamed(end, data_of)
            if edit is not None:
                rules = _expected(connection, end)
                places = tuple(
                    Lines(one.place.file, one.place.line, one.place.end_line)
                    for one in (*connection.providers, *connection.users)
                )
                also = ("TOP002", "TOP003", "TOP004", "GRF001", "NME001")
                what = f"closed world: one end of a {connection.kind} renamed"
                yield what, Defect((edit,), rules, places, also=also, launch=system.name)


def _expected(connection: Connection, end: Endpoint) -> tuple[str, ...]:
    if connection.kind == "topic":
        return ("TOP002", "TOP003")
    return ("SRV001",) if connection.kind == "service" else ("ACT001",)


def _renamed(end: Endpoint, data_of: dict[str, bytes]) -> Edit | None:
    """Write another literal at the create call."""
    place, data = end.creation.name_place, data_of.get(end.place.file)
    if (
        place is None
        or data is None
        or place.line != place.end_line
        or end.kind not in (*_ENDS, EntityKind.CLIENT, EntityKind.PUBLISHER)
    ):
        return None
    line = data.splitlines(keepends=True)[place.line - 1].decode()
    before = sum(len(one) for one in data.splitlines(keepends=True)[: place.line - 1])
    written = line[place.column - 1 : place.end_column - 1]
    if not written or written[0] not in "'\"" or written[-1] != written[0] or end.node.launch_place is None:
        return None
    start = before + len(line[: place.column - 1].encode())
    return Edit(end.place.file, start, start + len(written.encode()), b"'planted_in_between'")


_ENDS = ("subscriber", "service", "action_server", "action_client")

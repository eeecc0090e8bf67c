"""What another machine does to link a part of a workspace."""

from __future__ import annotations

from dataclasses import replace

import msgspec

from archlint.config.settings import Settings
from archlint.engine.compiling import compiled
from archlint.engine.facts_file import unpacked
from archlint.engine.inputs import Inputs, find_files
from archlint.engine.link_elsewhere import LinkTask
from archlint.engine.linked_facts import LinkedFacts
from archlint.engine.loading import follow_part
from archlint.engine.request import Request
from archlint.syntax.cache import NullStore


def link_part(payload: bytes) -> bytes:
    """The programs of a :class:`LinkTask`, as they are kept."""
    task = msgspec.msgpack.decode(payload, type=LinkTask)
    linked = LinkedFacts({str(number): unpacked(data) for number, data in enumerate(task.shards)}, task.base)
    request = Request((), Settings(), cached=False, jobs=2, linked=linked)
    workspace = find_files(request)
    wanted = set(task.files)
    files = tuple(file for file in workspace.files if file.relative in wanted)
    inputs = Inputs(request, replace(workspace, files=files), linked.tree, NullStore())
    return follow_part(inputs, compiled(request, workspace, NullStore()), task.modules, task.code)


__all__ = ["link_part"]

"""Linking on other machines: each follows some of the programs, and what it finds is used as if an earlier run had.

It gets the facts of the whole workspace, as ``archlint facts`` writes them, and needs no file of it.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import msgspec

from archlint.engine.collecting import shards_of
from archlint.engine.facts_file import OddShard, packed
from archlint.engine.facts_folder import FactsError
from archlint.engine.own_code import own_code
from archlint.programs.ahead import DEADLINE

if TYPE_CHECKING:
    from archlint.engine.inputs import Inputs
    from archlint.programs.kept import KeptPrograms
    from archlint.syntax.files import FactsOfFiles


class LinkTask(msgspec.Struct, frozen=True):
    """``files`` are those of the workspace that is linked, of those that stand side by side in the shards;
    ``modules`` the ones whose programs are to be followed."""

    base: str
    shards: list[bytes]
    files: list[str]
    modules: list[str]
    code: list[tuple[str, int, int]]


def follow_elsewhere(inputs: Inputs, facts: FactsOfFiles) -> Callable[[Sequence[Sequence[str]], KeptPrograms], None]:
    """Follows groups of programs on the machines of the request's pool, and adds what they find to what is kept."""

    def follow(groups: Sequence[Sequence[str]], kept: KeptPrograms) -> None:
        pool, monitor = inputs.request.pool, inputs.request.monitor
        assert pool is not None
        count = min(len(groups), pool.width)
        if count < 2:
            return
        modules = [[path for group in groups[number::count] for path in group] for number in range(count)]
        try:
            tasks = _tasks(inputs, facts, modules)
        except (FactsError, OddShard):  # files outside of the working directory: they are linked here
            return
        monitor.dividing(count)
        try:
            answers = pool.map(pool.link, tasks, DEADLINE, lambda number, seconds: monitor.part_done())
        finally:
            monitor.divided()
        for answer in answers:
            if isinstance(answer, bytes):
                kept.add(answer)

    return follow


def _tasks(inputs: Inputs, facts: FactsOfFiles, modules: Sequence[list[str]]) -> list[bytes]:
    workspace = inputs.workspace
    shards = shards_of(workspace, facts, workspace.complete_folders, Path.cwd(), whole=True)
    data = [packed(shard) for _, shard in sorted(shards.items())]
    files = [file.relative for file in workspace.files]
    code = own_code()
    tasks = (LinkTask(os.getcwd(), data, files, paths, code) for paths in modules)
    return [msgspec.msgpack.encode(task) for task in tasks]


__all__ = ["LinkTask", "follow_elsewhere"]

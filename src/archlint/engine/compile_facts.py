"""``archlint facts``: find and compile, and write down what linking needs."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from archlint.engine.collecting import shards_of
from archlint.engine.compiling import compiled
from archlint.engine.facts_folder import FactsError, write
from archlint.engine.inputs import find_files, python_files
from archlint.engine.pipeline import store_of
from archlint.records import dataclass

if TYPE_CHECKING:
    from archlint.engine.facts_file import Shard
    from archlint.engine.request import Request
    from archlint.syntax.files import FactsOfFiles
    from archlint.workspace.model import Workspace


@dataclass(frozen=True)
class Written:
    """What has been written: so many packages and files, and where archlint itself has failed."""

    packages: int
    files: int
    faults: list[str]


def write_facts(request: Request, folder: Path, prefix: str) -> Written:
    """Raises :class:`FactsError` and :class:`~archlint.engine.request.NothingToDo`."""
    workspace = find_files(request)
    store = store_of(request)
    facts = compiled(request, workspace, store)
    shards = collected(request, workspace, facts, prefix)
    write(folder, shards)
    store.close()
    files = sum(not row.context for shard in shards.values() for row in shard.files)
    packages = sum(any(row.kind == "package_xml" for row in shard.files) for shard in shards.values())
    return Written(packages, files, [] if facts.lasting else list(_faults(workspace, facts)))


def collected(request: Request, workspace: Workspace, facts: FactsOfFiles, prefix: str = "") -> dict[str, Shard]:
    """The shards of what a request is about, by the folders of the packages."""
    return shards_of(workspace, facts, request.paths, Path.cwd(), prefix)


def _faults(workspace: Workspace, facts: FactsOfFiles) -> list[str]:
    read = ((file, facts.facts_of(file)) for file in python_files(workspace) if facts.was_read(file))
    return [
        f"{file.relative}:{problem.line}:{problem.column}: {problem.message}"
        for file, file_facts in read
        if file_facts is not None
        for problem in file_facts.problems
        if problem.internal
    ]


__all__ = ["FactsError", "Written", "collected", "write_facts"]

"""Which files have code of nodes that launch files start: what is wrong there meets a user first."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from archlint.finding import Finding
    from archlint.model import Blueprint
    from archlint.systems.model import System


def launched_files(systems: Iterable[System], findings: Iterable[Finding]) -> list[str]:
    """The files of findings in which a node that a launch file starts is defined, creates something or has a
    callback."""
    launched = (node for system in systems if system.launched is not None for node in system.nodes)
    files = {file for node in launched for blueprint in node.blueprints for file in _files_of(blueprint)}
    return sorted(files & {finding.place.file for finding in findings})


def _files_of(blueprint: Blueprint) -> Iterator[str]:
    yield blueprint.place.file
    yield from (creation.place.file for creation in blueprint.creations)
    yield from (callback.place.file for callback in blueprint.callbacks)


__all__ = ["launched_files"]

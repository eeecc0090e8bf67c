"""Which C++ sources belong to a header."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.interpreter.reads import Reads
from archlint.syntax.facts import Facts, ImportFrom
from archlint.syntax.parts import once_for
from archlint.workspace.includes import SOURCE

if TYPE_CHECKING:
    from archlint.interpreter.modules import Module, ModuleIndex
    from archlint.workspace.model import SourceFile


def sources_to_run(index: ModuleIndex, module: Module) -> Iterator[Module]:
    """The C++ sources that define what headers declare, once the outermost of these headers is read: what includes it
    again meets it whole."""
    index.unlinked.append(module)
    while index.unlinked and not index.running:
        header = index.unlinked.pop(0)
        with index.reading(header.reads):  # whoever includes the header depends on them, too
            yield from _implementations(index, header)


def _implementations(index: ModuleIndex, header: Module) -> Sequence[Module]:
    """The C++ sources that define what a header declares: those of its package that include it."""
    if not index.importable.includes.is_header(header.file):
        return ()
    beside = index.importable.includes.sources_beside(header.file)
    index.find(header, f"{SOURCE}{len(beside)}")  # there is none: one more would count
    if not beside:
        return ()
    first = beside[0].path
    if first not in index.including:
        index.including[first] = _includers(index, beside)
    includers, reads = index.including[first]
    header.reads.of_packages[first] = reads
    return includers.get(header.file.path, ())


def _includers(index: ModuleIndex, beside: Sequence[SourceFile]) -> tuple[dict[str, list[Module]], Reads]:
    """Which sources of a package include each file, by its path, and what was read for that, once for all headers."""
    includers: dict[str, list[Module]] = {}
    with index.reading(Reads()) as reads:
        for file in beside:
            module = index.module(file)
            if module is None:
                continue
            meant = (index.find(module, name) for name in _included_by(module.facts))
            for path in dict.fromkeys(included.file.path for included in meant if included is not None):
                includers.setdefault(path, []).append(module)
    return includers, reads


@once_for
def _included_by(facts: Facts) -> tuple[str, ...]:
    """The files that a C++ file includes at its top level, as it writes them."""
    return tuple(row.module for row in facts.body if isinstance(row, ImportFrom) and row.names == [("*", "*")])


__all__ = ["sources_to_run"]

"""What a run has read of the workspace: the code that it saw, and what it asked for in vain.

Whatever a run gives is decided by that.  Where all of it is as before, the run would give the same again.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import field
from typing import TYPE_CHECKING

from archlint.records import dataclass
from archlint.workspace.closure import closure

if TYPE_CHECKING:
    from archlint.workspace.tree import Question

Lookup = tuple[str, str, int]
"""An import: the path of the file that it is in, the name, and how many dots it begins with."""


@dataclass(eq=False)
class Reads:
    """What one run, or the import of one module, has read; files by their paths."""

    files: set[str] = field(default_factory=set)
    """The files whose code was looked at."""
    used: set[str] = field(default_factory=set)
    """The modules that were imported, or had been before."""
    lookups: dict[Lookup, str | None] = field(default_factory=dict)
    """The file that each import means; None where it means none of the workspace."""
    imports: list[list[str]] = field(default_factory=list)
    """The modules that ran for the first time: each that was imported first, and those that its import led to."""
    answers: dict[Question, str | None] = field(default_factory=dict)
    """What was asked of the disk."""
    everything: bool = False
    """Whether it depends on all that has been imported so far, by whatever program."""
    of_packages: dict[str, Reads] = field(default_factory=dict)
    """What all headers of a C++ package have read in the same way: what its sources include."""

    def with_imports(self, of_module: Callable[[str], Reads | None]) -> Reads:
        """This, and what the imports of the modules that were used have read in their turn."""

        def used_by(path: str) -> Iterable[str]:
            reads = of_module(path)
            return () if reads is None else reads.used

        used = closure(self.used, used_by)
        parts = [self, *(reads for path in sorted(used) if (reads := of_module(path)) is not None)]
        shared = {package: reads for part in parts for package, reads in part.of_packages.items()}
        parts.extend(shared.values())
        files = set(used).union(*(reads.files for reads in parts))
        lookups: dict[Lookup, str | None] = {}
        answers: dict[Question, str | None] = {}
        for reads in parts:
            lookups.update(reads.lookups)
            answers.update(reads.answers)
        everything = any(reads.everything for reads in parts)
        return Reads(files, set(used), lookups, self.imports, answers, everything)

    def add(self, other: Reads) -> None:
        """Note what somebody else has read for this one."""
        self.files |= other.files
        self.used |= other.used
        self.lookups.update(other.lookups)
        self.answers.update(other.answers)
        self.everything |= other.everything
        self.of_packages.update(other.of_packages)


__all__ = ["Lookup", "Reads"]

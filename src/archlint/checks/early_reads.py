"""What API002 says of attributes that a constructor reads before it assigns them."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.checks.registry import finding
from archlint.finding import Finding, Related
from archlint.python_code.early_attribute_reads import EarlyRead, early_attribute_reads

if TYPE_CHECKING:
    from archlint.systems.model import System

TOO_EARLY = "too early"
"""The group of findings about what one class reads too early."""


def early_read_findings(system: System) -> Iterator[Finding]:
    """A finding for each such attribute."""
    if system.workspace is not None:
        yield from map(_finding, early_attribute_reads(system.workspace))


def _finding(read: EarlyRead) -> Finding:
    related = [Related(read.assigned, "it gets its first value here")]
    if read.called is None:
        told = f"{read.cls} assigns self.{read.name} only later: this line fails with an AttributeError"
        help = f"assign self.{read.name} before this line"
    else:
        told = (
            f"{read.cls} assigns self.{read.name} only after its __init__() has called {read.method}(), which fails "
            "here with an AttributeError"
        )
        help = f"assign self.{read.name} before the call of {read.method}()"
        related.append(Related(read.called, f"{read.method}() is called here"))
    return finding(
        "API002",
        read.place,
        told,
        help=help,
        related=related,
        identity=(read.cls, read.name, "early"),
        group=(TOO_EARLY, read.place.file, read.cls),
        fails=read.called is None,
    )


__all__ = ["TOO_EARLY", "early_read_findings"]

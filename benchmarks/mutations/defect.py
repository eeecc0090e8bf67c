"""What a planted defect is, and the register of the ways to plant one."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field

from .python_source import Edit, Lines
from .trees import Package


@dataclass(frozen=True)
class Defect:
    """One defect: ``edits`` plant it, and one of ``rules`` is expected at one of ``places``.

    ``also`` are rules that may rightly tell another side of it.  ``launch`` is the launch file whose system is
    judged as a closed world; None for the open one with the rules that are on by default.
    """

    edits: tuple[Edit, ...]
    rules: tuple[str, ...]
    places: tuple[Lines, ...]
    also: tuple[str, ...] = ()
    launch: str | None = None


@dataclass(frozen=True)
class Sites:
    """Where defects can be planted: one package, with all those that stand beside it in the workspace."""

    home: Package
    beside: dict[str, Package] = field(default_factory=dict)


Planter = Callable[[Sites], Iterator[Defect]]
PLANTERS: dict[str, Planter] = {}


def plants(what: str) -> Callable[[Planter], Planter]:
    """Register a generator of defects under the words that the table shows."""

    def register(planter: Planter) -> Planter:
        PLANTERS[what] = planter
        return planter

    return register

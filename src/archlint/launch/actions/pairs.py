"""Pairs of texts, such as remappings and the arguments of an include, each with the place where it is written."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.finding import Place
from archlint.interpreter.values import Known, Value
from archlint.launch.objects import PAIR_PLACE
from archlint.records import dataclass

if TYPE_CHECKING:
    from archlint.launch.run import LaunchRun


@dataclass(frozen=True)
class Pair:
    first: Value
    second: Value
    place: Place


def pairs_of(run: LaunchRun, value: Value | None) -> Iterator[Pair]:
    """The known items of a list, or entries of a dict, that are pairs."""
    for row in run.items(value):
        match run.items(row):
            case [first, second]:
                yield Pair(first, second, _place_of(run, row, first))


def _place_of(run: LaunchRun, row: Value, first: Value) -> Place:
    """Where a pair is written: in XML and YAML an element, in Python as far as its first text says so."""
    written = run.store.get(row.heap_key or 0, PAIR_PLACE)
    return written or (first.origin if isinstance(first, Known) else None) or run.place_now

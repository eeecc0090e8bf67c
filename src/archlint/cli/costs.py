"""What took long in a run, for ``--verbose``."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING

from archlint.counted import counted

if TYPE_CHECKING:
    from archlint.cli.tally import Tally

MOST = 10
"""How many files and programs are named."""


def costs(tally: Tally) -> Iterator[str]:
    """What was done and what was kept, and the slowest files and programs with their share of the processor time."""
    yield f"processor time: {tally.seconds:.2f} s"
    yield f"read {counted(len(tally.files), 'file')}{_total(tally.files.values(), tally.seconds)}"
    yield from _slowest(tally.files, tally.seconds)
    if not tally.links:
        yield "analysed no programs: the result of an earlier run was reused"
        return
    seconds = [seconds for _, seconds in tally.programs.values()]
    followed = f"analysed {counted(len(tally.programs), 'program')}{_total(seconds, tally.seconds)}"
    yield f"{followed}; reused {tally.kept} from an earlier run"
    yield from _slowest(_by_name(tally), tally.seconds)


def _by_name(tally: Tally) -> dict[str, float]:
    """The seconds of each program; that of one with several sets of parameters once."""
    rows: dict[str, list[float]] = {}
    for program, seconds in tally.programs.values():
        rows.setdefault(program, []).append(seconds)
    return {
        program if len(every) == 1 else f"{program}, {len(every)} times": sum(every) for program, every in rows.items()
    }


def _slowest(rows: dict[str, float], all_seconds: float) -> Iterator[str]:
    for name, seconds in sorted(rows.items(), key=lambda row: (-row[1], row[0]))[:MOST]:
        yield f"  {seconds:7.2f} s {_share(seconds, all_seconds):>6}  {name}"


def _total(every: Iterable[float], all_seconds: float) -> str:
    seconds = sum(every)
    return f": {seconds:.2f} s, {_share(seconds, all_seconds)}" if seconds else ""


def _share(seconds: float, all_seconds: float) -> str:
    return f"{100 * seconds / all_seconds:.1f} %" if all_seconds > 0 else "-"


__all__ = ["MOST", "costs"]

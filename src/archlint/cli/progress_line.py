"""One line of a terminal that says how far a run is, and is gone when it ends."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING, TextIO

from archlint.cli.console import columns

if TYPE_CHECKING:
    from archlint.cli.tally import Tally

DELAY = 1.0
"""How many seconds a run lasts before it says anything: most have ended by then."""

INTERVAL = 0.1
"""The fewest seconds between two changes of the line."""


class ProgressLine:
    """Writes the line, and writes over it.  ``clock`` gives seconds."""

    def __init__(self, stream: TextIO, clock: Callable[[], float] = time.monotonic) -> None:
        self._stream = stream
        self._clock = clock
        self._next = clock() + DELAY
        self._width = 0

    def show(self, tally: Tally) -> None:
        """Bring the line up to date, unless it is too early for that."""
        now = self._clock()
        if now < self._next:
            return
        self._next = now + INTERVAL
        text = words(tally)[: (columns(self._stream) or 80) - 1]  # a line that is full would be two
        self._write(f"\r{text.ljust(self._width)}")
        self._width = len(text)

    def erase(self) -> None:
        """Leave the terminal as it was."""
        if self._width:
            self._write(f"\r{' ' * self._width}\r")
            self._width = 0

    def _write(self, text: str) -> None:
        try:
            self._stream.write(text)
            self._stream.flush()
        except (OSError, ValueError):  # the terminal has gone: nobody looks
            self._next = float("inf")


def words(tally: Tally) -> str:
    """How far a run is."""
    return "archlint: " + (", ".join(_parts(tally)) or "reading")


def _parts(tally: Tally) -> Iterator[str]:
    if tally.files_all:
        yield f"{_of(tally.files_done, tally.files_all)} files read"
    if tally.parts_all:
        yield f"{_of(tally.parts_done, tally.parts_all)} parts of the programs analysed"
    elif tally.programs_all:
        yield f"{_of(tally.programs_done, tally.programs_all)} programs analysed"
    if tally.systems_all:
        yield f"{_of(tally.systems_done, tally.systems_all)} systems checked"


def _of(done: int, all_: int) -> str:
    return f"{done}/{all_}"


__all__ = ["DELAY", "INTERVAL", "ProgressLine", "words"]

"""What is said on standard error of how a run goes: a line while it lasts, and with ``--verbose`` what took long."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, TextIO

from archlint.cli import console
from archlint.monitor import Monitor

if TYPE_CHECKING:
    from archlint.cli.progress_line import ProgressLine
    from archlint.cli.tally import Tally


class Progress:
    """Shows what happens inside the block: ``with Progress(…) as monitor``.  Several blocks of one add up."""

    def __init__(self, stream: TextIO, quiet: bool, verbose: bool) -> None:
        self._line: ProgressLine | None = None
        self._tally: Tally | None = None
        self._verbose = verbose and not quiet
        shows_line = not quiet and shows_progress(stream)
        if not (shows_line or self._verbose):
            return
        from archlint.cli.tally import Tally  # most runs are short, and nobody watches those of machines

        self._tally = Tally()
        if shows_line:
            from archlint.cli.progress_line import ProgressLine

            self._line = ProgressLine(stream)
            self._tally.changed = self._line.show

    def __enter__(self) -> Monitor:
        return self._tally or Monitor()

    def __exit__(self, *error: object) -> None:
        if self._line is not None:
            self._line.erase()
        if self._tally is not None:
            self._tally.end()

    def note_costs(self) -> None:
        """Say what took long, where that was asked for."""
        if self._tally is not None and self._verbose:
            from archlint.cli.costs import costs

            console.note("\n".join(costs(self._tally)))


def shows_progress(stream: TextIO) -> bool:
    """Whether somebody sits in front of a stream: it is a terminal that can go back in a line, and no CI job's."""
    environment = os.environ.get
    in_ci = environment("CI", "").lower() not in ("", "0", "false")
    return not in_ci and environment("TERM") != "dumb" and stream.isatty()


__all__ = ["Progress", "shows_progress"]

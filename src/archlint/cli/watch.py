"""``archlint check --watch``: the result on the screen, and again whenever a file has changed.

Changes are found by asking for the stamps of the files: that is the same on every system and every file system, and
takes milliseconds, less than what a library would have to be installed for.
"""

from __future__ import annotations

import argparse
import gc
import sys
import time
from collections.abc import Callable, Hashable, Sequence
from typing import TYPE_CHECKING, NoReturn

from archlint import report as reports
from archlint.cli.exits import UsageError
from archlint.cli.watch_view import View
from archlint.config.settings import Settings
from archlint.engine.changes import state_of

if TYPE_CHECKING:
    from archlint.cli.said import Checked
    from archlint.engine.request import Request
    from archlint.finding import Finding

INTERVAL = 0.5
"""The fewest seconds between two looks at the disk."""
PAUSE = time.sleep
_SHARE = 5
"""A pause is so many times as long as a look, on a disk that is slow."""
_NOT_WATCHED = (
    "file",
    "output",
    "fix",
    "diff",
    "add_ignores",
    "write_baseline",
    "prune_baseline",
    "facts",
    "scheduler",
)


def watch(arguments: argparse.Namespace, checked: Callable[[argparse.Namespace], Checked]) -> NoReturn:
    """Check until Ctrl-C, which raises ``KeyboardInterrupt``.

    Raises :class:`UsageError` where that makes no sense or the first check cannot be done; a later one is shown, and
    the next change may mend it.
    """
    _refuse(arguments)
    gc.enable()  # a run is short, a watch is not
    view = View(arguments.color, arguments.quiet)
    disk = _Disk(arguments)
    before: Sequence[Finding] | None = None
    while True:
        state = disk.state()
        started = time.perf_counter()
        try:
            done = checked(argparse.Namespace(**vars(arguments)))  # a copy: a run completes what it is given
        except UsageError as error:
            if before is None:
                raise
            view.show_error(str(error))
        else:
            view.show(done.answer, done.report.findings, before, time.perf_counter() - started)
            before = done.report.findings
            if disk.learns(done.request):
                state = disk.state()
        _wait(disk, state)


def _wait(disk: _Disk, before: Hashable) -> None:
    """Return once the disk is another one."""
    spent = 0.0
    while True:
        PAUSE(max(INTERVAL, _SHARE * spent))
        began = time.perf_counter()
        if disk.state() != before:
            return
        spent = time.perf_counter() - began


class _Disk:
    """What lies on the disk that a check depends on, as far as the one before it says what that is."""

    def __init__(self, arguments: argparse.Namespace) -> None:
        self._paths: Sequence[str] = arguments.paths or ["."]
        self._settings = Settings()
        given = (*(arguments.launch or ())[:1], arguments.config, arguments.baseline, arguments.observed)
        self._given = [file for file in given if file is not None]

    def learns(self, request: Request) -> bool:
        """Whether a request is about something else than was thought."""
        known, self._paths, self._settings = (self._paths, self._settings), request.paths, request.settings
        return known != (self._paths, self._settings)

    def state(self) -> Hashable:
        baseline = self._settings.baseline
        return state_of(self._paths, self._settings, self._given if baseline is None else [*self._given, baseline])


def _refuse(arguments: argparse.Namespace) -> None:
    for name in _NOT_WATCHED:
        if getattr(arguments, name):
            option = "-o" if name == "file" else f"--{name.replace('_', '-')}"
            raise UsageError(f"--watch shows findings and does nothing else: leave out {option}")
    if not reports.FORMATS[arguments.format].arranged:
        raise UsageError(f"--watch shows text or concise, not {arguments.format}")
    if not sys.stdout.isatty():
        raise UsageError("--watch needs a terminal, and standard output is none: leave it out to check once")


__all__ = ["INTERVAL", "PAUSE", "watch"]

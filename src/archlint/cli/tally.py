"""What a run has done so far, counted, and what each part of it has cost."""

from __future__ import annotations

import os
from collections.abc import Callable

from archlint.monitor import Monitor


def processor_time() -> float:
    """The seconds of processor time of this process and of those that it has started and that have ended."""
    return sum(os.times()[:4])


class Tally(Monitor):
    """Counts.  ``changed`` is called with the tally whenever it has."""

    def __init__(self, clock: Callable[[], float] = processor_time) -> None:
        self.changed: Callable[[Tally], None] = _ignore
        self.files_done = self.files_all = 0
        self.programs_done = self.programs_all = 0
        self.parts_done = self.parts_all = 0
        self.systems_done = self.systems_all = 0
        self.files: dict[str, float] = {}
        """The seconds that each file took that was compiled."""
        self.programs: dict[str, tuple[str, float]] = {}
        """By their keys, the programs that were followed, and the seconds that each took."""
        self.links = False
        """Whether programs were looked at at all; they are not where the result of an earlier run holds."""
        self.seconds = 0.0
        """The processor time of the whole run, once it has ended."""
        self._known: set[str] = set()
        self._clock = clock
        self._began = clock()

    @property
    def kept(self) -> int:
        """How many programs an earlier run had followed."""
        return len(self._known.difference(self.programs))

    def end(self) -> None:
        """The run has ended."""
        self.seconds = self._clock() - self._began

    # --------------------------------------------------------------------------------------- what is reported

    def compiling(self, files: int) -> None:
        self.files_all += files
        self.changed(self)

    def compiled(self, file: str, seconds: float) -> None:
        self.files_done += 1
        self._add_file(file, seconds)
        self.changed(self)

    def following(self, programs: int) -> None:
        self.links = True
        self.programs_all += programs
        self.changed(self)

    def followed(self, key: str, program: str, seconds: float) -> None:
        self.programs_done += 1
        self._add_program(key, program, seconds)
        self.changed(self)

    def known(self, key: str) -> None:
        self.programs_done += 1
        self._known.add(key)
        self.changed(self)

    def judging(self, systems: int) -> None:
        self.systems_all += systems
        self.changed(self)

    def judged(self) -> None:
        self.systems_done += 1
        self.changed(self)

    def dividing(self, parts: int) -> None:
        self.parts_done, self.parts_all = 0, parts
        self.changed(self)

    def part_done(self) -> None:
        self.parts_done += 1
        self.changed(self)

    def divided(self) -> None:
        self.parts_done = self.parts_all = 0

    # ------------------------------------------------------------------------------------- other processes

    def begin_part(self) -> None:
        self.changed = _ignore  # the terminal belongs to the process that divides the work
        self.files, self.programs = {}, {}

    def end_part(self) -> bytes:
        import json  # only where work is divided

        return json.dumps([self.files, self.programs]).encode()

    def take(self, report: bytes) -> None:
        import json

        files, programs = json.loads(report)
        for file, seconds in files.items():
            self._add_file(file, seconds)
        for key, (program, seconds) in programs.items():
            self._add_program(key, program, seconds)

    def _add_file(self, file: str, seconds: float) -> None:
        self.files[file] = self.files.get(file, 0.0) + seconds

    def _add_program(self, key: str, program: str, seconds: float) -> None:
        _, before = self.programs.get(key, (program, 0.0))
        self.programs[key] = (program, before + seconds)


def _ignore(tally: Tally) -> None:
    """Nobody looks at it while the run goes on."""


__all__ = ["Tally", "processor_time"]

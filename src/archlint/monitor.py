"""Who follows the progress of a run, and what its parts cost.  Nothing that is kept or reported depends on it."""

from __future__ import annotations


class Monitor:
    """What a run reports while it goes on.  This monitor listens to nothing; one that does derives from it.

    All seconds are seconds of processor time, of whichever process did the work.
    """

    def compiling(self, files: int) -> None:
        """So many more files are to be compiled."""

    def compiled(self, file: str, seconds: float) -> None:
        """A file, by its shown path, has been compiled."""

    def following(self, programs: int) -> None:
        """So many more programs are to be followed, or taken from an earlier run."""

    def followed(self, key: str, program: str, seconds: float) -> None:
        """A program has been followed.  ``key`` sets it apart from the same program with other parameters."""

    def known(self, key: str) -> None:
        """What became of a program was known already: from an earlier run, or from a part that was done ahead."""

    def judging(self, systems: int) -> None:
        """So many more systems are to be judged."""

    def asking(self) -> None:
        """A rule is asked next."""

    def judged(self) -> None:
        """A system has been judged."""

    # ------------------------------------------------------------------ work that is done in several processes

    def dividing(self, parts: int) -> None:
        """The programs are now followed in so many parts, by processes of their own."""

    def part_done(self) -> None:
        """One of the parts has been done."""

    def divided(self) -> None:
        """All parts have been done."""

    def begin_part(self) -> None:
        """This process does one part of the work from here on."""

    def end_part(self) -> bytes:
        """What has been reported since the part began, for :meth:`take`."""
        return b""

    def take(self, report: bytes) -> None:
        """What was reported to another process."""


__all__ = ["Monitor"]

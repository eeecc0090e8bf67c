"""One finding for a line that was copied from launch file to launch file with the mistake in it."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Collection, Iterable, Sequence

from archlint.checks.folding import with_others
from archlint.finding import Finding, Place


def once_for_copied_lines(
    findings: Iterable[Finding], packaged: Collection[str], lines_of: Callable[[str, int, int], Sequence[str]]
) -> list[Finding]:
    """The findings with one for what a rule about launch files says of the very same lines of several, in the same
    words and with the same advice: who mends the first of them knows what to do with the others.  In the code of nodes
    what stands around a line counts as well.  ``packaged`` are the files of packages: the others are nobody's build.

    What one file shows several times is the same in another file in that order.
    """
    rows: dict[tuple[object, int], list[Finding]] = {}
    times: Counter[tuple[object, str]] = Counter()
    for number, finding in enumerate(sorted(findings, key=lambda finding: finding.sort_key)):
        place, is_judged = finding.place, finding.code.startswith("LCH") and finding.place.file in packaged
        lines = lines_at(place, lines_of) if is_judged else ()
        said = (finding.code, finding.severity, finding.message, finding.help, lines or number)
        times[said, place.file] += 1
        rows.setdefault((said, times[said, place.file]), []).append(finding)
    return [_of_copied_line(row) for row in rows.values()]


def lines_at(place: Place, lines_of: Callable[[str, int, int], Sequence[str]]) -> tuple[str, ...]:
    """The lines that a place is in, wherever they stand in their file."""
    return tuple(line.strip() for line in lines_of(place.file, place.line, place.end_line))


def _of_copied_line(row: Sequence[Finding]) -> Finding:
    if len(row) == 1:
        return row[0]
    return with_others(row, "another file has", "more files have", "the same", "the same here")


__all__ = ["lines_at", "once_for_copied_lines"]

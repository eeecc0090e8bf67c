"""Fixes: edits that mend a finding, made from the text of the file and applied all or not at all."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from archlint.faults import Faults
from archlint.fixes import names, timeouts
from archlint.fixes.source import Source, read

if TYPE_CHECKING:
    from archlint.finding import Finding, Fix

Builder = Callable[["Finding", Source, "Surroundings"], "Fix | None"]

_MOST_FILES = 1_000
"""How many files of a package are looked through for names in use."""

BUILDERS: dict[str, Builder] = {
    "NME001": lambda finding, _, around: names.declare_parameter(finding, around),
    "TMO001": lambda finding, source, _: timeouts.limit_wait(finding, source),
    "TMO002": lambda finding, source, around: timeouts.limit_call(finding, source, around.distros),
    "TMO003": lambda finding, source, _: timeouts.limit_spin(finding, source),
}
"""By the code of the rule; the fixes of LNT001 and PKG001 come with the findings."""


class Surroundings:
    """What a fix may need beside its finding: the texts of files, each read once, ``distros``, the ROS
    distributions that the code is for, and ``files``, the Python files of the workspace."""

    def __init__(self, distros: tuple[str, ...], files: Sequence[str] = ()) -> None:
        self.distros: tuple[str, ...] = distros
        self._files = files
        self._sources: dict[str, Source | None] = {}
        self._findings: dict[tuple[str, str], list[Finding]] = {}
        self._texts: dict[Path, dict[str, str]] = {}
        self.handed_over: set[str] = set()
        """Parameters that fixes declare on nodes of other files."""

    def keep(self, findings: Iterable[Finding]) -> None:
        """Take the findings of a run, of which a fix may mend several."""
        for one in findings:
            for file in sorted({one.place.file, *(related.place.file for related in one.related)}):
                self._findings.setdefault((one.code, file), []).append(one)

    def findings_like(self, finding: Finding, file: str) -> list[Finding]:
        """The other findings of the rule that are about a file."""
        return [one for one in self._findings.get((finding.code, file), []) if one is not finding]

    def source(self, file: str) -> Source | None:
        if file not in self._sources:
            self._sources[file] = read(file)
        return self._sources[file]

    def elsewhere(self, source: Source) -> str:
        """The text of the other Python files of a file's package, and the names that fixes bring into them."""
        file = Path(source.file).resolve()
        root = next((folder for folder in file.parents if (folder / "package.xml").is_file()), file.parent)
        if root not in self._texts:
            inside = sorted({path for path in (Path(one).resolve() for one in self._files) if root in path.parents})
            found = ((str(one), read(str(one))) for one in inside[:_MOST_FILES])
            self._texts[root] = {name: one.text for name, one in found if one is not None}
        taken = (name for other in self._sources.values() if other not in (None, source) for name in other.taken)
        return "\n".join((*(t for name, t in self._texts[root].items() if name != str(file)), *sorted(taken)))


def attach(findings: Iterable[Finding], around: Surroundings, faults: Faults | None = None) -> list[Finding]:
    """The findings, each with its fix where there is one.  Of a fix that fails to be made, ``faults`` are told."""
    found = list(findings)
    around.keep(found)
    faults = faults or Faults()
    for number, finding in enumerate(found):
        with faults.apart(f"making the fix of {finding.code}", finding.place):
            found[number] = _with_fix(finding, around)
    return found


def _with_fix(finding: Finding, around: Surroundings) -> Finding:
    builder = BUILDERS.get(finding.code)
    if builder is None or finding.fix is not None or not finding.mendable:
        return finding
    source = around.source(finding.place.file)
    fix = None if source is None else builder(finding, source, around)
    return finding if fix is None else replace(finding, fix=fix)

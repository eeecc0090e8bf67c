"""What a fix may need beside its finding."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from archlint.fixes.source import Source, read

if TYPE_CHECKING:
    from archlint.finding import Finding

_MOST_FILES = 1_000
"""How many files of a package are looked through for names in use."""


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

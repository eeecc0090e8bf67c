"""One finding for what copies of a package, of a file or of a function show."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import replace
from functools import cache
from typing import TYPE_CHECKING

from archlint.checks.folding import all_sites, with_others
from archlint.engine.repeats import lines_at
from archlint.finding import Finding, Related

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.workspace.model import Package


def once_for_copies(
    findings: Iterable[Finding], packages: Sequence[Package], lines_of: Callable[[str, int, int], Sequence[str]]
) -> list[Finding]:
    """The findings with one for what a file of a package and its twin in a copy of that package both show.

    Packages of one name need not be copies: what both show stands in the very same lines of code.
    """
    several = {name for name, count in Counter(package.name for package in packages).items() if count > 1}
    folders = {package.relative: package.name for package in packages if package.name in several}
    rows: dict[tuple[object, ...], list[Finding]] = {}
    for number, finding in enumerate(findings):
        folder = _innermost(folders, finding.place.file)
        twin: tuple[object, ...] = (number,)
        if folder is not None:
            twin = (folders[folder], finding.place.file[len(folder) :], lines_at(finding.place, lines_of))
        rows.setdefault((finding.code, finding.severity, finding.message, *twin), []).append(finding)
    shown = [finding for row in rows.values() for finding in _of_copies(row, folders)]
    return sorted(shown, key=lambda finding: finding.sort_key)


def once_for_twins(findings: Iterable[Finding], contents: Mapping[str, tuple[str, str]]) -> list[Finding]:
    """The findings with one for what files of a package with the very same content show, in the one with the shortest
    path; they come in the order of their places.  ``contents`` has the package of each file and a digest."""
    rows: dict[tuple[object, ...], list[Finding]] = {}
    for number, finding in enumerate(findings):
        place, content = finding.place, contents.get(finding.place.file)
        twin = (number,) if content is None else (content, place.line, place.column, finding.system)
        rows.setdefault((finding.code, finding.severity, finding.message, *twin), []).append(finding)
    shown = [_of_twins(row) for row in rows.values()]
    return sorted(shown, key=lambda finding: finding.sort_key)


def _of_twins(row: Sequence[Finding]) -> Finding:
    first, *others = sorted(row, key=lambda finding: (len(finding.place.file), finding.sort_key))
    if not others:
        return first
    twins = (Related(finding.place, "the same in a copy of this file") for finding in others)
    return replace(first, related=(*first.related, *twins), sites=all_sites([first, *others]))


_NUMBER = re.compile(r"\d+(?:\.\d+)?")
"""What the copies of a program that is there for each of several robots differ in, as a rule."""


def once_for_copied_code(
    findings: Iterable[Finding],
    package_of: Callable[[str], str | None],
    code_around: Callable[[Place], tuple[str, int] | None],
) -> list[Finding]:
    """The findings with one for what several files of a package show in the same function, but for numbers in it, in
    the one with the shortest path; they come in the order of their places.

    ``code_around`` gives the text of the function around a place and the line where it begins: of the file, where the
    place is in none; None for what cannot be read.
    """
    alike: dict[tuple[object, ...], list[Finding]] = {}
    once: dict[tuple[object, ...], Finding] = {}
    code_of = cache(code_around)
    for finding in sorted(findings, key=lambda finding: finding.sort_key):
        once.setdefault((finding.code, finding.place, finding.message), finding)  # two readers of a file may say it
    for finding in once.values():
        said, file = _NUMBER.sub("0", finding.message), finding.place.file
        alike.setdefault((finding.code, finding.severity, said, package_of(file) or file), []).append(finding)
    shown: list[Finding] = []
    for several in alike.values():
        if len({finding.place.file for finding in several}) == 1:
            shown += several
        else:
            shown += (_of_copied_code(row) for row in _by_code(several, code_of))
    shown = _with_loose_copies(shown, package_of, code_of)
    return sorted(shown, key=lambda finding: finding.sort_key)


def _with_loose_copies(
    findings: Sequence[Finding],
    package_of: Callable[[str], str | None],
    code_around: Callable[[Place], tuple[str, int] | None],
) -> list[Finding]:
    """The findings without those in a copy that lies outside of all packages: they are related to that of the same
    function in a package, which is what somebody builds."""
    loose = [finding for finding in findings if package_of(finding.place.file) is None]
    if not loose or len(loose) == len(findings):
        return [*findings]
    said = {(finding.code, finding.message) for finding in loose}
    originals: dict[tuple[object, ...], int] = {}
    shown = [finding for finding in findings if package_of(finding.place.file) is not None]
    for number, finding in enumerate(shown):
        if (finding.code, finding.message) in said:
            originals.setdefault((finding.code, finding.message, *_of_function(finding, code_around)), number)
    for copy in loose:
        number = originals.get((copy.code, copy.message, *_of_function(copy, code_around)), -1)
        if number < 0:
            shown.append(copy)
        else:
            told = Related(copy.place, "the same in a copy of this code")
            shown[number] = replace(shown[number], related=(*shown[number].related, told))
    return shown


def _of_function(finding: Finding, code_around: Callable[[Place], tuple[str, int] | None]) -> tuple[str, int]:
    """The text of the function that a finding is in, and its line there."""
    text, begin = code_around(finding.place) or ("", 0)
    return (text, finding.place.line - begin) if text else (finding.place.file, 0)


def _by_code(
    findings: Sequence[Finding], code_around: Callable[[Place], tuple[str, int] | None]
) -> Iterable[Sequence[Finding]]:
    """Findings by the line of their function, wherever that stands; what one file shows several times there is the
    same in another file in that order."""
    rows: dict[tuple[object, ...], list[Finding]] = {}
    times: Counter[tuple[object, ...]] = Counter()
    for finding in findings:
        text, begin = code_around(finding.place) or ("", 0)
        line = finding.place.line - begin
        code = (_up_to(_NUMBER.sub("0", text), line), line) if text else (finding.place.file, 0)
        times[code, finding.place.file] += 1
        rows.setdefault((code, times[code, finding.place.file]), []).append(finding)
    return rows.values()


_LONG = 40
"""Lines that nobody writes twice: what is the same for so long is copied, whatever was changed further down."""


def _up_to(text: str, line: int) -> str:
    """The text of a function as far as it says that a place in it is the same: up to its line, if that is far down."""
    return "\n".join(text.splitlines()[: line + 1]) if line >= _LONG else text


def _of_copied_code(row: Sequence[Finding]) -> Finding:
    if len(row) == 1:
        return row[0]
    ordered = sorted(row, key=lambda finding: (len(finding.place.file), finding.sort_key))
    return with_others(ordered, "another file has", "more files have", "the same", "the same in a copy of this code")


def _of_copies(row: Sequence[Finding], folders: Mapping[str, str]) -> Sequence[Finding]:
    """One finding for those of several copies; what one copy says several times stays."""
    first = row[0]
    if len({_innermost(folders, finding.place.file) for finding in row}) < len(row) or len(row) == 1:
        return row
    copies = (Related(finding.place, "the same in a copy of this package") for finding in row[1:])
    return [replace(first, related=(*first.related, *copies), sites=all_sites(row))]


def _innermost(folders: Mapping[str, str], file: str) -> str | None:
    """The package folder that a file is in, of those that have copies."""
    return max((folder for folder in folders if file.startswith(f"{folder}/")), key=len, default=None)

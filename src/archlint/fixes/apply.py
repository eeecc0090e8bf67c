"""Apply fixes: each whole or not at all, files replaced in one step."""

from __future__ import annotations

import ast
import difflib
import errno
import io
import os
from collections.abc import Callable, Collection, Iterable, Sequence
from dataclasses import field
from pathlib import Path
from typing import TYPE_CHECKING
from xml.parsers import expat

from archlint.disk import lies_in, replace_file
from archlint.fixes.source import Source, read
from archlint.records import dataclass
from archlint.syntax.safe_yaml import YamlError, YamlReader
from archlint.visible import visible

if TYPE_CHECKING:
    from archlint.finding import Finding, Fix

_Piece = tuple[int, int, str]


@dataclass
class Outcome:
    """New texts by file, with the sources they were made from, and the findings whose fixes they hold."""

    sources: dict[str, Source] = field(default_factory=dict)
    texts: dict[str, str] = field(default_factory=dict)
    fixed: list[Finding] = field(default_factory=list)


def fixable(findings: Iterable[Finding], unsafe: bool) -> list[Finding]:
    """The findings with a fix that may be applied."""
    return [finding for finding in findings if finding.fix is not None and (unsafe or finding.fix.safety == "safe")]


def apply(
    findings: Sequence[Finding],
    given: Callable[[str], bytes | None] = lambda file: None,
    inside: Collection[str] = (),
) -> Outcome:
    """Work the fixes of findings into the texts of their files; nothing is written.  ``given`` has the bytes of files
    that are not as on the disk; what lies, through links, outside of ``inside`` is left as it is.

    A fix that overlaps an earlier one waits for the next run.  One that leaves a file that does not parse is
    left out.
    """
    outcome = Outcome()
    pieces: dict[str, list[_Piece]] = {}
    for finding in findings:
        assert finding.fix is not None
        mine = all(lies_in(edit.place.file, inside) for edit in finding.fix.edits)
        new = _pieces(finding.fix, outcome, given) if mine else None
        if new is None or any(_overlaps(piece, pieces.get(file, [])) for file, piece in new):
            continue
        tried = {file: [*pieces.get(file, []), *(p for f, p in new if f == file)] for file, _ in new}
        if all(_parses(outcome.sources[file], _worked_in(outcome.sources[file], tried[file])) for file in tried):
            pieces.update(tried)
            outcome.fixed.append(finding)
    for file in pieces:
        outcome.texts[file] = _worked_in(outcome.sources[file], pieces[file])
    return outcome


def _pieces(fix: Fix, outcome: Outcome, given: Callable[[str], bytes | None]) -> list[tuple[str, _Piece]] | None:
    """Offsets and texts of a fix's edits; None where a file is not as the finding saw it."""
    pieces = []
    for edit in fix.edits:
        place = edit.place
        source = outcome.sources.get(place.file) or read(place.file, given(place.file))
        if source is None:
            return None
        outcome.sources[place.file] = source
        try:
            start, end = source.offset(place.line, place.column), source.offset(place.end_line, place.end_column)
        except ValueError:
            return None
        text = edit.text if "\r" in edit.text else edit.text.replace("\n", source.newline)
        pieces.append((place.file, (start, end, text)))
    return pieces


def _overlaps(piece: _Piece, others: Iterable[_Piece]) -> bool:
    """Whether two edits touch: insertions at one point do, but for whole lines, whose order is no matter."""
    start, end, text = piece
    for other_start, other_end, other_text in others:
        if start == end == other_start == other_end and _whole_lines(text) and _whole_lines(other_text):
            if text == other_text:
                return True
            continue
        if start <= other_end and other_start <= end:
            return True
    return False


def _whole_lines(text: str) -> bool:
    return text.endswith(("\r", "\n"))


def _worked_in(source: Source, pieces: Sequence[_Piece]) -> str:
    text = source.text
    for start, end, new in sorted(pieces, key=lambda piece: piece[:2], reverse=True):
        text = text[:start] + new + text[end:]
    return text


def _parses(source: Source, text: str) -> bool:
    """Whether a changed file can still be read by what reads it."""
    try:
        text.encode(source.encoding)
        if source.file.endswith((".xml", ".launch")):
            expat.ParserCreate().Parse(text, True)
        elif source.file.endswith((".yaml", ".yml")):
            YamlReader(text, several=True, rcl=True)
        else:
            ast.parse(text)
    except (SyntaxError, ValueError, RecursionError, MemoryError, expat.ExpatError, YamlError):
        return False
    return True


def write(outcome: Outcome) -> None:
    """Replace the files, each in one step and with its permissions; none where one is not to be written.

    Raises ``OSError``, with the file's name as it was given.
    """
    for file in sorted(outcome.texts):
        # A file can be replaced in a folder that allows it, whatever its own permissions say: they are asked first.
        if not os.access(file, os.W_OK) or not Path(file).stat().st_mode & 0o222:
            raise PermissionError(errno.EACCES, "the file is read-only", file)
    for file in sorted(outcome.texts):
        try:
            _replace(Path(file).resolve(), outcome.texts[file].encode(outcome.sources[file].encoding))
        except OSError as error:
            raise OSError(error.errno, error.strerror, file) from None


def _replace(target: Path, data: bytes) -> None:
    """``target`` is no symbolic link: one that leads to it stays as it is."""
    replace_file(target, data, target.stat())


def _lines(text: str) -> list[str]:
    """Lines as ``patch`` parts them, with their ends."""
    return list(io.StringIO(text, newline="\n"))


def unified_diff(outcome: Outcome) -> str:
    """What would be written, as a diff."""
    lines = []
    for file in sorted(outcome.texts):
        before, after, name = _lines(outcome.sources[file].text), _lines(outcome.texts[file]), visible(file)
        for line in difflib.unified_diff(before, after, name, name):
            lines.append(line if line.endswith("\n") else f"{line}\n\\ No newline at end of file\n")
    return "".join(lines)

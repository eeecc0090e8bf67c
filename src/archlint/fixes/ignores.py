"""``--add-ignores``: suppressions for what is there, written where they hold and change nothing of what a file says."""

from __future__ import annotations

import ast
import io
import re
import tokenize
from bisect import bisect_right
from collections.abc import Callable, Iterable, Mapping
from xml.parsers import expat

from archlint.fixes.apply import Outcome
from archlint.fixes.source import Source, read

_LISTED = re.compile(r"archlint:\s*ignore\[([^\]]*)\]")
"""The codes that a comment has already."""

Wanted = Mapping[str, Mapping[int, Iterable[str]]]
"""The codes to suppress, by file and line."""


def with_ignores(wanted: Wanted, reason: str, given: Callable[[str], bytes | None] = lambda file: None) -> Outcome:
    """New texts with a suppression for each code; a file that cannot have them stays as it is.  Nothing is written.
    ``given`` has the bytes of files that are not as on the disk."""
    outcome = Outcome()
    for file in sorted(wanted):
        source = read(file, given(file))
        text = None if source is None else _text(source, wanted[file], reason)
        if source is not None and text is not None and text != source.text:
            outcome.sources[file] = source
            outcome.texts[file] = text
    return outcome


def _text(source: Source, wanted: Mapping[int, Iterable[str]], reason: str) -> str | None:
    """The text of a file with its suppressions; None where they cannot be written."""
    change, meaning = _kind(source)
    lines = source.text.splitlines(keepends=True)
    if len(lines) < max(wanted) or len(lines) > len(source.starts):
        return None  # a line end that only Python's own functions know
    try:
        before = meaning(source.text)
        change(source, lines, wanted, f" {reason}" if reason else "")
        text = "".join(lines)
        return text if meaning(text) == before else None
    except (SyntaxError, ValueError, RecursionError, MemoryError, tokenize.TokenError, expat.ExpatError):
        return None


_Change = Callable[[Source, list[str], Mapping[int, Iterable[str]], str], None]


def _kind(source: Source) -> tuple[_Change, Callable[[str], object]]:
    """How suppressions come into a kind of file, and what must stay as it is."""
    if source.file.endswith((".xml", ".launch")):
        return _in_xml, _elements
    if source.file.endswith((".yaml", ".yml")):
        return _in_yaml, _events
    return _in_python, lambda text: ast.dump(ast.parse(text))


def _in_python(source: Source, lines: list[str], wanted: Mapping[int, Iterable[str]], reason: str) -> None:
    """At the end of the line, or of the statement where the line ends in a text or with a backslash."""
    ends = _line_ends(source.text)
    by_line: dict[int, set[str]] = {}
    for line, codes in wanted.items():
        by_line.setdefault(next(end for end in ends if end >= line), set()).update(codes)
    for line, codes in by_line.items():
        lines[line - 1] = _with_comment(lines[line - 1], codes, reason)


def _line_ends(text: str) -> list[int]:
    """The lines behind which a comment may stand."""
    tokens = tokenize.generate_tokens(io.StringIO(text, newline="").readline)
    return [token.start[0] for token in tokens if token.type in (tokenize.NEWLINE, tokenize.NL)]


def _in_yaml(source: Source, lines: list[str], wanted: Mapping[int, Iterable[str]], reason: str) -> None:
    """At the end of the line."""
    for line, codes in wanted.items():
        lines[line - 1] = _with_comment(lines[line - 1], codes, reason)


def _with_comment(line: str, codes: Iterable[str], reason: str) -> str:
    text = line.rstrip()
    end = line[len(line.rstrip("\r\n")) :]
    listed = _with_codes(text, codes)
    return (listed or f"{text}  # archlint: ignore[{', '.join(sorted(codes))}]{reason}") + end


def _with_codes(text: str, codes: Iterable[str]) -> str | None:
    """A line with more codes in the suppression that it has; None where it has none."""
    match = _LISTED.search(text)
    if match is None:
        return None
    known = [code for code in map(str.strip, match[1].split(",")) if code]
    listed = ", ".join(dict.fromkeys([*known, *sorted(codes)]))
    return f"{text[: match.start(1)]}{listed}{text[match.end(1) :]}"


def _in_xml(source: Source, lines: list[str], wanted: Mapping[int, Iterable[str]], reason: str) -> None:
    """On a line of its own above the element, or directly in front of an element that shares its line."""
    starts = _element_starts(source.text)
    by_start: dict[tuple[int, int], set[str]] = {}
    for line, codes in wanted.items():
        start = starts[max(bisect_right(starts, (line, len(source.text))) - 1, 0)]
        by_start.setdefault(start, set()).update(codes)
    for (line, column), codes in sorted(by_start.items(), reverse=True):
        text = lines[line - 1]
        before, above = text[:column], lines[line - 2].rstrip("\r\n") if line > 1 else ""
        comment = f"<!-- archlint: ignore[{', '.join(sorted(codes))}]{reason.replace('--', '- -')} -->"
        extended = _with_codes(above, codes) if above.strip().startswith("<!--") and not before.strip() else None
        if extended is not None:
            lines[line - 2] = extended + lines[line - 2][len(above) :]
        elif before.strip():
            lines[line - 1] = f"{before}{comment}{text[column:]}"
        else:
            lines[line - 1] = f"{before}{comment}{source.newline}{text}"


def _element_starts(text: str) -> list[tuple[int, int]]:
    """Line, from 1, and column, from 0, of each start tag, in order."""
    starts: list[tuple[int, int]] = []
    parser = expat.ParserCreate()
    parser.StartElementHandler = lambda *_: starts.append((parser.CurrentLineNumber, parser.CurrentColumnNumber))
    parser.Parse(text, True)
    return starts


def _elements(text: str) -> list[object]:
    """What an XML file says, without comments and the blanks around them."""
    said: list[object] = []
    parser = expat.ParserCreate()
    parser.buffer_text = True
    parser.ordered_attributes = True
    parser.StartElementHandler = lambda *element: said.append(element)
    parser.EndElementHandler = said.append
    parser.CharacterDataHandler = lambda data: said.extend(data.split())
    parser.Parse(text, True)
    return said


def _events(text: str) -> list[tuple[object, ...]]:
    """What a YAML file says, aliases not followed.  Raises ``ValueError``."""
    import yaml

    try:
        events = list(yaml.parse(text, Loader=yaml.SafeLoader))
    except yaml.YAMLError as error:
        raise ValueError(str(error)) from None
    return [(type(event), *(getattr(event, name, None) for name in ("anchor", "tag", "value"))) for event in events]


__all__ = ["Wanted", "with_ignores"]

"""``console_scripts`` and data files of setup.cfg, and ``[project.scripts]`` of pyproject.toml, with their places."""

from __future__ import annotations

import configparser
import importlib
import re
import sys
from collections.abc import Iterable, Iterator
from dataclasses import replace

from archlint.records import dataclass

_TARGET = re.compile(r"(?P<module>[\w.]+)(?:\s*:\s*(?P<function>[\w.]+))?(?:\s*\[.*\])?")
_COMMENT = re.compile(r"(?:^|\s)#.*$", re.DOTALL)


@dataclass(frozen=True)
class ScriptEntry:
    """``name = module:function`` at a line and column from 1.  What is ``wrong`` with one that is not of that form
    is said in words; then it is read as it was meant, ``module`` None where that is not known."""

    name: str
    module: str | None
    function: str | None
    line: int = 1
    column: int = 1
    end_column: int = 1
    wrong: str = ""


def parse_entry(text: str) -> ScriptEntry | None:
    """The entry that a text stands for; None for a blank one.  A comment at its end is left out."""
    text = _COMMENT.sub("", text)
    if not text.strip():
        return None
    entry = _well_formed(text)
    if entry is not None:
        return entry
    for meant, wrong in (
        (text.replace("==", "=", 1), "it has '==' instead of '='"),
        (text.rstrip().rstrip(",;"), f"it ends in '{text.rstrip()[-1]}'"),
    ):
        entry = _well_formed(meant) if meant != text else None
        if entry is not None:
            return replace(entry, wrong=wrong)
    name = text.partition("=")[0].strip()
    return ScriptEntry(name or text.strip(), None, None, wrong="it is not 'name = package.module:function'")


def _well_formed(text: str) -> ScriptEntry | None:
    """The entry that a text of the right form is."""
    name, _, target = text.partition("=")
    match = _TARGET.fullmatch(target.strip())
    return None if match is None or not name.strip() else ScriptEntry(name.strip(), match["module"], match["function"])


def entries_of_setup_cfg(text: str) -> list[ScriptEntry]:
    """``[options.entry_points] console_scripts``; nothing for a file that cannot be parsed."""
    parser = configparser.RawConfigParser(strict=False)
    try:
        parser.read_string(text)
        value = parser.get("options.entry_points", "console_scripts", fallback="")
    except configparser.Error:
        return []
    return list(_placed(text, value.splitlines()))


class _CaseKept(configparser.RawConfigParser):
    """A parser that does not write the names of options small: here they are folders."""

    def optionxform(self, optionstr: str) -> str:
        return optionstr


@dataclass(frozen=True)
class DataFile:
    """A file, or a pattern for files, of ``[options.data_files]``, and the line that names it."""

    destination: str
    source: str
    line: int


def data_files_of_setup_cfg(text: str) -> list[DataFile]:
    """``[options.data_files]``: lists of files by the folder that they go to; nothing for a file that cannot be parsed.

    Source: ``setuptools/config/setupcfg.py``, ``parse_section_data_files``.
    """
    parser = _CaseKept(strict=False)
    try:
        parser.read_string(text)
    except configparser.Error:
        return []
    if not parser.has_section(DATA_FILES):
        return []
    lines = text.splitlines()
    header = next((number for number, line in enumerate(lines, 1) if line.startswith(f"[{DATA_FILES}]")), 1)
    below = list(enumerate(lines[header:], header + 1))
    numbers = {line.rpartition("=")[2].strip(): number for number, line in reversed(below)}
    rows = []
    for destination, value in parser.items(DATA_FILES):
        sources = value.splitlines() if "\n" in value else value.split(",")
        for source in filter(None, map(str.strip, sources)):
            rows.append(DataFile(destination, source, numbers.get(source, header)))
    return rows


DATA_FILES = "options.data_files"
"""The section of a setup.cfg that lists the data files."""


def entries_of_pyproject(text: str) -> list[ScriptEntry]:
    """``[project.scripts]``; nothing for a file that is no TOML."""
    toml = importlib.import_module("tomllib" if sys.version_info >= (3, 11) else "tomli")
    try:
        document = toml.loads(text)
        scripts = document.get("project", {}).get("scripts", {})
        rows = [f"{name} = {target}" for name, target in scripts.items() if isinstance(target, str)]
    except (ValueError, AttributeError, RecursionError):
        return []
    return list(_placed(text, rows))


_ALIKE = 100
"""How many lines that begin with one name are looked at for the entry of that name."""


def _name_in(line: str) -> str:
    """What stands before the ``=`` of a line, without quotes."""
    name = line.partition("=")[0].strip(" \t")
    name = name[1:] if name[:1] in ("'", '"') else name
    return name[:-1] if name[-1:] in ("'", '"') else name


def _placed(text: str, rows: Iterable[str]) -> Iterator[ScriptEntry]:
    """The entries of a file's rows, each with the place of the line that says so."""
    lines: dict[str, list[tuple[int, str]]] = {}
    for number, line in enumerate(text.splitlines(), start=1):
        lines.setdefault(_name_in(line), []).append((number, line))
    for entry in filter(None, map(parse_entry, rows)):
        for number, line in lines.get(entry.name, [])[:_ALIKE]:
            _, equals, behind = line.partition("=")
            if not equals or (entry.module or "") in behind:
                start = len(line) - len(line.lstrip())
                yield replace(entry, line=number, column=start + 1, end_column=len(line.rstrip()) + 1)
                break
        else:
            yield entry

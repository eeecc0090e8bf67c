"""``console_scripts`` of setup.cfg and ``[project.scripts]`` of pyproject.toml, with their places."""

from __future__ import annotations

import configparser
import importlib
import re
import sys
from dataclasses import dataclass

_ENTRY = re.compile(
    r"^\s*(?P<name>[^=\s]+)\s*=\s*(?P<module>[\w.]+)\s*(?::\s*(?P<function>[\w.]+))?\s*(?:\[.*\])?\s*$"
)


@dataclass(frozen=True)
class ScriptEntry:
    """``name = module:function`` at a line and column from 1; ``wrong`` where it is not of that form."""

    name: str
    module: str
    function: str | None
    line: int = 1
    column: int = 1
    end_column: int = 1


def parse_entry(text: str) -> tuple[str, str, str | None] | None:
    """``(name, module, function)`` of ``name = module:function``; None for anything else."""
    match = _ENTRY.match(text)
    return None if match is None else (match["name"], match["module"], match["function"])


def entries_of_setup_cfg(text: str) -> list[ScriptEntry]:
    """``[options.entry_points] console_scripts``; nothing for a file that cannot be parsed."""
    parser = configparser.RawConfigParser(strict=False)
    try:
        parser.read_string(text)
        value = parser.get("options.entry_points", "console_scripts", fallback="")
    except configparser.Error:
        return []
    return [_placed(text, row) for row in value.splitlines() if parse_entry(row)]


def entries_of_pyproject(text: str) -> list[ScriptEntry]:
    """``[project.scripts]``; nothing for a file that is no TOML."""
    toml = importlib.import_module("tomllib" if sys.version_info >= (3, 11) else "tomli")
    try:
        document = toml.loads(text)
        scripts = document.get("project", {}).get("scripts", {})
        rows = [f"{name} = {target}" for name, target in scripts.items()]
    except (ValueError, AttributeError, RecursionError):
        return []
    return [_placed(text, row) for row in rows if parse_entry(row)]


def _placed(text: str, row: str) -> ScriptEntry:
    parsed = parse_entry(row)
    assert parsed is not None
    name, module, function = parsed
    pattern = re.compile(rf"^[ \t]*[\"']?{re.escape(name)}[\"']?[ \t]*=.*{re.escape(module)}.*$")
    for number, line in enumerate(text.splitlines(), start=1):
        if pattern.match(line):
            start = len(line) - len(line.lstrip())
            return ScriptEntry(name, module, function, number, start + 1, len(line.rstrip()) + 1)
    return ScriptEntry(name, module, function)

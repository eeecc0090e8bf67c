"""PKG001: name a dependency in ``package.xml``."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from archlint.finding import Edit, Fix

if TYPE_CHECKING:
    from archlint.finding import Finding
    from archlint.fixes.source import Source

_COMMENT = re.compile(r"<!--.*?-->", re.DOTALL)
_BEFORE = (
    r"exec_depend",
    r"depend",
    r"(?:build|buildtool|build_export|buildtool_export)_depend",
    r"(?:license|url|author|maintainer)",
)
"""After the last of which elements the line goes: the first of these that the manifest has."""


def add_dependency(finding: Finding, manifest: Source | None) -> Fix | None:
    """Add ``<exec_depend>`` on a line of its own, indented as its neighbours; ``identity`` ends in the package."""
    if manifest is None:
        return None
    # A comment may hold elements that do not count.
    text = _COMMENT.sub(lambda match: " " * len(match[0]), manifest.text)
    for tag in _BEFORE:
        found = list(re.finditer(rf"^([ \t]*)<{tag}\b[^>]*>[^<]*</{tag}>[ \t]*$", text, re.MULTILINE | re.ASCII))
        if found:
            last = found[-1]
            line = f"{manifest.newline}{last[1]}<exec_depend>{finding.identity[-1]}</exec_depend>"
            end = len(last[0].rstrip("\r")) + last.start()
            edit = Edit(manifest.place(end, end), line)
            return Fix("safe", (edit,), f"declare the dependency on {finding.identity[-1]}")
    return None

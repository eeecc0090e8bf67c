"""PKG001: declare packages in a package.xml."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from archlint.finding import Edit, Fix
from archlint.place import Place
from archlint.workspace.comments import replace_xml_comments

if TYPE_CHECKING:
    from archlint.edit_sites import MissingDependencies
    from archlint.fixes.source import Source

_DEPEND = re.compile(r"\s*<(?:exec_|run_|build_export_|buildtool_|build_|)depend\b.*</\w*depend>\s*$")
_ABOUT = re.compile(r"\s*<(?:maintainer|license|url|author)\b.*</(?:maintainer|license|url|author)>\s*$")


def declared(missing: MissingDependencies, manifest: Source) -> Fix | None:
    """A line for each package; None where the manifest has no lines like these to put them after."""
    free = free_line(manifest)
    if free is None:
        return None
    line, indent = free
    lines = "".join(f"{indent}<{missing.tag}>{name}</{missing.tag}>\n" for name in missing.packages)
    edit = Edit(Place(manifest.file, line, 1, line, 1), lines)
    return Fix("safe", (edit,), f"declare {', '.join(missing.packages)}")


def free_line(manifest: Source) -> tuple[int, str] | None:
    """Where the next dependency for run time goes, and what the lines there are indented with: after the last of their
    kind, or where the first would stand."""
    lines = manifest.lines
    in_force = replace_xml_comments("\n".join(lines), lambda comment: "\n" * comment.count("\n")).split("\n")
    after = [number for number, line in enumerate(in_force, start=1) if _DEPEND.match(line)]
    after = after or [number for number, line in enumerate(in_force, start=1) if _ABOUT.match(line)]
    if not after:
        return None
    line = lines[after[-1] - 1]
    return after[-1] + 1, line[: -len(line.lstrip())]

"""PKG004: headers that other packages include and that no build installs."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.checks.registry import finding
from archlint.finding import Finding, Related
from archlint.packaging.uninstalled_headers import HeaderLeftOut, headers_left_out

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex

_SHOWN = 5
"""How many includes are related."""


def of_left_out_headers(workspace: WorkspaceIndex) -> Iterator[Finding]:
    """One finding for each package that leaves out headers."""
    by_package: dict[tuple[str, bool], list[HeaderLeftOut]] = {}
    for row in headers_left_out(workspace):
        by_package.setdefault((row.package, row.installed), []).append(row)
    for (package, installed), rows in by_package.items():
        [first, *_] = rows
        files = list(dict.fromkeys(row.file for row in rows))
        more = f" and {len(files) - 1} more" if len(files) > 1 else ""
        top = first.file.partition("/")[0]
        line = f"install(DIRECTORY {top}/ DESTINATION include)"
        yield finding(
            "PKG004",
            first.place,
            f"package '{package}' {'installs' if installed else 'does not install'} the header '{first.file}'{more}, "
            f"which {first.included_at.file} includes"
            + (", and does not export its folder" if installed else "")
            + ": its build does not find it",
            help="add ament_export_include_directories() with the folder that it is installed in"
            if installed
            else f"add {line}"
            if top == "include"
            else f"install {posixpath.dirname(first.file)} as include/{package}, install(DIRECTORY …)",
            related=[Related(row.included_at, f"'{row.file}' is included here") for row in rows[:_SHOWN]],
            identity=(package, "headers", *files),
        )


__all__ = ["of_left_out_headers"]

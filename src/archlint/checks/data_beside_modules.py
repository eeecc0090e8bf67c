"""PKG004: files that an installed module looks for beside itself, where no build puts them."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.checks.registry import finding
from archlint.finding import Finding, Related
from archlint.packaging.data_beside_code import DataBeside, data_beside_code

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex

_SHOWN = 5
"""How many places that look for something are related."""


def of_data_beside_modules(workspace: WorkspaceIndex) -> Iterator[Finding]:
    """One finding for each module."""
    by_module: dict[tuple[str, str], list[DataBeside]] = {}
    for row in data_beside_code(workspace):
        by_module.setdefault((row.package, row.module), []).append(row)
    for (package, module), named in by_module.items():
        rows = [row for row in named if not any(other.file.startswith(f"{row.file}/") for other in named)]
        [first, *_] = rows
        files = list(dict.fromkeys(row.file for row in rows))
        kind = "folder" if first.folder else "file"
        more = f" and {len(files) - 1} more" if len(files) > 1 else ""
        yield finding(
            "PKG004",
            first.place,
            f"{module} looks for the {kind} '{first.file}'{more} by a path from its own file on, where a build without "
            "--symlink-install puts Python code alone",
            help=f"install it with data_files=, and look in get_package_share_directory('{package}')",
            related=[Related(row.place, f"'{row.file}' is named here") for row in rows[1:_SHOWN]],
            identity=(package, module, *files),
        )


__all__ = ["of_data_beside_modules"]

"""PKG004: what a CMakeLists.txt builds or has and does not install, though what it installs needs it."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.checks.registry import finding
from archlint.finding import Finding, Related
from archlint.packaging.left_out_packages import LeftOutPackage, packages_of_scripts
from archlint.packaging.uninstalled_files import understood

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex
    from archlint.workspace.installed import LeftLibrary

_SHOWN = 5
"""How many imports are related."""


def left_out_by_cmake(workspace: WorkspaceIndex) -> Iterator[Finding]:
    """Shared libraries of installed programs, and Python packages of installed scripts and launch files."""
    for package, installs in understood(workspace).items():
        manifest = workspace.packages.get(package)
        if manifest is not None and manifest.build_type == "ament_cmake":
            yield from (_library(package, row) for row in installs.left_libraries)
    by_folder: dict[str, list[LeftOutPackage]] = {}
    for row in packages_of_scripts(workspace):
        by_folder.setdefault(row.folder, []).append(row)
    for rows in by_folder.values():
        scripts = [row for row in rows if row.script is not None]
        yield _package(scripts or rows)


def _library(package: str, row: LeftLibrary) -> Finding:
    return finding(
        "PKG004",
        row.place,
        f"the shared library '{row.name}' is not installed, and '{row.needed_by}' needs it: that does not start",
        help=f"add install(TARGETS {row.name} DESTINATION lib)",
        identity=(package, "library", row.name),
        group=(row.place.file, "library", row.name),
    )


def _package(rows: list[LeftOutPackage]) -> Finding:
    [first, *others] = rows
    kind = "launch file" if first.script is None else "script"
    user = first.needed_at.file if first.script is None else f"the installed script '{first.script.name}'"
    more = f" and {len(others)} more {kind}{'s' * (len(others) > 1)}" if others else ""
    imports = "import" if others else "imports"
    place = first.needed_at if first.script is None else first.script.place
    what = f"'{first.name}', a folder that nothing installs where Python looks: the import fails"
    help = f"find ament_cmake_python, and write ament_python_install_package({first.name})"
    if first.module:
        what = f"'{first.module}', which nothing installs where Python looks: the package '{first.name}' that it finds "
        what += "has the interfaces alone, and the import fails"
        help = (
            f"rename the folder '{first.name}', also where it is imported, for rosidl_generate_interfaces() installs a "
        )
        help += "package of this name; then install it with ament_python_install_package()"
    return finding(
        "PKG004",
        place,
        f"{user}{more} {imports} {what}",
        help=help,
        related=[Related(row.needed_at, f"'{row.name}' is imported here") for row in rows[:_SHOWN]],
        identity=(first.package, "package", first.name),
        group=(place.file, "package", first.name),
    )


__all__ = ["left_out_by_cmake"]

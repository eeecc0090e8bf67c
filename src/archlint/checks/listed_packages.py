"""PKG004: Python packages that a setup.py lists and that are not there, so that the build stops.

Source: ``build_py.check_package`` of setuptools raises "package directory … does not exist".
"""

from __future__ import annotations

import posixpath
from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING

from archlint.checks.registry import finding
from archlint.finding import Finding
from archlint.packaging.generated_files import is_ignored, submodule_around
from archlint.packaging.modules_meant import is_called_in_its_code, target_meant
from archlint.packaging.python_folders import only_python_folder
from archlint.packaging.uninstalled_files import understood
from archlint.suggestions import meant, nearest

if TYPE_CHECKING:
    from archlint.packaging.left_out_code import LeftOut
    from archlint.systems.model import WorkspaceIndex


def _names(workspace: WorkspaceIndex, rows: Sequence[LeftOut]) -> Sequence[str]:
    """The packages of Python that files which are left out lie in."""
    names = {path: name for row in rows for name, path in workspace.code.modules_of(row.package).items()}
    return [*dict.fromkeys(names[row.file].rpartition(".")[0] for row in rows if row.file in names)]


def packages_in_vain(workspace: WorkspaceIndex) -> Mapping[str, Sequence[str]]:
    """The packages of Python without a folder that the ``packages=`` of each ROS package lists."""
    rows = {}
    for name, installs in understood(workspace).items():
        code = installs.python
        listed = () if code is None else code.listed_in_vain
        paths = {row: posixpath.normpath(posixpath.join(installs.folder, row.replace(".", "/"))) for row in listed}
        certain = [
            row
            for row, path in paths.items()
            if not is_ignored(workspace, path) and submodule_around(workspace, path) is None
        ]
        if certain:
            rows[name] = certain
    return rows


def of_packages_in_vain(workspace: WorkspaceIndex, left_out: Mapping[str, Sequence[LeftOut]]) -> Iterator[Finding]:
    """One finding for each such setup.py; ``left_out`` is the code that it does not install and that programs need."""
    for package, listed in packages_in_vain(workspace).items():
        code = workspace.installs[package].python
        assert code is not None  # or nothing would be listed in vain
        [first, *others] = listed
        own = sorted({name.rpartition(".")[0] for name in workspace.code.modules_of(package)} - {""})
        needed = _names(workspace, left_out.get(package, ()))
        right = None if others else needed[0] if len(needed) == 1 else nearest(first, own)
        if right is None and not others and not any(map(code.has, workspace.code.modules_of(package).values())):
            right = only_python_folder(workspace, workspace.installs[package].folder)
        right = right or (None if others else _folder_of_entries(workspace, package, first))
        more = f", and {len(others)} more" if others else ""
        help = f"write '{right}'" if right else "take it off the list" if not others else "take them off the list"
        if right and _is_called_so(workspace, package, right, first):
            help = f"rename the folder '{right}' to '{first}', as which the code of the package calls it"
        yield finding(
            "PKG004",
            code.place,
            f"packages= lists '{first}'{more}, without a folder: the build stops at '{first.replace('.', '/')}'"
            + (meant(f"'{right}'") if right else ""),
            help=help,
            identity=(package, "packages", *listed),
            meant=right or "",
        )


def _folder_of_entries(workspace: WorkspaceIndex, package: str, name: str) -> str | None:
    """The one folder in which the modules lie that entries with the name of a missing one mean."""
    entries = workspace.installs[package].executables.values()
    there = [target_meant(workspace, each) for each in entries if (each.module or "").partition(".")[0] == name]
    tops = {row.named.partition(".")[0] for row in there if row is not None}
    return tops.pop() if len(tops) == 1 else None


def _is_called_so(workspace: WorkspaceIndex, package: str, folder: str, name: str) -> bool:
    """Whether the entries of a package, or the modules of the folder themselves, call a folder by another name."""
    entries = workspace.installs[package].executables.values()
    tops = {(entry.module or "").partition(".")[0] for entry in entries}
    if folder in tops or "." in folder or "." in name:
        return False
    return name in tops or is_called_in_its_code(workspace, package, folder, name)


__all__ = ["of_packages_in_vain", "packages_in_vain"]

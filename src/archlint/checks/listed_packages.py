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
        more = f", and {len(others)} more" if others else ""
        yield finding(
            "PKG004",
            code.place,
            f"packages= lists '{first}'{more}, without a folder: the build stops at '{first.replace('.', '/')}'"
            + (meant(f"'{right}'") if right else ""),
            help=f"write '{right}'" if right else "take it off the list" if not others else "take them off the list",
            identity=(package, "packages", *listed),
            meant=right or "",
        )


__all__ = ["of_packages_in_vain", "packages_in_vain"]

"""Workspaces side by side: packages of one name cannot be built together, so here are two systems and not one.

The weeks of a course, a copy under ``old``, a second workspace for a bridge: each is judged by itself, with the
packages that no other one has a copy of.
"""

from __future__ import annotations

import os
from collections import Counter
from collections.abc import Collection, Iterable, Sequence
from dataclasses import replace

from archlint.workspace.model import Package, SourceFile, Workspace


def parts(workspace: Workspace) -> list[Workspace]:
    """The workspace split until no package name comes twice; itself where none does.

    What several parts share is asked for in the first and context in the others.
    """
    if _unique(workspace.packages):
        return [workspace]
    top = os.path.commonpath([package.root for package in workspace.packages])
    units = _units(top, workspace.packages)
    homes = {file.path: _homes(file, units) for file in workspace.files}
    return [_part(workspace, number, packages, homes) for number, packages in enumerate(units)]


def _part(workspace: Workspace, number: int, packages: Sequence[Package], homes: dict[str, list[int]]) -> Workspace:
    files = [file for file in workspace.files if number in homes[file.path]]
    kept = [file if homes[file.path][0] == number else replace(file, context=True) for file in files]
    problems = workspace.problems if number == 0 else ()
    own = {package.root for package in packages}
    return replace(
        workspace,
        files=tuple(kept),
        packages=_sorted(packages),
        problems=problems,
        beside=tuple(package.relative for package in workspace.packages if package.root not in own),
    )


def _sorted(packages: Iterable[Package]) -> tuple[Package, ...]:
    return tuple(sorted(packages, key=lambda package: (package.name, package.relative)))


def _unique(packages: Collection[Package]) -> bool:
    return len({package.name for package in packages}) == len(packages)


def _units(folder: str, packages: Sequence[Package]) -> list[list[Package]]:
    """Packages below a folder in groups without a name twice; what clashes with nothing is in each group.

    Packages that lie directly in the folder belong together.
    """
    if _unique(packages):
        return [list(packages)]
    direct = [package for package in packages if os.path.dirname(package.root) == folder]
    packagess = [direct] if _unique(direct) else [[package] for package in direct]
    below: dict[str, list[Package]] = {}
    for package in packages:
        if package not in direct:
            below.setdefault(_child(folder, package.root), []).append(package)
    for child in sorted(below):
        packagess += _units(child, below[child])
    owners = Counter(name for unit in packagess for name in {package.name for package in unit})
    clashing = [unit for unit in packagess if any(owners[package.name] > 1 for package in unit)]
    shared = [package for unit in packagess if unit not in clashing for package in unit]
    return [[*unit, *shared] for unit in clashing]


def _child(folder: str, path: str) -> str:
    """The folder in ``folder`` that a path leads through."""
    return os.path.join(folder, os.path.relpath(path, folder).split(os.sep)[0])


def _homes(file: SourceFile, units: Sequence[Sequence[Package]]) -> list[int]:
    """The numbers of the parts that a file is in; without a package, that of the nearest part."""
    owners = [number for number, unit in enumerate(units) if any(_is_in(file.path, package.root) for package in unit)]
    if owners:
        return owners
    return [max(range(len(units)), key=lambda number: (_nearness(file, units[number]), -number))]


def _nearness(file: SourceFile, packages: Iterable[Package]) -> int:
    """How many folders a file shares with the nearest of some packages."""
    return max(len(os.path.commonpath([file.path, package.root])) for package in packages)


def _is_in(path: str, folder: str) -> bool:
    return path.startswith(folder.rstrip(os.sep) + os.sep)

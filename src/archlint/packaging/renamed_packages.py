"""Imports of the workspace's own modules by the name that their package no longer has."""

from __future__ import annotations

import posixpath
import re
import sys
from collections.abc import Sequence
from typing import TYPE_CHECKING

from archlint.analysis.kept import kept, once
from archlint.packaging.absent_packages import is_nowhere
from archlint.python_code.offered_names import offers
from archlint.ros.python_modules import is_known
from archlint.syntax import facts
from archlint.syntax.parts import everything_in

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex
    from archlint.workspace.model import SourceFile

_REQUIREMENTS = re.compile(r"requirements[^/]*\.txt|pyproject\.toml|setup\.(?:py|cfg)|environment\.ya?ml|Dockerfile")
"""Where a project names the Python packages that it wants from elsewhere."""


def present_name(workspace: WorkspaceIndex, file: SourceFile, module: str, names: Sequence[str]) -> str | None:
    """The name that a module has now in the package of a file: ``robot.camera`` for ``robot_old.camera``, where nobody
    knows a ``robot_old``, and ``robot.camera`` defines all names that the file imports."""
    top, _, rest = module.partition(".")
    own = (file.module or "").partition(".")[0]
    if not rest or not names or not own or own == top or not is_unknown(workspace, file, module):
        return None
    present = f"{own}.{rest}"
    path = workspace.code.file_of_import(file.relative, present)
    if path is None or path == file.relative or present not in workspace.code.modules:
        return None
    there = all(offers(workspace, path, name) or f"{present}.{name}" in workspace.code.modules for name in names)
    return present if there and _is_own(workspace, top, own) else None


def _is_own(workspace: WorkspaceIndex, top: str, own: str) -> bool:
    """Whether all that anybody imports of a package lies in one of the workspace: else it is another one, of which that
    may be a copy."""
    imported = modules_imported(workspace).get(top, ())
    return all(f"{own}{module.removeprefix(top)}" in workspace.code.modules for module in imported)


@once
def modules_imported(workspace: WorkspaceIndex) -> dict[str, set[str]]:
    """By package, all modules of it that code of the workspace imports, or imports names from; where it is the package
    itself, each name with it."""
    modules: dict[str, set[str]] = {}
    for _, code in workspace.code.asked_for():
        for plain in everything_in(code.body, facts.Import):
            modules.setdefault(plain.module.partition(".")[0], set()).add(plain.module)
        for statement in everything_in(code.body, facts.ImportFrom):
            top, _, rest = statement.module.partition(".")
            if statement.level == 0:
                names = [statement.module] if rest else [f"{top}.{name}" for name, _ in statement.names]
                modules.setdefault(top, set()).update(names)
    return modules


def is_unknown(workspace: WorkspaceIndex, file: SourceFile, module: str) -> bool:
    """Whether nothing in the workspace, and nothing that is known of elsewhere, has the name of a package."""
    there = workspace.code.path_of_import(file.relative, module) is not None
    return not there and is_no_package(workspace, module.partition(".")[0])


def is_no_package(workspace: WorkspaceIndex, top: str) -> bool:
    """Whether a top-level name is that of no module or package of the workspace, and of none that is known or wanted
    from elsewhere."""
    return kept(workspace, (is_no_package, top), lambda: _is_no_package(workspace, top))


def _is_no_package(workspace: WorkspaceIndex, top: str) -> bool:
    if top in workspace.code.modules:
        return False
    if top in sys.stdlib_module_names or is_known(top) or not is_nowhere(workspace, top):
        return False
    word = re.compile(rf"(?<![\w-]){re.escape(top).replace('_', '[_-]')}(?![\w-])")
    return not any(word.search(text) for text in _wanted_from_elsewhere(workspace))


@once
def _wanted_from_elsewhere(workspace: WorkspaceIndex) -> tuple[str, ...]:
    """The texts of the files that name Python packages of others."""
    paths = (
        path
        for path in workspace.tree.files_below(workspace.tree.top)
        if _REQUIREMENTS.fullmatch(posixpath.basename(path))
    )
    return tuple(workspace.tree.text(path) or "" for path in sorted(paths))


__all__ = ["is_no_package", "is_unknown", "modules_imported", "present_name"]

"""Imports from packages that are nowhere, where another name was meant: that of the package of the workspace that has
these interfaces, or a known module's of which one letter differs."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from functools import cache
from typing import TYPE_CHECKING

from archlint.analysis.kept import once
from archlint.packaging.absent_packages import is_wanted_from_elsewhere
from archlint.packaging.renamed_packages import is_unknown, modules_imported
from archlint.ros import packages, python_modules
from archlint.suggestions import distance, nearest
from archlint.syntax.interfaces import INTERFACE_KINDS

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex
    from archlint.workspace.model import SourceFile

_LONG = 8
"""From how many letters on a name that differs in one of them from a known one is no name of its own."""
_SHORTEST = 5
"""The same for two letters that have changed places."""


def interfaces_of(workspace: WorkspaceIndex, file: SourceFile, module: str, names: Sequence[str]) -> str | None:
    """The module of the one package of the workspace that defines all interfaces which a file imports from a package
    that is nowhere, and all that others import from it."""
    package, _, kind = module.partition(".")
    if workspace.interfaces is None or kind not in INTERFACE_KINDS or not names:
        return None
    if not is_unknown(workspace, file, module) or is_wanted_from_elsewhere(workspace, package):
        return None
    imported = modules_imported(workspace).get(package, set())
    if any(other.partition(".")[2] != kind for other in imported):
        return None
    owners = [workspace.interfaces.packages_with(kind, name) for name in names]
    having = set(owners[0]).intersection(*owners[1:])
    return f"{next(iter(having))}.{kind}" if len(having) == 1 else None


def near_module(workspace: WorkspaceIndex, file: SourceFile, module: str) -> str | None:
    """The module that was meant by one whose top-level name is nowhere and a known one but for a slip."""
    top, dot, rest = module.partition(".")
    if len(top) < _SHORTEST or not is_unknown(workspace, file, module):
        return None
    known = _known_modules() | _of_workspace(workspace)
    near = nearest(top, known)
    if near is None or distance(top, near, 1) > 1 or top.replace("_", "") == near.replace("_", ""):
        return None
    is_slip = sorted(top) == sorted(near) or len(top) >= _LONG
    return f"{near}{dot}{rest}" if is_slip else None


@once
def _of_workspace(workspace: WorkspaceIndex) -> frozenset[str]:
    return frozenset(module for module in workspace.code.modules if "." not in module)


@cache
def _known_modules() -> frozenset[str]:
    return sys.stdlib_module_names | python_modules.names() | packages.table().names


__all__ = ["interfaces_of", "near_module"]

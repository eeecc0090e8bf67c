"""Which folder of a package has its Python code."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex

_OF_TESTS = frozenset({"test", "tests"})


def only_python_folder(workspace: WorkspaceIndex, package: str) -> str | None:
    """The one folder of a package that is one of Python: that which a setup.py installs none of is called otherwise."""
    depth = 0 if package in ("", ".") else len(package.split("/"))
    parts = (path.split("/")[depth:] for path in workspace.tree.files_below(package or "."))
    names = {own[0] for own in parts if own[1:] == ["__init__.py"]} - _OF_TESTS
    return names.pop() if len(names) == 1 else None


__all__ = ["only_python_folder"]

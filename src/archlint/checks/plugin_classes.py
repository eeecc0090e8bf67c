"""PKG002: classes that a description of plugins names and that the library of its package has under another name."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.checks.registry import finding
from archlint.finding import Finding, Related
from archlint.packaging.plugin_descriptions import MisnamedPlugin, misnamed_components, misnamed_plugins

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex


def plugin_classes(workspace: WorkspaceIndex) -> Iterator[Finding]:
    """One finding for each such class."""
    yield from map(_misnamed, misnamed_plugins(workspace))
    yield from map(_component, misnamed_components(workspace))


def _component(row: MisnamedPlugin) -> Finding:
    return _finding(
        row,
        f"the program of the component '{row.name}' cannot start: the package registers no class of that name, but "
        f"'{row.registered}', for which there is no program",
    )


def _misnamed(row: MisnamedPlugin) -> Finding:
    return _finding(
        row,
        f"the plugin '{row.name}' cannot be loaded: the package registers no class of that name for '{row.base}', but "
        f"'{row.registered}', which no description names",
    )


def _finding(row: MisnamedPlugin, message: str) -> Finding:
    return finding(
        "PKG002",
        row.place,
        message,
        help=f"write '{row.registered}', or register the class under the name that stands here",
        related=(Related(row.registered_at, "this class is registered here"),),
        identity=(row.place.file, row.name),
        meant=row.registered,
    )


__all__ = ["plugin_classes"]

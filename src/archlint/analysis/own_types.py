"""Which interfaces of the workspace have one side only, whatever the names are."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.analysis.kept import once
from archlint.model import EntityKind

if TYPE_CHECKING:
    from archlint.systems.model import System, WorkspaceIndex
    from archlint.systems.nodes import Endpoint

_SERVERS = {EntityKind.CLIENT: EntityKind.SERVICE, EntityKind.ACTION_CLIENT: EntityKind.ACTION_SERVER}
_CODE = (
    *(".c", ".cc", ".cpp", ".cs", ".cxx", ".go", ".h", ".hh", ".hpp", ".hxx", ".ino", ".ipynb", ".java", ".js"),
    *(".jsx", ".kt", ".lua", ".m", ".py", ".rb", ".rs", ".sh", ".ts", ".tsx", ".yaml", ".yml"),
)
"""What may have an end of an interface, or makes something that has."""


def has_no_server_here(system: System, end: Endpoint) -> bool:
    """Whether the workspace defines a client's type, and nothing there serves it under any name: nobody else can know
    it.

    False wherever something that is not followed names the type, for it may serve it.
    """
    workspace = system.workspace
    if workspace is None or workspace.is_subset or workspace.cut_short() or end.type is None:
        return False
    package, name = end.type.partition("/")[0], end.type.rpartition("/")[2]
    if package not in workspace.packages or _is_served(system, workspace, end):
        return False
    clients = {
        other.place.file for each in (*workspace.systems, system) for other in each.endpoints if other.type == end.type
    }
    return _files_that_name(workspace, name) <= clients


def _is_served(system: System, workspace: WorkspaceIndex, end: Endpoint) -> bool:
    kind = _SERVERS[EntityKind(end.kind)]
    return any(
        other.kind == kind and other.type in (end.type, None)
        for each in (*workspace.systems, system)
        for other in each.endpoints
    )


def _files_that_name(workspace: WorkspaceIndex, name: str) -> frozenset[str]:
    return _named(workspace).setdefault(name, _search(workspace, name))


@once
def _named(workspace: WorkspaceIndex) -> dict[str, frozenset[str]]:
    return {}


def _search(workspace: WorkspaceIndex, name: str) -> frozenset[str]:
    """The files with code in which a word stands."""
    paths = (path for path in workspace.tree.files_below("") if path.lower().endswith(_CODE))
    return frozenset(path for path in paths if workspace.code.mentions(path, name))


__all__ = ["has_no_server_here"]

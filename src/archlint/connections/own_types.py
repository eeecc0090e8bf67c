"""Which interfaces of the workspace have one side only, whatever the names are."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable
from typing import TYPE_CHECKING

from archlint.analysis.kept import kept, once
from archlint.analysis.reach import creations_of
from archlint.connections.lessons import is_lesson
from archlint.connections.parts_elsewhere import has_parts_elsewhere
from archlint.execution.present_servers import may_find_nobody
from archlint.model import SERVER_OF, EntityKind, Role
from archlint.ros.interfaces import parts_of_type

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.systems.model import System, WorkspaceIndex
    from archlint.systems.nodes import Endpoint

_CODE = (
    *(".c", ".cc", ".cpp", ".cs", ".cxx", ".go", ".h", ".hh", ".hpp", ".hxx", ".ino", ".ipynb", ".java", ".js"),
    *(".jsx", ".kt", ".lua", ".m", ".py", ".rb", ".rs", ".sh", ".ts", ".tsx", ".yaml", ".yml"),
)
"""What may have an end of an interface, or makes something that has."""


def has_no_server_here(system: System, end: Endpoint) -> bool:
    """Whether the workspace defines a client's type, and nothing there serves it under any name: nobody else can know
    it.

    False wherever something that is not followed names the type, for it may serve it; where the code is made for an
    absent server; and where a part of the system is elsewhere, as far as the workspace says (in a lesson, it seldom
    is).
    """
    workspace = system.workspace
    if workspace is None or workspace.is_subset or workspace.cut_short() or end.type is None:
        return False
    if not _asks(system, end):
        return False
    if not is_defined(workspace, end.type) or _is_served(system, workspace, end):
        return False
    if not _all_ends_known(system, workspace, end.type) or may_find_nobody(system, end.place):
        return False
    return not has_parts_elsewhere(workspace) and (is_lesson(system) or not may_be_served_elsewhere(system, end))


def is_only_server(system: System, server: Endpoint) -> bool:
    """Whether the workspace defines a server's type, and nothing else there serves it: whoever asks for the type can
    mean no other server.

    False wherever something that is not followed names the type, for it may serve it, too.
    """
    workspace = system.workspace
    if workspace is None or workspace.is_subset or workspace.cut_short() or server.type is None:
        return False
    servers = [end for end in system.endpoints if end.kind == server.kind and end.type in (server.type, None)]
    lines = _ends_of_system(system).lines_of(server) | _ends_of_workspace(workspace).lines_of(server)
    only = len(servers) == 1 and lines == {server.place}
    return only and is_defined(workspace, server.type) and _all_ends_known(system, workspace, server.type)


def are_only_ends(system: System, publisher: Endpoint, subscription: Endpoint) -> bool:
    """Whether the workspace defines the type of a publisher and a subscription, and nothing else there publishes or
    subscribes to it: nobody outside can know the type, so that each can be meant for the other alone."""
    workspace, type_ = system.workspace, publisher.type
    if workspace is None or workspace.is_subset or workspace.cut_short() or type_ is None:
        return False
    lines = {EntityKind.PUBLISHER: publisher.place, EntityKind.SUBSCRIBER: subscription.place}
    views = (_ends_of_system(system), _ends_of_workspace(workspace))
    only = all(ends.topic_lines(kind, type_) <= {place} for ends in views for kind, place in lines.items())
    return only and is_defined(workspace, type_) and _all_ends_known(system, workspace, type_)


def _all_ends_known(system: System, workspace: WorkspaceIndex, type_: str) -> bool:
    """Whether each file of the workspace that names a type has ends of it, and nothing else that may have some."""
    name = type_.rpartition("/")[2]
    ends, others = _ends_of_system(system), _ends_of_workspace(workspace)
    files = kept(workspace, (files_that_name, name), lambda: files_that_name(workspace, name))
    return files <= ends.files_of(type_) | others.files_of(type_)


_OF_TOPICS = frozenset({EntityKind.PUBLISHER, EntityKind.SUBSCRIBER})
_REQUESTS = (".call", ".call_async", ".send_goal", ".send_goal_async")


def _asks(system: System, client: Endpoint) -> bool:
    """Whether anything that runs uses a client, and not only makes it."""
    return client.place in _asking(system) or client.node.blueprint is None or client.node.blueprint.escapes


@once
def _asking(system: System) -> frozenset[Place]:
    """Where the clients are made with which callbacks, threads and programs ask for something."""
    calls = [call for call in system.calls if call.api.endswith(_REQUESTS) and call.context.role is not Role.METHOD]
    return frozenset(creation.place for call in calls for creation in creations_of(call.receiver))


def may_be_served_elsewhere(system: System, client: Endpoint) -> bool:
    """Whether nodes ask for several interfaces of a package of which nothing in the workspace serves any: what does, a
    robot say, may be another machine's."""
    workspace = system.workspace
    if workspace is None or client.type is None:
        return False
    package = client.type.partition("/")[0]
    views = (_ends_of_system(system), _ends_of_workspace(workspace))
    served = {type for ends in views for _, type in ends.served if type is not None}
    asked = {type for ends in views for type in ends.asked if type.partition("/")[0] == package}
    return len(asked) > 1 and package not in {type.partition("/")[0] for type in served}


def is_defined(workspace: WorkspaceIndex, interface: str) -> bool:
    """Whether an interface is there, and not only its package: without it the import fails, which MSG002 tells."""
    table = workspace.interfaces
    return table is not None and table.file(interface) is not None and bool(table.defines(*parts_of_type(interface)))


def _is_served(system: System, workspace: WorkspaceIndex, end: Endpoint) -> bool:
    kind = SERVER_OF[EntityKind(end.kind)]
    wanted = {(kind, end.type), (kind, None)}
    return any(not wanted.isdisjoint(ends.served) for ends in (_ends_of_system(system), _ends_of_workspace(workspace)))


class _Ends:
    """What some systems serve, and which files create endpoints of a type."""

    def __init__(self, systems: Iterable[System]) -> None:
        self.served: set[tuple[str, str | None]] = set()
        """The kinds of their servers, with the types; None for a type that is not known."""
        self._lines: defaultdict[tuple[str, str | None], set[Place]] = defaultdict(set)
        self.asked: set[str] = set()
        """The types of their clients that are known."""
        self._files: defaultdict[str | None, set[str]] = defaultdict(set)
        for end in (end for system in systems for end in system.endpoints):
            self._files[end.type].add(end.place.file)
            if end.kind in SERVER_OF.values():
                self.served.add((end.kind, end.type))
                self._lines[end.kind, end.type].add(end.place)
            elif end.kind in SERVER_OF and end.type is not None:
                self.asked.add(end.type)
            elif end.kind in _OF_TOPICS:
                self._lines[end.kind, end.type].add(end.place)

    def lines_of(self, server: Endpoint) -> set[Place]:
        """Where servers of the type of one are made, or of a type that is not known."""
        return self._lines.get((server.kind, server.type), set()) | self._lines.get((server.kind, None), set())

    def topic_lines(self, kind: EntityKind, type_: str) -> set[Place]:
        """Where publishers or subscriptions of a type are made, or of a type that is not known."""
        return self._lines.get((kind, type_), set()) | self._lines.get((kind, None), set())

    def files_of(self, type_: str) -> frozenset[str]:
        return frozenset(self._files.get(type_, ()))


@once
def _ends_of_system(system: System) -> _Ends:
    return _Ends([system])


@once
def _ends_of_workspace(workspace: WorkspaceIndex) -> _Ends:
    return _Ends(workspace.systems)


def files_that_name(workspace: WorkspaceIndex, name: str, endings: tuple[str, ...] = _CODE) -> frozenset[str]:
    """The files with code, or with other endings, in which a word stands; a package of another workspace does not know
    this one's types."""
    elsewhere = tuple(f"{folder}/" for folder in workspace.beside)
    every = workspace.tree.files_below(workspace.tree.top)
    paths = (path for path in every if path.lower().endswith(endings) and not path.startswith(elsewhere))
    return frozenset(path for path in paths if workspace.code.mentions(path, name))


__all__ = ["are_only_ends", "files_that_name", "has_no_server_here", "is_only_server", "may_be_served_elsewhere"]

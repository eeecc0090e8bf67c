"""A system: nodes that run together, under their final names, and who talks to whom."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from functools import cached_property, partial
from typing import TYPE_CHECKING

from archlint.branches import exclusive
from archlint.faults import Faults
from archlint.launch.files import LaunchFiles
from archlint.model import EntityKind
from archlint.syntax.summaries import Summaries
from archlint.systems.code import WorkspaceCode
from archlint.systems.nodes import Connection, key_of
from archlint.workspace.owners import FileOwners
from archlint.workspace.test_code import FileRoles
from archlint.workspace.tree import NO_FILES, Tree

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator, Mapping, Sequence

    from archlint.architecture import ConnectionKind
    from archlint.finding import Place
    from archlint.launch.model import Launched
    from archlint.model import (
        ApiCall,
        Blueprint,
        Callback,
        Program,
    )
    from archlint.observed.model import Comparison
    from archlint.ros.interfaces import InterfaceTable
    from archlint.syntax.facts import Facts
    from archlint.syntax.parameter_files import ParameterFacts
    from archlint.systems.nodes import Endpoint, Node
    from archlint.workspace.installed import Installs
    from archlint.workspace.model import Package


@dataclass(frozen=True, eq=False)
class System:
    """What is judged and drawn.  ``name`` is the launch file (relative path), None without one.

    ``closed`` is the closed world of the rules: nothing outside takes part.  Rules and renderers share it, so that
    it never changes: what differs in something is another one (``dataclasses.replace``).
    """

    name: str | None
    nodes: Sequence[Node]
    programs: Sequence[Program]
    closed: bool = False
    is_included: bool = False
    """True where another launch file includes this one, perhaps in a namespace and with other arguments."""
    package_dependencies: Mapping[str, frozenset[str]] = field(default_factory=dict)
    """Package → packages of this workspace it depends on (transitively)."""

    launched: Launched | None = None
    """The launch that starts this system."""
    alternatives: Sequence[tuple[Mapping[str, str], System]] = ()
    """The systems that it may be, with the launch arguments that make them, where nothing decides some."""
    defaults_decide: bool = False
    """Whether the first of these is this system itself, which the defaults make, and the others come of other choices
    that the launch file names."""
    workspace: WorkspaceIndex | None = None
    neighbours: Sequence[Node] = ()
    """For drawing: the nodes at the other end of what ``nodes`` have, that were not asked for, with these ends only."""
    launched_pairs: frozenset[frozenset[object]] = frozenset()
    """Pairs of node classes, each as ``(place, class name)``, that some launch file starts together."""
    compared: Comparison | None = None
    """What came of holding it against a running system, where one was recorded."""
    unowned: Sequence[Node] = ()
    """What is used by nodes that are not known.  Where ``nodes`` are given with such entries, these move here."""

    kept: dict[object, object] = field(default_factory=dict, init=False, repr=False)
    """What analyses found of it (:func:`archlint.analysis.kept.once`)."""
    _launched_names: dict[object, dict[tuple[str, Place], set[str | None]]] = field(
        default_factory=dict, init=False, repr=False
    )
    """Of each node that was asked for, by :func:`key_of`: the names of what it creates, by kind and place."""

    def __post_init__(self) -> None:
        # A frozen dataclass has no other way to settle its fields.
        settle = partial(object.__setattr__, self)
        settle("unowned", (*self.unowned, *(node for node in self.nodes if not node.is_node)))
        settle("nodes", tuple(node for node in self.nodes if node.is_node))
        for name in ("programs", "alternatives", "neighbours"):
            settle(name, tuple(getattr(self, name)))

    def __repr__(self) -> str:
        """A line: all that it holds would be megabytes."""
        return f"<System {self.name or 'of all code'}: {len(self.nodes)} nodes>"

    @property
    def roles(self) -> FileRoles:
        """Which files are test code, or put aside."""
        return FileRoles() if self.workspace is None else self.workspace.roles

    @property
    def entries(self) -> list[Node]:
        """The nodes, then what is used by nodes that are not known."""
        return [*self.nodes, *self.unowned]

    @property
    def drawn(self) -> list[Node]:
        """The entries, then the neighbours."""
        return [*self.entries, *self.neighbours]

    def in_same_launch(self, node: Node, other: Node) -> bool:
        """Whether a launch file starts both nodes, in a system that is judged by itself."""
        if not self.launched_pairs or node.blueprint is None or other.blueprint is None:
            return False
        pair = [(b.place, b.class_name) for b in (node.blueprint, other.blueprint)]
        return frozenset(pair) in self.launched_pairs

    @property
    def endpoints(self) -> Iterator[Endpoint]:
        """What the code of the workspace creates."""
        return (endpoint for node in self.entries if not node.external for endpoint in node.endpoints)

    @property
    def all_endpoints(self) -> Iterator[Endpoint]:
        """The same, and what is known of nodes whose source is not here."""
        return (endpoint for node in self.entries for endpoint in node.endpoints)

    @cached_property
    def topics(self) -> dict[str, Connection]:
        return self._connections("topic", EntityKind.PUBLISHER, EntityKind.SUBSCRIBER)

    @cached_property
    def services(self) -> dict[str, Connection]:
        return self._connections("service", EntityKind.SERVICE, EntityKind.CLIENT)

    @cached_property
    def actions(self) -> dict[str, Connection]:
        return self._connections("action", EntityKind.ACTION_SERVER, EntityKind.ACTION_CLIENT)

    def _connections(self, kind: ConnectionKind, provider: EntityKind, user: EntityKind) -> dict[str, Connection]:
        providers: dict[str, list[Endpoint]] = {}
        users: dict[str, list[Endpoint]] = {}
        for endpoint in (end for node in self.drawn for end in node.endpoints):
            if endpoint.kind not in (provider, user) or not endpoint.resolved or endpoint.error:
                continue
            assert endpoint.name is not None
            ends = providers if endpoint.kind == provider else users
            ends.setdefault(endpoint.name, []).append(endpoint)
        return {
            name: Connection(kind, name, tuple(providers.get(name, ())), tuple(users.get(name, ())))
            for name in sorted(providers.keys() | users.keys())
        }

    @property
    def calls(self) -> Iterator[ApiCall]:
        return (call for run in self.programs for call in run.calls)

    @property
    def callbacks(self) -> Iterator[Callback]:
        return (callback for run in self.programs for callback in run.callbacks)

    def may_coexist(self, node: Node, other: Node, any_package: bool = False) -> bool:
        """Whether two nodes can run in one system: a launch file starts both, or they are of one package,
        or one package depends on the other; with ``any_package``, of whichever packages they are.  Test code never
        runs together with anything else; opposite branches exclude each other, and nodes of different DDS domains do
        not see each other."""
        if node.test or other.test:
            return False
        if node.domain != other.domain or exclusive(node.alternatives, other.alternatives):
            return False
        if self.name is None and self.in_same_launch(node, other):
            return False  # the launch file's own system judges them, under their final names
        if any_package or self.name is not None or self.closed:
            return True
        if node.package is None or other.package is None:
            return node.package is None and other.package is None
        if node.package == other.package:
            return True
        return other.package in self.package_dependencies.get(
            node.package, frozenset()
        ) or node.package in self.package_dependencies.get(other.package, frozenset())


@dataclass(frozen=True, eq=False)
class WorkspaceIndex:
    """What is known of the whole workspace, the same for all systems of a run.

    Its ``systems``, and their alternatives, are those that it is made of, with itself as their ``workspace``.
    """

    installs: Mapping[str, Installs] = field(default_factory=dict)
    packages: Mapping[str, Package] = field(default_factory=dict)
    manifests: Mapping[str, Package] = field(default_factory=dict)
    """All packages by the shown path of their folder: two may have one name."""
    launched: Sequence[Launched] = ()
    """Every launch file of the workspace, run with its defaults (or the one that was asked for)."""
    launched_alone: Mapping[str, Launched] = field(default_factory=dict)
    """The launch files that others include and hand arguments, run on their own with their defaults."""
    systems: Sequence[System] = ()
    code: WorkspaceCode = field(default_factory=WorkspaceCode)
    """The Python files of the workspace."""
    launch_files: LaunchFiles = field(default_factory=LaunchFiles)
    """The launch files of the workspace, and the parameter files that they load."""
    tree: Tree = NO_FILES
    """All files of the workspace, for analyses."""
    owners: FileOwners = field(default_factory=FileOwners)
    faults: Faults = field(default_factory=Faults)
    """Where archlint itself failed in this run."""
    interfaces: InterfaceTable | None = None
    beside: Sequence[str] = ()
    """The folders, by shown paths, of packages of other workspaces: ``tree`` has their files, too."""
    declaration_files: Sequence[str] = ()
    """The files that declare the interfaces of nodes, by their shown paths."""
    explicit: bool = False
    """True where a launch file was named: the only system then."""
    is_subset: bool = False
    """True where only files of one package, or single ones, of all that the configuration is for were asked for:
    what is not seen may be elsewhere."""
    roles: FileRoles = field(default_factory=FileRoles)
    """Which files are test code, or put aside."""
    cut_short: Callable[[], list[str]] = list
    """The files of the programs that were followed only in part, since the workspace has so many."""
    summaries: Summaries = field(default_factory=Summaries)
    """What analyses say of single files, in this run and in those before."""
    kept: dict[object, object] = field(default_factory=dict, init=False, repr=False)
    """What analyses found of it (:func:`archlint.analysis.kept.once`)."""
    _launched_names: dict[object, dict[tuple[str, Place], set[str | None]]] = field(
        default_factory=dict, init=False, repr=False
    )
    """Of each node that was asked for, by :func:`key_of`: the names of what it creates, by kind and place."""

    def __post_init__(self) -> None:
        # A frozen dataclass has no other way to settle its fields.
        object.__setattr__(self, "systems", tuple(map(self._of_this, self.systems)))

    def _of_this(self, system: System) -> System:
        alternatives = [(arguments, self._of_this(other)) for arguments, other in system.alternatives]
        return replace(system, workspace=self, alternatives=alternatives)

    def facts_at(self, file: str) -> Facts | None:
        """The facts of a file of the workspace; None where it was not read."""
        return self.code.facts_at(file)

    def python_files(self, mentioning: str = "") -> Iterator[str]:
        """The Python files that were asked for and that can matter, and those that they import, but for launch files
        and test code; with a word, those in which it occurs."""
        for file, _ in self.code.judged():
            path = file.relative
            is_code = file.kind == "python" and not self.roles.is_test(path)
            if is_code and (not mentioning or self.code.mentions(path, mentioning)):
                yield path

    def parameters_of(self, file: str) -> ParameterFacts:
        """What a parameter file sets."""
        return self.launch_files.parameters(file)

    def package_of(self, file: str) -> str | None:
        """The package that a file belongs to."""
        return self.owners.package_of(file)

    @cached_property
    def started_by_launch(self) -> frozenset[object]:
        """The nodes, by :func:`key_of`, that launched systems have under a final name."""
        launched = (node for system in self.systems if system.name is not None for node in system.nodes)
        return frozenset(key_of(n.blueprint) for n in launched if n.blueprint is not None and (n.name or n.error))

    def launched_names(self, blueprint: Blueprint, kind: str, place: Place) -> frozenset[str | None]:
        """The names that launch files give to what a node creates at a place, with None for one that is not known;
        empty where none starts that."""
        key = key_of(blueprint)
        if key not in self._launched_names:
            names = self._launched_names[key] = {}
            for end in (end for node in self._launched_nodes.get(key, ()) for end in node.endpoints):
                names.setdefault((end.kind, end.place), set()).add(end.name if end.resolved else None)
        return frozenset(self._launched_names[key].get((kind, place), ()))

    def is_renamed_by_launch(self, blueprint: Blueprint, kind: str, place: Place, name: str | None) -> bool:
        """Whether every launch file that starts a node gives what it creates at a place another name than one, be it
        that the code goes back to that where it cannot read a parameter."""
        nodes = self._launched_nodes.get(key_of(blueprint), ())
        ends = [[end for end in node.endpoints if (end.kind, end.place) == (kind, place)] for node in nodes]
        return bool(nodes) and all(any(end.resolved and end.name not in (name, None) for end in row) for row in ends)

    @cached_property
    def _launched_nodes(self) -> Mapping[object, Sequence[Node]]:
        """What launch files start, by :func:`key_of`."""
        nodes: dict[object, list[Node]] = {}
        for system in self.systems:
            every = (system, *(other for _, other in system.alternatives)) if system.launched is not None else ()
            for node in (node for arm in every for node in arm.nodes):
                if node.blueprint is not None:
                    nodes.setdefault(key_of(node.blueprint), []).append(node)
        return nodes

    @cached_property
    def namespaces(self) -> Mapping[object, frozenset[str]]:
        """The namespaces in which whole systems have each node, by :func:`key_of`; a node of which one is not known
        has several.  A launch file that another one includes counts where no other has the node."""
        namespaces: dict[object, set[str]] = {}
        for system in sorted(self.systems, key=lambda other: other.is_included):
            for node in system.nodes if system.name is not None else ():
                if node.blueprint is None or (system.is_included and key_of(node.blueprint) in namespaces):
                    continue
                known = [node.name.rpartition("/")[0]] if node.name is not None else ["", "?"]
                namespaces.setdefault(key_of(node.blueprint), set()).update(known)
        return {key: frozenset(names) for key, names in namespaces.items()}

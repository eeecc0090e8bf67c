"""Load: the system that a launch file starts, each node under its final name and with its parameters."""

from __future__ import annotations

import posixpath
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.launch.kinds import StartedKind
from archlint.launch.model import Launched
from archlint.launch.started import Started
from archlint.model import Blueprint, ExecutorKind, Overrides, Program, Text
from archlint.ros import names
from archlint.ros.remapping import RemapRule, rules_of_arguments
from archlint.systems.command_line import Word, words_of
from archlint.systems.instances import instantiate
from archlint.systems.known_externals import NO_EXTERNAL_NODES, ExternalSources, blueprint_of
from archlint.systems.model import System
from archlint.systems.nodes import Node
from archlint.systems.overrides import applied, overrides_of
from archlint.systems.parameter_overrides import (
    declared_names,
    is_undecided,
    known_name,
    parameter_overrides,
    with_what_came_up,
)
from archlint.systems.understood import doubt

if TYPE_CHECKING:
    from archlint.interpreter.modules import Module
    from archlint.launch.launches import Launches
    from archlint.programs.entry import EntryPoint
    from archlint.programs.linker import Linker
    from archlint.ros.external_nodes import ExternalNode
    from archlint.syntax.parameter_files import ParameterFacts
    from archlint.systems.resolution import FinalName

_OF_PROGRAMS = (StartedKind.NODE, StartedKind.PROCESS, StartedKind.COMPONENT)
"""What may be a program of the workspace; a component is the class that its plugin names."""

_ROUNDS = 3
"""How often a program runs again because of parameters that it declares only with the values of others."""
RERUNS = 600
"""How many programs one session may run again with parameters from outside."""


class LaunchSystems:
    """Makes systems from launches, running executables again where parameters from outside change them."""

    def __init__(
        self,
        linker: Linker,
        entries: Iterable[EntryPoint],
        launches: Launches,
        dependencies: Mapping[str, frozenset[str]],
        distro: str | None = None,
        externals: ExternalSources = NO_EXTERNAL_NODES,
    ) -> None:
        self.linker = linker
        self.entries = {(entry.package, entry.executable): entry for entry in entries}
        self.parameters_of = launches.files.parameters
        self.dependencies = dependencies
        self.distro = distro
        self.externals = externals
        self._programs: dict[tuple[object, ...], Program | None] = {
            (*key, program.file): program for key, program in linker.started.items()
        }
        self._modules: dict[tuple[str | None, str, str], Module | None] = {}
        self.asked: list[Program] = []
        """The programs that systems were made of, in this order, since somebody cleared it."""

    def system(self, launched: Launched) -> System:
        nodes: list[Node] = []
        for started in _processes(launched):
            started_nodes = self.nodes(started, launched.file)
            reason, condition = self._doubt(started, started_nodes), launched.condition(started.branch_arms)
            nodes.extend(replace(node, doubt=reason, condition=condition) for node in started_nodes)
        programs = list({id(node.program): node.program for node in nodes if node.program is not None}.values())
        return System(
            name=launched.file,
            nodes=sorted(nodes, key=_order),
            programs=programs,
            package_dependencies=self.dependencies,
            launched=launched,
        )

    def files_asked(self) -> frozenset[str] | None:
        """The files, by their shown paths, that the programs in :attr:`asked` have read; None where that is not
        known."""
        rows = [self.linker.follower.files_read_by(program) for program in self.asked]
        return None if None in rows else frozenset(file for row in rows for file in row or ())

    def _doubt(self, started: Started, nodes: Sequence[Node]) -> str | None:
        """Why nodes whose source is here do not fit what the launch file says of them; None where they do."""
        if any(node.external for node in nodes):
            return None
        settings = [setting for node in nodes for setting in applied(started, known_name(node), self.parameters_of)]
        return doubt(started, nodes, settings)

    # --------------------------------------------------------------------------------------------- nodes

    def nodes(self, started: Started, launch_file: str) -> list[Node]:
        """The nodes of one started process."""
        program = self._followed(started)
        if program is None or not _has_nodes(program):
            return self._external_nodes(started, program, launch_file)
        own = [blueprint for blueprint in program.nodes if not (blueprint.test or blueprint.made_again)]
        nodes = [self._node(blueprint, program, started, launch_file) for blueprint in own]
        if not any(node.is_node for node in nodes):
            # It starts a node for sure, and all that is known of it is what some helper creates there.
            nodes.append(self._unfollowed(started, program, launch_file))
        return nodes

    def _followed(self, started: Started) -> Program | None:
        """The program of one started process, as it runs there."""
        program, words = self.program(started), None
        if program is not None and _wants_words(program, started):
            words = words_of(started)
            again = None if words is None else self.program(started, None, words)
            program = again if again is not None and _has_nodes(again) else program
        if program is None or not _has_nodes(program):
            return program
        rules = _rules(started)
        changes = parameter_overrides(started, program, self.parameters_of, rules)
        for _ in range(_ROUNDS):
            again = None if changes is None else self.program(started, changes, words)
            if changes is None or again is None or not _has_nodes(again):
                break
            new = declared_names(again) - declared_names(program)
            program = again
            changes = with_what_came_up(changes, new, started, program, self.parameters_of, rules) if new else None
        return program

    def by_executable(self, launches_: Iterable[Launched]) -> dict[tuple[str, str], list[Started]]:
        """What launch files start, all processes of one executable together; those with most to run first."""
        rows: dict[tuple[str, str], list[Started]] = {}
        for started in (started for launched in launches_ for started in _processes(launched)):
            key = (started.package.text or "", started.executable.text or "")
            if key in self.entries:
                rows.setdefault(key, []).append(started)

        def weight(key: tuple[str, str]) -> int:
            program = self.linker.started.get(key)
            return len(rows[key]) * (1 if program is None else 1 + len(program.callbacks))

        return {key: rows[key] for key in sorted(rows, key=lambda key: -weight(key))}

    def follow(self, group: Iterable[Started]) -> None:
        """Follow the programs of some processes, and leave it to others what systems these make."""
        for started in group:
            self._followed(started)

    def follow_after(self, program: Program, module: Module, group: Iterable[Started]) -> None:
        """The same of processes of one executable, of which it is known what it is by itself; of no other module."""
        for started in group:
            entry = self.entries[started.package.text, started.executable.text or ""]
            if self._module(entry, posixpath.dirname(started.file)) is module:
                self._programs[entry.package, entry.executable, module.path] = program
                self._followed(started)

    def _external_nodes(self, started: Started, program: Program | None, launch_file: str) -> list[Node]:
        """The nodes of what is not here, as far as they are known from elsewhere."""
        node = self._unfollowed(started, program, launch_file)
        is_here = node.unfollowed is not None or node.package in self.dependencies  # perhaps a fork of what is known
        rows = () if is_here else self.externals.nodes(started, self.distro)
        return [self._known(node, row) for row in rows] or [node]

    def _known(self, node: Node, row: ExternalNode) -> Node:
        """An external node with what it is known to have."""
        started = node.started
        assert started is not None
        blueprint, known = blueprint_of(row, started, self.distro)
        name, namespace = (None, _below(started, row.namespace)) if row.own_name else (started.name, started.namespace)
        instance = instantiate(
            blueprint,
            None,
            name=name,
            namespace=namespace,
            remaps=_rules(started),
            overrides=overrides_of(
                started, known_name(instantiate(blueprint, None, name=name, namespace=namespace)), self.parameters_of
            ),
            distro=self.distro,
        )
        instance = _without_uncertain_defaults(_without_unknown_remaps(instance, started), started, self.parameters_of)
        settings = sorted(applied(started, known_name(instance), self.parameters_of), key=lambda setting: setting.name)
        return replace(
            node,
            name=instance.name,
            resolution=instance.resolution if instance.name is not None else "unknown",
            own=instance.own,
            rules=instance.rules,
            creations=instance.creations,
            settings=tuple(settings),
            known=known,
            declared=tuple(blueprint.parameters),
        )

    def _unfollowed(self, started: Started, program: Program | None, launch_file: str) -> Node:
        node = _external(started, launch_file, self._why_unfollowed(started, program))
        settings = sorted(applied(started, node.name, self.parameters_of), key=lambda setting: setting.name)
        return replace(node, settings=tuple(settings))

    def _node(self, blueprint: Blueprint, program: Program, started: Started, launch_file: str) -> Node:
        node = instantiate(
            blueprint,
            program,
            name=started.name,
            namespace=started.namespace,
            remaps=_rules(started),
            launched_by=launch_file,
            distro=self.distro,
        )
        if blueprint.use_global_arguments:
            # The program has run with its parameters: its names are final.
            node = replace(node, overrides=overrides_of(started, known_name(node), self.parameters_of))
        node = _without_unknown_remaps(node, started)
        node = _without_uncertain_defaults(node, started, self.parameters_of)
        return replace(
            node,
            launch_place=started.place,
            started=started,
            alternatives=started.branch_arms,
            package=started.package.text or node.package,
            executable=started.executable.text or node.executable,
        )

    def _why_unfollowed(self, started: Started, program: Program | None) -> str | None:
        """Why an executable of this workspace has no node; None for one that is not here."""
        if (started.package.text or "", started.executable.text or "") not in self.entries:
            return None
        return (
            "the file that it starts is not in this workspace"
            if program is None
            else "no node was found in the code it starts"
        )

    def program(
        self, started: Started, changes: Overrides | None = None, words: tuple[Word, ...] | None = None
    ) -> Program | None:
        """The program of an executable, run with parameters and the words of a command line from outside; None
        for one that is not here."""
        package, executable = started.package.text, started.executable.text
        if package is None or executable is None or started.kind not in _OF_PROGRAMS:
            return None
        entry = self.entries.get((package, executable))
        if entry is None:
            return None
        module = self._module(entry, posixpath.dirname(started.file))
        if module is None:
            return None
        key: tuple[object, ...] = (package, executable, module.path)
        if changes is not None or words is not None:
            key = (*key, None if changes is None else changes.key, words)
        if key not in self._programs:
            if len(self._programs) > RERUNS:
                return self._programs.get((package, executable, module.path))
            self._programs[key] = self.linker.run_entry(entry, module, changes, words)
        program = self._programs[key]
        if program is not None:
            self.asked.append(program)
        return program

    def _module(self, entry: EntryPoint, folder: str) -> Module | None:
        key = (entry.package, entry.executable, folder)
        if key not in self._modules:
            self._modules[key] = self.linker.module_of(entry, f"{folder}/")
        return self._modules[key]


def _processes(launched: Launched) -> Iterator[Started]:
    """What a launch file starts that may be nodes."""
    return (row for row in launched.started if not row.dormant and row.kind != StartedKind.PROCESS)


def _below(started: Started, namespace: str) -> Text:
    """A namespace below the one that a launch file gives."""
    given = started.namespace
    if given is not None and not _known(given):
        return given
    return Text(names.join((given.text or "/") if given is not None else "/", namespace), "exact")


def _wants_words(program: Program, started: Started) -> bool:
    """Whether the words of a command line can change what a program creates."""
    if started.arguments:
        return program.parses_command_line or program.reads_command_line
    return program.parses_command_line and (not _has_nodes(program) or is_undecided(program.nodes))


def _has_nodes(program: Program) -> bool:
    return any(not blueprint.test for blueprint in program.nodes)


def _rules(started: Started) -> list[RemapRule]:
    """The remap rules of the process in the order of its command line."""
    arguments = [word for word in [*started.arguments, "--ros-args", *started.ros_arguments] if word is not None]
    rules = rules_of_arguments(arguments)
    for remap in started.remaps:
        if _known(remap.source) and _known(remap.target):
            try:
                rules.append(RemapRule.parse(f"{remap.source.text}:={remap.target.text}"))
            except ValueError:
                continue
    return rules


def _known(text: Text) -> bool:
    return text.text is not None and text.resolution in ("exact", "parameter")


def _without_unknown_remaps(node: Node, started: Started) -> Node:
    """A remapping to a name that is not known leaves the name unknown."""
    sources = [r.source.text for r in started.remaps if _known(r.source) and not _known(r.target)]
    if not sources or node.blueprint is None or (node.name is None and node.is_node):
        return node
    namespace, _, own = (node.name or f"{_namespace(started)}/_").rpartition("/")
    remapped = [names.expand(source or "", own, namespace or "/") for source in sources]
    reason = "the launch file remaps it to a name that is not known"
    return _forgetting(node, lambda final: final.name in remapped, reason)


def _without_uncertain_defaults(node: Node, started: Started, parameters_of: Callable[[str], ParameterFacts]) -> Node:
    """Parameters that are not known, a file that is not found say, may set whatever the nodes declare: what only their
    defaults name is not known.  What comes after them on the command line holds."""
    unread = [number for number, parameters in enumerate(started.parameters) if parameters.sets_anything]
    if not unread or node.blueprint is None or not node.blueprint.use_global_arguments:
        return node
    later = replace(started, parameters=started.parameters[unread[-1] + 1 :], arguments=[], ros_arguments=[])
    settings = overrides_of(later, known_name(node), parameters_of)

    def is_uncertain(final: FinalName) -> bool:
        decided_by = set((final.parameter or "").split(",")) - {""}
        return not settings.keys() >= decided_by

    return _forgetting(
        node, is_uncertain, "its parameter may be set by parameters of the launch file that are not known"
    )


def _forgetting(node: Node, is_lost: Callable[[FinalName], bool], reason: str) -> Node:
    """The node where names that are known, and lost all the same, are unknown for this reason."""
    return replace(
        node,
        creations=tuple(
            replace(named, final=named.final.forgotten(reason))
            if named.final.resolved and is_lost(named.final)
            else named
            for named in node.creations
        ),
    )


def _namespace(started: Started) -> str:
    """The namespace that a launch file gives, without a slash at the end."""
    given = started.namespace
    return (given.text or "").rstrip("/") if given is not None and _known(given) else ""


def _external(started: Started, launch_file: str, unfollowed: str | None) -> Node:
    """A node whose source is not here or of no use, with what the launch file says of its name."""
    name = started.name.text if started.name is not None and _known(started.name) else None
    namespace: str | None = "/"
    if started.namespace is not None:
        namespace = started.namespace.text if _known(started.namespace) else None
    full = None if name is None or namespace is None else names.join(namespace, name)
    return Node(
        name=full,
        blueprint=None,
        package=started.package.text,
        executable=started.executable.text,
        executor=ExecutorKind.UNKNOWN,
        launched_by=launch_file,
        external=True,
        unfollowed=unfollowed,
        alternatives=started.branch_arms,
        started=started,
        launch_place=started.place,
        resolution="exact" if full is not None else "unknown",
    )


def _order(node: Node) -> tuple[object, ...]:
    place = node.launch_place
    where = (place.file, place.line, place.column) if place else ("", 0, 0)
    return (node.name is None, node.name or "", *where, node.blueprint.class_name if node.blueprint else "")

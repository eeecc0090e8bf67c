"""Which launch files are systems, and how the open system is judged beside them."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence, Set
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING, Protocol

from archlint.finding import Place
from archlint.launch.kinds import FileStatus
from archlint.launch.launches import Launches
from archlint.launch.model import Launched
from archlint.launch.named_files import FileReference
from archlint.model import Blueprint, Program
from archlint.records import dataclass
from archlint.systems.known_externals import NO_EXTERNAL_NODES, ExternalSources
from archlint.systems.launched import LaunchSystems
from archlint.systems.model import System, WorkspaceIndex
from archlint.systems.nodes import key_of
from archlint.systems.variants import other_choices, undecided_arguments

if TYPE_CHECKING:
    from archlint.globs import Glob
    from archlint.interpreter.modules import Module
    from archlint.programs.entry import EntryPoint
    from archlint.programs.linker import Linker


def launch_systems(
    opened: System,
    linker: Linker,
    entries: Sequence[EntryPoint],
    launches: Launches,
    launched: Sequence[Launched],
    workspace: WorkspaceIndex,
    *,
    closed: bool,
    chosen: str | None = None,
    configured: Sequence[Glob] = (),
    distro: str | None = None,
    externals: ExternalSources = NO_EXTERNAL_NODES,
    memory: KeptSystems | None = None,
) -> list[System]:
    """The open system and one for each launch file (of those that are configured); only the chosen one, where
    one is named.  ``launched`` is what :func:`run_launches` gives.  ``memory`` may have some systems from an earlier
    run, and is told of those that are made.

    All of them share one index: ``workspace`` with what is known of launch files and systems.
    """
    maker = LaunchSystems(linker, entries, launches, opened.package_dependencies, distro, externals)
    making = _Making(maker, launches, launched, _parts(launched), closed, chosen, configured, memory)
    if not linker.ahead.has_started:
        linker.ahead.follow(making.programs_in_parts)
    linker.ahead.follow(making.alternatives_in_parts)
    systems = making.systems_of(launched)
    others = [other.launched for system in systems for _, other in system.alternatives if other.launched is not None]
    runs = [*launched, *others]
    pairs = frozenset(_started_pairs(runs, _by_executable(opened.programs)))
    beside = [] if chosen is not None else [replace(opened, launched_pairs=pairs)]
    index = replace(
        workspace,
        launched=launched,
        launched_alone={path: launches.with_defaults(path) for path in _given_arguments(systems)},
        systems=[*beside, *systems],
        explicit=chosen is not None,
    )
    return list(index.systems)


class KeptSystems(Protocol):
    """Systems of launch files that an earlier run has made."""

    def system(self, launched: Launched) -> System | None: ...
    def note(self, system: System, files: Iterable[str] | None) -> None: ...


@dataclass(frozen=True)
class _Making:
    """How launches become systems; ``parts`` are the launch files that others include."""

    maker: LaunchSystems
    launches: Launches
    launched: Sequence[Launched]
    parts: Set[str | None]
    closed: bool
    chosen: str | None
    configured: Sequence[Glob]
    memory: KeptSystems | None

    def programs_in_parts(self) -> list[Callable[[], object]]:
        """Following what the launch files start, an executable a part: launches of one share what they can."""
        chosen = [launch for launch in self.launched if self._is_system(launch)]
        return [partial(self.maker.follow, group) for group in self.maker.by_executable(chosen).values()]

    def alternatives_in_parts(self) -> list[Callable[[], object]]:
        """Making the systems of launch files that may start something else with other arguments, a few a part."""
        split = [row for row in self.launched if self._is_system(row) and (undecided_arguments(row) or _choices(row))]
        return [partial(self.systems_of, group) for group in _batches(split)]

    def systems_of(self, group: Iterable[Launched]) -> list[System]:
        systems = []
        for launch in group:
            place = Place(launch.file, 1, 1, 1, 1)
            with self.launches.faults.contained("making the system of this launch file", place):
                systems.append(self._known_or_made(launch))
        return [system for system in systems if system is not None]

    def _known_or_made(self, launch: Launched) -> System | None:
        if self.memory is None:
            return self._system_of(launch)
        known = self.memory.system(launch)
        if known is not None:
            return known
        self.maker.asked.clear()
        system = self._system_of(launch)
        if system is not None:
            self.memory.note(system, self.maker.files_asked())
        return system

    def _system_of(self, launch: Launched) -> System | None:
        """The system of a launch file; None where it is none, or not one of those that are configured."""
        if not self._is_system(launch):
            return None
        system = self.maker.system(launch)
        is_included = launch.file in self.parts
        # The nodes of a part may have their partners beside it.
        is_closed = (self.closed and not is_included) or (self._is_named(launch) and _is_complete(launch, system))
        settled = partial(replace, closed=is_closed, is_included=is_included)
        alternatives = [
            (values, settled(self.maker.system(self.launches.run(launch.file, {**launch.arguments, **values}))))
            for values in (undecided_arguments(launch) if _differs(system) else ())
        ]
        if alternatives or self.chosen is not None:
            return settled(system, alternatives=alternatives)
        defaults, more = _with_other_choices(self.launches, launch)
        alternatives = [(values, settled(self.maker.system(run))) for values, run in more]
        alternatives[:0] = [(defaults, settled(system))] if alternatives else []
        return settled(system, alternatives=alternatives, defaults_decide=bool(alternatives))

    def _is_named(self, launch: Launched) -> bool:
        """Whether somebody has said that a launch file is a system."""
        return self.chosen is not None or _matches(launch, self.configured)

    def _is_system(self, launch: Launched) -> bool:
        return _is_system(launch, self.chosen, self.configured)


def _matches(launch: Launched, configured: Sequence[Glob]) -> bool:
    return any(glob.matches(launch.file) for glob in configured)


def _is_system(launch: Launched, chosen: str | None, configured: Sequence[Glob]) -> bool:
    is_meant = not configured or chosen is not None or _matches(launch, configured)
    return is_meant and launch.is_launch_file and not launch.ros1


def follow_started_ahead(
    linker: Linker,
    entries: Sequence[EntryPoint],
    launches: Launches,
    launched: Sequence[Launched],
    chosen: str | None = None,
    configured: Sequence[Glob] = (),
) -> None:
    """Have the processes that follow the programs follow what launch files start of these, too."""
    maker = LaunchSystems(linker, entries, launches, {})
    groups = maker.by_executable(launch for launch in launched if _is_system(launch, chosen, configured))

    def follow(entry: EntryPoint, module: Module, program: Program) -> None:
        group = groups.get((entry.package or "", entry.executable))
        if group is not None:
            maker.follow_after(program, module, group)

    linker.ahead.started = follow


def _choices(launch: Launched) -> bool:
    """Whether a launch file gives choices of which not all have been tried."""
    return bool(other_choices(launch)[1])


def _with_other_choices(
    launches: Launches, launch: Launched
) -> tuple[dict[str, str], list[tuple[dict[str, str], Launched]]]:
    """The defaults of the arguments that a launch file gives choices for, and its runs with others of them, where
    its code then starts what it does not even mention with the defaults."""
    defaults, others = other_choices(launch)
    seen = {started.place for started in launch.started}
    runs = [(values, launches.run(launch.file, {**launch.arguments, **values})) for values in others]
    return defaults, [
        (values, run) for values, run in runs if any(started.place not in seen for started in run.started)
    ]


_FILES = 4
"""How many launch files of one folder are one part of the work."""


def _batches(launches_: Sequence[Launched]) -> list[list[Launched]]:
    """Launch files that may start the same programs with the same parameters: neighbours; those that start most
    first."""
    folders: dict[str, list[Launched]] = {}
    for launch in launches_:
        folders.setdefault(launch.file.rpartition("/")[0], []).append(launch)
    groups = [rows[at : at + _FILES] for rows in folders.values() for at in range(0, len(rows), _FILES)]
    return sorted(groups, key=lambda group: -sum(len(launch.started) for launch in group))


def _parts(launches_: Sequence[Launched]) -> set[str | None]:
    """The launch files that others include, or may include by a path of the machine that they run on."""
    includes = [include for launch in launches_ for include in launch.included]
    ends = {end for include in includes if (end := _end_on_machine(include.reference)) is not None}
    files = {launch.file for launch in launches_ if _end(launch.file) in ends}
    return files.union(include.reference.source for include in includes if include.file != include.reference.source)


def _end_on_machine(reference: FileReference) -> tuple[str, ...] | None:
    """The end of an absolute path, which may lead to a workspace that lies elsewhere: in a container, say."""
    written = reference.written or ""
    elsewhere = reference.source is None and written.startswith("/") and not written.startswith("/opt/ros/")
    return _end(written) if elsewhere else None


def _end(path: str) -> tuple[str, ...]:
    """The name of a file and of its folder: ``launch/robot.launch.py`` is installed with both."""
    return tuple(path.split("/")[-2:])


def _given_arguments(systems: Sequence[System]) -> list[str]:
    """The launch files that those of some systems include and hand arguments; where one of several files is included,
    each of these."""
    includes = [include for system in systems if system.launched is not None for include in system.launched.included]
    places = {include.place for include in includes if include.arguments}
    sources = (include.reference.source for include in includes if include.place in places)
    return sorted({source for source in sources if source is not None})


def run_launches(
    launches: Launches, chosen: str | None = None, arguments: Mapping[str, str] | None = None
) -> list[Launched]:
    """The launch files of the workspace with their defaults, or the chosen one with its arguments."""
    if chosen is not None:
        launches.knows_command_line = True
        return [launches.run(chosen, arguments)]
    return [launches.run(path) for path in launches.files.all()]


def _differs(system: System) -> bool:
    """Whether arguments that nothing decides can change what is judged: something of it runs only with some."""
    return any(node.condition for node in system.nodes) and not all(node.external for node in system.nodes)


def _is_complete(launched: Launched, system: System) -> bool:
    """Whether everything that a launch file starts is here and was followed."""
    included = all(
        include.reference.status not in (FileStatus.UNKNOWN, FileStatus.EXTERNAL) for include in launched.included
    )
    return included and not launched.gaps and not any(node.is_stranger for node in system.nodes)


def _by_executable(programs: Sequence[Program]) -> dict[tuple[str, str], list[Blueprint]]:
    blueprints: dict[tuple[str, str], list[Blueprint]] = {}
    for program in programs:
        if program.executable:
            blueprints.setdefault((program.package or "", program.name), []).extend(program.nodes)
    return blueprints


def _started_pairs(
    launches: Iterable[Launched], blueprints: Mapping[tuple[str, str], Sequence[Blueprint]]
) -> set[frozenset[object]]:
    """Pairs of node classes that one launch file starts: it, not the open system, judges them together."""
    pairs: set[frozenset[object]] = set()
    for launched in launches:
        keys: dict[object, None] = {}
        for started in launched.started:
            package, executable = started.package.text, started.executable.text
            for blueprint in blueprints.get((package or "", executable or ""), ()):
                keys.setdefault(key_of(blueprint))
        every = list(keys)
        if len(every) <= 200:
            pairs.update(frozenset((key, other)) for n, key in enumerate(every) for other in every[n:])
    return pairs

"""From the facts of a workspace to its systems: link, load."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.config.options import options_for
from archlint.engine.inputs import Inputs, is_subset
from archlint.engine.kept_programs import ProgramCache
from archlint.engine.request import NothingToDo, Request
from archlint.faults import Faults
from archlint.interpreter.modules import ModuleIndex
from archlint.launch.launches import Launches
from archlint.programs.cpp_programs import cpp_entry_points
from archlint.programs.entry_points import entry_points, read_installs
from archlint.programs.kept_launches import keep_launches
from archlint.programs.linker import Linker
from archlint.programs.scripts import forget_names
from archlint.ros.external_nodes import by_program
from archlint.ros.interfaces import InterfaceTable
from archlint.syntax.interface_declarations import FILE_NAME
from archlint.syntax.memory import default_processes
from archlint.syntax.nodl_declarations import SUFFIX
from archlint.syntax.workspace_files import WorkspaceFiles
from archlint.systems.code import WorkspaceCode
from archlint.systems.instances import assemble
from archlint.systems.known_externals import ExternalSources
from archlint.systems.launches import follow_started_ahead, launch_systems, run_launches
from archlint.systems.model import System, WorkspaceIndex
from archlint.systems.shown import only

if TYPE_CHECKING:
    from archlint.launch.files import LaunchFiles
    from archlint.observed.model import Observed
    from archlint.programs.ahead import Beside
    from archlint.programs.entry import EntryPoint
    from archlint.programs.kept import KeptPrograms
    from archlint.syntax.files import FactsOfFiles
    from archlint.workspace.installed import Installs
    from archlint.workspace.model import Workspace


def systems_of(
    inputs: Inputs, facts: FactsOfFiles, beside: Callable[[WorkspaceIndex], Beside | None] = lambda index: None
) -> list[System]:
    """Link and load.  What ``beside`` gives is begun where processes follow programs."""
    request, workspace, tree = inputs.request, inputs.workspace, inputs.tree
    faults = Faults()
    files = WorkspaceFiles(workspace.files, facts.facts_of, facts.relevant, tree, inputs.importable)
    installs = _installs(inputs, files, faults)
    linker, cache = _linker(inputs, facts, files, installs, faults)
    entries = _entries(installs, workspace, facts)
    old, distro = frozenset(package.name for package in workspace.packages if package.ros1), request.settings.distro
    launches = Launches(files, installs, faults, old, distro)
    if cache.lasts:
        keep_launches(launches, tree, lambda index, now: cache.open_launches(index, now, installs, sorted(old), distro))
    if request.launch is not None and not launches.files.can_be_launched(request.launch):
        raise NothingToDo(_no_launch_file(request, launches.files))
    launched = run_launches(launches, request.launch, dict(request.launch_arguments))
    follow_started_ahead(linker, entries, launches, launched, request.launch, request.settings.launch)
    index = _index(inputs, files, installs, linker, launches, _programs(entries, workspace))
    linker.ahead.beside = beside(index)
    followed = linker.run_all(entries)
    programs = forget_names(followed, linker.started.values(), installs, linker.own)
    [opened] = assemble(programs, workspace, request.settings, inputs.nodes)
    if inputs.memory is not None:
        inputs.memory.note_programs(opened.programs, linker.follower.files_read_by)
    systems = launch_systems(
        opened,
        linker,
        entries,
        launches,
        launched,
        index,
        closed=request.settings.closed_world,
        chosen=request.launch,
        configured=request.settings.launch,
        distro=distro,
        externals=ExternalSources(by_program(request.settings.external_nodes)),
        memory=inputs.memory,
    )
    cache.save()
    if not systems:  # only where one launch file was asked for: the open system is always there
        ros1 = launches.files.frontend(request.launch or "").ros1
        raise NothingToDo(f"{request.launch} {'is for ROS 1' if ros1 else 'starts nothing that can be read'}")
    if request.observed is not None:
        systems[0] = _compared(systems[0], request.observed, request, workspace)
    return systems


def _index(
    inputs: Inputs,
    files: WorkspaceFiles,
    installs: Mapping[str, Installs],
    linker: Linker,
    launches: Launches,
    programs: frozenset[str],
) -> WorkspaceIndex:
    """What is known of the whole workspace; ``programs`` are the files that are installed as such."""
    workspace = inputs.workspace
    return WorkspaceIndex(
        installs,
        {package.name: package for package in workspace.packages},
        {package.relative: package for package in workspace.packages},
        code=WorkspaceCode(files, launches.index, installs),
        launch_files=launches.files,
        tree=inputs.tree,
        owners=launches.owners,
        faults=launches.faults,
        interfaces=linker.interfaces,
        is_subset=is_subset(inputs.request, workspace),
        roles=replace(linker.index.roles, programs=programs),
        cut_short=linker.cut_short,
        declaration_files=declaration_files(workspace),
        beside=workspace.beside,
        summaries=inputs.summaries,
    )


def _programs(entries: Sequence[EntryPoint], workspace: Workspace) -> frozenset[str]:
    """The Python files that the executables of packages run."""
    modules = {(entry.package, entry.module) for entry in entries if entry.file is None}
    of_modules = (file.relative for file in workspace.files if (file.package, file.module) in modules)
    scripts = (entry.file for entry in entries if entry.file is not None)
    return frozenset((*of_modules, *(file.relative for file in scripts if file.kind != "cpp")))


def declaration_files(workspace: Workspace) -> list[str]:
    """The files that declare the interfaces of nodes."""
    files = (file.relative for file in workspace.files)
    return sorted(file for file in files if file.rpartition("/")[2] == FILE_NAME or file.endswith(SUFFIX))


def _installs(inputs: Inputs, files: WorkspaceFiles, faults: Faults) -> dict[str, Installs]:
    """What each package installs, by its name."""
    memory = inputs.memory
    known = None if memory is None else memory.installs()
    if known is not None:
        return known
    index = ModuleIndex(files.importable, files.facts_of)
    installs = read_installs(inputs.workspace.packages, files, faults, index)
    if memory is not None and not faults.count:
        memory.note_installs(installs, index.asked_for())
    return installs


def _compared(system: System, observed: Observed, request: Request, workspace: Workspace) -> System:
    """A system with what differs from the running one."""
    from archlint.analysis.comparison import compare  # seldom asked for

    is_external = options_for(request.settings, ["GRF006"])["GRF006"].is_external
    context = {file.relative for file in workspace.files if file.context and request.launch is None}
    return replace(system, compared=compare(system, observed, is_external, context))


def follow_part(inputs: Inputs, facts: FactsOfFiles, modules: Sequence[str], code: list[tuple[str, int, int]]) -> bytes:
    """The programs of some modules, by their paths, as they are kept by a run of the archlint that ``code`` says."""
    workspace, faults = inputs.workspace, Faults()
    files = WorkspaceFiles(workspace.files, facts.facts_of, facts.relevant, inputs.tree)
    installs = read_installs(workspace.packages, files, faults)
    linker, _ = _linker(inputs, facts, files, installs, faults, code)
    return linker.follow_part(_entries(installs, workspace, facts), modules)


def _entries(installs: dict[str, Installs], workspace: Workspace, facts: FactsOfFiles) -> list[EntryPoint]:
    """What starts nodes, of Python and of C++."""
    entries = entry_points(installs, workspace.files)
    return entries + cpp_entry_points(installs, workspace.files, facts.facts_of, facts.relevant)


def _linker(
    inputs: Inputs,
    facts: FactsOfFiles,
    files: WorkspaceFiles,
    installs: Mapping[str, Installs],
    faults: Faults,
    code: list[tuple[str, int, int]] | None = None,
) -> tuple[Linker, ProgramCache]:
    """What follows the programs, and what keeps them."""
    request, workspace, tree = inputs.request, inputs.workspace, inputs.tree
    words = {name: install.words for name, install in installs.items()}
    generated = {name: install.generated for name, install in installs.items() if install.generated is not None}
    names = Counter(package.name for package in workspace.packages)
    without = [name for name, install in installs.items() if install.generates_nothing and names[name] == 1]
    interfaces = InterfaceTable(workspace.files, lambda file: tree.text(file.relative), words, generated, without)
    cache = ProgramCache(inputs.store, workspace, facts, tree, code, inputs.results)

    def keep(index: ModuleIndex, import_now: Callable[[Iterable[str]], None]) -> KeptPrograms:
        parts = {name: sorted(interfaces) for name, interfaces in generated.items()}
        return cache.open(index, import_now, words, parts, without)

    jobs = request.jobs or default_processes()
    keeps = jobs > 1 or request.pool is not None or inputs.store.lasts
    kept = keep if keeps else None
    linker = Linker(files, interfaces, faults, kept, jobs, request.monitor, _elsewhere(inputs, facts))
    return linker, cache


def _elsewhere(inputs: Inputs, facts: FactsOfFiles) -> Callable[[Sequence[Sequence[str]], KeptPrograms], None] | None:
    if inputs.request.pool is None:
        return None
    from archlint.engine.link_elsewhere import follow_elsewhere  # most runs are on one machine

    return follow_elsewhere(inputs, facts)


def _no_launch_file(request: Request, files: LaunchFiles) -> str:
    """Why the file of ``--launch`` cannot be launched."""
    for file, line, column, message, internal in files.problems():
        if file == request.launch:
            return f"{file}:{line}:{column}: {'internal error: ' if internal else ''}{message}"
    return f"{request.launch} is not a launch file in {', '.join(request.paths)}"


def as_asked_for(request: Request, system: System, workspace: Workspace) -> System:
    """The system as it is shown: whole where a launch file was asked for, else without what is only context."""
    if request.launch is not None:
        return system
    return only(system, {file.relative for file in workspace.files if file.context})


def combined(systems: Sequence[System]) -> System:
    """One system to draw of those of several workspaces."""
    first, *others = systems
    if not others:
        return first
    nodes = sorted((n for system in systems for n in system.nodes), key=lambda n: (n.name is None, n.name or ""))
    return replace(
        first,
        nodes=nodes,
        programs=[program for system in systems for program in system.programs],
        unowned=[entry for system in systems for entry in system.unowned],
        neighbours=[node for system in systems for node in system.neighbours],
    )

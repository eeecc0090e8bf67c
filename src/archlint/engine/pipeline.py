"""One run of archlint, top to bottom: find, compile, link, load, judge, suppress, sort."""

from __future__ import annotations

import os
import time
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING

from archlint.engine.result_cache import RunCache
from archlint.engine.sources import PYTHON, Sources
from archlint.faults import Faults
from archlint.finding import Place, Related
from archlint.report.model import Judged, Report, Summary, summarise
from archlint.syntax.python.deep_stack import call_with_deep_stack
from archlint.workspace.tree import SourceTree

if TYPE_CHECKING:
    from archlint.config.settings import Settings
    from archlint.finding import Finding
    from archlint.launch.load import LaunchLoader
    from archlint.observed.model import Observed
    from archlint.syntax.cache import NullStore, Store
    from archlint.syntax.files import FactsOfFiles
    from archlint.systems.model import System
    from archlint.workspace.model import SourceFile, Workspace


class NothingToDo(Exception):
    """No file to look at; ``str()`` says where none was found."""


@dataclass(frozen=True)
class Request:
    """What is to be analysed and how.  ``paths`` exist; ``jobs`` is the most processes, None for as many as
    there are processors."""

    paths: tuple[str, ...]
    settings: Settings
    cached: bool = True
    jobs: int | None = None
    launch: str | None = None
    """The launch file that is the only system, as a path from the working directory."""
    launch_arguments: tuple[tuple[str, str], ...] = ()
    observed: Observed | None = None
    """What a running system said of itself, to hold the system against."""


def check(request: Request) -> Report:
    """Everything that the selected rules find, in order.  Raises :class:`NothingToDo`."""
    started = time.perf_counter()
    workspace = call_with_deep_stack(lambda: _found(request))
    store = _store(request)
    tree = SourceTree(Path.cwd(), Path(workspace.root))
    kept = RunCache(store, request, workspace, tree)
    judged = kept.load()
    if judged is None:
        facts = _compiled(request, workspace, store)
        judged = kept.load_again(facts)
        if judged is None:
            judged = call_with_deep_stack(lambda: _judged_in_parts(request, workspace, facts, tree))
            if facts.lasting and not any(finding.code == "LNT003" for finding in judged.findings):
                kept.save(judged)
    store.close()
    elapsed = time.perf_counter() - started
    summary = replace(judged.summary, elapsed_s=elapsed, cpp_packages=len(workspace.cpp_packages))
    notices = [*judged.notices, *_not_looked_at(request, workspace, summary)]
    return Report(judged.findings, summary, Sources().line, notices, remarks=judged.remarks)


def _not_looked_at(request: Request, workspace: Workspace, summary: Summary) -> Iterator[str]:
    from archlint.engine.looked_at import idle_patterns, without_node

    yield from without_node(summary)
    if request.settings.file is not None and not _partial(request, workspace):
        yield from idle_patterns(request.settings, workspace)


def graph(request: Request, everything: bool = False) -> System:
    """The system of all nodes, for drawing; ``everything`` adds what rclpy makes for every node.

    Raises :class:`NothingToDo`.
    """
    from archlint.systems.implicit import with_implicit

    workspace = _found(request)
    store = _store(request)
    facts = _compiled(request, workspace, store)
    _refuse_nothing(request, workspace, facts)
    tree = SourceTree(Path.cwd(), Path(workspace.root))
    parts = _parts(request, workspace)
    opened = call_with_deep_stack(lambda: [_systems(request, part, facts, tree)[0] for part in parts])
    store.close()
    system = _together([_asked_for(request, one, part) for one, part in zip(opened, parts, strict=True)])
    return with_implicit(system, request.settings.distro) if everything else system


# --- the floors


def _found(request: Request) -> Workspace:
    from archlint.workspace.discovery import find

    exclude = [pattern for glob in request.settings.exclude for pattern in glob.patterns()]
    workspace = find(request.paths, exclude=exclude)
    if not workspace.problems and not any(_is_input(file) or _is_of_package(file) for file in workspace.files):
        where = ", ".join(request.paths)
        raise NothingToDo(f"nothing to check: no package.xml, no Python file and no launch file in {where}")
    return workspace


def _is_input(file: SourceFile) -> bool:
    return not file.context and file.kind in ("python", "launch_python", "launch_xml", "launch_yaml")


def _is_of_package(file: SourceFile) -> bool:
    """Whether a file can be judged without any Python: a manifest, an interface."""
    return not file.context and file.kind in ("package_xml", "interface")


def _is_for_ros(workspace: Workspace) -> bool:
    """Whether files say by their kind that this is ROS."""
    kinds = ("package_xml", "interface", "launch_python", "launch_xml", "launch_yaml")
    return any(file.kind in kinds for file in workspace.files)


def _passed_over(
    request: Request, workspace: Workspace, facts: FactsOfFiles, loader: LaunchLoader | None
) -> Iterator[str]:
    """What is told of files for ROS 1; raises :class:`NothingToDo` where there are no others."""
    from archlint.engine.looked_at import for_ros1

    python = [file.relative for file in _python(workspace) if not file.context and facts.is_ros1(file)]
    launch = loader.ros1_files() if loader is not None else []
    inputs = {file.relative for file in workspace.files if _is_input(file)}
    if inputs and inputs <= {*python, *launch}:
        raise NothingToDo(f"nothing to check in {', '.join(request.paths)}: all of it is for ROS 1")
    yield from for_ros1(python, launch)


def _refuse_nothing(request: Request, workspace: Workspace, facts: FactsOfFiles) -> None:
    """Raises :class:`NothingToDo` where nothing is for ROS 2: a run that finds nothing there would say nothing."""
    if _known(request, workspace, facts):
        return
    if not _is_for_ros(workspace):
        files = len(_python(workspace))
        raise NothingToDo(
            f"nothing to check in {', '.join(request.paths)}: no package.xml, no launch file, "
            f"and nothing that uses rclpy in {files} Python file{'s' if files > 1 else ''}"
        )


def _python(workspace: Workspace) -> list[SourceFile]:
    return [file for file in workspace.files if file.kind in PYTHON]


def _store(request: Request) -> Store | NullStore:
    from archlint import __version__
    from archlint.syntax.cache import NullStore, Store
    from archlint.syntax.secret import user_key

    key = user_key(request.paths) if request.cached else None
    return NullStore() if key is None else Store(request.settings.cache_folder, __version__, key)


def _compiled(request: Request, workspace: Workspace, store: Store | NullStore) -> FactsOfFiles:
    from archlint.syntax.files import FactsOfFiles

    facts = FactsOfFiles(store, _screen_words, request.jobs)
    facts.prepare(_python(workspace), {package.name for package in workspace.packages if package.catkin_code})
    return facts


def _screen_words() -> tuple[bytes, ...]:
    from archlint.libraries.screen import WORDS  # a run that changes nothing does without the API tables

    return WORDS


def _systems(request: Request, workspace: Workspace, facts: FactsOfFiles, tree: SourceTree) -> list[System]:
    """Link and load."""
    from archlint.launch.load import LaunchLoader
    from archlint.programs.entry_points import entry_points, read_installs
    from archlint.programs.linker import Linker
    from archlint.ros.interfaces import InterfaceTable
    from archlint.systems.instances import assemble
    from archlint.systems.launches import launch_systems
    from archlint.systems.model import World

    faults = Faults()
    installs = read_installs(workspace.packages, workspace.files, facts.facts_of, tree, faults)
    words = {name: one.words for name, one in installs.items()}
    generated = {name: one.generated for name, one in installs.items() if one.generated is not None}
    names = Counter(package.name for package in workspace.packages)
    without = [name for name, one in installs.items() if one.generates_nothing and names[name] == 1]
    interfaces = InterfaceTable(workspace.files, lambda file: tree.text(file.relative), words, generated, without)
    linker = Linker(workspace.files, facts.facts_of, facts.relevant, interfaces, faults)
    entries = entry_points(installs, workspace.files)
    programs = linker.run_all(entries)
    [opened] = assemble(programs, workspace, request.settings)
    old = frozenset(package.name for package in workspace.packages if package.ros1)
    distro = request.settings.distro
    loader = LaunchLoader(workspace.files, facts.facts_of, installs, tree, facts.relevant, faults, old, distro)
    if request.launch is not None and not loader.is_launch_file(request.launch):
        raise NothingToDo(_no_launch_file(request, loader))
    systems = launch_systems(
        opened,
        linker,
        entries,
        loader,
        World(
            installs,
            {package.name: package for package in workspace.packages},
            {package.relative: package for package in workspace.packages},
            loader=loader,
            faults=faults,
            interfaces=interfaces,
            partial=_partial(request, workspace),
            roles=linker.index.roles,
            cut_short=linker.cut_short,
        ),
        closed=request.settings.closed_world,
        chosen=request.launch,
        arguments=dict(request.launch_arguments),
        configured=request.settings.launch,
        distro=distro,
    )
    if not systems:  # only where one launch file was asked for: the open system is always there
        ros1 = loader.frontend(request.launch or "").ros1
        raise NothingToDo(f"{request.launch} {'is for ROS 1' if ros1 else 'starts nothing that can be read'}")
    if request.observed is not None:
        from archlint.analysis.comparison import compare
        from archlint.checks.registry import options_for

        is_external = options_for(request.settings, ["GRF006"])["GRF006"].is_external
        context = {file.relative for file in workspace.files if file.context and request.launch is None}
        systems[0].compared = compare(systems[0], request.observed, is_external, context)
    return systems


def _no_launch_file(request: Request, loader: LaunchLoader) -> str:
    """Why the file of ``--launch`` cannot be launched."""
    for file, line, column, message in loader.problems():
        if file == request.launch:
            return f"{file}:{line}:{column}: {message}"
    return f"{request.launch} is no launch file in {', '.join(request.paths)}"


def _partial(request: Request, workspace: Workspace) -> bool:
    """Whether less is known than the folder that the configuration is for holds."""
    if request.settings.file is None:
        return False
    base = Path(request.settings.file).parent.resolve()
    return not any(base.is_relative_to(Path(folder).resolve()) for folder in workspace.whole)


def _asked_for(request: Request, system: System, workspace: Workspace) -> System:
    """The system as it is shown: whole where a launch file was asked for, else without what is only context."""
    from archlint.systems.shown import only

    if request.launch is not None:
        return system
    return only(system, {file.relative for file in workspace.files if file.context})


def _known(request: Request, workspace: Workspace, facts: FactsOfFiles) -> list[SourceFile]:
    """The Python files that matter, and those that were asked for by name and cannot be compiled."""
    named = {os.path.abspath(path) for path in request.paths}

    def broken(file: SourceFile) -> bool:
        found = facts.facts_of(file) if file.path in named and not facts.is_ros1(file) else None
        return found is not None and bool(found.problems)

    return [file for file in _python(workspace) if facts.relevant(file) or broken(file)]


def _parts(request: Request, workspace: Workspace) -> list[Workspace]:
    """The workspace, or the several that it is, of which those that were asked for; with ``--launch`` the one that
    has the launch file."""
    from archlint.workspace.parts import parts

    found = [part for part in parts(workspace) if any(not file.context for file in part.files)] or [workspace]
    if request.launch is None and request.observed is not None and len(found) > 1:
        folders = ", ".join(sorted(part.root for part in found))
        raise NothingToDo(f"--observed is of one system, and several workspaces stand side by side here: {folders}")
    if request.launch is None or len(found) == 1:
        return found
    return [part for part in found if any(file.relative == request.launch for file in part.files)][:1] or found[:1]


def _together(systems: Sequence[System]) -> System:
    """One system to draw of those of several workspaces."""
    first, *others = systems
    if not others:
        return first
    nodes = sorted((n for one in systems for n in one.nodes), key=lambda n: (n.name is None, n.name or ""))
    return replace(
        first,
        nodes=nodes,
        programs=[program for one in systems for program in one.programs],
        unowned=[entry for one in systems for entry in one.unowned],
        neighbours=[node for one in systems for node in one.neighbours],
    )


def _judged_in_parts(request: Request, workspace: Workspace, facts: FactsOfFiles, tree: SourceTree) -> Judged:
    """What is found in each of the workspaces that stand side by side."""
    _refuse_nothing(request, workspace, facts)
    judged: list[Judged] = []
    refused: NothingToDo | None = None
    for part in _parts(request, workspace):
        try:
            judged.append(_judged(request, part, facts, tree))
        except NothingToDo as error:
            refused = refused or error
    if not judged:
        assert refused is not None
        raise refused
    return judged[0] if len(judged) == 1 else _joined(judged)


def _joined(judged: Sequence[Judged]) -> Judged:
    findings = sorted(dict.fromkeys(f for one in judged for f in one.findings), key=lambda finding: finding.sort_key)
    summary = summarise(
        findings,
        files=sum(one.summary.files for one in judged),
        nodes=sum(one.summary.nodes for one in judged),
        suppressed=sum(one.summary.suppressed for one in judged),
        unresolved=sum(one.summary.unresolved for one in judged),
        elapsed_s=0.0,
    )
    return Judged(findings, summary, list(dict.fromkeys(notice for one in judged for notice in one.notices)))


def _judged(request: Request, workspace: Workspace, facts: FactsOfFiles, tree: SourceTree) -> Judged:
    from archlint.checks.launch_notices import argument_notices
    from archlint.checks.registry import failure, unreadable
    from archlint.engine import suppressions
    from archlint.engine.looked_at import followed_in_part, without_start
    from archlint.engine.merging import folded, merged
    from archlint.observed.words import comparison_notices, comparison_words
    from archlint.render.json import unresolved

    known = _known(request, workspace, facts)
    systems = _systems(request, workspace, facts, tree)
    loader = systems[0].world.loader if systems[0].world is not None else None
    faults = systems[0].world.faults if systems[0].world is not None else Faults()
    imported = [f for f in _python(workspace) if f not in known and facts.was_read(f) and not facts.is_ros1(f)]
    found = [*_problems(workspace, [*known, *imported], facts), *merged(_rules(request.settings, systems))]
    found.extend(_of_interfaces(workspace, systems, faults))
    by_file = {file.relative: one.suppressions for file in known if (one := facts.facts_of(file)) is not None}
    if loader is not None:
        found.extend(unreadable(*problem) for problem in loader.problems())
        by_file.update(loader.suppressions())
    found.extend(failure(fault) for fault in faults.found())
    outcome = suppressions.apply(_wanted(found, request.settings, workspace), by_file)
    stale = suppressions.stale(outcome.unused, _ran(request, systems), Sources().line)
    kept = [*outcome.kept, *suppressions.apply(_wanted(stale, request.settings, workspace), by_file).kept]
    whole = folded(dict.fromkeys(_with_fixes(kept, request, workspace)))
    findings = sorted(whole, key=lambda finding: finding.sort_key)
    shown = [_asked_for(request, systems[0], workspace)]
    summary = summarise(
        findings,
        files=sum(map(_is_input, workspace.files)) or sum(map(_is_of_package, workspace.files)),
        nodes=sum(len(system.nodes) for system in shown),
        suppressed=len(outcome.suppressed),
        unresolved=sum(len(unresolved(system)) for system in shown),
        elapsed_s=0.0,
    )
    refused = [suppressions.refusal(file, suppression) for file, suppression in outcome.refused]
    notices = [*_passed_over(request, workspace, facts, loader)]
    if request.launch is not None:
        notices.extend(argument_notices(systems[0]))
    notices.extend(comparison_notices(systems[0].compared))
    notices.extend(without_start(systems, {file.relative for file in workspace.files if file.context}))
    notices.extend(followed_in_part(systems[0].world.cut_short() if systems[0].world is not None else []))
    remarks = [*comparison_words(systems[0].compared)]
    return Judged(findings, summary, [*refused, *notices, *_idle(request.settings, systems)], remarks)


# --- judging


def _rules(settings: Settings, systems: Sequence[System]) -> Iterator[Finding]:
    from archlint.checks.registry import options_for, registered
    from archlint.engine.judging import judge_alternatives

    selection, checks = settings.selection, registered()
    for system in systems:
        codes = [code for code in selection.codes if selection.runs(code, system.closed)]
        if system.launched is not None and len(systems) > 1:
            codes = [code for code in codes if code in checks and checks[code].scope.of_each_system]
        yield from judge_alternatives(system, options_for(settings, codes))


def _idle(settings: Settings, systems: Sequence[System]) -> list[str]:
    """Parts of the declared architecture that no system has, so that nothing was held against them."""
    from archlint.checks.registry import options_for

    judged = {"ARC001", "ARC002", "ARC003", "OWN003"} & set(settings.selection.codes)
    if not judged or not (settings.contracts or settings.owners or settings.node_layers):
        return []
    from archlint.checks.idle_contracts import idle_patterns

    return list(dict.fromkeys(idle_patterns(systems, options_for(settings, ["ARC003"])["ARC003"])))


def _ran(request: Request, systems: Sequence[System]) -> frozenset[str]:
    """The codes of the rules that judged everything they can judge."""
    from archlint.checks.registry import registered
    from archlint.checks.scope import Scope

    if request.launch is not None:
        return frozenset()
    closed = any(system.closed for system in systems)
    selection = request.settings.selection
    running = frozenset(code for code, check in registered().items() if check.scope is Scope.RUNNING)
    unheld = frozenset() if request.observed is not None else running
    return frozenset(code for code in selection.codes if selection.runs(code, closed)) - unheld


def _with_fixes(findings: Sequence[Finding], request: Request, workspace: Workspace) -> Sequence[Finding]:
    """The findings with their fixes; one more for each fix that cannot be made by a fault of ours."""
    from archlint.checks.registry import failure
    from archlint.rulebook import rules

    if not any(rules()[finding.code].fix for finding in findings):
        return findings
    from archlint.fixes import Surroundings, attach

    faults = Faults()
    files = [file.path for file in _python(workspace)]
    fixed = attach(findings, Surroundings(request.settings.distros, files), faults)
    return [*fixed, *map(failure, faults.found())]


def _problems(workspace: Workspace, files: Sequence[SourceFile], facts: FactsOfFiles) -> Iterator[Finding]:
    """What could not be read: LNT002, or LNT003 where the fault is ours."""
    from archlint.checks.registry import unreadable

    old = tuple(f"{package.relative}/" for package in workspace.packages if package.catkin_code)
    for problem in workspace.problems:
        if not problem.file.startswith(old):
            yield unreadable(problem.file, problem.line, problem.column, problem.message, problem.help)
    for file in files:
        found = facts.facts_of(file)
        if found is None or not found.problems:
            continue
        importers = _importers(file, files, facts) if file.context else ()
        for fault in found.problems:
            one = unreadable(file.relative, fault.line, fault.column, fault.message)
            yield replace(one, related=tuple(Related(place, "it is imported here") for place in importers))


def _of_interfaces(workspace: Workspace, systems: Sequence[System], faults: Faults) -> Iterator[Finding]:
    """One LNT002 for an interface file that rosidl would refuse."""
    from archlint.checks.registry import unreadable_interface
    from archlint.syntax.interfaces import interface_problems

    table = systems[0].world.interfaces if systems[0].world is not None else None
    old = {package.name for package in workspace.packages if package.ros1}
    for file in workspace.files:
        if file.kind == "interface" and not file.context and file.package not in old:
            with faults.apart("reading this interface", Place(file.relative, 1, 1, 1, 1)):
                problems = interface_problems(file.path)
                if problems:
                    yield unreadable_interface(file.relative, problems, table is None or table.is_built(file))


def _importers(module: SourceFile, files: Sequence[SourceFile], facts: FactsOfFiles) -> list[Place]:
    """Where the files that were asked for import one that was not."""
    asked = (file for file in files if not file.context)
    rows = [(file.relative, span) for file in asked if (span := facts.imports_of(file, module)) is not None]
    return [Place.of(file, span) for file, span in rows[:_FEW]]


_FEW = 3
"""How many places that import a broken module are told."""


def _wanted(findings: Iterable[Finding], settings: Settings, workspace: Workspace) -> Iterator[Finding]:
    """The findings that the configuration does not turn off, with the severities that it wants."""
    from archlint.config.filters import Filters

    filters = Filters(settings, workspace)
    for finding in findings:
        wanted = filters.apply(finding)
        if wanted is not None:
            yield wanted

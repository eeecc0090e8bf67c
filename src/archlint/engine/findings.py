"""Everything that the selected rules find in a workspace: judge, suppress, fold, sort."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING

from archlint.analysis.source_code import code_of
from archlint.checks.folding import with_others
from archlint.checks.idle_contracts import idle_patterns
from archlint.checks.launch_notices import argument_notices
from archlint.checks.registry import failure, registered, unreadable, unreadable_interface
from archlint.checks.scope import Scope
from archlint.config.filters import Filters
from archlint.config.options import options_for
from archlint.engine import suppressions, uninstalled
from archlint.engine.broken_packages import broken_packages
from archlint.engine.copies import once_for_copied_code, once_for_copies, once_for_twins
from archlint.engine.half_ported import as_information, half_ported, with_reason
from archlint.engine.inputs import Inputs, is_input, is_of_package, known_files, parts_of, python_files
from archlint.engine.judging import judge_alternatives
from archlint.engine.kept_summaries import keep_summaries, kept_summaries
from archlint.engine.kept_words import kept_words
from archlint.engine.known import Sieve
from archlint.engine.languages import for_their_languages
from archlint.engine.launched_code import launched_files
from archlint.engine.loading import as_asked_for, systems_of
from archlint.engine.looked_at import followed_in_part, started_elsewhere, without_start
from archlint.engine.merging import folded, merged
from archlint.engine.passed_over import passed_over
from archlint.engine.repeats import once_for_copied_lines
from archlint.engine.request import NothingToDo, Request
from archlint.engine.second_lines import without_second_lines
from archlint.engine.stale_entries import Judgement, stale_entry
from archlint.engine.summaries_ahead import SummariesAhead
from archlint.engine.unreached import without_unreached
from archlint.engine.unread_data import is_manifest_to_fill, is_to_be_filled_in, unread_data, with_its_reason
from archlint.engine.unused_files import apart, count_of_files, unused_files
from archlint.engine.vendored_packages import without_vendored
from archlint.faults import Faults
from archlint.finding import Place, Related
from archlint.observed.words import comparison_notices, comparison_words
from archlint.render.json import unresolved
from archlint.report.model import Judged, recounted, summarise
from archlint.syntax.interfaces import interface_problems
from archlint.syntax.launch_xml import suppressions_of_xml
from archlint.syntax.statements import Function
from archlint.systems.model import WorkspaceIndex

if TYPE_CHECKING:
    from archlint.checks.registry import Options
    from archlint.config.settings import Settings
    from archlint.engine.memory import Memory
    from archlint.finding import Finding
    from archlint.syntax.facts import Suppression
    from archlint.syntax.files import FactsOfFiles
    from archlint.systems.model import System
    from archlint.workspace.model import SourceFile, Workspace
    from archlint.workspace.tree import SourceTree


def judged_in_parts(
    inputs: Inputs,
    facts: FactsOfFiles,
    shown: list[System] | None = None,
    loaded: list[list[System]] | None = None,
) -> Judged:
    """What is found in each of the workspaces that stand side by side.  ``shown`` is given the system of each, unless
    there is nothing to do for one of them; ``loaded`` all systems of each."""
    request = inputs.request
    inputs = replace(inputs, summaries=kept_summaries(inputs, facts))
    words = kept_words(inputs, facts)
    sieve = Sieve(request.baseline, request.before)
    ran: list[frozenset[str]] = []
    judged: list[Judged] = []
    systems: list[System] = []
    refused: NothingToDo | None = None
    parts = parts_of(inputs.request, inputs.workspace)
    for part in parts:
        try:
            result, system, every = _judged(replace(inputs, workspace=part), facts, sieve, ran, len(parts) > 1)
        except NothingToDo as error:
            refused = refused or error
        else:
            judged.append(result)
            systems.append(system)
            if loaded is not None:
                loaded.append(every)
    if not judged:
        assert refused is not None
        raise refused
    if shown is not None and refused is None:
        shown.extend(systems)
    if facts.lasting:
        keep_summaries(inputs.summaries, inputs)
        if words is not None:
            words.keep()
    joined = _without_repeats(judged[0] if len(parts) == 1 else _joined(judged, inputs), inputs)
    if request.occurrences:
        joined = replace(joined, occurrences=sieve.occurrences)
    return joined if request.baseline is None else _with_stale(joined, inputs, sieve, frozenset.intersection(*ran))


def _with_stale(judged: Judged, inputs: Inputs, sieve: Sieve, ran: frozenset[str]) -> Judged:
    """The findings with one for each entry of the baseline that holds back nothing."""
    baseline = inputs.request.baseline
    assert baseline is not None
    stale = list(Judgement(ran, judged.findings).stale(sieve.idle(), inputs))
    rows = _wanted((stale_entry(entry, baseline.file) for entry in stale), inputs.request.settings, inputs.workspace)
    findings = sorted((*judged.findings, *rows), key=lambda finding: finding.sort_key)
    summary = recounted(judged.summary, findings)
    return replace(judged, findings=findings, summary=summary, idle=[entry.line for entry in stale])


def _joined(judged: Sequence[Judged], inputs: Inputs) -> Judged:
    every = folded(dict.fromkeys(finding for part in judged for finding in part.findings))
    every.sort(key=lambda finding: finding.sort_key)
    findings = once_for_copies(every, inputs.workspace.packages, inputs.tree.lines)
    summary = summarise(
        findings,
        files=sum(part.summary.files for part in judged),
        nodes=sum(part.summary.nodes for part in judged),
        suppressed=sum(part.summary.suppressed for part in judged),
        unresolved=sum(part.summary.unresolved for part in judged),
        elapsed_s=0.0,
        baselined=sum(part.summary.baselined for part in judged),
        older=sum(part.summary.older for part in judged),
        unused=sum(part.summary.unused for part in judged),
        unused_files=sum(part.summary.unused_files for part in judged),
        vendored=sum(part.summary.vendored for part in judged),
        unreached=sum(part.summary.unreached for part in judged),
    )
    notices = list(dict.fromkeys(notice for part in judged for notice in part.notices))
    return Judged(findings, summary, notices, launched=[file for part in judged for file in part.launched])


def _judged(
    inputs: Inputs, facts: FactsOfFiles, sieve: Sieve, ran: list[frozenset[str]], is_a_part: bool
) -> tuple[Judged, System, list[System]]:
    """What is found in a workspace and not known yet, its system as it is shown, and all its systems; the rules that
    judged all of it are added to ``ran``."""
    request, workspace = inputs.request, inputs.workspace
    known = known_files(request, workspace, facts)
    systems = _loaded(inputs, facts, known)
    index = systems[0].workspace or WorkspaceIndex()
    faults, launch_files = index.faults, index.launch_files
    to_report = [*known, *_imported(workspace, known, facts)]
    judged_by_rules = for_their_languages(_rules(request, systems, inputs.memory))
    candidates = [*_problems(workspace, to_report, facts, inputs.tree), *merged(judged_by_rules)]
    candidates.extend([*_of_interfaces(workspace, systems, inputs.tree, faults), *unread_data(index, workspace)])
    candidates.extend(unreadable(*problem) for problem in launch_files.problems())
    by_file = _of_code(workspace, known, facts) | launch_files.suppressions()
    by_file.update(_of_manifests(workspace, inputs.tree))
    candidates.extend(failure(fault) for fault in faults.by_place())
    skipped = {file.relative for file in python_files(workspace) if facts.is_ros1(file)}
    candidates = [with_its_reason(each, inputs.tree) for each in candidates if each.place.file not in skipped]
    unused = unused_files(index, candidates, request)
    old = half_ported(workspace, known, facts)
    aside = uninstalled.files_of(index, candidates)
    candidates = uninstalled.as_information(as_information(candidates, old), aside)
    candidates = uninstalled.without_dead_ends(candidates, aside, index)
    outcome = suppressions.apply(_wanted(candidates, request.settings, workspace), by_file)
    ran.append(_ran(request, systems))
    stale = suppressions.stale(outcome.unused, ran[-1])
    about = _wanted([*stale, *suppressions.without_reason(by_file)], request.settings, workspace)
    kept = [*without_second_lines(index, outcome.kept), *suppressions.apply(about, by_file).kept]
    sifted = sieve.part(dict.fromkeys(kept), {file.relative for file in workspace.files})
    new, vendored, hidden, unreached = _shown_and_not(index, sifted.new, unused, aside, request)
    explained = uninstalled.once_for_a_file(with_reason(folded(new, in_a_part=is_a_part), old), aside)
    findings = _without_copies(inputs, facts, index, explained)
    shown = as_asked_for(request, systems[0], workspace)
    summary = summarise(
        findings,
        files=sum(map(is_input, workspace.files)) or sum(map(is_of_package, workspace.files)),
        nodes=len(shown.nodes),
        suppressed=len(outcome.suppressed),
        unresolved=len(unresolved(shown)),
        elapsed_s=0.0,
        baselined=len(folded(sifted.baselined)),
        older=len(folded(sifted.older)),
        unused=len(folded(hidden)),
        unused_files=count_of_files(hidden, unused | aside),
        vendored=len(folded(vendored)),
        unreached=len(folded(unreached)),
    )
    refused = [suppressions.refusal(file, suppression) for file, suppression in outcome.refused]
    notices = [*passed_over(workspace, request.paths, facts, launch_files), *_of_systems(request, workspace, systems)]
    notices.extend(followed_in_part(index.cut_short()))
    said = [*refused, *notices, *_idle(request.settings, systems)]
    judged = Judged(findings, summary, said, remarks=[*comparison_words(systems[0].compared)])
    return replace(judged, launched=launched_files(systems, findings)), shown, systems


def _shown_and_not(
    index: WorkspaceIndex,
    findings: Sequence[Finding],
    unused: frozenset[str],
    aside: frozenset[str],
    request: Request,
) -> tuple[list[Finding], list[Finding], list[Finding], list[Finding]]:
    """The findings that are shown, and those in packages of others, in unused files and in code that is not reached."""
    own, vendored = without_vendored(index, findings, request)
    in_use, hidden = apart(index, own, unused)
    met, unreached = without_unreached(index, in_use, request)
    shown, waits = uninstalled.without_waits(met, aside, request)
    return shown, vendored, [*hidden, *waits], unreached


def _without_repeats(judged: Judged, inputs: Inputs) -> Judged:
    """The findings with one for lines that were copied; who wants to see all files wants to see those, too."""
    if inputs.request.settings.unused_files:
        return judged
    packaged = {file.relative for file in inputs.workspace.files if file.package is not None}
    findings = once_for_copied_lines(judged.findings, packaged, inputs.tree.lines)
    return replace(judged, findings=findings, summary=recounted(judged.summary, findings))


def _loaded(inputs: Inputs, facts: FactsOfFiles, known: Sequence[SourceFile]) -> list[System]:
    """The systems, and what rules ask of single files, as far as processes say that ahead."""
    ahead = SummariesAhead(inputs.request, known)
    try:
        systems = systems_of(inputs, facts, ahead.begin)
        ahead.finish(systems[0].workspace or WorkspaceIndex())
    finally:
        ahead.close()
    return systems


def _of_systems(request: Request, workspace: Workspace, systems: Sequence[System]) -> Iterator[str]:
    """What is to be said of the systems beside the findings."""
    if request.launch is not None:
        yield from argument_notices(systems[0])
        yield from started_elsewhere(request, systems[0], workspace)
    yield from comparison_notices(systems[0].compared)
    yield from without_start(systems, {file.relative for file in workspace.files if file.context})


def _without_copies(
    inputs: Inputs, facts: FactsOfFiles, index: WorkspaceIndex, findings: Iterable[Finding]
) -> list[Finding]:
    """The findings with one for what copies show; who wants to see all files wants to see those that were changed."""
    if inputs.request.settings.unused_files:
        return once_for_twins(findings, _contents(inputs.workspace, facts))
    return once_for_copied_code(findings, index.package_of, partial(_code_around, index, inputs.tree))


def _code_around(index: WorkspaceIndex, tree: SourceTree, place: Place) -> tuple[str, int] | None:
    """The text of the function around a place and the line where it begins; of the file, where it is in none."""
    code = code_of(index)
    statement = code.statement_at(place)
    function = statement if isinstance(statement, Function) else code.function_at(place)
    if function is None:
        text = tree.text(place.file)
        return None if text is None else (text, 1)
    first, last = function.span[0], function.span[2]
    return "\n".join(tree.lines(place.file, first, last)), first


def _contents(workspace: Workspace, facts: FactsOfFiles) -> dict[str, tuple[str, str]]:
    """The package of each file that is in one, and a digest of its content."""
    return {
        file.relative: (file.package, digest)
        for file in workspace.files
        if file.package is not None and (digest := facts.digest(file)) is not None
    }


def _of_code(
    workspace: Workspace, known: Sequence[SourceFile], facts: FactsOfFiles
) -> dict[str, Sequence[Suppression]]:
    """The suppressions in the code of a workspace, by the files that they are in."""
    files = [*known, *(file for file in workspace.of_kind("cpp") if facts.relevant(file))]
    return {file.relative: read.suppressions for file in files if (read := facts.facts_of(file)) is not None}


def _imported(workspace: Workspace, known: Sequence[SourceFile], facts: FactsOfFiles) -> Iterator[SourceFile]:
    """The files that were read beside those that were asked for, and the packages that cannot be imported."""
    own = {file.path for file in known}
    others = (file for file in python_files(workspace) if file.path not in own)
    yield from (file for file in others if facts.was_read(file) and not facts.is_ros1(file))
    yield from broken_packages(python_files(workspace), facts)


def _rules(request: Request, systems: Sequence[System], memory: Memory | None = None) -> Iterator[Finding]:
    settings, checks = request.settings, registered()
    selection = settings.selection
    judge = partial(judge_alternatives, monitor=request.monitor)
    request.monitor.judging(len(systems))
    options: dict[tuple[bool, bool], Mapping[str, Options]] = {}
    for system in systems:
        is_one_of_several = system.launched is not None and len(systems) > 1
        kind = system.closed, is_one_of_several
        if kind not in options:
            codes = [code for code in selection.codes if selection.runs(code, system.closed)]
            if is_one_of_several:
                codes = [code for code in codes if code in checks and checks[code].scope.of_each_system]
            options[kind] = options_for(settings, codes)
        selected = options[kind]
        if memory is None:
            yield from judge(system, selected)
        else:
            yield from memory.judged(system, selected, judge)
        request.monitor.judged()


def _idle(settings: Settings, systems: Sequence[System]) -> list[str]:
    """Parts of the declared architecture that no system has, so that nothing was held against them."""
    judged = {"ARC001", "ARC002", "ARC003", "OWN003"} & set(settings.selection.codes)
    if not judged or not (settings.contracts or settings.owners or settings.node_layers):
        return []

    return list(dict.fromkeys(idle_patterns(systems, options_for(settings, ["ARC003"])["ARC003"])))


def _ran(request: Request, systems: Sequence[System]) -> frozenset[str]:
    """The codes of the rules that judged everything they can judge."""
    if request.launch is not None:
        return frozenset()
    closed = any(system.closed for system in systems)
    selection = request.settings.selection
    running = frozenset(code for code, check in registered().items() if check.scope is Scope.RUNNING)
    unheld = frozenset() if request.observed is not None else running
    return frozenset(code for code in selection.codes if selection.runs(code, closed)) - unheld


def _problems(
    workspace: Workspace, files: Sequence[SourceFile], facts: FactsOfFiles, tree: SourceTree
) -> Iterator[Finding]:
    """What could not be read: LNT002, or LNT003 where the fault is ours."""
    old = tuple(f"{package.relative}/" for package in workspace.packages if package.catkin_code)
    for problem in workspace.problems:
        if not problem.file.startswith(old) and not is_manifest_to_fill(problem.file, tree):
            place = problem.file, problem.line, problem.column
            yield unreadable(*place, problem.message, help=problem.help, leads_out=problem.leads_out)
    sources = (file for file in workspace.of_kind("cpp") if facts.relevant(file) and not file.context)
    for file in (*files, *sources):
        read = facts.facts_of(file)
        if read is None or not read.problems:
            continue
        importers = _importers(file, files, facts) if file.context else ()
        for fault in (fault for fault in read.problems if not (fault.partly and is_to_be_filled_in(file.relative))):
            advice = _IF_IT_COMPILES if fault.partly else None
            finding = unreadable(file.relative, fault.line, fault.column, fault.message, fault.internal, help=advice)
            if read.body and not fault.partly and not fault.internal:
                finding = replace(finding, help=_PARTLY_READ)
            yield replace(finding, related=tuple(Related(place, "it is imported here") for place in importers))


def _of_manifests(workspace: Workspace, tree: SourceTree) -> Iterator[tuple[str, list[Suppression]]]:
    """What each ``package.xml`` suppresses in place."""
    for package in workspace.packages:
        file = package.manifest.relative
        if not package.ros1 and (comments := suppressions_of_xml(tree.text(file) or "")):
            yield file, comments


def _of_interfaces(
    workspace: Workspace, systems: Sequence[System], tree: SourceTree, faults: Faults
) -> Iterator[Finding]:
    """One LNT002 for the interface files of a package that rosidl refuses for the same reason, if the build of the
    package gives them to rosidl."""
    alike: dict[tuple[str | None, str], list[Finding]] = {}
    table = systems[0].workspace.interfaces if systems[0].workspace is not None else None
    old = {package.name for package in workspace.packages if package.ros1}
    for file in workspace.files:
        if file.kind == "interface" and not file.context and file.package not in old:
            with faults.contained("reading this interface", Place(file.relative, 1, 1, 1, 1)):
                problems = interface_problems(file.path, tree.given(file.relative))
                if problems and (table is None or table.is_built(file)):
                    told = unreadable_interface(file.relative, problems)
                    alike.setdefault((file.package, told.message), []).append(told)
    for row in alike.values():
        yield with_others(row, "another file has", "more files have", "the same") if len(row) > 1 else row[0]


def _importers(module: SourceFile, files: Sequence[SourceFile], facts: FactsOfFiles) -> list[Place]:
    """Where the files that were asked for import one that was not."""
    asked = (file for file in files if not file.context)
    rows = [(file.relative, span) for file in asked if (span := facts.imports_of(file, module)) is not None]
    return [Place.of(file, span) for file, span in rows[:_FEW]]


_PARTLY_READ = "correct it: until then part of this file is not checked"
_IF_IT_COMPILES = "correct the code around it; if it compiles, report it as a limit of archlint"
_FEW = 3
"""How many places that import a broken module are reported."""


def _wanted(findings: Iterable[Finding], settings: Settings, workspace: Workspace) -> Iterator[Finding]:
    """The findings that the configuration does not turn off, with the severities that it wants."""
    filters = Filters(settings, workspace)
    for finding in findings:
        wanted = filters.apply(finding)
        if wanted is not None:
            yield wanted

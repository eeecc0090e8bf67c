"""One run of archlint, top to bottom: find, compile, link, load, judge, suppress, sort."""

from __future__ import annotations

import time
from collections.abc import Iterator, Sequence
from contextvars import copy_context
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint import __version__
from archlint.engine.drawn import Drawn
from archlint.engine.inputs import Inputs, find_files, is_subset, parts_of, refuse_nothing, tree_of
from archlint.engine.looked_at import around, idle_patterns, ignored_sources, without_node, without_plugins
from archlint.engine.request import NothingToDo, Request
from archlint.engine.result_cache import Result, RunCache
from archlint.engine.sources import Sources
from archlint.render import FORMATS, FormatName
from archlint.report.model import Judged, Report, Summary
from archlint.syntax.cache import NullStore, Store
from archlint.syntax.python.deep_stack import call_with_deep_stack
from archlint.syntax.secret import user_key

if TYPE_CHECKING:
    from archlint.finding import Finding
    from archlint.render.page.model import SourceLink
    from archlint.render.view import View
    from archlint.syntax.files import FactsOfFiles
    from archlint.systems.model import System
    from archlint.workspace.model import Workspace
    from archlint.workspace.tree import SourceTree
__all__ = ["NothingToDo", "Request", "asked_for", "check", "draw", "graph", "systems"]


def check(request: Request, shown: list[System] | None = None) -> Report:
    """Everything that the selected rules find, in order.  ``shown`` is given the systems that :func:`graph` would
    combine, where the run makes them.  Raises :class:`NothingToDo`."""
    return copy_context().run(_check, request, shown)  # the rules of its plugins are there for this run only


def _check(request: Request, shown: list[System] | None) -> Report:
    request.settings.activate_plugins()
    started = time.perf_counter()
    if request.keeper is not None:
        request.keeper.starts(request.paths, request.settings)
    workspace = call_with_deep_stack(lambda: find_files(request))
    inputs = _inputs(request, workspace)
    kept = RunCache(inputs, Judged)
    judged = kept.load()
    if judged is None:
        from archlint.engine.compiling import compiled  # a check with a known result needs none of it

        facts = compiled(request, workspace, inputs.store)
        judged = kept.load_again(facts) or _alike(kept, facts)
        if judged is None:
            refuse_nothing(request, workspace, facts)
            from archlint.engine.findings import judged_in_parts  # all the rules, and what runs the code

            judged = call_with_deep_stack(lambda: judged_in_parts(inputs, facts, shown))
            if facts.lasting and not any(finding.code == "LNT003" for finding in judged.findings):
                kept.save(judged, facts)
    if request.fixes and not judged.mended and any(finding.sites is not None for finding in judged.findings):
        judged = _mended(judged, inputs, kept)
    _refuse_gaps(request)
    _tell_keeper(inputs, kept)
    inputs.store.close()
    elapsed = time.perf_counter() - started
    summary = replace(judged.summary, elapsed_s=elapsed)
    notices = [*judged.notices, *_not_looked_at(request, workspace, summary)]
    return Report(
        judged.findings,
        summary,
        Sources(inputs.tree.given, inputs.tree.base, workspace.inside).line,
        notices,
        remarks=[*judged.remarks, *around(request.paths, workspace)],
        occurrences=judged.occurrences,
        idle=judged.idle,
        launched=judged.launched,
        inside=workspace.inside,
        packages={file.relative: file.package for file in workspace.files if file.package is not None},
    )


def _alike(kept: RunCache[Judged], facts: FactsOfFiles) -> Judged | None:
    """The result of a run over files of which only the texts differ.  Its fixes are made anew: they are edits of these
    texts."""
    judged = kept.load_alike(facts)
    if judged is None:
        return None
    judged = judged.unmended()
    kept.save_again(judged)
    return judged


def _mended(judged: Judged, inputs: Inputs, kept: RunCache[Judged]) -> Judged:
    from archlint.engine.mending import mended  # most checks ask for no fixes, or know them

    result = mended(judged, inputs)
    if not any(finding.code == "LNT003" for finding in result.findings):
        kept.save_again(result)
    return result


def _not_looked_at(request: Request, workspace: Workspace, summary: Summary) -> Iterator[str]:
    yield from without_node(summary)
    yield from ignored_sources(workspace)
    yield from without_plugins(request.settings)
    if request.settings.file is not None and not is_subset(request, workspace):
        yield from idle_patterns(request.settings, workspace)


def graph(request: Request, everything: bool = False) -> System:
    """The system of all nodes, for drawing; ``everything`` adds what rclpy makes for every node.

    Raises :class:`NothingToDo`.
    """
    from archlint.engine.compiling import compiled  # as above: `check` does without them where it can

    workspace = find_files(request)
    inputs = _inputs(request, workspace)
    facts = compiled(request, workspace, inputs.store)
    system = _graph(inputs, facts, everything)
    inputs.store.close()
    return system


def systems(request: Request) -> list[System]:
    """What rules judge: the open system of each workspace that was asked for, each with what its launch files start.

    Raises :class:`NothingToDo`.
    """
    return [system for _, of_part in _systems_of_parts(request) for system in of_part]


def asked_for(request: Request) -> list[System]:
    """As :func:`systems`, without what was only read as context: nodes, and launch files.

    Raises :class:`NothingToDo`.
    """
    from archlint.engine.loading import as_asked_for  # as above

    shown: list[System] = []
    for part, of_part in _systems_of_parts(request):
        context = {file.relative for file in part.files if file.context}
        for system in of_part:
            if system.name is None:
                shown.append(as_asked_for(request, system, part))
            elif request.launch is not None or system.name not in context:
                shown.append(system)
    return shown


def _systems_of_parts(request: Request) -> list[tuple[Workspace, list[System]]]:
    from archlint.engine.compiling import compiled  # as above
    from archlint.engine.drawing import faults_of
    from archlint.engine.loading import systems_of

    if request.keeper is not None:
        request.keeper.starts(request.paths, request.settings)
    workspace = find_files(request)
    inputs = _inputs(request, workspace)
    facts = compiled(request, workspace, inputs.store)
    refuse_nothing(request, workspace, facts)
    parts = parts_of(request, workspace)
    loaded = call_with_deep_stack(lambda: [systems_of(replace(inputs, workspace=part), facts) for part in parts])
    inputs.store.close()
    faults = [fault for of_part in loaded for system in of_part for fault in faults_of(system)]
    if request.keeper is not None and facts.lasting and not faults:
        request.keeper.lasts(workspace, _asked(inputs.tree), inputs.store)
    return list(zip(parts, loaded, strict=True))


def _asked(tree: SourceTree) -> Iterator[tuple[str, str, str | None]]:
    """What was asked of the disk; whoever looks at the systems may ask more, so this is for the end of a command."""
    yield from ((question, path, answer) for (question, path), answer in tree.asked.items())


def draw(request: Request, format: FormatName, color: bool, view: View, source_link: SourceLink | None = None) -> Drawn:
    """The system of all nodes in one of :data:`archlint.render.FORMATS`, with what is found in it where the format
    shows that, and with the systems of launch files where it has room for them.

    Raises :class:`NothingToDo`, :class:`archlint.render.errors.CannotDraw` and
    :class:`archlint.render.selection.NothingOfThatName`.
    """
    return copy_context().run(_draw, request, format, color, view, source_link)


def _draw(request: Request, format: FormatName, color: bool, view: View, source_link: SourceLink | None) -> Drawn:
    request.settings.activate_plugins()
    if request.keeper is not None:
        request.keeper.starts(request.paths, request.settings)
    workspace = find_files(request)
    inputs = _inputs(request, workspace)
    kept = RunCache(inputs, Drawn, format, color, view)
    lasts = not FORMATS[format].drawn  # a picture depends on the Graphviz that is installed
    result = kept.load() if lasts else None
    if result is None:
        from archlint.engine.compiling import compiled
        from archlint.engine.drawing import drawn

        facts = compiled(request, workspace, inputs.store)
        result = (kept.load_again(facts) or kept.load_alike(facts)) if lasts else None
        if result is None and FORMATS[format].of == "all systems":
            from archlint.engine.paging import page  # all the rules

            refuse_nothing(request, workspace, facts)
            result = page(inputs, facts, view, source_link)
        elif result is None:
            system, findings = _marked(inputs, facts, format, view.everything)
            result = drawn(system, format, color, view, findings)
            if lasts and facts.lasting and not result.faults:
                kept.save(result, facts)
    _refuse_gaps(request)
    _tell_keeper(inputs, kept)
    inputs.store.close()
    return result


def _marked(
    inputs: Inputs, facts: FactsOfFiles, format: FormatName, everything: bool
) -> tuple[System, Sequence[Finding]]:
    """The system, and what is found in it where a format shows that: by an equal check, if its result is kept."""
    if not FORMATS[format].shows_findings:
        return _graph(inputs, facts, everything), ()
    kept = RunCache(inputs, Judged)
    judged = kept.load() or kept.load_again(facts)
    if judged is not None:
        return _graph(inputs, facts, everything), judged.findings
    from archlint.engine.findings import judged_in_parts  # all the rules
    from archlint.engine.loading import combined

    refuse_nothing(inputs.request, inputs.workspace, facts)
    shown: list[System] = []
    judged = call_with_deep_stack(lambda: judged_in_parts(inputs, facts, shown))
    if not shown:  # there is nothing to do in one of several workspaces
        return _graph(inputs, facts, everything), judged.findings
    return _complete(inputs.request, combined(shown), everything), judged.findings


def _refuse_gaps(request: Request) -> None:
    """Raises :class:`NothingToDo` where facts that were given lack what was asked for: no result is better than a wrong
    one."""
    missed = [] if request.linked is None else sorted(request.linked.tree.missed)
    if missed:
        more = f" and {len(missed) - 1} more" if len(missed) > 1 else ""
        raise NothingToDo(f"the facts do not hold the content of {missed[0]}{more}, which is needed: check the sources")


def _tell_keeper(inputs: Inputs, kept: RunCache[Result]) -> None:
    keeper = inputs.request.keeper
    if keeper is not None and kept.asked is not None:
        keeper.lasts(inputs.workspace, kept.asked, inputs.store)


def _graph(inputs: Inputs, facts: FactsOfFiles, everything: bool) -> System:
    from archlint.engine.loading import as_asked_for, combined, systems_of

    request = inputs.request
    refuse_nothing(request, inputs.workspace, facts)
    parts = parts_of(request, inputs.workspace)
    opened = call_with_deep_stack(
        lambda: [systems_of(replace(inputs, workspace=part), facts)[0] for part in parts],
    )
    system = combined(
        [as_asked_for(request, opened_system, part) for opened_system, part in zip(opened, parts, strict=True)]
    )
    return _complete(request, system, everything)


def _complete(request: Request, system: System, everything: bool) -> System:
    """With what rclpy makes for every node, where that was asked for."""
    from archlint.systems.implicit import with_implicit

    return with_implicit(system, request.settings.distro) if everything else system


def _inputs(request: Request, workspace: Workspace) -> Inputs:
    return Inputs(request, workspace, tree_of(request, workspace), store_of(request))


def store_of(request: Request) -> Store | NullStore:
    """Where results are kept; nowhere without a key of the user's own."""
    if request.store is not None:
        return request.store
    key = user_key(request.paths) if request.cached else None
    return NullStore() if key is None else Store(request.settings.cache_folder, __version__, key)

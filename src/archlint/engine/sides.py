"""The two sides of ``archlint diff``: a revision, a folder, the working tree or a saved graph, each as graphs."""

from __future__ import annotations

import os
from collections.abc import Sequence
from contextvars import copy_context
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.comparing.graphs import Graph, UnreadableGraph, graph_of, read_graph
from archlint.engine.compiling import compiled
from archlint.engine.findings import judged_in_parts
from archlint.engine.git import GitError, Repository, repository_of
from archlint.engine.inputs import Inputs, find_files, refuse_nothing, tree_of
from archlint.engine.loading import as_asked_for, combined
from archlint.engine.old_request import commit_of, old_request, paths_there, working_in
from archlint.engine.old_tree import old_tree
from archlint.engine.pipeline import store_of
from archlint.engine.request import NothingToDo, Request
from archlint.engine.surroundings import Surroundings, folder_of
from archlint.records import dataclass
from archlint.render.json import document
from archlint.report.occurrence import Occurrence
from archlint.syntax.python.deep_stack import call_with_deep_stack
from archlint.workspace.discovery import PathNotFound

if TYPE_CHECKING:
    from archlint.finding import Finding
    from archlint.syntax.cache import NullStore, Store
    from archlint.systems.model import System


class NoSide(Exception):
    """What cannot be compared; ``str()`` says why."""


@dataclass(frozen=True)
class Met:
    """A finding, and what it is about."""

    finding: Finding
    occurrence: Occurrence


@dataclass(frozen=True)
class Side:
    """One side, with the system of all nodes first and then those of launch files.

    ``findings`` is None for a saved graph, which has none; ``commit`` is that of a revision.
    """

    shown: str
    graphs: Sequence[Graph]
    findings: Sequence[Met] | None = None
    commit: str | None = None
    notices: tuple[str, ...] = ()
    is_empty: bool = False
    """Whether there is nothing there that archlint reads."""


def of_file(path: str) -> Side:
    """A saved graph.  Raises :class:`NoSide`."""
    try:
        with open(path, "rb") as stream:
            graph = read_graph(stream.read())
    except OSError as error:
        raise NoSide(f"{path} cannot be read: {error.strerror}") from None
    except UnreadableGraph as error:
        raise NoSide(f"{path}: {error}") from None
    return Side(path, [graph])


def of_request(request: Request, shown: str) -> Side:
    """What lies in the paths of a request.  Raises :class:`NothingToDo`."""
    graphs, findings = _analysed(request)
    return Side(shown, graphs, findings)


def of_folder(request: Request, folder: str) -> Side:
    """A folder; the paths of the request are seen from it, and so is what is shown of it."""
    with working_in(os.path.abspath(folder)):
        return of_request(request, folder)


def of_revision(request: Request, revision: str, fork: bool) -> Side:
    """A revision of the repository that the paths of a request lie in, with the configuration of the working tree.
    With ``fork`` the commit is that at which the history of the working tree leaves the revision.

    Raises :class:`NoSide`.
    """
    try:
        return _of_revision(request, revision, fork)
    except GitError as error:
        raise NoSide(str(error)) from None
    except OSError as error:
        raise NoSide(f"{revision} cannot be read: {error.strerror}") from None


def _of_revision(request: Request, revision: str, fork: bool) -> Side:
    repository = repository_of(dict.fromkeys(folder_of(path) for path in request.paths))
    commit, notices = _commit(repository, revision, fork)
    surroundings = Surroundings(request, repository)
    store = store_of(request)
    with old_tree() as tree:
        tree.write(repository, commit)
        surroundings.add_to(tree)
        old = old_request(request, tree, store)
        here = tree.place(os.getcwd())
        with working_in(here):
            graphs, findings = _analysed_if_there(old)
        notices += [
            f"the submodule {os.path.relpath(folder)} is compared as it is now: this clone does not have its content "
            f"at {revision}"
            for folder in tree.kept
        ]
    store.close()
    empty = not graphs
    return Side(revision, graphs or [_NOTHING], findings, commit, tuple(notices), empty)


_NOTHING = Graph(1, None, [], [], [])


def _commit(repository: Repository, revision: str, fork: bool) -> tuple[str, list[str]]:
    commit = commit_of(repository, revision)
    head = repository.commit("HEAD") if fork else None
    start = None if head is None else repository.fork(commit, head)
    if not fork or start == commit:
        return commit, []
    if start is not None:
        return start, [f"compared with {start[:12]}, where this branch left {revision}"]
    why = "this clone is shallow" if repository.is_shallow else "they have no common history"
    return commit, [f"where HEAD and {revision} part is not known ({why}), so it is compared with {revision}"]


def _analysed_if_there(request: Request) -> tuple[list[Graph], list[Met]]:
    present = paths_there(request)
    if not present:
        return [], []
    try:
        return _analysed(replace(request, paths=present))
    except (NothingToDo, PathNotFound):
        return [], []


def _analysed(request: Request) -> tuple[list[Graph], list[Met]]:
    return copy_context().run(_of_workspaces, request)  # the rules of its plugins are there for this run only


def _of_workspaces(request: Request) -> tuple[list[Graph], list[Met]]:
    """The graphs and the findings."""
    request.settings.activate_plugins()
    workspace = find_files(request)
    store: Store | NullStore = store_of(request)
    inputs = Inputs(request, workspace, tree_of(request, workspace), store)
    facts = compiled(request, workspace, store)
    refuse_nothing(request, workspace, facts)
    loaded: list[list[System]] = []
    judged = call_with_deep_stack(lambda: judged_in_parts(inputs, facts, loaded=loaded))
    graphs: list[Graph] = []
    if request.launch is None:
        opened = combined([as_asked_for(request, systems[0], workspace) for systems in loaded])
        graphs.append(_graph(opened))
    launched = {system.name: system for systems in loaded for system in systems if system.name is not None}
    graphs += [_graph(launched[name]) for name in sorted(launched)]
    store.close()
    files = {file.relative for file in workspace.files}
    return graphs, [Met(finding, Occurrence.of(finding, files)) for finding in judged.findings]


def _graph(system: System) -> Graph:
    try:
        return graph_of(document(system))
    except UnreadableGraph as error:  # an error of ours
        raise AssertionError(str(error)) from None


def same_systems(before: Side, after: Side) -> tuple[Side, Side]:
    """The sides with what both can have: where one is a saved graph, the other one's graph of the same system.

    Raises :class:`NoSide` where it has none.
    """
    if before.findings is None and after.findings is not None:
        return before, _only(after, before)
    if after.findings is None and before.findings is not None:
        return _only(before, after), after
    return before, after


def _only(side: Side, saved: Side) -> Side:
    system = saved.graphs[0].system
    same = [graph for graph in side.graphs if graph.system == system]
    if not same and not side.is_empty:
        what = "the whole workspace" if system is None else system
        raise NoSide(f"{saved.shown} is the graph of {what}, which {side.shown} does not have")
    return replace(side, graphs=same or [_NOTHING])


@dataclass(frozen=True)
class FindingChanges:
    """The findings that only one side has."""

    appeared: Sequence[Finding]
    vanished: Sequence[Finding]


def finding_changes(before: Side, after: Side) -> FindingChanges | None:
    """What appeared and vanished, by what findings are about and not by their lines; None where a side has none."""
    if before.findings is None or after.findings is None:
        return None
    old, new = list(before.findings), list(after.findings)
    for anywhere in (False, True):  # a file may have another name now
        left: dict[tuple[str, ...], list[Met]] = {}
        for met in old:
            left.setdefault(_key(met, anywhere), []).append(met)
        kept = []
        for met in new:
            same = left.get(_key(met, anywhere))
            if same:
                same.pop(0)
            else:
                kept.append(met)
        new, old = kept, [met for met in old if any(met is other for other in left[_key(met, anywhere)])]
    return FindingChanges([met.finding for met in new], [met.finding for met in old])


def _key(met: Met, anywhere: bool) -> tuple[str, ...]:
    occurrence = met.occurrence
    return (occurrence.code, "" if anywhere else occurrence.place.file, occurrence.what)


__all__ = [
    "FindingChanges",
    "NoSide",
    "Side",
    "finding_changes",
    "of_file",
    "of_folder",
    "of_request",
    "of_revision",
    "same_systems",
]

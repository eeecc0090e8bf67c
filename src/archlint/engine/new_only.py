"""``--new-only``: what an earlier revision has of findings, so that only those that are new are reported.

Both revisions are judged whole, and with the configuration of the working tree: a change of one file may break another.
"""

from __future__ import annotations

import hashlib
import json
import os
from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.engine.git import GitError, Repository, repository_of
from archlint.engine.known import Older
from archlint.engine.old_request import commit_of, old_request, paths_there, working_in
from archlint.engine.old_tree import OldTree, old_tree
from archlint.engine.own_code import own_code
from archlint.engine.pipeline import NothingToDo, Request, check, store_of
from archlint.engine.surroundings import Surroundings, folder_of
from archlint.finding import Severity
from archlint.records import dataclass
from archlint.report.occurrence import Key
from archlint.workspace.discovery import PathNotFound

if TYPE_CHECKING:
    from archlint.report.model import Report
    from archlint.syntax.cache import NullStore, Store

__all__ = ["Before", "GitError", "findings_before"]


@dataclass(frozen=True)
class Before:
    """The findings of an earlier revision, and what is to be said of the comparison."""

    findings: tuple[Older, ...]
    notices: tuple[str, ...]


def findings_before(request: Request, revision: str) -> Before:
    """What a request would have reported at the revision that the working tree comes from.

    Raises :class:`GitError` where that is not known, and :class:`NothingToDo` where there is nothing to check now.
    """
    repository = repository_of(dict.fromkeys(folder_of(path) for path in request.paths))
    commit, notices = _commit(repository, revision)
    surroundings = Surroundings(request, repository)
    store = store_of(request)
    kept = _Kept(store, request, repository, commit, surroundings)
    known = kept.load()
    if known is not None:
        return Before(known, tuple(notices))
    with old_tree() as tree:
        tree.write(repository, commit)
        surroundings.add_to(tree)
        report = _report(request, tree, store)
        notices += [
            f"--new-only: the submodule {os.path.relpath(folder)} is compared as it is now: this clone does not have "
            f"its content at {revision}"
            for folder in tree.kept
        ]
    store.close()
    occurrences = () if report is None else report.occurrences
    findings = tuple(Older(occurrence.key, occurrence.severity) for occurrence in occurrences)
    failures = [] if report is None else [finding for finding in report.findings if finding.code == "LNT003"]
    notices += [f"--new-only: at {revision}, {failure.place.file}: {failure.message}" for failure in failures]
    if not failures:
        kept.save(findings)
    return Before(findings, tuple(notices))


def _commit(repository: Repository, revision: str) -> tuple[str, list[str]]:
    """The commit to compare with: where the history of the working tree leaves that of the revision."""
    commit, head = commit_of(repository, revision), repository.commit("HEAD")
    fork = None if head is None else repository.fork(commit, head)
    if fork is not None:
        return fork, []
    why = "this clone is shallow" if repository.is_shallow else "they have no common history"
    return commit, [
        f"--new-only: where HEAD and {revision} part is not known ({why}), so it is compared with {revision}"
    ]


class _Kept:
    """The findings of a revision, kept in the cache."""

    def __init__(
        self,
        store: Store | NullStore,
        request: Request,
        repository: Repository,
        commit: str,
        surroundings: Surroundings,
    ) -> None:
        self._store = store
        here = os.path.relpath(os.getcwd(), repository.root)
        observed = None if request.observed is None else (request.observed.file, request.observed.digest)
        asked = [repr(request.paths), repr(request.settings), request.launch, request.launch_arguments, observed]
        decisive = [own_code(), commit, here, repository.root, asked, surroundings.rows()]
        self._key = f"before-{hashlib.sha256(json.dumps(decisive).encode()).hexdigest()}"

    def load(self) -> tuple[Older, ...] | None:
        payload = self._store.get_run(self._key)
        try:
            rows = None if payload is None else json.loads(payload)
            return None if rows is None else tuple(Older(Key(*map(str, row[1:])), Severity(row[0])) for row in rows)
        except (ValueError, TypeError, LookupError, RecursionError):
            return None

    def save(self, findings: Sequence[Older]) -> None:
        rows = [[older.severity, older.key.code, older.key.file, older.key.what] for older in findings]
        self._store.put_run(self._key, json.dumps(rows).encode())


def _report(request: Request, tree: OldTree, store: Store | NullStore) -> Report | None:
    """What is found in an earlier revision; None where there was nothing yet to check."""
    here = os.getcwd()
    old = old_request(request, tree, store)
    with working_in(tree.place(here)):
        present = paths_there(old)
        if not present:
            return None
        try:
            report = check(replace(old, paths=present))
        except (NothingToDo, PathNotFound):
            return None
    # Their files are named from the working directory, which is another one now.
    return report

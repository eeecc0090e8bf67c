"""``--new-only``: what an earlier revision has of findings, so that only those that are new are reported.

Both revisions are judged whole, and with the configuration of the working tree: a change of one file may break another.
"""

from __future__ import annotations

import hashlib
import json
import os
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from archlint.engine.git import GitError, Repository, repository_of
from archlint.engine.inputs import find_files
from archlint.engine.known import Older
from archlint.engine.old_tree import OldTree, old_tree
from archlint.engine.own_code import own_code
from archlint.engine.pipeline import NothingToDo, Request, check, store_of
from archlint.finding import Severity
from archlint.report.occurrence import Key
from archlint.suggestions import did_you_mean
from archlint.syntax.cache import NullStore
from archlint.workspace.around import is_below
from archlint.workspace.discovery import PathNotFound

if TYPE_CHECKING:
    from archlint.config.settings import Settings
    from archlint.globs import Glob
    from archlint.report.model import Report
    from archlint.syntax.cache import Store

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
    repository = repository_of(dict.fromkeys(_folder(path) for path in request.paths))
    commit, notices = _commit(repository, revision)
    surroundings = _Surroundings(request, repository)
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


def _folder(path: str) -> str:
    absolute = os.path.abspath(path)
    return absolute if os.path.isdir(absolute) else os.path.dirname(absolute)


def _commit(repository: Repository, revision: str) -> tuple[str, list[str]]:
    """The commit to compare with: where the history of the working tree leaves that of the revision."""
    commit, head = repository.commit(revision), repository.commit("HEAD")
    if commit is None:
        raise GitError(_unknown(repository, revision))
    fork = None if head is None else repository.fork(commit, head)
    if fork is not None:
        return fork, []
    why = "this clone is shallow" if repository.is_shallow else "they have no common history"
    return commit, [
        f"--new-only: where HEAD and {revision} part is not known ({why}), so it is compared with {revision}"
    ]


def _unknown(repository: Repository, revision: str) -> str:
    if repository.is_shallow:
        fetch = "git fetch --unshallow origin '+refs/heads/*:refs/remotes/origin/*'"
        return f"{revision} is not in this clone, which is shallow; `{fetch}` brings it"
    near = did_you_mean(revision, repository.names(), quote="")
    return f"git knows no revision {revision} in {os.path.relpath(repository.root)}{near}"


class _Surroundings:
    """What belongs to a workspace and to no revision of its repository: files outside of it, those of repositories in
    it, and the configuration, which is that of the working tree."""

    def __init__(self, request: Request, repository: Repository) -> None:
        self._root = repository.root
        self._folders = [os.getcwd(), *map(_folder, request.paths)]
        self._configuration = request.settings.read
        self._masters: dict[str, bool] = {}
        self._files = [file for file in find_files(request).files if self._is_foreign(file.path)]

    def add_to(self, tree: OldTree) -> None:
        written = {folder for folder in tree.written if folder != self._root}
        files = [file for file in self._files if not any(is_below(file.path, folder) for folder in written)]
        tree.surround(files, self._folders, self._root)
        for file in self._configuration:
            tree.copy(file)
        for folder in self._folders:
            if os.path.isdir(folder) and not is_below(folder, self._root):
                os.makedirs(tree.place(folder), exist_ok=True)

    def rows(self) -> list[object]:
        """What changes with them."""
        return [(file.relative, *file.stamp) for file in self._files]

    def _is_foreign(self, path: str) -> bool:
        if not is_below(path, self._root):
            return True
        return self._has_other_master(os.path.dirname(path))

    def _has_other_master(self, folder: str) -> bool:
        """Whether a folder below the root is reached through a link, or lies in another repository."""
        if folder == self._root or folder == os.path.dirname(folder):
            return False
        if folder not in self._masters:
            is_other = os.path.islink(folder) or os.path.lexists(os.path.join(folder, ".git"))
            self._masters[folder] = is_other or self._has_other_master(os.path.dirname(folder))
        return self._masters[folder]


class _Kept:
    """The findings of a revision, kept in the cache."""

    def __init__(
        self,
        store: Store | NullStore,
        request: Request,
        repository: Repository,
        commit: str,
        surroundings: _Surroundings,
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


class _FactsOnly(NullStore):
    """A cache of what files say, whichever files these are; nothing else of an earlier revision is kept."""

    def __init__(self, store: Store | NullStore) -> None:
        self._store = store

    def get(self, digest: str) -> bytes | None:
        return self._store.get(digest)

    def put(self, digest: str, payload: bytes) -> None:
        self._store.put(digest, payload)


def _report(request: Request, tree: OldTree, store: Store | NullStore) -> Report | None:
    """What is found in an earlier revision; None where there was nothing yet to check."""
    here = os.getcwd()
    paths = tuple(tree.place(path) if os.path.isabs(path) else path for path in request.paths)
    old = replace(
        request,
        settings=_moved(request.settings, tree),
        cached=False,
        store=_FactsOnly(store),
        baseline=None,
        before=None,
        occurrences=True,
        fixes=False,
        keeper=None,
    )
    with _working_in(tree.place(here)):
        present = tuple(path for path in paths if os.path.exists(path))
        if not present or not (request.launch is None or os.path.isfile(request.launch)):
            return None
        try:
            report = check(replace(old, paths=present))
        except (NothingToDo, PathNotFound):
            return None
    # Their files are named from the working directory, which is another one now.
    return report


def _moved(settings: Settings, tree: OldTree) -> Settings:
    """The settings with all that they name in the folder of a revision."""

    def moved(glob: Glob) -> Glob:
        return replace(glob, base=tree.place(glob.base))

    return replace(
        settings,
        exclude=tuple(map(moved, settings.exclude)),
        launch=tuple(map(moved, settings.launch)),
        per_file_ignores={moved(glob): codes for glob, codes in settings.per_file_ignores.items()},
        file=None if settings.file is None else tree.place(settings.file),
        read=tuple(map(tree.place, settings.read)),
    )


@contextmanager
def _working_in(folder: str) -> Iterator[None]:
    before = os.getcwd()
    os.makedirs(folder, exist_ok=True)
    os.chdir(folder)
    try:
        yield
    finally:
        os.chdir(before)

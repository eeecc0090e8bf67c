"""A request, asked of an earlier revision: in a folder that stands for the root of the disk (:mod:`old_tree`)."""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.engine.git import GitError, Repository
from archlint.engine.request import Request
from archlint.suggestions import did_you_mean
from archlint.syntax.cache import NullStore

if TYPE_CHECKING:
    from archlint.config.settings import Settings
    from archlint.engine.old_tree import OldTree
    from archlint.globs import Glob
    from archlint.syntax.cache import Store


def commit_of(repository: Repository, revision: str) -> str:
    """The commit that a revision means.  Raises :class:`GitError`, which says which one was perhaps meant."""
    commit = repository.commit(revision)
    if commit is None:
        raise GitError(_unknown(repository, revision))
    return commit


def _unknown(repository: Repository, revision: str) -> str:
    if repository.is_shallow:
        fetch = "git fetch --unshallow origin '+refs/heads/*:refs/remotes/origin/*'"
        return f"{revision} is not in this clone, which is shallow; `{fetch}` brings it"
    near = did_you_mean(revision, repository.names(), quote="")
    return f"git knows no revision {revision} in {os.path.relpath(repository.root)}{near}"


class _FactsOnly(NullStore):
    """A cache of what files say, whichever files these are; nothing else of an earlier revision is kept."""

    def __init__(self, store: Store | NullStore) -> None:
        self._store = store

    def get(self, digest: str) -> bytes | None:
        return self._store.get(digest)

    def put(self, digest: str, payload: bytes) -> None:
        self._store.put(digest, payload)


def old_request(request: Request, tree: OldTree, store: Store | NullStore) -> Request:
    """What is asked of the revision in ``tree``."""
    return replace(
        request,
        paths=tuple(tree.place(path) if os.path.isabs(path) else path for path in request.paths),
        settings=_moved(request.settings, tree),
        cached=False,
        store=_FactsOnly(store),
        baseline=None,
        before=None,
        occurrences=True,
        fixes=False,
        keeper=None,
    )


def paths_there(request: Request) -> tuple[str, ...]:
    """Those of its paths that are in the working directory; empty where its launch file is not."""
    present = tuple(path for path in request.paths if os.path.exists(path))
    return present if request.launch is None or os.path.isfile(request.launch) else ()


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
def working_in(folder: str) -> Iterator[None]:
    before = os.getcwd()
    os.makedirs(folder, exist_ok=True)
    os.chdir(folder)
    try:
        yield
    finally:
        os.chdir(before)


__all__ = ["commit_of", "old_request", "paths_there", "working_in"]

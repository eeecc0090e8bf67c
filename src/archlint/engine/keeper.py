"""Keeps what a command says, with the state of everything on the disk that it came from."""

from __future__ import annotations

import os
import time
from collections.abc import Iterable, Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.disk import walk
from archlint.engine.answers import (
    Answer,
    Names,
    State,
    can_be_kept,
    kinds_of,
    name_of,
    payload_of,
    roots,
    stamps_of,
)
from archlint.engine.own_code import own_places
from archlint.records import dataclass
from archlint.syntax.cache import RACY_NS, Store

if TYPE_CHECKING:
    from archlint.config.settings import Settings
    from archlint.syntax.cache import NullStore
    from archlint.workspace.model import Workspace

_MARKS = (".", ".git", "src", "build", "install", "log", "package.xml", "__init__.py")
"""What is asked for in the folders above a path: only whether it is there counts."""
_READ = ("archlint.toml", ".archlint.toml", "pyproject.toml", ".gitignore", ".git/info", ".git/info/exclude")
"""What is read in the folders above a path."""
_MOST = 50_000
"""Places; an answer that depends on more is not kept."""


class Keeper:
    """Keeps the answer to one command.

    A run says when it :meth:`starts`, and that its result :meth:`lasts`.  ``words`` are those of the command,
    ``terminal`` what else decides how it is shown; ``files`` are read beside those of the workspace.
    """

    def __init__(self, words: Sequence[str], terminal: Sequence[str], files: Iterable[str] = ()) -> None:
        self._began = time.time_ns()
        self._words, self._terminal, self._files = words, terminal, list(files)
        self._basis: _Basis | None = None

    def starts(self, paths: Iterable[str], settings: Settings) -> None:
        """A run begins over some paths."""
        root = os.path.abspath(settings.cache_folder)
        self._names = Names(os.path.dirname(root), os.path.basename(root))
        self._above = Above(paths, settings, self._files)

    def lasts(
        self, workspace: Workspace, asked: Iterable[tuple[str, str, str | None]], store: Store | NullStore
    ) -> None:
        """The result is one that an equal run would have; ``asked`` is what was asked of the disk beside the files of
        the workspace, or what will have been when the answer is kept: question, path, answer."""
        if isinstance(store, Store) and not workspace.problems:
            self._basis = _Basis(workspace, asked, store)

    def keep(self, answer: Answer) -> None:
        """Keep an answer, unless something that it depends on has just changed."""
        basis = self._basis
        if basis is None or not can_be_kept(self._words):
            return
        if all(os.path.abspath(basis.store.root) != os.path.abspath(root) for root in roots(self._words)):
            return  # it would not be found
        state = self._state(basis)
        if state is not None:
            basis.store.put_answer(name_of(self._words, self._terminal), payload_of(answer, state))

    def _state(self, basis: _Basis) -> State | None:
        """How all is that the answer depends on; None where that is not known for the whole time of the run."""
        if not self._above.is_unchanged():
            return None
        rows = self._above.rows()
        rows.update((file.path, " ".join(map(str, file.stamp))) for file in basis.workspace.files)
        others = sorted({os.path.abspath(path) for path in basis.places()} - rows.keys())
        if len(others) > _MOST:
            return None
        rows.update(zip(others, stamps_of(others).split("\n"), strict=True))
        names = self._names if rows.pop(self._names.folder, None) is not None else Names()
        if names.again().fields != names.fields or any(self._is_recent(row) for row in rows.values()):
            return None
        here = os.getcwd()
        stamped = {_seen_from(path, here): row for path, row in rows.items()}
        return State(list(stamped), "\n".join(stamped.values()), self._above.placed, self._above.kinds, names)

    def _is_recent(self, row: str) -> bool:
        """Whether something may have changed since the run began: its stamp would not show it."""
        times = [] if row.startswith("-") else row.split(" ")[:2]
        return any(int(changed) + RACY_NS >= self._began for changed in times)


class Above:
    """What decides, above the paths of a run, which workspace and which configuration they belong to."""

    def __init__(self, paths: Iterable[str], settings: Settings, files: Iterable[str]) -> None:
        here = os.getcwd()
        starts = [os.path.join(here, path) for path in paths]
        starts += [os.path.dirname(os.path.abspath(file)) for file in settings.read]
        folders = dict.fromkeys(
            folder
            for start in (here, *starts)
            for path in (start, os.path.normpath(start))
            for folder in _upwards(path)
        )
        self.placed = [os.path.join(folder, mark) for folder in folders for mark in _MARKS]
        self.kinds = kinds_of(self.placed)
        self._read = [os.path.join(folder, name) for folder in folders for name in _READ]
        self._read += [os.path.abspath(file) for file in (*settings.read, *files)]
        self._stamps = stamps_of(self._read)

    def is_unchanged(self) -> bool:
        return kinds_of(self.placed) == self.kinds and stamps_of(self._read) == self._stamps

    def rows(self) -> dict[str, str]:
        """The stamps of what is read, by path."""
        return dict(zip(self._read, self._stamps.split("\n"), strict=True))


@dataclass(frozen=True)
class _Basis:
    """What a result came from, below the paths of its run."""

    workspace: Workspace
    asked: Iterable[tuple[str, str, str | None]]
    store: Store

    def places(self) -> Iterator[str]:
        """All that was looked at beside the files of the workspace, archlint's own files among it."""
        yield from self.workspace.looked_at
        yield from own_places()
        for question, path, _ in self.asked:
            yield from _below(path) if question == "listing" else [path]


def _below(folder: str) -> Iterator[str]:
    """A folder and all folders in it, with what is linked there."""
    yield folder
    for top, folders, names in walk(folder):
        folders[:] = [name for name in folders if not name.startswith((".", "__pycache__"))]
        for name in (*folders, *names):
            path = os.path.join(top, name)
            if name in folders or os.path.islink(path):
                yield path


def _seen_from(path: str, here: str) -> str:
    """A path as it is shortest: the system finds it sooner."""
    below = here.rstrip(os.sep) + os.sep
    return path[len(below) :] if path.startswith(below) and path != below else path


def _upwards(path: str) -> Iterator[str]:
    yield path
    while path != os.path.dirname(path):
        path = os.path.dirname(path)
        yield path


__all__ = ["Above", "Keeper"]

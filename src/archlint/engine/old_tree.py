"""An earlier revision, written to a folder of its own in the same surroundings as the working tree.

The folder stands for the root of the disk: a path below it is that of the working tree, so that whatever is relative
(what is shown, what a configuration names) is the same in both.
"""

from __future__ import annotations

import contextlib
import os
import shutil
import signal
import tempfile
import threading
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path
from types import FrameType
from typing import TYPE_CHECKING

from archlint.disk import walk
from archlint.engine.git import GitError, Repository, TreeEntry
from archlint.workspace.around import ROOT_MARKS, has, is_below
from archlint.workspace.kinds import kind_of
from archlint.workspace.pruning import COLCON_FOLDERS
from archlint.workspace.tracked import index_of
from archlint.workspace.tree import TEXT_LIMIT

if TYPE_CHECKING:
    from archlint.workspace.model import SourceFile

_NO_TEXT = (
    *(".bag", ".bin", ".dae", ".db3", ".gif", ".glb", ".gz", ".jpeg", ".jpg", ".mcap", ".mp4", ".npy", ".obj", ".onnx"),
    *(".pcd", ".pdf", ".pgm", ".ply", ".png", ".pt", ".so", ".stl", ".svg", ".tif", ".webp", ".zip"),
)
"""Of these files only the name counts."""
_MOST = TEXT_LIMIT + 1
"""Bytes: a file that has so many is too large to be read, whatever else it has."""


_MOST_IN_ALL = 4_000_000_000
"""Bytes that are written: a revision can name one large file any number of times."""


class OldTree:
    """A folder with a revision; ``base`` stands for the root of the disk."""

    def __init__(self, base: str) -> None:
        self.base = base
        self._left = _MOST_IN_ALL
        self.written: list[str] = []
        """The repositories whose content is that of a commit."""
        self.kept: list[str] = []
        """Submodules whose earlier content is not at hand, so that they are as they are now."""

    def place(self, path: str) -> str:
        """Where the file of a path of the disk is."""
        absolute = os.path.abspath(path)
        drive, below = os.path.splitdrive(absolute)
        return os.path.join(self.base, drive.strip(":\\/"), below.lstrip(os.sep + "/")).rstrip(os.sep)

    def write(self, repository: Repository, commit: str) -> None:
        """Write a commit of a repository.  Raises :class:`GitError` and ``OSError``."""
        links = self._files(repository, commit)
        for path, target in links:  # once nothing else is written: nothing goes through a link
            self._link(path, target)
        self._remove_ways_out(repository.root)

    def _files(self, repository: Repository, commit: str) -> list[tuple[str, str]]:
        """Write the files; returns the symbolic links, each with what it says."""
        self.written.append(repository.root)
        entries = repository.tree(commit)
        plain = [entry for entry in entries if not entry.is_link and not entry.is_submodule]
        self._write_index(repository, entries)
        missing = repository.missing(commit)
        read = [entry for entry in plain if _is_text(entry) and entry.object not in missing]
        for entry, data in zip(read, repository.contents([entry.object for entry in read], _MOST), strict=True):
            self._left -= len(data)
            if self._left < 0:
                raise GitError(f"the files of the revision have more than {_MOST_IN_ALL // 1_000_000_000} GB")
            self._add(repository, entry, data)
        for entry in plain:
            if entry.object in missing and _is_read(entry):
                fetch = f"git archive --output={os.devnull} {commit}"
                raise GitError(f"the content of {entry.path} is not in this partial clone; `{fetch}` brings it")
            if entry.object in missing or not _is_text(entry):
                self._add(repository, entry, b"")
        links = [entry for entry in entries if entry.is_link and entry.object not in missing]
        targets = repository.contents([entry.object for entry in links], _MOST)
        rows = [
            (self.place(os.path.join(repository.root, entry.path)), os.fsdecode(data))
            for entry, data in zip(links, targets, strict=True)
        ]
        for entry in entries:
            if entry.is_submodule:
                rows += self._submodule(os.path.join(repository.root, entry.path), entry.object)
        return rows

    def _write_index(self, repository: Repository, entries: list[TreeEntry]) -> None:
        """What a commit has is tracked, whatever its ``.gitignore`` says."""
        folder = self.place(os.path.join(repository.root, ".git"))
        os.makedirs(folder, exist_ok=True)
        with contextlib.suppress(FileExistsError), open(os.path.join(folder, "index"), "xb") as stream:
            stream.write(index_of([os.fsencode(entry.path) for entry in entries]))

    def _add(self, repository: Repository, entry: TreeEntry, data: bytes) -> None:
        """A file that is not there yet."""
        target = self.place(os.path.join(repository.root, entry.path))
        with contextlib.suppress(FileExistsError, NotADirectoryError):  # names that a file system takes for the same
            os.makedirs(os.path.dirname(target), exist_ok=True)
            with open(target, "xb") as stream:
                stream.write(data)
            if entry.is_executable:
                os.chmod(target, 0o755)

    def _submodule(self, folder: str, commit: str) -> list[tuple[str, str]]:
        os.makedirs(self.place(os.path.join(folder, ".git")), exist_ok=True)
        if not os.path.lexists(os.path.join(folder, ".git")):
            return []
        with contextlib.suppress(GitError):
            submodule = Repository(folder)
            if submodule.root not in self.written and submodule.commit(commit) is not None:  # no link leads back
                return self._files(submodule, commit)
        self.kept.append(folder)
        return []

    def _link(self, path: str, target: str) -> None:
        with contextlib.suppress(OSError, ValueError):  # a name that is no path, a system without links
            os.makedirs(os.path.dirname(path), exist_ok=True)
            if not os.path.isabs(target) and is_below(os.path.realpath(os.path.dirname(path)), self.base):
                os.symlink(target, path)

    def _remove_ways_out(self, root: str) -> None:
        """Remove the symbolic links of a repository that lead out of it, by whichever others."""
        top = os.path.realpath(self.place(root))
        for folder, folders, names in walk(top):
            for name in (*folders, *names):
                path = os.path.join(folder, name)
                if os.path.islink(path) and not is_below(os.path.realpath(path), top):
                    os.unlink(path)

    def surround(self, files: Iterable[SourceFile], folders: Iterable[str], root: str) -> None:
        """Add what no revision of the repository at ``root`` changes: files as they are, and what the folders above
        some show of themselves."""
        for file in files:
            self.copy(file.path)
        for folder in folders:
            for above in _upwards(folder):
                self._mark(above, is_outside=not is_below(above, root))

    def copy(self, path: str) -> None:
        """Add a file as it is now, in place of the one that is there."""
        target = self.place(path)
        with contextlib.suppress(OSError):
            os.makedirs(os.path.dirname(target), exist_ok=True)
            if os.path.islink(target):
                os.unlink(target)
            shutil.copyfile(path, target)
            shutil.copymode(path, target)

    def _mark(self, folder: str, is_outside: bool) -> None:
        for name in (".git", "src", *sorted(COLCON_FOLDERS)):
            if os.path.isdir(os.path.join(folder, name)) or (name == ".git" and has(folder, name)):
                with contextlib.suppress(OSError):
                    os.makedirs(self.place(os.path.join(folder, name)), exist_ok=True)
        outside = (*ROOT_MARKS, ".gitignore", "package.xml") if is_outside else ()
        for name in (*outside, os.path.join(".git", "info", "exclude")):
            path = os.path.join(folder, name)
            if os.path.isfile(path) and not os.path.lexists(self.place(path)):
                self.copy(path)


@contextmanager
def old_tree() -> Iterator[OldTree]:
    """A new folder, which is removed whatever happens."""
    with _removed_on_termination():
        base = os.path.realpath(tempfile.mkdtemp(prefix="archlint-"))
        try:
            yield OldTree(base)
        finally:
            shutil.rmtree(base, ignore_errors=True)


@contextmanager
def _removed_on_termination() -> Iterator[None]:
    """A signal to end, such as that of a CI job that is cancelled, ends what is inside in order."""
    if threading.current_thread() is not threading.main_thread():
        yield
        return

    def end(number: int, frame: FrameType | None) -> None:
        raise SystemExit(128 + number)

    before = signal.signal(signal.SIGTERM, end)
    try:
        yield
    finally:
        signal.signal(signal.SIGTERM, before)


def _is_text(entry: TreeEntry) -> bool:
    return not entry.path.lower().endswith(_NO_TEXT)


def _is_read(entry: TreeEntry) -> bool:
    """Whether archlint reads what is in a file, and not only that it is there."""
    folder, name = os.path.split(entry.path)
    return "." not in name or kind_of(name, os.path.basename(folder)) is not None


def _upwards(folder: str) -> Iterator[str]:
    """A folder and those around it, below the user's home folder."""
    path, home = Path(folder), os.path.expanduser("~")
    for above in (path, *path.parents):
        if str(above) == home or above == above.parent:
            return
        yield str(above)


__all__ = ["OldTree", "old_tree"]

"""What git has of an earlier revision, by commands that run no code of the repository and change nothing in it.

Only plumbing is used: no hook, no filter, no external diff and no ``textconv`` is started by it, no index is read or
refreshed, and what a partial clone lacks is not fetched.
"""

from __future__ import annotations

import os
import shutil
import subprocess
import tempfile
import threading
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager
from typing import IO

from archlint.records import dataclass

_OPTIONS = (
    "--no-pager",
    "--literal-pathspecs",
    *("-c", f"core.hooksPath={os.devnull}"),
    *("-c", "core.fsmonitor=false"),
    *("-c", "safe.bareRepository=explicit"),
)
_FORGOTTEN = ("GIT_DIR", "GIT_WORK_TREE", "GIT_INDEX_FILE", "GIT_PREFIX", "GIT_COMMON_DIR", "GIT_NAMESPACE")
"""Variables that a hook sets for the repository that it runs in: here the folder decides which one is meant."""
_QUIET = {
    "GIT_ALLOW_PROTOCOL": "none",
    "GIT_NO_LAZY_FETCH": "1",
    "GIT_OPTIONAL_LOCKS": "0",
    "GIT_TERMINAL_PROMPT": "0",
    "LC_ALL": "C",
}


_PARTIAL = r"^(remote\..*\.promisor|extensions\.partialclone)$"


MOST_FILES = 500_000
"""Files of a revision: a tree of a few kilobytes can name any number, each folder many times."""
DEEPEST = 200
"""Folders inside each other: what lies deeper is left out, as every walk over it would be too deep."""
_LONGEST_ROW = 1_000_000
_PATIENCE = 600.0
"""Seconds that git may take: where a pipe stands for a file of it, it waits forever."""


class GitError(Exception):
    """What git cannot say; ``str()`` is the reason, for people."""


@dataclass(frozen=True)
class TreeEntry:
    """A file, a symbolic link or a submodule of a tree."""

    path: str
    mode: str
    object: str

    @property
    def is_link(self) -> bool:
        return self.mode == "120000"

    @property
    def is_submodule(self) -> bool:
        return self.mode == "160000"

    @property
    def is_executable(self) -> bool:
        return self.mode == "100755"


class Repository:
    """The repository that a folder lies in; ``root`` is the top of its working tree.  Raises :class:`GitError`."""

    def __init__(self, folder: str) -> None:
        self._git = shutil.which("git") or ""
        if not self._git:
            raise GitError("it needs git, and there is no `git` here")
        self._folder = folder
        if not _lies_in_one(folder):
            raise GitError(f"{_shown(folder)} lies in no git repository; name a folder that does")
        self.root = os.path.normpath(os.fsdecode(self._said("rev-parse", "--show-toplevel").rstrip(b"\r\n")))

    @property
    def is_shallow(self) -> bool:
        return self._said("rev-parse", "--is-shallow-repository").strip() == b"true"

    def commit(self, revision: str) -> str | None:
        """The commit that a revision means; None for one that is not here."""
        if revision.startswith("-") or "\0" in revision:
            return None
        run = self._run("rev-parse", "--verify", "--quiet", "--end-of-options", f"{revision}^{{commit}}")
        return run.stdout.decode("ascii", "replace").strip() if run.returncode == 0 else None

    def fork(self, commit: str, other: str) -> str | None:
        """The last commit that two have in common; None where that is not in this clone."""
        run = self._run("merge-base", commit, other)
        return run.stdout.decode("ascii", "replace").strip() if run.returncode == 0 else None

    def names(self) -> list[str]:
        """The branches and tags."""
        return self._said("for-each-ref", "--format=%(refname:short)").decode("utf-8", "replace").split("\n")

    def tree(self, commit: str) -> list[TreeEntry]:
        """All that a commit has, by path from the root."""
        entries: list[TreeEntry] = []
        with self._started("ls-tree", "-r", "-z", "--full-tree", commit) as process:
            for number, row in enumerate(_rows(_output(process))):
                if number == MOST_FILES:
                    raise GitError(f"the revision has more than {MOST_FILES:,} files")
                entry = _entry(row)
                if entry is not None:
                    entries.append(entry)
            if process.wait() != 0:
                raise GitError("git does not have all folders of the revision: `git fsck` says more")
        return entries

    def missing(self, commit: str) -> frozenset[str]:
        """The files of a commit whose content is not in this clone, which is a partial one then."""
        if self._run("config", "--get-regexp", _PARTIAL).returncode != 0:
            return frozenset()
        rows = self._said("rev-list", "--objects", "--missing=print", f"{commit}^{{tree}}").decode("ascii", "replace")
        return frozenset(row[1:] for row in rows.split("\n") if row.startswith("?"))

    def contents(self, objects: Sequence[str], most: int) -> Iterator[bytes]:
        """The bytes of each of some files, in order, and of a larger one the first ``most``.  Raises
        :class:`GitError`."""
        with tempfile.TemporaryFile() as wanted:
            wanted.write("".join(f"{name}\n" for name in objects).encode())
            wanted.seek(0)
            with self._started("cat-file", "--batch", given=wanted) as process:
                for _ in objects:
                    yield _content(_output(process), most)

    @contextmanager
    def _started(self, *words: str, given: IO[bytes] | int = subprocess.DEVNULL) -> Iterator[subprocess.Popen[bytes]]:
        """A process of git while its output is read."""
        process = subprocess.Popen(
            self._words(*words), stdin=given, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, env=_environment()
        )
        timer = threading.Timer(_PATIENCE, process.kill)
        timer.daemon = True
        timer.start()
        try:
            yield process
        finally:
            timer.cancel()
            _output(process).close()
            process.kill()
            process.wait()

    def _said(self, *words: str) -> bytes:
        run = self._run(*words)
        if run.returncode != 0:
            lines = run.stderr.decode("utf-8", "replace").splitlines()
            raise GitError(f"git says: {lines[0].removeprefix('fatal: ') if lines else run.returncode}")
        return run.stdout

    def _run(self, *words: str) -> subprocess.CompletedProcess[bytes]:
        try:
            return subprocess.run(
                self._words(*words),
                stdin=subprocess.DEVNULL,
                capture_output=True,
                env=_environment(),
                check=False,
                timeout=_PATIENCE,
            )
        except subprocess.TimeoutExpired:
            raise GitError(f"git has not answered for {_PATIENCE:.0f} s") from None
        except OSError as error:
            raise GitError(f"git cannot be started: {error.strerror}") from None

    def _words(self, *words: str) -> list[str]:
        return [self._git, *_OPTIONS, "-C", self._folder, *words]


def _environment() -> dict[str, str]:
    return {name: value for name, value in os.environ.items() if name not in _FORGOTTEN} | _QUIET


def _lies_in_one(folder: str) -> bool:
    while not os.path.lexists(os.path.join(folder, ".git")):
        if folder == os.path.dirname(folder):
            return False
        folder = os.path.dirname(folder)
    return True


def _shown(folder: str) -> str:
    return "this folder" if folder == os.getcwd() else os.path.relpath(folder)


def _output(process: subprocess.Popen[bytes]) -> IO[bytes]:
    assert process.stdout is not None
    return process.stdout


def _rows(stream: IO[bytes]) -> Iterator[bytes]:
    """What is between the NUL bytes of a stream, each as soon as it is there."""
    rest = b""
    while data := stream.read(1 << 16):
        *rows, rest = (rest + data).split(b"\0")
        yield from rows
        if len(rest) > _LONGEST_ROW:
            raise GitError("a file of the revision has a name that is too long")


def _entry(row: bytes) -> TreeEntry | None:
    """A row of ``ls-tree``; None for a path that no checkout would write, and for one that is too deep."""
    about, _, path = row.partition(b"\t")
    mode, _, name = about.decode("ascii", "replace").split()
    decoded = os.fsdecode(path)
    if decoded.count("/") > DEEPEST or any(
        part in ("", ".", "..") or part.lower() == ".git" for part in decoded.split("/")
    ):
        return None
    if os.sep != "/" and (os.sep in decoded or ":" in decoded):
        return None
    return TreeEntry(decoded, mode, name)


def _content(stream: IO[bytes], most: int) -> bytes:
    header = stream.readline().split()
    if len(header) != 3 or not header[2].isdigit():
        raise GitError("git does not have all files of the revision: `git fsck` says more")
    size = int(header[2])
    data = stream.read(min(size, most))
    left = size - len(data)
    while left and (skipped := stream.read(min(left, most))):
        left -= len(skipped)
    if stream.read(1) != b"\n":
        raise GitError("git ended in the middle of a file")
    return data


def repository_of(folders: Iterable[str]) -> Repository:
    """The one repository that all folders lie in.  Raises :class:`GitError`."""
    first, *others = [Repository(folder) for folder in folders]
    for other in others:
        if other.root != first.root:
            raise GitError(f"the paths lie in two repositories, {_shown(first.root)} and {_shown(other.root)}")
    return first


__all__ = ["GitError", "Repository", "TreeEntry", "repository_of"]

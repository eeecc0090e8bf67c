"""The cache: facts by content, and the results of whole runs by all that they depend on.

A folder may come with a repository that somebody else wrote, so what is in it is only ever data: each entry
is signed with the user's own key (:mod:`archlint.syntax.secret`), whatever is damaged or not what it should be is a
miss, no name from the cache becomes a path unchecked, and no link out of the folder is followed to write or to
delete.  Every file is written aside and
put in place at once, so that runs may go on at the same time.
"""

from __future__ import annotations

import contextlib
import hashlib
import json
import os
import re
import time
from collections.abc import Iterator

from archlint.syntax.signed import read_signed, signed, version_folder

INDEX = "index.json"

RACY_NS = 2_000_000_000
"""A file changed this shortly before a run may change again within the same tick of its file system's clock:
its time proves nothing, and it is hashed anew."""
KEPT_DAYS = 30
"""How long an entry that no run asks for is kept."""
KEPT_RUNS = 100
"""How many results of runs are kept, each with a record of what it depends on."""
KEPT_OF_WORKSPACES = 40
"""How many entries of workspaces are kept: each has one of programs, launches, summaries and words."""
KEPT_ANSWERS = 50
"""How many answers to whole commands are kept."""

Stamp = tuple[int, int, int, int]
"""See :attr:`archlint.workspace.model.SourceFile.stamp`: the first is the time of modification."""
_Row = tuple[Stamp, str, int]
"""Stamp, digest, and the day on which a run last asked for the file."""

_KEY = re.compile(r"(?:[a-z]+-)?[0-9a-f]{32,64}")
_VERSION_FOLDER = re.compile(r"[0-9][\w.+]*-3\.[0-9]+")
_DAY = 24 * 3600
_MARKS = {
    ".gitignore": "*\n",
    "CACHEDIR.TAG": "Signature: 8a477f597d28d172789f06886806bc55\n# Made by archlint; safe to delete.\n",
}


def digest_of(data: bytes, salt: str = "") -> str:
    """The name of a content: SHA-256 of it and of what it is read as."""
    return hashlib.sha256(salt.encode() + b"\0" + data).hexdigest()[:40]


class Store:
    """Facts and results under one folder; where it cannot be written, nothing is kept, silently.

    ``root`` is made when there is something to keep.
    """

    lasts = True
    """Whether anybody will ask for what is kept."""

    @property
    def takes_programs(self) -> bool:
        """Whether what is known of programs may be kept now."""
        return True

    def __init__(self, root: str, version: str, key: bytes) -> None:
        self.root = root
        self._secret = key
        self.folder = os.path.join(root, version_folder(version))
        self._opened = time.time_ns()
        self._today = self._opened // (_DAY * 10**9)
        inner = (os.path.join(self.folder, kind) for kind in ("facts", "runs", "programs", "answers"))
        self._usable = not any(map(os.path.islink, (root, self.folder, *inner)))
        self._folders: set[str] = set()
        self._index, self._swept = _read_index(self._read(INDEX))
        self._changed = False

    def lookup(self, path: str, stamp: Stamp) -> str | None:
        """The digest of a file that has not changed since it was last hashed; None: hash it."""
        row = self._index.get(path)
        if row is None or row[0] != stamp:
            return None
        if row[2] != self._today:
            self._index[path] = (stamp, row[1], self._today)
            self._changed = True
        return row[1]

    def remember(self, path: str, stamp: Stamp, digest: str) -> None:
        """Note the digest of a file that was hashed after its status was taken."""
        if stamp[0] + RACY_NS >= self._opened:
            self._changed |= self._index.pop(path, None) is not None
        elif (row := (stamp, digest, self._today)) != self._index.get(path):
            self._index[path] = row
            self._changed = True

    def get(self, digest: str) -> bytes | None:
        """The payload of a content; None where there is none."""
        return self._read_entry(os.path.join("facts", digest[:2]), digest)

    def put(self, digest: str, payload: bytes) -> None:
        self._write_entry(os.path.join("facts", digest[:2]), digest, payload)

    def get_run(self, key: str) -> bytes | None:
        return self._read_entry("runs", key)

    def put_run(self, key: str, payload: bytes) -> None:
        self._write_entry("runs", key, payload)

    def get_programs(self, key: str) -> bytes | None:
        return self._read_entry("programs", key)

    def put_programs(self, key: str, payload: bytes) -> None:
        self._write_entry("programs", key, payload)

    def put_answer(self, key: str, payload: bytes) -> None:
        """Keep what a command has said; :mod:`archlint.engine.answers` reads it."""
        self._write_entry("answers", key, payload)

    def close(self) -> None:
        """Write what changed of the index, and once a day throw old entries away."""
        if not self._changed:
            return
        due = self._swept != self._today
        if due:
            oldest = self._today - KEPT_DAYS
            self._index = {path: row for path, row in self._index.items() if row[2] > oldest}
            self._swept = self._today
        rows = {path: [*stamp, digest, day] for path, (stamp, digest, day) in self._index.items()}
        self._write(INDEX, json.dumps({"swept": self._swept, "files": rows}, sort_keys=True).encode())
        self._changed = False
        if due:
            self._sweep()

    # --- the disk

    def _read_entry(self, folder: str, key: str) -> bytes | None:
        return self._read(os.path.join(folder, key)) if _KEY.fullmatch(key) else None

    def _write_entry(self, folder: str, key: str, payload: bytes) -> None:
        if _KEY.fullmatch(key):
            self._write(os.path.join(folder, key), payload)

    def _read(self, name: str) -> bytes | None:
        return read_signed(self.folder, name, self._secret) if self._usable else None

    def _write(self, name: str, payload: bytes) -> None:
        if not self._usable:
            return
        path = os.path.join(self.folder, name)
        temporary = f"{path}.{os.getpid()}.{time.monotonic_ns()}.tmp"
        try:
            self._make(os.path.dirname(path))
            with open(temporary, "xb") as stream:
                stream.write(signed(self.folder, name, payload, self._secret))
            os.replace(temporary, path)
        except OSError:
            self._usable = False  # no permission, no room: as good as no cache
            with contextlib.suppress(OSError):
                os.unlink(temporary)

    def _make(self, folder: str) -> None:
        """Make a folder of the cache.  A cache that is ours from the start is marked for git and for backups."""
        if folder in self._folders:
            return
        os.makedirs(self.root, exist_ok=True)
        if not os.listdir(self.root):
            for name, text in _MARKS.items():
                with contextlib.suppress(FileExistsError), open(os.path.join(self.root, name), "x") as stream:
                    stream.write(text)
        os.makedirs(folder, exist_ok=True)
        if os.path.islink(folder):
            raise NotADirectoryError(folder)
        self._folders.add(folder)

    def _sweep(self) -> None:
        """Delete what no run has asked for in a long time, also of other versions."""
        for folder in _entries(self.root):
            if not folder.is_dir(follow_symlinks=False) or not _VERSION_FOLDER.fullmatch(folder.name):
                continue
            is_own = folder.name == os.path.basename(self.folder)
            named = {digest for _, digest, _ in self._index.values()} if is_own else set()
            _expire(folder.path, set())
            _expire(os.path.join(folder.path, "runs"), set(), KEPT_RUNS)
            _expire(os.path.join(folder.path, "programs"), set(), KEPT_OF_WORKSPACES)
            _expire(os.path.join(folder.path, "answers"), set(), KEPT_ANSWERS)
            for shard in _entries(os.path.join(folder.path, "facts")):
                _expire(shard.path, named)


def _read_index(data: bytes | None) -> tuple[dict[str, _Row], int]:
    """The rows of the index, and the day of the last sweep; nothing where anything is wrong."""
    rows: dict[str, _Row] = {}
    try:
        index = json.loads(data or b"")
        swept = index["swept"]
        for path, (modified, changed, size, inode, digest, day) in index["files"].items():
            numbers = modified, changed, size, inode, day, swept
            if not all(type(number) is int for number in numbers) or not _KEY.fullmatch(digest):
                return {}, 0
            rows[path] = ((modified, changed, size, inode), digest, day)
    except (ValueError, TypeError, KeyError, AttributeError, RecursionError):
        return {}, 0
    return rows, swept


def _expire(folder: str, named: set[str], most: int | None = None) -> None:
    """Delete our own files in a folder that are old and not among ``named``, and all but the newest ``most``."""
    if os.path.islink(folder) or os.path.islink(os.path.dirname(folder)):
        return
    oldest = time.time() - KEPT_DAYS * _DAY
    files = []
    for entry in _entries(folder):
        ours = _KEY.fullmatch(entry.name) or entry.name == INDEX or entry.name.endswith(".tmp")
        if ours and entry.is_file(follow_symlinks=False):
            with contextlib.suppress(OSError):
                files.append((entry.stat(follow_symlinks=False).st_mtime, entry.name, entry.path))
    for number, (changed, name, path) in enumerate(sorted(files, reverse=True)):
        too_many = most is not None and number >= most
        if (changed < oldest and name.rpartition("-")[2] not in named) or too_many:
            with contextlib.suppress(OSError):
                os.unlink(path)


def _entries(folder: str) -> Iterator[os.DirEntry[str]]:
    try:
        with os.scandir(folder) as entries:
            yield from entries
    except OSError:
        return


class NullStore:
    """No cache: everything is a miss and nothing is kept."""

    lasts = False

    @property
    def takes_programs(self) -> bool:
        return False

    def lookup(self, path: str, stamp: Stamp) -> str | None:
        return None

    def remember(self, path: str, stamp: Stamp, digest: str) -> None:
        return None

    def get(self, digest: str) -> bytes | None:
        return None

    def put(self, digest: str, payload: bytes) -> None:
        return None

    def get_run(self, key: str) -> bytes | None:
        return None

    def put_run(self, key: str, payload: bytes) -> None:
        return None

    def get_programs(self, key: str) -> bytes | None:
        return None

    def put_programs(self, key: str, payload: bytes) -> None:
        return None

    def put_answer(self, key: str, payload: bytes) -> None:
        return None

    def close(self) -> None:
        return None

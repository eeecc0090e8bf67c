"""The cache: facts by content, and the findings of whole runs by all their inputs.

One folder, data only.  Every file is written aside and put in place at once, so that concurrent runs are safe;
whatever cannot be read, or is not what it should be, is a miss.  Nothing here is ever executed.
"""

from __future__ import annotations

import contextlib
import hashlib
import json
import os
import sys
import time
from typing import Any

FOLDER = ".archlint_cache"
INDEX = "index.json"
RACY_NS = 2_000_000_000
"""A file changed this shortly before the cache was written may change again unseen: it is hashed anew."""
KEPT_SECONDS = 30 * 24 * 3600
"""How long an entry that no run asks for is kept."""


def digest_of(data: bytes, salt: str = "") -> str:
    """The name of a content: SHA-256 of it and of what it is read as."""
    return hashlib.sha256(salt.encode() + b"\0" + data).hexdigest()[:40]


class Store:
    """Facts and results under one folder; a folder that cannot be written is no cache, silently."""

    def __init__(self, root: str, version: str) -> None:
        # Facts depend on the Python that judged the source, too: newer ones accept more.
        name = f"{version}-{sys.version_info[0]}.{sys.version_info[1]}"
        self.folder = os.path.join(root, name)
        self.root = root
        self._opened = time.time_ns()
        self._index: dict[str, list[Any]] = {}
        self._changed = False
        self._seen: set[str] = set()
        self._load()

    # ------------------------------------------------------------------------------------------ the index

    def _load(self) -> None:
        found = self._read_json(INDEX)
        if isinstance(found, dict) and isinstance(found.get("files"), dict):
            written = found.get("written", 0)
            self._written = written if isinstance(written, int) else 0
            for path, row in found["files"].items():
                if (
                    isinstance(path, str)
                    and isinstance(row, list)
                    and len(row) == 4
                    and all(isinstance(number, int) for number in row[:3])
                    and isinstance(row[3], str)
                ):
                    self._index[path] = row
        else:
            self._written = 0

    def lookup(self, path: str, mtime_ns: int, size: int, inode: int) -> str | None:
        """The digest of a file that has not changed since it was last hashed; None: hash it."""
        row = self._index.get(path)
        if row is None or row[:3] != [mtime_ns, size, inode]:
            return None
        if mtime_ns >= self._written - RACY_NS:
            return None
        return str(row[3])

    def remember(self, path: str, mtime_ns: int, size: int, inode: int, digest: str) -> None:
        row = [mtime_ns, size, inode, digest]
        # A file that was too young to be trusted is written again, with the newer time of this index.
        if self._index.get(path) != row or mtime_ns >= self._written - RACY_NS:
            self._index[path] = row
            self._changed = True

    # ------------------------------------------------------------------------------------------- entries

    def get(self, digest: str) -> bytes | None:
        """The payload of a content; None where there is none."""
        return self._read(os.path.join("facts", digest[:2], digest))

    def put(self, digest: str, payload: bytes) -> None:
        self._write(os.path.join("facts", digest[:2], digest), payload)

    def get_run(self, key: str) -> bytes | None:
        return self._read(os.path.join("runs", key))

    def put_run(self, key: str, payload: bytes) -> None:
        self._write(os.path.join("runs", key), payload)

    def close(self) -> None:
        """Write the index if it changed, and now and then throw old entries away."""
        if not self._changed:
            return
        body = json.dumps({"written": self._opened, "files": self._index}, sort_keys=True).encode()
        self._write(INDEX, body)
        self._mark()
        if self._opened % 32 == 0:
            self._sweep()

    # ------------------------------------------------------------------------------------------- the disk

    def _read(self, name: str) -> bytes | None:
        path = os.path.join(self.folder, name)
        try:
            with open(path, "rb") as stream:
                data = stream.read()
        except OSError:
            return None
        checksum, _, payload = data.partition(b"\n")
        if checksum != hashlib.sha256(payload).hexdigest()[:32].encode():
            return None
        return payload

    def _read_json(self, name: str) -> object:
        data = self._read(name)
        if data is None:
            return None
        try:
            return json.loads(data)
        except (ValueError, RecursionError):
            return None

    def _write(self, name: str, payload: bytes) -> None:
        path = os.path.join(self.folder, name)
        temporary = f"{path}.{os.getpid()}.{time.monotonic_ns()}.tmp"
        data = hashlib.sha256(payload).hexdigest()[:32].encode() + b"\n" + payload
        try:
            os.makedirs(os.path.dirname(path), exist_ok=True)
            with open(temporary, "wb") as stream:
                stream.write(data)
            os.replace(temporary, path)
        except OSError:
            with contextlib.suppress(OSError):
                os.unlink(temporary)

    def _mark(self) -> None:
        """Tell git and backup programs that this folder can be made again."""
        marks = {
            ".gitignore": "*\n",
            "CACHEDIR.TAG": "Signature: 8a477f597d28d172789f06886806bc55\n# Made by archlint; safe to delete.\n",
        }
        for name, text in marks.items():
            path = os.path.join(self.root, name)
            with contextlib.suppress(OSError):
                if not os.path.exists(path):
                    with open(path, "x", encoding="utf-8") as stream:
                        stream.write(text)

    def _sweep(self) -> None:
        oldest = time.time() - KEPT_SECONDS
        for folder, _, names in os.walk(self.folder):
            for name in names:
                path = os.path.join(folder, name)
                with contextlib.suppress(OSError):
                    if os.stat(path).st_mtime < oldest and name != INDEX:
                        os.unlink(path)


class NullStore:
    """No cache: everything is a miss and nothing is kept."""

    def lookup(self, path: str, mtime_ns: int, size: int, inode: int) -> str | None:
        return None

    def remember(self, path: str, mtime_ns: int, size: int, inode: int, digest: str) -> None:
        return None

    def get(self, digest: str) -> bytes | None:
        return None

    def put(self, digest: str, payload: bytes) -> None:
        return None

    def get_run(self, key: str) -> bytes | None:
        return None

    def put_run(self, key: str, payload: bytes) -> None:
        return None

    def close(self) -> None:
        return None

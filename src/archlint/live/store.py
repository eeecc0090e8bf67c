"""The cache of a workspace in memory, above the one on the disk."""

from __future__ import annotations

import time
from collections.abc import Mapping

from archlint.syntax.cache import RACY_NS, NullStore, Stamp, Store
from archlint.syntax.files import source_digest

_MOST = 20_000
"""How many payloads are kept: a workspace of thousands of files, and what was typed today."""


class LiveStore(NullStore):
    """Keeps facts in memory, and on the disk what files on the disk say.

    What an editor holds and has not saved is never written to the disk.
    """

    lasts = True

    def __init__(self, disk: Store | NullStore) -> None:
        self._disk = disk
        self._unsaved: dict[str, str] = {}
        self._foreign: set[str] = set()
        """The digests of what was never seen on the disk."""
        self._stamps: dict[str, tuple[Stamp, str]] = {}
        self._payloads: dict[str, bytes] = {}

    def hold(self, unsaved: Mapping[str, bytes]) -> None:
        """From now on these files, by absolute path, are what an editor holds of them."""
        self._unsaved = {path: source_digest(data) for path, data in unsaved.items()}
        self._foreign.update(self._unsaved.values())

    def lookup(self, path: str, stamp: Stamp) -> str | None:
        held = self._unsaved.get(path)
        if held is not None:
            return held
        known = self._stamps.get(path)
        return known[1] if known is not None and known[0] == stamp else self._disk.lookup(path, stamp)

    def remember(self, path: str, stamp: Stamp, digest: str) -> None:
        if path in self._unsaved:
            return
        self._foreign.discard(digest)
        self._disk.remember(path, stamp, digest)
        if stamp[0] + RACY_NS < time.time_ns():
            self._stamps[path] = (stamp, digest)

    def get(self, digest: str) -> bytes | None:
        payload = self._payloads.get(digest)
        if payload is None and digest not in self._foreign:
            payload = self._disk.get(digest)
            if payload is not None:
                self._payloads[digest] = payload
        return payload

    def put(self, digest: str, payload: bytes) -> None:
        if len(self._payloads) >= _MOST:
            self._payloads.clear()
        self._payloads[digest] = payload
        if digest.rpartition("-")[2] not in self._foreign:
            self._disk.put(digest, payload)

    def get_programs(self, key: str) -> bytes | None:
        return self._disk.get_programs(key)

    @property
    def takes_programs(self) -> bool:
        return not self._unsaved and self._disk.takes_programs

    def put_programs(self, key: str, payload: bytes) -> None:
        self._disk.put_programs(key, payload)

    def close(self) -> None:
        self._disk.close()


__all__ = ["LiveStore"]

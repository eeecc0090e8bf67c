"""The documents that are open in an editor."""

from __future__ import annotations

import os
from types import MappingProxyType

from archlint.live.buffers import Buffer, Buffers, as_saved
from archlint.server.uris import Addresses, path_of


class Documents:
    """Changed by the thread that talks with the editor; :attr:`buffers` may be read by any."""

    def __init__(self) -> None:
        self._buffers: dict[str, Buffer] = {}
        self._addresses: dict[str, str] = {}
        self.buffers: Buffers = MappingProxyType({})
        """The texts of now; another object after each change."""

    @property
    def addresses(self) -> Addresses:
        return Addresses(dict(self._addresses))

    def put(self, uri: str, text: str, version: int | None) -> str | None:
        """Note the text of a document; returns its path, None where it is no file: that of a folder would have all of
        it analysed, which may be the whole disk."""
        path = path_of(uri)
        if path is None or os.path.isdir(path):
            return None
        self._addresses[path] = uri
        self._set({**self._buffers, path: Buffer(as_saved(text), version)})
        return path

    def remove(self, uri: str) -> str | None:
        """Note that a document was closed; returns its path.  Its address stays as the editor spelt it."""
        path = path_of(uri)
        if path in self._buffers:
            self._set({other: buffer for other, buffer in self._buffers.items() if other != path})
        return path

    def version(self, path: str) -> int | None:
        buffer = self._buffers.get(path)
        return None if buffer is None else buffer.version

    def _set(self, buffers: dict[str, Buffer]) -> None:
        self._buffers = buffers
        self.buffers = MappingProxyType(buffers)


__all__ = ["Documents"]

"""Facts that are decoded once, however often a workspace is analysed."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING

from archlint.libraries.screen import WORDS
from archlint.syntax.facts import Facts, decode
from archlint.syntax.files import FactsOfFiles
from archlint.syntax.python import gate

if TYPE_CHECKING:
    from archlint.monitor import Monitor
    from archlint.syntax.files import Cache
    from archlint.workspace.model import SourceFile

Decoded = dict[bytes, "Facts | None"]
"""Facts by their encoded form."""


class LiveFacts(FactsOfFiles):
    """The facts of files of which some, by absolute path, have other bytes than on the disk.

    ``decoded`` are the facts that an earlier analysis has used; those of this one are added to ``used``.
    """

    def __init__(self, cache: Cache, held: Mapping[str, bytes], decoded: Decoded, monitor: Monitor) -> None:
        super().__init__(cache, lambda: WORDS, jobs=1, monitor=monitor, read=_reader(held))
        self._decoded_before = decoded
        self.used: Decoded = {}

    def _decoded(self, payload: bytes) -> Facts | None:
        if payload not in self.used:
            known = self._decoded_before.get(payload)
            self.used[payload] = decode(payload) if known is None else known
        return self.used[payload]


def _reader(held: Mapping[str, bytes]) -> Callable[[SourceFile], bytes | gate.Refusal]:
    def read(file: SourceFile) -> bytes | gate.Refusal:
        data = held.get(file.path)
        if data is None:
            return gate.read_bytes(file.path)
        return data if len(data) <= gate.MAX_BYTES else gate.refused_for_size(len(data))

    return read


__all__ = ["Decoded", "LiveFacts"]

"""What is said of the facts of single files, kept from one run to the next.

A summary is data that follows from the facts of one file alone.  It is kept under the digest of these, so that an edit
of one file leaves those of all others.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import field
from functools import cached_property
from typing import Any, TypeVar, cast

import msgspec

from archlint.records import dataclass

Result = TypeVar("Result")
_Rows = dict[str, dict[str, msgspec.Raw]]
"""The encoded summaries by the digest of the facts, and by what they say."""


def _nothing() -> None:
    return None


def _unknown(file: str) -> None:
    return None


@dataclass(eq=False)
class Summaries:
    """The summaries of a workspace.  ``read`` gives what :meth:`written` has made in an earlier run, and ``digest_of``
    what stands for the facts of a file, by its shown path; None for one that has none.  ``surroundings`` stands for the
    code that makes the summaries."""

    read: Callable[[], bytes | None] = _nothing
    digest_of: Callable[[str], str | None] = _unknown
    surroundings: str = ""
    changed: bool = field(default=False, init=False)
    """Whether there is something new to keep."""
    _digests: dict[str, str | None] = field(default_factory=dict, init=False)
    _known: dict[tuple[str, str], Any] = field(default_factory=dict, init=False)
    """What was asked for in this run, by the digest and by what it says."""
    _decoders: dict[str, msgspec.msgpack.Decoder[Any]] = field(default_factory=dict, init=False)
    _new: list[tuple[str, str]] = field(default_factory=list, init=False)
    """The same of what was made since somebody took it."""

    def of(self, file: str, name: str, kind: Any, work: Callable[[], Result]) -> Result:
        """The summary ``name`` of a file, which is of a type ``kind``; ``work`` is done where it is not known."""
        digest = self._digest(file)
        if digest is None:
            return work()
        if (digest, name) not in self._known:
            self._known[digest, name] = self._stored_or_made(digest, name, kind, work)
        return cast("Result", self._known[digest, name])

    def _digest(self, file: str) -> str | None:
        if file not in self._digests:
            self._digests[file] = self.digest_of(file)
        return self._digests[file]

    def has_nothing_of(self, file: str) -> bool:
        """Whether nothing is known of a file, and something could be kept."""
        digest = self._digest(file)
        return digest is not None and not self._rows.get(digest)

    def _stored_or_made(self, digest: str, name: str, kind: Any, work: Callable[[], Result]) -> Result:
        rows = self._rows.setdefault(digest, {})
        if name in rows:
            try:
                return cast("Result", self._decoder(name, kind).decode(rows[name]))
            except msgspec.MsgspecError:
                pass  # of another form: made anew
        result = work()
        rows[name] = msgspec.Raw(msgspec.msgpack.encode(result))
        self._new.append((digest, name))
        self.changed = True
        return result

    def _decoder(self, name: str, kind: Any) -> msgspec.msgpack.Decoder[Any]:
        """Reads one summary of any file: to make what reads a type takes longer than to read with it."""
        if name not in self._decoders:
            self._decoders[name] = msgspec.msgpack.Decoder(kind)
        return self._decoders[name]

    def take_new(self) -> bytes:
        """What was made since the last time, for another process."""
        rows: _Rows = {}
        for digest, name in self._new:
            rows.setdefault(digest, {})[name] = self._rows[digest][name]
        self._new = []
        return msgspec.msgpack.encode(rows)

    def add(self, payload: bytes) -> None:
        """Add what another process has made of the same files."""
        for digest, rows in msgspec.msgpack.decode(payload, type=_Rows).items():
            self._rows.setdefault(digest, {}).update(rows)
            self.changed = True

    @cached_property
    def _rows(self) -> _Rows:
        try:
            surroundings, rows = msgspec.msgpack.decode(self.read() or b"", type=tuple[str, _Rows])
        except msgspec.MsgspecError:
            return {}
        return rows if surroundings == self.surroundings else {}

    def written(self) -> bytes:
        """All that is known of the files that were asked for in this run."""
        digests = sorted({digest for digest in self._digests.values() if digest is not None})
        return msgspec.msgpack.encode((self.surroundings, {digest: self._rows.get(digest, {}) for digest in digests}))


__all__ = ["Summaries"]

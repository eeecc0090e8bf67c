"""What is said of the facts of single files, kept from one run to the next.

A summary is data that follows from the facts of one file alone.  It is kept under the digest of these, so that an edit
of one file leaves those of all others.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any, TypeVar, cast

import msgspec

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

    def of(self, file: str, name: str, kind: Any, work: Callable[[], Result]) -> Result:
        """The summary ``name`` of a file, which is of a type ``kind``; ``work`` is done where it is not known."""
        if file not in self._digests:
            self._digests[file] = self.digest_of(file)
        digest = self._digests[file]
        if digest is None:
            return work()
        if (digest, name) not in self._known:
            self._known[digest, name] = self._stored_or_made(digest, name, kind, work)
        return cast("Result", self._known[digest, name])

    def _stored_or_made(self, digest: str, name: str, kind: Any, work: Callable[[], Result]) -> Result:
        rows = self._rows.setdefault(digest, {})
        if name in rows:
            try:
                return cast("Result", msgspec.msgpack.decode(rows[name], type=kind))
            except msgspec.MsgspecError:
                pass  # of another form: made anew
        result = work()
        rows[name] = msgspec.Raw(msgspec.msgpack.encode(result))
        self.changed = True
        return result

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

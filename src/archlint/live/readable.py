"""Half-typed files: while a file does not compile, the rest of the workspace is judged with what it said before."""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import field
from typing import TYPE_CHECKING

from archlint.checks.registry import unreadable
from archlint.launch.files import launch_facts_of
from archlint.live.buffers import Buffers, Shifts
from archlint.records import dataclass
from archlint.syntax.compile import compile_sources
from archlint.syntax.facts import decode
from archlint.syntax.files import source_digest
from archlint.workspace.kinds import kind_of
from archlint.workspace.model import LAUNCH_TEXT_KINDS, PYTHON_KINDS
from archlint.workspace.tree import decoded

if TYPE_CHECKING:
    from archlint.finding import Finding
    from archlint.live.store import LiveStore

Problem = tuple[int, int, str]
"""Line, column and message of what is wrong with a file; lines and columns start at 1."""


@dataclass(frozen=True)
class Readable:
    """What is analysed in place of what an editor holds.  ``held`` are the bytes by absolute path; of ``broken`` files
    they are those that compiled last."""

    held: Mapping[str, bytes]
    broken: Mapping[str, Problem] = field(default_factory=dict)
    shifts: Mapping[str, Shifts] = field(default_factory=dict)
    """Where the lines of broken files are now."""

    def findings(self, base: str) -> list[Finding]:
        """What is wrong with the broken files, shown as seen from ``base``."""
        return [
            unreadable(os.path.relpath(path, base).replace(os.sep, "/"), *problem)
            for path, problem in sorted(self.broken.items())
        ]


class LastReadable:
    """Remembers of each file that an editor holds what it said when it last compiled."""

    def __init__(self, store: LiveStore) -> None:
        self._store = store
        self._good: dict[str, bytes] = {}
        self._judged: dict[str, tuple[bytes, Problem | None]] = {}

    def of(self, buffers: Buffers) -> Readable:
        """What to analyse.  A file that never compiled is analysed as it is."""
        held: dict[str, bytes] = {}
        broken: dict[str, Problem] = {}
        shifts: dict[str, Shifts] = {}
        for path, buffer in buffers.items():
            problem = self._problem(path, buffer.data)
            good = self._good.get(path)
            if problem is None or good is None:
                held[path] = buffer.data
                if problem is None:
                    self._good[path] = buffer.data
                continue
            held[path] = good
            broken[path] = problem
            shifts[path] = Shifts(good.decode("utf-8", "replace"), buffer.data.decode("utf-8", "replace"))
        for path in self._good.keys() - buffers.keys():  # closed: the disk speaks for it
            del self._good[path]
            self._judged.pop(path, None)
        return Readable(held, broken, shifts)

    def _problem(self, path: str, data: bytes) -> Problem | None:
        known = self._judged.get(path)
        if known is None or known[0] != data:
            known = self._judged[path] = (data, self._problem_in(path, data))
        return known[1]

    def _problem_in(self, path: str, data: bytes) -> Problem | None:
        folder, name = os.path.split(path)
        kind = kind_of(name, os.path.basename(folder))
        if kind in PYTHON_KINDS:
            problems = self._of_python(data)
        elif kind in LAUNCH_TEXT_KINDS:
            problems = _of_launch_file(path, data)
        else:
            return None
        return problems[0] if problems else None

    def _of_python(self, data: bytes) -> list[Problem]:
        from archlint.libraries.screen import WORDS

        if not any(word in data for word in WORDS):
            return []  # nobody compiles it
        digest = source_digest(data)
        payload = self._store.get(digest)
        if payload is None:
            [result] = compile_sources([data], jobs=1)
            payload = result.payload
            if result.lasting:
                self._store.put(digest, payload)
        facts = decode(payload)
        return [] if facts is None else [(p.line, p.column, p.message) for p in facts.problems if not p.internal]


def _of_launch_file(path: str, data: bytes) -> list[Problem]:
    try:
        facts = launch_facts_of(path, decoded(data))
    except UnicodeDecodeError:
        return []
    return [(p.line, p.column, p.message) for p in facts.problems if not p.internal]


__all__ = ["LastReadable", "Problem", "Readable"]

"""The facts of a workspace's files: from the cache where it has them, compiled where it has not."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Protocol

from archlint.facts import gate
from archlint.facts.store import digest_of

if TYPE_CHECKING:
    from archlint.facts.model import Facts
    from archlint.workspace.model import SourceFile

_IRRELEVANT = b"-"


class Cache(Protocol):
    """What is needed of a :class:`~archlint.facts.store.Store`."""

    def lookup(self, path: str, mtime_ns: int, size: int, inode: int) -> str | None: ...
    def remember(self, path: str, mtime_ns: int, size: int, inode: int, digest: str) -> None: ...
    def get(self, digest: str) -> bytes | None: ...
    def put(self, digest: str, payload: bytes) -> None: ...


class FactsOfFiles:
    """Facts by file: :meth:`prepare` compiles what is new in one go, the linker asks for more one by one."""

    def __init__(self, cache: Cache, jobs: int | None = None) -> None:
        self._cache = cache
        self._jobs = jobs
        self._digests: dict[str, str] = {}
        self._payloads: dict[str, bytes] = {}
        self._facts: dict[str, Facts | None] = {}
        self.compiled = 0
        """How many files had to be parsed in this run."""

    def prepare(self, files: Iterable[SourceFile]) -> None:
        """Make sure that each file is known: cached, screened out, or compiled now."""
        waiting: list[tuple[SourceFile, str, bytes]] = []
        for file in files:
            digest = self._known_digest(file)
            if digest is not None:
                payload = self._cache.get(digest)
                if payload is not None:
                    self._keep(file, digest, payload)
                    continue
            found = self._read(file)
            if found is not None:
                waiting.append((file, *found))
        self._compile(waiting)

    def digest(self, file: SourceFile) -> str | None:
        """The digest of a file's content; None where it cannot be read."""
        return self._digests.get(file.path)

    def relevant(self, file: SourceFile) -> bool:
        """Whether the screen kept a file."""
        return self._payloads.get(file.path, _IRRELEVANT) != _IRRELEVANT

    def facts_of(self, file: SourceFile) -> Facts | None:
        """The facts of a file; one that the screen left out is compiled now.  None for what is no Python."""
        if file.path in self._facts:
            return self._facts[file.path]
        payload = self._payloads.get(file.path)
        if payload is None or payload == _IRRELEVANT:
            payload = self._on_demand(file)
        self._facts[file.path] = None if payload is None else self._decoded(payload)
        return self._facts[file.path]

    # --------------------------------------------------------------------------------------------- inside

    def _known_digest(self, file: SourceFile) -> str | None:
        return self._cache.lookup(file.path, file.mtime_ns, file.size, file.inode)

    def _keep(self, file: SourceFile, digest: str, payload: bytes) -> None:
        self._digests[file.path] = digest
        self._payloads[file.path] = payload
        self._cache.remember(file.path, file.mtime_ns, file.size, file.inode, digest)

    def _read(self, file: SourceFile) -> tuple[str, bytes] | None:
        """``(digest, bytes)`` of a file that must be compiled; what needs no compiling is settled here."""
        data = gate.read_bytes(file.path)
        if isinstance(data, gate.Refusal):
            self._refuse(file, data)
            return None
        digest = digest_of(data, _salt())
        payload = self._cache.get(digest)
        if payload is not None:
            self._keep(file, digest, payload)
            return None
        if not gate.relevant(data) and b"\0" not in data:
            self._cache.put(digest, _IRRELEVANT)
            self._keep(file, digest, _IRRELEVANT)
            return None
        return digest, data

    def _refuse(self, file: SourceFile, refusal: gate.Refusal) -> None:
        from archlint.facts.model import FACTS_VERSION, Facts, FileProblem, encode

        problem = FileProblem(refusal.line, refusal.column, refusal.message)
        # Not readable now: nothing to remember.
        self._payloads[file.path] = encode(Facts(FACTS_VERSION, problems=[problem]))

    def _compile(self, waiting: list[tuple[SourceFile, str, bytes]]) -> None:
        if not waiting:
            return
        from archlint.facts.compile import compile_sources

        unique: dict[str, bytes] = {}
        for _, digest, data in waiting:
            unique.setdefault(digest, data)
        results = dict(zip(unique, compile_sources(list(unique.values()), self._jobs), strict=True))
        self.compiled += len(unique)
        for digest, result in results.items():
            if result.lasting:
                self._cache.put(digest, result.payload)
        for file, digest, _ in waiting:
            self._keep(file, digest, results[digest].payload)

    def _on_demand(self, file: SourceFile) -> bytes | None:
        """Compile a file that the screen left out, because an import leads to it."""
        digest = self._digests.get(file.path)
        key = None if digest is None else "all-" + digest
        if key is not None:
            payload = self._cache.get(key)
            if payload is not None:
                return payload
        data = gate.read_bytes(file.path)
        if isinstance(data, gate.Refusal):
            return None
        from archlint.facts.compile import compile_sources

        (result,) = compile_sources([data], 1)
        self.compiled += 1
        if key is not None and result.lasting:
            self._cache.put(key, result.payload)
        return result.payload

    def _decoded(self, payload: bytes) -> Facts | None:
        from archlint.facts.model import decode

        return decode(payload)


def _salt() -> str:
    from archlint.facts.model import FACTS_VERSION

    return f"python {FACTS_VERSION}"

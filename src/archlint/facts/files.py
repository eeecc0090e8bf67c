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
    """Facts by file.  :meth:`prepare` compiles what is new in one go; the linker asks for the rest one by one."""

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
        waiting: list[tuple[SourceFile, str, str]] = []
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
        self._facts[file.path] = None if payload is None else self._decoded(file, payload)
        return self._facts[file.path]

    # --------------------------------------------------------------------------------------------- inside

    def _known_digest(self, file: SourceFile) -> str | None:
        return self._cache.lookup(file.path, file.mtime_ns, file.size, file.inode)

    def _keep(self, file: SourceFile, digest: str, payload: bytes) -> None:
        self._digests[file.path] = digest
        self._payloads[file.path] = payload
        self._cache.remember(file.path, file.mtime_ns, file.size, file.inode, digest)

    def _read(self, file: SourceFile) -> tuple[str, str] | None:
        """``(digest, text)`` of a file that must be compiled; what needs no compiling is settled here."""
        data = gate.read_bytes(file.path)
        if isinstance(data, gate.Refusal):
            self._refuse(file, None, data)
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
        text = gate.decode(data)
        refusal = text if isinstance(text, gate.Refusal) else gate.inspect(text)
        if refusal is not None:
            self._refuse(file, digest, refusal)
            return None
        assert isinstance(text, str)
        return digest, text

    def _refuse(self, file: SourceFile, digest: str | None, refusal: gate.Refusal) -> None:
        from archlint.facts.model import FACTS_VERSION, Facts, FileProblem, encode

        problem = FileProblem(refusal.line, refusal.column, refusal.message)
        payload = encode(Facts(FACTS_VERSION, problems=[problem]))
        if digest is None:
            self._payloads[file.path] = payload  # not readable now: nothing to remember
            return
        self._cache.put(digest, payload)
        self._keep(file, digest, payload)

    def _compile(self, waiting: list[tuple[SourceFile, str, str]]) -> None:
        if not waiting:
            return
        from archlint.facts.compile import compile_texts

        unique: dict[str, str] = {}
        for _, digest, text in waiting:
            unique.setdefault(digest, text)
        payloads = dict(zip(unique, compile_texts(list(unique.values()), self._jobs), strict=True))
        self.compiled += len(unique)
        for digest, text in unique.items():
            payloads[digest] = _judged(text, payloads[digest])
            self._cache.put(digest, payloads[digest])
        for file, digest, _ in waiting:
            self._keep(file, digest, payloads[digest])

    def _on_demand(self, file: SourceFile) -> bytes | None:
        """Compile a file that the screen left out, because an import leads to it."""
        digest = self._digests.get(file.path)
        key = None if digest is None else "all-" + digest
        if key is not None:
            payload = self._cache.get(key)
            if payload is not None:
                return payload
        source = gate.read_source(file.path)
        if isinstance(source, gate.Refusal):
            return None
        from archlint.facts.compile import compile_texts

        payload = compile_texts([source.text], 1)[0]
        self.compiled += 1
        if key is not None:
            self._cache.put(key, payload)
        return payload

    def _decoded(self, file: SourceFile, payload: bytes) -> Facts | None:
        from archlint.facts.deep_stack import raised_recursion_limit
        from archlint.facts.model import decode

        with raised_recursion_limit():
            return decode(payload)


def _salt() -> str:
    from archlint.facts.model import FACTS_VERSION

    return f"python {FACTS_VERSION}"


def _judged(text: str, payload: bytes) -> bytes:
    """Add what Python's compiler refuses to facts that have no problem of their own; word Python 2 as such."""
    from archlint.facts.model import Facts, FileProblem, decode, encode

    facts = decode(payload)
    if facts is None:
        return payload
    if facts.problems:
        first = facts.problems[0]
        if first.message.startswith("syntax error") and gate.looks_like_python_2(text):
            message = f"{first.message} (this looks like Python 2, which ROS 2 does not run)"
            rest = facts.problems[1:]
            problems = [FileProblem(first.line, first.column, message), *rest]
            return encode(Facts(facts.version, facts.body, facts.suppressions, problems, facts.exports))
        return payload
    refusal = gate.compile_refusal(text)
    if refusal is None:
        return payload
    problem = FileProblem(refusal.line, refusal.column, refusal.message)
    return encode(Facts(facts.version, facts.body, facts.suppressions, [problem], facts.exports))

"""The facts of a workspace's files: from the cache where it has them, compiled where it has not."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Sequence
from typing import TYPE_CHECKING, Protocol

from archlint.monitor import Monitor
from archlint.syntax.cache import Stamp, digest_of
from archlint.syntax.compile import Compiled, Language, compile_sources
from archlint.syntax.facts import FACTS_VERSION, Facts, FileProblem, Span, decode, encode
from archlint.syntax.imported_names import imported, included, modules_of, names_of, targets_of
from archlint.syntax.python import gate
from archlint.syntax.walk import statements_of

if TYPE_CHECKING:
    from archlint.syntax.pools import Pool
    from archlint.workspace.model import SourceFile, SourceKind

_CPP_WORD = b"rclcpp"
"""A C++ file without it is read only where another includes it."""
_IRRELEVANT = b"-"
"""How the entry of a file begins that the screen left out; the modules that it imports follow, a line each."""

_ROS1 = b"-1"
"""The same of a file for ROS 1."""


class Cache(Protocol):
    """What is needed of a :class:`~archlint.syntax.cache.Store`."""

    def lookup(self, path: str, stamp: Stamp) -> str | None: ...
    def remember(self, path: str, stamp: Stamp, digest: str) -> None: ...
    def get(self, digest: str) -> bytes | None: ...
    def put(self, digest: str, payload: bytes) -> None: ...


Reader = Callable[["SourceFile"], "bytes | gate.Refusal"]
"""Gives the bytes of a file, or says why they cannot be had."""


def _from_disk(file: SourceFile) -> bytes | gate.Refusal:
    return gate.read_bytes(file.path)


class FactsOfFiles:
    """Facts by file: :meth:`prepare` compiles what is new in one go, the linker asks for more one by one.

    ``words`` gives the words of the screen: a file that has none of them is compiled only where another leads to it.
    It is called when a file has to be read.  ``read`` gives the bytes of files that are not on the disk.
    """

    def __init__(
        self,
        cache: Cache,
        words: Callable[[], Sequence[bytes]],
        jobs: int | None = None,
        monitor: Monitor | None = None,
        read: Reader | None = None,
        pool: Pool | None = None,
    ) -> None:
        self._cache = cache
        self._bytes_of = read or _from_disk
        self._words = words
        self._jobs = jobs
        self._pool = pool
        self._monitor = monitor or Monitor()
        self._digests: dict[str, str] = {}
        self._payloads: dict[str, bytes] = {}
        self._facts: dict[str, Facts | None] = {}
        self._outlines: dict[str, str] = {}
        self._screened: dict[str, bytes] = {}
        """The entries of the files that the screen left out, also of those that were taken back."""
        self.compiled = 0
        """How many files had to be parsed in this run."""
        self._fresh_imports: set[str] = set()
        self._ahead: dict[str, bytes] = {}
        self._seen: set[str] = set()
        self.lasting = True
        """False where a file failed for a passing reason: nothing may be concluded for the next run."""

    def prepare(self, files: Sequence[SourceFile], ros1: Collection[SourceFile] = ()) -> None:
        """Make sure that each file is known: cached, screened out, or compiled now.  The files ``ros1`` are for ROS 1,
        or for another rclpy than that of ROS 2, whatever they import."""
        old = {file.path for file in ros1}
        self._payloads.update((path, _ROS1) for path in old)
        self._prepare(file for file in files if file.path not in old)
        self._screened = {file.path: self._payloads[file.path] for file in files if not self.relevant(file)}
        self._widen(files)
        self._look_ahead(files)

    def _look_ahead(self, files: Sequence[SourceFile]) -> None:
        """Compile together what the screen left out but is read nevertheless: launch files, ``setup.py``, and what
        files that were compiled now import.  A process for each would cost more than the compiling."""
        left: dict[str, list[SourceFile]] = {}
        ahead: dict[str, SourceFile] = {}
        for file in files:
            if self.relevant(file):
                continue
            if file.kind == "launch_python" or file.path.endswith("setup.py"):
                ahead[file.path] = file
            for name in names_of([file]):
                left.setdefault(name, []).append(file)
        names = self._fresh_imports
        while names:
            new = {file.path: file for name in names for file in left.get(name, ()) if file.path not in ahead}
            ahead.update(new)
            names = {name for file in new.values() for name in self._imports(file)}
        self._ahead = self._on_demand(ahead[path] for path in sorted(ahead))

    def _widen(self, files: Sequence[SourceFile]) -> None:
        """Take back what the screen left out but imports a module that it kept: a class derived from a node
        class elsewhere, or a caller of a helper, may hold none of the words itself."""
        left = [file for file in files if not self.relevant(file) and not self.is_ros1(file)]
        kept = names_of(file for file in files if self.relevant(file))
        while True:
            importers = [file for file in left if not kept.isdisjoint(self._imports(file))]
            if not importers:
                return
            self._payloads.update(self._on_demand(importers))
            left = [file for file in left if file not in importers]
            kept = names_of(importers)

    def _imports(self, file: SourceFile) -> set[str]:
        """The dotted names of modules that a screened-out file may import."""
        return targets_of(file, self._payloads.get(file.path, b"").split(b"\n")[1:])

    def _prepare(self, files: Iterable[SourceFile]) -> None:
        waiting: list[tuple[SourceFile, str, bytes]] = []
        for file in files:
            digest = self._known_digest(file)
            if digest is not None:
                payload = self._cache.get(digest)
                if payload is not None:
                    self._keep(file, digest, payload)
                    continue
            source = self._read(file)
            if source is not None:
                waiting.append((file, *source))
        self._compile(waiting)

    def digest(self, file: SourceFile) -> str | None:
        """The digest of a file's content; None where it cannot be read."""
        return self._digests.get(file.path)

    def meaning(self, file: SourceFile) -> str | None:
        """What stands for the code of a file: the same where an edit changes nothing but comments at its end.  None
        where it cannot be read."""
        return self.outline(file) if self.relevant(file) else self.digest(file)

    def outline(self, file: SourceFile) -> str | None:
        """As :meth:`meaning`; of a file that the screen left out it stands for what it imports and no more."""
        if self.digest(file) is None:
            return None
        if file.path not in self._outlines:
            self._outlines[file.path] = digest_of(self._payloads[file.path], "facts")
        return self._outlines[file.path]

    def meaning_of_read(self, file: SourceFile) -> str | None:
        """As :meth:`meaning`, of a file that the screen left out and somebody reads nevertheless."""
        payload = self._payload_of(file)
        return None if payload is None else digest_of(payload, "facts")

    def relevant(self, file: SourceFile) -> bool:
        """Whether the screen kept a file."""
        return not self._payloads.get(file.path, _IRRELEVANT).startswith(_IRRELEVANT)

    def imports_of(self, file: SourceFile, module: SourceFile) -> Span | None:
        """Where a file imports a module of the workspace; None where it does not."""
        file_facts = self.facts_of(file)
        wanted = names_of([module])
        for statement in statements_of(file_facts.body) if file_facts is not None else ():
            if not wanted.isdisjoint(targets_of(file, modules_of(statement))):
                return getattr(statement, "span", None)
        return None

    def is_ros1(self, file: SourceFile) -> bool:
        """Whether a file is a program or module for ROS 1, or passed over as one."""
        return self._payloads.get(file.path, b"").startswith(_ROS1)

    def was_read(self, file: SourceFile) -> bool:
        """Whether somebody asked for the facts of a file: it matters, or what matters imports it."""
        return file.path in self._facts or file.path in self._seen

    def note_read(self, paths: Iterable[str]) -> None:
        """The result of an earlier run stands for reading these files."""
        self._seen.update(paths)

    def facts_of(self, file: SourceFile) -> Facts | None:
        """The facts of a file; one that the screen left out is compiled now.  None for what is no code."""
        if file.path in self._facts:
            return self._facts[file.path]
        payload = self._payload_of(file)
        facts = None if payload is None else self._decoded(payload)
        self._facts[file.path] = self._compiled_anew(file) if payload is not None and facts is None else facts
        return self._facts[file.path]

    def encoded(self, files: Sequence[SourceFile]) -> list[tuple[bytes, bytes]]:
        """For each file the entry of the screen, empty for one that it kept, and the encoded facts."""
        left = (file for file in files if not self.relevant(file) and file.path not in self._ahead)
        self._ahead.update(self._on_demand(left))
        return [(self._screened.get(file.path, b""), self._payload_of(file) or b"") for file in files]

    def _payload_of(self, file: SourceFile) -> bytes | None:
        payload = self._payloads.get(file.path)
        if payload is not None and not payload.startswith(_IRRELEVANT):
            return payload
        if file.path not in self._ahead:
            self._ahead.update(self._on_demand([file]))
        return self._ahead.get(file.path)

    def _compiled_anew(self, file: SourceFile) -> Facts | None:
        """The facts of a file whose entry is one of another archlint; the next run finds them."""
        if isinstance(data := self._bytes_of(file), gate.Refusal):
            return None
        [result] = self._compile_all([file], [data])
        if result.lasting and file.path in self._digests:
            self._cache.put(self._digests[file.path], result.payload)
        return self._decoded(result.payload)

    def _compile_all(self, files: Sequence[SourceFile], sources: Sequence[bytes]) -> list[Compiled]:
        """The facts of what is written in some files."""

        def on_done(number: int, seconds: float) -> None:
            self._monitor.compiled(files[number].relative, seconds)

        self._monitor.compiling(len(files))
        by_language: dict[Language, list[int]] = {}
        for number, file in enumerate(files):
            by_language.setdefault(language_of(file.kind), []).append(number)
        if by_language.keys() == {"python"}:
            return compile_sources(sources, self._jobs, on_done=on_done, pool=self._pool)
        results: dict[int, Compiled] = {}
        for language, numbers in sorted(by_language.items(), reverse=True):
            results.update(zip(numbers, self._compile_part(files, sources, language, numbers), strict=True))
        return [results[number] for number in range(len(files))]

    def _compile_part(
        self, files: Sequence[SourceFile], sources: Sequence[bytes], language: Language, numbers: Sequence[int]
    ) -> list[Compiled]:
        """The facts of those of some files that are of one language."""

        def on_done(number: int, seconds: float) -> None:
            self._monitor.compiled(files[numbers[number]].relative, seconds)

        chosen = [sources[number] for number in numbers]
        return compile_sources(chosen, self._jobs, on_done=on_done, pool=self._pool, language=language)

    # --------------------------------------------------------------------------------------------- inside

    def _known_digest(self, file: SourceFile) -> str | None:
        return self._cache.lookup(file.path, file.stamp)

    def _keep(self, file: SourceFile, digest: str, payload: bytes) -> None:
        self._digests[file.path] = digest
        self._payloads[file.path] = payload
        self._cache.remember(file.path, file.stamp, digest)

    def _read(self, file: SourceFile) -> tuple[str, bytes] | None:
        """``(digest, bytes)`` of a file that must be compiled; what needs no compiling is settled here."""
        data = self._bytes_of(file)
        if isinstance(data, gate.Refusal):
            words = (_CPP_WORD,) if file.kind == "cpp" else self._words()
            if data.is_large and file.kind != "parameter_library" and not gate.mentions_any(file.path, words):
                self._payloads[file.path] = _IRRELEVANT
            else:
                self._refuse(file, data)
            return None
        digest = source_digest(data, language_of(file.kind))
        payload = self._cache.get(digest)
        if payload is not None:
            self._keep(file, digest, payload)
            return None
        if file.kind == "parameter_library":
            return digest, data
        if file.kind == "cpp" and _CPP_WORD not in data:
            payload = b"\n".join((_IRRELEVANT, *included(data)))
            self._cache.put(digest, payload)
            self._keep(file, digest, payload)
            return None
        old = file.kind != "cpp" and gate.is_ros1(data)
        if old or not (file.kind == "cpp" or b"\0" in data or any(word in data for word in self._words())):
            payload = b"\n".join((_ROS1 if old else _IRRELEVANT, *imported(data)))
            self._cache.put(digest, payload)
            self._keep(file, digest, payload)
            return None
        return digest, data

    def _refuse(self, file: SourceFile, refusal: gate.Refusal) -> None:
        problem = FileProblem(refusal.line, refusal.column, refusal.message)
        # Not readable now: nothing to remember.
        self._payloads[file.path] = encode(Facts(FACTS_VERSION, problems=[problem]))

    def _compile(self, waiting: list[tuple[SourceFile, str, bytes]]) -> None:
        if not waiting:
            return
        unique: dict[str, tuple[SourceFile, bytes]] = {}
        for file, digest, data in waiting:
            unique.setdefault(digest, (file, data))
        files, sources = zip(*unique.values(), strict=True)
        results = dict(zip(unique, self._compile_all(files, sources), strict=True))
        self.compiled += len(unique)
        for digest, result in results.items():
            self.lasting &= result.lasting
            if result.lasting:
                self._cache.put(digest, result.payload)
        for file, digest, data in waiting:
            self._keep(file, digest, results[digest].payload)
            if file.kind != "parameter_library":  # what is generated of it imports nothing of the workspace
                self._fresh_imports |= targets_of(file, included(data) if file.kind == "cpp" else imported(data))

    def _on_demand(self, files: Iterable[SourceFile]) -> dict[str, bytes]:
        """Compile files that the screen left out, because imports lead to them; payloads by path."""
        payloads: dict[str, bytes] = {}
        waiting: list[tuple[SourceFile, str | None, bytes]] = []
        for file in files:
            digest = self._digests.get(file.path)
            key = None if digest is None else "all-" + digest
            payload = None if key is None else self._cache.get(key)
            if payload is not None:
                payloads[file.path] = payload
                continue
            data = self._bytes_of(file)
            if not isinstance(data, gate.Refusal):
                waiting.append((file, key, data))
        if not waiting:
            return payloads
        results = self._compile_all([file for file, _, _ in waiting], [data for _, _, data in waiting])
        self.compiled += len(results)
        for (file, key, _), result in zip(waiting, results, strict=True):
            self.lasting &= result.lasting
            if key is not None and result.lasting:
                self._cache.put(key, result.payload)
            payloads[file.path] = result.payload
        return payloads

    def _decoded(self, payload: bytes) -> Facts | None:
        return decode(payload)


def language_of(kind: SourceKind) -> Language:
    """What a file is written in, as it is compiled."""
    match kind:
        case "cpp" | "parameter_library":
            return kind
    return "python"


def source_digest(data: bytes, language: Language = "python") -> str:
    """What the facts of a source are kept under."""
    return digest_of(data, f"{language} {FACTS_VERSION}")

"""One workspace, analysed again and again: what an analysis can use of the one before stays in memory."""

from __future__ import annotations

import os
from collections.abc import Callable, Collection, Iterable, Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from archlint import __version__
from archlint.config.filters import Filters
from archlint.config.seen_from import seen_from
from archlint.engine.findings import judged_in_parts
from archlint.engine.inputs import Inputs, compiled_files, is_input, is_of_package, refuse_nothing
from archlint.engine.memory import Memory
from archlint.engine.passed_over import skipped_files
from archlint.engine.request import NothingToDo, Request
from archlint.live.buffers import Shifts
from archlint.live.facts import LiveFacts
from archlint.live.readable import LastReadable, Readable
from archlint.live.sayings import Change, change_of
from archlint.live.snapshot import Snapshot, shown_now
from archlint.live.store import LiveStore
from archlint.live.tree import DiskMemory, LiveTree
from archlint.monitor import Monitor
from archlint.records import dataclass
from archlint.syntax.cache import NullStore, Store
from archlint.syntax.python.deep_stack import call_with_deep_stack
from archlint.syntax.secret import user_key
from archlint.syntax.signed import CACHE_FOLDER
from archlint.systems.instances import KnownNodes
from archlint.workspace.around import is_below
from archlint.workspace.discovery import find
from archlint.workspace.importable import Importable
from archlint.workspace.membership import read_file
from archlint.workspace.model import LAUNCH_TEXT_KINDS, SourceFile, SourceKind, Workspace

if TYPE_CHECKING:
    from archlint.config.settings import Settings
    from archlint.engine.kept_programs import ResultsInMemory
    from archlint.engine.known import Baseline
    from archlint.finding import Finding
    from archlint.live.buffers import Buffers
    from archlint.live.facts import Decoded
    from archlint.systems.model import System


@dataclass(frozen=True)
class Asked:
    """What an analysis is about: folders and files of the workspace by absolute path, and how they are judged."""

    paths: tuple[str, ...]
    settings: Settings
    baseline: Baseline | None = None


@dataclass(frozen=True)
class _Last:
    """A whole analysis, and what the next one may use of it."""

    asked: Asked
    memory: Memory
    snapshot: Snapshot
    read: frozenset[str]
    """The files whose texts it has read as they are, by their shown paths."""


@dataclass(frozen=True)
class _Since:
    """What has become of the last analysis: the buffers and files of now, where lines of edited files have gone, and
    what all that changes."""

    last: _Last
    own: Buffers
    readable: Readable
    tree: LiveTree
    shifts: dict[str, Shifts]
    change: Change


_CODE: tuple[SourceKind, ...] = ("python", "launch_python", *LAUNCH_TEXT_KINDS)
"""What may be edited without a change of anything but what it says itself."""
_PYTHON: tuple[SourceKind, ...] = ("python", "launch_python")
"""What of it may have comments that are known to be some."""


class LiveWorkspace:
    """The workspace at ``root``, an absolute path, from which findings name their files.  One analysis at a time."""

    def __init__(self, root: str) -> None:
        self.root = root
        self._cache_folder: str | None = None
        self._store = LiveStore(NullStore())
        self._readable = LastReadable(self._store)
        self._found: tuple[Asked, Workspace, Importable] | None = None
        self._disk = DiskMemory()
        self._decoded: Decoded = {}
        self._results: ResultsInMemory = {}
        self._nodes = KnownNodes()
        self._last: _Last | None = None
        """The last whole analysis; None where something has changed since that a first answer would not see."""

    def analyse(self, asked: Asked, buffers: Buffers, monitor: Monitor | None = None) -> Snapshot:
        """What is found with these texts in the editor.

        ``monitor`` may raise what is no ``Exception`` to end the analysis.
        """
        asked = replace(asked, settings=seen_from(self.root, asked.settings))
        self._open_store(asked.settings)
        known = self._known(asked, buffers)
        if known is not None:
            return known
        memory = Memory()
        snapshot = call_with_deep_stack(lambda: self._analyse(asked, buffers, monitor or Monitor(), memory))
        read = frozenset(path for question, path in snapshot.tree.asked if question == "content")
        self._last = _Last(asked, memory, snapshot, read)
        return snapshot

    def first_answer(self, asked: Asked, buffers: Buffers, monitor: Monitor | None = None) -> Snapshot | None:
        """As :meth:`analyse`, but soon: what other launch files start than those with edited code counts as judged.
        None where there is nothing to begin with, or more than code has been edited."""
        asked = replace(asked, settings=seen_from(self.root, asked.settings))
        since = self._since_last(asked, buffers)
        if since is None:
            return None
        moved = self._moved(since)
        if moved is not None:
            return moved
        memory = self._memory_of(since)
        if memory is None:
            return None
        return call_with_deep_stack(lambda: self._analyse(asked, buffers, monitor or Monitor(), memory))

    def _known(self, asked: Asked, buffers: Buffers) -> Snapshot | None:
        """The last analysis, where all that can be compiled says what it said then; None where something does not."""
        since = self._since_last(asked, buffers)
        if since is None or since.change is not Change.NOTHING:
            return None
        return self._finished(replace(since.last.snapshot, buffers=since.own, tree=since.tree), since.readable)

    def _moved(self, since: _Since) -> Snapshot | None:
        """The last analysis, where edits since have changed nothing but the lines of its findings."""
        if since.change is not Change.PLACES:
            return None
        snapshot = since.last.snapshot
        judged = shown_now(snapshot.judged, since.shifts)
        if _places(judged) != _places(snapshot.judged):  # some are on edited lines
            return None
        return self._finished(replace(snapshot, buffers=since.own, judged=judged), since.readable)

    def _since_last(self, asked: Asked, buffers: Buffers) -> _Since | None:
        """What has changed since the last analysis; None where there is none that asked the same."""
        last = self._last
        if last is None or self._found is None or last.asked != asked:
            return None
        own = self._own(buffers)
        readable = self._readable.of(own)
        tree = self._tree_of(last, readable)
        shifts = self._edited(last, tree)
        return _Since(last, own, readable, tree, shifts, self._change(last, tree, shifts))

    def _memory_of(self, since: _Since) -> Memory | None:
        snapshot, shifts = since.last.snapshot, since.shifts
        code = {file.relative for file in snapshot.workspace.of_kind(*_CODE)}
        if len(snapshot.systems) != 1 or not code.issuperset(shifts) or since.change is Change.NOTHING:
            return None
        return Memory(since.last.memory, frozenset(shifts), lambda findings: shown_now(findings, shifts))

    def _tree_of(self, last: _Last, readable: Readable) -> LiveTree:
        """The files of the last analysis as they are now."""
        return LiveTree(last.snapshot.tree.base, Path(last.snapshot.workspace.root), readable.held, self._disk)

    def _change(self, last: _Last, now: LiveTree, edited: Collection[str]) -> Change:
        """What the edits of these files, by their shown paths, change."""
        files = [file for file in last.snapshot.workspace.of_kind(*_PYTHON) if file.relative in edited]
        if len(files) < len(edited) or not last.read.isdisjoint(edited):
            return Change.MORE
        return change_of(files, last.snapshot.tree, now, self._store)

    def _edited(self, last: _Last, now: LiveTree) -> dict[str, Shifts]:
        """Where the lines of the files are, by their shown paths, whose texts are not those of the last analysis."""
        tree = last.snapshot.tree
        texts = {
            file: (tree.content(file), now.content(file))
            for file in sorted({self._shown(path) for path in (*tree.held, *now.held)})
        }
        return {file: Shifts(_text(old), _text(new)) for file, (old, new) in texts.items() if old != new}

    def _shown(self, path: str) -> str:
        return os.path.relpath(path, self.root).replace(os.sep, "/")

    def look_again(self) -> None:
        """Files may have come or gone, or changed on the disk: have the next analysis look at all of them."""
        self._found = self._last = None
        self._disk = DiskMemory()

    def close(self) -> None:
        """Write down what the next server can use."""
        self._store.close()

    def _analyse(self, asked: Asked, buffers: Buffers, monitor: Monitor, memory: Memory) -> Snapshot:
        asked.settings.activate_plugins()
        own = self._own(buffers)
        readable = self._readable.of(own)
        self._store.hold(readable.held)
        workspace, importable = self._files(asked, readable)
        tree = LiveTree(Path(self.root), Path(workspace.root), readable.held, self._disk)
        request = Request(
            asked.paths,
            replace(asked.settings, unused_files=True),  # who opens a file asks for it
            cached=False,
            jobs=1,
            folder=self.root,
            fixes=False,
            baseline=asked.baseline,
            monitor=monitor,
        )
        inputs = Inputs(request, workspace, tree, self._store, memory, self._results, importable, self._nodes)
        facts = LiveFacts(self._store, readable.held, self._decoded, monitor)
        systems: list[list[System]] = []
        findings: Sequence[Finding] = ()
        try:
            _refuse_no_input(workspace)
            facts.prepare(compiled_files(workspace), skipped_files(workspace))
            refuse_nothing(request, workspace, facts)
            judged = judged_in_parts(inputs, facts, loaded=systems)
        except NothingToDo as error:
            notices = [str(error)]
        else:
            findings, notices = judged.findings, judged.notices
        self._decoded = facts.used
        snapshot = Snapshot(
            self.root, asked.settings, own, workspace, tree, systems, judged=findings, notices=tuple(notices)
        )
        return self._finished(snapshot, readable)

    def _finished(self, snapshot: Snapshot, readable: Readable) -> Snapshot:
        """With what is wrong with files that do not compile, and all findings where their lines are now."""
        shifts = {self._shown(path): shift for path, shift in readable.shifts.items()}
        wanted = Filters(snapshot.settings, snapshot.workspace)
        broken = [kept for finding in readable.findings(self.root) if (kept := wanted.apply(finding)) is not None]
        findings = [*shown_now(snapshot.judged, shifts), *broken]
        ordered = sorted(findings, key=lambda finding: finding.sort_key)
        return replace(snapshot, findings=ordered, shifts=readable.shifts)

    def _files(self, asked: Asked, readable: Readable) -> tuple[Workspace, Importable]:
        if self._found is None or self._found[0] != asked:
            exclude = [pattern for glob in asked.settings.exclude for pattern in glob.patterns()]
            workspace = find(asked.paths, exclude=exclude, working_directory=self.root, read=_reader(readable))
            self._found = asked, workspace, Importable(workspace.files)
        return self._found[1:]

    def _own(self, buffers: Buffers) -> Buffers:
        """The texts that lie in this workspace."""
        return {path: buffer for path, buffer in buffers.items() if is_below(path, self.root)}

    def _open_store(self, settings: Settings) -> None:
        """The cache on the disk, where the configuration wants it; a run of ``archlint check`` uses the same."""
        folder = os.path.join(self.root, CACHE_FOLDER) if settings.file is None else settings.cache_folder
        if folder == self._cache_folder:
            return
        key = user_key([self.root])
        self._cache_folder = folder
        self._store = LiveStore(NullStore() if key is None else Store(folder, __version__, key))
        self._readable = LastReadable(self._store)


def _places(findings: Iterable[Finding]) -> int:
    """How many places findings name."""
    return sum(1 + len(finding.related) for finding in findings)


def _text(data: bytes | None) -> str:
    return (data or b"").decode("utf-8", "replace")


def _refuse_no_input(workspace: Workspace) -> None:
    if not workspace.problems and not any(is_input(file) or is_of_package(file) for file in workspace.files):
        raise NothingToDo("nothing to check: no package.xml, no Python or C++ file and no launch file")


def _reader(readable: Readable) -> Callable[[SourceFile], bytes]:
    return lambda file: readable.held.get(file.path) or read_file(file)


__all__ = ["Asked", "LiveWorkspace"]

"""Everything that is known of one editor: its documents, folders and workspaces."""

from __future__ import annotations

import gc
import os
import threading
from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import Future, ThreadPoolExecutor
from dataclasses import replace
from typing import TYPE_CHECKING, TypeVar

from lsprotocol.types import CodeAction, Diagnostic, DiagnosticSeverity, Position, Range

from archlint.records import dataclass
from archlint.server.actions import Actions
from archlint.server.diagnostics import SOURCE, Shown, by_path
from archlint.server.documents import Documents
from archlint.server.names import Names
from archlint.server.session import Session, place_of
from archlint.server.worker import Worker
from archlint.workspace.around import is_below

if TYPE_CHECKING:
    from archlint.finding import Finding
    from archlint.live.snapshot import Snapshot
    from archlint.monitor import Monitor
    from archlint.server.configuration import Mistake
    from archlint.server.positions import Units

Result = TypeVar("Result")


@dataclass(frozen=True)
class Published:
    """The diagnostics of one document, for the version of it that they were made for."""

    uri: str
    version: int | None
    diagnostics: Sequence[Diagnostic]


@dataclass(frozen=True)
class Client:
    """What is called with what the editor is to hear, from any thread, and how it wants it."""

    publish: Callable[[Published], None]
    log: Callable[[str], None]
    units: Units = len
    versioned: bool = True
    watches: bool = False
    """Whether it says which files change on the disk; else files are looked at again whenever one is saved."""


class Editor:
    """Turns what an editor says into diagnostics.

    Each method but :meth:`close` returns at once; what takes time is done by a thread of its own.
    """

    def __init__(self, client: Client, pause: float | None = None) -> None:
        self.client = client
        self.documents = Documents()
        self._folders: list[str] = []
        self._sessions: dict[str, Session] = {}
        self._shown: dict[str, dict[str, object]] = {}
        """What was last published, by workspace and path."""
        self._lock = threading.Lock()
        self._worker = Worker(self._analyse, self._failed, gc.collect)
        self._answering = ThreadPoolExecutor(1, "archlint-names")
        self._pause = {} if pause is None else {"pause": pause}

    # ---------------------------------------------------------------------------------------- what the editor says

    def set_folders(self, folders: Sequence[str]) -> None:
        """These are the folders that are open now."""
        self._folders = [os.path.normpath(folder) for folder in folders]
        for root in [root for root in self._sessions if not self._is_needed(root)]:
            self._forget(root)

    def opened(self, uri: str, text: str, version: int | None) -> None:
        path = self.documents.put(uri, text, version)
        if path is not None and not self._is_known(path, text):
            self._touch_around(path)

    def changed(self, uri: str, text: str, version: int | None) -> None:
        path = self.documents.put(uri, text, version)
        if path is not None:
            self._touch_around(path, looks_again=False)

    def saved(self, path: str | None) -> None:
        if path is not None and not self.client.watches:
            self._touch_around(path)

    def closed(self, uri: str) -> None:
        path = self.documents.remove(uri)
        if path is not None:
            self._touch_around(path)

    def changed_on_disk(self, paths: Sequence[str]) -> None:
        """Files have come, gone or changed.  Those that are open count as the editor has them."""
        paths = [path for path in paths if path not in self.documents.buffers]
        for root, session in self._sessions.items():
            if any(is_below(path, root) or is_below(root, os.path.dirname(path)) for path in paths):
                session.look_again()
                self._worker.touch(root, **self._pause)

    # ---------------------------------------------------------------------------------------------- what it asks

    def actions(self, path: str, where: Range, only: Sequence[str] | None) -> Future[list[CodeAction]]:
        """What can be done about the findings in a range of a file."""

        def of(snapshot: Snapshot) -> list[CodeAction]:
            file = os.path.relpath(path, snapshot.root).replace(os.sep, "/")
            return Actions(self._as_shown(snapshot), file, self.client.versioned).at(where, only)

        return self.ask(path, of, [])

    def ask(self, path: str, question: Callable[[Snapshot], Result], otherwise: Result) -> Future[Result]:
        """The answer to a question about the workspace that a file lies in, once that is analysed as it is now;
        ``otherwise`` where it is not known."""
        root = self._root_of(path)

        def answer() -> Result:
            session = self._sessions.get(root)
            if session is None or session.snapshot is None:
                return otherwise
            return question(session.snapshot)

        return self._worker.ask(answer, about=root)

    def names(self, path: str, question: Callable[[Names], Result], otherwise: Result) -> Future[Result]:
        """The answer to a question about names in a file, from what is known now; ``otherwise`` where nothing is."""
        session = self._sessions.get(self._root_of(path))

        def answer() -> Result:
            snapshot = None if session is None else session.snapshot
            return otherwise if snapshot is None else question(self._names(snapshot))

        return self._answering.submit(answer)

    def names_for_edits(self, path: str, question: Callable[[Names], Result], otherwise: Result) -> Future[Result]:
        """As :meth:`names`, once the workspace is analysed as it is now: the answer will edit files."""
        return self.ask(path, lambda snapshot: question(self._names(snapshot)), otherwise)

    def close(self) -> None:
        """End the thread, and write down what the next server can use."""
        self._answering.shutdown()
        self._worker.close()
        for session in self._sessions.values():
            session.close()

    # ------------------------------------------------------------------------------------------------------ inside

    def _touch_around(self, path: str, looks_again: bool = True) -> None:
        root, paths = place_of(path, self._folders)
        if root not in self._sessions:
            self._sessions[root] = Session(root, paths)
        elif looks_again:
            self._sessions[root].look_again()
        self._worker.touch(root, **self._pause)

    def _is_known(self, path: str, text: str) -> bool:
        """Whether a text that comes from the editor is the one that was analysed."""
        session = self._sessions.get(self._root_of(path))
        snapshot = None if session is None else session.snapshot
        if snapshot is None or path in snapshot.buffers:
            return False
        return snapshot.text(os.path.relpath(path, snapshot.root).replace(os.sep, "/")) == text

    def _root_of(self, path: str) -> str:
        return place_of(path, self._folders)[0]

    def _is_needed(self, root: str) -> bool:
        open_below = any(is_below(path, root) for path in self.documents.buffers)
        return open_below or any(is_below(root, folder) or is_below(folder, root) for folder in self._folders)

    def _forget(self, root: str) -> None:
        self._worker.forget(root)
        self._worker.ask(lambda: self._cleared(root))

    def _cleared(self, root: str) -> None:
        session = self._sessions.pop(root, None)
        if session is not None:
            session.close()
        for path in self._shown.pop(root, {}):
            self._say(path, [])

    def _names(self, snapshot: Snapshot) -> Names:
        """The names of an analysis in the texts of now."""
        shown = self._as_shown(replace(snapshot, buffers=self.documents.buffers))
        return Names(shown, snapshot.indexes, self.client.versioned)

    def _as_shown(self, snapshot: Snapshot) -> Shown:
        return Shown(snapshot, self.documents.addresses, self.client.units)

    # ------------------------------------------------------------------------------------- in the worker's thread

    def _analyse(self, root: str, monitor: Monitor) -> None:
        session = self._sessions.get(root)
        if session is None:
            return
        for snapshot in session.analyse(self.documents.buffers, monitor):
            self._publish(root, snapshot, session.configuration.mistakes)

    def _publish(self, root: str, snapshot: Snapshot, mistakes: Sequence[Mistake]) -> None:
        """Say what has changed: of a file whose findings are those that they were, nothing is said again."""
        shown = self._as_shown(snapshot)
        before = self._shown.get(root, {})
        findings: Mapping[str, Sequence[Finding]] = by_path(snapshot)
        now: dict[str, object] = {}
        for path in sorted({*before, *findings, *(mistake.path for mistake in mistakes)}):
            own = findings.get(path, ())
            wrong = [mistake for mistake in mistakes if mistake.path == path]
            buffer = snapshot.buffers.get(path)
            state = (tuple(own), tuple(wrong), None if buffer is None else buffer.version)
            if own or wrong:
                now[path] = state
            if before.get(path) == state or self._is_old(snapshot, path):
                continue
            self._say(path, [*map(_mistake, wrong), *shown.diagnostics(own)])
        self._shown[root] = now

    def _is_old(self, snapshot: Snapshot, path: str) -> bool:
        """Whether a document has been edited since: what is known of it is not about its text."""
        buffer = snapshot.buffers.get(path)
        return buffer is not None and self.documents.version(path) != buffer.version

    def _say(self, path: str, diagnostics: Sequence[Diagnostic]) -> None:
        self.client.publish(Published(self.documents.addresses.of(path), self.documents.version(path), diagnostics))

    def _failed(self, root: str, error: Exception) -> None:
        import traceback

        frames = "".join(traceback.format_exception(error))
        self.client.log(f"archlint: analysing {root} failed, which is an error in archlint:\n{frames}")


def _mistake(mistake: Mistake) -> Diagnostic:
    line = mistake.line - 1
    return Diagnostic(
        Range(Position(line, 0), Position(line + 1, 0)),
        mistake.message,
        DiagnosticSeverity.Error,
        source=SOURCE,
    )


__all__ = ["Client", "Editor", "Published"]

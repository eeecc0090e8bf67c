"""An editor that drives a real server over standard input and output."""

from __future__ import annotations

import asyncio
import sys
import threading
from collections.abc import Awaitable, Callable, Coroutine
from concurrent.futures import Future
from pathlib import Path
from typing import Any, TypeVar

from lsprotocol import types as lsp
from pygls.lsp.client import LanguageClient

Answer = TypeVar("Answer")

PATIENCE = 60.0
"""Seconds; a busy machine is no reason for a test to fail."""


class EditorClient:
    """Calls from a test; the protocol itself runs in a thread of its own."""

    def __init__(self, folder: Path, encoding: lsp.PositionEncodingKind, *words: str) -> None:
        self.diagnostics: dict[str, lsp.PublishDiagnosticsParams] = {}
        self.logged: list[str] = []
        self._heard = threading.Condition()
        self._loop = asyncio.new_event_loop()
        self._thread = threading.Thread(target=self._loop.run_forever)
        self._thread.start()
        self._versions: dict[str, int] = {}
        self.client = LanguageClient("tests", "1")

        @self.client.feature(lsp.TEXT_DOCUMENT_PUBLISH_DIAGNOSTICS)
        def heard(params: lsp.PublishDiagnosticsParams) -> None:
            with self._heard:
                self.diagnostics[params.uri] = params
                self._heard.notify_all()

        self.client.feature(lsp.WINDOW_LOG_MESSAGE)(lambda params: self.logged.append(params.message))
        self.client.feature(lsp.CLIENT_REGISTER_CAPABILITY)(lambda params: None)
        self._run(self.client.start_io(sys.executable, "-m", "archlint", "server", *words))
        general = lsp.GeneralClientCapabilities(position_encodings=[encoding])
        edits = lsp.WorkspaceEditClientCapabilities(document_changes=True)
        watched = lsp.DidChangeWatchedFilesClientCapabilities(dynamic_registration=True)
        workspace = lsp.WorkspaceClientCapabilities(workspace_edit=edits, did_change_watched_files=watched)
        params = lsp.InitializeParams(
            lsp.ClientCapabilities(general=general, workspace=workspace),
            workspace_folders=[lsp.WorkspaceFolder(folder.as_uri(), folder.name)],
        )
        self.capabilities = self._run(self.client.initialize_async(params)).capabilities
        self._tell(lambda: self.client.initialized(lsp.InitializedParams()))

    def open(self, file: Path, text: str | None = None, language: str = "python") -> None:
        self._versions[file.as_uri()] = 1
        content = file.read_text("utf-8") if text is None else text
        document = lsp.TextDocumentItem(file.as_uri(), language, 1, content)
        self._tell(lambda: self.client.text_document_did_open(lsp.DidOpenTextDocumentParams(document)))

    def type(self, file: Path, text: str) -> None:
        """The file is this text now; nothing is saved."""
        self._versions[file.as_uri()] += 1
        document = lsp.VersionedTextDocumentIdentifier(version=self._versions[file.as_uri()], uri=file.as_uri())
        change = lsp.TextDocumentContentChangeWholeDocument(text)
        params = lsp.DidChangeTextDocumentParams(document, [change])
        self._tell(lambda: self.client.text_document_did_change(params))

    def close(self, file: Path) -> None:
        params = lsp.DidCloseTextDocumentParams(lsp.TextDocumentIdentifier(file.as_uri()))
        self._tell(lambda: self.client.text_document_did_close(params))

    def changed_on_disk(self, file: Path) -> None:
        event = lsp.FileEvent(file.as_uri(), lsp.FileChangeType.Changed)
        params = lsp.DidChangeWatchedFilesParams([event])
        self._tell(lambda: self.client.workspace_did_change_watched_files(params))

    def codes(self, file: Path) -> list[str]:
        """The codes of the diagnostics that are shown for a file now, sorted."""
        return sorted(str(one.code) for one in self.of(file))

    def of(self, file: Path) -> list[lsp.Diagnostic]:
        published = self.diagnostics.get(file.as_uri())
        return [] if published is None else list(published.diagnostics)

    def version(self, file: Path) -> int:
        return self._versions[file.as_uri()]

    def shown(self, file: Path, code: str) -> lsp.Diagnostic:
        """The one diagnostic of a code in a file."""
        [one] = [one for one in self.diagnostics[file.as_uri()].diagnostics if one.code == code]
        return one

    def wait_until(self, holds: Callable[[], bool]) -> None:
        """Until diagnostics came with which something holds."""
        with self._heard:
            assert self._heard.wait_for(holds, PATIENCE), self.diagnostics

    def actions(self, file: Path, where: lsp.Range, *only: str) -> list[lsp.CodeAction]:
        context = lsp.CodeActionContext([], only=list(only) or None)
        params = lsp.CodeActionParams(lsp.TextDocumentIdentifier(file.as_uri()), where, context)
        return [a for a in self.ask(self.client.text_document_code_action_async(params)) or [] if a.title]

    def ask(self, question: Awaitable[Answer]) -> Answer:
        async def asked() -> Answer:
            return await question

        return self._run(asked())

    def leave(self) -> int | None:
        """Shut the server down; returns its exit status."""
        self._run(self.client.shutdown_async(None))
        self._tell(lambda: self.client.exit(None))
        self._run(self.client.stop())
        self._loop.call_soon_threadsafe(self._loop.stop)
        self._thread.join()
        self._loop.close()
        return self.client._server.returncode if self.client._server is not None else None

    def _tell(self, act: Callable[[], object]) -> None:
        done: Future[object] = Future()
        self._loop.call_soon_threadsafe(lambda: done.set_result(act()))
        done.result(PATIENCE)

    def _run(self, work: Coroutine[Any, Any, Answer]) -> Answer:
        return asyncio.run_coroutine_threadsafe(work, self._loop).result(PATIENCE)

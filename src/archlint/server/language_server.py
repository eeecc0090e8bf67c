"""The protocol: what an editor sends, and what it is sent."""

from __future__ import annotations

import asyncio
import gc
import sys
from collections.abc import Callable, Sequence
from typing import BinaryIO, TypeVar, cast

from lsprotocol import types as lsp
from pygls.lsp.server import LanguageServer

from archlint import __version__
from archlint.server.actions import FIX_ALL
from archlint.server.editor import Client, Editor, Published
from archlint.server.frames import DamagedFrame, Frames
from archlint.server.name_features import answer_about_names
from archlint.server.uris import path_of

_WATCHED = "**/*.{py,xml,launch,yaml,yml,toml,cfg,msg,srv,action,txt,cpp,cc,cxx,hpp,hh,hxx,h}"


Said = TypeVar("Said")


class ArchlintServer(LanguageServer):
    """One client, over its standard input and output."""

    def __init__(self) -> None:
        super().__init__("archlint", __version__, text_document_sync_kind=lsp.TextDocumentSyncKind.Full)
        self.editor = Editor(Client(self._later(self._publish), self._later(self._log)))
        self._loop: asyncio.AbstractEventLoop | None = None

    def begin(self, capabilities: lsp.ClientCapabilities) -> None:
        """The client is ready."""
        self._loop = asyncio.get_running_loop()
        of_workspace = capabilities.workspace or lsp.WorkspaceClientCapabilities()
        edits, watched = of_workspace.workspace_edit, of_workspace.did_change_watched_files
        self.editor.client = Client(
            self._later(self._publish),
            self._later(self._log),
            self.workspace.position_codec.client_num_units,
            versioned=bool(edits and edits.document_changes),
            watches=bool(watched and watched.dynamic_registration),
        )
        self.note_folders()

    def note_folders(self) -> None:
        uris = list(self.workspace.folders) or ([self.workspace.root_uri] if self.workspace.root_uri else [])
        self.editor.set_folders([path for uri in uris if (path := path_of(uri)) is not None])

    def text_of(self, uri: str) -> str:
        return self.workspace.get_text_document(uri).source

    def _later(self, act: Callable[[Said], None]) -> Callable[[Said], None]:
        """The same, from any thread."""

        def call(what: Said) -> None:
            if self._loop is not None and not self._loop.is_closed():
                self._loop.call_soon_threadsafe(act, what)

        return call

    def _publish(self, published: Published) -> None:
        self.text_document_publish_diagnostics(
            lsp.PublishDiagnosticsParams(published.uri, list(published.diagnostics), published.version)
        )

    def _log(self, message: str) -> None:
        self.window_log_message(lsp.LogMessageParams(lsp.MessageType.Error, message))


def make_server() -> ArchlintServer:
    """A server that waits for its client."""
    server = ArchlintServer()
    _hear_documents(server)
    _hear_workspace(server)
    _answer(server)
    answer_about_names(server, server.editor)
    return server


def _hear_documents(server: ArchlintServer) -> None:
    @server.feature(lsp.TEXT_DOCUMENT_DID_OPEN)
    def opened(params: lsp.DidOpenTextDocumentParams) -> None:
        document = params.text_document
        server.editor.opened(document.uri, document.text, document.version)

    @server.feature(lsp.TEXT_DOCUMENT_DID_CHANGE)
    def changed(params: lsp.DidChangeTextDocumentParams) -> None:
        document = params.text_document
        server.editor.changed(document.uri, server.text_of(document.uri), document.version)

    @server.feature(lsp.TEXT_DOCUMENT_DID_SAVE)
    def saved(params: lsp.DidSaveTextDocumentParams) -> None:
        server.editor.saved(path_of(params.text_document.uri))

    @server.feature(lsp.TEXT_DOCUMENT_DID_CLOSE)
    def closed(params: lsp.DidCloseTextDocumentParams) -> None:
        server.editor.closed(params.text_document.uri)


def _hear_workspace(server: ArchlintServer) -> None:
    @server.feature(lsp.INITIALIZED)
    async def initialized(_: lsp.InitializedParams) -> None:
        server.begin(server.client_capabilities)
        if server.editor.client.watches:
            options = lsp.DidChangeWatchedFilesRegistrationOptions([lsp.FileSystemWatcher(_WATCHED)])
            registration = lsp.Registration("archlint-files", lsp.WORKSPACE_DID_CHANGE_WATCHED_FILES, options)
            await server.client_register_capability_async(lsp.RegistrationParams([registration]))

    @server.feature(lsp.WORKSPACE_DID_CHANGE_WATCHED_FILES)
    def changed_on_disk(params: lsp.DidChangeWatchedFilesParams) -> None:
        paths = (path_of(change.uri) for change in params.changes)
        server.editor.changed_on_disk([path for path in paths if path is not None])

    @server.feature(lsp.WORKSPACE_DID_CHANGE_WORKSPACE_FOLDERS)
    def folders_changed(_: lsp.DidChangeWorkspaceFoldersParams) -> None:
        server.note_folders()


def _answer(server: ArchlintServer) -> None:
    kinds: Sequence[lsp.CodeActionKind | str] = [lsp.CodeActionKind.QuickFix, FIX_ALL]

    @server.feature(lsp.TEXT_DOCUMENT_CODE_ACTION, lsp.CodeActionOptions(code_action_kinds=kinds))
    async def actions(params: lsp.CodeActionParams) -> list[lsp.CodeAction]:
        path = path_of(params.text_document.uri)
        if path is None:
            return []
        return await asyncio.wrap_future(server.editor.actions(path, params.range, params.context.only))


def serve() -> None:
    """Serve one client over standard input and output, until it leaves.  Raises :class:`DamagedFrame`.

    Garbage is collected between analyses only (:data:`archlint.server.worker.REST`): it takes a third of their time.
    """
    gc.disable()
    server = make_server()
    messages, output = Frames(sys.stdin.buffer), sys.stdout.buffer
    sys.stdout = sys.stderr  # whatever else is printed must not come between the messages
    try:
        server.start_io(cast("BinaryIO", messages), output)
    finally:
        server.editor.close()
    if messages.mistake is not None:
        raise DamagedFrame(messages.mistake)


__all__ = ["ArchlintServer", "DamagedFrame", "make_server", "serve"]

"""The features of the protocol that are about names: hover, definition, references, completion, rename, links."""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from typing import TYPE_CHECKING, TypeVar

from lsprotocol import types as lsp
from pygls.exceptions import JsonRpcException

from archlint.server.names import TRIGGERS, CannotRename, Names
from archlint.server.uris import path_of

if TYPE_CHECKING:
    from pygls.lsp.server import LanguageServer

    from archlint.server.editor import Editor

Answer = TypeVar("Answer")

_REQUEST_FAILED = -32803
"""The request was understood and cannot be fulfilled: ``LSPErrorCodes.RequestFailed``."""


def answer_about_names(server: LanguageServer, editor: Editor) -> None:
    """Have a server answer such questions."""

    async def ask(uri: str, question: Callable[[Names, str], Answer], otherwise: Answer) -> Answer:
        path = path_of(uri)
        if path is None:
            return otherwise
        return await asyncio.wrap_future(editor.names(path, lambda names: question(names, path), otherwise))

    @server.feature(lsp.TEXT_DOCUMENT_HOVER)
    async def hover(params: lsp.HoverParams) -> lsp.Hover | None:
        return await ask(params.text_document.uri, lambda names, path: names.hover(path, params.position), None)

    @server.feature(lsp.TEXT_DOCUMENT_DEFINITION)
    async def definition(params: lsp.DefinitionParams) -> list[lsp.Location]:
        return await ask(params.text_document.uri, lambda names, path: names.definition(path, params.position), [])

    @server.feature(lsp.TEXT_DOCUMENT_REFERENCES)
    async def references(params: lsp.ReferenceParams) -> list[lsp.Location]:
        return await ask(params.text_document.uri, lambda names, path: names.references(path, params.position), [])

    @server.feature(lsp.TEXT_DOCUMENT_COMPLETION, lsp.CompletionOptions(trigger_characters=TRIGGERS))
    async def completion(params: lsp.CompletionParams) -> list[lsp.CompletionItem]:
        return await ask(params.text_document.uri, lambda names, path: names.completions(path, params.position), [])

    @server.feature(lsp.TEXT_DOCUMENT_DOCUMENT_LINK)
    async def links(params: lsp.DocumentLinkParams) -> list[lsp.DocumentLink]:
        return await ask(params.text_document.uri, lambda names, path: names.links(path), [])

    @server.feature(lsp.TEXT_DOCUMENT_PREPARE_RENAME)
    async def prepare_rename(params: lsp.PrepareRenameParams) -> lsp.PrepareRenamePlaceholder | None:
        try:
            return await ask(
                params.text_document.uri, lambda names, path: names.prepare_rename(path, params.position), None
            )
        except CannotRename as error:
            raise _refusal(error) from None

    @server.feature(lsp.TEXT_DOCUMENT_RENAME, lsp.RenameOptions(prepare_provider=True))
    async def rename(params: lsp.RenameParams) -> lsp.WorkspaceEdit | None:
        path = path_of(params.text_document.uri)
        if path is None:
            return None
        place, new = params.position, params.new_name
        answer = editor.names_for_edits(path, lambda names: names.rename(path, place, new), None)
        try:
            return await asyncio.wrap_future(answer)
        except CannotRename as error:
            raise _refusal(error) from None


def _refusal(error: CannotRename) -> JsonRpcException:
    return JsonRpcException(str(error), _REQUEST_FAILED)


__all__ = ["answer_about_names"]

"""How long an editor waits for the language server: from an edit to the diagnostics of that version of the file.

A made-up workspace, one real server, and a client that types; the pause that the server waits for is in the figures.
"""

from __future__ import annotations

import asyncio
import os
import statistics
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from pathlib import Path

from lsprotocol import types as lsp
from pygls.lsp.client import LanguageClient

from benchmarks.speed.edits import Topic, topics_below
from benchmarks.speed.workspaces import make_workspace

_PATIENCE = 300.0
_QUIET = 1.5
"""Seconds without any work after which the server has done all that it does for an edit."""


@dataclass
class Waits:
    """The seconds of one kind of edit: on the clock, and of the server's processor time."""

    kind: str
    wall: list[float] = field(default_factory=list)
    cpu: list[float] = field(default_factory=list)

    @property
    def medians(self) -> tuple[float, float, float]:
        """Median and most of the wall time, median of the processor time."""
        return statistics.median(self.wall), max(self.wall), statistics.median(self.cpu)


def _renamed(text: str, topic: Topic, number: int) -> str:
    lines = text.split("\n")
    line = lines[topic.line]
    lines[topic.line] = f'{line[: topic.start]}"renamed_{number}"{line[topic.end :]}'
    return "\n".join(lines)


def _commented(text: str, topic: Topic, number: int) -> str:
    return f"{text}\n# edit {number}\n"


def _half_typed(text: str, topic: Topic, number: int) -> str:
    return f"{text}\ndef later_{number}(\n"


_Edit = Callable[[str, Topic, int], str]
_EDITS: tuple[tuple[str, _Edit, bool], ...] = (
    ("another name for a topic", _renamed, True),
    ("the same, while the whole answer to the edit before is worked out", _renamed, False),
    ("a comment at the end", _commented, True),
    ("half-typed code", _half_typed, True),
)
"""Kinds of edits, and whether each is made after a pause in the typing."""


def waits(packages: int, rounds: int) -> Iterator[Waits]:
    """What each kind of edit takes in a workspace of so many packages, of four Python files each."""
    with tempfile.TemporaryDirectory() as folder:
        root = Path(folder).resolve()
        (root / ".git").mkdir()
        make_workspace(root, packages)
        yield from asyncio.run(_all(root, rounds))


async def _all(root: Path, rounds: int) -> list[Waits]:
    client = _Client()
    await client.begin(root)
    topics = topics_below(root)[:rounds]
    rows = []
    for kind, edit, pauses in _EDITS:
        row = Waits(kind)
        await client.rest()
        for number, topic in enumerate(topics, len(rows) * rounds):
            if pauses:
                await client.rest()
            wall, cpu = await client.type(topic.file, edit(client.text(topic.file), topic, number))
            row.wall.append(wall)
            row.cpu.append(cpu)
        rows.append(row)
    await client.end()
    return rows


class _Client:
    def __init__(self) -> None:
        self._client = LanguageClient("benchmark", "1")
        self._versions: dict[str, int] = {}
        self._texts: dict[Path, str] = {}
        self._shown: dict[str, int | None] = {}
        self._heard = asyncio.Event()

        @self._client.feature(lsp.TEXT_DOCUMENT_PUBLISH_DIAGNOSTICS)
        def heard(params: lsp.PublishDiagnosticsParams) -> None:
            self._shown[params.uri] = params.version
            self._heard.set()

    async def begin(self, root: Path) -> None:
        await self._client.start_io(sys.executable, "-m", "archlint", "server", env=_environment())
        folders = [lsp.WorkspaceFolder(root.as_uri(), root.name)]
        await self._client.initialize_async(lsp.InitializeParams(lsp.ClientCapabilities(), workspace_folders=folders))
        self._client.initialized(lsp.InitializedParams())

    def text(self, file: Path) -> str:
        """What the editor holds of a file: an edit begins with that, for it is to change what it says and no more."""
        return self._texts[file] if file in self._texts else file.read_text()

    async def type(self, file: Path, text: str) -> tuple[float, float]:
        """Seconds until the diagnostics of a new text are there, and seconds of the server's processor time."""
        uri = file.as_uri()
        if uri not in self._versions:
            self._versions[uri] = 0
            item = lsp.TextDocumentItem(uri, "python", 0, file.read_text())
            self._client.text_document_did_open(lsp.DidOpenTextDocumentParams(item))
            await self._until(lambda: uri in self._shown)
            await self.rest()
        self._texts[file] = text
        self._versions[uri] += 1
        version, began, used = self._versions[uri], time.perf_counter(), self._processor_time()
        document = lsp.VersionedTextDocumentIdentifier(version=version, uri=uri)
        change = lsp.TextDocumentContentChangeWholeDocument(text)
        self._client.text_document_did_change(lsp.DidChangeTextDocumentParams(document, [change]))
        await self._until(lambda: self._shown.get(uri) == version)
        return time.perf_counter() - began, self._processor_time() - used

    async def rest(self) -> None:
        """Until the server has nothing more to do."""
        used = -1.0
        while used != (now := self._processor_time()):
            used = now
            await asyncio.sleep(_QUIET)

    async def _until(self, holds: Callable[[], bool]) -> None:
        while not holds():
            self._heard.clear()
            await asyncio.wait_for(self._heard.wait(), _PATIENCE)

    def _processor_time(self) -> float:
        """Of the server so far, on Linux."""
        server = self._client._server
        try:
            fields = Path(f"/proc/{server.pid}/stat").read_text().rpartition(")")[2].split()
        except (OSError, AttributeError):
            return 0.0
        return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")

    async def end(self) -> None:
        await self._client.shutdown_async(None)
        self._client.exit(None)
        await self._client.stop()


def _environment() -> dict[str, str]:
    return {**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)}

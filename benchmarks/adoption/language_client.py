"""An editor that opens one file and waits for what the language server says of it; every message is kept."""

from __future__ import annotations

import json
import subprocess
import threading
from collections.abc import Mapping, Sequence
from pathlib import Path
from queue import Empty, Queue
from typing import Any

PATIENCE = 120
"""Seconds until a server that says nothing is given up."""

Message = dict[str, Any]


class Silence(Exception):
    """The server ended, or did not answer in time."""


class Session:
    """One server from its start to its end."""

    def __init__(self, command: Sequence[str], folder: Path, environment: Mapping[str, str]) -> None:
        self.messages: list[Message] = []
        """What was said, with ``from`` telling who."""
        self._folder = folder
        self._heard: Queue[Message] = Queue()
        self._server = subprocess.Popen(
            command,
            cwd=folder,
            env=environment,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
        )
        self._listener = threading.Thread(target=self._listen, daemon=True)
        self._listener.start()

    def diagnostics(self, file: Path) -> list[Message]:
        """What the server says of a file, as an editor asks for it."""
        folder = {"uri": self._folder.as_uri(), "name": self._folder.name}
        self._ask(
            1, "initialize", {"processId": None, "rootUri": None, "capabilities": {}, "workspaceFolders": [folder]}
        )
        self._tell("initialized", {})
        document = {"uri": file.as_uri(), "languageId": "python", "version": 1, "text": file.read_text("utf-8")}
        self._tell("textDocument/didOpen", {"textDocument": document})
        while True:
            message = self._next()
            if message.get("method") == "textDocument/publishDiagnostics":
                if message["params"]["uri"] == file.as_uri() and message["params"]["diagnostics"]:
                    return [*message["params"]["diagnostics"]]
            elif "id" in message and "method" in message:  # a request of the server's, such as to watch files
                self._say({"id": message["id"], "result": None})

    def end(self) -> int:
        """Shut down in order; returns the exit status."""
        self._ask(2, "shutdown", None)
        self._tell("exit", None)
        return self._server.wait(PATIENCE)

    def kill(self) -> None:
        """Leave nothing behind, however it went."""
        self._server.kill()
        self._server.wait()
        self._listener.join()
        for stream in (self._server.stdin, self._server.stdout):
            if stream is not None:
                stream.close()

    def _ask(self, number: int, method: str, params: object) -> Message:
        self._say({"id": number, "method": method, "params": params})
        while True:
            message = self._next()
            if message.get("id") == number and "method" not in message:
                return message

    def _tell(self, method: str, params: object) -> None:
        self._say({"method": method, "params": params})

    def _say(self, message: Message) -> None:
        self.messages.append({"from": "editor", **message})
        body = json.dumps({"jsonrpc": "2.0", **message}).encode()
        assert self._server.stdin is not None
        self._server.stdin.write(b"Content-Length: %d\r\n\r\n%s" % (len(body), body))
        self._server.stdin.flush()

    def _next(self) -> Message:
        try:
            message = self._heard.get(timeout=PATIENCE)
        except Empty:
            raise Silence(f"the server says nothing for {PATIENCE} s") from None
        if not message:
            raise Silence(f"the server ended with exit status {self._server.wait(PATIENCE)}")
        self.messages.append({"from": "server", **message})
        return message

    def _listen(self) -> None:
        stream = self._server.stdout
        assert stream is not None
        length = 0
        while line := stream.readline():
            if line.lower().startswith(b"content-length:"):
                length = int(line.split(b":")[1])
            elif not line.strip():
                self._heard.put(json.loads(stream.read(length)))
        self._heard.put({})

"""A headless Chromium, asked through the pipe of its own debugging protocol: no driver and no package is needed.

    with Chromium() as browser:
        browser.open(Path("robot.html"))
        browser.run("document.title")

Commands are those of the DevTools protocol, such as ``Page.captureScreenshot``.
"""

from __future__ import annotations

import base64
import contextlib
import json
import os
import select
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from types import TracebackType
from typing import Any

_NAMES = ("chromium", "chromium-browser", "google-chrome", "chrome")
_FLAGS = (
    *("--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--hide-scrollbars"),
    *("--disable-background-networking", "--disable-component-update", "--disable-sync", "--remote-debugging-pipe"),
)
_KEYS = {"Tab": 9, "Enter": 13, "Escape": 27, "ArrowLeft": 37, "ArrowUp": 38, "ArrowRight": 39, "ArrowDown": 40}
_PATIENCE = 60
"""Seconds that an answer may take."""
_LAUNCH = """
import os, sys
commands, answers = (os.dup(os.dup(os.dup(int(word)))) for word in sys.argv[1:3])
os.dup2(commands, 3)
os.dup2(answers, 4)
os.execv(sys.argv[3], sys.argv[3:])
"""
"""Becomes Chromium, which expects its commands at descriptor 3 and answers at 4."""


def installed() -> str | None:
    """The program, or None where there is none."""
    return next(filter(None, map(shutil.which, _NAMES)), None)


class BrowserError(Exception):
    """What Chromium refuses; ``str()`` says why."""


class Chromium:
    """One page of a browser with a profile of its own."""

    def __init__(self, width: int = 1400, height: int = 900) -> None:
        program = installed()
        if program is None:
            raise BrowserError("no Chromium is installed")
        self._profile = tempfile.mkdtemp(prefix="archlint-page-")
        commands, self._write = os.pipe()
        self._read, answers = os.pipe()
        words = [program, *_FLAGS, f"--user-data-dir={self._profile}", f"--window-size={width},{height}", "about:blank"]
        self._process = subprocess.Popen(
            [sys.executable, "-c", _LAUNCH, str(commands), str(answers), *words],
            pass_fds=(commands, answers),
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
        )
        os.close(commands)
        os.close(answers)
        self._rest, self._count, self._session = b"", 0, ""
        self.events: list[dict[str, Any]] = []
        """What the page has told without being asked: logs, exceptions, requests."""
        try:
            self._attach()
        except BaseException:
            self.close()
            raise

    def _attach(self) -> None:
        pages = [target for target in self.send("Target.getTargets")["targetInfos"] if target["type"] == "page"]
        self._session = self.send("Target.attachToTarget", targetId=pages[0]["targetId"], flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Log", "Network"):
            self.send(f"{domain}.enable")

    def __enter__(self) -> Chromium:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.close()

    def close(self) -> None:
        with contextlib.suppress(BrowserError, OSError):
            self._session = ""
            self.send("Browser.close")
        for descriptor in (self._write, self._read):
            os.close(descriptor)
        try:
            self._process.wait(10)
        except subprocess.TimeoutExpired:
            self._process.kill()
            self._process.wait()
        shutil.rmtree(self._profile, ignore_errors=True)

    def processor_time(self) -> float:
        """Seconds of processor time that all processes of the browser have taken so far; Linux alone says that."""
        children: dict[int, list[tuple[int, int]]] = {}
        for file in Path("/proc").glob("[0-9]*/stat"):
            with contextlib.suppress(OSError):
                fields = file.read_text("utf-8", "replace").rpartition(")")[2].split()
                children.setdefault(int(fields[1]), []).append(
                    (int(file.parent.name), int(fields[11]) + int(fields[12]))
                )
        ticks, todo = 0, [os.getpid()]
        while todo:
            for process, taken in children.get(todo.pop(), []):
                ticks += taken
                todo.append(process)
        return ticks / os.sysconf("SC_CLK_TCK")

    def send(self, method: str, **parameters: Any) -> dict[str, Any]:
        """A command and its result.  Raises :class:`BrowserError`."""
        self._count += 1
        message = {"id": self._count, "method": method, "params": parameters}
        if self._session:
            message["sessionId"] = self._session
        os.write(self._write, json.dumps(message).encode() + b"\0")
        while True:
            answer = self._next()
            if answer.get("id") == self._count:
                if "error" in answer:
                    raise BrowserError(f"{method}: {answer['error'].get('message')}")
                result: dict[str, Any] = answer["result"]
                return result
            self.events.append(answer)

    def _next(self) -> dict[str, Any]:
        end = time.monotonic() + _PATIENCE
        while b"\0" not in self._rest:
            ready, _, _ = select.select([self._read], [], [], max(0.0, end - time.monotonic()))
            more = os.read(self._read, 1 << 16) if ready else b""
            if not more:
                raise BrowserError("the browser went away" if ready else f"no answer for {_PATIENCE} seconds")
            self._rest += more
        message, _, self._rest = self._rest.partition(b"\0")
        answer: dict[str, Any] = json.loads(message)
        return answer

    def open(self, file: Path, fragment: str = "") -> None:
        """Loads a file and waits until it has been drawn."""
        self.events.clear()
        self.send("Page.navigate", url=file.resolve().as_uri() + fragment)
        while not any(event.get("method") == "Page.loadEventFired" for event in self.events):
            self.events.append(self._next())
        self.settle()

    def run(self, expression: str) -> Any:
        """The value of an expression, or what it promises.  Raises :class:`BrowserError` for an exception."""
        options = {"awaitPromise": True, "returnByValue": True, "userGesture": True}
        done = self.send("Runtime.evaluate", expression=expression, **options)
        if "exceptionDetails" in done:
            raise BrowserError(done["exceptionDetails"].get("exception", {}).get("description", "exception"))
        return done["result"].get("value")

    def settle(self) -> None:
        """Until what was asked for is drawn."""
        self.run("new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => done(0))))")

    def complaints(self) -> list[str]:
        """Errors and warnings of the console, exceptions, and what the policy has refused."""
        said = []
        for event in self.events:
            match event:
                case {"method": "Log.entryAdded", "params": {"entry": entry}}:
                    said.append(entry["text"])
                case {"method": "Runtime.exceptionThrown", "params": {"exceptionDetails": details}}:
                    said.append(details.get("exception", {}).get("description", details["text"]))
                case {"method": "Runtime.consoleAPICalled", "params": {"type": kind, "args": words}}:
                    said.append(f"{kind}: {words}")
        return said

    def requests(self) -> list[str]:
        """The addresses that were asked for."""
        asked = (event for event in self.events if event.get("method") == "Network.requestWillBeSent")
        return [event["params"]["request"]["url"] for event in asked]

    def click(self, x: float, y: float, times: int = 1) -> None:
        """With the mouse, at a point of the window."""
        self.send("Input.dispatchMouseEvent", type="mouseMoved", x=x, y=y)
        for count in range(1, times + 1):
            for kind in ("mousePressed", "mouseReleased"):
                self.send("Input.dispatchMouseEvent", type=kind, x=x, y=y, button="left", clickCount=count)
        self.settle()

    def press(self, key: str, code: int = 0) -> None:
        """A key by its name (``Tab``, ``Enter``, ``/``)."""
        text = {"text": "\r"} if key == "Enter" else {"text": key} if len(key) == 1 else {}
        code = code or {"Tab": 9, "Enter": 13, "Escape": 27, "ArrowUp": 38, "ArrowDown": 40, "ArrowRight": 39}.get(
            key, 0
        )
        self.send("Input.dispatchKeyEvent", type="keyDown", key=key, windowsVirtualKeyCode=code, **text)
        self.send("Input.dispatchKeyEvent", type="keyUp", key=key, windowsVirtualKeyCode=code)
        self.settle()

    def type(self, text: str) -> None:
        self.send("Input.insertText", text=text)
        self.settle()

    def screenshot(self, file: Path) -> None:
        file.write_bytes(base64.b64decode(self.send("Page.captureScreenshot")["data"]))

    def pdf(self) -> bytes:
        return base64.b64decode(self.send("Page.printToPDF", landscape=True, printBackground=True)["data"])


__all__ = ["BrowserError", "Chromium", "installed"]

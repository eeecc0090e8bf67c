"""Keeps code of launch files from doing anything but compute: no process, no network, bounded time and memory."""

from __future__ import annotations

import io
import os
import resource
import subprocess
import sys

OUTPUT = "output_of_a_command"
"""What every command prints."""
FROM_OUTSIDE = "of_the_environment"
"""The value of a variable that a launch file stops without, and what is in names that are made up at run time."""

_REFUSED = ("os.exec", "os.posix_spawn", "os.spawn", "os.system", "pty.spawn", "socket.connect", "socket.bind")
_REFUSED += ("subprocess.Popen", "os.fork", "os.forkpty", "os.kill", "os.killpg", "pty.fork")


class _Finished:
    """A process that is over, as ``subprocess.Popen`` and ``run`` give it."""

    def __init__(self, args: object = (), *_: object, **options: object) -> None:
        text = any(options.get(name) for name in ("text", "universal_newlines", "encoding", "errors"))
        output: str | bytes = OUTPUT if text else OUTPUT.encode()
        self.args, self.pid, self.returncode = args, 0, 0
        self.output, self.stderr = output, output[:0]
        self.stdout: object = output

    def communicate(self, *_: object, **__: object) -> tuple[object, object]:
        return self.output, self.stderr

    def wait(self, *_: object, **__: object) -> int:
        return 0

    def poll(self) -> int:
        return 0

    def check_returncode(self) -> None:
        pass

    kill = terminate = check_returncode

    def send_signal(self, _: object) -> None:
        pass

    def __enter__(self) -> _Finished:
        return self

    def __exit__(self, *_: object) -> None:
        pass


class _Started(_Finished):
    def __init__(self, *args: object, **options: object) -> None:
        super().__init__(*args, **options)
        self.stdout = io.StringIO(self.output) if isinstance(self.output, str) else io.BytesIO(self.output)  # type: ignore[arg-type]


def install(seconds: int = 20) -> None:
    """From here on, this process starts nothing and talks to nobody."""
    subprocess.run = _Finished  # type: ignore[assignment]
    subprocess.Popen = _Started  # type: ignore[assignment, misc]
    subprocess.check_output = lambda *args, **options: _Finished(*args, **options).output  # type: ignore[assignment]
    subprocess.call = subprocess.check_call = lambda *_, **__: 0  # type: ignore[assignment]
    subprocess.getoutput = lambda *_, **__: OUTPUT
    subprocess.getstatusoutput = lambda *_, **__: (0, OUTPUT)
    os.system = lambda *_: 0  # type: ignore[assignment]
    os.popen = lambda *_, **__: io.StringIO(OUTPUT)  # type: ignore[assignment, return-value]
    sys.addaudithook(_refuse)
    resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds))
    resource.setrlimit(resource.RLIMIT_FSIZE, (20_000_000, 20_000_000))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def _refuse(event: str, _: object) -> None:
    if event in _REFUSED:
        raise PermissionError(f"{event} is not allowed here")

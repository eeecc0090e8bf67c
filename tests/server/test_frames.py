"""Frames that are damaged end the server, and say why: nobody can tell where the next message begins."""

from __future__ import annotations

import io
import subprocess
import sys

import pytest

from archlint.server.frames import Frames

BODY = b'{"jsonrpc":"2.0","id":1,"method":"shutdown"}'
FRAME = b"Content-Length: %d\r\n\r\n%s" % (len(BODY), BODY)


def read(data: bytes) -> tuple[list[bytes], str | None]:
    """The bodies that somebody gets who reads as pygls does, and the mistake."""
    frames, bodies, length = Frames(io.BytesIO(data)), [], 0
    while line := frames.readline():
        if line.startswith(b"Content-Length: "):
            length = int(line.removeprefix(b"Content-Length: "))
        elif line == b"\r\n" and length:
            bodies.append(frames.read(length))
            length = 0
    return bodies, frames.mistake


@pytest.mark.parametrize(
    "data",
    [
        FRAME + FRAME,
        (b"Content-Type: application/vscode-jsonrpc; charset=utf-8\r\n" + FRAME) * 2,
        FRAME.replace(b"Content-Length: ", b"content-length:") * 2,
        FRAME.replace(b"\r\n", b"\n") * 2,
        FRAME + b"Content-Length: 0\r\n\r\n" + FRAME,
        FRAME + FRAME + b"Content-Le",
    ],
    ids=["plain", "with a type", "in small letters", "Unix lines", "an empty message", "the editor dies"],
)
def test_frames_are_read(data: bytes) -> None:
    assert read(data) == ([BODY, BODY], None)


@pytest.mark.parametrize(
    ("data", "mistake"),
    [
        (b"Content-Type: x\r\n\r\n", "a header has no Content-Length"),
        (b"\r\n", "a header has no Content-Length"),
        (BODY + b"\r\n", '\'{"jsonrpc":"2.0","id":1,"method":"shutdo…\' is no header'),
        (b"hello \x1b[31m\r\n", "'hello ␛[31m' is no header"),
        (b"Content-Length: -5\r\n\r\n", "'-5' is no length"),
        (b"Content-Length: 1e9\r\n\r\n", "'1e9' is no length"),
        (b"Content-Length: 100000001\r\n\r\n", "a message is too large: the limit is 100 MB"),
        (b"Content-Length: " + b"9" * 4_000 + b"\r\n\r\n", "a message is too large: the limit is 100 MB"),
        (b"x" * 10_000_000, f"'{'x' * 40}…' is no header"),
    ],
)
def test_a_damaged_frame_is_the_end_and_is_told(data: bytes, mistake: str) -> None:
    assert read(FRAME + data + FRAME) == ([BODY], mistake)


@pytest.mark.parametrize("wrong", [-3, 3], ids=["too short", "too long"])
def test_after_a_wrong_length_nothing_is_taken_for_a_message(wrong: int) -> None:
    damaged = b"Content-Length: %d\r\n\r\n%s" % (len(BODY) + wrong, BODY)
    bodies, mistake = read(FRAME + damaged + FRAME + FRAME)
    assert bodies[0] == BODY
    assert len(bodies) == 2
    assert mistake is not None


@pytest.mark.parametrize("data", [BODY, b"check .\n" * 1_000, b"Content-Type: x\r\n\r\n" + BODY])
def test_the_server_ends_with_2_and_one_line(data: bytes) -> None:
    """Also one that somebody has started by hand."""
    command = [sys.executable, "-m", "archlint", "server"]
    done = subprocess.run(command, input=data + b"\r\n" + FRAME, capture_output=True, check=False, timeout=60)
    assert (done.returncode, done.stdout) == (2, b"")
    assert done.stderr.startswith(b"archlint: error: standard input is no language client: ")
    assert len(done.stderr.splitlines()) == 1

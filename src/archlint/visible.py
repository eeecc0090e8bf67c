"""Make any string of the user's safe to show: no control codes, no reordering, no lone surrogates."""

from __future__ import annotations

import re

_UNSAFE = re.compile(
    "[\x00-\x1f\x7f-\x9f\u061c\u200b-\u200f\u2028-\u202e\u2060-\u2064\u2066-\u2069\ufeff\ufff9-\ufffb"
    "\ud800-\udfff\ufffe\uffff\U000e0000-\U000e007f]"
)


def _picture(match: re.Match[str]) -> str:
    code = ord(match.group())
    if code < 0x20:
        return chr(0x2400 + code)  # ␀ … ␟, the Unicode pictures of the control codes
    if code == 0x7F:
        return "\u2421"
    if 0xDC80 <= code <= 0xDCFF:
        return f"\\x{code - 0xDC00:02x}"  # a byte of a file name that is no UTF-8
    if code <= 0xFF:
        return f"\\x{code:02x}"
    return f"\\u{code:04x}" if code <= 0xFFFF else f"\\U{code:08x}"


def visible(text: str) -> str:
    """``text`` on one line, every character that could steer a terminal or hide something made visible.

    Covers C0 and C1 controls, DEL, bidirectional and zero-width marks, line separators, tag characters, lone
    surrogates, and what XML does not allow.
    """
    if text.isascii() and text.isprintable():
        return text
    return _UNSAFE.sub(_picture, text)


def visible_text(text: str) -> str:
    """A text of several lines, each made visible; tabs and the ends of lines stay as they are."""
    return "\n".join(map(_visible_line, text.split("\n")))


def _visible_line(line: str) -> str:
    body, end = (line[:-1], "\r") if line.endswith("\r") else (line, "")
    return "\t".join(map(visible, body.split("\t"))) + end


TAB = 4


def visible_code(line: str, *columns: int) -> tuple[str, tuple[int, ...]]:
    """A line of source made visible, tabs expanded; ``columns`` (from 1) moved along with what they point at."""
    shown: list[str] = []
    starts: list[int] = []
    width = 0
    for character in line.rstrip("\r\n"):
        starts.append(width)
        piece = " " * (TAB - width % TAB) if character == "\t" else visible(character)
        shown.append(piece)
        width += len(piece)
    starts.append(width)
    moved = tuple(
        (starts[column - 1] if 0 < column <= len(starts) else width + max(0, column - len(starts))) + 1
        for column in columns
    )
    return "".join(shown), moved

"""What happens to files: half an edit, a merge, another editor, a broken disk."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from benchmarks.fuzz.pick import ODD_NAMES, Pick

_ODD_BYTES = (
    b"\x00",
    b"\xff\xfe",
    b"\xef\xbb\xbf",
    b"\r",
    b"\x0c",
    b"\x1b[2J",
    b"\xc3",
    b"\xe2\x80\xa8",
    b"\xed\xa0\x80",
    b"\t",
    b"\\",
    b"\x85",
)
_MERGE = b"<<<<<<< HEAD\n%s=======\n%s>>>>>>> other\n"


def mangled(pick: Pick, text: bytes, others: Sequence[bytes]) -> bytes:
    """A text after one to three accidents; ``others`` are where lines come from that do not belong there."""
    for _ in range(pick.number(1, 3)):
        text = pick.among(_ACCIDENTS)(pick, text, others)
    return text


def _line_lost(pick: Pick, text: bytes, others: Sequence[bytes]) -> bytes:
    lines = text.splitlines(keepends=True)
    at = pick.number(0, max(0, len(lines) - 1))
    return b"".join(lines[:at] + lines[at + 1 :])


def _line_moved(pick: Pick, text: bytes, others: Sequence[bytes]) -> bytes:
    lines = text.splitlines(keepends=True)
    first, second = (pick.number(0, max(0, len(lines) - 1)) for _ in range(2))
    return b"".join([*lines[:first], *lines[second : second + 2], *lines[first:]])


def _line_of_another(pick: Pick, text: bytes, others: Sequence[bytes]) -> bytes:
    lines = text.splitlines(keepends=True)
    strange = pick.among(others).splitlines(keepends=True) if others else []
    at = pick.number(0, len(lines))
    return b"".join([*lines[:at], *strange[pick.number(0, len(strange)) :][:1], *lines[at:]])


def _merge_markers(pick: Pick, text: bytes, others: Sequence[bytes]) -> bytes:
    lines = text.splitlines(keepends=True)
    at = pick.number(0, len(lines))
    end = min(len(lines), at + 2)
    both = b"".join(lines[at:end])
    return b"".join([*lines[:at], _MERGE % (both, both), *lines[end:]])


def _cut(pick: Pick, text: bytes, others: Sequence[bytes]) -> bytes:
    return text[: pick.number(0, len(text))]


def _bracket_lost(pick: Pick, text: bytes, others: Sequence[bytes]) -> bytes:
    places = [at for at, byte in enumerate(text) if byte in b"()[]{}<>\"':,"]
    at = pick.among(places) if places else 0
    return text[:at] + text[at + 1 :]


def _bracket_doubled(pick: Pick, text: bytes, others: Sequence[bytes]) -> bytes:
    places = [at for at, byte in enumerate(text) if byte in b"()[]{}<>\"':,"]
    at = pick.among(places) if places else 0
    return text[:at] + text[at : at + 1] * pick.one(2, 2, 20, 300) + text[at:]


def _word_replaced(pick: Pick, text: bytes, others: Sequence[bytes]) -> bytes:
    words = text.split(b"'")
    if len(words) < 3:
        words = text.split(b'"')
    quote = b"'" if b"'" in text else b'"'
    if len(words) >= 3:
        words[2 * pick.number(0, (len(words) - 2) // 2) + 1] = pick.among(ODD_NAMES).encode("utf-8", "surrogatepass")
    return quote.join(words)


def _number_grown(pick: Pick, text: bytes, others: Sequence[bytes]) -> bytes:
    places = [at for at, byte in enumerate(text) if byte in b"0123456789"]
    at = pick.among(places) if places else 0
    return text[:at] + pick.one(b"9" * 30, b"9" * 5000, b"-", b"1e400", b"0x", b"") + text[at + 1 :]


def _byte_changed(pick: Pick, text: bytes, others: Sequence[bytes]) -> bytes:
    at = pick.number(0, len(text))
    return text[:at] + pick.among(_ODD_BYTES) + text[at + pick.number(0, 1) :]


def _crlf(pick: Pick, text: bytes, others: Sequence[bytes]) -> bytes:
    return text.replace(b"\n", pick.one(b"\r\n", b"\r", b"\n\n", b"\n\x0c"))


def _bom(pick: Pick, text: bytes, others: Sequence[bytes]) -> bytes:
    return (
        pick.one(b"\xef\xbb\xbf", b"\xff\xfe", b"#!/usr/bin/env python\n# coding: latin-1\n", b"# coding: odd\n") + text
    )


def _tabs(pick: Pick, text: bytes, others: Sequence[bytes]) -> bytes:
    return text.replace(b"    ", b"\t", pick.one(-1, 1, 3))


def _encoded(pick: Pick, text: bytes, others: Sequence[bytes]) -> bytes:
    return text.decode("utf-8", "replace").encode(pick.one("utf-16", "latin-1", "utf-7", "utf-32"), "replace")


def _nested(pick: Pick, text: bytes, others: Sequence[bytes]) -> bytes:
    at = text.find(b"\n", pick.number(0, len(text)))
    before, after = pick.one(
        (b"(", b")"), (b"[", b"]"), (b"{", b"}"), (b"<a>", b"</a>"), (b"- ", b""), (b"not ", b""), (b"-", b"")
    )
    times = pick.one(5, 50, 150, 500)
    return text[:at] + before * times + b"1" + after * times + text[at:]


_ACCIDENTS: Sequence[Callable[[Pick, bytes, Sequence[bytes]], bytes]] = (
    *(_line_lost, _line_moved, _line_of_another, _merge_markers, _cut, _bracket_lost, _bracket_doubled, _word_replaced),
    *(_word_replaced, _number_grown, _byte_changed, _crlf, _bom, _tabs, _encoded, _nested),
)

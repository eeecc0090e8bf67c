"""The gate: what a file must pass before libcst sees it.

libcst can kill the process on deep nesting and stall on long operator chains, so a file is looked at first: a
regular file of bearable size, decodable, not nested too deep, no chain too long.
``ast.parse`` at the stock recursion limit is the last look, and never the judge of syntax: a newer Python's
syntax is not an error.
"""

from __future__ import annotations

import ast
import io
import os
import re
import stat
import sys
import tokenize
import warnings
from collections.abc import Iterable
from itertools import islice

from archlint.records import dataclass
from archlint.syntax.python import chains

MAX_BYTES = 1_000_000
MAX_DEPTH = 200
"""CPython's own limit on nested brackets."""
MAX_CHAIN = 2_500
"""The longest run of operators, ``elif``, attribute steps or neighbouring strings that is parsed."""


MAX_TOKENS = 300_000
"""The most words, numbers, texts and signs of a file: libcst needs 3 kB and 30 microseconds for each, 1 GB for all."""


@dataclass(frozen=True)
class SourceText:
    """A file that passed: its text (decoded, as written) and its bytes."""

    text: str
    data: bytes


@dataclass(frozen=True)
class Refusal:
    """Why a file is not analysed, and where; lines and columns start at 1."""

    line: int
    column: int
    message: str
    is_large: bool = False
    """Whether the size alone is why."""


ROS1_MODULES = ("rospy", "roslib", "actionlib", "dynamic_reconfigure")
"""Python modules that only ROS 1 has."""
_ROS1_WORDS = tuple(name.encode() for name in ROS1_MODULES)
_ANY_OF_ROS1 = b"|".join(_ROS1_WORDS)
_ROS1_IMPORT = re.compile(
    rb"^[ \t]*(?:from[ \t]+(?:%b)\b|import[ \t]+[^\n#]*\b(?:%b)\b)" % (_ANY_OF_ROS1, _ANY_OF_ROS1), re.MULTILINE
)
_ROS2_WORD = re.compile(rb"\brclpy\b")


def is_ros1(data: bytes) -> bool:
    """Whether a file imports what only ROS 1 has, and speaks of rclpy nowhere."""
    if not any(word in data for word in _ROS1_WORDS):
        return False
    return _ROS1_IMPORT.search(data) is not None and _ROS2_WORD.search(data) is None


def read_bytes(path: str, limit: int = MAX_BYTES) -> bytes | Refusal:
    """The bytes of a regular file of bearable size."""
    try:
        descriptor = os.open(path, os.O_RDONLY | getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_CLOEXEC", 0))
    except OSError as error:
        return Refusal(1, 1, f"cannot read this file: {error.strerror or error}")
    try:
        status = os.fstat(descriptor)
        if not stat.S_ISREG(status.st_mode):
            return Refusal(1, 1, "not a regular file")
        if status.st_size > limit:
            return refused_for_size(status.st_size, limit)
        with os.fdopen(os.dup(descriptor), "rb") as stream:
            return stream.read(limit + 1)
    except OSError as error:
        return Refusal(1, 1, f"cannot read this file: {error.strerror or error}")
    finally:
        os.close(descriptor)


def refused_for_size(size: int, limit: int = MAX_BYTES) -> Refusal:
    """What is said of a file with so many bytes."""
    message = f"the file is too large to analyse: {size // 1000} kB, the limit is {limit // 1000} kB"
    return Refusal(1, 1, message, is_large=True)


_PICTURES = 64_000_000
"""Bytes of a file that is looked through for words: what a compiler makes of the pictures of a user interface."""


def mentions_any(path: str, words: Iterable[bytes]) -> bool:
    """Whether a large file holds one of some words, or cannot be looked through."""
    data = read_bytes(path, _PICTURES)
    return isinstance(data, Refusal) or any(word in data for word in words)


_UTF_16_MARKS = (b"\xff\xfe", b"\xfe\xff")
_NOT_FOR_SOURCE = ("punycode", "idna", "undefined")
"""Encodings of host names: Python would take them, and decode a large file for hours."""
_SURROGATE = re.compile("[\ud800-\udfff]")


def decode(data: bytes) -> str | Refusal:
    """The text of Python source: by its byte order mark, its coding cookie, or UTF-8."""
    if data.startswith(_UTF_16_MARKS):
        return Refusal(1, 1, "the file is UTF-16, which Python does not read: save it as UTF-8")
    zero = data.find(b"\0")
    if zero >= 0:
        return _refused_byte(data, zero, "utf-8", "the file contains a NUL byte, so it is not Python source")
    try:
        encoding, _ = tokenize.detect_encoding(io.BytesIO(data).readline)
    except SyntaxError as error:
        return Refusal(1, 1, f"the encoding of this file is not known: {error.msg}")
    if encoding in _NOT_FOR_SOURCE:
        return Refusal(1, 1, f"the encoding of this file cannot be used: {encoding} is not for source code")
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            text = data.decode(encoding)
    except UnicodeDecodeError as error:
        readable = _with_readable_comments(data) if encoding.startswith("utf-8") else None
        if readable is not None:
            return readable
        at = error.start
        hint = "save the file as UTF-8 or name its encoding on line 1"
        return _refused_byte(data, at, encoding, f"byte 0x{data[at]:02x} is not valid {encoding}: {hint}")
    except (LookupError, ValueError) as error:
        return Refusal(1, 1, f"the encoding of this file cannot be used: {error}")
    if "\0" in text or _SURROGATE.search(text):
        return Refusal(1, 1, f"the file is not text in {encoding}: save it as UTF-8")
    return text


def _with_readable_comments(data: bytes) -> str | None:
    """UTF-8 source with ``?`` for what is no UTF-8 in its comments; None where there is more of that than in comments.

    Python skips a comment before it decodes it, where it compiles bytes, as ``import`` and ``ros2 launch`` do.
    Source: CPython, tried with 3.10 to 3.12.  ``python3 FILE`` does refuse such a file.
    """
    text = data.decode("utf-8-sig", "surrogateescape")
    places = [
        (number, byte.start()) for number, line in enumerate(text.split("\n"), 1) for byte in _ESCAPED.finditer(line)
    ]
    readable = _ESCAPED.sub("?", text)
    try:
        tokens = list(tokenize.generate_tokens(io.StringIO(readable).readline))
    except (tokenize.TokenError, SyntaxError):
        return None
    comments = {token.start[0]: token.start[1] for token in tokens if token.type == tokenize.COMMENT}
    return readable if all(column > comments.get(line, column) for line, column in places) else None


_ESCAPED = re.compile("[\udc80-\udcff]")
"""A byte that is no UTF-8, as ``surrogateescape`` decodes it."""


def _refused_byte(data: bytes, at: int, encoding: str, message: str) -> Refusal:
    start = data.rfind(b"\n", 0, at) + 1
    column = len(data[start:at].decode(encoding, "replace")) + 1
    return Refusal(data.count(b"\n", 0, at) + 1, column, message)


_SKIP = re.compile(
    rf"(?P<string>{chains.STRING})"
    r"|(?P<comment>\#[^\n]*)"
    r"|(?P<open>[(\[{])|(?P<close>[)\]}])",
    re.DOTALL,
)


def nesting(text: str) -> tuple[int, int]:
    """The deepest bracket nesting and its line; strings and comments do not count."""
    depth = deepest = at = 0
    for match in _SKIP.finditer(text):
        kind = match.lastgroup
        if kind == "open":
            depth += 1
            if depth > deepest:
                deepest, at = depth, match.start()
        elif kind == "close":
            depth = max(0, depth - 1)
    return deepest, text.count("\n", 0, at) + 1


_ELIF = re.compile(r"^[ \t]*elif\b", re.MULTILINE)


def longest_chain(text: str) -> tuple[str, int] | None:
    """What a file strings together too long for the parser, and its line; None where nothing is."""
    if sum(1 for _ in _ELIF.finditer(text)) > MAX_CHAIN:
        match = next(_ELIF.finditer(text))
        return "elif branches", text.count("\n", 0, match.start()) + 1
    longest, line = chains.longest_chain(text, MAX_CHAIN)
    return ("operators", line) if longest > MAX_CHAIN else None


_TOKEN = re.compile(rf"{chains.STRING}|\#[^\n]*|\w+|[^\s\w]", re.DOTALL)


def has_too_many_tokens(text: str) -> bool:
    """Whether a text is a table rather than code; a shorter one is not looked through."""
    return len(text) > MAX_TOKENS and next(islice(_TOKEN.finditer(text), MAX_TOKENS, None), None) is not None


def inspect(text: str) -> Refusal | None:
    """Whether libcst can be trusted with a text; None where it can."""
    chain = longest_chain(text)
    if chain is not None:
        return Refusal(chain[1], 1, f"too many {chain[0]} in one expression to analyse (more than {MAX_CHAIN})")
    if has_too_many_tokens(text):
        return Refusal(1, 1, f"the file is too large to analyse: more than {MAX_TOKENS:,} words, numbers and signs")
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            ast.parse(text)
    except SyntaxError as error:
        # What ast.parse takes is within its limit.  The rest may be the syntax of a newer Python: libcst decides,
        # and words the finding, but how deep it goes has to be known.
        depth, line = nesting(text)
        if depth > MAX_DEPTH:
            return Refusal(line, 1, f"brackets are nested {depth} deep, more than Python's own limit of {MAX_DEPTH}")
        if "too many nested" in (error.msg or "") or "too deeply" in (error.msg or ""):
            return Refusal(error.lineno or 1, 1, "the code is nested too deep to analyse")
        return None
    except (RecursionError, MemoryError):
        return Refusal(1, 1, "the code is nested too deep to analyse")
    except ValueError as error:
        return Refusal(1, 1, f"Python cannot read this file: {error}")
    return None


def read_source(path: str, limit: int = MAX_BYTES) -> SourceText | Refusal:
    """A file's text if it is safe to parse, else why not."""
    data = read_bytes(path, limit)
    if isinstance(data, Refusal):
        return data
    text = decode(data)
    if isinstance(text, Refusal):
        return text
    refusal = inspect(text)
    return SourceText(text, data) if refusal is None else refusal


_ALLOWED_LATER = (
    () if sys.version_info >= (3, 11) else ("asynchronous comprehension outside of an asynchronous function",)
)
"""What only this Python refuses, and newer ones compile."""


def compile_refusal(text: str) -> Refusal | None:
    """What Python's compiler refuses although the syntax is right: a repeated keyword argument, ``return``
    outside of a function.  Silent where this Python cannot even parse the text."""
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            tree = ast.parse(text)
    except (SyntaxError, RecursionError, MemoryError, ValueError):
        return None
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            compile(tree, "<archlint>", "exec", dont_inherit=True)
    except SyntaxError as error:
        if error.msg in _ALLOWED_LATER:
            return None
        line = error.lineno or 1
        column = _column(text, line, error.offset or 1)
        return Refusal(line, column, f"Python refuses to compile this file: {error.msg}")
    except (RecursionError, MemoryError, ValueError):
        return None
    return None


def _column(text: str, line: int, offset: int) -> int:
    """The compiler counts the bytes of UTF-8; columns count characters."""
    lines = re.split(r"\r\n|\r|\n", text)
    if line > len(lines):
        return offset
    return len(lines[line - 1].encode()[: offset - 1].decode("utf-8", "replace")) + 1


_PYTHON_2 = re.compile(
    r"^[ \t]*(?:print[ \t]+[^\s(=.\[]|print[ \t]*$|exec[ \t]+[\"']|except[ \t]+\w[\w.]*[ \t]*,[ \t]*\w+[ \t]*:"
    r"|raise[ \t]+\w[\w.]*[ \t]*,)",
    re.MULTILINE,
)


def looks_like_python_2(text: str) -> bool:
    """Whether a text that does not parse has the marks of Python 2."""
    return _PYTHON_2.search(text) is not None

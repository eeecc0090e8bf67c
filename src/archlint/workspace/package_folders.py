"""The folders that the ``package_dir`` of a setup.py gives packages, read without running it: Python's own tokens tell
texts and comments from code, and any text whatever can be cut into them."""

from __future__ import annotations

import io
import posixpath
import re
import tokenize
from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from itertools import groupby, takewhile
from tokenize import NAME, NEWLINE, OP, STRING, TokenInfo

_PLAIN = re.compile(r"""(["'])([\w./]*)\1""")
"""A text that needs no reading: no prefix, no escape."""
_NO_CODE = frozenset({tokenize.COMMENT, tokenize.NL, tokenize.INDENT, tokenize.DEDENT})


def package_folders(text: str) -> dict[str, str]:
    """Folder, relative to that of the setup.py, to the dotted name of the package that it is.

    A name counts for the text that the module's code assigns to it; a pair of which more than that is written is left
    out.
    """
    if "package_dir" not in text:
        return {}
    tokens = list(_tokens(text))
    texts = dict(_assigned(tokens))
    folders = {}
    for key, value in _pairs(tokens):
        package, folder = _text(key, texts), _text(value, texts)
        path = posixpath.normpath(folder)
        if path != "." and package and all(part.isidentifier() for part in package.split(".")):
            folders[path] = package
    return folders


def _tokens(text: str) -> Iterator[TokenInfo]:
    """The tokens of code, up to where it is none of Python's."""
    with suppress(tokenize.TokenError, SyntaxError):
        for token in tokenize.generate_tokens(io.StringIO(text).readline):
            if token.type not in _NO_CODE:
                yield token


def _assigned(tokens: Sequence[TokenInfo]) -> Iterator[tuple[str, str]]:
    """The names that lines of the module assign a plain text to, and nothing else."""
    for name, sign, value, end in zip(tokens, tokens[1:], tokens[2:], tokens[3:], strict=False):
        if name.type == NAME and name.start[1] == 0 and sign.string == "=" and end.type == NEWLINE:
            plain = _PLAIN.fullmatch(value.string) if value.type == STRING else None
            if plain is not None:
                yield name.string, plain[2]


def _pairs(tokens: Sequence[TokenInfo]) -> Iterator[tuple[TokenInfo, TokenInfo]]:
    """Key and value of each pair of the first ``package_dir={…}`` that is one token each."""
    words = [token.string if token.type in (NAME, OP) else "" for token in tokens]
    start = next((at + 3 for at in range(len(words)) if words[at : at + 3] == ["package_dir", "=", "{"]), None)
    inside = [] if start is None else list(takewhile(lambda token: token.string not in ("{", "}"), tokens[start:]))
    for is_comma, part in groupby(inside, key=lambda token: token.string == ","):
        match list(part):
            case [key, TokenInfo(string=":"), value] if not is_comma:
                yield key, value


def _text(token: TokenInfo, texts: Mapping[str, str]) -> str:
    """The text that a key or a value is; nothing where that is not plain."""
    if token.type == NAME:
        return texts.get(token.string, "")
    plain = _PLAIN.fullmatch(token.string) if token.type == STRING else None
    return "" if plain is None else plain[2]


__all__ = ["package_folders"]

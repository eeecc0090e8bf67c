"""Dividing up the texts of XML and YAML launch files: substitutions, their words, and command lines."""

from __future__ import annotations

import shlex
from collections.abc import Iterator


def shell_words(text: str) -> list[str]:
    try:
        return shlex.split(text)
    except ValueError:
        return text.split()


def closing(text: str, at: int) -> int:
    """Where the parenthesis opened before ``at`` closes; -1 if it does not."""
    depth = 1
    for index in range(at, len(text)):
        if text.startswith("$(", index) or (text[index] == "(" and (index == 0 or text[index - 1] != "$")):
            depth += 1
        elif text[index] == ")":
            depth -= 1
            if depth == 0:
                return index
    return -1


def words_of(text: str) -> Iterator[str]:
    """Words of a substitution: split at spaces outside of quotes and of inner substitutions.

    Within quotes a backslash keeps what follows from ending them (``grammar.lark`` of launch).
    """
    word, depth, quote, escaped = "", 0, "", False
    for character in text:
        if quote:
            quote = "" if character == quote and not escaped else quote
            escaped = character == "\\" and not escaped
        elif character in "\"'" and depth == 0:
            quote = character
        elif character == "(":
            depth += 1
        elif character == ")":
            depth -= 1
        if character.isspace() and not quote and depth == 0:
            if word:
                yield word
            word = ""
        else:
            word += character
    if word:
        yield word


def unquoted(word: str) -> str:
    if len(word) > 1 and word[0] == word[-1] and word[0] in "\"'":
        inner = word[1:-1]
        if word[0] not in inner.replace("\\" + word[0], ""):
            return inner.replace("\\" + word[0], word[0])
    return word

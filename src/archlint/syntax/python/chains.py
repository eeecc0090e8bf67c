"""How long an expression strings things together, measured without parsing it and in linear time."""

from __future__ import annotations

import re

STRING = (
    r"'''[^\\']*(?:(?:\\.|'(?!''))[^\\']*)*(?:'''|\Z)"
    r"|\"\"\"[^\\\"]*(?:(?:\\.|\"(?!\"\"))[^\\\"]*)*(?:\"\"\"|\Z)"
    r"|'[^\\'\n]*(?:\\.[^\\'\n]*)*'?"
    r"|\"[^\\\"\n]*(?:\\.[^\\\"\n]*)*\"?"
)
"""A string, or what is left of the line or file where it does not end: nothing is ever looked at twice."""

# What may be a link of a chain, what ends one, and what hides either.
_TOKEN = re.compile(
    rf"(?P<hidden>{STRING})"
    r"|(?P<comment>\#[^\n]*|\\\r?\n)"
    r"|(?P<open>[(\[{])"
    r"|(?P<close>[)\]}])"
    r"|(?P<end>[,;\n])"
    r"|(?P<link>\*\*|//|<<|>>|[-+*/%@&|^~<>=.]|\b(?:and|or|not|in|is|if|else|lambda|await)\b)",
    re.DOTALL,
)
_CHARACTERS = "+-*/%@&|^~<>=.([{'\""
_WORDS = ("and", "or", "not", "in", "is", "if", "lambda", "await")


def longest_chain(text: str, least: int) -> tuple[int, int]:
    """The most operators, attribute steps, calls and neighbouring strings in one expression, and its line.

    ``(0, 1)`` where a count of characters shows that there are fewer than ``least``.
    """
    if not _may_hold(text, least):
        return 0, 1
    longest = at = 0
    counts = [0]
    for match in _TOKEN.finditer(text):
        kind = match.lastgroup
        if kind == "comment":
            continue
        if kind == "close":
            if len(counts) > 1:
                counts.pop()
            continue
        if kind == "end":
            if len(counts) == 1 or match[0] != "\n":  # a newline within brackets ends nothing
                counts[-1] = 0
            continue
        counts[-1] += 1
        if counts[-1] > longest:
            longest, at = counts[-1], match.start()
        if kind == "open":
            counts.append(0)
    return longest, text.count("\n", 0, at) + 1


def _may_hold(text: str, least: int) -> bool:
    total = 0
    for piece in (*_CHARACTERS, *_WORDS):
        total += text.count(piece)
        if total >= least:
            return True
    return False

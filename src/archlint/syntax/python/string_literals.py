"""The value of a string literal, from its spelling.

``ast.literal_eval`` would do for plain strings, but it warns about invalid escapes in the user's code and
has no answer for the text between the fields of an f-string.
"""

from __future__ import annotations

import re

_SIMPLE_ESCAPES = {
    "\n": "",
    "\\": "\\",
    "'": "'",
    '"': '"',
    "a": "\a",
    "b": "\b",
    "f": "\f",
    "n": "\n",
    "r": "\r",
    "t": "\t",
    "v": "\v",
}
_ESCAPE = re.compile(
    r"\\(?:([0-7]{1,3})|x([0-9a-fA-F]{2})|u([0-9a-fA-F]{4})|U([0-9a-fA-F]{8})|N\{([^}]*)\}|(.))",
    re.DOTALL,
)
_FIELD_TEXT = re.compile(_ESCAPE.pattern + r"|(\{\{|\}\})", re.DOTALL)
_DOUBLED_BRACE = re.compile(r"()()()()()()(\{\{|\}\})")


def split_prefix(spelling: str) -> tuple[str, str]:
    """``rb'…'`` as ``("rb", "…")``: the prefix in lower case and what stands between the quotes."""
    start = min(index for index in (spelling.find("'"), spelling.find('"')) if index >= 0)
    quoted = spelling[start:]
    width = 3 if len(quoted) >= 6 and quoted[:3] in ("'''", '"""') else 1
    return spelling[:start].lower(), quoted[width:-width]


def string_value(prefix: str, content: str) -> str:
    """The string that a literal denotes.

    ``prefix`` is in lower case and holds no ``b`` or ``f``.  Raises ``ValueError`` for an escape that Python
    refuses, and for a lone surrogate, which no file format of ours can hold.
    """
    content = _universal_newlines(content)
    if "\\" not in content or "r" in prefix:
        return content
    return _encodable(_ESCAPE.sub(_unescaped, content))


def format_text(prefix: str, content: str) -> str:
    """The literal text of an f-string between its fields: escapes resolved, doubled braces made single."""
    content = _universal_newlines(content)
    if "\\" in content and "r" not in prefix:
        return _encodable(_FIELD_TEXT.sub(_unescaped, content))
    if "{" in content or "}" in content:
        return _DOUBLED_BRACE.sub(_unescaped, content)
    return content


def _universal_newlines(content: str) -> str:
    # A file's newlines are \n inside strings, whatever the file uses.
    if "\r" in content:
        return content.replace("\r\n", "\n").replace("\r", "\n")
    return content


def _unescaped(match: re.Match[str]) -> str:
    if match.lastindex == 7:
        return match[7][0]
    octal, two, four, eight, name, other = match.group(1, 2, 3, 4, 5, 6)
    if octal is not None:
        return chr(int(octal, 8))
    digits = two or four or eight
    if digits is not None:
        return chr(int(digits, 16))
    if name is not None:
        return _named_character(name)
    if other in "xuUN":
        raise ValueError(f"truncated \\{other} escape")
    # An unknown escape keeps its backslash.
    return _SIMPLE_ESCAPES.get(other, "\\" + other)


def _named_character(name: str) -> str:
    from unicodedata import lookup

    try:
        return lookup(name)
    except KeyError:
        raise ValueError(f"unknown character name {name!r}") from None


def _encodable(value: str) -> str:
    value.encode()  # UnicodeEncodeError, a ValueError, for a lone surrogate
    return value

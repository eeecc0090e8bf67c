"""What a source imports or includes, as its text says: for those who have not compiled it."""

from __future__ import annotations

import re
from itertools import chain

_INCLUDE = re.compile(rb'^[ \t]*#[ \t]*include[ \t]*["<]([^">\n]+)[">]', re.MULTILINE)

_IMPORT = re.compile(
    rb"^[ \t]*(?:from[ \t]+([\w.]*)[ \t]+import[ \t]*(\([^)]*\)|[^\n#]*)|import[ \t]+([^\n#]+))", re.MULTILINE
)
_IMPORT_OF_ONE_LINE = re.compile(
    rb"^[ \t]*(?:from[ \t]+([\w.]*)[ \t]+import[ \t]*([^\n#]*)|import[ \t]+([^\n#]+))", re.MULTILINE
)
"""The same behind the last closing bracket: whoever looks for one there goes through the rest of the file."""
_IMPORTED_NAME = re.compile(rb"(\w[\w.]*)(?:[ \t]+as[ \t]+\w+)?")


def imported(data: bytes) -> list[bytes]:
    """The modules that a source imports, and what it imports from them, which may be modules too."""
    imported: dict[bytes, None] = {}
    behind = data.rfind(b")") + 1
    line_end = data.find(b"\n", behind) if behind else 0
    behind = len(data) if line_end < 0 else line_end
    for match in chain(_IMPORT.finditer(data, 0, behind), _IMPORT_OF_ONE_LINE.finditer(data, behind)):
        origin, names, plain = match.groups()
        if plain is not None:
            for name in _IMPORTED_NAME.findall(plain):
                imported.setdefault(name)
            continue
        imported.setdefault(origin)
        dot = b"" if origin.endswith(b".") else b"."
        for name in _IMPORTED_NAME.findall(names):
            imported.setdefault(origin + dot + name)
    return list(imported)


def included(data: bytes) -> list[bytes]:
    """The files that a C++ source includes, as it writes them."""
    return list(dict.fromkeys(_INCLUDE.findall(data)))


__all__ = ["imported", "included"]

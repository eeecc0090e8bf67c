"""What a source imports or includes, as its text says, and which files that may be: for those who have not compiled it.

Both are sets of texts, and where they meet, a file may import another; what it does import, ``workspace/importable.py``
knows.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from itertools import chain
from typing import TYPE_CHECKING

from archlint.syntax.facts import Import, ImportFrom, Stmt

if TYPE_CHECKING:
    from archlint.workspace.model import SourceFile

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


def modules_of(statement: Stmt) -> list[bytes]:
    """The modules that a statement may import; none for what is no import."""
    match statement:
        case Import(module):
            return [module.encode()]
        case ImportFrom(module, level, names):
            origin = "." * level + module
            dot = "" if origin.endswith(".") else "."
            return [name.encode() for name in (origin, *(f"{origin}{dot}{name}" for name, _ in names))]
    return []


def targets_of(file: SourceFile, names: Iterable[bytes]) -> set[str]:
    """What may stand for the files that the imported names mean in a file: see :func:`names_of`."""
    folder = file.path.replace("\\", "/").split("/")[:-1]
    if file.kind == "cpp":
        return {_include_name(name.decode("utf-8", "replace")) for name in names}
    targets = set()
    for written in names:
        name = written.decode("utf-8", "replace")
        level = len(name) - len(name.lstrip("."))
        if level:
            targets.add("/".join((*folder[: len(folder) - level + 1], *name[level:].split("."))).rstrip("/"))
        else:
            targets.add(name)
            targets.add("/".join((*folder, *name.split("."))))
            targets.add(_in_package(file, name))
    return targets


def names_of(files: Iterable[SourceFile]) -> set[str]:
    """Under which names files can be imported: dotted, by path without the suffix, and for code of the same package
    that puts a folder on the path, dotted below any folder."""
    names = set()
    for file in files:
        path = file.path.replace("\\", "/")
        if file.kind == "cpp":
            names.add(_include_name(path))
            continue
        if file.kind == "parameter_library":
            names.update(_include_name(f"{module.rpartition('.')[2]}.hpp") for module in file.modules)
        stem = path.removesuffix(".py").removesuffix("/__init__")
        names.add(stem)
        names.update(file.modules)
        names.update(_in_package(file, tail) for tail in _dotted_tails(stem))
    return names


def _include_name(path: str) -> str:
    """What stands for a header among the names that files import: its last part."""
    return "#include " + path.rpartition("/")[2]


def _in_package(file: SourceFile, name: str) -> str:
    """What stands for a dotted name that only code of the same package can import."""
    return f"{file.package or ''}: {name}"


def _dotted_tails(stem: str) -> Iterator[str]:
    """``b.c`` and ``a.b.c`` of the path ``/a/b/c``; a name alone is no reason to look in other folders."""
    parts = stem.split("/")
    return (".".join(parts[first:]) for first in range(len(parts) - 1))


__all__ = ["imported", "included", "modules_of", "names_of", "targets_of"]

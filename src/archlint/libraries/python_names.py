"""Which names common modules of Python's library have, in any version from 3.8 on and on any system.

The table, ``tables/python_names.json``, is written by ``scripts/generate_python_names``.
"""

from __future__ import annotations

from datetime import datetime
from functools import cache
from pathlib import Path

from archlint.libraries.module_names import NamesOfModule, names_in
from archlint.suggestions import nearest

_FILE = Path(__file__).with_name("tables") / "python_names.json"
_OF_THE_SYSTEM = frozenset({"errno", "fcntl", "locale", "mmap", "os", "resource", "select", "signal", "socket", "ssl"})
"""Modules whose constants are those of the system that Python is built on."""
_EXTENDED = frozenset({"logging", "sys"})
"""Modules to which others add names: levels of a log, what an installer makes of a program."""
_TAKEN_AWAY = {
    "itertools.ifilter": "filter",
    "itertools.imap": "map",
    "itertools.izip": "zip",
    "os.getcwdu": "os.getcwd",
    "string.letters": "string.ascii_letters",
    "string.lowercase": "string.ascii_lowercase",
    "string.maketrans": "str.maketrans",
    "string.uppercase": "string.ascii_uppercase",
    "sys.maxint": "sys.maxsize",
    "time.clock": "time.perf_counter",
    "urllib.quote": "urllib.parse.quote",
}
"""What came instead of names that Python 3.8 has no more.  Source: docs.python.org/3/whatsnew."""


def is_module(path: str) -> bool:
    """Whether a dotted name is that of a module in the table."""
    return path in _table()


def lacks(module: str, name: str) -> bool:
    """Whether no version of a module in the table has such a name, and nothing that extends the module gives it one."""
    row = _table().get(module)
    if row is None or name.startswith("_") or name in row.offered or name in row.imported:
        return False
    if f"{module}.{name}" in _table() or (module in _OF_THE_SYSTEM and name.isupper()):
        return False
    return module not in _EXTENDED or bool(near_name(module, name)) or f"{module}.{name}" in _TAKEN_AWAY


def near_name(module: str, name: str) -> str:
    """What a module offers by almost the same name; empty where there is nothing.  What decodes is not what encodes."""
    row, other_way = _table().get(module), name.lower().replace("encode", "decode")
    offered = () if row is None else row.offered
    return nearest(name, (other for other in offered if other.lower() != other_way or other_way == name.lower())) or ""


def instead_of(module: str, name: str) -> str:
    """The dotted name that is meant by one which a module does not have: that of a module below it, of the class that
    is called as the module, or what has taken its place; empty where there is none."""
    if (taken_away := _TAKEN_AWAY.get(f"{module}.{name}")) is not None:
        return taken_away
    if module == "datetime" and hasattr(datetime, name):
        return f"datetime.datetime.{name}"
    below = (path for path, row in _table().items() if path.startswith(f"{module}.") and row and name in row.offered)
    return next((f"{path}.{name}" for path in sorted(below)), "")


@cache
def _table() -> dict[str, NamesOfModule | None]:
    return names_in(_FILE)


__all__ = ["instead_of", "is_module", "lacks", "near_name"]

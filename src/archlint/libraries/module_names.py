"""Which names the modules of launch, launch_ros and rclpy have in any distribution from Foxy on.

The table, ``tables/module_names.json``, is written by ``scripts/generate_module_names`` from their sources.
"""

from __future__ import annotations

from functools import cache
from pathlib import Path

import msgspec

from archlint.records import dataclass
from archlint.suggestions import nearest

_FILE = Path(__file__).with_name("tables") / "module_names.json"


@dataclass(frozen=True)
class NamesOfModule:
    """What a module has."""

    offered: frozenset[str]
    """What it defines, or takes from the modules below it."""
    imported: frozenset[str]


def is_module(path: str) -> bool:
    """Whether a dotted name is that of a module in the table."""
    return path in _table()


def is_known(path: str) -> bool:
    """Whether the table has all modules of the package that a dotted name begins with."""
    return path.partition(".")[0] in _table()


def lacks(module: str, name: str) -> bool:
    """Whether a module of the table has no such name, and nothing below it is called so."""
    row = _table().get(module)
    has = row is None or name in row.offered or name in row.imported
    return not (has or name.startswith("_") or f"{module}.{name}" in _table())


_NOTHING_ELSE = frozenset({"launch_ros", "rclpy"})
"""Packages whose name nobody gives to anything else."""


def module_behind(path: str) -> str | None:
    """The package that a name means which a module only has as it imports that package: ``rclpy.logging.rclpy``."""
    owner, _, name = path.rpartition(".")
    if not owner or name not in _table():
        return None
    row = _table().get(owner)
    imports = name in _NOTHING_ELSE and not is_known(owner) if row is None else name in row.imported
    return name if imports else None


def near_name(module: str, name: str) -> str:
    """What a module offers by almost the same name; empty where there is nothing."""
    row = _table().get(module)
    return (row and nearest(name, row.offered)) or ""


def near_module(path: str) -> str:
    """The module whose name differs from a dotted one by a slip in one of its words; empty where there is none."""
    parts = path.split(".")
    for number in range(1, len(parts)):
        known = [other.split(".") for other in _table() if len(other.split(".")) == len(parts)]
        words = [
            row[number] for row in known if row[:number] + row[number + 1 :] == parts[:number] + parts[number + 1 :]
        ]
        word = nearest(parts[number], words)
        if word is not None:
            return ".".join([*parts[:number], word, *parts[number + 1 :]])
    return ""


def modules_with(name: str, beside: str) -> list[str]:
    """The modules that offer a name, the best to import it from first: a package comes before the modules below it, and
    of those beside each other the one that is called like it; what launch lacks launch_ros may offer."""
    family = _family(beside)
    offering = [path for path, row in _table().items() if row and name in row.offered and _family(path) == family]
    return sorted(offering, key=lambda path: (path.count("."), path.rpartition(".")[2] != name.lower(), path))


def _family(path: str) -> str:
    return path.partition(".")[0].partition("_")[0]


@cache
def _table() -> dict[str, NamesOfModule | None]:
    return names_in(_FILE)


def names_in(file: Path) -> dict[str, NamesOfModule | None]:
    """The modules of a table; None for one whose names are not known."""
    rows = msgspec.json.decode(file.read_bytes(), type=dict[str, str | None])
    return {path: None if names is None else _parsed(names) for path, names in rows.items()}


def _parsed(names: str) -> NamesOfModule:
    offered, _, imported = names.partition(";")
    return NamesOfModule(frozenset(offered.split()), frozenset(imported.split()))


__all__ = [
    "NamesOfModule",
    "is_known",
    "is_module",
    "lacks",
    "module_behind",
    "modules_with",
    "names_in",
    "near_module",
    "near_name",
]

"""The standard interfaces of ROS 2, from the table that ``scripts/generate_interfaces`` writes."""

from __future__ import annotations

from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING

import msgspec

if TYPE_CHECKING:
    from archlint.syntax.interfaces import InterfaceKind

FILE = Path(__file__).with_suffix(".json")


class Definition(msgspec.Struct):
    """One interface: ``text`` is the union of what the distributions say, ``varies`` names the fields whose
    type is not the same in all of them."""

    distros: list[str]
    text: str
    varies: list[str] = []


class Table(msgspec.Struct):
    """``packages`` has the distributions each package is in; ``interfaces`` goes by ``package/kind/Name``."""

    packages: dict[str, list[str]]
    interfaces: dict[str, Definition]

    def names(self, package: str, kind: InterfaceKind) -> list[str]:
        """Names of the interfaces that a package has of one kind."""
        start = f"{package}/{kind}/"
        return [name.removeprefix(start) for name in self.interfaces if name.startswith(start)]


@cache
def table() -> Table:
    """Read the table, once."""
    return msgspec.json.decode(FILE.read_bytes(), type=Table)
